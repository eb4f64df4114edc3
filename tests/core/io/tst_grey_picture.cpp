#include "core/io/exr_file.h"
#include "core/io/grey_picture.h"
#include "core/io/picture_file.h"
#include "tests/support/suite.h"
#include <QFile>
#include <QTemporaryDir>
#include <limits>
#include <png.h>

namespace tst_grey_picture {

using namespace ramure;

/// Maps of density and of heights: numbers, not colours.
class TestGreyPicture : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    std::string written(const char* name, std::string_view bytes)
    {
        QFile file(m_folder.filePath(name));
        if (!file.open(QIODevice::WriteOnly))
            qFatal("no file");
        file.write(bytes.data(), qint64(bytes.size()));
        return file.fileName().toStdString();
    }
    static std::string png16(int width, int height, const std::vector<std::uint16_t>& values)
    {
        png_image image{};
        image.version = PNG_IMAGE_VERSION;
        image.width = png_uint_32(width);
        image.height = png_uint_32(height);
        image.format = PNG_FORMAT_LINEAR_Y;
        std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
        png_alloc_size_t size = bytes.size();
        if (!png_image_write_to_memory(&image, bytes.data(), &size, 0, values.data(), 0, nullptr))
            qFatal("%s", image.message);
        bytes.resize(size);
        return bytes;
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void badFilesAreRefusedWithTheirName()
    {
        const auto refuses = [](const std::string& path, ErrorCode code) {
            const auto picture = readGreyPicture(path);
            return !picture && picture.error().code == code && picture.error().file == path;
        };
        QVERIFY(refuses("/nowhere.png", ErrorCode::Io));
        QVERIFY(refuses(m_folder.path().toStdString(), ErrorCode::Io));
        QVERIFY(refuses(written("empty.png", ""), ErrorCode::Unknown));
        QVERIFY(refuses(written("text.png", "no picture"), ErrorCode::Unknown));
        const std::vector<std::uint8_t> grey{0, 85, 170, 255};
        const std::string whole = *pngOf({2, 2, 1, false, grey});
        for (std::size_t size = 4; size + 12 < whole.size(); ++size) // all that lacks more than the end
            QVERIFY(refuses(written("cut.png", whole.substr(0, size)), ErrorCode::Invalid));
        const std::vector<std::uint8_t> wide(16385, 0);
        QVERIFY(refuses(written("wide.png", *pngOf({16385, 1, 1, false, wide})), ErrorCode::Limit));
        QVERIFY(refuses(written("cut.exr", "\x76\x2f\x31\x01 and no more"), ErrorCode::Syntax));
    }

    void aBytePngIsReadAsItIs()
    {
        const std::vector<std::uint8_t> grey{0, 85, 170, 255}; // from below
        const auto picture = readGreyPicture(written("grey.png", *pngOf({2, 2, 1, false, grey})));
        QVERIFY2(picture, test::why(picture));
        QCOMPARE(picture->width, 2);
        QCOMPARE(picture->height, 2);
        const std::vector<float> expected{170.0F / 255.0F, 1.0F, 0.0F, 85.0F / 255.0F};
        QCOMPARE(picture->values, expected);
    }

    void sixteenBitsAreKept()
    {
        const std::vector<std::uint16_t> values{0, 1, 2, 32768, 65534, 65535};
        const auto picture = readGreyPicture(written("wide16.png", png16(3, 2, values)));
        QVERIFY2(picture, test::why(picture));
        for (std::size_t i = 0; i < values.size(); ++i)
            QCOMPARE(std::uint16_t(std::lround(picture->values[i] * 65535.0F)), values[i]);
    }

    void heightsOfAnExrAreKept()
    {
        const std::vector<glm::vec4> pixels{{-3.5F, 1.0F, 1.0F, 1.0F}, {812.25F, 0.0F, 0.0F, 1.0F}};
        const std::string path = m_folder.filePath("heights.exr").toStdString();
        QVERIFY(writeExr(path, 1, 2, pixels));
        const auto picture = readGreyPicture(path);
        QVERIFY2(picture, test::why(picture));
        QCOMPARE(picture->values, (std::vector<float>{-3.5F, 812.25F}));
        const std::vector<glm::vec4> none{{std::numeric_limits<float>::quiet_NaN(), 0.0F, 0.0F, 1.0F}};
        QVERIFY(writeExr(path, 1, 1, none));
        const auto refused = readGreyPicture(path);
        QVERIFY(!refused && refused.error().code == ErrorCode::Invalid && refused.error().file == path);
    }

    void betweenPixelsItIsStraight()
    {
        const GreyPicture picture{2, 2, {0.0F, 1.0F, 2.0F, 4.0F}, GreyPicture::Kind::Shares};
        QCOMPARE(picture.at(0.25, 0.25), 0.0);
        QCOMPARE(picture.at(0.75, 0.25), 1.0);
        QCOMPARE(picture.at(0.5, 0.5), 1.75);
        QCOMPARE(picture.at(-3.0, 0.75), 2.0);
        QCOMPARE(picture.at(9.0, 9.0), 4.0);
        QCOMPARE((GreyPicture{1, 1, {7.0F}, GreyPicture::Kind::Numbers}).at(0.3, 0.9), 7.0);
    }
};

RAMURE_SUITE(TestGreyPicture)

} // namespace tst_grey_picture

#include "tst_grey_picture.moc"
