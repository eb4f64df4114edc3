#include "app/cli/commands/commands.h"
#include "app/cli/input.h"
#include "app/cli/json_measures.h"
#include "app/cli/mesh_check.h"
#include "app/cli/moments.h"
#include "core/math/box.h"
#include "core/params/source_facts.h"
#include "core/params/tree_edit_table.h"
#include "core/qt/document/project/project_json.h"
#include "core/recipe/apply_edits.h"
#include "core/rig/arm/arm_chain.h"
#include "core/scene/object_mesh.h"
#include "core/skeleton/edit_places.h"
#include "core/skeleton/measures.h"
#include "core/surface/season/foliage_on_day.h"
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

/// What is said of one skeleton, or of several together.
struct SkeletonFacts
{
    std::int64_t branches = 0, terminals = 0, maxChildren = 0;
    double totalLength = 0.0, sumA1 = 0.0;
    glm::dvec3 sumTip{0.0};
    Box box;
};

struct TreeFacts
{
    std::string name;
    std::int64_t symbols = 0;
    SkeletonFacts full, simplified;
    std::int64_t leaves = 0, shed = 0; ///< shed: by the season; below 0: there would be too many leaves
    LayerCount layer;
    QJsonArray editList;
    QJsonArray axes;                      ///< where they were asked for
    std::optional<TreeMeasures> measures; ///< of one tree
    std::optional<LeafMeasures> crown;    ///< of one tree whose leaves are those of a plant
};

SkeletonFacts factsOf(const Skeleton& skeleton)
{
    const SkeletonStats stats = skeletonStats(skeleton);
    SkeletonFacts out{
        stats.branches, stats.terminals, stats.maxChildren, stats.totalLength, stats.sumA1, stats.sumTip, {}};
    out.box.add(stats.min);
    out.box.add(stats.max);
    return out;
}

/// \param world puts the box of \p more where it stands.
void add(SkeletonFacts& sum, const SkeletonFacts& more, const glm::dmat4& world)
{
    sum.branches += more.branches;
    sum.terminals += more.terminals;
    sum.maxChildren = std::max(sum.maxChildren, more.maxChildren);
    sum.totalLength += more.totalLength;
    sum.sumA1 += more.sumA1;
    sum.sumTip += glm::dvec3(world * glm::dvec4(more.sumTip, static_cast<double>(more.branches)));
    sum.box.add(more.box.transformed(world));
}

QJsonArray jsonVector(const glm::dvec3& v)
{
    // A negative zero would be printed as such.
    return {v.x + 0.0, v.y + 0.0, v.z + 0.0};
}

QJsonObject jsonFacts(const SkeletonFacts& facts)
{
    return {{QStringLiteral("branches"), qint64(facts.branches)},
            {QStringLiteral("terminals"), qint64(facts.terminals)},
            {QStringLiteral("maxChildren"), qint64(facts.maxChildren)},
            {QStringLiteral("totalLength"), facts.totalLength},
            {QStringLiteral("sumA1"), facts.sumA1},
            {QStringLiteral("sumRadius"), facts.sumA1},
            {QStringLiteral("sumTip"), jsonVector(facts.sumTip)},
            {QStringLiteral("min"), jsonVector(facts.box.min)},
            {QStringLiteral("max"), jsonVector(facts.box.max)}};
}

QJsonObject jsonTree(const TreeFacts& tree)
{
    QJsonObject out = jsonFacts(tree.full);
    out.insert(QStringLiteral("symbols"), qint64(tree.symbols));
    out.insert(QStringLiteral("simplified"), jsonFacts(tree.simplified));
    if (tree.leaves >= 0) {
        out.insert(QStringLiteral("leaves"), qint64(tree.leaves));
        out.insert(QStringLiteral("shed"), qint64(tree.shed));
    }
    QJsonObject edits{{QStringLiteral("placed"), qint64(tree.layer.placed)},
                      {QStringLiteral("matched"), qint64(tree.layer.matched)},
                      {QStringLiteral("unplaced"), qint64(tree.layer.unplaced)}};
    if (!tree.editList.isEmpty())
        edits.insert(QStringLiteral("list"), tree.editList);
    out.insert(QStringLiteral("edits"), edits);
    if (!tree.axes.isEmpty())
        out.insert(QStringLiteral("axes"), tree.axes);
    if (tree.measures)
        out.insert(QStringLiteral("measures"), jsonMeasures(*tree.measures));
    if (tree.crown)
        insertLeaves(out, *tree.crown);
    return out;
}

