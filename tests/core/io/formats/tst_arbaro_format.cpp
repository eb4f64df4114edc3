#include "core/io/formats/text/blender_scene.h"
#include "core/math/random.h"
#include "core/params/param_def.h"
#include "core/presets/presets.h"
#include "tests/support/suite.h"
#include <QFile>
#include <QTemporaryDir>
#include <cmath>
#include <numbers>
#include <tuple>

namespace tst_arbaro_format {

using namespace ramure;

/// The quaking aspen of the paper, as Arbaro writes it.
static const QByteArray aspen = R"(<?xml version='1.0' ?>
<arbaro>
  <species name='quaking_aspen'>
    <!-- general params -->
    <param name='Shape' value='7'/>
    <param name='Levels' value='3'/>
    <param name='Scale' value='13.0'/>
    <param name='ScaleV' value='3.0'/>
    <param name='BaseSize' value='0.4'/>
    <param name='Ratio' value='0.015'/>
    <param name='RatioPower' value='1.2'/>
    <param name='Smooth' value='0.0'/>
    <param name='Leaves' value='25'/>
    <param name='LeafScale' value='0.17'/>
    <param name='LeafQuality' value='1.0'/>
    <param name='LeafBend' value='0.3'/>
    <param name='AttractionUp' value='0.5'/>
    <param name='0BaseSplits' value='0'/>
    <param name='0CurveRes' value='3'/>
    <param name='1DownAngle' value='60.0'/>
    <param name='1DownAngleV' value='-50.0'/>
    <param name='1BranchDist' value='1'/>
    <param name='1Branches' value='50'/>
    <param name='2Length' value='0.6'/>
  </species>
</arbaro>
)";

