#include "core/io/exr_file.h"
#include "core/math/angle.h"
#include "tests/support/suite.h"
#include "widgets/view/render/light/picture_sky.h"
#include "widgets/view/render/passes/picture_light.h"
#include "widgets/view/render/passes/sky_picture.h"
#include <QFile>
#include <QTemporaryDir>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

namespace tst_picture_sky {

using namespace ramure;

namespace {

double bright(const glm::dvec3& colour)
{
    return glm::dot(glm::dvec3(0.2126, 0.7152, 0.0722), colour);
}

double apartDeg(const glm::dvec3& a, const glm::dvec3& b)
{
    return std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0)) / oneDegree;
}

} // namespace

class TestPictureSky : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    Expected<std::shared_ptr<const PictureSky>>
    skyOf(int width, int height, const std::function<glm::vec3(const glm::dvec3&)>& radiance)
    {
        std::vector<glm::vec4> pixels;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                pixels.emplace_back(radiance(directionInPicture({(x + 0.5) / width, (y + 0.5) / height})),
                                    1.0f);
        const std::string path = m_folder.filePath("sky.exr").toStdString();
        if (!writeExr(path, width, height, pixels))
            qFatal("no file");
        return readPictureSky(path);
    }

private slots:
    void init() { test::failOnAnyWarning(); }
    void badPicturesAreRefused()
    {
        const auto grey = [](const glm::dvec3&) { return glm::vec3(0.5f); };
        for (const auto& [width, height] : {std::pair(1, 1), {16, 16}, {32, 17}, {16, 32}}) {
            const auto read = skyOf(width, height, grey);
            QVERIFY(!read);
            QCOMPARE(read.error().code, ErrorCode::Invalid);
            QVERIFY(read.error().message().find("twice as wide") != std::string::npos);
            QVERIFY(read.error().message().find("sky.exr") != std::string::npos);
        }
        const auto small = skyOf(2, 1, grey);
        QVERIFY(!small);
        QCOMPARE(small.error().code, ErrorCode::Limit);
        const auto black = skyOf(32, 16, [](const glm::dvec3&) { return glm::vec3(0.0f); });
        QVERIFY(!black);
        QVERIFY(black.error().message().find("black") != std::string::npos);
        QVERIFY(!readPictureSky(m_folder.filePath("none.exr").toStdString()));
    }
    void theWidestIsKeptInHalf_data()
    {
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("kept");
        QTest::newRow("widest") << 16384 << 8192;
        QTest::newRow("too wide") << 32768 << 0;
    }
    void theWidestIsKeptInHalf()
    {
        QFETCH(int, width);
        QFETCH(int, kept);
        QFile file(m_folder.filePath("wide.hdr"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + QByteArray::number(width / 2) + " +X " +
                   QByteArray::number(width) + "\n");
        QByteArray row("\2\2", 2);
        row += char(width >> 8);
        row += char(width & 255);
        for (int i = 0; i < 4; ++i)
            for (int x = 0; x < width; x += 64)
                row += QByteArray("\xc0\x80", 2);
        for (int y = 0; y < width / 2; ++y)
            file.write(row);
        file.close();
        const auto read = readPictureSky(file.fileName().toStdString());
        QCOMPARE(bool(read), kept > 0);
        if (!read) {
            QCOMPARE(read.error().code, ErrorCode::Limit);
            return;
        }
        QCOMPARE((*read)->width, kept);
        QCOMPARE((*read)->pixels.size(), std::size_t(kept) * std::size_t(kept / 2));
        QCOMPARE((*read)->pixels.front(), (*read)->pixels.back());
        QVERIFY(glm::distance((*read)->rest.front(), glm::dvec3(128.5 / 256.0)) < 1e-6);
    }
    void placesAndDirectionsAreOneAnothersInverse()
    {
        for (double x = 0.03; x < 1.0; x += 0.07)
            for (double y = 0.03; y < 1.0; y += 0.07)
                QVERIFY(glm::distance(placeInPicture(directionInPicture({x, y})), glm::dvec2(x, y)) < 1e-9);
        QVERIFY(glm::distance(directionInPicture({0.5, 0.5}), glm::dvec3(1.0, 0.0, 0.0)) < 1e-9);
        QVERIFY(glm::distance(directionInPicture({0.75, 0.5}), glm::dvec3(0.0, 0.0, 1.0)) < 1e-9);
    }
    void theBrightestSpotIsTheSun()
    {
        const glm::dvec3 sun = SceneLight{70.0, 35.0}.sun();
        const auto read = skyOf(1024, 512, [&](const glm::dvec3& way) {
            return apartDeg(way, sun) < 2.0 ? glm::vec3(4000.0f, 3000.0f, 2000.0f)
                                            : glm::vec3(0.2f, 0.4f, 0.8f);
        });
        QVERIFY2(read, read ? "" : read.error().message().c_str());
        QVERIFY(apartDeg((*read)->sun, sun) < 0.3);
        const glm::dvec3 expected =
            glm::dvec3(4000.0, 3000.0, 2000.0) * fullTurn * (1.0 - std::cos(2.0 * oneDegree));
        QVERIFY(glm::distance((*read)->sunlight, expected) < 0.05 * glm::length(expected));
        QVERIFY(glm::distance((*read)->restAt(sun), glm::dvec3(0.2, 0.4, 0.8)) < 0.01);
        SceneLight light;
        light.backdrop = Backdrop::Picture;
        light.picture = *read;
        light.turnDeg = 90.0;
        QVERIFY(apartDeg(lightOf(light).sun, SceneLight{160.0, 35.0}.sun()) < 0.3);
        light.turnDeg = -70.0;
        QVERIFY(apartDeg(lightOf(light).sun, SceneLight{0.0, 35.0}.sun()) < 0.3);
    }
    void cloudsAndWindowsAreNoSun()
    {
        const glm::dvec3 bright = SceneLight{200.0, 50.0}.sun();
        const auto cloudy = skyOf(256, 128, [&](const glm::dvec3& way) {
            return glm::vec3(float(1.0 + 3.0 * std::pow(std::max(glm::dot(way, bright), 0.0), 8.0)));
        });
        const auto lampBelow = skyOf(256, 128, [](const glm::dvec3& way) {
            return glm::vec3(apartDeg(way, {0.0, -1.0, 0.0}) < 1.5 ? 1e4f : 1.0f);
        });
        for (const auto& read : {cloudy, lampBelow}) {
            QVERIFY(read);
            QCOMPARE((*read)->sunlight, glm::dvec3(0.0));
        }
        SceneLight light;
        light.backdrop = Backdrop::Picture;
        light.picture = *cloudy;
        const PictureLight lit = lightOf(light);
        QCOMPARE(lit.sunlight, glm::vec3(0.0f));
        QVERIFY(bright.y > 0.0 && lit.ambient[0].r > 0.0f);
    }
    void aSunAtTheHorizonStandsOverIt()
    {
        const glm::dvec3 sun(0.0, 0.0, 1.0);
        const auto read = skyOf(256, 128, [&](const glm::dvec3& way) {
            return glm::vec3(apartDeg(way, sun) < 2.0 ? 900.0f : 0.5f);
        });
        QVERIFY(read);
        QVERIFY(std::abs((*read)->sun.y - std::sin(SceneLight::leastHeightDeg * oneDegree)) < 1e-9);
        QVERIFY(std::abs(glm::length((*read)->sun) - 1.0) < 1e-9);
    }
    /// The program's own sky as a picture lights as that sky itself does.
    void aPictureOfTheNaturalSkyIsTheNaturalSky()
    {
        for (const double height : {8.0, 25.0, 55.0}) {
            const SceneLight natural{200.0, height, Backdrop::Sky};
            const std::string path = m_folder.filePath("own.hdr").toStdString();
            QVERIFY(saveSkyPicture(natural, 1024, path, true));
            const auto read = readPictureSky(path);
            QVERIFY(read);
            SceneLight own;
            own.backdrop = Backdrop::Picture;
            own.picture = *read;
            const PictureLight is = lightOf(own), was = lightOf(natural);
            QVERIFY(apartDeg(is.sun, was.sun) < 0.2);
            const auto near = [](const glm::vec3& a, const glm::vec3& b) {
                return glm::distance(a, b) < 0.08f * glm::length(b);
            };
            QVERIFY(near(is.sunlight, was.sunlight));
            for (const glm::vec3 normal : {glm::vec3(0, 1, 0), glm::vec3(0, 0, 1), glm::vec3(-1, 0, 0)})
                QVERIFY(near(ambientAt(is.ambient, normal), ambientAt(was.ambient, normal)));
            QVERIFY(bright(was.sunlight) > 0.0);
        }
    }
    void theUnitOfAPictureDoesNotMatter()
    {
        const auto skyTimes = [&](float factor) {
            const auto read = skyOf(64, 32, [&](const glm::dvec3& way) {
                return factor * glm::vec3(0.3f, 0.4f, 0.5f) * float(1.2 + way.y);
            });
            SceneLight light;
            light.backdrop = Backdrop::Picture;
            light.picture = read.value();
            return lightOf(light).ambient[0];
        };
        QVERIFY(glm::distance(skyTimes(1.0f), skyTimes(400.0f)) < 1e-2f);
        QVERIFY(glm::distance(skyTimes(1.0f), skyTimes(0.002f)) < 1e-2f);
    }
    void withoutAPictureItIsTheNaturalSky()
    {
        SceneLight light;
        light.backdrop = Backdrop::Picture;
        QVERIFY(lightOf(light).sky);
        QVERIFY(!lightOf(light).around);
    }
};

RAMURE_SUITE(TestPictureSky)

} // namespace tst_picture_sky

#include "tst_picture_sky.moc"