/// The edits of a tree in their order, and what became of them.
QJsonArray jsonEdits(const std::vector<TreeEdit>& edits, const EditReport* report)
{
    QJsonArray list;
    for (std::size_t i = 0; report && i < report->size(); ++i) {
        const EditOutcome& outcome = (*report)[i];
        QJsonObject entry{{QStringLiteral("id"), json::branchKey(outcome.id)},
                          {QStringLiteral("op"), QLatin1String(infoOf(edits[i].operation).key)},
                          {QStringLiteral("state"), QLatin1String(stateName(outcome.state))}};
        if (!edits[i].name.empty())
            entry.insert(QStringLiteral("name"), fromText(edits[i].name));
        if (outcome.address != 0)
            entry.insert(QStringLiteral("target"), json::branchKey(outcome.address));
        if (const std::string why = outcome.why.plain(); !why.empty())
            entry.insert(QStringLiteral("why"), fromText(why));
        list.append(entry);
    }
    return list;
}

QJsonArray jsonAxes(const Skeleton& skeleton)
{
    QJsonArray list;
    const TreeAxes tree = axesOf(skeleton);
    for (const Axis& axis : tree.axes)
        list.append(QJsonObject{
            {QStringLiteral("id"), json::branchKey(axis.address)},
            {QStringLiteral("parent"), axis.parent == noIndex
                                           ? QJsonValue()
                                           : QJsonValue(json::branchKey(tree.axes[axis.parent].address))},
            {QStringLiteral("order"), qint64(axis.order)},
            {QStringLiteral("s"), axis.s},
            {QStringLiteral("length"), axis.length},
            {QStringLiteral("radius"), axis.radius},
            {QStringLiteral("downAngle"), axis.downAngle},
            {QStringLiteral("azimuth"), axis.azimuth}});
    return list;
}

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

/// At rest, but with the parameters of the time.
Expected<std::vector<TreeFacts>> factsOfTrees(EvaluatedScene& scene, const std::vector<const Node*>& trees,
                                              bool axes)
{
    TreePipeline pipeline;
    std::vector<TreeFacts> out;
    for (const Node* node : trees) {
        Node now = *node;
        now.params = scene.params(*node);
        const auto result = evaluateTree(pipeline, now, trees.size() > 1, Stage::Simplified);
        RAMURE_TRY(result);
        const Skeleton& simplified = result->simplified->skeleton;
        const auto foliage = foliageOf(simplified, now.params);
        out.push_back({node->name, std::int64_t(result->symbols->size()), factsOf(*result->skeleton),
                       factsOf(simplified), foliage ? std::int64_t(leafCount(*foliage)) : -1,
                       foliage ? std::int64_t(foliage->shed) : 0,
                       result->edits ? countLayer(*result->edits) : LayerCount(),
                       jsonEdits(now.params.edits, result->edits.get()),
                       axes ? jsonAxes(*result->skeleton) : QJsonArray(), measuresOf(*result->skeleton),
                       std::nullopt});
        if (foliage && foliage->form.shape != LeafShape::Faithful)
            out.back().crown =
                leafMeasures(*foliage, trunkRadius(now.params), out.back().measures->crownWidth);
    }
    return out;
}

QJsonArray jsonMatrix(const glm::dmat4& matrix)
{
    QJsonArray rows;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            rows.append(matrix[column][row] + 0.0);
    return rows;
}

/// What is known of an arm, a terrain, a primitive or an imported mesh. Errors: those of
/// EvaluatedScene::solid.
Expected<void> addShapeFacts(QJsonObject& entry, const Node& node, EvaluatedScene& scene)
{
    const auto mesh = scene.solid(node);
    RAMURE_TRY(mesh);
    if (node.kind == NodeKind::Arm) {
        const ArmChain chain(scene.params(node).joints);
        entry.insert(QStringLiteral("joints"), qint64(chain.jointCount()));
        entry.insert(QStringLiteral("reach"), chain.reach());
        entry.insert(QStringLiteral("tip"), jsonVector(chain.tip()));
    }
    entry.insert(QStringLiteral("vertices"), qint64(*mesh ? (*mesh)->vertexCount() : 0));
    entry.insert(QStringLiteral("faces"), qint64(*mesh ? (*mesh)->faceCount() : 0));
    return {};
}

