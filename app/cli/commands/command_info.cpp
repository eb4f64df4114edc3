#include "app/cli/commands/commands.h"
#include "app/cli/mesh_check.h"
#include "app/cli/moments.h"
#include "app/cli/scene_facts.h"
#include "core/scene/object_mesh.h"
#include "widgets/view/render/surface_images.h"
#include <QJsonArray>
#include <QJsonObject>
#include <algorithm>

namespace ramure::cli {

namespace {

constexpr CommandText infoText = {
    "info", "counts and measures of a tree or mesh", "INPUT",
    "Counts and measures the skeleton of a tree, before and after simplification, or a mesh file.",
    "Lengths are in metres and boxes in the tree's own space, before its placement. Of a project with "
    "several trees the counts "
    "and lengths are summed, maxChildren is the largest, min and max are the box of all trees in world "
    "space, and \"trees\" "
    "(JSON) lists each. \"leaves\" (JSON) counts those that hang, \"shed\" those that the season took. "
    "\"nodes\" (JSON) lists every node of a scene with its world matrix at --time: 16 "
    "numbers, "
    "row after row; \"geometry\" is where its own shape stands, which its children do not see; of arms, "
    "terrains, primitives and imported meshes also the vertices and faces, of arms the joints, the reach and "
    "the tip (m, the arm's own space, as it is at --time). \"edits\" counts the steps of recipes: in "
    "their places, matched by likeness, and without a place; \"list\" there "
    "names them with what became of each; \"badPictures\" names image files that are "
    "missing or cannot be read; \"axes\" with --axes lists the stems; \"measures\" are a tree's height, the "
    "diameter of its stem 1.3 m above the ground and the width of its crown without leaves (m); "
    "\"leafLength\" "
    "and \"leafReach\" are the median length of a leaf without and with its petiole (m), \"leafArea\" that "
    "of "
    "all blades, one side counted (m²), and \"leafAreaIndex\" that area over the ground below the crown. Of "
    "a file "
    "{read}: vertices, faces, box and its objects."};

QString figure(double value)
{
    return QString::number(value, 'g', 9);
}

QString vectorText(const glm::dvec3& v)
{
    return QStringLiteral("%1 %2 %3").arg(figure(v.x + 0.0), figure(v.y + 0.0), figure(v.z + 0.0));
}

QString row(const char* name, const QString& first, const QString& second = {})
{
    return (QStringLiteral("%1 %2 ").arg(QLatin1String(name), -12).arg(first, -36) + second).trimmed() +
           QLatin1Char('\n');
}

QString textOf(const TreeFacts& tree)
{
    const SkeletonFacts& a = tree.full;
    const SkeletonFacts& b = tree.simplified;
    return row("", QStringLiteral("skeleton"), QStringLiteral("simplified"))
               .prepend(QString(13, QLatin1Char(' '))) +
           row("symbols", QString::number(tree.symbols)) +
           row("branches", QString::number(a.branches), QString::number(b.branches)) +
           row("terminals", QString::number(a.terminals), QString::number(b.terminals)) +
           row("maxChildren", QString::number(a.maxChildren), QString::number(b.maxChildren)) +
           row("totalLength", figure(a.totalLength), figure(b.totalLength)) +
           row("sumA1", figure(a.sumA1), figure(b.sumA1)) +
           row("min", vectorText(a.box.min), vectorText(b.box.min)) +
           row("max", vectorText(a.box.max), vectorText(b.box.max));
}

using Checked = std::optional<std::vector<CheckedMesh>>;

/// Empty where it was not asked for.
QString verdictRow(const Checked& checked)
{
    return checked ? row("verdict", verdictText(verdictOn(*checked), crossingsOf(*checked))) : QString();
}

void addVerdict(QJsonObject& object, const Checked& checked)
{
    if (checked)
        object.insert(QStringLiteral("verdict"), QLatin1String(verdictName(verdictOn(*checked))));
}

/// How many there are of what is no tree.
QString objectsText(const Scene& scene)
{
    const auto& nodes = scene.nodes();
    const auto objects =
        std::count_if(nodes.begin(), nodes.end(), [](const Node& node) { return isShape(node.kind); });
    const auto moving =
        std::count_if(nodes.begin(), nodes.end(), [](const Node& node) { return !node.animation.empty(); });
    return objects == 0 && moving == 0
               ? QString()
               : row("objects", QString::number(objects)) + row("animated", QString::number(moving));
}

QString textOfTrees(const TreeFacts& sum, const std::vector<TreeFacts>& trees)
{
    if (trees.size() == 1)
        return textOf(trees.front());
    QString texts;
    for (const TreeFacts& tree : trees)
        texts += QStringLiteral("%1\n%2\n").arg(fromText(tree.name), textOf(tree));
    return texts + QStringLiteral("%1 trees\n%2").arg(trees.size()).arg(textOf(sum));
}

/// Image files that cannot be drawn.
QJsonArray jsonPictures(const Scene& scene)
{
    QJsonArray list;
    for (const Node& node : scene.nodes())
        for (const auto part : {&NodeParams::barkPictures, &NodeParams::leafPictures,
                                &NodeParams::fruitPictures, &NodeParams::surfacePictures})
            for (const Error& error : pictureProblems(node.params.*part))
                list.append(QJsonObject{{QStringLiteral("node"), qint64{node.id}},
                                        {QStringLiteral("file"), fromText(error.file)},
                                        {QStringLiteral("problem"), fromText(error.plain())}});
    return list;
}

Expected<void> showScene(EvaluatedScene now, const Checked& checked, bool json, bool axes)
{
    const auto facts = sceneFacts(now, axes);
    RAMURE_TRY(facts);
    const Scene& scene = now.scene();
    if (!json)
        return print((facts->trees.empty() ? QString() : textOfTrees(facts->sum, facts->trees)) +
                     objectsText(scene) + verdictRow(checked));
    auto all = jsonOf(*facts, now);
    RAMURE_TRY(all);
    if (const QJsonArray pictures = jsonPictures(scene); !pictures.isEmpty())
        all->insert(QStringLiteral("badPictures"), pictures);
    addVerdict(*all, checked);
    return printJson(*all);
}

Expected<void> showMesh(const ReadMesh& mesh, const Checked& checked, bool json)
{
    if (json) {
        QJsonObject out = jsonFacts(mesh);
        addVerdict(out, checked);
        return printJson(out);
    }
    QString lines;
    for (const ReadObject& object : mesh.objects)
        lines += row("object", fromText(object.name),
                     QStringLiteral("%1 vertices, %2 faces")
                         .arg(object.mesh.vertexCount())
                         .arg(object.mesh.faceCount()));
    for (const std::string& note : mesh.notes)
        lines += row("note", fromText(note));
    const TriangleMesh joined = mesh.joined();
    const Box box = boxOf(joined);
    return print(row("vertices", QString::number(joined.vertexCount())) +
                 row("faces", QString::number(joined.faceCount())) + row("min", vectorText(box.min)) +
                 row("max", vectorText(box.max)) + verdictRow(checked) + lines);
}

void addInfoOptions(CommandLine& line)
{
    line.addInputOptions();
    line.add({QStringLiteral("json")}, QStringLiteral("Prints one JSON object."));
    line.add(
        {QStringLiteral("axes")},
        QStringLiteral("With --json: every axis of each tree, from its foot to its tip as it was drawn."));
    line.add(
        {QStringLiteral("time")},
        QStringLiteral("Tracks as they are after so many seconds; 0 without it. Trees are measured at rest."),
        QStringLiteral("SECONDS"));
    line.add({QStringLiteral("verdict")},
             QStringLiteral("Also what the meshes are worth, as `validate --self-intersections` finds: the "
                            "worst verdict of all."));
}

Expected<int> runInfo(const CommandLine& line)
{
    const auto input = loadInput(line);
    RAMURE_TRY(input);
    const auto moments = momentsOf(line, *input);
    RAMURE_TRY(moments);
    Checked checked;
    TreePipeline pipeline;
    Evaluator evaluator(pipelineSource(pipeline), moments->timeline);
    if (line.has("verdict")) {
        auto found = checkMeshes(*input, evaluator, {moments->timeSeconds, true, true}, {});
        RAMURE_TRY(found);
        checked = std::move(*found);
    }
    const auto shown = input->scene() ? showScene(evaluator.at(*input->scene(), moments->timeSeconds),
                                                  checked, line.has("json"), line.has("axes"))
                                      : showMesh(*input->mesh(), checked, line.has("json"));
    RAMURE_TRY(shown);
    return exitGood;
}

} // namespace

const Command infoCommand{infoText, &addInfoOptions, &runInfo};

} // namespace ramure::cli
