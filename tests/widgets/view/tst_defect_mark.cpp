#include "tests/support/sample_tree.h"
#include "tests/support/suite.h"
#include "widgets/view/defect_mark.h"

namespace tst_defect_mark {

using namespace ramure;

/// How a defect is looked at: without OpenGL.
class TestDefectMark : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnAnyWarning(); }
    void leavesAndApplesFadeWhileADefectIsShown();
    void theReachIsSomeBranchesWide();
    void aFreeViewStaysWhereItIs();
    void theLineOfSightIsFree();
    void theEyeStaysAboveTheGround();
};

static DefectPlace defectAt(const glm::dvec3& point)
{
    DefectPlace place;
    place.points = {point};
    place.box.add(point);
    place.box = place.box.grown(0.01);
    return place;
}

/// Two triangles, upright, across Z.
static MeshItem wallAt(double z, double half, const char* material)
{
    TriangleMesh mesh;
    const auto h = float(half), d = float(z);
    mesh.positions = {{-h, 1 - h, d}, {h, 1 - h, d}, {h, 1 + h, d}, {-h, 1 + h, d}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return test::sampleItem(std::move(mesh), material, 1);
}

void TestDefectMark::leavesAndApplesFadeWhileADefectIsShown()
{
    RenderScene scene = test::sampleScene();
    scene.meshes.push_back(wallAt(0.3, 0.1, "fruit"));
    DefectMark mark;
    mark.addTo(scene); // none yet
    QVERIFY(scene.lines.empty());
    DefectPlace place = defectAt({0, 1, 0});
    place.edges = {{glm::dvec3(0.0), glm::dvec3(0, 1, 0)}};
    mark.show(place);
    QVERIFY(mark.isShown());
    mark.addTo(scene);
    QVERIFY(scene.meshes[0].opacity == 1.0f && scene.meshes[0].pickable && scene.meshes[0].castsShadow);
    for (const MeshItem& fading : {scene.meshes[1], scene.meshes[2]})
        QVERIFY(fading.opacity < 0.2f && !fading.pickable && !fading.castsShadow);
    QCOMPARE(scene.lines.back().lines->segments.size(), std::size_t(1));
    QVERIFY(scene.lines.back().throughSurfaces && scene.lines.back().hidden == 1.0f);
    QVERIFY(scene.points.back().throughSurfaces && scene.points.back().hidden == 1.0f);
    const quint64 before = mark.revision();
    QVERIFY(mark.clear() && !mark.clear());
    QVERIFY(!mark.isShown() && mark.revision() != before);
}

void TestDefectMark::theReachIsSomeBranchesWide()
{
    SimplifiedSkeleton tree;
    tree.skeleton = test::sampleSkeleton(4);
    Box node;
    for (const glm::dvec3& end : tree.skeleton.p1)
        node.add(end);
    const glm::dmat4 world = glm::scale(glm::translate(glm::dmat4(1.0), {5, 0, 0}), glm::dvec3(2.0));
    const Index twig = tree.skeleton.size() - 1;
    const glm::dvec3 middle = 0.5 * (tree.skeleton.p0[twig] + tree.skeleton.p1[twig]);
    const DefectPlace place = defectAt(glm::dvec3(world * glm::dvec4(middle, 1.0)));
    const double reach = defectReach(place, &tree, world, node.transformed(world));
    const double length = 2.0 * tree.skeleton.length(twig);
    QVERIFY2(reach > 2.0 * length && reach < 4.0 * length, qPrintable(QString::number(reach / length)));
    const double trunk = defectReach(defectAt({5, 1, 0}), &tree, world, node.transformed(world));
    QVERIFY(trunk <= node.transformed(world).radius()); // no further than the whole tree
    QVERIFY(defectReach(place, nullptr, world, node) > 0.0);
}

void TestDefectMark::aFreeViewStaysWhereItIs()
{
    RenderScene scene;
    scene.meshes = {wallAt(-0.2, 1.0, "bark"), wallAt(0.3, 1.0, "leaves")}; // behind it, and what fades
    scene.updateBoxes();
    Camera from;
    from.yawRad = 0.1;
    const Camera view = defectView(scene, defectAt({0, 1, 0}), 0.5, from, 1.5, true);
    QCOMPARE(view.yawRad, from.yawRad);
    QCOMPARE(view.pitchRad, from.pitchRad);
    QVERIFY(glm::length(view.target - glm::dvec3(0, 1, 0)) < 1e-9);
    QVERIFY(std::abs(0.5 * view.heightAtTarget() - 0.5) < 1e-6);
}

void TestDefectMark::theLineOfSightIsFree()
{
    RenderScene scene;
    scene.meshes = {wallAt(0.3, 0.8, "bark")};
    scene.updateBoxes();
    Camera from;
    from.yawRad = 0.1;
    const DefectPlace place = defectAt({0, 1, 0});
    const Camera view = defectView(scene, place, 0.6, from, 1.5, true);
    const glm::dvec3 way = view.eye() - view.target;
    if (way.z > 0.3) { // past the wall's rim
        const glm::dvec3 crossing = view.target + way * (0.3 / way.z);
        QVERIFY(std::abs(crossing.x) > 0.8 || std::abs(crossing.y - 1.0) > 0.8);
    }
}

void TestDefectMark::theEyeStaysAboveTheGround()
{
    RenderScene scene;
    scene.meshes = {wallAt(0.3, 0.8, "bark")};
    scene.updateBoxes();
    Camera from;
    from.pitchRad = -1.2;
    const DefectPlace place = defectAt({0, 0.2, 0});
    QVERIFY(defectView(scene, place, 1.0, from, 1.5, true).eye().y > 0.0);
    QVERIFY(defectView(scene, place, 1.0, from, 1.5, false).eye().y < 0.0);
}

RAMURE_SUITE(TestDefectMark)

} // namespace tst_defect_mark

#include "tst_defect_mark.moc"
