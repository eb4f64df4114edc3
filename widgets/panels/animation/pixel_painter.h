/// \file
/// Lines and dots set pixel by pixel: for pictures of so many that a QPainter would take too long.
#pragma once

#include <QColor>
#include <QImage>
#include <QPointF>

namespace ramure {

class PixelPainter
{
public:
    /// \param image Format_RGB32, of at least one pixel; it is drawn into and must outlive the painter.
    /// Places are logical: its device pixel ratio counts.
    explicit PixelPainter(QImage& image);

    /// One pixel wide, both ends included. Any finite places: what lies outside is cut off.
    void line(QPointF from, QPointF to, QRgb colour);
    /// A square of three pixels' side around the place.
    void dot(QPointF at, QRgb colour);

private:
    [[nodiscard]] QRgb* at(std::ptrdiff_t x, std::ptrdiff_t y) const { return m_bits + y * m_stride + x; }

    QRgb* m_bits;
    std::ptrdiff_t m_stride; ///< pixels from row to row
    std::ptrdiff_t m_width, m_height;
    double m_scale;
    std::ptrdiff_t m_reach; ///< of a dot, to each side
};

} // namespace ramure
