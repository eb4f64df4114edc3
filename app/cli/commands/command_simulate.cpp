#include "app/cli/commands/commands.h"
#include "app/cli/input.h"
#include "app/cli/work.h"
#include "core/base/file_writer.h"
#include "core/base/number_text.h"
#include "core/params/source_facts.h"
#include "core/rig/physics/physics_cache.h"
#include <QJsonArray>
#include <QJsonObject>
#include <chrono>

namespace ramure::cli {

namespace {

constexpr CommandText simulateText = {
    "simulate", "lets a tree move", "INPUT", "Lets a tree move in the wind and says how far it went.",
    "Steps are of physics.stepSeconds; --set physics.mode=faithful, "
    "physics.windStrength=0 and so on say how.\n"
    "Of all steps: lengthError, the worst relative error of a branch's length; "
    "largestTurn, the largest angle "
    "between a branch and its direction at rest. After the last step: "
    "kineticEnergy, half the sum of mass times "
    "velocity squared; tip, the end of the first branch without children, in "
    "metres in the tree's own space.\n"
    "A CSV file has a row for each step, the tree at rest being step 0: "
    "step,time,lengthError,kineticEnergy,tipX,tipY,tipZ."};

/// Steps between two looks at Ctrl+C.
constexpr std::int64_t lookEvery = 16;

Expected<std::int64_t> stepsOf(const CommandLine& line)
{
    if (!line.has("steps"))
        return fail(ErrorCode::Invalid,
                    "missing --steps N: `ramure-cli simulate --help` shows what it takes");
    bool isNumber = false;
    const QString given = line.value("steps");
    const qlonglong steps = given.toLongLong(&isNumber);
    if (!isNumber || steps < 0 || steps > maxPhysicsSteps)
        return fail(ErrorCode::Invalid, "--steps \"%1\": a whole number from 0 to %2 expected",
                    {given.toStdString(), std::to_string(maxPhysicsSteps)});
    return steps;
}

Expected<const Node*> treeOf(const Input& input, const CommandLine& line)
{
    if (!input.scene())
        return fail(ErrorCode::Invalid, "\"%1\" is a mesh: only trees move",
                    {line.arguments().front().toStdString()});
    const auto trees = treesOf(*input.scene());
    RAMURE_TRY(trees);
    std::vector<const Node*> chosen;
    QStringList names;
    for (const Node* tree : *trees) {
        names << fromText(tree->name);
        if (!line.has("tree") || line.value("tree") == names.last())
            chosen.push_back(tree);
    }
    if (chosen.size() == 1)
        return chosen.front();
    return fail(ErrorCode::Invalid,
                chosen.empty() ? "--tree: none has this name; there are %1"
                               : "there are several trees: --tree NAME, one of %1, expected",
                {commaList(names).toStdString()});
}

/// Rows of figures, into a file or nowhere.
class Table
{
public:
    Expected<void> open(const QString& path)
    {
        auto file = FileWriter::open(systemPath(path));
        RAMURE_TRY(file);
        m_file.emplace(std::move(*file));
        m_file->append("step,time,lengthError,kineticEnergy,tipX,tipY,tipZ\n");
        return {};
    }
    void add(const PhysicsState& state, const PhysicsFigures& figures)
    {
        if (!m_file)
            return;
        std::string row = numberText(state.step);
        for (const double number : {state.timeSeconds, figures.lengthError, figures.kineticEnergy,
                                    figures.tip.x, figures.tip.y, figures.tip.z})
            row.append(",").append(numberText(number + 0.0));
        m_file->append(row.append("\n"));
    }
    [[nodiscard]] bool isGood() const { return !m_file || m_file->isGood(); }
    Expected<void> close() { return m_file ? m_file->commit() : Expected<void>(); }

private:
    std::optional<FileWriter> m_file;
};

struct Run
{
    PhysicsFigures last;
    double time = 0.0, lengthError = 0.0, largestTurnRad = 0.0;
    double stepSeconds = 0.0; ///< what a step took to compute
};

Expected<Run> simulate(TreePhysics& physics, std::int64_t steps, Table& table, const Progress& progress)
{
    using Clock = std::chrono::steady_clock;
    Run run;
    PhysicsState state = physics.restState();
    const auto look = [&] {
        run.last = physics.figures(state);
        run.lengthError = std::max(run.lengthError, run.last.lengthError);
        run.largestTurnRad = std::max(run.largestTurnRad, run.last.largestTurnRad);
        table.add(state, run.last);
    };
    look();
    Clock::duration busy{};
    while (state.step < steps && table.isGood()) {
        if (state.step % lookEvery == 0) {
            if (progress.cancelled())
                return fail(ErrorCode::Cancelled, "cancelled");
            progress.report(static_cast<double>(state.step) / static_cast<double>(steps));
        }
        const auto before = Clock::now();
        physics.step(state);
        busy += Clock::now() - before;
        look();
    }
    run.time = state.timeSeconds;
    run.stepSeconds =
        std::chrono::duration<double>(busy).count() / static_cast<double>(std::max<std::int64_t>(steps, 1));
    return run;
}

Expected<void> show(const Run& run, const TreeBody& body, std::int64_t steps, bool json)
{
    const glm::dvec3 tip = run.last.tip;
    if (json)
        return printJson(QJsonObject{{QStringLiteral("branches"), qint64(body.size())},
                                     {QStringLiteral("apples"), qint64(body.appleSlot.size())},
                                     {QStringLiteral("steps"), qint64(steps)},
                                     {QStringLiteral("time"), run.time},
                                     {QStringLiteral("lengthError"), run.lengthError},
                                     {QStringLiteral("largestTurn"), run.largestTurnRad},
                                     {QStringLiteral("kineticEnergy"), run.last.kineticEnergy},
                                     {QStringLiteral("tip"), QJsonArray{tip.x, tip.y, tip.z}},
                                     {QStringLiteral("stepMilliseconds"), 1e3 * run.stepSeconds}});
    const auto row = [](const char* name, const QString& value) {
        return QStringLiteral("%1 %2\n").arg(QLatin1String(name), -16).arg(value);
    };
    const auto number = [](double value) { return QString::number(value, 'g', 6); };
    return print(row("branches", QString::number(body.size())) +
                 row("apples", QString::number(body.appleSlot.size())) +
                 row("steps", QString::number(steps)) + row("time", number(run.time) + QStringLiteral(" s")) +
                 row("lengthError", number(run.lengthError)) +
                 row("largestTurn", number(run.largestTurnRad) + QStringLiteral(" rad")) +
                 row("kineticEnergy", number(run.last.kineticEnergy)) +
                 row("tip", QStringLiteral("%1 %2 %3 m").arg(number(tip.x), number(tip.y), number(tip.z))) +
                 row("stepTime", number(1e3 * run.stepSeconds) + QStringLiteral(" ms")));
}

void addSimulateOptions(CommandLine& line)
{
    line.addInputOptions();
    line.add({QStringLiteral("steps")}, QStringLiteral("How many steps."), QStringLiteral("N"));
    line.add({QStringLiteral("csv")}, QStringLiteral("Writes the figures of every step."),
             QStringLiteral("FILE"));
    line.add({QStringLiteral("tree")}, QStringLiteral("Which tree of a project with several."),
             QStringLiteral("NAME"));
    line.add({QStringLiteral("json")}, QStringLiteral("Prints one JSON object."));
}

Expected<int> runSimulate(const CommandLine& line)
{
    const auto steps = stepsOf(line);
    RAMURE_TRY(steps);
    const auto input = loadInput(line);
    RAMURE_TRY(input);
    const auto node = treeOf(*input, line);
    RAMURE_TRY(node);
    Table table; // before the long work: a folder that is missing
    if (line.has("csv"))
        RAMURE_TRY(table.open(line.value("csv")));
    const Work work("simulate");
    const Progress progress = work.progress();
    TreePipeline pipeline;
    const NodeParams& params = (*node)->params;
    const auto tree = evaluateTree(pipeline, **node, false, Stage::Foliage, progress.part(0.0, 0.1));
    RAMURE_TRY(tree);
    const auto body = makeTreeBody(tree->simplified->skeleton, tree->foliage.get(), trunkRadius(params));
    TreePhysics physics(body, params.physics);
    const auto run = simulate(physics, *steps, table, progress.part(0.1, 1.0));
    RAMURE_TRY(run);
    RAMURE_TRY(table.close());
    RAMURE_TRY(show(*run, *body, *steps, line.has("json")));
    return exitGood;
}

} // namespace

const Command simulateCommand{simulateText, &addSimulateOptions, &runSimulate};

} // namespace ramure::cli
