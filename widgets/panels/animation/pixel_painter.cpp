#include "widgets/panels/animation/pixel_painter.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace ramure {
namespace {

/// Leaves of the way from a to b (0 to 1) what lies between 0 and most. \returns false: nothing
bool cut(double a, double b, double most, double& from, double& to)
{
    const double way = b - a;
    if (way == 0.0)
        return a >= 0.0 && a <= most;
    double enter = -a / way, leave = (most - a) / way;
    if (way < 0.0)
        std::swap(enter, leave);
    from = std::max(from, enter);
    to = std::min(to, leave);
    return from <= to;
}

} // namespace

PixelPainter::PixelPainter(QImage& image)
    : m_bits(reinterpret_cast<QRgb*>(image.bits()))
    , m_stride(image.bytesPerLine() / static_cast<std::ptrdiff_t>(sizeof(QRgb)))
    , m_width(image.width())
    , m_height(image.height())
    , m_scale(image.devicePixelRatio())
    , m_reach(std::max<std::ptrdiff_t>(1, std::lround(m_scale)))
{
}

void PixelPainter::line(QPointF from, QPointF to, QRgb colour)
{
    from *= m_scale;
    to *= m_scale;
    double enter = 0.0, leave = 1.0;
    if (!cut(from.x(), to.x(), double(m_width - 1), enter, leave) ||
        !cut(from.y(), to.y(), double(m_height - 1), enter, leave))
        return;
    const QPointF way = to - from, a = from + enter * way, b = from + leave * way;
    // Places in 1/65536 of a pixel; over a picture's width the rounding stays far below a pixel.
    constexpr double one = 65536.0;
    constexpr int shift = 16;
    const bool flat = std::abs(b.x() - a.x()) >= std::abs(b.y() - a.y());
    const long begin = std::lround(flat ? a.x() : a.y()), end = std::lround(flat ? b.x() : b.y());
    const long steps = std::abs(end - begin);
    const double across = flat ? b.y() - a.y() : b.x() - a.x();
    const auto step = static_cast<std::int64_t>(std::lround(steps > 0 ? across / double(steps) * one : 0.0));
    const auto last = (flat ? m_height : m_width) - 1;
    auto side = static_cast<std::int64_t>(((flat ? a.y() : a.x()) + 0.5) * one);
    std::ptrdiff_t along = begin;
    const std::ptrdiff_t forward = end < begin ? -1 : 1, most = (flat ? m_width : m_height) - 1;
    for (long i = 0; i <= steps; ++i, along += forward, side += step) {
        const auto beside = std::clamp<std::ptrdiff_t>(side >> shift, 0, last);
        const auto ahead = std::clamp<std::ptrdiff_t>(along, 0, most);
        *(flat ? at(ahead, beside) : at(beside, ahead)) = colour;
    }
}

void PixelPainter::dot(QPointF place, QRgb colour)
{
    place *= m_scale;
    const double beyond = double(m_reach) + 1.0;
    if (!(place.x() > -beyond && place.y() > -beyond && place.x() < double(m_width) + beyond &&
          place.y() < double(m_height) + beyond))
        return;
    const std::ptrdiff_t x = std::lround(place.x()), y = std::lround(place.y());
    const std::ptrdiff_t left = std::max<std::ptrdiff_t>(x - m_reach, 0);
    const std::ptrdiff_t right = std::min(x + m_reach + 1, m_width);
    const std::ptrdiff_t below = std::min(y + m_reach + 1, m_height);
    for (std::ptrdiff_t row = std::max<std::ptrdiff_t>(y - m_reach, 0); row < below && left < right; ++row)
        std::fill(at(left, row), at(right, row), colour);
}

} // namespace ramure
