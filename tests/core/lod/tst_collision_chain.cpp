#include "core/lod/collision_chain.h"

#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/surface/proof/validate.h"
#include "tests/support/suite.h"

namespace tst_collision_chain {

using namespace ramure;

class TestCollisionChain : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void nothingHasNoPieces() { QVERIFY(collisionChain({}).empty()); }

    /// Closed, convex, few, and around the foot of the trunk.
    void piecesAreConvex_data()
    {
        QTest::addColumn<QByteArray>("name");
        for (const char* name :
             {"TinyTree", "SmallTree", "EnglishOak", "CoconutPalm", "NorwaySpruce", "WeepingWillow"})
            QTest::newRow(name) << QByteArray(name);
    }
    void piecesAreConvex()
    {
        QFETCH(QByteArray, name);
        const auto tree = TreePipeline().evaluate(*presetParams(name.constData()), Stage::Simplified);
        QVERIFY2(tree, test::why(tree));
        const std::vector<TriangleMesh> pieces = collisionChain(tree->simplified->skeleton);
        QVERIFY(!pieces.empty() && pieces.size() <= mostCollisionPieces);
        for (const TriangleMesh& piece : pieces) {
            const auto report = validateMesh(piece);
            QVERIFY2(report && report->boundaryEdges == 0 && report->nonManifoldEdges == 0 &&
                         report->inconsistentEdges == 0,
                     name.constData());
            glm::dvec3 low(1e9), high(-1e9);
            for (const glm::vec3& p : piece.positions) {
                low = glm::min(low, glm::dvec3(p));
                high = glm::max(high, glm::dvec3(p));
            }
            const double rounding = 1e-5 * glm::distance(low, high);
            for (const glm::uvec3& face : piece.triangles) {
                const glm::dvec3 a(piece.positions[face.x]), b(piece.positions[face.y]),
                    c(piece.positions[face.z]);
                const glm::dvec3 out = glm::normalize(glm::cross(b - a, c - a));
                for (const glm::vec3& p : piece.positions)
                    QVERIFY2(glm::dot(glm::dvec3(p) - a, out) <= rounding, name.constData());
            }
        }
    }
};

RAMURE_SUITE(TestCollisionChain)

} // namespace tst_collision_chain

#include "tst_collision_chain.moc"
