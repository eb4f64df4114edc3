#include "tests/cli/cli_support.h"
#include <QDir>
#include <QTemporaryDir>

namespace tst_ramure_cli_age {

using namespace ramure;
using test::isRefused;
using test::runCli;

/// `ramure-cli age`.
class TestRamureCliAge : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void badUseIsRefused()
    {
        QVERIFY(isRefused(runCli({"age"}), "missing INPUT"));
        QVERIFY(isRefused(runCli({"age", "preset:EnglishOak"}), "missing -o FILE"));
        QVERIFY(isRefused(runCli({"age", "preset:EnglishOak", "-o", "oak.stl"}), "{age}"));
        const QStringList many{"age", "preset:EnglishOak", "-o", "oak_{age}.stl"};
        QVERIFY(isRefused(runCli(many + QStringList{"--from", "old"}), "--from"));
        QVERIFY(isRefused(runCli(many + QStringList{"--from", "-3"}), "--from"));
        QVERIFY(isRefused(runCli(many + QStringList{"--from", "9", "--to", "3"}), "--to"));
        QVERIFY(isRefused(runCli(many + QStringList{"--step", "0"}), "--step"));
        QVERIFY(isRefused(runCli(many + QStringList{"--step", "0.001"}), "--step"));
        QVERIFY(isRefused(runCli({"age", "preset:TinyTree", "-o", m_folder.filePath("{age}.stl")}),
                          "grows by years"));
        QVERIFY(
            isRefused(runCli({"age", "preset:EnglishOak", "-o", m_folder.filePath("{age}.doc")}), ".doc"));
        QVERIFY(QDir(m_folder.path()).isEmpty());
    }

    void eachAgeHasAFile()
    {
        const QString pattern = m_folder.filePath(QStringLiteral("oak_{age}.stl"));
        const auto run = runCli({"age", "preset:EnglishOak", "--from", "2", "--to", "12", "--step", "5", "-o",
                                 pattern, "--set", "growth.density=0.3"});
        QCOMPARE(run.code, 0);
        QCOMPARE(QDir(m_folder.path()).entryList(QDir::Files, QDir::Name),
                 (QStringList{"oak_02.stl", "oak_07.stl", "oak_12.stl"}));
        qint64 before = 0;
        for (const QFileInfo& file : QDir(m_folder.path()).entryInfoList(QDir::Files, QDir::Name)) {
            QVERIFY(file.size() > before);
            before = file.size();
        }
        // The same bytes as that age alone.
        const QString alone = m_folder.filePath(QStringLiteral("alone.stl"));
        QCOMPARE(runCli({"export", "preset:EnglishOak", "--set", "growth.density=0.3", "--set",
                         "growth.age=7", "-o", alone})
                     .code,
                 0);
        QCOMPARE(bytesOf(alone), bytesOf(m_folder.filePath(QStringLiteral("oak_07.stl"))));
    }

private:
    static QByteArray bytesOf(const QString& path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    QTemporaryDir m_folder;
};

RAMURE_SUITE(TestRamureCliAge)

} // namespace tst_ramure_cli_age

#include "tst_ramure_cli_age.moc"
