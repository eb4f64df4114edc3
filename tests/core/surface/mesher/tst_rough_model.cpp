#include "core/math/random.h"
#include "core/surface/mesher/rough_model.h"
#include "tests/support/mesh_checker.h"
#include "tests/support/suite.h"

#include <cmath>

namespace tst_rough_model {

using namespace ramure;

namespace {

Skeleton randomTree(std::uint64_t seed, Index count)
{
    Random random(seed, RandomStream::Test);
    Skeleton skeleton;
    for (Index i = 0; i < count; ++i) {
        const Index parent = i == 0 ? noIndex : random.below(i);
        const glm::dvec3 from = parent == noIndex ? glm::dvec3(0.0) : skeleton.p1[parent];
        const glm::dvec3 step{random.range(-1, 1), random.range(-1, 1), random.range(-1, 1)};
        skeleton.add(parent, from, from + step, random.range(0.05, 0.1), random.range(0.01, 0.1), i % 3);
    }
    return skeleton;
}

double distanceToAxis(const Skeleton& skeleton, Index branch, const glm::dvec3& point)
{
    const glm::dvec3 axis = glm::normalize(skeleton.p1[branch] - skeleton.p0[branch]);
    const glm::dvec3 away = point - skeleton.p0[branch];
    return glm::length(away - glm::dot(away, axis) * axis);
}

} // namespace

class TestRoughModel : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void emptySkeleton();
    void branchWithoutLengthIsLeftOut();
    void fewerThanThreeSidesBecomeThree();
    void conesStandOnTheirCircles();
    void normalsStandOnTheSurface();
    void eachConeIsOpenAndConsistent();
    void usedArraysChangeNothing();
    void usedArraysAreWrittenInPlace();
};

void TestRoughModel::emptySkeleton()
{
    QVERIFY(buildRoughBranches(Skeleton(), 8) == TriangleMesh());
}

void TestRoughModel::branchWithoutLengthIsLeftOut()
{
    Skeleton skeleton;
    skeleton.add(noIndex, {0, 0, 0}, {0, 0, 0}, 0.1, 0.1);
    skeleton.add(0, {0, 0, 0}, {0, 1, 0}, 0.1, 0.1);
    const TriangleMesh mesh = buildRoughBranches(skeleton, 5);
    QCOMPARE(mesh.vertexCount(), Index(10));
    QVERIFY(mesh.branch == std::vector<Index>(10, 1));
}

void TestRoughModel::fewerThanThreeSidesBecomeThree()
{
    for (const int sides : {-1, 0, 2, 3})
        QCOMPARE(buildRoughBranches(randomTree(1, 4), sides).faceCount(), Index(24));
}

void TestRoughModel::conesStandOnTheirCircles()
{
    const Skeleton tree = randomTree(2, 50);
    for (const int sides : {3, 8, 64}) {
        const TriangleMesh mesh = buildRoughBranches(tree, sides);
        QCOMPARE(mesh.vertexCount(), tree.size() * 2 * Index(sides));
        QCOMPARE(mesh.faceCount(), tree.size() * 2 * Index(sides));
        for (Index i = 0; i < mesh.vertexCount(); ++i) {
            const Index branch = i / (2 * Index(sides));
            const bool atEnd = i / Index(sides) % 2 == 1;
            const glm::dvec3 at(mesh.positions[i]);
            QCOMPARE(mesh.branch[i], branch);
            QCOMPARE(mesh.level[i], tree.level[branch]);
            const double radius = atEnd ? tree.a1[branch] : tree.a0[branch];
            QVERIFY(std::abs(distanceToAxis(tree, branch, at) - radius) < 1e-5);
            const glm::dvec3 centre = atEnd ? tree.p1[branch] : tree.p0[branch];
            QVERIFY(std::abs(glm::length(at - centre) - radius) < 1e-5);
        }
    }
}

void TestRoughModel::normalsStandOnTheSurface()
{
    const Skeleton tree = randomTree(3, 20);
    const TriangleMesh mesh = buildRoughBranches(tree, 32);
    for (Index i = 0; i < mesh.vertexCount(); ++i)
        QVERIFY(std::abs(glm::length(mesh.normals[i]) - 1.0f) < 1e-5f);
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::vec3 a = mesh.positions[t.x], b = mesh.positions[t.y], c = mesh.positions[t.z];
        const glm::vec3 face = glm::normalize(glm::cross(b - a, c - a));
        for (int corner = 0; corner < 3; ++corner)
            QVERIFY(glm::dot(face, mesh.normals[t[corner]]) > 0.99f);
    }
}

void TestRoughModel::eachConeIsOpenAndConsistent()
{
    Skeleton tree;
    tree.add(noIndex, {0, 0, 0}, {0, 1, 0}, 0.2, 0.1);
    tree.add(0, {0, 1, 0}, {1, 2, 0}, 0.05, 0.02);
    const test::CheckedMesh checked = test::checkMesh(buildRoughBranches(tree, 6));
    QCOMPARE(checked.components.size(), std::size_t(2));
    QCOMPARE(checked.boundaryEdges, Index(24));
    QCOMPARE(checked.crowdedEdges + checked.misorientedEdges + checked.pinchedVertices +
                 checked.duplicateVertices + checked.duplicateFaces + checked.degenerateFaces +
                 checked.isolatedVertices,
             Index(0));
    QCOMPARE(checked.inwardNormals + checked.badNormals + checked.badOwners, Index(0));
}

void TestRoughModel::usedArraysChangeNothing()
{
    TriangleMesh used;
    // Those of 100,000 branches are large enough to be written past the caches.
    std::uint64_t seed = 3;
    for (const Index count : {1u, 40u, 7u, 100'000u, 99'999u, 200u, 100'000u, 0u, 3u}) {
        Skeleton tree = randomTree(++seed, count);
        for (Index i = 0; i < count; i += 11) // branches without length
            tree.p1[i] = tree.p0[i];
        const TriangleMesh fresh = buildRoughBranches(tree, 8);
        used = buildRoughBranches(tree, 8, std::move(used));
        QVERIFY(used == fresh);
    }
}

void TestRoughModel::usedArraysAreWrittenInPlace()
{
    const Skeleton tree = randomTree(4, 500);
    TriangleMesh mesh = buildRoughBranches(tree, 8);
    const TriangleMesh before = mesh;
    const glm::vec3 *const positions = mesh.positions.data(), *const normals = mesh.normals.data();
    mesh = buildRoughBranches(tree, 8, std::move(mesh));
    QVERIFY(mesh == before);
    QVERIFY(mesh.positions.data() == positions && mesh.normals.data() == normals);
    // Of far more than is needed nothing is kept.
    mesh = buildRoughBranches(randomTree(5, 20), 8, std::move(mesh));
    QVERIFY(mesh.positions.capacity() < before.positions.size());
}

RAMURE_SUITE(TestRoughModel)

} // namespace tst_rough_model

#include "tst_rough_model.moc"
