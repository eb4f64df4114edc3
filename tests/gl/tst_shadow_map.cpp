#include "widgets/view/render/passes/shadow_map.h"

#include "tests/support/cannot_run.h"
#include "tests/support/suite.h"
#include "widgets/view/render/passes/gl_setup.h"
#include "widgets/view/render/passes/offscreen_renderer.h"
#include <QApplication>

namespace tst_shadow_map {

using namespace ramure;

namespace {

constexpr int side = 200;

/// Level, its texture from 0 to 1 along X and Z.
MeshItem plate(const glm::vec3& middle, float half)
{
    auto mesh = std::make_shared<TriangleMesh>();
    for (const auto& [x, z] : {std::pair{-1.0f, -1.0f}, {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}}) {
        mesh->positions.push_back(middle + half * glm::vec3(x, 0.0f, z));
        mesh->normals.emplace_back(0.0f, 1.0f, 0.0f);
        mesh->uv.emplace_back(0.5f * (x + 1.0f), 0.5f * (z + 1.0f));
    }
    mesh->triangles = {{0, 2, 1}, {0, 3, 2}};
    MeshItem item;
    item.box = meshBox(*mesh);
    item.mesh = std::move(mesh);
    item.material.twoSided = true;
    return item;
}

/// From above at one place on the ground; plates are a metre above it and their shadows a metre beside.
class Picture
{
public:
    Picture(RenderScene scene, const glm::dvec3& place, double height, Quality quality)
    {
        scene.updateBoxes();
        m_camera.target = place;
        m_camera.pitchRad = 1.5707963267948966;
        m_camera.yawRad = 0.0;
        m_camera.distance = height;
        RenderOptions options;
        options.quality = quality;
        options.light.azimuthDeg = 90.0;
        options.light.heightDeg = 45.0;
        options.light.backdrop = Backdrop::LightStudio;
        auto image = renderImage(scene, m_camera, {side, side}, options);
        if (!image)
            qWarning("%s", image.error().message().c_str());
        m_image = image ? *image : QImage();
    }
    [[nodiscard]] int lightAt(double x, double z) const
    {
        const glm::dvec2 ndc = *m_camera.project({x, 0.0, z}, 1.0);
        return m_image.pixelColor(int(0.5 * (ndc.x + 1.0) * side), int(0.5 * (1.0 - ndc.y) * side))
            .lightness();
    }

private:
    Camera m_camera;
    QImage m_image;
};

} // namespace

class TestShadowMap : public QObject
{
    Q_OBJECT
public:
    static void initMain() { prepareOpenGl(); }
private slots:
    void initTestCase()
    {
        const OpenGlProbe probe = probeOpenGl();
        if (!probe.available)
            RAMURE_CANNOT_RUN(qPrintable(probe.reason));
    }
    void init() { test::failOnAnyWarning(); }

    void theFocusKeepsTheDepthOfAll()
    {
        Box casters;
        casters.add({-50.0, 0.0, -50.0});
        casters.add({50.0, 20.0, 50.0});
        const glm::dvec3 sun = glm::normalize(glm::dvec3(1.0, 1.0, 0.3));
        const ShadowFit all = fitShadow(casters, sun, ShadowMap::size);
        const ShadowFit near = fitShadow(casters, sun, ShadowFocus{{3.0, 1.0, 2.0}, 2.0});
        QCOMPARE(near.side, 4.0);
        QVERIFY(near.side < 0.1 * all.side);
        const glm::dvec4 middle = near.clip * glm::dvec4(3.0, 1.0, 2.0, 1.0);
        QVERIFY(std::abs(middle.x) < 1e-9 && std::abs(middle.y) < 1e-9);
        for (int i = 0; i < 8; ++i) // whatever throws a shadow into the place is in its depth
            QVERIFY(std::abs((near.clip * glm::dvec4(casters.corner(i), 1.0)).z) <= 1.0);
    }
    void whatIsNearHasFineShadows()
    {
        RenderScene scene;
        scene.meshes = {plate({0.0f, 1.0f, 0.0f}, 0.1f), plate({-400.0f, 1.0f, 0.0f}, 1.0f),
                        plate({400.0f, 1.0f, 0.0f}, 1.0f)};
        const Picture good(scene, {-1.0, 0.0, 0.0}, 2.5, Quality::Good);
        const int open = good.lightAt(-1.5, 0.0);
        QVERIFY(good.lightAt(-1.0, 0.0) < open - 40);
        for (const double beside : {-0.3, 0.3})
            QVERIFY(std::abs(good.lightAt(-1.0, beside) - open) <= 3);
        // As the shadow of one map alone does not.
        const Picture draft(scene, {-1.0, 0.0, 0.0}, 2.5, Quality::Draft);
        QVERIFY(draft.lightAt(-1.0, 0.0) > draft.lightAt(-1.0, 0.3) - 40 ||
                draft.lightAt(-1.0, 0.3) < draft.lightAt(-1.6, 0.8) - 3);
    }
    void whatAPictureCutsOutThrowsNoShadow()
    {
        auto images = std::make_shared<SurfaceImages>();
        images->size = 64;
        images->isCut = true;
        for (int i = 0; i < 64 * 64; ++i) {
            images->colour.emplace_back(120, 160, 80, i % 64 < 32 ? 0 : 255);
            images->normal.emplace_back(128, 128, 255, 128);
        }
        RenderScene scene;
        scene.meshes = {plate({0.0f, 1.0f, 0.0f}, 0.5f)};
        for (const bool isCut : {false, true}) {
            if (isCut)
                scene.meshes.front().images = images;
            const Picture seen(scene, {-1.0, 0.0, 0.0}, 6.0, Quality::Good);
            const int open = seen.lightAt(-1.8, 0.0);
            QVERIFY(seen.lightAt(-0.75, 0.0) < open - 40);
            QCOMPARE(seen.lightAt(-1.25, 0.0) < open - 40, !isCut);
        }
    }
};

RAMURE_SUITE(TestShadowMap)

} // namespace tst_shadow_map

#include "tst_shadow_map.moc"
