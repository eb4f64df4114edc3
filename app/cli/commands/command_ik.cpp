#include "app/cli/commands/commands.h"
#include "app/cli/input.h"
#include "core/rig/arm/arm_solver.h"
#include <QJsonArray>
#include <QJsonObject>
#include <cmath>

namespace ramure::cli {

namespace {

constexpr CommandText ikText = {
    "ik", "turns the joints of an arm to a target", "INPUT",
    "Turns the joints of an arm until its tip is at a target.",
    "INPUT is demo:Arm or a .ramure file; of several arms --node names one. The target is in the arm's own "
    "space: its foot "
    "at 0, Z up, metres. Angles are radians. Speed limits do not count. Where the target is not reached, the "
    "exit code is "
    "1 and residual says how far the tip is from it."};

Expected<const Node*> armOf(const Scene& scene, const QString& name)
{
    for (const Node& node : scene.nodes())
        if (node.kind == NodeKind::Arm && (name.isEmpty() || fromText(node.name) == name))
            return &node;
    if (name.isEmpty())
        return fail(ErrorCode::Invalid, "the project holds no arm");
    return fail(ErrorCode::Unknown, "there is no arm \"%1\"", {name.toStdString()});
}

Expected<glm::dvec3> parseTarget(const QString& typed)
{
    if (typed.isEmpty())
        return fail(ErrorCode::Invalid, "missing --target X,Y,Z");
    const auto value = parseValue(*findParam("arm.target"), typed.toStdString());
    const auto* target = value ? std::get_if<glm::dvec3>(&*value) : nullptr;
    if (!target || !std::isfinite(target->x + target->y + target->z))
        return fail(ErrorCode::Syntax, "--target \"%1\": X,Y,Z expected", {typed.toStdString()});
    return *target;
}

Expected<ArmSolverParams> parseSolver(const CommandLine& line, ArmSolverParams params)
{
    const QString name = line.value("solver");
    if (name == QLatin1String("transpose"))
        params.kind = ArmSolverKind::Transpose;
    else if (name == QLatin1String("dls"))
        params.kind = ArmSolverKind::LeastSquares;
    else if (!name.isEmpty())
        return fail(ErrorCode::Invalid, "--solver \"%1\": transpose or dls expected", {name.toStdString()});
    return params;
}

Expected<int> parseSteps(const CommandLine& line)
{
    bool isNumber = false;
    const int steps = line.value("steps").toInt(&isNumber);
    if (!isNumber || steps < 0 || steps > 10'000'000)
        return fail(ErrorCode::Invalid, "--steps \"%1\": a number from 0 to 10000000 expected",
                    {line.value("steps").toStdString()});
    return steps;
}

QJsonObject jsonOf(const ArmSolver& solver)
{
    QJsonArray angles;
    for (std::size_t i = 0; i < solver.angles().size(); i += 2)
        angles.append(QJsonObject{{QStringLiteral("phi"), solver.angles()[i]},
                                  {QStringLiteral("theta"), solver.angles()[i + 1]}});
    const glm::dvec3& tip = solver.chain().tip();
    int atLimit = 0;
    for (std::size_t i = 0; i < solver.angles().size(); ++i)
        atLimit += solver.limit(i) == ArmLimit::Free ? 0 : 1;
    return {{QStringLiteral("angles"), angles},
            {QStringLiteral("tip"), QJsonArray{tip.x + 0.0, tip.y + 0.0, tip.z + 0.0}},
            {QStringLiteral("residual"), solver.figures().residual},
            {QStringLiteral("steps"), qint64(solver.figures().steps)},
            {QStringLiteral("anglesAtLimit"), atLimit},
            {QStringLiteral("reached"), solver.figures().status == ArmStatus::Reached}};
}

QString textOf(const ArmSolver& solver)
{
    const auto number = [](double value) { return QString::number(value + 0.0, 'g', 9); };
    QString out;
    for (std::size_t i = 0; i < solver.angles().size(); i += 2)
        out += QStringLiteral("joint %1: phi %2, theta %3\n")
                   .arg(i / 2 + 1)
                   .arg(number(solver.angles()[i]), number(solver.angles()[i + 1]));
    const glm::dvec3& tip = solver.chain().tip();
    const ArmFigures& figures = solver.figures();
    out += QStringLiteral("tip      %1 %2 %3\n").arg(number(tip.x), number(tip.y), number(tip.z));
    out += QStringLiteral("residual %1 m\nsteps    %2\n").arg(number(figures.residual)).arg(figures.steps);
    return out +
           QStringLiteral("reached  %1\n")
               .arg(figures.status == ArmStatus::Reached ? QStringLiteral("yes") : QStringLiteral("no"));
}

Expected<int> solveInput(const CommandLine& line)
{
    const auto target = parseTarget(line.value("target"));
    RAMURE_TRY(target);
    const auto steps = parseSteps(line);
    RAMURE_TRY(steps);
    const auto input = loadInput(line);
    RAMURE_TRY(input);
    if (!input->scene())
        return fail(ErrorCode::Invalid, "a mesh has no arm");
    const auto arm = armOf(*input->scene(), line.value("node"));
    RAMURE_TRY(arm);
    const auto params = parseSolver(line, (*arm)->params.ik);
    RAMURE_TRY(params);
    ArmSolver solver((*arm)->params.joints, *params);
    solver.setTarget(*target);
    solver.solve(*steps);
    const auto shown = line.has("json") ? printJson(jsonOf(solver)) : print(textOf(solver));
    RAMURE_TRY(shown);
    return solver.figures().status == ArmStatus::Reached ? exitGood : exitCheckFailed;
}

void addIkOptions(CommandLine& line)
{
    line.addInputOptions();
    line.add({QStringLiteral("target")}, QStringLiteral("Where the tip is to go."), QStringLiteral("X,Y,Z"));
    line.add({QStringLiteral("solver")},
             QStringLiteral("transpose or dls (damped least squares); without it the arm's own."),
             QStringLiteral("transpose|dls"));
    line.addDefault({QStringLiteral("steps")}, QStringLiteral("Gives up after so many steps."),
                    QStringLiteral("N"), QStringLiteral("10000"));
    line.add({QStringLiteral("node")}, QStringLiteral("Name of the arm; without it the first one."),
             QStringLiteral("NAME"));
    line.add({QStringLiteral("json")}, QStringLiteral("Prints one JSON object."));
}

} // namespace

const Command ikCommand{ikText, &addIkOptions, &solveInput};

} // namespace ramure::cli
