#include "app/cli/scene_facts.h"

#include "core/params/source_facts.h"
#include "core/params/tree_edit_table.h"
#include "core/qt/document/project/project_json.h"
#include "core/rig/arm/arm_chain.h"
#include "core/scene/object_mesh.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/edit_places.h"
#include <algorithm>

namespace ramure::cli {

namespace {

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

} // namespace

Expected<SceneFacts> sceneFacts(EvaluatedScene& now, bool axes)
{
    if (auto posed = now.poseArms(); !posed)
        return fail(std::move(posed.error()));
    const auto nodes = treesOrShapes(now.scene());
    RAMURE_TRY(nodes);
    auto trees = factsOfTrees(now, *nodes, axes);
    RAMURE_TRY(trees);
    SceneFacts out{std::move(*trees), {}};
    TreeFacts& sum = out.sum;
    for (std::size_t i = 0; i < out.trees.size(); ++i) {
        const TreeFacts& tree = out.trees[i];
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
    return out;
}

Expected<QJsonObject> jsonOf(const SceneFacts& facts, EvaluatedScene& now)
{
    QJsonObject all = facts.trees.empty() ? QJsonObject() : jsonTrees(facts.sum, facts.trees);
    const auto list = jsonNodes(now);
    RAMURE_TRY(list);
    all.insert(QStringLiteral("nodes"), *list);
    if (const QJsonArray warnings = jsonWarnings(now.scene()); !warnings.isEmpty())
        all.insert(QStringLiteral("warnings"), warnings);
    return all;
}

QJsonObject jsonFacts(const ReadMesh& mesh)
{
    QJsonArray objects, notes;
    for (const ReadObject& object : mesh.objects) {
        const Box box = boxOf(object.mesh);
        objects.append(QJsonObject{{QStringLiteral("name"), fromText(object.name)},
                                   {QStringLiteral("vertices"), qint64(object.mesh.vertexCount())},
                                   {QStringLiteral("faces"), qint64(object.mesh.faceCount())},
                                   {QStringLiteral("min"), jsonVector(box.min)},
                                   {QStringLiteral("max"), jsonVector(box.max)}});
    }
    for (const std::string& note : mesh.notes)
        notes.append(fromText(note));
    const TriangleMesh joined = mesh.joined();
    const Box all = boxOf(joined);
    return {{QStringLiteral("vertices"), qint64(joined.vertexCount())},
            {QStringLiteral("faces"), qint64(joined.faceCount())},
            {QStringLiteral("min"), jsonVector(all.min)},
            {QStringLiteral("max"), jsonVector(all.max)},
            {QStringLiteral("objects"), objects},
            {QStringLiteral("notes"), notes}};
}

Box boxOf(const TriangleMesh& mesh)
{
    Box out;
    for (const glm::vec3& p : mesh.positions)
        out.add(glm::dvec3(p));
    return out;
}

} // namespace ramure::cli
