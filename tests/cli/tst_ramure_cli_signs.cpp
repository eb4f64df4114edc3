#include "tests/cli/cli_support.h"
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace tst_ramure_cli_signs {

using namespace ramure;
using test::runCli;

/// The table of the signs of wood and growth on the command line.
class TestRamureCliSigns : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void whatIsNoTreeIsRefused()
    {
        QCOMPARE(runCli({"signs"}).code, 2);
        QCOMPARE(runCli({"signs", "preset:NoSuchTree"}).code, 2);
        QCOMPARE(runCli({"signs", "preset:EnglishOak", "--set", "growth.age=-1"}).code, 2);
        QTemporaryDir folder;
        const QString mesh = folder.filePath("tree.ply");
        QCOMPARE(runCli({"export", "preset:SmallTree", "-o", mesh}).code, 0);
        const auto refused = runCli({"signs", mesh});
        QCOMPARE(refused.code, 2);
        QVERIFY2(refused.err.contains(QStringLiteral("only trees have signs")), qPrintable(refused.err));
    }

    /// The same rows as text and as JSON; where there is no value, none is told.
    void rowsAreTheSameInBoth()
    {
        const QStringList tree{"signs", "preset:EnglishOak", "--set", "growth.age=25"};
        const auto text = runCli(tree);
        QCOMPARE(text.code, 0);
        const auto json = runCli(tree + QStringList{"--json"});
        QCOMPARE(json.code, 0);
        const QJsonArray trees = QJsonDocument::fromJson(json.out.toUtf8()).array();
        QCOMPARE(trees.size(), 1);
        const QJsonArray signs = trees[0]["signs"].toArray();
        QVERIFY(signs.size() >= 12);
        const QStringList lines = text.out.split(u'\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), signs.size() + 1);
        for (qsizetype i = 0; i < signs.size(); ++i) {
            const QJsonObject sign = signs[i].toObject();
            const QString state = sign["state"].toString();
            QVERIFY(lines[i + 1].startsWith(sign["label"].toString()) && lines[i + 1].contains(state));
            const bool hasBand = state == QLatin1String("inside") || state == QLatin1String("outside");
            QCOMPARE(sign.contains("value"), hasBand || state == QLatin1String("no band"));
            QCOMPARE(sign.contains("low"), hasBand);
        }
        QCOMPARE(signs.last()["state"].toString(), QStringLiteral("not modelled"));
    }
};

RAMURE_SUITE(TestRamureCliSigns)

} // namespace tst_ramure_cli_signs

#include "tst_ramure_cli_signs.moc"
