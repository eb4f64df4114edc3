#include "tests/support/suite.h"
#include "widgets/view/render/light/sky.h"
#include "widgets/view/render/passes/picture_light.h"
#include "widgets/view/render/passes/sky_picture.h"
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace tst_sky {

using namespace ramure;

namespace {

const glm::dvec3 luminance(0.2126, 0.7152, 0.0722);

double bright(const glm::dvec3& colour)
{
    return glm::dot(luminance, colour);
}

glm::dvec3 towards(double azimuthDeg, double heightDeg)
{
    return SceneLight{azimuthDeg, heightDeg}.sun();
}

} // namespace

class TestSky : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnAnyWarning(); }
    void aFolderThatIsNotThereIsNamed()
    {
        const auto saved = saveSkyPicture({}, 16, "/nowhere/sky.hdr");
        QVERIFY(!saved);
        QCOMPARE(saved.error().code, ErrorCode::Io);
        QCOMPARE(saved.error().file, std::string("/nowhere/sky.hdr"));
    }
    void everySkyIsLight()
    {
        for (double turbidity = Sky::leastTurbidity; turbidity <= Sky::mostTurbidity; turbidity += 1.0)
            for (double height = SceneLight::leastHeightDeg; height <= 90.0; height += 4.0) {
                const Sky sky = clearSky(towards(40.0, height), turbidity);
                QVERIFY(sky.sunlight.r > 0.0 && sky.sunlight.r >= sky.sunlight.b * 0.8);
                for (double y = -10.0; y <= 90.0; y += 5.0)
                    for (double around = 0.0; around < 360.0; around += 30.0) {
                        const glm::dvec3 light = sky.radiance(towards(around, y));
                        for (int i = 0; i < 3; ++i)
                            QVERIFY(std::isfinite(light[i]) && light[i] >= 0.0);
                        QVERIFY(bright(light) > 0.0);
                    }
            }
    }
    /// Klx on a level surface from the sky, and on one that faces the sun, on days like this.
    void itIsAsBrightAsADay()
    {
        const Sky sky = clearSky(towards(0.0, 45.0), 3.0);
        const Ambient ambient = ambientOf(sky, glm::dvec3(0.0));
        const double level = std::numbers::pi * bright(glm::dvec3(ambientAt(ambient, {0.0f, 1.0f, 0.0f})));
        QVERIFY2(level > 8.0 && level < 35.0, qPrintable(QString::number(level)));
        const double sun = bright(sky.sunlight);
        QVERIFY2(sun > 60.0 && sun < 110.0, qPrintable(QString::number(sun)));
        QVERIFY(bright(sky.radiance(towards(0.0, 50.0))) > 2.0 * bright(sky.radiance(towards(180.0, 50.0))));
    }
    void upAboveItIsBlueAndALowSunIsWarm()
    {
        const Sky noon = clearSky(towards(0.0, 60.0), 2.5);
        const glm::dvec3 north = noon.radiance(towards(180.0, 60.0));
        QVERIFY(north.b > 1.5 * north.r);
        const Sky evening = clearSky(towards(0.0, 5.0), 2.5);
        QVERIFY(evening.sunlight.r > 2.0 * evening.sunlight.b);
        QVERIFY(bright(evening.sunlight) < 0.5 * bright(noon.sunlight));
    }
    /// The nine numbers against the integral they stand for.
    void ambientLightIsThatOfTheWholeSky()
    {
        const Sky sky = clearSky(towards(120.0, 35.0), 3.0);
        const glm::dvec3 ground(0.5, 0.8, 0.3);
        const Ambient ambient = ambientOf(sky, ground);
        for (const glm::dvec3 normal : {glm::dvec3(0, 1, 0), glm::dvec3(0, -1, 0), glm::dvec3(1, 0, 0),
                                        glm::dvec3(0, 0, -1), glm::normalize(glm::dvec3(-1, 2, 0.5))}) {
            glm::dvec3 sum(0.0);
            constexpr int rings = 200, spokes = 200;
            for (int i = 0; i < rings; ++i)
                for (int j = 0; j < spokes; ++j) {
                    const double y = (i + 0.5) * 2.0 / rings - 1.0, out = std::sqrt(1.0 - y * y);
                    const double turn = 2.0 * std::numbers::pi * j / spokes;
                    const glm::dvec3 way(out * std::cos(turn), y, out * std::sin(turn));
                    const glm::dvec3 light = y > 0.0 ? sky.radiance(way) : ground;
                    sum += std::max(glm::dot(normal, way), 0.0) * light * (4.0 / (rings * spokes));
                }
            const double error = std::abs(bright(glm::dvec3(ambientAt(ambient, normal))) / bright(sum) - 1.0);
            QVERIFY2(error < 0.06, qPrintable(QString::number(error)));
        }
    }
    void lightFromAboveAndBelowIsWhatItWas()
    {
        const glm::vec3 above(0.3f, 0.4f, 0.5f), below(0.2f, 0.1f, 0.05f);
        const Ambient ambient = ambientOf(above, below);
        for (const float y : {-1.0f, -0.3f, 0.0f, 0.8f, 1.0f}) {
            const glm::vec3 normal(std::sqrt(1.0f - y * y), y, 0.0f);
            const glm::vec3 expected = below + (above - below) * (0.5f + 0.5f * y);
            QVERIFY(glm::distance(ambientAt(ambient, normal), expected) < 1e-6f);
        }
    }
    void aPictureOfItHasItsNumbers()
    {
        QTemporaryDir folder;
        const SceneLight light{90.0, 30.0, Backdrop::Sky};
        const std::string path = folder.filePath("sky.hdr").toStdString();
        constexpr int width = 64;
        QVERIFY(saveSkyPicture(light, width, path));
        QFile file(QString::fromStdString(path));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray bytes = file.readAll();
        QVERIFY(bytes.startsWith("#?RADIANCE\n"));
        const qsizetype start = bytes.indexOf("-Y 32 +X 64\n") + 12;
        QCOMPARE(bytes.size() - start, qsizetype(4 * width * width / 2));
        const auto at = [&](int x, int y) {
            const auto* p =
                reinterpret_cast<const unsigned char*>(bytes.constData()) + start + 4 * (y * width + x);
            return glm::dvec3(p[0] + 0.5, p[1] + 0.5, p[2] + 0.5) * std::ldexp(1.0, p[3] - 136);
        };
        // The east is in the middle, the west at the edges.
        QVERIFY(bright(at(width / 2, 10)) > 3.0 * bright(at(0, 10)));
        const glm::dvec3 ground = lightOf(light).radiance({0.0, -1.0, 0.0});
        QVERIFY(glm::distance(at(5, 31), ground) < 0.02 * glm::length(ground));
    }
};

RAMURE_SUITE(TestSky)

} // namespace tst_sky

#include "tst_sky.moc"
