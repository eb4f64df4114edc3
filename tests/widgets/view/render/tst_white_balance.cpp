#include "tests/support/suite.h"
#include "widgets/view/render/light/white_balance.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace tst_white_balance {

using namespace ramure;

class TestWhiteBalance : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void theUsualOneChangesNothing()
    {
        const glm::dvec3 factors = whiteBalance(usualKelvin);
        for (int i = 0; i < 3; ++i)
            QVERIFY(std::abs(factors[i] - 1.0) < 1e-12);
    }
    void greyKeepsItsLuminanceAndWarmsWithTheNumber()
    {
        double before = 0.0;
        for (double kelvin = leastKelvin; kelvin <= mostKelvin; kelvin += 100.0) {
            const glm::dvec3 factors = whiteBalance(kelvin);
            QVERIFY(std::min({factors.r, factors.g, factors.b}) > 0.1);
            QVERIFY(std::max({factors.r, factors.g, factors.b}) < 10.0);
            QVERIFY(std::abs(glm::dot(factors, glm::dvec3(0.2126, 0.7152, 0.0722)) - 1.0) < 1e-9);
            QVERIFY(factors.r / factors.b > before);
            before = factors.r / factors.b;
        }
    }
    /// Published colours of black bodies (CIE 1931 x, y: 3000 K .4369 .4041, 5000 K .3451 .3516, 10000 K
    /// .2807 .2884), as ratios of linear red to blue against 6500 K.
    void itUndoesTheLightOfBlackBodies()
    {
        const auto ratio = [](double x, double y) {
            const double z = 1.0 - x - y;
            return (3.2406 * x - 1.5372 * y - 0.4986 * z) / (0.0557 * x - 0.2040 * y + 1.0570 * z);
        };
        const double usual = ratio(0.3135, 0.3237);
        for (const auto& [kelvin, x, y] :
             {std::tuple{3000.0, 0.4369, 0.4041}, std::tuple{5000.0, 0.3451, 0.3516},
              std::tuple{10000.0, 0.2807, 0.2884}}) {
            const glm::dvec3 factors = whiteBalance(kelvin);
            const double undone = factors.r / factors.b * ratio(x, y) / usual;
            QVERIFY2(std::abs(undone - 1.0) < 0.03, qPrintable(QString::number(undone)));
        }
    }
};

RAMURE_SUITE(TestWhiteBalance)

} // namespace tst_white_balance

#include "tst_white_balance.moc"
