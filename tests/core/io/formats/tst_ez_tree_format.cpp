#include "core/io/formats/text/blender_scene.h"
#include "core/math/random.h"
#include "core/params/param_def.h"
#include "tests/support/suite.h"
#include <QFile>
#include <QTemporaryDir>
#include <cmath>
#include <numbers>

namespace tst_ez_tree_format {

using namespace ramure;

static const QByteArray tree = R"({
  "seed": 7,
  "type": "deciduous",
  "bark": { "type": "birch", "tint": 16777215 },
  "branch": {
    "levels": 2,
    "angle": { "1": 60, "2": 45 },
    "children": { "0": 6, "1": 4 },
    "force": { "direction": { "x": 0, "y": 1, "z": 0 }, "strength": 0.02 },
    "gnarliness": { "0": 0, "1": -0.1, "2": 0.1 },
    "length": { "0": 20, "1": 10, "2": 5 },
    "radius": { "0": 1.5, "1": 0.7, "2": 0.7 },
    "sections": { "0": 8, "1": 6, "2": 3 },
    "start": { "1": 0.5, "2": 0 },
    "taper": { "0": 0.7, "1": 0.7, "2": 0.7 },
    "twist": { "0": 0.3, "1": 0, "2": 0 }
  },
  "leaves": { "type": "ash", "angle": 30, "count": 10, "size": 1.5, "sizeVariance": 0.95 },
  "trellis": { "enabled": false }
}
)";

