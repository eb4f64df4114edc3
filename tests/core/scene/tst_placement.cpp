#include "core/math/random.h"
#include "core/scene/scene.h"
#include "tests/support/suite.h"

#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <numbers>

namespace tst_placement {

using namespace ramure;

static double difference(const glm::dmat4& a, const glm::dmat4& b)
{
    double worst = 0.0;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            worst = std::max(worst, std::abs(a[column][row] - b[column][row]));
    return worst;
}

class TestPlacement : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void whatIsNoPlacementIsRefused()
    {
        glm::dmat4 sheared(1.0);
        sheared[1][0] = 0.5;
        QVERIFY(!decomposePlacement(sheared));
        QVERIFY(!decomposePlacement(glm::scale(glm::dmat4(1.0), {1.0, 0.0, 1.0})));
        glm::dmat4 projection(1.0);
        projection[2][3] = -1.0;
        QVERIFY(!decomposePlacement(projection));
        glm::dmat4 broken(1.0);
        broken[3][0] = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(!decomposePlacement(broken));
    }
    void matrixIsTimesRotationTimesScale()
    {
        Random random(7, RandomStream::Test);
        for (int i = 0; i < 200; ++i) {
            PlacementParams p;
            for (int k = 0; k < 3; ++k) {
                p.translation[k] = random.range(-9.0, 9.0);
                p.rotation[k] = random.range(-7.0, 7.0);
                p.scale[k] = random.range(-3.0, 3.0);
            }
            glm::dmat4 expected = glm::translate(glm::dmat4(1.0), p.translation);
            expected = glm::rotate(expected, p.rotation.z, {0.0, 0.0, 1.0});
            expected = glm::rotate(expected, p.rotation.y, {0.0, 1.0, 0.0});
            expected = glm::rotate(expected, p.rotation.x, {1.0, 0.0, 0.0});
            expected = glm::scale(expected, p.scale);
            QVERIFY(difference(placementMatrix(p), expected) < 1e-12);
            const auto back = decomposePlacement(expected);
            QVERIFY2(back, test::why(back));
            QVERIFY(difference(placementMatrix(*back), expected) < 1e-12);
        }
    }
    void quarterTurnAboutY()
    {
        for (const double y : {std::numbers::pi / 2, -std::numbers::pi / 2}) {
            PlacementParams p;
            p.rotation = {0.7, y, 1.1};
            const auto back = decomposePlacement(placementMatrix(p));
            QVERIFY(back);
            QVERIFY(difference(placementMatrix(*back), placementMatrix(p)) < 1e-9);
        }
    }
    void worldIsParentTimesOwn()
    {
        Scene scene;
        Node group, tree;
        group.id = 1;
        group.params.tree.translation = {1.0, 2.0, 3.0};
        group.params.tree.scale = glm::dvec3(2.0);
        tree.id = 2;
        tree.parent = 1;
        tree.params.tree.translation = {10.0, 0.0, 0.0};
        QVERIFY(scene.insert({group, tree}, noNode, 0));
        const glm::dvec4 origin = worldMatrix(scene, 2) * glm::dvec4(0.0, 0.0, 0.0, 1.0);
        QVERIFY(glm::length(glm::dvec3(origin) - glm::dvec3(21.0, 2.0, 3.0)) < 1e-12);
        QVERIFY(worldMatrix(scene, 77) == glm::dmat4(1.0));
    }
};

RAMURE_SUITE(TestPlacement)

} // namespace tst_placement

#include "tst_placement.moc"
