#include "core/lod/leaf_clusters.h"
#include "core/lod/level_leaves.h"
#include "core/lod/level_skins.h"
#include "core/lod/tree_levels.h"
#include "core/math/principal_axes.h"
#include "core/presets/presets.h"
#include "core/surface/proof/validate.h"
#include "tests/support/shaped_tree.h"
#include <algorithm>
#include <cmath>
#include <map>

namespace tst_tree_levels {

using namespace ramure;

namespace {

const std::vector<std::int64_t> game{10'000, 2'500, 600};

TreeResult treeOf(const NodeParams& params, Stage last = Stage::Simplified)
{
    TreePipeline pipeline;
    auto tree = pipeline.evaluate(params, last);
    if (!tree)
        qFatal("%s", test::why(tree).constData());
    return std::move(*tree);
}

NodeParams preset(const char* name)
{
    const auto params = presetParams(name);
    if (!params)
        qFatal("%s is gone", name);
    return *params;
}

Expected<std::vector<TreeLevel>> levelsOf(const NodeParams& params, const LevelOptions& options,
                                          const LevelParts& parts = {}, const Progress& progress = {})
{
    return treeLevels(treeOf(params, stageOfLevels(options)), params, options, parts, progress);
}

std::vector<TreeLevel> made(const NodeParams& params, const LevelOptions& options,
                            const LevelParts& parts = {})
{
    auto levels = levelsOf(params, options, parts);
    if (!levels)
        qFatal("%s", test::why(levels).constData());
    return std::move(*levels);
}

bool isWithin(double value, double wanted, double slack)
{
    return std::abs(value - wanted) <= slack * wanted;
}

void presetRows()
{
    QTest::addColumn<QString>("name");
    for (const char* name :
         {"SmallTree", "FanTree", "EnglishOak1995", "SilverBirch1995", "WeepingWillow1995", "ScotsPine1995",
          "CommonAsh1995", "OrchardApple1995", "WinterOak", "CoconutPalmRules"})
        QTest::newRow(name) << QString::fromLatin1(name);
}

} // namespace

class TestTreeLevels : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnAnyWarning(); }

    void whatIsRefused_data()
    {
        QTest::addColumn<qint64>("count");
        QTest::addColumn<QList<qint64>>("budgets");
        QTest::addColumn<QString>("about");
        QTest::newRow("none") << qint64(0) << QList<qint64>() << "1 to 8";
        QTest::newRow("less than none") << qint64(-1) << QList<qint64>() << "1 to 8";
        QTest::newRow("too many") << qint64(9) << QList<qint64>() << "1 to 8";
        QTest::newRow("budget of 0") << qint64(1) << QList<qint64>{0} << "the least, 50";
        QTest::newRow("too many triangles") << qint64(1) << QList<qint64>{90'000'000} << "the most, 20000000";
        QTest::newRow("negative") << qint64(2) << QList<qint64>{1000, -1} << "level 1";
        QTest::newRow("rising") << qint64(2) << QList<qint64>{1000, 2000} << "must fall";
        QTest::newRow("equal") << qint64(2) << QList<qint64>{1000, 1000} << "must fall";
        QTest::newRow("too few") << qint64(3) << QList<qint64>{1000, 500} << "as many budgets, not 2";
    }
    void whatIsRefused()
    {
        QFETCH(qint64, count);
        QFETCH(QList<qint64>, budgets);
        QFETCH(QString, about);
        const LevelOptions options{count, {budgets.begin(), budgets.end()}};
        const auto levels = levelsOf(preset("TinyTree"), options);
        QVERIFY(!levels);
        QCOMPARE(levels.error().code, ErrorCode::Invalid);
        QVERIFY2(QString::fromStdString(levels.error().message()).contains(about), test::why(levels));
    }

    /// Too few even for the roots.
    void budgetsThatNoMeshKeeps()
    {
        NodeParams yew = preset("CommonYew1995");
        yew.mesh.roots = 0; // for which the first pieces of its trunk would become one
        const auto few = levelsOf(yew, {1, {leastBudget}}, {true, false, false, false});
        QVERIFY(!few);
        QCOMPARE(few.error().code, ErrorCode::Limit);
        QVERIFY2(few.error().message().find("the nearest has") != std::string::npos, test::why(few));
    }

    void stopsWhenAsked()
    {
        std::stop_source stop;
        stop.request_stop();
        const TreeResult tree = treeOf(preset("SmallTree"));
        const auto levels = treeLevels(tree, preset("SmallTree"), {3, game}, {}, {stop.get_token(), {}});
        QVERIFY(!levels);
        QCOMPARE(levels.error().code, ErrorCode::Cancelled);
    }

    /// Of the area of all, facing where it did, along them; leaves all in one place do not make the crown
    /// reach further.
    void aLeafStandsForItsCluster()
    {
        LeafForm form;
        form.shape = LeafShape::Birch;
        const auto shapes = leafShapesOfLevels(form, {}, 0.1);
        const LeafShapeOfLevel &whole = shapes.front(), &shape = shapes.back();
        const glm::dmat3 axes = principalAxes(shape.spread);
        std::vector<FoliageItem> items(5);
        for (std::size_t i = 0; i < items.size(); ++i)
            items[i].position = 0.3 * double(i) * glm::normalize(axes[0] + 2.0 * axes[1] + axes[2]);
        const LeafCluster all{2, {0, 1, 2, 3, 4}}, one{3, {3}};
        const glm::dvec3 middle = items[2].position + whole.middle;
        const auto middleOf = [&](const FoliageItem& leaf) {
            return leaf.position + leaf.orientation * (double(leaf.size) * shape.middle);
        };
        const FoliageItem longer = leafOfCluster(items, all, whole, shape, middle - axes[2]);
        QVERIFY(isWithin(double(longer.size) * double(longer.size) * shape.area, 5.0 * whole.area, 1e-5));
        QVERIFY(glm::distance(middleOf(longer), middle) < 1e-6);
        QVERIFY(glm::dot(longer.orientation * axes[2], axes[2]) > 1.0 - 1e-9);
        QVERIFY(glm::dot(longer.orientation * axes[0], glm::normalize(axes[0] + 2.0 * axes[1])) > 0.99);
        QVERIFY(isWithin(extentOf(items, std::vector{all}, whole), 2.0 * 0.3 * std::sqrt(2.0), 0.05));
        QVERIFY(leafOfCluster(items, one, whole, shape, {}).position == items[3].position);
        for (FoliageItem& item : items)
            item.position = {};
        const FoliageItem inner = leafOfCluster(items, all, whole, shape, whole.middle - axes[0]);
        const double further = (std::sqrt(5.0 * whole.area / shape.area) - 1.0) *
                               std::sqrt(3.0 * glm::dot(axes[0], shape.spread * axes[0]));
        QVERIFY(isWithin(glm::dot(whole.middle - middleOf(inner), axes[0]), further, 0.2));
    }

    /// Nothing of a bare trunk goes but sides, and those are a difference, too.
    void sidesAloneAreDetail()
    {
        const auto levels = made(preset("DeadSnag"), {3, {}});
        QCOMPARE(levels.size(), std::size_t{3});
        QVERIFY(levels[0].detail == 0.0 && levels[1].detail > 0.0);
        QVERIFY(levels[2].detail > levels[1].detail && levels[2].detail < 0.5);
    }

    void keepBudgetAreaAndProof_data() { presetRows(); }
    void keepBudgetAreaAndProof()
    {
        QFETCH(QString, name);
        const auto levels = made(preset(name.toLatin1()), {3, game});
        QCOMPARE(levels.size(), game.size());
        for (std::size_t i = 0; i < levels.size(); ++i) {
            const TreeLevel& level = levels[i];
            QVERIFY2(isWithin(double(level.triangles()), double(game[i]), levelSlack),
                     QByteArray::number(level.triangles()));
            const auto report = validateMesh(*level.bark);
            QVERIFY(report && report->valid);
            QCOMPARE(level.bark->uvTriangles.size(), level.bark->triangles.size());
            QCOMPARE(bool(level.leaves), bool(levels[0].leaves));
            if (level.leaves) {
                QVERIFY2(isWithin(areaOf(*level.leaves), levels[0].leafArea, levelSlack),
                         QByteArray::number(level.leafArea));
                QCOMPARE(level.leaves->uv.size(), level.leaves->positions.size());
            }
            if (i > 0)
                QVERIFY(level.detail > 0.0);
        }
    }

    /// Whatever a level has, the one before it has: nothing comes back on the way off.
    void levelsAreNested_data() { presetRows(); }
    void levelsAreNested()
    {
        QFETCH(QString, name);
        const auto levels = made(preset(name.toLatin1()), {3, game});
        for (std::size_t i = 1; i < levels.size(); ++i) {
            QVERIFY(std::ranges::includes(levels[i - 1].leafOf, levels[i].leafOf));
            QVERIFY(std::ranges::includes(levels[i - 1].appleOf, levels[i].appleOf));
            const std::vector<Index>&fine = levels[i - 1].wood.branchOf, &coarse = levels[i].wood.branchOf;
            for (std::size_t b = 0; b < fine.size(); ++b)
                QVERIFY(coarse[b] == noIndex || fine[b] != noIndex);
        }
    }

    /// Without budgets the first level is the tree itself, triangle by triangle.
    void firstLevelIsTheTree()
    {
        const NodeParams params = preset("SmallTree");
        const TreeResult tree = treeOf(params, Stage::Foliage);
        const auto levels = treeLevels(tree, params, {3, {}});
        QVERIFY2(levels, test::why(levels));
        QCOMPARE(levels->front().bark->positions, tree.branches->mesh.positions);
        QCOMPARE(levels->front().bark->triangles, tree.branches->mesh.triangles);
        QCOMPARE(levels->front().bark->branch, tree.branches->mesh.branch);
        QCOMPARE(levels->front().leaves->positions, tree.leaves->positions);
        for (std::size_t i = 1; i < 3; ++i)
            QVERIFY(isWithin(double((*levels)[i].triangles()), 0.25 * double((*levels)[i - 1].triangles()),
                             levelSlack));
    }

    /// An oak's leaves become so simple that a quarter of its triangles would make the bark finer than its
    /// own.
    void withoutBudgetsTheBarkGetsCoarserToo()
    {
        const auto levels = made(preset("EnglishOak1995"), {2, {}});
        for (std::size_t i = 1; i < levels.size(); ++i) {
            QVERIFY(levels[i].triangles() <= std::llround(0.26 * double(levels[i - 1].triangles())));
            QVERIFY(double(levels[i].bark->faceCount()) <= 0.6 * double(levels[i - 1].bark->faceCount()));
        }
    }
    void cutsShowTheirWood()
    {
        test::Shaped shaped;
        TreeEdit edit = test::editOf(EditOperation::Thickness, shaped.address[0]);
        edit.factor = 0.1;
        edit.below = true;
        QVERIFY(shaped.make(edit));
        edit = test::editOf(EditOperation::Cut, shaped.address[3]);
        edit.at = 0.5;
        QVERIFY(shaped.make(edit));
        shaped.params.sections = {16, 32}; // enough triangles for levels
        const TreeResult tree = shaped.tree(Stage::Foliage);
        const auto levels = treeLevels(tree, shaped.params, {2, {}});
        QVERIFY2(levels, test::why(levels));
        QVERIFY(levels->front().cuts && *levels->front().cuts == *tree.cuts);
        for (const TreeLevel& level : *levels) {
            QVERIFY(level.cuts && !level.cuts->empty());
            const Index stump = tree.simplified->skeleton.sawn.front();
            for (std::size_t v = 0; v < level.cuts->positions.size(); ++v) {
                QCOMPARE(level.cuts->branch[v], stump);
                const glm::dvec3 end = tree.simplified->skeleton.p1[stump];
                QVERIFY(glm::distance(glm::dvec3(level.cuts->positions[v]), end) <
                        tree.simplified->skeleton.a1[stump]);
            }
        }
        QVERIFY(!made(preset("TinyTree"), {2, {}}).back().cuts);
    }
    void sameBytesAgain()
    {
        const NodeParams params = preset("SilverBirch1995");
        const auto one = made(params, {3, game}), other = made(params, {3, game});
        for (std::size_t i = 0; i < one.size(); ++i) {
            QCOMPARE(*one[i].bark, *other[i].bark);
            QCOMPARE(*one[i].leaves, *other[i].leaves);
        }
        // A level does not depend on those that follow.
        QCOMPARE(*made(params, {1, {game[0]}})[0].bark, *one[0].bark);
    }

    /// The tiles of the bark are those of the first level: one map serves all.
    void tilesAreShared()
    {
        const auto levels = made(preset("EnglishOak1995"), {3, game});
        std::vector<double> perMetre;
        for (const TreeLevel& level : levels) {
            double place = 0.0, picture = 0.0;
            const TriangleMesh& bark = *level.bark;
            for (std::size_t t = 0; t < bark.triangles.size(); ++t) {
                if (bark.level[bark.triangles[t].x] != 0) // on twigs a tile is as small as they are thin
                    continue;
                const glm::dvec3 a(bark.positions[bark.triangles[t].x]),
                    b(bark.positions[bark.triangles[t].y]), c(bark.positions[bark.triangles[t].z]);
                const glm::dvec2 u(bark.uv[bark.uvTriangles[t].x]), v(bark.uv[bark.uvTriangles[t].y]),
                    w(bark.uv[bark.uvTriangles[t].z]);
                place += glm::length(glm::cross(b - a, c - a));
                picture += std::abs((v - u).x * (w - u).y - (v - u).y * (w - u).x);
            }
            perMetre.push_back(std::sqrt(picture / place));
        }
        for (const double density : perMetre)
            QVERIFY2(isWithin(density, perMetre.front(), 0.25), QByteArray::number(density));
    }

    void partsAlone()
    {
        const NodeParams params = preset("SmallTree");
        const auto wood = made(params, {2, {5000, 1000}}, {true, false, false, false});
        QVERIFY(!wood[0].leaves && !wood[0].apples && wood[0].bark->uv.empty());
        QVERIFY(isWithin(double(wood[1].bark->faceCount()), 1000.0, levelSlack));
        const auto leaves = made(params, {2, {5000, 1000}}, {false, true, false, true});
        QVERIFY(!leaves[0].bark && leaves[1].leaves);
        QVERIFY(isWithin(double(leaves[1].leaves->faceCount()), 1000.0, levelSlack));
    }

    /// At rest a skin moves nothing; every bone it names exists, and weights are whole.
    void skinsFollowTheTreesBones_data() { presetRows(); }
    void skinsFollowTheTreesBones()
    {
        QFETCH(QString, name);
        const NodeParams params = preset(name.toLatin1());
        const TreeResult tree = treeOf(params);
        const Skeleton& skeleton = tree.simplified->skeleton;
        const auto levels = treeLevels(tree, params, {2, {10'000, 2'500}});
        QVERIFY2(levels, test::why(levels));
        for (const TreeLevel& level : *levels) {
            const auto skins = bindLevel(level, skeleton, SkinMethod::Linear, noIndex);
            QVERIFY2(skins, test::why(skins));
            QCOMPARE(skins->bark->vertices, level.bark->vertexCount());
            for (const SkinRun& run : skins->bark->runs)
                for (const Index bone : run.influence.bone)
                    QVERIFY(bone < skeleton.size() && level.wood.branchOf[bone] != noIndex);
            const std::vector<RigidTransform> lifted(
                skeleton.size() + tree.simplified->skeleton.size(), // enough for fruit too
                {glm::dquat(1.0, 0.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.0)});
            const TriangleMesh moved = deformed(*level.bark, *skins->bark, lifted, SkinMethod::Linear);
            for (std::size_t v = 0; v < moved.positions.size(); ++v)
                QVERIFY(glm::distance(moved.positions[v],
                                      level.bark->positions[v] + glm::vec3(0.0F, 1.0F, 0.0F)) < 1e-4F);
        }
    }
};

RAMURE_SUITE(TestTreeLevels)

} // namespace tst_tree_levels

#include "tst_tree_levels.moc"
