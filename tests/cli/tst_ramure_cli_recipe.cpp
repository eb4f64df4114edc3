#include "tests/cli/cli_support.h"
#include <QJsonArray>

namespace tst_ramure_cli_recipe {

using namespace ramure;
using test::isRefused;
using test::runCli;

/// `ramure-cli recipe`, and `--set` of steps.
class TestRamureCliRecipe : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void badUseIsRefused()
    {
        QVERIFY(isRefused(runCli({"recipe"}), "missing INPUT"));
        QVERIFY(isRefused(runCli({"recipe", "demo:Arm"}), "holds no tree"));
        // Of a kind of step that the recipe has not: it names those that it has.
        QVERIFY(isRefused(runCli({"recipe", "preset:TinyTree", "--set", "weberPenn.levels=2"}), "1 grammar"));
        QVERIFY(isRefused(runCli({"recipe", "preset:TinyTree", "--set", "sag.amount=2"}), "1 grammar"));
        QVERIFY(isRefused(runCli({"recipe", "preset:TinyTree", "--set", "#2.sag.amount=2"}), "#2"));
        QVERIFY(isRefused(runCli({"recipe", "preset:TinyTree", "--set", "#1.sag.amount=2"}), "sag.amount"));
        QVERIFY(isRefused(runCli({"recipe", "preset:TinyTree", "--set", "step:a.b=2"}), "step:a.b"));
    }

    void stepsAreListed()
    {
        const QString project = shaped();
        const auto text = runCli({"recipe", project});
        QCOMPARE(text.code, 0);
        QVERIFY(text.out.contains("1  grammar") && text.out.contains("2  Old limbs") &&
                text.out.contains("no axis meets the condition"));
        const auto json = runCli({"recipe", project, "--json", "--set", "#3.gnarl.angle=0.5"});
        QCOMPARE(json.code, 0);
        const QJsonArray steps = json.json()
                                     .value(QLatin1String("trees"))
                                     .toArray()
                                     .at(0)
                                     .toObject()
                                     .value(QLatin1String("steps"))
                                     .toArray();
        QCOMPARE(steps.size(), 3);
        const QJsonObject sag = steps.at(1).toObject(), gnarl = steps.at(2).toObject();
        QCOMPARE(sag.value(QLatin1String("state")).toString(), QStringLiteral("placed"));
        QCOMPARE(sag.value(QLatin1String("values")).toObject().value(QLatin1String("sag.amount")).toDouble(),
                 4.0);
        QCOMPARE(gnarl.value(QLatin1String("state")).toString(), QStringLiteral("idle"));
        QCOMPARE(
            gnarl.value(QLatin1String("values")).toObject().value(QLatin1String("gnarl.angle")).toDouble(),
            0.5);
    }

    void valuesOfStepsAreSet()
    {
        const QString project = shaped();
        const auto tip = [&](const QString& set) {
            return runCli({"info", project, "--json", "--set", set})
                .json()
                .value(QLatin1String("max"))
                .toArray();
        };
        QVERIFY(tip(QStringLiteral("sag.amount=40")) != tip(QStringLiteral("sag.amount=0")));
        QCOMPARE(tip(QStringLiteral("sag.amount=40")), tip(QStringLiteral("step:Old limbs.sag.amount=40")));
        QCOMPARE(tip(QStringLiteral("sag.amount=40")), tip(QStringLiteral("#2.sag.amount=40")));
    }

private:
    QString shaped()
    {
        const QString script = m_folder.filePath(QStringLiteral("steps.jsonl"));
        const QString out = m_folder.filePath(QStringLiteral("steps.ramure"));
        QFile file(script);
        if (file.open(QIODevice::WriteOnly))
            file.write("{\"op\":\"sag\",\"name\":\"Old limbs\",\"values\":{\"sag.amount\":4}}\n"
                       "{\"op\":\"gnarl\",\"enabled\":false,\"values\":{\"step.where\":\"order = 9\"}}\n"
                       "{\"step\":\"gnarl\",\"enabled\":true}\n");
        file.close();
        if (runCli({"edit", "preset:TinyTree", "--script", script, "-o", out}).code != 0)
            qFatal("the script was refused");
        return out;
    }

    QTemporaryDir m_folder;
};

RAMURE_SUITE(TestRamureCliRecipe)

} // namespace tst_ramure_cli_recipe

#include "tst_ramure_cli_recipe.moc"
