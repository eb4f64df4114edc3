#include "app/cli/commands/commands.h"
#include "app/cli/input.h"
#include "core/params/recipe.h"
#include "core/params/tree_edit_table.h"
#include "core/qt/document/project/project_json.h"
#include <QJsonObject>

namespace ramure::cli {

namespace {

constexpr CommandText recipeText = {
    "recipe", "lists the steps that make a tree", "INPUT",
    "Prints the recipe of each tree: the source that it begins with and the steps behind it, in their order.",
    "Each step has a number, its kind, a state and the values that are not the usual ones. States: `placed` "
    "acts, `matched` acts on a limb that looks like the one it was made for, `unplaced` has no such limb, "
    "`idle` "
    "cannot act and says why, `off` is switched off. `--set` and the columns of a table name a value of a "
    "step by its key alone where only one step has it, else as `#3.sag.amount` or `step:NAME.sag.amount`; a "
    "column cannot begin with #."};

struct StepFacts
{
    QString kind, name, state, why;
    bool enabled = true;
    double seconds = 0.0;
    QJsonObject values; ///< that are not those of a new step
};

/// The values of a step, or of the tree's own source, beside those of a new one.
QJsonObject valuesOf(const NodeParams& params, EditOperation operation, const NodeParams& usual)
{
    QJsonObject values;
    for (const ParamDef* def : stepParams(operation))
        if (const ParamValue value = def->get(params); value != def->get(usual))
            values.insert(QLatin1String(def->key), json::fromParam(value));
    return values;
}

Expected<std::vector<StepFacts>> factsOf(const Node& node, TreePipeline& pipeline, bool isOneOfSeveral)
{
    const auto result = evaluateTree(pipeline, node, isOneOfSeveral, Stage::Skeleton);
    RAMURE_TRY(result);
    const NodeParams usual;
    const QString first = fromText(stepName(node.params, 0));
    std::vector<StepFacts> steps{
        {first,
         first,
         QStringLiteral("placed"),
         {},
         true,
         0.0,
         valuesOf(node.params, editOperationOf(first.toStdString())->operation, usual)}};
    const std::vector<TreeEdit>& edits = node.params.edits;
    for (std::size_t i = 0; i < edits.size(); ++i) {
        const EditOutcome outcome = result->edits ? (*result->edits)[i] : EditOutcome();
        steps.push_back(
            {QLatin1String(infoOf(edits[i].operation).key), fromText(stepName(node.params, i + 1)),
             QLatin1String(stateName(outcome.state)), fromText(outcome.why.plain()), edits[i].enabled,
             outcome.seconds,
             valuesOf(*edits[i].values, edits[i].operation, *newStep(edits[i].operation).values)});
    }
    return steps;
}

QJsonObject jsonOf(const StepFacts& step, std::size_t number)
{
    QJsonObject out{{QStringLiteral("number"), qint64(number)}, {QStringLiteral("kind"), step.kind},
                    {QStringLiteral("name"), step.name},        {QStringLiteral("enabled"), step.enabled},
                    {QStringLiteral("state"), step.state},      {QStringLiteral("values"), step.values}};
    if (!step.why.isEmpty())
        out.insert(QStringLiteral("why"), step.why);
    return out;
}

QString lineOf(const StepFacts& step, std::size_t number)
{
    QString line = QStringLiteral("%1  %2 %3").arg(number, 3).arg(step.name, -24).arg(step.state, -9);
    if (!step.why.isEmpty())
        line += QStringLiteral(" (%1)").arg(step.why);
    for (auto it = step.values.begin(); it != step.values.end(); ++it) {
        const QString value = it.value().isString()   ? it.value().toString()
                              : it.value().isDouble() ? QString::number(it.value().toDouble())
                              : it.value().isBool()   ? QLatin1String(it.value().toBool() ? "true" : "false")
                                                      : QStringLiteral("...");
        line += QStringLiteral(" %1=%2").arg(it.key(), value);
    }
    return line.trimmed().prepend(QString(number < 10 ? 2 : number < 100 ? 1 : 0, u' ')) + u'\n';
}

void addRecipeOptions(CommandLine& line)
{
    line.addInputOptions();
    line.add({QStringLiteral("json")}, QStringLiteral("Prints one JSON object."));
}

Expected<int> runRecipe(const CommandLine& line)
{
    const auto input = loadInput(line);
    RAMURE_TRY(input);
    if (!input->scene())
        return fail(ErrorCode::Invalid, "\"%1\" is a mesh: only trees have a recipe",
                    {line.arguments().front().toStdString()});
    const auto trees = treesOf(*input->scene());
    RAMURE_TRY(trees);
    TreePipeline pipeline;
    QJsonArray all;
    QString text;
    for (const Node* node : *trees) {
        const auto steps = factsOf(*node, pipeline, trees->size() > 1);
        RAMURE_TRY(steps);
        text += trees->size() > 1 ? fromText(node->name) + QLatin1String(":\n") : QString();
        QJsonArray list;
        for (std::size_t i = 0; i < steps->size(); ++i) {
            text += lineOf((*steps)[i], i + 1);
            list.append(jsonOf((*steps)[i], i + 1));
        }
        all.append(
            QJsonObject{{QStringLiteral("tree"), fromText(node->name)}, {QStringLiteral("steps"), list}});
    }
    RAMURE_TRY(line.has("json") ? printJson(QJsonObject{{QStringLiteral("trees"), all}}) : print(text));
    return exitGood;
}

} // namespace

const Command recipeCommand{recipeText, &addRecipeOptions, &runRecipe};

} // namespace ramure::cli
