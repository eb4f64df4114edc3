#include "tests/cli/cli_support.h"
#include "tests/support/cannot_run.h"
#include <QDir>
#include <QImage>
#include <QJsonArray>
#include <QStandardPaths>
#include <QtEndian>
#include <cmath>

namespace tst_ramure_cli_billboard {

using namespace ramure;
using test::isRefused;
using test::runCli;

namespace {

/// The parts of a GLB file.
struct Glb
{
    QJsonObject json;
    QByteArray bytes;

    explicit Glb(const QByteArray& file)
    {
        const auto number = [&](qsizetype at) {
            return qsizetype(qFromLittleEndian<quint32>(file.constData() + at));
        };
        if (file.size() < 28 || !file.startsWith("glTF"))
            qFatal("no GLB");
        const qsizetype length = number(12);
        json = QJsonDocument::fromJson(file.mid(20, length)).object();
        bytes = file.mid(28 + length, number(20 + length));
    }
    [[nodiscard]] QJsonObject part(const char* list, int i) const
    {
        return json.value(QLatin1String(list)).toArray().at(i).toObject();
    }
    [[nodiscard]] QImage picture(const QJsonValue& texture) const
    {
        const int source =
            part("textures", texture.toObject().value("index").toInt()).value("source").toInt();
        const QJsonObject view = part("bufferViews", part("images", source).value("bufferView").toInt());
        return QImage::fromData(
            bytes.mid(view.value("byteOffset").toInt(), view.value("byteLength").toInt()));
    }
};

int covered(const QImage& image)
{
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            count += image.pixelColor(x, y).alpha() >= 128 ? 1 : 0;
    return count;
}

} // namespace

/// Cards and atlases that stand for trees far away.
class TestRamureCliBillboard : public test::FolderSuite
{
    Q_OBJECT
private slots:
    void init() { begin(); }

