#include "core/generators/grammar/grammar.h"
#include "core/params/param_def.h"
#include "core/presets/presets.h"
#include "tests/support/suite.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>

namespace tst_presets {

using namespace ramure;

namespace {

QJsonObject reference()
{
    QFile file(QStringLiteral(RAMURE_TEST_DATA "/presets.json"));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    return QJsonDocument::fromJson(file.readAll()).object();
}

} // namespace

class TestPresets : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void unknownNameListsTheNames();
    void valuesAreValidAndDeterministic();
    void valuesAreThoseOfTheReference();
    void rulesAreThoseOfTheReference();
    void unchangedNodesHaveTheValuesOfTheirPreset();
};

void TestPresets::unknownNameListsTheNames()
{
    for (const char* name : {"", "smalltree", "Oak", "SmallTree "}) {
        const auto params = presetParams(name);
        QVERIFY(!params);
        QCOMPARE(params.error().code, ErrorCode::Unknown);
        for (const Preset& preset : presets())
            QVERIFY(params.error().message().find(preset.name) != std::string::npos);
    }
}

void TestPresets::valuesAreValidAndDeterministic()
{
    QVERIFY(presets().size() >= 8);
    for (const Preset& preset : presets()) {
        const auto checked = checkParams(preset.params);
        QVERIFY2(checked, test::why(checked));
        // By chance only what says so: the same for everyone, as its seed is part of it.
        QVERIFY2(!preset.params.grammar.stochastic ||
                     preset.params.grammar.rules.find("rand(") != std::string::npos,
                 preset.name);
        QVERIFY(*preset.description && *preset.group);
        const std::string_view group = preset.group;
        const EditOperation generator = preset.params.generator.kind;
        const bool isForm = group == "Forms"; // of a species, at one age
        const bool grows = generator == EditOperation::Growth && !isForm;
        const bool isSpecies = grows || (generator == EditOperation::WeberPenn && !isForm);
        QVERIFY2(!isSpecies || *preset.latin, preset.name);
        QVERIFY2(isSpecies ==
                     (group == "Broadleaved trees" || group == "Conifers" || group == "Weber and Penn 1995" ||
                      preset.name == std::string_view("CoconutPalm")),
                 preset.name);
        QVERIFY2(grows == (preset.ages[0] > 0 && preset.ages[1] > preset.ages[0] &&
                           preset.ages[2] > preset.ages[1]),
                 preset.name);
        QVERIFY2(!grows || presetParams(std::string(preset.name) + "1995") ||
                     presetParams(std::string(preset.name) + "Rules"),
                 preset.name);
        QVERIFY(*presetParams(preset.name) == preset.params);
    }
}

void TestPresets::unchangedNodesHaveTheValuesOfTheirPreset()
{
    for (const ParamDef& def : paramTable()) {
        for (const Preset& preset : presets())
            QVERIFY2(presetValue(preset.name, def) == def.get(preset.params), def.key);
        for (const char* none : {"", "Oak"}) // made from nothing, or by a newer version
            QVERIFY2(presetValue(none, def) == defaultValue(def), def.key);
    }
    QVERIFY(presetValue("FanTree", *findParam("turtle.theta")) == ParamValue(0.15));
}

void TestPresets::valuesAreThoseOfTheReference()
{
    const QJsonObject all = reference();
    QCOMPARE(std::size_t(all.size()), courseworkPresets().size());
    for (const Preset& preset : courseworkPresets()) {
        const QJsonObject expected = all[QLatin1String(preset.name)].toObject();
        QCOMPARE(preset.params.turtle.theta, expected["theta"].toDouble(-1));
        QCOMPARE(preset.params.turtle.alpha, expected["alpha"].toDouble(-1));
        QCOMPARE(preset.params.turtle.decay, expected["decay"].toDouble(-1));
        QCOMPARE(preset.params.grammar.iterations, std::int64_t(expected["iterations"].toInt(-1)));
        QCOMPARE(preset.params.grammar.axiom, expected["axiom"].toString().toStdString());
    }
}

void TestPresets::rulesAreThoseOfTheReference()
{
    const QJsonObject all = reference();
    for (const Preset& preset : courseworkPresets()) {
        const QJsonObject expected = all[QLatin1String(preset.name)].toObject()["rules"].toObject();
        const auto grammar = parseGrammar(preset.params.grammar.axiom, preset.params.grammar.rules);
        QVERIFY2(grammar, test::why(grammar));
        QCOMPARE(qsizetype(grammar->rules.size()), expected.size());
        for (const Rule& rule : grammar->rules) {
            const QJsonObject of = expected[QString(QLatin1Char(rule.symbol))].toObject();
            QCOMPARE(rule.defaultText, of["default"].toString().toStdString());
            const QJsonArray probabilities = of["probabilities"].toArray();
            const QJsonArray replacements = of["replacements"].toArray();
            QCOMPARE(qsizetype(rule.probabilities.size()), probabilities.size());
            QCOMPARE(qsizetype(rule.replacements.size()), replacements.size());
            for (std::size_t i = 0; i < rule.probabilities.size(); ++i) {
                QCOMPARE(rule.probabilities[i], probabilities[qsizetype(i)].toDouble());
                QCOMPARE(rule.replacements[i], replacements[qsizetype(i)].toString().toStdString());
            }
        }
    }
}

RAMURE_SUITE(TestPresets)

} // namespace tst_presets

#include "tst_presets.moc"
