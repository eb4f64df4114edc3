#include "widgets/view/render/surface_images.h"

#include "core/scene/material.h"
#include "core/surface/foliage/leaf_maps.h"
#include "tests/support/suite.h"
#include <QFile>
#include <QGuiApplication>
#include <QTemporaryDir>
#include <algorithm>
#include <cmath>
#include <sys/stat.h>

namespace tst_surface_images {

using namespace ramure;

class TestSurfaceImages : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;

    std::string path(const char* name) const
    {
        return QFile::encodeName(m_folder.filePath(QLatin1String(name))).toStdString();
    }
    std::string saved(const QImage& image, const char* name) const
    {
        if (!image.save(QFile::decodeName(path(name).c_str())))
            qFatal("cannot write %s", name);
        return path(name);
    }
    static QImage filled(QSize size, const QColor& colour)
    {
        QImage image(size, QImage::Format_ARGB32);
        image.fill(colour);
        return image;
    }
    void write(const char* name, const QByteArray& bytes) const
    {
        QFile file(QFile::decodeName(path(name).c_str()));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void badFilesAreNamedWithTheReason_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("code");
        const std::string whole = saved(filled({64, 64}, Qt::red), "whole.png");
        QFile file(QFile::decodeName(whole.c_str()));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray bytes = file.readAll();
        write("empty.png", {});
        write("text.png", "no picture at all");
        write("head.png", bytes.left(20));
        write("cut.png", bytes.left(bytes.size() / 2));
        saved(filled({30'000, 2}, Qt::red), "wide.png");
        QCOMPARE(mkfifo(path("pipe.png").c_str(), 0600), 0);
        QTest::newRow("missing") << "gone.png" << int(ErrorCode::Io);
        QTest::newRow("a folder") << "." << int(ErrorCode::Io);
        QTest::newRow("a pipe") << "pipe.png" << int(ErrorCode::Io);
        QTest::newRow("empty") << "empty.png" << int(ErrorCode::Syntax);
        QTest::newRow("a text") << "text.png" << int(ErrorCode::Syntax);
        QTest::newRow("a cut head") << "head.png" << int(ErrorCode::Syntax);
        QTest::newRow("cut pixels") << "cut.png" << int(ErrorCode::Syntax);
        QTest::newRow("30,000 wide") << "wide.png" << int(ErrorCode::Limit);
    }
    void badFilesAreNamedWithTheReason()
    {
        QFETCH(QString, name);
        QFETCH(int, code);
        PictureParams pictures;
        pictures.normal = path(qPrintable(name));
        const auto read = readPicture(pictures.normal);
        QVERIFY(!read);
        QCOMPARE(int(read.error().code), code);
        QCOMPARE(read.error().file, pictures.normal);
        QVERIFY(!read.error().plain().empty());
        const SurfaceImages drawn = surfaceImages(barkMaterial({}, pictures));
        QCOMPARE(drawn.problems.size(), std::size_t(1));
        QCOMPARE(drawn.colour.front(), glm::u8vec4(255, 0, 255, 255));
    }

    void picturesTakeThePlaceOfWhatIsMade()
    {
        PictureParams pictures;
        pictures.colour = saved(filled({20, 50}, QColor(200, 100, 50)), "colour.jpg");
        pictures.occlusion = saved(filled({64, 64}, QColor(128, 128, 128)), "occlusion.png");
        pictures.roughness = saved(filled({8, 8}, Qt::white), "rough.png");
        BarkParams bark;
        bark.family = BarkFamily::Furrowed;
        const SurfaceImages images = surfaceImages(barkMaterial(bark, pictures));
        QVERIFY(images.problems.empty() && images.isAged && !images.isCut);
        QCOMPARE(images.size, 64);
        QVERIFY(std::abs(images.colour.front().r - 100) < 4);
        QCOMPARE(images.normal.front().a, std::uint8_t(255));
        QVERIFY(std::ranges::any_of(images.normal, [](const glm::u8vec4& n) { return n.x != 128; }));
        QCOMPARE(images.base, glm::u8vec3(255));
    }
    void heightMakesNormalsWithoutASeam()
    {
        QImage height(64, 64, QImage::Format_Grayscale8);
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x)
                height.setPixel(x, y, qRgb(x < 32 ? 0 : 255, 0, 0));
        PictureParams pictures;
        pictures.height = saved(height.convertToFormat(QImage::Format_RGB32), "height.png");
        const SurfaceImages images = surfaceImages(barkMaterial({}, pictures));
        QCOMPARE(images.normal[10], glm::u8vec4(128, 128, 255, 128));
        QVERIFY(images.normal[31].x < 100);                             // the step up looks left
        QVERIFY(images.normal[0].x > 156 && images.normal[63].x > 156); // the step down across the edge
    }
    void opacityCutsLeaves()
    {
        PictureParams pictures;
        pictures.opacity = saved(filled({32, 32}, Qt::black), "opacity.png");
        const SurfaceImages images = surfaceImages(leavesMaterial(LeafShape::Birch, false, pictures));
        QVERIFY(images.isCut);
        QCOMPARE(images.base, leafMaps(LeafShape::Birch, 32)->blade);
        pictures = {};
        pictures.colour = saved(filled({32, 32}, Qt::transparent), "alpha.png");
        QVERIFY(surfaceImages(leavesMaterial(LeafShape::Birch, false, pictures)).isCut);
    }
    void theStampFollowsTheFile()
    {
        PictureParams pictures;
        pictures.colour = saved(filled({8, 8}, Qt::red), "stamp.png");
        const auto before = pictureStamp(pictures);
        QCOMPARE(pictureStamp(pictures), before);
        saved(filled({80, 80}, Qt::blue), "stamp.png");
        QVERIFY(pictureStamp(pictures) != before);
        QVERIFY(pictureStamp({}) != before);
    }
    void smallerPicturesShowAsMuch_data()
    {
        QTest::addColumn<int>("size");
        QTest::addColumn<double>("share");
        for (const int size : {64, 100, 256})
            for (const double share : {0.0, 0.1, 0.5, 0.9, 1.0})
                QTest::addRow("%d, %g", size, share) << size << share;
    }
    void smallerPicturesShowAsMuch()
    {
        QFETCH(const int, size);
        QFETCH(const double, share);
        std::vector<double> field; // thin shapes with soft edges
        for (int i = 0; i < size * size; ++i) {
            const double x = i % size, y = double(i / size);
            field.push_back(std::sin(0.9 * x + 0.31 * y) + std::sin(0.37 * x - 0.71 * y));
        }
        std::vector<double> sorted = field;
        std::ranges::sort(sorted);
        const double least =
            sorted[std::min(sorted.size() - 1, std::size_t((1.0 - share) * double(sorted.size())))];
        std::vector<glm::u8vec4> pixels;
        for (const double at : field)
            pixels.emplace_back(40, 120, 30,
                                share == 0.0 ? 0 : int(std::clamp(128.0 + 300.0 * (at - least), 0.0, 255.0)));
        const auto shareOf = [](const std::vector<glm::u8vec4>& of) {
            return double(std::ranges::count_if(of, [](const auto& p) { return p.a >= 128; })) /
                   double(of.size());
        };
        const auto levels = smallerPictures(size, pixels);
        QCOMPARE(levels.back().size(), std::size_t(1));
        for (const auto& level : levels) {
            if (level.size() >= 32 * 32) // smaller ones are all alike
                QVERIFY2(std::abs(shareOf(level) - shareOf(pixels)) <= 0.02,
                         qPrintable(QString::number(shareOf(level))));
            for (const auto& pixel : level) // no dark rims
                QVERIFY(pixel.a == 0 || glm::u8vec3(pixel) == glm::u8vec3(40, 120, 30));
        }
    }
};

RAMURE_SUITE(TestSurfaceImages)

} // namespace tst_surface_images

#include "tst_surface_images.moc"