    void badWordsAreRefused_data()
    {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<QString>("part");
        const auto row = [](const char* name, const QStringList& words, const char* part) {
            QTest::newRow(name) << words << QString::fromUtf8(part);
        };
        row("no output", {}, "one -o FOLDER or -o FILE.glb expected");
        row("two outputs", {"-o", "a", "-o", "b"}, "one -o FOLDER or -o FILE.glb expected");
        row("kind", {"-o", "a", "--kind", "cube"}, "--kind \"cube\": cards or atlas expected");
        row("ending", {"-o", "a.obj"}, "a.obj: unknown file ending");
        row("atlas as a file", {"-o", "a.glb", "--kind", "atlas"}, "an atlas is three files");
        row("small", {"-o", "a", "--size", "63"}, "--size \"63\": 64 to 8192 pixels expected");
        row("large", {"-o", "a", "--size", "8193"}, "64 to 8192 pixels expected");
        row("no number", {"-o", "a", "--size", "big"}, "64 to 8192 pixels expected");
        row("cards", {"-o", "a", "--cards", "0"}, "--cards \"0\": 1 to 16 expected");
        row("views", {"-o", "a", "--kind", "atlas", "--views", "1"}, "--views \"1\": 2 to 32 expected");
        row("multiple", {"-o", "a", "--kind", "atlas", "--size", "100"}, "a multiple of 8 views expected");
        row("tiny views", {"-o", "a", "--kind", "atlas", "--size", "64"}, "at least 16 pixels for each");
        row("views of cards", {"-o", "a", "--views", "4"}, "--views goes with --kind atlas");
        row("compared cards", {"-o", "a", "--compare", "4"}, "--compare goes with --kind atlas");
        row("cards of an atlas", {"-o", "a", "--kind", "atlas", "--lying"}, "--lying goes with --kind cards");
        row("compare", {"-o", "a", "--kind", "atlas", "--compare", "0"}, "1 to 10000 directions expected");
        row("time", {"-o", "a", "--time", "soon"}, "--time");
    }
    void badWordsAreRefused()
    {
        QFETCH(QStringList, words);
        QFETCH(const QString, part);
        for (qsizetype i = 1; i < words.size(); ++i)
            if (words[i - 1] == QLatin1String("-o"))
                words[i] = path(words[i]);
        QVERIFY(isRefused(runCli(QStringList{"billboard", "preset:TinyTree"} + words), part));
        QVERIFY(QDir(folder()).isEmpty());
    }
    void placesThatCannotBeWrittenAreNamed()
    {
        test::write(path("file"), "no folder");
        QVERIFY(isRefused(runCli({"billboard", "preset:TinyTree", "-o", path("file") + "/cards"}),
                          "the folder cannot be made"));
        needDisplay();
        QVERIFY(isRefused(runCli({"billboard", "preset:TinyTree", "-o", path("none/x.glb"), "--size", "64"}),
                          "none/x.glb"));
        QVERIFY(QDir(path("made")).mkpath("cards.glb")); // a folder where the file should be
        QVERIFY(isRefused(runCli({"billboard", "preset:TinyTree", "-o", path("made"), "--size", "64"}),
                          "cards.glb"));
    }
    void nothingVisibleIsRefused()
    {
        needDisplay();
        test::write(path("hidden.ramure"), R"({"format": "ramure", "version": 1, "nodes": [
            {"id": 1, "kind": "primitive", "name": "Box", "visible": false,
             "params": {"primitive.shape": "box"}}]})");
        QVERIFY(isRefused(runCli({"billboard", path("hidden.ramure"), "-o", path("a")}), "visible"));
    }

    void cardsAreOneFileWithItsPictures()
    {
        needDisplay();
        const QStringList words = {"billboard", "preset:TinyTree", "--size", "128", "--cards",
                                   "3",         "--lying"};
        const test::CliRun run = runCli(words + QStringList{"-o", path("tree.glb"), "--json"});
        QVERIFY2(run.code == 0 && run.err.isEmpty(), qPrintable(run.err));
        QCOMPARE(run.json().value("triangles").toInt(), 8);
        QCOMPARE(run.json().value("files").toArray(), QJsonArray{"tree.glb"});
        QCOMPARE(QDir(folder()).entryList(QDir::Files), QStringList{"tree.glb"});
        const Glb glb(test::bytesOf(path("tree.glb")));
        const QJsonObject material = glb.part("materials", 0);
        QCOMPARE(material.value("alphaMode").toString(), QStringLiteral("MASK"));
        QVERIFY(material.value("doubleSided").toBool());
        const QImage colour =
            glb.picture(material.value("pbrMetallicRoughness").toObject().value("baseColorTexture"));
        const QImage normal = glb.picture(material.value("normalTexture"));
        QCOMPARE(colour.size(), QSize(128, 128));
        QCOMPARE(normal.size(), QSize(128, 128));
        QVERIFY(colour.hasAlphaChannel() && !normal.hasAlphaChannel());
        const int count = covered(colour);
        QVERIFY2(count > 128 * 128 / 20 && count < 128 * 128 / 2, qPrintable(QString::number(count)));
        for (int y = 0; y < 128; ++y) // in tangent space, all look out of their card
            for (int x = 0; x < 128; ++x)
                QVERIFY(colour.pixelColor(x, y).alpha() == 0 || normal.pixelColor(x, y).blue() >= 120);

        const QByteArray before = test::bytesOf(path("tree.glb"));
        QCOMPARE(runCli(words + QStringList{"-o", path("again")}).code, 0);
        QCOMPARE(test::bytesOf(path("again/cards.glb")), before);
        QCOMPARE(QDir(path("again")).entryList(QDir::Files),
                 (QStringList{"cards.glb", "cards_colour.png", "cards_normal.png"}));
        const QImage beside(path("again/cards_colour.png"));
        QCOMPARE(beside.convertToFormat(QImage::Format_ARGB32),
                 colour.convertToFormat(QImage::Format_ARGB32));
    }

    void atlasesAreAsTheirTextSays()
    {
        needDisplay();
        const QStringList words = {"billboard", "preset:TinyTree", "--kind", "atlas", "--size",
                                   "256",       "--views",         "4",      "-o"};
        const test::CliRun run = runCli(words + QStringList{path("a"), "--compare", "8"});
        QVERIFY2(run.code == 0 && run.err.isEmpty(), qPrintable(run.err));
        const QJsonObject likeness = run.json().value("likeness").toObject();
        QCOMPARE(likeness.value("directions").toInt(), 8);
        QVERIFY2(likeness.value("silhouetteIou").toDouble() > 0.6, qPrintable(run.out));
        QVERIFY(likeness.value("leastSilhouetteIou").toDouble() <=
                likeness.value("silhouetteIou").toDouble());
        QCOMPARE(runCli(words + QStringList{path("b")}).out, QString());
        for (const char* name : {"atlas_colour.png", "atlas_normal.png", "atlas.json"})
            QCOMPARE(test::bytesOf(path("a/") + name), test::bytesOf(path("b/") + name));
        const QJsonObject json = QJsonDocument::fromJson(test::bytesOf(path("a/atlas.json"))).object();
        QCOMPARE(json.value("views").toInt(), 4);
        QCOMPARE(json.value("viewSize").toInt(), 64);
        const double radius = json.value("radius").toDouble();
        QVERIFY(radius > 0.1 && json.value("middle").toArray().at(1).toDouble() > 0.0);
        checkViews(QImage(path("a/atlas_colour.png")), QImage(path("a/atlas_normal.png")));
    }

