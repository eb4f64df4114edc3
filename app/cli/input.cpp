#include "app/cli/input.h"
#include "core/base/utf8.h"
#include "core/generators/parametric/grammar_notes.h"
#include "core/io/formats/file_format.h"
#include "core/params/recipe.h"
#include "core/qt/document/project/project_file.h"
#include "core/rig/arm/arm_chain.h"
#include "core/scene/demo_scenes.h"
#include "core/scene/growth_spaces.h"
#include "core/scene/object_mesh.h"
#include "core/scene/preset_scene.h"
#include "core/scene/shown_nodes.h"
#include <QFileInfo>
#include <QJsonObject>
#include <QLocale>
#include <algorithm>
#include <set>

namespace ramure::cli {

namespace {

struct Setting
{
    RecipeKey key;
    ParamValue value;
};

Expected<Setting> parseSetting(const QString& text)
{
    const auto equals = text.indexOf(QLatin1Char('='));
    if (equals < 0)
        return fail(ErrorCode::Syntax, "--set \"%1\": KEY=VALUE expected", {text.toStdString()});
    auto key = parseRecipeKey(text.left(equals).trimmed().toStdString());
    RAMURE_TRY(key);
    auto value = parseValue(*key->def, text.mid(equals + 1).toStdString(), true);
    RAMURE_TRY(value);
    return Setting{std::move(*key), std::move(*value)};
}

/// "joints[1].theta.angle=0.3", of all arms that have this joint; settings of joints are radians too.
Expected<void> applyJointSetting(Scene& scene, const QString& text)
{
    const auto equals = text.indexOf(QLatin1Char('='));
    const std::string key = text.left(equals).trimmed().toStdString();
    const auto channel = channelFromKey(key, NodeKind::Arm);
    if (equals < 0 || !channel)
        return fail(ErrorCode::Unknown,
                    "unknown setting \"%1\": joints[0].length=METRES, joints[0].phi.angle=RADIANS "
                    "or the like expected",
                    {text.toStdString()});
    bool isNumber = false;
    const double value = QLocale::c().toDouble(text.mid(equals + 1).trimmed(), &isNumber);
    if (!isNumber)
        return fail(ErrorCode::Syntax, "--set \"%1\": a number is expected", {text.toStdString()});
    for (const Node& listed : scene.nodes()) {
        std::vector<ArmJoint>& joints = scene.find(listed.id)->params.joints;
        if (listed.kind != NodeKind::Arm || channel->component >= joints.size())
            continue;
        channel->jointDef()->of(joints[channel->component]) = value;
        if (auto checked = checkArm(joints); !checked)
            return checked;
    }
    return {};
}

/// Of all nodes that have the parameter; of several trees, those whose recipe has it.
Expected<void> applySetting(Scene& scene, const Setting& setting)
{
    Expected<void> refused;
    bool taken = false;
    for (const Node& listed : scene.nodes()) {
        NodeParams& params = scene.find(listed.id)->params;
        const bool isOfTree = listed.kind == NodeKind::Tree && isOfSteps(*setting.key.def);
        if (!isOfTree && !hasParam(listed.kind, *setting.key.def))
            continue;
        const auto set = listed.kind == NodeKind::Tree ? setRecipeValue(params, setting.key, setting.value)
                                                       : setParam(params, *setting.key.def, setting.value);
        taken = taken || set;
        if (!set && set.error().code != ErrorCode::Unknown)
            return set;
        if (!set)
            refused = set;
    }
    return taken ? Expected<void>() : refused;
}

Expected<Scene> projectScene(const QString& path)
{
    auto project = loadProjectFile(path);
    RAMURE_TRY(project);
    return std::move(project->scene);
}

} // namespace

Expected<void> applySettings(Scene& scene, const QStringList& sets)
{
    for (const QString& text : sets) {
        if (!isUtf8(systemPath(text)))
            return fail(ErrorCode::Syntax, "--set \"%1\": the text is no UTF-8", {text.toStdString()});
        if (text.startsWith(QLatin1String("joints["))) {
            if (auto set = applyJointSetting(scene, text); !set)
                return set;
            continue;
        }
        const auto setting = parseSetting(text);
        RAMURE_TRY(setting);
        RAMURE_TRY(applySetting(scene, *setting));
    }
    return {};
}

const char* stateName(EditState state)
{
    constexpr const char* names[] = {"off", "frozen", "waits", "placed", "matched", "unplaced", "idle"};
    return names[static_cast<std::size_t>(state)];
}

Expected<Input> loadInput(const QString& text, const QStringList& sets, const Progress& progress)
{
    const QString presetPrefix = QStringLiteral("preset:"), demoPrefix = QStringLiteral("demo:");
    const QString ending = QFileInfo(text).suffix().toLower();
    const bool isPreset = text.startsWith(presetPrefix), isDemo = text.startsWith(demoPrefix);
    if (isPreset || isDemo || ending == QLatin1String("ramure")) {
        auto scene = isPreset ? presetScene(text.mid(presetPrefix.size()).toStdString())
                     : isDemo ? demoScene(text.mid(demoPrefix.size()).toStdString())
                              : projectScene(text);
        RAMURE_TRY(scene);
        RAMURE_TRY(applySettings(*scene, sets));
        linkGrowthSpaces(*scene);
        return Input{std::move(*scene)};
    }
    if (!findFormat(systemPath(text), FormatUse::Read))
        return fail(ErrorCode::Unknown,
                    "\"%1\" is no input: preset:NAME, demo:NAME or a file .ramure, %2 expected",
                    {text.toStdString(), endingList(FormatUse::Read)});
    if (!sets.isEmpty())
        return fail(ErrorCode::Invalid, "--set needs a tree: \"%1\" is a mesh", {text.toStdString()});
    auto mesh = readMeshFile(systemPath(text), progress);
    RAMURE_TRY(mesh);
    return Input{std::move(*mesh)};
}

Expected<Input> loadInput(const CommandLine& line, const Progress& progress)
{
    auto input = loadInput(line.arguments().front(), line.values("set"), progress);
    if (input && input->scene())
        for (const Error& warning : warningsOf(*input->scene()))
            printError(QStringLiteral("warning: ") + fromText(warning.message()));
    return input;
}

std::vector<Error> warningsOf(const Scene& scene)
{
    const auto& nodes = scene.nodes();
    const bool isOne = std::ranges::count(nodes, NodeKind::Tree, &Node::kind) == 1;
    std::vector<Error> warnings;
    for (const Node& node : nodes)
        if (node.kind == NodeKind::Tree)
            for (Error& warning : grammarWarnings(node.params))
                warnings.push_back(isOne ? std::move(warning) : named(node, std::move(warning)));
    return warnings;
}

QJsonArray jsonWarnings(const Scene& scene)
{
    QJsonArray list;
    for (const Error& warning : warningsOf(scene))
        list.append(QJsonObject{{QStringLiteral("path"), fromText(warning.path)},
                                {QStringLiteral("line"), warning.line},
                                {QStringLiteral("column"), warning.column},
                                {QStringLiteral("text"), fromText(warning.plain())}});
    return list;
}

Expected<std::vector<const Node*>> treesOf(const Scene& scene)
{
    std::vector<const Node*> trees;
    for (const Node& node : scene.nodes())
        if (node.kind == NodeKind::Tree)
            trees.push_back(&node);
    if (trees.empty())
        return fail(ErrorCode::Invalid, "the project holds no tree");
    return trees;
}

Expected<std::vector<const Node*>> treesOrShapes(const Scene& scene)
{
    const auto& nodes = scene.nodes();
    const bool trees =
        std::any_of(nodes.begin(), nodes.end(), [](const Node& node) { return node.kind == NodeKind::Tree; });
    const bool shapes =
        std::any_of(nodes.begin(), nodes.end(), [](const Node& node) { return isShape(node.kind); });
    return trees || !shapes ? treesOf(scene) : std::vector<const Node*>();
}

Expected<void> keepNodes(Input& input, const QStringList& names)
{
    if (names.isEmpty())
        return {};
    Scene* scene = std::get_if<Scene>(&input.content);
    if (!scene)
        return fail(ErrorCode::Invalid, "--node needs a scene: the input is a mesh");
    std::set<NodeId> chosen;
    for (const QString& name : names) {
        const std::size_t before = chosen.size();
        for (const Node& node : scene->nodes())
            if (fromText(node.name) == name)
                chosen.insert(node.id);
        if (chosen.size() == before)
            return fail(ErrorCode::Unknown,
                        "--node \"%1\": no node has this name: `ramure-cli info INPUT --json` lists them",
                        {name.toStdString()});
    }
    showOnly(*scene, std::vector<NodeId>(chosen.begin(), chosen.end()));
    return {};
}

static Expected<TreeResult> told(Expected<TreeResult> result, const Node& node, bool isOneOfSeveral)
{
    if (!result && isOneOfSeveral)
        return fail(named(node, std::move(result.error())));
    return result;
}

Expected<TreeResult> evaluateTree(TreePipeline& pipeline, const Node& node, bool isOneOfSeveral, Stage last,
                                  const Progress& progress)
{
    return told(pipeline.evaluate(node.params, last, progress), node, isOneOfSeveral);
}

Expected<TreeResult> evaluateTree(EvaluatedScene& scene, const Node& node, bool isOneOfSeveral, Stage last,
                                  const Progress& progress)
{
    return told(scene.tree(node, last, progress), node, isOneOfSeveral);
}

} // namespace ramure::cli