/// Every node with its place at a time.
Expected<QJsonArray> jsonNodes(EvaluatedScene& now)
{
    QJsonArray list;
    const std::vector<NodeTransforms>& transforms = now.transforms();
    for (std::size_t i = 0; i < transforms.size(); ++i) {
        const Node& node = now.scene().nodes()[i];
        QJsonObject entry{{QStringLiteral("id"), qint64{node.id}},
                          {QStringLiteral("name"), fromText(node.name)},
                          {QStringLiteral("kind"), json::kindName(node)},
                          {QStringLiteral("world"), jsonMatrix(transforms[i].world)}};
        if (node.parent != noNode)
            entry.insert(QStringLiteral("parent"), qint64{node.parent});
        if (!node.preset.empty())
            entry.insert(QStringLiteral("preset"), fromText(node.preset));
        if (node.kind != NodeKind::Group)
            entry.insert(QStringLiteral("geometry"), jsonMatrix(transforms[i].geometry));
        if (isShape(node.kind))
            RAMURE_TRY(addShapeFacts(entry, node, now));
        list.append(entry);
    }
    return list;
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

/// One tree, or the sum of several with each of them.
QJsonObject jsonTrees(const TreeFacts& sum, const std::vector<TreeFacts>& trees)
{
    if (trees.size() == 1)
        return jsonTree(trees.front());
    QJsonObject all = jsonTree(sum);
    QJsonArray list;
    for (const TreeFacts& tree : trees) {
        QJsonObject entry = jsonTree(tree);
        entry.insert(QStringLiteral("name"), fromText(tree.name));
        list.append(entry);
    }
    all.insert(QStringLiteral("trees"), list);
    return all;
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
    if (auto posed = now.poseArms(); !posed)
        return posed;
    const Scene& scene = now.scene();
    const auto nodes = treesOrShapes(scene);
    RAMURE_TRY(nodes);
    const auto trees = factsOfTrees(now, *nodes, axes);
    RAMURE_TRY(trees);
    TreeFacts sum;
    for (std::size_t i = 0; i < trees->size(); ++i) {
        const TreeFacts& tree = (*trees)[i];
        const glm::dmat4 world = now.transforms((*nodes)[i]->id).geometry;
        sum.symbols += tree.symbols;
        sum.layer.placed += tree.layer.placed;
        sum.layer.matched += tree.layer.matched;
        sum.layer.unplaced += tree.layer.unplaced;
        add(sum.full, tree.full, world);
        add(sum.simplified, tree.simplified, world);
        sum.leaves += std::max<std::int64_t>(tree.leaves, 0);
        sum.shed += tree.shed;
    }
    if (!json)
        return print((trees->empty() ? QString() : textOfTrees(sum, *trees)) + objectsText(scene) +
                     verdictRow(checked));
    QJsonObject all = trees->empty() ? QJsonObject() : jsonTrees(sum, *trees);
    const auto list = jsonNodes(now);
    RAMURE_TRY(list);
    all.insert(QStringLiteral("nodes"), *list);
    if (const QJsonArray pictures = jsonPictures(scene); !pictures.isEmpty())
        all.insert(QStringLiteral("badPictures"), pictures);
    if (const QJsonArray warnings = jsonWarnings(scene); !warnings.isEmpty())
        all.insert(QStringLiteral("warnings"), warnings);
    addVerdict(all, checked);
    return printJson(all);
}

Box boxOf(const TriangleMesh& mesh)
{
    Box out;
    for (const glm::vec3& p : mesh.positions)
        out.add(glm::dvec3(p));
    return out;
}

Expected<void> showMesh(const ReadMesh& mesh, const Checked& checked, bool json)
{
    Box all;
    QJsonArray objects;
    QString lines;
    for (const ReadObject& object : mesh.objects) {
        const Box box = boxOf(object.mesh);
        all.add(box);
        objects.append(QJsonObject{{QStringLiteral("name"), fromText(object.name)},
                                   {QStringLiteral("vertices"), qint64(object.mesh.vertexCount())},
                                   {QStringLiteral("faces"), qint64(object.mesh.faceCount())},
                                   {QStringLiteral("min"), jsonVector(box.min)},
                                   {QStringLiteral("max"), jsonVector(box.max)}});
        lines += row("object", fromText(object.name),
                     QStringLiteral("%1 vertices, %2 faces")
                         .arg(object.mesh.vertexCount())
                         .arg(object.mesh.faceCount()));
    }
    const TriangleMesh joined = mesh.joined();
    QJsonArray notes;
    for (const std::string& note : mesh.notes) {
        notes.append(fromText(note));
        lines += row("note", fromText(note));
    }
    if (json) {
        QJsonObject out{{QStringLiteral("vertices"), qint64(joined.vertexCount())},
                        {QStringLiteral("faces"), qint64(joined.faceCount())},
                        {QStringLiteral("min"), jsonVector(all.min)},
                        {QStringLiteral("max"), jsonVector(all.max)},
                        {QStringLiteral("objects"), objects},
                        {QStringLiteral("notes"), notes}};
        addVerdict(out, checked);
        return printJson(out);
    }
    return print(row("vertices", QString::number(joined.vertexCount())) +
                 row("faces", QString::number(joined.faceCount())) + row("min", vectorText(all.min)) +
                 row("max", vectorText(all.max)) + verdictRow(checked) + lines);
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
