#include "core/base/parallel.h"
#include "core/surface/mesh/mesh_arrays.h"
#include "core/surface/mesher/build_branch_mesh.h"
#include "tests/support/fork_judge.h"
#include "tests/support/preset_trees.h"
#include "tests/support/skeleton_zoo.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <cstring>
#include <thread>

namespace tst_mesh_threads {

using namespace ramure;
using namespace ramure::test;

/// The same bytes on one thread and on many.
class TestMeshThreads : public QObject
{
    Q_OBJECT
private slots:
    void init() { failOnAnyWarning(); }
    void cancelStopsAllThreads();
    void progressRises();
    void presets_data();
    void presets();
    void forests();
    void treesThatComeOutInsideOut();
    void zoo();
    void checkedBesideIsCheckedAfter();
    void sharedMeshesGiveTheirMemoryBack();

private:
    static Expected<BranchMesh> onThreads(unsigned threads, const Skeleton& skeleton,
                                          const BranchMeshOptions& options = {});
    static bool sameOnAll(const Skeleton& skeleton, const BranchMeshOptions& options = {});
};

namespace {

template <class T> bool sameBytes(const std::vector<T>& a, const std::vector<T>& b)
{
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool sameAxes(const TubeAxis& a, const TubeAxis& b)
{
    return a.curve.h0 == b.curve.h0 && a.curve.h1 == b.curve.h1 && a.curve.v0 == b.curve.v0 &&
           a.curve.v1 == b.curve.v1 && a.a0 == b.a0 && a.a1 == b.a1;
}

bool sameNotes(const RepairNote& a, const RepairNote& b)
{
    return a.kind == b.kind && a.branch == b.branch && a.other == b.other;
}

bool same(const BranchMesh& a, const BranchMesh& b)
{
    return sameBytes(a.mesh.positions, b.mesh.positions) && sameBytes(a.mesh.normals, b.mesh.normals) &&
           sameBytes(a.mesh.triangles, b.mesh.triangles) && sameBytes(a.mesh.branch, b.mesh.branch) &&
           sameBytes(a.mesh.level, b.mesh.level) && a.tubes == b.tubes && a.forkVertices == b.forkVertices &&
           std::equal(a.axes.begin(), a.axes.end(), b.axes.begin(), b.axes.end(), sameAxes) &&
           std::equal(a.repairs.begin(), a.repairs.end(), b.repairs.begin(), b.repairs.end(), sameNotes) &&
           a.roots == b.roots && a.budget == b.budget;
}

bool sameReports(const MeshReport& a, const MeshReport& b)
{
    for (int kind = 0; kind < defectKindCount; ++kind)
        if (a.count(static_cast<DefectKind>(kind)) != b.count(static_cast<DefectKind>(kind)))
            return false;
    return a.valid == b.valid && a.vertices == b.vertices && a.faces == b.faces &&
           a.components == b.components && a.eulerCharacteristic == b.eulerCharacteristic &&
           std::memcmp(&a.volume, &b.volume, sizeof a.volume) == 0 && a.defects.size() == b.defects.size();
}

/// A tree that is large enough for several tasks.
Skeleton largeTree()
{
    PresetTree wanted{"SmallTree"};
    wanted.iterations = 9;
    return presetSkeleton(wanted).value_or(Skeleton());
}

/// Adds a copy of a tree beside what is there.
void plant(Skeleton& forest, const Skeleton& tree, double x)
{
    const Index first = forest.size();
    for (Index i = 0; i < tree.size(); ++i)
        forest.add(tree.parent[i] == noIndex ? noIndex : tree.parent[i] + first,
                   tree.p0[i] + glm::dvec3(x, 0, 0), tree.p1[i] + glm::dvec3(x, 0, 0), tree.a0[i], tree.a1[i],
                   tree.level[i]);
}

} // namespace

Expected<BranchMesh> TestMeshThreads::onThreads(unsigned threads, const Skeleton& skeleton,
                                                const BranchMeshOptions& options)
{
    const ThreadLimit limit(threads);
    return buildBranchMesh(skeleton, options);
}

bool TestMeshThreads::sameOnAll(const Skeleton& skeleton, const BranchMeshOptions& options)
{
    const Expected<BranchMesh> alone = onThreads(1, skeleton, options);
    for (const unsigned threads : {2U, 0U}) {
        const Expected<BranchMesh> shared = onThreads(threads, skeleton, options);
        if (alone.has_value() != shared.has_value() || (alone && !same(*alone, *shared)))
            return false;
    }
    return true;
}

void TestMeshThreads::cancelStopsAllThreads()
{
    const Skeleton tree = largeTree();
    for (const double at : {0.0, 0.1, 0.5, 0.8}) {
        std::stop_source source;
        const Progress progress{source.get_token(), [&](double fraction) {
                                    if (fraction >= at)
                                        source.request_stop();
                                }};
        const Expected<BranchMesh> built = buildBranchMesh(tree, {}, progress);
        QVERIFY(!built);
        QCOMPARE(built.error().code, ErrorCode::Cancelled);
    }
}

void TestMeshThreads::progressRises()
{
    for (const Index budget : {0U, 100'000U}) {
        BranchMeshOptions options;
        options.targetTriangles = budget;
        double last = 0.0;
        bool rises = true;
        const Progress progress{{}, [&](double fraction) {
                                    rises = rises && fraction >= last && fraction <= 1.0;
                                    last = fraction;
                                }};
        QVERIFY(buildBranchMesh(largeTree(), options, progress));
        QVERIFY(rises);
        QCOMPARE(last, 1.0);
    }
}

void TestMeshThreads::presets_data()
{
    QTest::addColumn<QString>("preset");
    QTest::addColumn<unsigned>("budget");
    for (const char* name : {"SmallTree", "FanTree", "TinyTree", "Fern2D"})
        for (const unsigned budget : {0U, 60'000U})
            QTest::addRow("%s %u", name, budget) << QString(name) << budget;
}

void TestMeshThreads::presets()
{
    QFETCH(QString, preset);
    QFETCH(unsigned, budget);
    const std::string name = preset.toStdString();
    const Expected<Skeleton> skeleton = presetSkeleton({name});
    BranchMeshOptions options;
    options.targetTriangles = budget;
    QVERIFY(sameOnAll(*skeleton, options));
}

/// Many small trees share a task; large ones are cut into several.
void TestMeshThreads::forests()
{
    const Expected<Skeleton> tiny = presetSkeleton({"TinyTree"}), small = presetSkeleton({"SmallTree"});
    Skeleton forest;
    for (int i = 0; i < 12; ++i) {
        plant(forest, *tiny, 10.0 * i);
        forest.add(noIndex, {10.0 * i + 5.0, 0, 0}, {10.0 * i + 5.0, 1, 0}, 0.1, 0.1);
        if (i % 5 == 2)
            plant(forest, *small, 10.0 * i + 200.0);
    }
    QVERIFY(sameOnAll(forest));
    const Expected<BranchMesh> built = buildBranchMesh(forest, {});
    QVERIFY2(built, why(built));
    QCOMPARE(built->roots, Index(26));
    const std::string faults = branchMeshFaults(forest, *built);
    QVERIFY2(faults.empty(), faults.c_str());
}

void TestMeshThreads::treesThatComeOutInsideOut()
{
    Skeleton thick = largeTree();
    for (Index i = 0; i < thick.size(); ++i) {
        thick.a0[i] *= 400.0;
        thick.a1[i] *= 400.0;
    }
    Skeleton forest;
    const Skeleton good = largeTree();
    plant(forest, good, 0.0);
    plant(forest, thick, 50.0);
    plant(forest, good, 100.0);
    QVERIFY(sameOnAll(forest));
    const Expected<BranchMesh> built = buildBranchMesh(forest, {});
    QVERIFY2(built, why(built));
    const std::string faults = branchMeshFaults(forest, *built);
    QVERIFY2(faults.empty(), faults.c_str());
}

void TestMeshThreads::zoo()
{
    const std::uint64_t count = fuzzCount(10 * zooFamilyCount);
    for (std::uint64_t number = 0; number < count; ++number) {
        const Specimen animal = specimen(number);
        BranchMeshOptions options = animal.meshOptions();
        options.targetTriangles = number % 3 == 0 ? animal.skeleton.size() * 40 : 0;
        QVERIFY2(sameOnAll(animal.skeleton, options), animal.name.c_str());
    }
}

/// Among the zoo's animals are those whose vertices meet and whose triangles have no area at first.
void TestMeshThreads::checkedBesideIsCheckedAfter()
{
    BranchMeshOptions tooFew;
    tooFew.radialDivisions = 2;
    QVERIFY(!buildCheckedBranchMesh(largeTree(), tooFew));
    std::stop_source stopped;
    stopped.request_stop();
    const auto cancelled = buildCheckedBranchMesh(largeTree(), {}, {stopped.get_token(), {}});
    QVERIFY(!cancelled);
    QCOMPARE(cancelled.error().code, ErrorCode::Cancelled);
    const std::uint64_t count = fuzzCount(10 * zooFamilyCount);
    for (std::uint64_t number = 0; number <= count; ++number) {
        const Specimen animal = specimen(number);
        const Skeleton skeleton = number < count ? animal.skeleton : largeTree();
        const BranchMeshOptions options = number < count ? animal.meshOptions() : BranchMeshOptions();
        const Expected<BranchMesh> built = buildBranchMesh(skeleton, options);
        const auto report = built ? validateMesh(built->mesh) : MeshReport();
        for (const unsigned threads : {1U, 2U}) {
            const ThreadLimit limit(threads);
            const auto checked = buildCheckedBranchMesh(skeleton, options);
            QCOMPARE(checked.has_value(), built.has_value());
            QVERIFY2(!checked || same(checked->mesh, *built), animal.name.c_str());
            QVERIFY2(!checked || sameReports(checked->report, *report), animal.name.c_str());
        }
    }
}

void TestMeshThreads::sharedMeshesGiveTheirMemoryBack()
{
    std::shared_ptr<const TriangleMesh> last;
    {
        MeshArrays arrays;
        Expected<BranchMesh> built = buildBranchMesh(largeTree(), {});
        QVERIFY(built);
        const TriangleMesh copy = built->mesh;
        const glm::uvec3* const place = built->mesh.triangles.data();
        std::shared_ptr<const TriangleMesh> shared = arrays.share(std::move(built->mesh));
        QVERIFY(shared->triangles == copy.triangles && shared->positions == copy.positions);
        QVERIFY(arrays.take().triangles.empty()); // still somebody's
        std::jthread([mesh = std::move(shared)] {});
        const TriangleMesh back = arrays.take();
        QVERIFY(back.triangles.data() == place);
        QVERIFY(back.uv.empty());
        last = arrays.share(TriangleMesh(copy));
    }
    QVERIFY(!last->empty()); // longer than the arrays
}

RAMURE_SUITE(TestMeshThreads)

} // namespace tst_mesh_threads

#include "tst_mesh_threads.moc"