class TestEzTreeFormat : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    [[nodiscard]] Expected<BlenderImport> read(const QByteArray& text,
                                               const ImportOptions& options = {}) const
    {
        QFile file(m_folder.filePath(QStringLiteral("park.json")));
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            qFatal("cannot write");
        file.close();
        return importObjects(file.fileName().toStdString(), options);
    }
    [[nodiscard]] static QByteArray with(const char* from, const char* to)
    {
        if (!tree.contains(from))
            qFatal("%s", from);
        return QByteArray(tree).replace(from, to);
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void whatIsRefused_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<ErrorCode>("code");
        QTest::addColumn<int>("line");
        QTest::addColumn<QByteArray>("path");
        const auto syntax = ErrorCode::Syntax, invalid = ErrorCode::Invalid;
        QTest::newRow("nothing") << QByteArray() << syntax << 1 << QByteArray();
        QTest::newRow("a comma too many") << with("7,", "7,,") << syntax << 2 << QByteArray();
        QTest::newRow("a number without end") << with(": 7", ": 1e999") << syntax << 1 << QByteArray();
        QTest::newRow("other JSON") << QByteArray("[1, 2]") << invalid << 0 << QByteArray();
        QTest::newRow("no branch") << QByteArray("{\"branch\": 3}") << invalid << 0 << QByteArray();
        QTest::newRow("deep") << QByteArray(100'000, '[') << invalid << 0 << QByteArray();
        QTest::newRow("a text") << with("\"levels\": 2", "\"levels\": \"2\"") << syntax << 0
                                << QByteArray("branch.levels");
        QTest::newRow("levels") << with("\"levels\": 2", "\"levels\": 4") << invalid << 0
                                << QByteArray("branch.levels");
        QTest::newRow("half a level")
            << with("\"levels\": 2", "\"levels\": 0.5") << invalid << 0 << QByteArray("branch.levels");
        QTest::newRow("no length") << with("\"1\": 10", "\"1\": 0") << invalid << 0
                                   << QByteArray("branch.length.1");
        QTest::newRow("too long") << with("\"0\": 20", "\"0\": 2e6") << invalid << 0
                                  << QByteArray("branch.length.0");
        QTest::newRow("too many") << with("\"0\": 6,", "\"0\": 60000,") << invalid << 0
                                  << QByteArray("branch.children.0");
        QTest::newRow("a type") << with("\"deciduous\"", "3") << syntax << 0 << QByteArray("type");
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
    }
    void aFileCutAnywhereIsRefused()
    {
        for (qsizetype length = 0; length < tree.lastIndexOf('}'); length += test::isSanitized ? 20 : 1) {
            const auto import = read(tree.left(length));
            QVERIFY2(!import, qPrintable(QString::number(length)));
            QVERIFY(import.error().line >= 1 && import.error().column >= 1);
        }
    }

    /// A tree that the table allows, or an error that names the file.
    void brokenBytesNeverPassUnseen()
    {
        Random random(5, RandomStream::Test);
        for (int round = 0; round < test::runs(2000); ++round) {
            QByteArray text = tree;
            for (std::uint32_t i = 1 + random.below(4); i-- > 0;) {
                const auto at = static_cast<qsizetype>(random.below(std::uint32_t(text.size())));
                text[at] = random.below(2) == 0 ? char(random.below(256))
                                                : tree[random.below(std::uint32_t(tree.size()))];
            }
            const auto import = read(text);
            if (import)
                QVERIFY(import->nodes.size() == 1 && checkParams(import->nodes[0].params));
            else
                QVERIFY(import.error().file.ends_with("park.json") && !import.error().plain().empty());
        }
    }
    void itBecomesATreeOfWeberAndPenn()
    {
        const auto import = read(tree);
        QVERIFY2(import, test::why(import));
        const Node& node = import->nodes.front();
        QVERIFY(node.kind == NodeKind::Tree && node.name == "park" && checkParams(node.params));
        const WeberPennParams& grown = node.params.weberPenn;
        QCOMPARE(grown.levels, std::int64_t(3));
        QCOMPARE(grown.scale, 35.0); // the trunk, and what goes on from its end
        QCOMPARE(grown.ratio, 1.5 / 35.0);
        QCOMPARE(grown.level[1].length, 15.0 / 35.0);
        QCOMPARE(grown.level[1].branches, std::int64_t(10));
        QCOMPARE(grown.level[2].branches, std::int64_t(4));
        QVERIFY(std::abs(grown.level[1].downAngle - std::numbers::pi / 3.0) < 1e-12);
        QVERIFY(grown.ratioPower > 0.5 && grown.ratioPower < 2.0);
        QVERIFY(grown.attractionUp > 0.0 && grown.level[0].curveV == 0.0);
        QCOMPARE(node.params.leaf.shape, LeafShape::Ash);
        QCOMPARE(node.params.leaf.variation, 0.9);
        QCOMPARE(node.params.bark.family, BarkFamily::Ringed);
    }
    void coniferStemsEndWhereTheyEnd()
    {
        const auto import = read(with("deciduous", "evergreen"));
        const WeberPennParams& grown = import->nodes.front().params.weberPenn;
        QCOMPARE(grown.scale, 20.0);
        QCOMPARE(grown.level[1].branches, std::int64_t(6));
        QCOMPARE(grown.shape, CrownShape::Conical);
    }
    void whatHasNoCounterpartIsNoted()
    {
        const auto import = read(tree);
        const auto notes = [&](const char* path) {
            return std::ranges::count_if(import->notes, [&](const Note& note) { return note.path == path; });
        };
        QCOMPARE(notes("branch.twist.0"), 1);
        QCOMPARE(notes("branch.twist.1"), 0);
        QCOMPARE(notes("trellis.enabled"), 0);
        QCOMPARE(notes("bark.tint"), 0);
    }
    void whatAFileLeavesOutIsAsUsual()
    {
        const auto import = read("{\"branch\": {}}");
        QVERIFY2(import, test::why(import));
        QCOMPARE(import->nodes.front().params.weberPenn.levels, std::int64_t(4));
        const auto trunk = read("{\"branch\": {\"levels\": 0}, \"leaves\": {\"count\": 0}}");
        QVERIFY2(trunk, test::why(trunk));
        QCOMPARE(trunk->nodes.front().params.leaf.size, 0.0);
    }
};

RAMURE_SUITE(TestEzTreeFormat)

} // namespace tst_ez_tree_format

#include "tst_ez_tree_format.moc"
