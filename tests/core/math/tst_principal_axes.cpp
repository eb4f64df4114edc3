#include "core/math/principal_axes.h"
#include "tests/support/suite.h"
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

namespace tst_principal_axes {

using namespace ramure;

class TestPrincipalAxes : public QObject
{
    Q_OBJECT
private slots:
    /// However a box is turned, its edges are found, the longest first.
    void findEdges_data()
    {
        QTest::addColumn<double>("angle");
        for (const double angle : {0.0, 0.3, 1.1, 1.5707963, 2.9})
            QTest::addRow("%g", angle) << angle;
    }
    void findEdges()
    {
        QFETCH(double, angle);
        const glm::dquat turn = glm::angleAxis(angle, glm::normalize(glm::dvec3(1.0, -2.0, 0.5)));
        const glm::dmat3 edges = glm::mat3_cast(turn);
        const glm::dmat3 spread = 1.0 * glm::outerProduct(edges[0], edges[0]) +
                                  9.0 * glm::outerProduct(edges[1], edges[1]) +
                                  4.0 * glm::outerProduct(edges[2], edges[2]);
        const glm::dmat3 axes = principalAxes(spread);
        QVERIFY(std::abs(glm::dot(axes[0], edges[1])) > 1.0 - 1e-12);
        QVERIFY(std::abs(glm::dot(axes[1], edges[2])) > 1.0 - 1e-12);
        QVERIFY(std::abs(glm::dot(axes[2], edges[0])) > 1.0 - 1e-12);
        QVERIFY(std::abs(glm::determinant(axes) - 1.0) < 1e-12);
    }
    /// Points on a line, a single one and a ball have a frame, too.
    void whatHasNoEdges()
    {
        const glm::dvec3 way = glm::normalize(glm::dvec3(1.0, 1.0, -3.0));
        QVERIFY(std::abs(glm::dot(principalAxes(glm::outerProduct(way, way))[0], way)) > 1.0 - 1e-12);
        for (const double size : {0.0, 1.0, 1e-300, 1e100})
            QVERIFY(std::abs(glm::determinant(principalAxes(glm::dmat3(size))) - 1.0) < 1e-12);
    }
};

RAMURE_SUITE(TestPrincipalAxes)

} // namespace tst_principal_axes

#include "tst_principal_axes.moc"
