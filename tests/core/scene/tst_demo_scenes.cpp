#include "core/scene/demo_scenes.h"
#include "core/scene/object_mesh.h"
#include "core/scene/world_transforms.h"
#include "tests/support/suite.h"

#include <cmath>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>

namespace tst_demo_scenes {

using namespace ramure;

namespace {

/// Written by hand from SPEC B3, with nothing of the program in it: plain row-major products.
using Matrix = std::array<double, 16>;

Matrix times(const Matrix& a, const Matrix& b)
{
    Matrix out{};
    for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t c = 0; c < 4; ++c)
            for (std::size_t k = 0; k < 4; ++k)
                out[4 * r + c] += a[4 * r + k] * b[4 * k + c];
    return out;
}

Matrix turnX(double degrees)
{
    const double a = degrees * std::acos(-1.0) / 180.0, c = std::cos(a), s = std::sin(a);
    return {1, 0, 0, 0, 0, c, -s, 0, 0, s, c, 0, 0, 0, 0, 1};
}

Matrix turnY(double degrees)
{
    const double a = degrees * std::acos(-1.0) / 180.0, c = std::cos(a), s = std::sin(a);
    return {c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0, 0, 0, 0, 1};
}

Matrix turnZ(double degrees)
{
    const double a = degrees * std::acos(-1.0) / 180.0, c = std::cos(a), s = std::sin(a);
    return {c, -s, 0, 0, s, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
}

Matrix moved(double x, double y, double z)
{
    return {1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z, 0, 0, 0, 1};
}

Matrix scaled(double x, double y, double z)
{
    return {x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0, 0, 0, 0, 1};
}

double difference(const glm::dmat4& a, const Matrix& b)
{
    double worst = 0.0;
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c)
            worst = std::max(worst, std::abs(a[c][r] - b[static_cast<std::size_t>(4 * r + c)]));
    return worst;
}

constexpr double times5[] = {0.0, 1.25, 2.5, 3.75, 5.0};

} // namespace

class TestDemoScenes : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void unknownNamesAreRefused()
    {
        const auto scene = demoScene("Nothing");
        QVERIFY(!scene);
        QVERIFY(QByteArray::fromStdString(scene.error().message()).contains("MovingTree"));
    }
    void cylinderRollsAlongACircle()
    {
        const Scene scene = *demoScene("MovingCylinder");
        QCOMPARE(scene.nodes().size(), std::size_t(1));
        for (const double t : times5) {
            const double angle = 54.0 * t;
            const NodeTransforms place = worldTransformAt(scene, scene.nodes().front().id, t);
            QVERIFY(difference(place.world, turnY(angle)) < 1e-5);
            QVERIFY(difference(place.geometry, times(turnY(angle), times(moved(0, 0, -5), turnZ(angle)))) <
                    1e-5);
        }
    }
    void treeHasAllItsCylindersInTheirPlaces()
    {
        const Scene scene = *demoScene("MovingTree");
        QCOMPARE(scene.nodes().size(), std::size_t(1365));
        for (const double t : times5) {
            // From 10 degrees at 0 s to none at 2.5 s and back, evenly; 5 s is 0 s again.
            const double looped = std::fmod(t, 5.0), further = 10.0 * std::abs(looped - 2.5) / 2.5;
            const std::vector<NodeTransforms> transforms = worldTransformsAt(scene, t);
            std::size_t seen = 0;
            double worst = 0.0;
            const std::function<void(NodeId, const Matrix&, int)> walk = [&](NodeId id, const Matrix& world,
                                                                             int level) {
                const auto index = static_cast<std::size_t>(std::ranges::find(scene.nodes(), id, &Node::id) -
                                                            scene.nodes().begin());
                worst =
                    std::max({worst, difference(transforms[index].world, world),
                              difference(transforms[index].geometry, times(world, scaled(0.15, 1, 0.15)))});
                ++seen;
                const std::vector<NodeId> children = scene.children(id);
                QCOMPARE(children.size(), std::size_t(level < 5 ? 4 : 0));
                for (std::size_t i = 0; i < children.size(); ++i) {
                    const Matrix turn = times(turnY(35.0 + 90.0 * double(i)), turnX(35.0 + further));
                    walk(children[i], times(world, times(moved(0, 1, 0), times(turn, scaled(.75, .75, .75)))),
                         level + 1);
                }
            };
            walk(scene.nodes().front().id, scaled(1, 1, 1), 0);
            QCOMPARE(seen, std::size_t(1365));
            QVERIFY2(worst < 1e-5, qPrintable(QString::number(worst)));
        }
    }
    void everyCylinderHasTwentySides()
    {
        const Scene scene = *demoScene("MovingTree");
        for (const Node& node : scene.nodes()) {
            QVERIFY(node.kind == NodeKind::Primitive);
            QVERIFY(node.params.primitive.shape == PrimitiveShape::Cylinder);
            QCOMPARE(node.params.primitive.sides, std::int64_t(20));
        }
        const auto mesh = objectSolid(scene.nodes().front(), scene.nodes().front().params);
        QCOMPARE((*mesh)->vertexCount(), Index(2 * 20 + 2));
        QCOMPARE((*mesh)->faceCount(), Index(4 * 20));
    }
};

RAMURE_SUITE(TestDemoScenes)

} // namespace tst_demo_scenes

#include "tst_demo_scenes.moc"
