#include "app/cli/commands/commands.h"
#include "app/cli/input.h"
#include "app/cli/work.h"
#include "core/io/formats/text/blender_scene.h"
#include "core/qt/document/project/project_file.h"
#include "core/scatter/scatter.h"
#include "core/scene/growth_spaces.h"
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonObject>
#include <algorithm>
#include <cmath>
#include <map>

namespace ramure::cli {

namespace {

constexpr CommandText scatterText = {
    "scatter", "lets many copies of a few trees stand on the ground", "[INPUT]",
    "Adds a scatter to a scene and saves the project: copies of trees that stand on the ground by rules.",
    "INPUT is the scene; without one the project holds the scatter alone. Each `--tree` names what is "
    "copied: "
    "preset:NAME, or a file whose trees and shapes are. The ground is the mesh of `--on`, else the terrains "
    "of "
    "the scene, else level. `--set scatter.KEY=VALUE` sets the other rules: shares, slopes, heights, a map "
    "of "
    "density, clusters, scales (`ramure-cli list params`).\n"
    "`export` writes the copies as instances where the format has them, and as a list beside the file with "
    "`--instances`."};

void addScatterOptions(CommandLine& line)
{
    line.addInputOptions();
    line.add({QStringLiteral("tree")},
             QStringLiteral("What is copied: preset:NAME, demo:NAME or a .ramure; may be repeated."),
             QStringLiteral("INPUT"));
    line.add({QStringLiteral("on")}, QStringLiteral("A mesh file: the ground."), QStringLiteral("FILE"));
    line.add(
        {QStringLiteral("area")},
        QStringLiteral("Width and depth of the area in m, with the origin in its middle: 100x60. As large "
                       "as the ground of --on where that is given alone."),
        QStringLiteral("WxD"));
    line.add({QStringLiteral("count")},
             QStringLiteral("At most so many copies. 0: as many as the spacing lets stand."),
             QStringLiteral("N"));
    line.add({QStringLiteral("spacing")}, QStringLiteral("m between two copies at least."),
             QStringLiteral("M"));
    line.add({QStringLiteral("seed")}, QStringLiteral("Another seed gives other places."),
             QStringLiteral("S"));
    line.add({QStringLiteral("o"), QStringLiteral("output")},
             QStringLiteral("The project to write, .ramure."), QStringLiteral("FILE"));
    line.add({QStringLiteral("json")}, QStringLiteral("Prints the numbers of copies as a JSON object."));
}

Expected<void> setNumber(const CommandLine& line, const char* option, const char* key, NodeParams& params)
{
    if (!line.has(option))
        return {};
    const ParamDef& def = *findParam(key);
    const auto named = [option](Error error) {
        error.path = std::string("--") + option;
        return error;
    };
    const auto value = parseValue(def, line.value(option).toStdString()).map_error(named);
    RAMURE_TRY(value);
    return setParam(params, def, *value).map_error(named);
}

Expected<void> setArea(const CommandLine& line, NodeParams& params)
{
    if (!line.has("area"))
        return {};
    const QStringList sides = line.value("area").split(QLatin1Char('x'));
    bool areGood[] = {false, false};
    const double width = sides.front().toDouble(&areGood[0]), depth = sides.back().toDouble(&areGood[1]);
    if (sides.size() != 2 || !areGood[0] || !areGood[1])
        return fail(ErrorCode::Syntax, "--area \"%1\": WIDTHxDEPTH in m expected, such as 100x60",
                    {line.value("area").toStdString()});
    RAMURE_TRY(setParam(params, *findParam("scatter.width"), width));
    return setParam(params, *findParam("scatter.depth"), depth);
}

/// The scene's top nodes and what is below them, under \p parent with other ids.
Expected<void> addScene(Scene& to, const Scene& from, NodeId parent)
{
    for (const NodeId top : from.children(noNode)) {
        std::vector<Node> nodes = from.subtree(top);
        std::map<NodeId, NodeId> ids;
        for (Node& node : nodes) {
            ids[node.id] = to.newId();
            node.id = ids[node.id];
            if (const auto above = ids.find(node.parent); above != ids.end())
                node.parent = above->second;
        }
        RAMURE_TRY(to.insert(std::move(nodes), parent, int(to.children(parent).size())));
    }
    return {};
}

/// All meshes of the file, by one name. The area becomes as large as they are where nobody says another.
Expected<void> addGround(const CommandLine& line, Scene& scene, NodeParams& scatter, const Progress& progress)
{
    if (!line.has("on"))
        return {};
    const QString file = line.value("on");
    auto imported = importObjects(systemPath(file), {}, progress);
    RAMURE_TRY(imported);
    scatter.scatter.ground = QFileInfo(file).completeBaseName().toStdString();
    for (Node& node : imported->nodes)
        if (node.kind == NodeKind::Mesh)
            node.name = scatter.scatter.ground;
    const auto ground = Scene::fromNodes(std::move(imported->nodes));
    RAMURE_TRY(ground);
    double width = 0.0, depth = 0.0;
    for (const Node& node : ground->nodes())
        if (node.mesh) {
            const glm::dmat4 place = geometryMatrix(*ground, node);
            for (const glm::vec3& point : node.mesh->positions) {
                const glm::dvec4 at = place * glm::dvec4(point, 1.0);
                width = std::max(width, 2.0 * std::abs(at.x));
                depth = std::max(depth, 2.0 * std::abs(at.z));
            }
        }
    if (!line.has("area")) {
        scatter.scatter.width = std::clamp(width, 1e-3, 1e6);
        scatter.scatter.depth = std::clamp(depth, 1e-3, 1e6);
    }
    return addScene(scene, *ground, noNode);
}

Expected<Scene> sceneOf(const CommandLine& line, const Progress& progress)
{
    if (line.arguments().isEmpty())
        return Scene();
    auto input = loadInput(line.arguments().front(), {}, progress);
    RAMURE_TRY(input);
    if (!input->scene())
        return fail(ErrorCode::Invalid, "\"%1\" is a mesh: --on makes it the ground",
                    {line.arguments().front().toStdString()});
    return std::get<Scene>(std::move(input->content));
}

Expected<NodeId> addScatterTo(Scene& scene, const CommandLine& line, const Progress& progress)
{
    Node scatter;
    scatter.kind = NodeKind::Scatter;
    scatter.name = "Scatter";
    RAMURE_TRY(setArea(line, scatter.params));
    RAMURE_TRY(setNumber(line, "count", "scatter.count", scatter.params));
    RAMURE_TRY(setNumber(line, "spacing", "scatter.spacing", scatter.params));
    RAMURE_TRY(setNumber(line, "seed", "scatter.seed", scatter.params));
    RAMURE_TRY(addGround(line, scene, scatter.params, progress));
    const NodeId id = scatter.id = scene.newId();
    RAMURE_TRY(scene.insert({std::move(scatter)}, noNode, int(scene.children(noNode).size())));
    for (const QString& tree : line.values("tree")) {
        const auto input = loadInput(tree, {}, progress);
        RAMURE_TRY(input);
        if (!input->scene())
            return fail(ErrorCode::Invalid, "--tree \"%1\" is a mesh: preset:NAME or a .ramure expected",
                        {tree.toStdString()});
        RAMURE_TRY(addScene(scene, *input->scene(), id));
    }
    RAMURE_TRY(applySettings(scene, line.values("set")));
    return id;
}

QString factsOf(const std::vector<const Node*>& prototypes, const ScatterPlaces& places)
{
    QString text = QStringLiteral("%1 copies\n").arg(places.size());
    for (std::size_t i = 0; i < prototypes.size(); ++i)
        text += QStringLiteral("  %1 %2\n")
                    .arg(std::ranges::count(places, std::uint32_t(i), &ScatterPlace::prototype), 8)
                    .arg(fromText(prototypes[i]->name));
    return text;
}

QJsonObject jsonOf(const std::vector<const Node*>& prototypes, const ScatterPlaces& places)
{
    QJsonArray list;
    for (std::size_t i = 0; i < prototypes.size(); ++i)
        list.append(
            QJsonObject{{QStringLiteral("name"), fromText(prototypes[i]->name)},
                        {QStringLiteral("copies"),
                         qint64(std::ranges::count(places, std::uint32_t(i), &ScatterPlace::prototype))}});
    return {{QStringLiteral("copies"), qint64(places.size())}, {QStringLiteral("prototypes"), list}};
}

Expected<int> runScatter(const CommandLine& line)
{
    if (!line.has("tree"))
        return fail(ErrorCode::Invalid,
                    "missing --tree INPUT: `ramure-cli scatter --help` shows what it takes");
    if (QFileInfo(line.value("output")).suffix().toLower() != QLatin1String("ramure"))
        return fail(ErrorCode::Invalid, "missing -o FILE.ramure");
    const Work work("scatter");
    auto scene = sceneOf(line, work.progress());
    RAMURE_TRY(scene);
    const auto id = addScatterTo(*scene, line, work.progress());
    RAMURE_TRY(id);
    linkGrowthSpaces(*scene);
    const std::vector<const Node*> prototypes = prototypesOf(*scene, *id);
    if (prototypes.empty())
        return fail(ErrorCode::Invalid, "nothing of --tree can be copied: trees and shapes can");
    const auto places = scatterPlaces(*scene, *scene->find(*id), work.progress());
    RAMURE_TRY(places);
    if ((*places)->empty())
        return fail(ErrorCode::Invalid, "the rules let no copy stand");
    RAMURE_TRY(saveProjectFile({*scene, {}}, line.value("output")));
    RAMURE_TRY(line.has("json") ? printJson(jsonOf(prototypes, **places))
                                : print(factsOf(prototypes, **places)));
    return exitGood;
}

} // namespace

const Command scatterCommand{scatterText, &addScatterOptions, &runScatter};

} // namespace ramure::cli
