#include "core/surface/mesher/build_branch_mesh.h"
#include "tests/support/preset_trees.h"
#include "tests/support/suite.h"
#include <algorithm>

namespace tst_tubes {

using namespace ramure;
using namespace ramure::test;

/// What the mesh says about its tubes and forks: texture coordinates and skins are made from it.
class TestTubes : public QObject
{
    Q_OBJECT

private slots:
    void init() { failOnAnyWarning(); }
    void tubesShareOutAllTriangles_data() { presets(); }
    void tubesShareOutAllTriangles();
    void forkVerticesLieBetweenSiblings_data() { presets(); }
    void forkVerticesLieBetweenSiblings();

private:
    static void presets();
    static BranchMesh meshOf(const QString& preset);
};

void TestTubes::presets()
{
    QTest::addColumn<QString>("preset");
    for (const char* name : {"SmallTree", "FanTree", "TinyTree", "Fern2D"})
        QTest::newRow(name) << QString(name);
}

BranchMesh TestTubes::meshOf(const QString& preset)
{
    const Expected<Skeleton> skeleton = presetSkeleton({preset.toStdString()});
    if (!skeleton)
        return {};
    return buildBranchMesh(*skeleton, {}).value_or(BranchMesh{});
}

void TestTubes::tubesShareOutAllTriangles()
{
    QFETCH(QString, preset);
    const BranchMesh made = meshOf(preset);
    QVERIFY(!made.tubes.empty());
    QCOMPARE(made.tubes.front().firstTriangle, Index(0));
    QCOMPARE(made.axes.size(), made.tubes.size());
    const Expected<Skeleton> skeleton = presetSkeleton({preset.toStdString()});
    std::vector<bool> seen(skeleton->size(), false);
    for (std::size_t t = 0; t < made.tubes.size(); ++t) {
        const TubeRange& tube = made.tubes[t];
        const Index end = t + 1 < made.tubes.size() ? made.tubes[t + 1].firstTriangle : made.mesh.faceCount();
        QVERIFY(end > tube.firstTriangle);
        QVERIFY(!seen[tube.branch]);
        seen[tube.branch] = true;
        QCOMPARE(tube.parent == noIndex, skeleton->parent[tube.branch] == noIndex);
        QVERIFY(tube.parent == noIndex || seen[tube.parent]);
        const TubeAxis& axis = made.axes[t];
        QVERIFY(glm::length(axis.curve.h1 - skeleton->p1[tube.branch]) < 1e-9);
        QVERIFY(axis.a0 > 0.0 && axis.a1 > 0.0);
        QCOMPARE(axis.curve.v1, axis.curve.h1 - axis.curve.h0);
        // A tube's own vertices, those of its fork, and its parent's last ring: nothing else.
        for (Index f = tube.firstTriangle; f < end; ++f)
            for (int corner = 0; corner < 3; ++corner) {
                const Index vertex = made.mesh.triangles[f][corner];
                const Index owner = made.mesh.branch[vertex];
                const auto fork =
                    std::lower_bound(made.forkVertices.begin(), made.forkVertices.end(), vertex,
                                     [](const ForkVertex& at, Index v) { return at.vertex < v; });
                const bool inFork = fork != made.forkVertices.end() && fork->vertex == vertex;
                if (inFork)
                    QVERIFY(std::find(fork->branch.begin(), fork->branch.end(), tube.branch) !=
                                fork->branch.end() ||
                            fork->parent == tube.parent);
                else
                    QVERIFY(owner == tube.branch || owner == tube.parent);
            }
    }
}

void TestTubes::forkVerticesLieBetweenSiblings()
{
    QFETCH(QString, preset);
    const BranchMesh made = meshOf(preset);
    Index last = 0;
    for (const ForkVertex& fork : made.forkVertices) {
        QVERIFY(fork.vertex < made.mesh.vertexCount());
        QVERIFY(fork.vertex > last);
        last = fork.vertex;
        QVERIFY(fork.along >= 0.0F);
        float sum = 0.0F;
        for (std::size_t i = 0; i < 3; ++i) {
            if (fork.branch[i] == noIndex) {
                QVERIFY(i == 2);
                QCOMPARE(fork.weight[i], 0.0F);
                continue;
            }
            const auto tube = std::find_if(made.tubes.begin(), made.tubes.end(),
                                           [&](const TubeRange& t) { return t.branch == fork.branch[i]; });
            QVERIFY(tube != made.tubes.end());
            QCOMPARE(tube->parent, fork.parent);
            sum += fork.weight[i];
        }
        QVERIFY(std::abs(sum - 1.0F) < 1e-6F);
    }
}

RAMURE_SUITE(TestTubes)

} // namespace tst_tubes

#include "tst_tubes.moc"
