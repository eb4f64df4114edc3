#include "core/evaluate/tree_run.h"
#include "tests/support/mesh_checker.h"
#include "tests/support/shaped_tree.h"

#include <QElapsedTimer>
#include <cmath>

namespace tst_random_edits {

using namespace ramure;
using namespace ramure::test;

namespace {

/// A tree of a preset, small enough that a mesh is made after each edit.
NodeParams smallTree(const QByteArray& preset)
{
    NodeParams params = *presetParams(preset.constData());
    params.mesh.targetTriangles = 0;
    params.sections.lengthDivisions = 2;
    params.sections.radialDivisions = 5;
    const auto branches = [&params] { return grownTree(params).simplified->skeleton.size(); };
    while (params.generator.kind == EditOperation::Grammar && params.grammar.iterations > 2 &&
           branches() > 600)
        --params.grammar.iterations;
    if (params.generator.kind == EditOperation::WeberPenn)
        params.weberPenn.levels = 2;
    if (params.generator.kind == EditOperation::Colonisation)
        params.colonisation.points = 300;
    return params;
}

bool isFinite(const TriangleMesh& mesh)
{
    return std::ranges::all_of(mesh.positions, [](const glm::vec3& p) {
        return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    });
}

} // namespace

/// Whatever hands do to a tree, its mesh is whole.
class TestRandomEdits : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void everyMeshIsWhole_data();
    void everyMeshIsWhole();
    void editedTreesMove_data() { addTrees(); }
    void editedTreesMove();
    void theSameEditsGiveTheSameBytes();
    void aStrokeOfTheBrushIsOneEdit();

private:
    static void addTrees();
};

void TestRandomEdits::addTrees()
{
    QTest::addColumn<QByteArray>("preset");
    for (const char* preset : {"SmallTree", "FanTree", "TernaryTree", "QuakingAspen", "Ginkgo1995"})
        QTest::newRow(preset) << QByteArray(preset);
}

void TestRandomEdits::everyMeshIsWhole_data()
{
    QTest::addColumn<QByteArray>("preset");
    QTest::addColumn<int>("edits");
    // RAMURE_EDITS asks for so many times as many.
    const int times = std::max(1, qEnvironmentVariableIntValue("RAMURE_EDITS"));
    for (const Preset& preset : courseworkPresets())
        QTest::newRow(preset.name) << QByteArray(preset.name) << 300 * times;
    for (const char* preset : {"HondaTree", "QuakingAspen", "WeepingWillow1995", "CaliforniaBlackOak",
                               "Ginkgo1995", "NorwaySpruce1995", "UmbrellaAcacia"})
        QTest::newRow(preset) << QByteArray(preset) << 120 * times;
}

void TestRandomEdits::everyMeshIsWhole()
{
    QFETCH(QByteArray, preset);
    QFETCH(int, edits);
    const NodeParams plain = smallTree(preset);
    TreePipeline pipeline;
    Random random(20251, RandomStream::Test, static_cast<std::uint64_t>(preset.size()));
    NodeParams params = plain;
    int made = 0, refused = 0;
    while (made < edits) {
        if (made % 25 == 0)
            params = plain;
        const auto before = pipeline.evaluate(params, Stage::Skeleton);
        QVERIFY2(before, why(before).constData());
        const TreeEdit edit = randomEdit(axesOf(*before->skeleton), *before->skeleton, random);
        EditContext context(*before->grown, params.edits);
        if (!make(params, edit, context)) {
            QVERIFY(++refused < 20 * edits);
            continue;
        }
        ++made;
        QVERIFY(params.edits.back().id != 0);
        const auto tree = pipeline.evaluate(params, Stage::Mesh);
        QVERIFY2(tree, why(tree).constData());
        QVERIFY2(tree->report->valid, infoOf(edit.operation).key);
        QCOMPARE(tree->report->components, tree->branches->roots);
        QCOMPARE(tree->report->eulerCharacteristic, 2 * std::int64_t{tree->branches->roots});
        if (made % 20 == 0) {
            const CheckedMesh checked = checkMesh(tree->branches->mesh);
            QVERIFY2(checked.perfect(tree->branches->roots), infoOf(edit.operation).key);
        }
        for (const EditOutcome& outcome : *tree->edits)
            QVERIFY(outcome.state == EditState::ByAddress);
        // A hand goes on from the result and makes no edit of it again.
        QVERIFY(tree->edited->upTo(params.edits)->skeleton() == *tree->skeleton);
        QVERIFY(!tree->edited->upTo(std::span(params.edits).subspan(1)));
        if (before->edited)
            QVERIFY(before->edited->upTo(params.edits)->skeleton() == *tree->skeleton);
    }
}