private:
    static void needDisplay()
    {
        if (qEnvironmentVariableIsEmpty("DISPLAY") && QStandardPaths::findExecutable("Xvfb").isEmpty())
            qFatal("Xvfb is not installed");
    }
    /// Each has the tree in the middle and a free edge, no fringe, and surfaces that look to the eye.
    static void checkViews(const QImage& colour, const QImage& normal)
    {
        QCOMPARE(colour.size(), QSize(256, 256));
        for (int i = 0; i < 16; ++i) {
            const QRect tile(i % 4 * 64, i / 4 * 64, 64, 64);
            QVERIFY(covered(colour.copy(tile)) > 64 * 64 / 50);
            // atlas.json: "direction"
            const double u = 2.0 * (i % 4) / 3 - 1, v = 2.0 * (i / 4) / 3 - 1;
            double x = (u + v) / 2, z = (u - v) / 2, y = 1 - std::abs(x) - std::abs(z);
            const double length = std::sqrt(x * x + y * y + z * z);
            int there = 0, away = 0;
            for (int row = 0; row < 64; ++row)
                for (int column = 0; column < 64; ++column) {
                    const QColor c = colour.pixelColor(tile.topLeft() + QPoint(column, row));
                    const QColor n = normal.pixelColor(tile.topLeft() + QPoint(column, row));
                    const bool isEdge = row == 0 || column == 0 || row == 63 || column == 63;
                    QVERIFY(!isEdge || c.alpha() == 0);
                    QVERIFY(n.alpha() > 0 && c.red() + c.green() + c.blue() > 20);
                    const double facing = ((n.red() / 127.5 - 1) * x + (n.green() / 127.5 - 1) * y +
                                           (n.blue() / 127.5 - 1) * z) /
                                          length;
                    there += c.alpha() > 0 ? 1 : 0;
                    away += c.alpha() > 0 && facing < -0.05 ? 1 : 0;
                }
            QVERIFY2(there > 0 && away <= there / 20,
                     qPrintable(QStringLiteral("%1: %2 of %3").arg(i).arg(away).arg(there)));
        }
    }
};

RAMURE_SUITE(TestRamureCliBillboard)

} // namespace tst_ramure_cli_billboard

#include "tst_ramure_cli_billboard.moc"
