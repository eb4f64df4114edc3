// Lines and dots set pixel by pixel.
#include "core/math/random.h"
#include "tests/support/suite.h"
#include "widgets/panels/animation/pixel_painter.h"
#include <cmath>

namespace tst_pixel_painter {

using namespace ramure;

namespace {

constexpr QRgb paper = 0xff101010, ink = 0xffe04020;

QImage blank(int width = 60, int height = 40, double scale = 1.0)
{
    QImage image(width, height, QImage::Format_RGB32);
    image.setDevicePixelRatio(scale);
    image.fill(paper);
    return image;
}

int inked(const QImage& image)
{
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            count += image.pixel(x, y) == ink ? 1 : 0;
    return count;
}

/// From the line through both points, in pixels.
double away(QPointF a, QPointF b, QPointF p)
{
    const QPointF way = b - a;
    const double length = std::hypot(way.x(), way.y());
    return length == 0.0 ? std::hypot(p.x() - a.x(), p.y() - a.y())
                         : std::abs(way.x() * (p.y() - a.y()) - way.y() * (p.x() - a.x())) / length;
}

} // namespace

class TestPixelPainter : public QObject
{
    Q_OBJECT
private slots:
    void whatLiesOutsideLeavesThePictureAlone()
    {
        QImage image = blank();
        PixelPainter painter(image);
        painter.line({-50, -3}, {900, -2}, ink);
        painter.line({-50, 10}, {-1, 30}, ink);
        painter.line({70, -1e9}, {65, 1e9}, ink);
        painter.line({1e300, 1e300}, {1e300, -1e300}, ink);
        painter.dot({-5, 10}, ink);
        painter.dot({1e300, -1e300}, ink);
        painter.dot({30, 45}, ink);
        QCOMPARE(inked(image), 0);
    }
    void linesGoFromEndToEndWithoutAGap()
    {
        Random random(31, RandomStream::Test);
        for (int i = 0; i < 500; ++i) {
            QImage image = blank();
            const QPointF a(random.range(0.0, 59.0), random.range(0.0, 39.0));
            const QPointF b(random.range(0.0, 59.0), random.range(0.0, 39.0));
            PixelPainter(image).line(a, b, ink);
            QCOMPARE(image.pixel(a.toPoint()), ink);
            QCOMPARE(image.pixel(b.toPoint()), ink);
            const double wide = std::abs(b.x() - a.x()), high = std::abs(b.y() - a.y());
            QVERIFY(std::abs(inked(image) - (std::max(wide, high) + 1.0)) <= 1.5);
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x)
                    QVERIFY(image.pixel(x, y) == paper || away(a, b, QPointF(x, y)) <= 1.0);
        }
    }
    void longLinesAreCutAtTheEdges()
    {
        Random random(32, RandomStream::Test);
        for (int i = 0; i < 500; ++i) {
            QImage image = blank();
            const double far = std::pow(10.0, random.range(2.0, 6.0));
            const QPointF inside(random.range(5.0, 54.0), random.range(5.0, 34.0));
            const double angle = random.range(0.0, 6.283185307179586);
            const QPointF way(far * std::cos(angle), far * std::sin(angle));
            PixelPainter(image).line(inside - way, inside + way, ink);
            QVERIFY(inked(image) >= 10); // from edge to edge, past that point
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x)
                    QVERIFY(image.pixel(x, y) == paper ||
                            away(inside - way, inside + way, QPointF(x, y)) <= 1.01);
        }
    }
    void dotsAreSquaresOfThreePixels()
    {
        QImage image = blank();
        PixelPainter painter(image);
        painter.dot({10.4, 20.4}, ink);
        QCOMPARE(inked(image), 9);
        QCOMPARE(image.pixel(9, 19), ink);
        QCOMPARE(image.pixel(11, 21), ink);
        painter.dot({0, 0}, ink); // at a corner what is inside
        QCOMPARE(inked(image), 13);
    }
    void placesAreLogical()
    {
        QImage image = blank(60, 40, 2.0);
        PixelPainter painter(image);
        painter.line({0, 10}, {29, 10}, ink);
        QCOMPARE(image.pixel(0, 20), ink);
        QCOMPARE(image.pixel(58, 20), ink);
        painter.dot({20, 5}, ink);
        QCOMPARE(image.pixel(40, 10), ink);
        QCOMPARE(image.pixel(42, 12), ink);
    }
};

RAMURE_SUITE(TestPixelPainter)

} // namespace tst_pixel_painter

#include "tst_pixel_painter.moc"
