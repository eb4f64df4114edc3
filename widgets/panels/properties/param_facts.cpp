#include "widgets/panels/properties/param_facts.h"

#include "core/presets/presets.h"
#include "core/rig/physics/wind.h"
#include "widgets/base/texts/core_text.h"
#include <QCoreApplication>
#include <QDate>
#include <QLocale>
#include <cmath>
#include <string_view>

namespace ramure {
namespace {

struct FactWords
{
    Q_DECLARE_TR_FUNCTIONS(ParamFacts)
};

QString unitText(const ParamDef& def, AngleUnit unit)
{
    switch (def.unit) {
    case ParamUnit::Metre:
        return FactWords::tr("metres; also cm, mm, km, in, ft");
    case ParamUnit::Radian:
        return unit == AngleUnit::Degrees ? FactWords::tr("degrees; also rad, turn, pi")
                                          : FactWords::tr("radians; also deg, turn, pi");
    case ParamUnit::Degree:
        return FactWords::tr("degrees");
    case ParamUnit::Ratio:
        return FactWords::tr("a ratio; also %");
    case ParamUnit::Share:
        return FactWords::tr("per cent");
    case ParamUnit::Count:
        return FactWords::tr("a count");
    case ParamUnit::Second:
        return FactWords::tr("seconds; also ms, min");
    case ParamUnit::Kilogram:
        return FactWords::tr("kilograms; also g");
    case ParamUnit::Factor:
        return FactWords::tr("a factor");
    case ParamUnit::Year:
        return FactWords::tr("years");
    case ParamUnit::Day:
        return FactWords::tr("days of the year: 1 is the first of January");
    case ParamUnit::None:
        break;
    }
    return {};
}

QString itemLabel(const ParamDef& def, const std::string& name)
{
    for (const EnumItem& item : def.items)
        if (name == item.name)
            return coreText(item.label);
    return {};
}

QString valueText(const ParamDef& def, const ParamValue& value, AngleUnit unit)
{
    const NumberFormat format = numberFormat(def, unit);
    if (const auto* flag = std::get_if<bool>(&value))
        return *flag ? FactWords::tr("on") : FactWords::tr("off");
    if (const auto* whole = std::get_if<std::int64_t>(&value))
        return format.text(static_cast<double>(*whole));
    if (const auto* real = std::get_if<double>(&value))
        return format.text(*real);
    if (const auto* vector = std::get_if<glm::dvec3>(&value))
        return QStringLiteral("%1, %2, %3")
            .arg(format.text(vector->x), format.text(vector->y), format.text(vector->z));
    if (const auto* choice = std::get_if<EnumValue>(&value))
        return itemLabel(def, choice->name);
    return {}; // texts are too long to say here; the reset arrow shows them
}

} // namespace

QList<std::pair<QString, QString>> paramFacts(const ParamDef& def, AngleUnit unit, const std::string& preset)
{
    const ParamValue standard = defaultValue(def), begun = presetValue(preset, def);
    QList<std::pair<QString, QString>> facts{{FactWords::tr("Unit"), unitText(def, unit)},
                                             {FactWords::tr("Range"), rangeText(def, unit)},
                                             {FactWords::tr("Default"), valueText(def, standard, unit)}};
    if (begun != standard)
        facts.append(
            {FactWords::tr("In %1").arg(QString::fromStdString(preset)), valueText(def, begun, unit)});
    facts.removeIf([](const auto& fact) { return fact.second.isEmpty(); });
    return facts;
}

QString paramMeaning(const ParamDef& def, const ParamValue& value)
{
    const auto* number = std::get_if<double>(&value);
    if (number && def.unit == ParamUnit::Day)
        return *number >= 1.0 ? QLocale().toString(QDate(2023, 1, 1).addDays(std::lround(*number) - 1),
                                                   FactWords::tr("d MMMM", "a day of the year"))
                              : FactWords::tr("no day: see Season");
    if (!number || def.key != std::string_view("physics.windStrength"))
        return {};
    return FactWords::tr("about %1 m/s on average")
        .arg(QLocale().toString(*number * robustWindSpeed, 'f', 1));
}

} // namespace ramure
