#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/print/leaf_sheets.h"
#include "core/print/print_tree.h"
#include "tests/core/io/io_support.h"

namespace tst_leaf_sheets {

using namespace ramure;

namespace {

/// A bough with a twig that is too thin to be printed, and a leaf at the end of each.
Skeleton bough()
{
    Skeleton out;
    const Index trunk = out.add(noIndex, {0, 0, 0}, {0, 4, 0}, 0.3, 0.2);
    out.add(trunk, {0, 4, 0}, {2, 5, 0}, 0.15, 0.1, 1);
    out.add(trunk, {0, 4, 0}, {-2, 5, 0}, 0.01, 0.005, 1);
    return out;
}

Foliage leavesAt(std::initializer_list<std::pair<Index, glm::dvec3>> places)
{
    Foliage out;
    out.form.shape = LeafShape::Oak;
    for (const auto& [branch, at] : places) {
        FoliageItem item;
        item.branch = branch;
        item.position = at;
        out.leaves.push_back(item);
    }
    return out;
}

constexpr double alpha = 1.0, thickness = 0.002;
constexpr LeafLimits limits{thickness, 1.0};

} // namespace

class TestLeafSheets : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void withoutLeavesThereAreNone()
    {
        const PrintSkeleton print = printSkeletonAt(bough(), 0.04, thickness);
        const LeafSheets none = leafSheets(leavesAt({}), bough(), print, alpha, limits);
        QVERIFY(none.mesh.empty() && none.leaves == 0 && none.leftOut == 0);
        Foliage flat = leavesAt({{1, {2, 5, 0}}});
        flat.form.width = 0.0;
        QCOMPARE(leafSheets(flat, bough(), print, alpha, limits).leftOut, Index(1));
    }
    void leavesOfCutTwigsComeOffUnlessTheyAreNear()
    {
        const PrintSkeleton print = printSkeletonAt(bough(), 0.04, thickness);
        QCOMPARE(print.numberOf[2], noIndex);
        const Foliage leaves = leavesAt({{1, {2, 5, 0}}, {2, {-2, 5, 0}}, {2, {-0.1, 4.1, 0}}});
        const LeafSheets made = leafSheets(leaves, bough(), print, alpha, limits);
        QCOMPARE(made.leaves, Index(2));
        QCOMPARE(made.leftOut, Index(1));
        QCOMPARE(made.enlargement, 1.0);
        for (const glm::vec3& p : made.mesh.positions)
            QVERIFY(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && p.x > -0.04F);
    }
    /// Ten times as large, a hundredth as many.
    void smallLeavesAreEnlargedAndFewer()
    {
        const PrintSkeleton print = printSkeletonAt(bough(), 0.04, thickness);
        Foliage many;
        many.form.shape = LeafShape::Oak;
        for (int i = 0; i < 2000; ++i) {
            FoliageItem item;
            item.branch = 1;
            item.position = {0.001 * i, 4.0 + 0.0005 * i, 0.0};
            many.leaves.push_back(item);
        }
        const LeafSheets made = leafSheets(many, bough(), print, 0.05, limits);
        QVERIFY(made.enlargement > 2.0);
        QVERIFY(std::abs(double(made.leaves) * made.enlargement * made.enlargement / 2000.0 - 1.0) < 0.1);
        QCOMPARE(made.leaves + made.leftOut, Index(2000));
        const LeafSheets again = leafSheets(many, bough(), print, 0.05, limits);
        QVERIFY(again.mesh == made.mesh);
        const LeafSheets few = leafSheets(many, bough(), print, 0.05, {thickness, 1e-4});
        QVERIFY(few.leaves > 0 && few.leaves < made.leaves);
    }
    void shellsAndTwigsAreOnePiece()
    {
        NodeParams params = *presetParams("TinyTree");
        const auto grown = TreePipeline().evaluate(params);
        QVERIFY2(grown, test::why(grown));
        PrintOptions options;
        options.process = PrintProcess::Resin;
        options.height = 0.06;
        const Skeleton& tree = grown->simplified->skeleton;
        const auto bare = printTree(tree, params, options, {}, grown->foliage.get());
        options.leaves = PrintLeaves::Shells;
        const auto leafy = printTree(tree, params, options, {}, grown->foliage.get());
        QVERIFY2(bare, test::why(bare));
        QVERIFY2(leafy, test::why(leafy));
        QCOMPARE(bare->leaves + bare->leavesLeftOut, Index(0));
        QVERIFY(leafy->leaves > 10);
        QCOMPARE(leafy->leaves + leafy->leavesLeftOut, Index(grown->foliage->leaves.size()));
        const PrintReport& report = leafy->report;
        QVERIFY(report.isClosed);
        QCOMPARE(report.pieces, Index(1));
        QCOMPARE(report.crossings, std::uint64_t(0));
        QCOMPARE(report.low.y, 0.0);
        QVERIFY(report.volume > bare->report.volume);
        QVERIFY2(report.thinnest > 0.99 * options.smallestDiameter(),
                 qPrintable(QString::number(1e3 * report.thinnest)));
        QVERIFY2(std::abs(report.high.y / options.height - 1.0) < 0.02,
                 qPrintable(QString::number(1e3 * report.high.y)));
        const auto none = printTree(tree, params, options, {}, nullptr); // shells of no leaves
        QVERIFY(none && *none->mesh == *bare->mesh);
    }
};

RAMURE_SUITE(TestLeafSheets)

} // namespace tst_leaf_sheets

#include "tst_leaf_sheets.moc"
