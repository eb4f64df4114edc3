#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/surface/foliage/bark_place.h"
#include "core/surface/foliage/place_foliage.h"
#include "tests/support/suite.h"
#include <algorithm>

namespace tst_feet_on_bark {

using namespace ramure;

namespace {

struct Dress
{
    const char* name;
    LeafShape leaf;
    FruitKind fruit;
};
constexpr Dress dresses[] = {
    {"birch", LeafShape::Birch, FruitKind::Blossom}, {"oak", LeafShape::Oak, FruitKind::Acorn},
    {"pine", LeafShape::ScotsPine, FruitKind::Cone}, {"maple", LeafShape::Maple, FruitKind::Berries},
    {"palm", LeafShape::Palm, FruitKind::Coconut},   {"apple", LeafShape::Apple, FruitKind::Apple},
};

NodeParams dressed(const char* preset, const Dress& dress)
{
    NodeParams params = presetParams(preset).value_or(NodeParams{});
    params.leaf.shape = dress.leaf;
    params.fruit.kind = dress.fruit;
    params.foliage.applesProbability = 0.3;
    return params;
}

glm::dvec3 footOf(const FoliageItem& item, double reach)
{
    return item.position + item.orientation * glm::dvec3(0.0, reach * double(item.size), 0.0);
}

/// From the bark of its branch, in radii of the branch's thinner end; of one without bark 0.
double distance(const TreeResult& tree, const FoliageItem& item, const glm::dvec3& foot)
{
    const Skeleton& skeleton = tree.simplified->skeleton;
    static std::shared_ptr<const BranchMesh> known;
    static std::vector<std::span<const glm::uvec3>> tubes;
    if (known != tree.branches)
        tubes = trianglesOfTubes(*tree.branches, skeleton.size());
    known = tree.branches;
    if (tubes[item.branch].empty())
        return 0.0;
    const BarkPlace place = nearestOnBark(tree.branches->mesh, tubes[item.branch], foot);
    glm::dvec3 on(0.0);
    for (int k = 0; k < 3; ++k)
        on += place.shares[k] * glm::dvec3(tree.branches->mesh.positions[place.triangle[k]]);
    return glm::distance(on, foot) / std::min(skeleton.a0[item.branch], skeleton.a1[item.branch]);
}

} // namespace

class TestFeetOnBark : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void feetLieOnTheBark_data()
    {
        QTest::addColumn<QByteArray>("preset");
        QTest::addColumn<int>("dress");
        for (const char* preset : {"SmallTree", "FanTree", "TinyTree", "Fern2D"})
            for (std::size_t i = 0; i < std::size(dresses); ++i)
                QTest::addRow("%s %s", preset, dresses[i].name) << QByteArray(preset) << int(i);
    }
    void feetLieOnTheBark()
    {
        QFETCH(QByteArray, preset);
        QFETCH(int, dress);
        const NodeParams params = dressed(preset.constData(), dresses[std::size_t(dress)]);
        const auto tree = TreePipeline().evaluate(params);
        QVERIFY2(tree, test::why(tree));
        const FruitForm& fruit = tree->foliage->fruit;
        const double reach = fruitRadius(fruit, params.turtle.alpha) * fruitReach(fruit);
        double most = 0.0;
        for (const FoliageItem& leaf : tree->foliage->leaves)
            most = std::max(most, distance(*tree, leaf, leaf.position));
        for (const FoliageItem& apple : tree->foliage->apples)
            most = std::max(most, distance(*tree, apple, footOf(apple, reach)));
        QVERIFY(!tree->foliage->leaves.empty());
        QVERIFY2(most < 0.01, qPrintable(QString::number(most)));
    }

    void feetKeepTheirDirection()
    {
        const NodeParams params = dressed("TinyTree", dresses[1]);
        const auto tree = TreePipeline().evaluate(params);
        QVERIFY(tree);
        const auto placed = placeFoliage(tree->simplified->skeleton, params.foliage, params.leaf,
                                         params.fruit, params.turtle.alpha);
        QVERIFY(placed && placed->leaves.size() == tree->foliage->leaves.size());
        for (std::size_t i = 0; i < placed->leaves.size(); ++i)
            QVERIFY(placed->leaves[i].orientation == tree->foliage->leaves[i].orientation);
    }

    void faithfulLeavesStayWhereTheyAre()
    {
        NodeParams params = dressed("TinyTree", dresses[0]);
        params.leaf.shape = LeafShape::Faithful;
        params.fruit.kind = FruitKind::Faithful;
        const auto tree = TreePipeline().evaluate(params);
        const auto placed = placeFoliage(tree->simplified->skeleton, params.foliage, params.turtle.alpha);
        QVERIFY(tree && placed);
        QCOMPARE(*tree->leaves,
                 buildLeaves(tree->simplified->skeleton, *placed, params.turtle.alpha, FoliageModel::Fine));
        QCOMPARE(*tree->apples,
                 buildApples(tree->simplified->skeleton, *placed, params.turtle.alpha, FoliageModel::Fine));
    }

    /// A draft has no bark to stand on: what it made is not taken for the foliage of the full tree.
    void draftsAreNotMistakenForTheFullTree()
    {
        const NodeParams params = dressed("TinyTree", dresses[0]);
        TreePipeline pipeline;
        const auto draft = pipeline.evaluateDraft(params), full = pipeline.evaluate(params);
        const auto alone = TreePipeline().evaluate(params);
        QVERIFY(draft && full && alone && !draft->branches);
        QCOMPARE(*full->leaves, *alone->leaves);
        QVERIFY(!(*full->leaves == *draft->leaves));
        // Another mesh, other feet.
        NodeParams coarse = params;
        coarse.sections.radialDivisions = 4;
        const auto other = pipeline.evaluate(coarse), again = TreePipeline().evaluate(coarse);
        QVERIFY(other && again);
        QCOMPARE(*other->leaves, *again->leaves);
        QVERIFY(!(*other->leaves == *full->leaves));
    }
};

RAMURE_SUITE(TestFeetOnBark)

} // namespace tst_feet_on_bark

#include "tst_feet_on_bark.moc"
