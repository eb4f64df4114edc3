#include "core/surface/mesh/deferred_mesh.h"

#include "tests/support/suite.h"
#include <atomic>
#include <stdexcept>
#include <thread>
#include <tuple>
#include <vector>

namespace tst_deferred_mesh {

using namespace ramure;

namespace {

TriangleMesh oneTriangle()
{
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    return mesh;
}

} // namespace

class TestDeferredMesh : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void nullIsNone()
    {
        for (const DeferredMesh& none : {DeferredMesh(), DeferredMesh(nullptr)}) {
            QVERIFY(!none && none.empty() && !none.get() && !none.key() && none.isMade());
            QVERIFY(none.vertexCount() == 0 && none.bytes() == 0 && none == DeferredMesh());
        }
    }

    /// Whoever asks next makes it.
    void aMakerThatFailsIsAskedAgain()
    {
        int calls = 0;
        const DeferredMesh mesh(3, 1, [&calls] {
            if (++calls == 1)
                throw std::runtime_error("no memory");
            return oneTriangle();
        });
        QVERIFY_THROWS_EXCEPTION(std::runtime_error, std::ignore = mesh.pointer());
        QVERIFY(!mesh.isMade());
        QCOMPARE(mesh->faceCount(), Index(1));
        QCOMPARE(calls, 2);
    }

    void itIsMadeOnceForAllCopies()
    {
        std::atomic<int> calls = 0;
        const DeferredMesh mesh(3, 1, [&calls] {
            ++calls;
            return oneTriangle();
        });
        const DeferredMesh copy = mesh, other(3, 1, oneTriangle);
        QVERIFY(mesh && !mesh.empty() && mesh.vertexCount() == 3 && mesh.bytes() == 0);
        QVERIFY(copy == mesh && copy.key() == mesh.key() && !(other == mesh) && !(mesh == DeferredMesh()));
        QCOMPARE(calls.load(), 0);
        {
            std::vector<std::jthread> threads;
            for (int i = 0; i < 4; ++i)
                threads.emplace_back([&mesh] { QVERIFY(mesh.get()); });
        }
        QCOMPARE(calls.load(), 1);
        QVERIFY(copy.isMade() && copy.get() == mesh.get() && mesh.bytes() > 0);
        QVERIFY(DeferredMesh(mesh.pointer()) == mesh); // the mesh itself, however one holds it
    }

    void aMeshThatIsThereIsItself()
    {
        const auto made = std::make_shared<TriangleMesh>(oneTriangle());
        const DeferredMesh mesh = made;
        QVERIFY(mesh.isMade() && mesh.get() == made.get() && mesh.key() == made && mesh == made);
        QVERIFY(!(mesh == std::make_shared<TriangleMesh>(oneTriangle())));
    }
};

RAMURE_SUITE(TestDeferredMesh)

} // namespace tst_deferred_mesh

#include "tst_deferred_mesh.moc"
