#include "tests/cli/cli_support.h"
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace tst_ramure_cli_levels {

using namespace ramure;
using test::runCli;

class TestRamureCliLevels : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void whatHasNoLevelsIsRefused()
    {
        QCOMPARE(runCli({"levels"}).code, 2);
        QCOMPARE(runCli({"levels", "preset:NoSuchTree"}).code, 2);
        QCOMPARE(runCli({"levels", "preset:TinyTree", "--budget", "10"}).code, 2);
        const auto refused = runCli({"levels", "preset:TinyTree", "--billboard"});
        QCOMPARE(refused.code, 2);
        QVERIFY2(refused.err.contains(QStringLiteral("--levels")), qPrintable(refused.err));
    }

    void rowsAreToldAndCompared()
    {
        const QStringList tree{"levels", "preset:TinyTree", "--budget", "900,300", "--billboard", "--check"};
        const auto text = runCli(tree);
        QCOMPARE(text.code, 0);
        QCOMPARE(text.out.count(QStringLiteral("triangles")), 3);
        const auto json = runCli(tree + QStringList{"--json"});
        QCOMPARE(json.code, 0);
        const QJsonArray levels = QJsonDocument::fromJson(json.out.toUtf8())
                                      .array()
                                      .first()
                                      .toObject()
                                      .value(QStringLiteral("levels"))
                                      .toArray();
        QCOMPARE(levels.size(), 3);
        const QJsonObject last = levels.last().toObject(), before = levels.at(1).toObject();
        QCOMPARE(last.value(QStringLiteral("triangles")).toInt(), 6);
        QVERIFY(last.value(QStringLiteral("billboard")).toBool() &&
                !before.value(QStringLiteral("billboard")).toBool());
        for (int i = 1; i < 3; ++i)
            for (const char* where : {"atSwitch", "atPixel"}) {
                const QJsonObject found = levels.at(i).toObject().value(QLatin1String(where)).toObject();
                const double overlap = found["overlap"].toDouble();
                QVERIFY(overlap > 0.0 && overlap <= 1.0 && found["pixels"].toInt() > 0);
            }
    }
};

RAMURE_SUITE(TestRamureCliLevels)

} // namespace tst_ramure_cli_levels

#include "tst_ramure_cli_levels.moc"
