#include "app/cli/commands/commands.h"
#include "app/cli/json_measures.h"
#include "app/cli/work.h"
#include "core/base/parallel.h"
#include "core/generators/variety.h"
#include "core/params/recipe.h"
#include "core/params/source_facts.h"
#include "core/params/tree_edit_table.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/presets/named_seeds.h"
#include "core/presets/presets.h"
#include "core/skeleton/measures.h"
#include "core/surface/foliage/place_foliage.h"
#include <QJsonArray>
#include <QJsonObject>
#include <span>
#include <vector>

namespace ramure::cli {

namespace {

constexpr CommandText listText = {
    "list", "the trees that ship with the program; every parameter", "presets|params",
    "Lists the trees that ship with the program, or every parameter of a tree.",
    "A parameter's key is its name in project files and for --set. Numbers outside its range are refused. "
    "Of a species --json names seeds worth a look, gives the mean height, stem diameter (1.3 m above the "
    "ground) and crown width of their trees in m (\"ours\"), and what was measured of such trees "
    "(\"published\", with its source; null where there is none). Of a species whose leaves have a length "
    "of their own \"ours\" has their sizes as `info` prints them, and \"publishedLeaves\" the ranges that "
    "floras give. \"steps\" are those of its recipe, and of a tree that grows by years \"ages\" says when "
    "it is young, mature and old."};

const char* unitName(ParamUnit unit)
{
    switch (unit) {
    case ParamUnit::None:
        return "";
    case ParamUnit::Metre:
        return "m";
    case ParamUnit::Radian:
        return "rad";
    case ParamUnit::Ratio:
        return "ratio";
    case ParamUnit::Count:
        return "count";
    case ParamUnit::Degree:
        return "deg";
    case ParamUnit::Second:
        return "s";
    case ParamUnit::Share:
        return "share";
    case ParamUnit::Kilogram:
        return "kg";
    case ParamUnit::Factor:
        return "factor";
    case ParamUnit::Year:
        return "years";
    case ParamUnit::Day:
        return "day";
    }
    return "";
}

const char* typeName(ParamType type)
{
    switch (type) {
    case ParamType::Bool:
        return "bool";
    case ParamType::Int:
        return "int";
    case ParamType::Real:
        return "real";
    case ParamType::Text:
        return "text";
    case ParamType::Vec3:
        return "vec3";
    case ParamType::Enum:
        return "choice";
    }
    return "";
}

bool hasRange(const ParamDef& def)
{
    return def.type == ParamType::Int || def.type == ParamType::Real || def.type == ParamType::Vec3;
}

QStringList itemNames(const ParamDef& def)
{
    QStringList out;
    for (const EnumItem& item : def.items)
        out << QString::fromUtf8(item.name);
    return out;
}

/// Bounds that are no bounds are not shown.
QString rangeText(const ParamDef& def)
{
    if (!def.items.empty())
        return itemNames(def).join(QLatin1Char('|'));
    if (!hasRange(def))
        return {};
    const auto number = [](double value) { return fromText(formatValue(ParamValue(value))); };
    return number(def.hardMin) + QStringLiteral(" .. ") + number(def.hardMax);
}

QJsonValue jsonValue(const ParamValue& value)
{
    if (const auto* flag = std::get_if<bool>(&value))
        return *flag;
    if (const auto* whole = std::get_if<std::int64_t>(&value))
        return qint64(*whole);
    if (const auto* real = std::get_if<double>(&value))
        return *real;
    if (const auto* string = std::get_if<std::string>(&value))
        return fromText(*string);
    if (const auto* choice = std::get_if<EnumValue>(&value))
        return fromText(choice->name);
    const auto& vector = std::get<glm::dvec3>(value);
    return QJsonArray{vector.x, vector.y, vector.z};
}

struct SpeciesMeasures
{
    TreeMeasures tree;
    LeafMeasures leaves; ///< of a species whose leaves have a length of their own
};

/// Mean of the trees of all named seeds; of a tree that grows by years, which takes longer, the typical one.
/// Errors: those of the tree; Cancelled.
Expected<SpeciesMeasures> meanMeasures(TreePipeline& pipeline, const Preset& preset, const Progress& progress)
{
    std::span<const std::int64_t> seeds = *namedSeeds(preset.name);
    if (preset.ages.front() > 0)
        seeds = seeds.first(1);
    SpeciesMeasures sum;
    for (const std::int64_t seed : seeds) {
        const auto tree = pipeline.evaluate(reseeded(preset.params, seed), Stage::Skeleton, progress);
        RAMURE_TRY(tree);
        const TreeMeasures one = measuresOf(*tree->skeleton);
        const auto count = static_cast<double>(seeds.size());
        sum.tree.height += one.height / count;
        sum.tree.stemDiameter += one.stemDiameter / count;
        sum.tree.crownWidth += one.crownWidth / count;
    }
    if (publishedLeaves(preset.latin) && preset.params.leaf.length > 0.0) {
        const NodeParams params = reseeded(preset.params, seeds.front());
        const auto tree = pipeline.evaluate(params, Stage::Simplified, progress);
        RAMURE_TRY(tree);
        const auto foliage = placeFoliage(tree->simplified->skeleton, params.foliage, params.leaf,
                                          params.fruit, trunkRadius(params), progress);
        RAMURE_TRY(foliage);
        sum.leaves = leafMeasures(*foliage, trunkRadius(params), sum.tree.crownWidth);
    }
    return sum;
}

/// Returns the means of all presets, and nothing for those without named seeds. They grow side by side.
std::vector<Expected<SpeciesMeasures>> allMeasures(const Progress& progress)
{
    std::vector<Expected<SpeciesMeasures>> all(presets().size(), SpeciesMeasures());
    parallelFor(all.size(), 1, [&](std::size_t i, std::size_t) {
        TreePipeline pipeline;
        if (const Preset& preset = presets()[i]; namedSeeds(preset.name))
            all[i] = meanMeasures(pipeline, preset, {progress.stop, {}});
    });
    return all;
}

/// Adds what is known of a species.
void addSpecies(QJsonObject& entry, const Preset& preset, const SpeciesMeasures& ours)
{
    QJsonObject seeds;
    for (std::size_t i = 0; i < namedSeedCount; ++i)
        seeds.insert(QLatin1String(seedNames[i]), qint64((*namedSeeds(preset.name))[i]));
    entry.insert(QStringLiteral("seeds"), seeds);
    QJsonObject own = jsonMeasures(ours.tree);
    if (ours.leaves.leaves > 0)
        insertLeaves(own, ours.leaves);
    entry.insert(QStringLiteral("ours"), own);
    const PublishedMeasures* published = publishedMeasures(preset.latin);
    entry.insert(QStringLiteral("published"),
                 published ? QJsonValue(jsonMeasures(published->mean)) : QJsonValue());
    entry.insert(QStringLiteral("source"),
                 published ? QJsonValue(QLatin1String(published->source)) : QJsonValue());
    if (const PublishedLeaves* leaves = publishedLeaves(preset.latin); leaves && ours.leaves.leaves > 0)
        entry.insert(QStringLiteral("publishedLeaves"),
                     QJsonObject{{QStringLiteral("leafLength"), jsonRange(leaves->length)},
                                 {QStringLiteral("leafAreaIndex"), jsonRange(leaves->areaIndex)},
                                 {QStringLiteral("source"), QLatin1String(publishedLeavesSource)}});
}

Expected<QJsonArray> presetsJson()
{
    const Work work("list");
    const auto measures = allMeasures(work.progress());
    QJsonArray out;
    for (std::size_t i = 0; i < presets().size(); ++i) {
        RAMURE_TRY(measures[i]);
        const Preset& preset = presets()[i];
        QJsonObject entry{{QStringLiteral("name"), QString::fromUtf8(preset.name)},
                          {QStringLiteral("latin"), QString::fromUtf8(preset.latin)},
                          {QStringLiteral("group"), QString::fromUtf8(preset.group)},
                          {QStringLiteral("description"), QString::fromUtf8(preset.description)}};
        const NodeParams& params = preset.params;
        QJsonArray steps;
        for (StepNumber step = 0; step <= params.edits.size(); ++step)
            steps.append(fromText(stepName(params, step)));
        entry.insert(QStringLiteral("steps"), steps);
        const bool grows = preset.ages.front() > 0;
        if (grows)
            entry.insert(QStringLiteral("ages"), QJsonObject{{QStringLiteral("young"), preset.ages[0]},
                                                             {QStringLiteral("mature"), preset.ages[1]},
                                                             {QStringLiteral("old"), preset.ages[2]}});
        if (namedSeeds(preset.name))
            addSpecies(entry, preset, *measures[i]);
        out.append(entry);
    }
    return out;
}

QJsonArray paramsJson()
{
    QJsonArray out;
    for (const ParamDef& def : allParams()) {
        QJsonObject row{{QStringLiteral("key"), QString::fromUtf8(def.key)},
                        {QStringLiteral("group"), QString::fromUtf8(def.group)},
                        {QStringLiteral("label"), QString::fromUtf8(def.label)},
                        {QStringLiteral("description"), QString::fromUtf8(def.tooltip)},
                        {QStringLiteral("type"), QLatin1String(typeName(def.type))},
                        {QStringLiteral("unit"), QLatin1String(unitName(def.unit))},
                        {QStringLiteral("default"), jsonValue(defaultValue(def))}};
        if (hasRange(def)) {
            row.insert(QStringLiteral("min"), def.hardMin);
            row.insert(QStringLiteral("max"), def.hardMax);
        }
        if (!def.items.empty())
            row.insert(QStringLiteral("items"), QJsonArray::fromStringList(itemNames(def)));
        out.append(row);
    }
    return out;
}

/// The value on one line, as --set takes it.
QString defaultText(const ParamDef& def)
{
    QString out = fromText(formatValue(defaultValue(def)));
    if (def.type == ParamType::Text)
        out.replace(QLatin1Char('\\'), QStringLiteral("\\\\"))
            .replace(QLatin1Char('\n'), QStringLiteral("\\n"));
    return out;
}

QString presetsText()
{
    QString out;
    for (const Preset& preset : presets())
        out += QStringLiteral("%1 %2%3\n")
                   .arg(QString::fromUtf8(preset.name), -18)
                   .arg(*preset.latin ? QString::fromUtf8(preset.latin) + QStringLiteral(": ") : QString())
                   .arg(QString::fromUtf8(preset.description));
    return out;
}

QString paramsText()
{
    QString out;
    for (const ParamDef& def : allParams()) {
        const QString unit = QLatin1String(unitName(def.unit));
        out += QStringLiteral("%1 %2 %3 %4\n")
                   .arg(QString::fromUtf8(def.key), -28)
                   .arg(QLatin1String(typeName(def.type)) +
                            (unit.isEmpty() ? unit : QStringLiteral(", ") + unit),
                        -12)
                   .arg(rangeText(def), -24)
                   .arg(defaultText(def));
    }
    return out;
}

QString paramsMarkdown()
{
    QString out =
        QStringLiteral("# Parameters\n\n"
                       "Made by `./dev docs` from the parameter table: `ramure-cli list params --markdown`. "
                       "The key is the name in "
                       "project files and for `--set key=value`. Numbers outside the range are refused.\n");
    const char* group = "";
    for (const ParamDef& def : allParams()) {
        if (std::string_view(group) != def.group) {
            group = def.group;
            out += QStringLiteral("\n## %1\n").arg(QString::fromUtf8(group));
        }
        out += QStringLiteral("\n**%1** `%2`  \n%3\n")
                   .arg(QString::fromUtf8(def.label), QString::fromUtf8(def.key),
                        QString::fromUtf8(def.tooltip));
        QStringList facts{QLatin1String(typeName(def.type))};
        if (*unitName(def.unit))
            facts << QLatin1String(unitName(def.unit));
        if (hasRange(def))
            facts << QStringLiteral("range %1").arg(rangeText(def));
        if (!def.items.empty())
            facts << QStringLiteral("one of `%1`").arg(itemNames(def).join(QStringLiteral("`, `")));
        out += QStringLiteral("\n- %1\n- default `` %2 ``\n").arg(commaList(facts), defaultText(def));
    }
    return out;
}

void addListOptions(CommandLine& line)
{
    line.add({QStringLiteral("json")}, QStringLiteral("Prints JSON: an array with one object per entry."));
    line.add({QStringLiteral("markdown")}, QStringLiteral("Prints the handbook's page of the parameters."));
}

Expected<int> runList(const CommandLine& line)
{
    const QString what = line.arguments().front();
    const bool isPresets = what == QLatin1String("presets");
    if (!isPresets && what != QLatin1String("params"))
        return fail(ErrorCode::Unknown, "cannot list \"%1\": presets or params expected",
                    {what.toStdString()});
    if (line.has("markdown") && (isPresets || line.has("json")))
        return fail(ErrorCode::Invalid, "--markdown is for params, and not together with --json");
    const auto printed = line.has("json") && isPresets
                             ? presetsJson().and_then([](const QJsonArray& list) { return printJson(list); })
                         : line.has("json")     ? printJson(paramsJson())
                         : line.has("markdown") ? print(paramsMarkdown())
                                                : print(isPresets ? presetsText() : paramsText());
    RAMURE_TRY(printed);
    return exitGood;
}

} // namespace

const Command listCommand{listText, &addListOptions, &runList};

} // namespace ramure::cli
