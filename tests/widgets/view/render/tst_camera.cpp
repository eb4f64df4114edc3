#include "core/math/random.h"
#include "tests/support/suite.h"
#include "widgets/view/render/camera.h"
#include <cmath>
#include <numbers>

namespace tst_camera {

using namespace ramure;

namespace {

constexpr double pi = std::numbers::pi;

Camera randomCamera(Random& random)
{
    Camera camera;
    camera.target = {random.range(-5.0, 5.0), random.range(-5.0, 5.0), random.range(-5.0, 5.0)};
    camera.distance = std::exp(random.range(-3.0, 5.0));
    camera.yawRad = random.range(-pi, pi);
    camera.pitchRad = random.range(-0.5 * pi, 0.5 * pi);
    camera.orthographic = random.below(2) == 1;
    return camera;
}

double distanceToRay(const ViewRay& ray, const glm::dvec3& point)
{
    return glm::length(glm::cross(point - ray.origin, ray.direction));
}

} // namespace

class TestCamera : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void emptyBoxChangesNothing()
    {
        Camera camera;
        const Camera before = camera;
        camera.frame(Box(), 1.5);
        QCOMPARE(camera, before);
        const DepthRange range = camera.depthRange(Box());
        QVERIFY(range.near > 0.0 && range.far > range.near);
    }
    void axesAreOrthonormalEverywhere()
    {
        Random random(1, RandomStream::Test);
        for (int i = 0; i < 500; ++i) {
            Camera camera = randomCamera(random);
            if (i % 5 == 0)
                camera.pitchRad = (i % 2 == 0 ? 0.5 : -0.5) * pi;
            QVERIFY(std::abs(glm::dot(camera.right(), camera.up())) < 1e-14);
            QVERIFY(std::abs(glm::length(camera.up()) - 1.0) < 1e-14);
            QVERIFY(glm::length(glm::cross(camera.right(), camera.up()) - camera.backward()) < 1e-14);
        }
    }
    void axisViews()
    {
        Camera camera;
        const std::vector<std::pair<AxisView, glm::dvec3>> views = {
            {AxisView::Front, {0, 0, 1}}, {AxisView::Back, {0, 0, -1}}, {AxisView::Right, {1, 0, 0}},
            {AxisView::Left, {-1, 0, 0}}, {AxisView::Top, {0, 1, 0}},   {AxisView::Bottom, {0, -1, 0}}};
        for (const auto& [view, towardsEye] : views) {
            camera.setAxisView(view);
            QVERIFY(glm::length(camera.backward() - towardsEye) < 1e-15);
        }
        camera.setAxisView(AxisView::Top);
        QVERIFY(glm::length(camera.up() - glm::dvec3(0, 0, -1)) < 1e-15);
    }
    void rayAndProjectAreInverse()
    {
        Random random(2, RandomStream::Test);
        for (int i = 0; i < 1000; ++i) {
            Camera camera = randomCamera(random);
            camera.shift = {random.range(-0.5, 0.5), random.range(-0.5, 0.5)};
            const double aspect = random.range(0.3, 3.0);
            const glm::dvec2 ndc(random.range(-1.0, 1.0), random.range(-1.0, 1.0));
            const ViewRay ray = camera.ray(ndc, aspect);
            const glm::dvec3 point = ray.origin + random.range(0.2, 30.0) * ray.direction;
            const auto back = camera.project(point, aspect);
            QVERIFY(back);
            QVERIFY(glm::length(*back - ndc) < 1e-9);
        }
    }
    void projectAgreesWithTheMatrices()
    {
        Random random(3, RandomStream::Test);
        for (int i = 0; i < 1000; ++i) {
            Camera camera = randomCamera(random);
            camera.shift = {random.range(-0.5, 0.5), random.range(-0.5, 0.5)};
            const glm::dvec3 point =
                camera.target +
                0.3 * camera.distance *
                    glm::dvec3(random.range(-1.0, 1.0), random.range(-1.0, 1.0), random.range(-1.0, 1.0));
            Box box;
            box.add(point);
            box.add(camera.target);
            const glm::dmat4 both =
                camera.projectionMatrix(1.6, camera.depthRange(box)) * camera.viewMatrix();
            const glm::dvec4 clip = both * glm::dvec4(point, 1.0);
            QVERIFY(glm::length(glm::dvec2(clip) / clip.w - *camera.project(point, 1.6)) < 1e-9);
            QVERIFY2(std::abs(clip.z / clip.w) <= 1.0, "inside the near and far planes");
        }
    }
    void behindTheEyeIsNowhere()
    {
        Camera camera;
        QVERIFY(!camera.project(camera.eye(), 1.0));
        QVERIFY(!camera.project(camera.eye() + camera.backward(), 1.0));
    }
    void zoomKeepsThePointUnderTheCursor()
    {
        Random random(4, RandomStream::Test);
        for (int i = 0; i < 1000; ++i) {
            Camera camera = randomCamera(random);
            const glm::dvec2 ndc(random.range(-1.0, 1.0), random.range(-1.0, 1.0));
            const glm::dvec3 fixed = camera.pointAtTargetDepth(ndc, 1.3);
            camera.zoom(random.range(0.3, 3.0), fixed);
            QVERIFY(glm::length(*camera.project(fixed, 1.3) - ndc) < 1e-9);
        }
    }
    void zoomHasLimits()
    {
        Camera camera;
        for (int i = 0; i < 400; ++i)
            camera.zoom(0.5, camera.target);
        QVERIFY(camera.distance > 0.0);
        for (int i = 0; i < 400; ++i)
            camera.zoom(2.0, camera.target);
        QVERIFY(camera.distance <= 1e6);
    }
    void panMovesTheTargetByTheCursor()
    {
        Random random(5, RandomStream::Test);
        for (int i = 0; i < 200; ++i) {
            Camera camera = randomCamera(random);
            const glm::dvec3 held = camera.target;
            const glm::dvec2 delta(random.range(-0.5, 0.5), random.range(-0.5, 0.5));
            camera.pan(delta, 1.4);
            QVERIFY(glm::length(*camera.project(held, 1.4) - delta) < 1e-9);
        }
    }
    void allAroundNothingLeavesThePicture()
    {
        Random random(7, RandomStream::Test);
        for (int round = 0; round < 40; ++round) {
            std::vector<glm::dvec3> points; // a crown to one side of its trunk
            for (int i = 0; i < 300; ++i)
                points.emplace_back(random.range(-1.0, 3.0), random.range(0.0, 5.0), random.range(-0.4, 0.9));
            Camera camera = randomCamera(random);
            camera.pitchRad = random.range(-0.4, 0.9);
            const Camera before = camera;
            const double aspect = random.range(0.6, 2.0);
            camera.frameAllAround(points, aspect);
            QCOMPARE(camera.yawRad, before.yawRad);
            QCOMPARE(camera.pitchRad, before.pitchRad);
            double widest = 0.0;
            for (int turn = 0; turn < 90; ++turn) {
                Camera turned = camera;
                turned.yawRad += 2.0 * pi * turn / 90.0;
                for (const glm::dvec3& point : points) {
                    const auto at = turned.project(point, aspect);
                    QVERIFY(at);
                    widest = std::max({widest, std::abs(at->x), std::abs(at->y)});
                }
            }
            QVERIFY2(widest <= 1.0 && widest > 0.75, qPrintable(QString::number(widest)));
        }
    }
    void orbitKeepsTargetAndStopsAtThePoles()
    {
        Camera camera;
        const glm::dvec3 target = camera.target;
        camera.orbit(100.0, 100.0);
        QCOMPARE(camera.target, target);
        QVERIFY(camera.yawRad > -pi && camera.yawRad <= pi);
        QCOMPARE(camera.pitchRad, 0.5 * pi);
    }
    void framedBoxIsInsideAndFillsThePicture()
    {
        Random random(6, RandomStream::Test);
        for (int i = 0; i < 1000; ++i) {
            Camera camera = randomCamera(random);
            const double scale = std::exp(random.range(-2.0, 4.0));
            Box box;
            for (int k = 0; k < 2; ++k)
                box.add(scale * glm::dvec3(random.range(-1.0, 1.0), random.range(-1.0, 1.0),
                                           random.range(-1.0, 1.0)));
            const double aspect = random.range(0.4, 2.5);
            camera.frame(box, aspect);
            double widest = 0.0;
            for (int k = 0; k < 8; ++k) {
                const auto at = camera.project(box.corner(k), aspect);
                QVERIFY(at);
                widest = std::max({widest, std::abs(at->x), std::abs(at->y)});
            }
            QVERIFY2(widest <= 1.0 && widest > 0.6, qPrintable(QString::number(widest)));
        }
    }
    void framedPointsAreCentred()
    {
        Random random(16, RandomStream::Test);
        for (int i = 0; i < 300; ++i) {
            Camera camera = randomCamera(random);
            std::vector<glm::dvec3> points;
            for (int k = 0; k < 40; ++k)
                points.emplace_back(random.range(-1.0, 3.0), random.range(0.0, 5.0), random.range(-1.0, 0.5));
            const double aspect = random.range(0.4, 2.5);
            camera.frame(points, aspect);
            glm::dvec2 low(9.0);
            glm::dvec2 high(-9.0);
            for (const glm::dvec3& point : points) {
                const auto at = camera.project(point, aspect);
                QVERIFY(at);
                low = glm::min(low, *at);
                high = glm::max(high, *at);
            }
            QVERIFY(glm::length(low + high) < 0.02);
            QVERIFY(std::max(high.x, high.y) > 0.85 && std::max(high.x, high.y) < 0.95);
        }
    }
    void framingAPointGivesAPicture()
    {
        Camera camera;
        Box box;
        box.add(glm::dvec3(1.0, 2.0, 3.0));
        camera.frame(box, 1.0);
        QCOMPARE(camera.target, glm::dvec3(1.0, 2.0, 3.0));
        QVERIFY(camera.distance > 0.01 && camera.distance < 10.0);
    }
    void depthRangeHoldsTheBox()
    {
        Random random(7, RandomStream::Test);
        for (int i = 0; i < 500; ++i) {
            const Camera camera = randomCamera(random);
            Box box;
            box.add(glm::dvec3(random.range(-9.0, 9.0)));
            box.add(glm::dvec3(random.range(-9.0, 9.0), 0.0, 3.0));
            const DepthRange range = camera.depthRange(box);
            QVERIFY(range.near < range.far);
            QVERIFY(camera.orthographic || range.near > 0.0);
            for (int k = 0; k < 8; ++k) {
                const double depth = -glm::dot(box.corner(k) - camera.eye(), camera.backward());
                QVERIFY(depth <= range.far);
                QVERIFY(depth >= range.near || (!camera.orthographic && range.near < 3e-4 * range.far));
            }
        }
    }
    void mixedTakesTheShortWay()
    {
        Camera from;
        Camera to;
        from.yawRad = 3.0;
        to.yawRad = -3.0;
        from.distance = 1.0;
        to.distance = 100.0;
        QCOMPARE(mixed(from, to, 1.0), to);
        const Camera half = mixed(from, to, 0.5);
        QVERIFY(std::abs(half.yawRad) > 3.1);
        QVERIFY(std::abs(half.distance - 10.0) < 1e-9);
    }
    void metresPerPixelMatchesProjection()
    {
        Random random(8, RandomStream::Test);
        for (int i = 0; i < 200; ++i) {
            const Camera camera = randomCamera(random);
            const double size = camera.metresPerPixel(camera.target, 600.0);
            const auto at = camera.project(camera.target + size * camera.up(), 1.5);
            QVERIFY(std::abs(at->y * 300.0 - 1.0) < 1e-9);
            QVERIFY(distanceToRay(camera.ray({0.0, 0.0}, 1.5), camera.target) <
                    1e-9 * (1.0 + camera.distance));
        }
    }
};

RAMURE_SUITE(TestCamera)

} // namespace tst_camera

#include "tst_camera.moc"
