#include "core/math/random.h"
#include "core/surface/proof/validate.h"
#include "tests/support/mesh_checker.h"
#include "tests/support/solids.h"
#include "tests/support/suite.h"

namespace tst_judges_agree {

using namespace ramure;
using namespace ramure::test;

/// The program's check and the tests' own judge were written apart; on meshes broken at random they must say
/// the same.
class TestJudgesAgree : public QObject
{
    Q_OBJECT
private slots:
    void init() { failOnAnyWarning(); }
    void onMeshesBrokenAtRandom();
};

namespace {

void breakOnce(TriangleMesh& mesh, Random& random)
{
    const auto vertex = [&] { return random.below(mesh.vertexCount()); };
    const Index face = random.below(mesh.faceCount());
    glm::uvec3& t = mesh.triangles[face];
    switch (random.below(9)) {
    case 0:
        std::swap(t.x, t.y);
        break;
    case 1:
        mesh.triangles.erase(mesh.triangles.begin() + face);
        break;
    case 2:
        mesh.triangles.push_back({t.y, t.z, t.x});
        break;
    case 3:
        mesh.triangles.push_back({t.y, t.x, t.z});
        break;
    case 4:
        mesh.positions[vertex()] = mesh.positions[vertex()];
        break;
    case 5:
        mesh.positions.push_back({random.unit(), random.unit(), random.unit()});
        break;
    case 6:
        t[static_cast<int>(random.below(3))] = vertex();
        break;
    case 7:
        mesh.triangles.emplace_back(vertex(), vertex(), vertex());
        break;
    default: { // weld two vertices
        const Index from = vertex(), to = vertex();
        for (glm::uvec3& u : mesh.triangles)
            for (int k = 0; k < 3; ++k)
                if (u[k] == from)
                    u[k] = to;
    }
    }
}

} // namespace

void TestJudgesAgree::onMeshesBrokenAtRandom()
{
    const TriangleMesh sound[] = {box({0, 0, 0}, {1, 2, 3}), torus(8, 5),
                                  joined(box({0, 0, 0}, {1, 1, 1}), moved(torus(5, 4), {5, 0, 0}))};
    for (std::uint64_t seed = 0; seed < 3000; ++seed) {
        Random random(seed, RandomStream::Test);
        TriangleMesh mesh = sound[seed % 3];
        for (std::uint32_t i = random.below(5); i > 0; --i)
            breakOnce(mesh, random);
        const CheckedMesh ours = checkMesh(mesh);
        const Expected<MeshReport> theirs = validateMesh(mesh);
        QVERIFY2(theirs, why(theirs));
        std::int64_t euler = 0;
        bool outward = !ours.components.empty();
        for (const CheckedComponent& c : ours.components) {
            euler += c.euler;
            outward = outward && c.volume > 0.0;
        }
        const bool same =
            ours.boundaryEdges == theirs->boundaryEdges && ours.crowdedEdges == theirs->nonManifoldEdges &&
            ours.pinchedVertices == theirs->nonManifoldVertices &&
            ours.misorientedEdges == theirs->inconsistentEdges &&
            ours.duplicateVertices == theirs->duplicateVertices &&
            ours.duplicateFaces == theirs->duplicateFaces &&
            ours.degenerateFaces == theirs->degenerateFaces &&
            ours.isolatedVertices == theirs->isolatedVertices &&
            ours.components.size() == theirs->components && euler == theirs->eulerCharacteristic &&
            (ours.closedManifold() && outward) == theirs->valid;
        if (!same) {
            const std::string text = "seed " + std::to_string(seed) + "\n" + ours.summary() +
                                     "program: boundary " + std::to_string(theirs->boundaryEdges) +
                                     ", non-manifold edges " + std::to_string(theirs->nonManifoldEdges) +
                                     ", non-manifold vertices " +
                                     std::to_string(theirs->nonManifoldVertices) + ", inconsistent " +
                                     std::to_string(theirs->inconsistentEdges) + ", duplicate vertices " +
                                     std::to_string(theirs->duplicateVertices) + ", duplicate faces " +
                                     std::to_string(theirs->duplicateFaces) + ", degenerate " +
                                     std::to_string(theirs->degenerateFaces) + ", isolated " +
                                     std::to_string(theirs->isolatedVertices) + ", components " +
                                     std::to_string(theirs->components) + ", Euler " +
                                     std::to_string(theirs->eulerCharacteristic) + " (" +
                                     std::to_string(euler) + "), valid " + std::to_string(theirs->valid);
            QFAIL(text.c_str());
        }
    }
}

RAMURE_SUITE(TestJudgesAgree)

} // namespace tst_judges_agree

#include "tst_judges_agree.moc"
