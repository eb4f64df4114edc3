#include "core/surface/season/leaf_pigments.h"

#include "tests/support/colour_difference.h"
#include "tests/support/suite.h"
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <optional>

namespace tst_leaf_pigments {

using namespace ramure;

namespace {

/// Colours that leaves have in nature, sRGB reflected and transmitted.
struct Known
{
    const char* name;
    Pigments pigments;
    glm::vec3 reflected;
    std::optional<glm::vec3> transmitted;
};

const std::array known{
    Known{"an oak in summer", {45, 10, 1, 0}, {72, 92, 52}, glm::vec3(60, 83, 0)},
    Known{"young", {17.5F, 4.7F, 2.9F, 0}, {99, 99, 53}, glm::vec3(116, 112, 9)},
    Known{"evergreen", {70, 15, 0.2F, 0}, {63, 85, 53}, glm::vec3(35, 62, 0)},
    Known{"early autumn", {15, 10, 0.3F, 0}, {122, 118, 48}, {}},
    Known{"yellow", {2, 7, 0, 0}, {181, 147, 49}, glm::vec3(180, 141, 0)},
    Known{"orange", {2, 7, 6, 0}, {156, 99, 54}, glm::vec3(154, 90, 1)},
    Known{"red", {2, 7, 25, 0}, {120, 60, 57}, glm::vec3(118, 31, 6)},
    Known{"a purple beech", {35, 9, 30, 0}, {67, 57, 57}, glm::vec3(60, 22, 0)},
    Known{"brown", {2.9F, 3, 3.7F, 0.67F}, {138, 104, 73}, glm::vec3(124, 84, 41)},
    Known{"litter", {4.7F, 0.3F, 4, 0.9F}, {115, 92, 75}, {}},
};

glm::vec3 linear(const glm::vec3& srgb)
{
    glm::vec3 out;
    for (int i = 0; i < 3; ++i) {
        const float c = srgb[i] / 255.0F;
        out[i] = c <= 0.04045F ? c / 12.92F : std::pow((c + 0.055F) / 1.055F, 2.4F);
    }
    return out;
}

} // namespace

class TestLeafPigments : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void amountsThatNoLeafHoldsAreHeld()
    {
        const float nan = std::numeric_limits<float>::quiet_NaN(),
                    inf = std::numeric_limits<float>::infinity();
        const glm::vec3 none = pigmentColours({}).reflected;
        QCOMPARE(pigmentColours({-1, nan, -inf, -3}).reflected, none);
        QCOMPARE(pigmentColours({inf, 1e9F, inf, 1e9F}).reflected,
                 pigmentColours({150, 25, 50, 4}).reflected);
        for (const Pigments& each : {Pigments{}, Pigments{150, 25, 50, 4}})
            for (const glm::vec3& colour : {pigmentColours(each).reflected, pigmentColours(each).transmitted})
                for (int i = 0; i < 3; ++i)
                    QVERIFY(colour[i] >= 0.0F && colour[i] <= 255.0F);
    }

    void theDifferenceOfColoursIsThatOfThePaper()
    {
        // Sharma, Wu, Dalal, "The CIEDE2000 color-difference formula", 2005, table 1.
        const auto near = [](double a, double b) { return std::abs(a - b) < 1e-4; };
        QVERIFY(near(test::deltaE00({50, 2.6772, -79.7751}, {50, 0, -82.7485}), 2.0425));
        QVERIFY(near(test::deltaE00({50, 2.5, 0}, {73, 25, -18}), 27.1492));
        QVERIFY(near(test::deltaE00({60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}), 1.2644));
        QVERIFY(near(test::deltaE00({2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}), 0.9082));
    }

    void leavesHaveTheirColours_data()
    {
        QTest::addColumn<int>("row");
        for (std::size_t i = 0; i < known.size(); ++i)
            QTest::addRow("%s", known[i].name) << int(i);
    }
    void leavesHaveTheirColours()
    {
        QFETCH(const int, row);
        const Known& leaf = known[std::size_t(row)];
        const LeafColours made = pigmentColours(leaf.pigments);
        const double seen = test::deltaE00(test::labOf(made.reflected), test::labOf(leaf.reflected));
        const double through =
            leaf.transmitted ? test::deltaE00(test::labOf(made.transmitted), test::labOf(*leaf.transmitted))
                             : 0.0;
        qInfo("reflected %3.0f %3.0f %3.0f, dE00 %.2f; transmitted %3.0f %3.0f %3.0f, dE00 %.2f",
              double(made.reflected.r), double(made.reflected.g), double(made.reflected.b), seen,
              double(made.transmitted.r), double(made.transmitted.g), double(made.transmitted.b), through);
        QVERIFY(seen <= 6.0 && through <= 6.0);
    }

    /// What shaders make of the colour that is seen.
    void whatShinesThroughFollowsFromWhatIsSeen()
    {
        for (const Known& leaf : known) {
            const LeafColours made = pigmentColours(leaf.pigments);
            const glm::vec3 light =
                passedOn * glm::max(linear(made.reflected) - surfaceSheen, glm::vec3(0.0F));
            QVERIFY(test::deltaE00(test::labOfLight(light), test::labOf(made.transmitted)) < 5.0);
        }
    }

    /// Brighter, in the same order and of the same hue.
    void photographsKeepHueAndOrder()
    {
        const auto hue = [](const glm::dvec3& lab) {
            return std::atan2(lab.z, lab.y) * 180.0 / 3.14159265358979;
        };
        QVERIFY(photographed({}).reflected == glm::vec3(0.0F));
        for (const Known& leaf : known) {
            const LeafColours made = pigmentColours(leaf.pigments), shown = photographed(made);
            const glm::dvec3 seen = test::labOf(made.reflected), photo = test::labOf(shown.reflected);
            QVERIFY(photo.x > seen.x && photo.x < 90.0);
            QVERIFY2(std::abs(hue(photo) - hue(seen)) < 25.0, leaf.name);
            for (const Known& other : known)
                if (test::labOf(pigmentColours(other.pigments).reflected).x > seen.x + 5.0)
                    QVERIFY(test::labOf(photographed(pigmentColours(other.pigments)).reflected).x > photo.x);
        }
    }

    void morePigmentsLetLessLightOut()
    {
        const auto brightness = [](const glm::vec3& colour) { return test::labOf(colour).x; };
        for (int which = 0; which < 4; ++which) {
            double seen = 1e9, through = 1e9;
            for (float share = 0.0F; share <= 1.0F; share += 0.125F) {
                const LeafColours made =
                    pigmentColours({which == 0 ? 150 * share : 5, which == 1 ? 25 * share : 2,
                                    which == 2 ? 50 * share : 0, which == 3 ? 4 * share : 0});
                QVERIFY(brightness(made.reflected) <= seen && brightness(made.transmitted) <= through);
                seen = brightness(made.reflected);
                through = brightness(made.transmitted);
            }
        }
    }
};

RAMURE_SUITE(TestLeafPigments)

} // namespace tst_leaf_pigments

#include "tst_leaf_pigments.moc"