void TestRandomEdits::editedTreesMove()
{
    QFETCH(QByteArray, preset);
    NodeParams params = smallTree(preset);
    Random random(7, RandomStream::Test);
    for (int made = 0; made < 12;) {
        const TreeResult before = grownTree(params, Stage::Skeleton);
        made += make(params, randomEdit(axesOf(*before.skeleton), *before.skeleton, random)) ? 1 : 0;
    }
    const TreeResult tree = grownTree(params, Stage::Foliage);
    QVERIFY(isFinite(*tree.leaves) && isFinite(*tree.apples));
    TreeRun run;
    const auto set = run.setTree(tree, params);
    QVERIFY2(set, why(set).constData());
    run.setPhysics(params.physics, {}, 0.0);
    const auto motion = run.motionAt(0.5, {}, {});
    QVERIFY2(motion, why(motion).constData());
    const auto moved = movedTree(tree, *motion, {});
    QVERIFY2(moved, why(moved).constData());
    QVERIFY(isFinite(moved->branches->mesh));
    QCOMPARE(moved->skeleton->size(), tree.skeleton->size());
}

void TestRandomEdits::theSameEditsGiveTheSameBytes()
{
    NodeParams params = smallTree("SmallTree");
    Random random(3, RandomStream::Test);
    std::vector<Skeleton> steps;
    EditContext growing(*grownTree(params, Stage::Skeleton).grown, {});
    while (params.edits.size() < 60) {
        const Skeleton now = growing.skeleton();
        if (make(params, randomEdit(axesOf(now), now, random), growing))
            steps.push_back(growing.skeleton());
    }
    // One at a time as all at once, and again.
    while (!params.edits.empty()) {
        const TreeResult tree = grownTree(params, Stage::Skeleton);
        QVERIFY(*tree.skeleton == steps.back());
        steps.pop_back();
        params.edits.pop_back();
    }
}

/// The same as its places one by one; those out of reach do not count.
void TestRandomEdits::aStrokeOfTheBrushIsOneEdit()
{
    TreeEdit touch = editOf(EditOperation::Comb, 0);
    touch.centre = {0.0, 4.0, 0.0};
    touch.radius = 3.0;
    touch.strength = 1.0;
    touch.direction = {1.0, 0.0, 0.0};
    TreeEdit stroke = touch;
    stroke.points = {{{0.5, 3.5, 0.0}, 2.5}, {{400.0, 3.0, 0.0}, 0.0}, {{400.0, 3.0, 0.0}, 0.0}};
    Shaped one, many;
    QVERIFY(one.make(stroke));
    QVERIFY(many.make(touch));
    touch.direction = glm::dvec3(0.5, 3.5, 0.0) - touch.centre;
    touch.centre = {0.5, 3.5, 0.0};
    touch.radius = 2.5;
    QVERIFY(many.make(touch));
    for (const std::uint64_t address : one.address)
        QVERIFY(one.tip(address) == many.tip(address));
    stroke.points.front().radius = -1.0;
    QVERIFY(!checkTreeEdit(stroke));
}

RAMURE_SUITE(TestRandomEdits)

} // namespace tst_random_edits

#include "tst_random_edits.moc"
