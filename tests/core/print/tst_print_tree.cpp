#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/print/print_tree.h"
#include "core/print/thinned_mesh.h"
#include "core/print/united_surface.h"
#include "tests/core/io/io_support.h"

namespace tst_print_tree {

using namespace ramure;

namespace {

TriangleMesh box(const glm::vec3& low, const glm::vec3& high)
{
    TriangleMesh out;
    for (int i = 0; i < 8; ++i)
        out.positions.emplace_back(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
    out.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                     {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return out;
}

void append(TriangleMesh& to, const TriangleMesh& mesh)
{
    const Index first = to.vertexCount();
    to.positions.insert(to.positions.end(), mesh.positions.begin(), mesh.positions.end());
    for (const glm::uvec3& t : mesh.triangles)
        to.triangles.push_back(t + first);
}

/// A tree of two limbs that run through each other.
Skeleton crossingTree()
{
    Skeleton out;
    const Index trunk = out.add(noIndex, {0, 0, 0}, {0, 4, 0}, 0.5, 0.4);
    const Index left = out.add(trunk, {0, 4, 0}, {-2, 6, 0}, 0.3, 0.3, 1);
    const Index right = out.add(trunk, {0, 4, 0}, {2, 6, 0}, 0.3, 0.3, 1);
    out.add(left, {-2, 6, 0}, {2, 9, 0.1}, 0.25, 0.2, 1);
    out.add(right, {2, 6, 0}, {-2, 9, 0}, 0.25, 0.2, 1);
    return out;
}

Progress stopped()
{
    std::stop_source stop;
    stop.request_stop();
    return {stop.get_token(), {}};
}

} // namespace

class TestPrintTree : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void badInput()
    {
        PrintOptions options;
        options.height = -1.0;
        QCOMPARE(printTree(crossingTree(), {}, options).error().code, ErrorCode::Invalid);
        QVERIFY(!printTree({}, {}, {}));
        QCOMPARE(printTree(crossingTree(), {}, {}, stopped()).error().code, ErrorCode::Cancelled);
        QVERIFY(!unitedSurface({}, {0.1, true}));
        QVERIFY(!unitedSurface(box(glm::vec3(0), glm::vec3(1)), {0.0, true}));
        QCOMPARE(unitedSurface(box(glm::vec3(0), glm::vec3(1)), {1e-6, true}).error().code, ErrorCode::Limit);
        QCOMPARE(unitedSurface(box(glm::vec3(0), glm::vec3(1)), {0.1, true}, stopped()).error().code,
                 ErrorCode::Cancelled);
        QVERIFY(!thinnedMesh({}, {0.1, 100}));
    }
    /// Two boxes through each other, half of one below the ground, and one in the air.
    void boxesAreUnited()
    {
        TriangleMesh mesh = box({-1, -1, -1}, {1, 1, 1});
        append(mesh, box({0, 0.5F, -0.5F}, {2, 1.5F, 0.5F}));
        append(mesh, box({0, 5, 0}, {0.5F, 5.5F, 0.5F}));
        const auto made = unitedSurface(mesh, {0.05, true});
        QVERIFY2(made, test::why(made));
        QCOMPARE(made->loose, Index(1));
        QVERIFY(std::abs(made->looseVolume - 0.125) < 0.01);
        const auto shared = std::make_shared<const TriangleMesh>(made->mesh);
        const auto report = printReport(shared, 0.1);
        QVERIFY2(report, test::why(report));
        QVERIFY(report->isClosed);
        QCOMPARE(report->pieces, Index(1));
        QCOMPARE(report->low.y, 0.0);
        QVERIFY(std::abs(report->volume - 5.5) < 0.05);
        QVERIFY2(std::abs(report->footArea - 4.0) < 0.5, qPrintable(QString::number(report->footArea)));
        QVERIFY(report->standsUp());
        // Below the arm: it looks down, the foot does not count.
        QVERIFY2(std::abs(report->overhang - 1.0) < 0.3, qPrintable(QString::number(report->overhang)));
        const auto thin = thinnedMesh(made->mesh, {0.05, 100'000});
        QVERIFY2(thin, test::why(thin));
        QVERIFY(thin->triangles.size() < made->mesh.triangles.size() / 10);
        const auto after = printReport(std::make_shared<const TriangleMesh>(*thin), 0.1);
        QVERIFY(after && after->isClosed && after->pieces == 1);
        QVERIFY(std::abs(after->volume / report->volume - 1.0) < 0.001);
    }
    void hollowsAreFilled()
    {
        TriangleMesh mesh = box(glm::vec3(-1), glm::vec3(1));
        TriangleMesh hollow = box(glm::vec3(-0.5F), glm::vec3(0.5F));
        for (glm::uvec3& t : hollow.triangles)
            std::swap(t.x, t.y);
        append(mesh, hollow);
        const auto made = unitedSurface(mesh, {0.05, false});
        QVERIFY2(made, test::why(made));
        const auto report = printReport(std::make_shared<const TriangleMesh>(made->mesh), 0.1);
        QVERIFY(report && report->pieces == 1);
        QVERIFY(std::abs(report->volume - 8.0) < 0.05);
    }
    void reportOfABox()
    {
        const auto report =
            printReport(std::make_shared<const TriangleMesh>(box({0, 0, 0}, {0.3F, 0.1F, 0.2F})), 0.01);
        QVERIFY(report && report->isClosed);
        QVERIFY(std::abs(report->volume - 0.006) < 1e-9);
        QVERIFY(std::abs(report->thinnest - 0.1) < 1e-6);
        QVERIFY(glm::distance(report->centreOfMass, glm::dvec3(0.15, 0.05, 0.1)) < 1e-6);
        QVERIFY(std::abs(report->balance - 0.1) < 1e-6);
        QVERIFY(std::abs(report->footArea - 0.06) < 1e-6);
        QCOMPARE(report->overhang, 0.0);
        QCOMPARE(report->crossings, std::uint64_t(0));
        const auto beside =
            printReport(std::make_shared<const TriangleMesh>(box({0, 1, 0}, {1, 2, 1})), 0.01);
        QVERIFY(beside && !beside->standsUp());
    }
    void hull()
    {
        QVERIFY(convexHull({}).empty());
        QCOMPARE(convexHull({{1, 1}, {1, 1}}).size(), std::size_t(1));
        const auto found = convexHull({{0, 0}, {1, 0}, {0.5, 0.5}, {1, 1}, {0, 1}, {0.5, 0}});
        QCOMPARE(found, (std::vector<glm::dvec2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
    }
    void treesBecomeOneSurface_data()
    {
        QTest::addColumn<int>("process");
        QTest::addColumn<bool>("disc");
        for (int i = 0; i < 3; ++i)
            for (const bool disc : {false, true})
                QTest::addRow("%s %d", printProcesses()[std::size_t(i)].name, disc) << i << disc;
    }
    void treesBecomeOneSurface()
    {
        QFETCH(const int, process);
        QFETCH(const bool, disc);
        PrintOptions options;
        options.process = static_cast<PrintProcess>(process);
        options.height = test::isSanitized ? 20.0 * options.smallestDiameter() : 0.04;
        options.hasFootDisc = disc;
        const auto print = printTree(crossingTree(), {}, options);
        QVERIFY2(print, test::why(print));
        const PrintReport& report = print->report;
        QVERIFY(report.isClosed);
        QCOMPARE(report.pieces, Index(1));
        QCOMPARE(report.crossings, std::uint64_t(0));
        QCOMPARE(report.low.y, 0.0);
        QVERIFY(std::abs(report.high.y / options.height - 1.0) < 0.01);
        QVERIFY2(report.thinnest > 0.99 * options.smallestDiameter(),
                 qPrintable(QString::number(1e3 * report.thinnest)));
        QCOMPARE(report.standsUp(), true);
        const auto again = printTree(crossingTree(), {}, options);
        QVERIFY(again && *again->mesh == *print->mesh);
    }
    void theBudgetIsKept()
    {
        NodeParams params;
        params.mesh.targetTriangles = 6000;
        PrintOptions options;
        options.height = test::isSanitized ? 0.06 : options.height;
        const auto print = printTree(crossingTree(), params, options);
        QVERIFY2(print, test::why(print));
        QVERIFY(print->report.triangles <= 6000);
        QVERIFY(print->report.isClosed);
    }
};

RAMURE_SUITE(TestPrintTree)

} // namespace tst_print_tree

#include "tst_print_tree.moc"
