#include "core/math/random.h"
#include "core/rig/tracks/node_animation.h"
#include "core/scene/world_transforms.h"
#include "tests/support/solids.h"
#include "tests/support/suite.h"
#include "widgets/view/render/pick/pick_scene.h"
#include "widgets/view/render/scene_builder.h"
#include <glm/gtc/matrix_transform.hpp>

namespace tst_surface_picks {

using namespace ramure;

namespace {

/// An imported mesh that is scaled unevenly, turned and moved by keys; something stands before it.
Scene terrainScene()
{
    Node land;
    land.id = 1;
    land.kind = NodeKind::Mesh;
    land.name = "Land";
    land.mesh = SharedValue<TriangleMesh>(test::torus(160, 80));
    land.params.tree.scale = {2.0, 0.5, 1.5};
    land.params.tree.rotation = {0.3, -0.4, 0.2};
    land.params.local.translation = {0.2, 0.1, -0.3};
    Key from, to;
    to.time = ticksPerSecond;
    to.value = 6.0;
    land.animation.set({ChannelPart::GlobalTranslation, 0, 0},
                       std::make_shared<const AnyTrack>(*Track::fromKeys({from, to})));
    Node before;
    before.id = 2;
    before.kind = NodeKind::Primitive;
    before.name = "Before";
    before.params.primitive.radius = 6.0;
    before.params.primitive.shape = PrimitiveShape::Sphere;
    before.params.tree.translation = {3.0, 0.0, 0.0};
    return Scene::fromNodes({land, before}).value_or(Scene());
}

RenderScene builtAt(const Scene& scene, double seconds)
{
    SceneView view;
    view.timeSeconds = seconds;
    return SceneBuilder().build(
        scene, [](NodeId) { return nullptr; }, view);
}

/// Around the mesh where it is.
Box boxAt(const TriangleMesh& mesh, const glm::dmat4& world)
{
    Box box;
    for (const glm::vec3& position : mesh.positions)
        box.add(glm::dvec3(world * glm::dvec4(glm::dvec3(position), 1.0)));
    return box;
}

/// Every triangle in world space, without any hierarchy.
std::optional<double> bruteForce(const TriangleMesh& mesh, const glm::dmat4& world, const ViewRay& ray)
{
    std::optional<double> nearest;
    for (const glm::uvec3& t : mesh.triangles) {
        glm::dvec3 corner[3];
        for (int c = 0; c < 3; ++c)
            corner[c] = glm::dvec3(world * glm::dvec4(glm::dvec3(mesh.positions[t[c]]), 1.0));
        const glm::dvec3 u = corner[1] - corner[0], v = corner[2] - corner[0];
        const glm::dvec3 p = glm::cross(ray.direction, v);
        const double det = glm::dot(u, p);
        if (det == 0.0)
            continue;
        const glm::dvec3 s = ray.origin - corner[0], q = glm::cross(s, u);
        const double a = glm::dot(s, p) / det, b = glm::dot(ray.direction, q) / det;
        const double at = glm::dot(v, q) / det;
        if (a >= 0.0 && b >= 0.0 && a + b <= 1.0 && at >= 0.0 && (!nearest || at < *nearest))
            nearest = at;
    }
    return nearest;
}

} // namespace

/// The surface of one node under the cursor: what a target is set on.
class TestSurfacePicks : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void whatIsNotThereIsNotMet()
    {
        PickView view;
        view.size = {800.0, 600.0};
        const PickScene empty;
        QVERIFY(!empty.meet(view, {400.0, 300.0}, 1, glm::dmat4(1.0)));
        QVERIFY(!empty.hasSurface(1));
        const RenderScene scene = builtAt(terrainScene(), 0.0);
        const PickScene picks(scene, nullptr);
        view.camera.frame(scene.box, view.aspect());
        QVERIFY(picks.hasSurface(1) && picks.hasSurface(2) && !picks.hasSurface(3));
        QVERIFY(picks.hasSurface(1, scene.meshes[0].mesh.get()));
        QVERIFY(!picks.hasSurface(1, scene.meshes[1].mesh.get()));
        QVERIFY(!picks.meet(view, {400.0, 300.0}, 3, glm::dmat4(1.0)));
        QVERIFY(!picks.meet(view, {400.0, 300.0}, 2, glm::dmat4(0.0))); // flattened
        QVERIFY(picks.meet(view, {400.0, 300.0}, 2, scene.meshes[1].world));
    }

    void randomRaysMeetWhatBruteForceMeets()
    {
        const Scene scene = terrainScene();
        const RenderScene rest = builtAt(scene, 0.0);
        const PickScene picks(rest, nullptr); // of another time: the surface has moved on
        PickView view;
        view.size = {800.0, 600.0};
        Random random(7, RandomStream::Test);
        int hits = 0;
        for (int i = 0; i < 1000; ++i) {
            const double seconds = random.range(0.0, 1.0);
            const glm::dmat4 world = worldTransformAt(scene, 1, seconds).geometry;
            view.camera.orthographic = i % 2 == 1;
            view.camera.yawRad = random.range(-3.0, 3.0);
            view.camera.pitchRad = random.range(-1.4, 1.4);
            view.camera.frame(boxAt(*scene.find(1)->mesh, world), view.aspect());
            const glm::dvec2 pixel(random.range(0.0, 800.0), random.range(0.0, 600.0));
            ViewRay ray = view.camera.ray(view.ndc(pixel), view.aspect());
            if (view.camera.orthographic) // parallel rays begin before everything
                ray.origin -= 1000.0 * ray.direction;
            const auto expected = bruteForce(*scene.find(1)->mesh, world, ray);
            const auto met = picks.meet(view, pixel, 1, world);
            QCOMPARE(met.has_value(), expected.has_value());
            if (!met)
                continue;
            ++hits;
            QVERIFY(glm::distance(*met, ray.origin + *expected * ray.direction) < 1e-5);
        }
        QVERIFY2(hits > 100 && hits < 900, qPrintable(QString::number(hits))); // both happen often
    }
};

RAMURE_SUITE(TestSurfacePicks)

} // namespace tst_surface_picks

#include "tst_surface_picks.moc"
