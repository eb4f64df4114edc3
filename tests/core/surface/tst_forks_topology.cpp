#include "core/math/random.h"
#include "core/surface/mesher/build_branch_mesh.h"
#include "tests/support/fork_judge.h"
#include "tests/support/preset_trees.h"
#include "tests/support/skeleton_zoo.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <cmath>

namespace tst_forks_topology {

using namespace ramure;
using namespace ramure::test;

/// One watertight 2-manifold from any skeleton: by the program's own check, by OpenMesh, and by a judge of
/// the tests that shares no code with either. RAMURE_FUZZ_COUNT raises the number of skeletons for long runs.
class TestForksTopology : public QObject
{
    Q_OBJECT
private slots:
    void init() { failOnAnyWarning(); }
    void badInputIsAnError();
    void presetsInAllDivisions_data();
    void presetsInAllDivisions();
    void randomTreesOfAGrammar_data();
    void randomTreesOfAGrammar();
    void zoo();
    void zooAtTheExtremes();
    void sameSkeletonSameMesh();
    void theSkeletonsOwnRepairsAreReported();
};

namespace {

constexpr std::uint64_t slowness = test::isSanitized ? 20 : 1;

/// Collects faults: all are counted, the first few are told.
class Faults
{
public:
    void add(const std::string& name, const std::string& faults)
    {
        if (!faults.empty() && m_count++ < 25)
            m_text += "\n" + name + "\n" + faults;
    }
    QByteArray text(std::uint64_t of) const
    {
        return QByteArray::number(qulonglong(m_count)) + " of " + QByteArray::number(qulonglong(of)) +
               QByteArray::fromStdString(m_text);
    }
    [[nodiscard]] bool none() const { return m_count == 0; }

private:
    std::uint64_t m_count = 0;
    std::string m_text;
};

void resize(Skeleton& skeleton, double scale, const glm::dvec3& offset)
{
    for (Index i = 0; i < skeleton.size(); ++i) {
        skeleton.p0[i] = skeleton.p0[i] * scale + offset;
        skeleton.p1[i] = skeleton.p1[i] * scale + offset;
        skeleton.a0[i] *= scale;
        skeleton.a1[i] *= scale;
    }
}

} // namespace

void TestForksTopology::badInputIsAnError()
{
    const auto code = [](const Skeleton& skeleton, const BranchMeshOptions& options = {}) {
        const Expected<BranchMesh> built = buildBranchMesh(skeleton, options);
        return built ? -1 : static_cast<int>(built.error().code);
    };
    const int invalid = static_cast<int>(ErrorCode::Invalid);
    QCOMPARE(code({}), invalid);
    Skeleton good;
    good.add(noIndex, {0, 0, 0}, {0, 1, 0}, 0.1, 0.05);
    QCOMPARE(code(good), -1);
    for (const double bad : {double(NAN), double(INFINITY), -double(INFINITY)}) {
        Skeleton s = good;
        s.p1[0].x = bad;
        QCOMPARE(code(s), invalid);
        s = good;
        s.a0[0] = bad;
        QCOMPARE(code(s), invalid);
    }
    std::stop_source source;
    source.request_stop();
    const Expected<BranchMesh> stopped = buildBranchMesh(good, {}, {source.get_token(), {}});
    QVERIFY(!stopped && stopped.error().code == ErrorCode::Cancelled);
}

void TestForksTopology::presetsInAllDivisions_data()
{
    QTest::addColumn<QString>("preset");
    QTest::addColumn<int>("radial");
    QTest::addColumn<int>("length");
    const auto row = [](const char* preset, int radial, int length) {
        QTest::addRow("%s %d radial x %d length", preset, radial, length) << preset << radial << length;
    };
    for (const int radial : {3, 4, 5, 8, 16, 64})
        for (const int length : {2, 3, 4, 16}) {
            row("TinyTree", radial, length);
            if (slowness == 1 &&
                (radial == 8 || length == 4 || radial + length <= 6 || radial + length == 80))
                for (const char* preset : {"SmallTree", "FanTree", "Fern2D"})
                    row(preset, radial, length);
        }
}

void TestForksTopology::presetsInAllDivisions()
{
    QFETCH(QString, preset);
    QFETCH(int, radial);
    QFETCH(int, length);
    const Expected<Skeleton> skeleton = presetSkeleton({preset.toStdString()});
    QVERIFY2(skeleton, why(skeleton));
    BranchMeshOptions options;
    options.radialDivisions = radial;
    options.lengthDivisions = length;
    const std::string faults = branchMeshFaults(*skeleton, options);
    QVERIFY2(faults.empty(), faults.c_str());
}

void TestForksTopology::randomTreesOfAGrammar_data()
{
    QTest::addColumn<QString>("preset");
    QTest::newRow("SmallTree") << "SmallTree";
    QTest::newRow("FanTree") << "FanTree";
}

void TestForksTopology::randomTreesOfAGrammar()
{
    QFETCH(QString, preset);
    const std::string name = preset.toStdString();
    const std::uint64_t count = 1000 / slowness;
    Faults faults;
    for (std::uint64_t seed = 1; seed <= count; ++seed) {
        PresetTree tree{name};
        tree.stochastic = seed;
        tree.iterations = 5;
        const Expected<Skeleton> skeleton = presetSkeleton(tree);
        QVERIFY2(skeleton, why(skeleton));
        faults.add(name + " seed " + std::to_string(seed), branchMeshFaults(*skeleton, BranchMeshOptions()));
    }
    QVERIFY2(faults.none(), faults.text(count));
}

void TestForksTopology::zoo()
{
    const std::uint64_t count = fuzzCount(2000 / slowness);
    Faults faults;
    for (std::uint64_t number = 0; number < count; ++number) {
        const Specimen animal = specimen(number);
        faults.add(animal.name, branchMeshFaults(animal.skeleton, animal.meshOptions()));
    }
    QVERIFY2(faults.none(), faults.text(count));
}

/// From an atom's size to a planet's, up to ten million times its size from the origin, with the finest
/// divisions: where floats no longer hold the shape an error is fine, a broken mesh never.
void TestForksTopology::zooAtTheExtremes()
{
    const std::uint64_t count = 300 / slowness;
    Faults faults;
    for (std::uint64_t number = 0; number < count; ++number) {
        Specimen animal = specimen(number);
        if (animal.skeleton.size() > 300)
            continue;
        Random random(number, RandomStream::Test, 1);
        const double scale = std::pow(10.0, random.range(-10.0, 10.0));
        const double away = scale * std::pow(10.0, random.range(0.0, 7.0));
        const glm::dvec3 offset{random.range(-away, away), random.range(-away, away),
                                random.range(-away, away)};
        resize(animal.skeleton, scale, offset);
        BranchMeshOptions options = animal.meshOptions();
        options.radialDivisions = random.below(4) == 0 ? 128 : options.radialDivisions;
        options.lengthDivisions = random.below(8) == 0 ? 64 : options.lengthDivisions;
        options.nearTwinRatio = random.below(4) == 0 ? random.range(0.0, 3.0) : options.nearTwinRatio;
        const Expected<BranchMesh> built = buildBranchMesh(animal.skeleton, options);
        if (built)
            faults.add(animal.name + " at the extremes", branchMeshFaults(animal.skeleton, *built));
        else
            QCOMPARE(static_cast<int>(built.error().code), static_cast<int>(ErrorCode::Invalid));
    }
    QVERIFY2(faults.none(), faults.text(count));
}

void TestForksTopology::sameSkeletonSameMesh()
{
    for (std::uint64_t number = 0; number < 3 * zooFamilyCount; ++number) {
        const Specimen animal = specimen(number);
        const Expected<BranchMesh> first = buildBranchMesh(animal.skeleton, animal.meshOptions());
        const Expected<BranchMesh> second = buildBranchMesh(animal.skeleton, animal.meshOptions());
        QVERIFY2(first && second, animal.name.c_str());
        QVERIFY2(first->mesh == second->mesh && first->repairs.size() == second->repairs.size(),
                 animal.name.c_str());
    }
}

void TestForksTopology::theSkeletonsOwnRepairsAreReported()
{
    const auto has = [](const BranchMesh& built, SkeletonRepair kind, Index branch) {
        return std::any_of(built.repairs.begin(), built.repairs.end(), [&](const RepairNote& note) {
            return note.kind == kind && note.branch == branch;
        });
    };
    Skeleton s;
    s.add(noIndex, {0, 0, 0}, {0, 1, 0}, 0.1, 0.1);
    s.add(0, {0, 1, 0}, {1, 2, 0}, 0.1, 0.1);
    s.add(0, {0, 1, 0}, {-1, 2, 0}, 0.1, 0.1);
    Expected<BranchMesh> built = buildBranchMesh(s, {});
    QVERIFY2(built, why(built));
    QVERIFY(built->repairs.empty());
    s.add(0, {0, 1, 0}, {1, 2, 0}, 0.1, 0.1);  // 3: coincides with 1
    s.add(0, {0, 1, 0}, {0, 1, 0}, 0.1, 0.1);  // 4: no length
    s.add(0, {0, 1, 0}, {-3, 4, 0}, 0.1, 0.1); // 5: runs through 2 and on
    built = buildBranchMesh(s, {});
    QVERIFY2(built, why(built));
    QVERIFY(has(*built, SkeletonRepair::SiblingsMerged, 1) || has(*built, SkeletonRepair::SiblingsMerged, 3));
    QVERIFY(has(*built, SkeletonRepair::ZeroLengthContracted, 4));
    QVERIFY(has(*built, SkeletonRepair::SiblingChained, 5));
}

RAMURE_SUITE(TestForksTopology)

} // namespace tst_forks_topology

#include "tst_forks_topology.moc"