class TestArbaroFormat : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    [[nodiscard]] Expected<BlenderImport> read(const QByteArray& text,
                                               const ImportOptions& options = {}) const
    {
        QFile file(m_folder.filePath(QStringLiteral("tree.xml")));
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            qFatal("cannot write");
        file.close();
        return importObjects(file.fileName().toStdString(), options);
    }
    [[nodiscard]] static QByteArray with(const char* name, const char* value)
    {
        QByteArray text = aspen;
        const auto at = text.indexOf(QByteArray("name='") + name + '\'');
        const auto from = text.indexOf("value='", at) + 7;
        return text.replace(from, text.indexOf('\'', from) - from, value);
    }
    [[nodiscard]] static bool notes(const BlenderImport& import, const char* path)
    {
        return std::ranges::any_of(import.notes,
                                   [&](const Note& note) { return note.path == path && note.line > 0; });
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void whatIsRefused_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<ErrorCode>("code");
        QTest::addColumn<int>("line");
        QTest::addColumn<QByteArray>("path");
        QTest::newRow("nothing") << QByteArray() << ErrorCode::Syntax << 1 << QByteArray();
        QTest::newRow("no XML") << QByteArray("Shape = 7\n") << ErrorCode::Syntax << 1 << QByteArray();
        QTest::newRow("other XML") << QByteArray("<svg><species name='x'/></svg>") << ErrorCode::Invalid << 1
                                   << QByteArray();
        QTest::newRow("no species") << QByteArray("<arbaro/>") << ErrorCode::Invalid << 1 << QByteArray();
        QTest::newRow("no number") << with("Ratio", "thick") << ErrorCode::Syntax << 10
                                   << QByteArray("Ratio");
        QTest::newRow("half a number")
            << with("Ratio", "0.1m") << ErrorCode::Syntax << 10 << QByteArray("Ratio");
        QTest::newRow("not finite") << with("Ratio", "nan") << ErrorCode::Invalid << 10
                                    << QByteArray("Ratio");
        QTest::newRow("too large") << with("Scale", "1e9") << ErrorCode::Invalid << 7 << QByteArray("Scale");
        QTest::newRow("not whole") << with("1Branches", "2.5") << ErrorCode::Invalid << 23
                                   << QByteArray("1Branches");
        QTest::newRow("no such shape")
            << with("Shape", "9") << ErrorCode::Invalid << 5 << QByteArray("Shape");
        QTest::newRow("no level") << with("Levels", "0") << ErrorCode::Invalid << 6 << QByteArray("Levels");
        QTest::newRow("twice") << QByteArray(aspen).replace("'Scale'", "'Shape'") << ErrorCode::Syntax << 7
                               << QByteArray();
        QTest::newRow("no value") << QByteArray(aspen).replace("value='7'", "") << ErrorCode::Syntax << 5
                                  << QByteArray();
        QTest::newRow("too long") << aspen + QByteArray((4 << 20) + 1, ' ') << ErrorCode::Limit << 0
                                  << QByteArray();
        QByteArray bomb = "<!DOCTYPE a [<!ENTITY b0 'branch'>";
        for (int i = 0; i < 30; ++i)
            bomb += QStringLiteral("<!ENTITY b%1 '&b%2;&b%2;'>").arg(i + 1).arg(i).toLatin1();
        QTest::newRow("bomb") << bomb + "]>\n<arbaro><species name='&b30;'/></arbaro>" << ErrorCode::Syntax
                              << 2 << QByteArray();
    }
    void whatIsRefused()
    {
        QFETCH(const QByteArray, text);
        QFETCH(const ErrorCode, code);
        QFETCH(const int, line);
        QFETCH(const QByteArray, path);
        const auto import = read(text);
        QVERIFY(!import);
        const Error& error = import.error();
        QVERIFY2(error.code == code && error.line == line && error.path == path.toStdString(),
                 error.message().c_str());
        QVERIFY(error.file.ends_with("tree.xml"));
    }
    void aFileCutAnywhereIsRefused()
    {
        const auto end = aspen.lastIndexOf('>');
        for (qsizetype length = 0; length < end; length += test::isSanitized ? 20 : 1) {
            const auto import = read(aspen.left(length));
            QVERIFY2(!import, qPrintable(QString::number(length)));
            QCOMPARE(import.error().code, ErrorCode::Syntax);
            QVERIFY(import.error().line >= 1 && import.error().column >= 1);
        }
    }
    /// A tree that the table allows, or an error that names the file.
    void brokenBytesNeverPassUnseen()
    {
        Random random(5, RandomStream::Test);
        for (int round = 0; round < test::runs(2000); ++round) {
            QByteArray text = aspen;
            for (std::uint32_t i = 1 + random.below(4); i-- > 0;) {
                const auto at = static_cast<qsizetype>(random.below(std::uint32_t(text.size())));
                text[at] = random.below(2) == 0 ? char(random.below(256))
                                                : aspen[random.below(std::uint32_t(aspen.size()))];
            }
            const auto import = read(text);
            if (import)
                QVERIFY(import->nodes.size() == 1 && checkParams(import->nodes[0].params));
            else
                QVERIFY(import.error().file.ends_with("tree.xml") && !import.error().plain().empty());
        }
    }
    void axesAreRefused()
    {
        ImportOptions options;
        options.space.emplace();
        QVERIFY(!read(aspen, options));
        QVERIFY(!importObjects(m_folder.filePath(QStringLiteral("none.xml")).toStdString()));
    }

    void itsNumbersAreOurs()
    {
        const auto import = read(aspen);
        QVERIFY2(import, test::why(import));
        QCOMPARE(import->nodes.size(), std::size_t(1));
        const Node& node = import->nodes.front();
        QVERIFY(node.kind == NodeKind::Tree && node.name == "quaking_aspen");
        const NodeParams& params = node.params;
        QVERIFY(checkParams(params));
        QCOMPARE(params.generator.kind, EditOperation::WeberPenn);
        WeberPennParams expected; // whose defaults are the paper's aspen
        expected.level[0].curveRes = 3;
        QCOMPARE(params.weberPenn.level[1].downAngle, expected.level[1].downAngle);
        QVERIFY(params.weberPenn == expected);
        const NodeParams ours = *presetParams("QuakingAspen");
        QVERIFY(params.leaf.shape == ours.leaf.shape && params.bark == ours.bark);
        QVERIFY(notes(*import, "LeafBend"));
        QVERIFY(!notes(*import, "Smooth") && !notes(*import, "LeafQuality") &&
                !notes(*import, "1BranchDist"));
    }
    void leavesAreAsLongAndAsManyAsItSays()
    {
        const auto once = read(aspen), larger = read(with("LeafScale", "0.34")),
                   more = read(with("Leaves", "50"));
        QVERIFY(once && larger && more);
        const auto leaf = [](const Expected<BlenderImport>& from) { return from->nodes[0].params.leaf; };
        QVERIFY(std::abs(leaf(larger).size - 2.0 * leaf(once).size) < 1e-12);
        QVERIFY(std::abs(leaf(more).internode - 0.5 * leaf(once).internode) < 1e-12);
        QCOMPARE(read(with("Leaves", "0"))->nodes[0].params.leaf.size, 0.0);
        const auto fan = read(with("Leaves", "-25"));
        QVERIFY(notes(*fan, "LeafScale"));
        QCOMPARE(leaf(fan).internode, leaf(once).internode);
    }
    void plantsAreKnownByTheirNames()
    {
        const auto named = [this](const char* name) {
            return read(QByteArray(aspen).replace("quaking_aspen", name))->nodes[0].params;
        };
        QCOMPARE(named("ca_black_oak").leaf.shape, LeafShape::Oak);
        QCOMPARE(named("Japanese Maple").leaf.shape, LeafShape::JapaneseMaple);
        QCOMPARE(named("weeping-willow").bark, presetParams("WeepingWillow1995")->bark);
        QCOMPARE(named("triffid").leaf.shape, LeafShape::Beech);
    }
    /// Its own program's ranges; of those without an end some number far out. None is refused, and what is
    /// changed is noted at its line.
    void everyNumberThatItAllowsIsRead_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<double>("low");
        QTest::addColumn<double>("high");
        const auto row = [](const char* name, double low, double high) {
            QTest::newRow(name) << QByteArray(name) << low << high;
        };
        constexpr double far = 1e6;
        row("ScaleV", 0, far);
        row("BaseSize", 0, 1);
        row("Ratio", 1e-6, far);
        row("RatioPower", -far, far);
        row("Flare", -1, far);
        row("Lobes", 0, far);
        row("LobeDepth", 0, far);
        row("Leaves", -far, far);
        row("LeafScale", 1e-6, far);
        row("LeafScaleX", 1e-6, far);
        row("LeafBend", 0, 1);
        row("LeafStemLen", -far, far);
        row("LeafDistrib", 0, 8);
        row("LeafQuality", 1e-6, 1);
        row("Smooth", 0, 1);
        row("AttractionUp", -far, far);
        row("PruneRatio", 0, 1);
        row("PruneWidth", 0, 1);
        row("PruneWidthPeak", 0, 1);
        row("PrunePowerLow", 0, far);
        row("PrunePowerHigh", 0, far);
        row("0Scale", 1e-6, far);
        row("0ScaleV", 0, far);
        row("0BaseSplits", 0, far);
        for (const char level : {'0', '1', '2', '3'})
            for (const auto& [name, low, high] :
                 {std::tuple("Length", 1e-7, far), std::tuple("LengthV", 0.0, far),
                  std::tuple("Taper", 0.0, 2.99999999), std::tuple("SegSplits", 0.0, far),
                  std::tuple("SplitAngle", 0.0, 180.0), std::tuple("SplitAngleV", 0.0, 180.0),
                  std::tuple("CurveRes", 1.0, far), std::tuple("Curve", -far, far),
                  std::tuple("CurveBack", -far, far), std::tuple("CurveV", -90.0, far),
                  std::tuple("DownAngle", -179.9999999, 179.999999),
                  std::tuple("DownAngleV", -179.9999999, 179.9999999), std::tuple("Rotate", -360.0, 360.0),
                  std::tuple("RotateV", -360.0, 360.0), std::tuple("Branches", 0.0, far),
                  std::tuple("BranchDist", 0.0, 1.0)})
                row((level + std::string(name)).c_str(), low, high);
    }
    void everyNumberThatItAllowsIsRead()
    {
        QFETCH(const QByteArray, name);
        QFETCH(const double, low);
        QFETCH(const double, high);
        const auto readWith = [&](double value) {
            QByteArray text = aspen;
            const QByteArray line =
                "    <param name='" + name + "' value='" + QByteArray::number(value, 'g', 17) + "'/>\n";
            const auto old = text.indexOf("    <param name='" + name + '\'');
            if (old >= 0)
                text.remove(old, text.indexOf('\n', old) + 1 - old);
            return read(text.replace("  </species>", line + "  </species>"));
        };
        for (const double value : {low, high}) {
            const auto import = readWith(value);
            QVERIFY2(import, test::why(import));
            QVERIFY(checkParams(import->nodes[0].params));
        }
        if (high == 1e6 && name != "Leaves" && name != "LeafScale" && !name.startsWith("2B") &&
            name[0] != '3')
            QVERIFY(notes(*readWith(high), name));
    }
    /// Two levels grow: what the others say has no effect, and needs no remark.
    void levelsThatDoNotGrowAreNotNoted()
    {
        const auto import =
            read(with("Levels", "2").replace("'2Length' value='0.6'", "'2Length' value='2000'"));
        QVERIFY2(import, test::why(import));
        QVERIFY(!notes(*import, "2Length"));
        QVERIFY(notes(*read(with("2Length", "2000")), "2Length"));
    }
    void numbersBeyondArbarosAreClamped()
    {
        const auto steep = read(with("1DownAngle", "-170"));
        QCOMPARE(steep->nodes[0].params.weberPenn.level[1].downAngle, -170.0 / 180.0 * std::numbers::pi);
        QVERIFY(!notes(*steep, "1DownAngle"));
        const auto bare = read(with("BaseSize", "1"));
        QCOMPARE(bare->nodes[0].params.weberPenn.baseSize, 0.99);
        const auto note = std::ranges::find(bare->notes, "BaseSize", &Note::path);
        QVERIFY(note != bare->notes.end());
        QCOMPARE(note->plain(), std::string("1 is out of range: 0.99 is used instead"));
    }
    void whatGoesTooFarIsNoted()
    {
        const auto deep = read(with("Levels", "6"));
        QCOMPARE(deep->nodes[0].params.weberPenn.levels, std::int64_t(4));
        QVERIFY(notes(*deep, "Levels"));
        QByteArray thick = aspen;
        thick.replace("0BaseSplits", "0Scale");
        thick = thick.replace("'0Scale' value='0'", "'0Scale' value='2'");
        QCOMPARE(read(thick)->nodes[0].params.weberPenn.ratio, 0.03);
    }
};

RAMURE_SUITE(TestArbaroFormat)

} // namespace tst_arbaro_format

#include "tst_arbaro_format.moc"
