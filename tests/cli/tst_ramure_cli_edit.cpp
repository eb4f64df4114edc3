#include "tests/cli/cli_support.h"
#include <QJsonArray>

namespace tst_ramure_cli_edit {

using namespace ramure;
using test::isRefused;
using test::runCli;

/// `ramure-cli edit`.
class TestRamureCliEdit : public QObject
{
    Q_OBJECT
private slots:
    void init()
    {
        test::failOnAnyWarning();
        m_script = m_folder.filePath(QStringLiteral("edits.jsonl"));
        m_out = m_folder.filePath(QStringLiteral("out.ramure"));
        QFile::remove(m_out);
    }

    void badUseIsRefused()
    {
        write("");
        QVERIFY(isRefused(runCli({"edit"}), "missing INPUT"));
        QVERIFY(isRefused(runCli({"edit", "preset:TinyTree", "-o", m_out}), "missing --script FILE"));
        QVERIFY(isRefused(runCli({"edit", "preset:TinyTree", "--script", m_script}), "missing -o"));
        QVERIFY(isRefused(runCli({"edit", "preset:TinyTree", "--script", m_script, "-o", "a.obj"}), "-o"));
        QVERIFY(isRefused(run("demo:Arm"), "holds no tree"));
        QVERIFY(isRefused(run("preset:TinyTree", {"--node", "Oak"}), "Oak"));
        QVERIFY(isRefused(runCli({"edit", "preset:TinyTree", "--script", "none.jsonl", "-o", m_out}),
                          "none.jsonl"));
        QVERIFY(!QFile::exists(m_out));
    }

    void badLinesAreNamed()
    {
        const QString trunk = address(0);
        const QByteArray good =
            QStringLiteral("{\"op\": \"length\", \"target\": \"%1\", \"factor\": 2}\n").arg(trunk).toUtf8();
        write(good + "\n{\"op\": \"grow\", \"target\": \"" + trunk.toUtf8() + "\"}\n");
        QVERIFY(isRefused(run("preset:TinyTree"), "edits.jsonl:3"));
        write(good + "{\"op\": \"remove\", \"target\": \"0123456789abcdef\"}\n");
        QVERIFY(isRefused(run("preset:TinyTree"), "edits.jsonl:2"));
        write(good + good + "{\"op\": \n");
        QVERIFY(isRefused(run("preset:TinyTree"), "edits.jsonl:3"));
        QVERIFY(!QFile::exists(m_out));
    }

    void editsAreKeptAndCounted()
    {
        const QString trunk = address(0), limb = address(1);
        write(
            QStringLiteral("{\"op\": \"cut\", \"target\": \"%1\", \"at\": 0.5}\n"
                           "{\"op\": \"draw\", \"parent\": \"%2\", \"at\": 0.3, \"id\": "
                           "\"00000000000000aa\", \"points\": [[1, 1, 0, 0.02], [1.5, 1.5, 0, 0.01]]}\n"
                           "{\"op\": \"leaves\", \"target\": \"%1\", \"shown\": false, \"enabled\": false}\n")
                .arg(limb, trunk)
                .toUtf8());
        const auto made = run("preset:TinyTree");
        QCOMPARE(made.code, 0);
        const auto info = runCli({"info", m_out, "--json", "--axes"});
        QCOMPARE(info.code, 0);
        const QJsonObject edits = info.json().value(QLatin1String("edits")).toObject();
        QCOMPARE(edits.value(QLatin1String("placed")).toInt(), 2);
        QCOMPARE(edits.value(QLatin1String("unplaced")).toInt(), 0);
        QCOMPARE(edits.value(QLatin1String("list")).toArray().size(), 3);
        bool isDrawn = false;
        for (const QJsonValue& axis : info.json().value(QLatin1String("axes")).toArray())
            isDrawn =
                isDrawn || axis.toObject().value(QLatin1String("id")) == QLatin1String("00000000000000aa");
        QVERIFY(isDrawn);
        QCOMPARE(runCli({"validate", m_out}).code, 0);
        // Read and written again: the same bytes.
        const QByteArray bytes = test::bytesOf(m_out);
        write("");
        QCOMPARE(run(m_out.toUtf8().constData()).code, 0);
        QCOMPARE(test::bytesOf(m_out), bytes);
    }

    void solidsOfTheSceneAreShapes()
    {
        const QString scene = m_folder.filePath(QStringLiteral("scene.ramure"));
        test::write(scene, R"({"format": "ramure", "version": 3, "nodes": [
            {"id": 1, "kind": "tree", "name": "Oak", "preset": "TinyTree"},
            {"id": 2, "kind": "primitive", "name": "Ball", "params": {"local.translation": [0, 3, 0]}}]})");
        write(R"({"op": "prune", "shape": {"mesh": "None"}})");
        QVERIFY(isRefused(run(scene.toUtf8().constData()), "shape.mesh"));
        write(R"({"op": "prune", "shape": {"mesh": "Oak"}})");
        QVERIFY(isRefused(run(scene.toUtf8().constData()), "shape.mesh"));
        write(R"({"op": "prune", "shape": {"mesh": "Ball"}})");
        QCOMPARE(run(scene.toUtf8().constData()).code, 0);
        QCOMPARE(runCli({"validate", m_out, "--node", "Oak"}).code, 0);
    }

private:
    void write(const QByteArray& script) { test::write(m_script, script); }
    test::CliRun run(const char* input, const QStringList& more = {})
    {
        return runCli(QStringList{"edit", QString::fromUtf8(input), "--script", m_script, "-o", m_out} +
                      more);
    }
    static QString address(int axis)
    {
        const auto info = runCli({"info", "preset:TinyTree", "--json", "--axes"});
        return info.json()
            .value(QLatin1String("axes"))
            .toArray()[axis]
            .toObject()
            .value(QLatin1String("id"))
            .toString();
    }

    QTemporaryDir m_folder;
    QString m_script, m_out;
};

RAMURE_SUITE(TestRamureCliEdit)

} // namespace tst_ramure_cli_edit

#include "tst_ramure_cli_edit.moc"
