// The picture of the curve editor where there are more keys than anyone can take by hand: a dot for each.
#include "widgets/base/timeline_ruler.h"
#include "widgets/panels/animation/key_curves.h"
#include "widgets/panels/animation/key_texts.h"
#include "widgets/panels/animation/pixel_painter.h"

#include <QPainter>
#include <algorithm>
#include <array>
#include <cstring>

namespace ramure {

static constexpr std::size_t manyCurves = 40; ///< from here on lines are one pixel wide and not smooth
static constexpr std::size_t mostKeys = 2000; ///< dots from here on

KeyCurves::Scale KeyCurves::scaleOf(const Curve& curve) const
{
    Scale scale;
    scale.left = xOf(0.0);
    scale.perTick = (xOf(1.0) - scale.left) / double(ticksPerSecond);
    scale.perUnit = 1.0 / unitsPerPixel(curve);
    scale.top = m_high;
    if (m_normalised) // see yOf()
        scale.top = curve.high() > curve.low() ? curve.low() + m_high * (curve.high() - curve.low())
                                               : curve.low() + m_high - 0.5;
    return scale;
}

bool KeyCurves::isDense() const
{
    std::size_t inSight = 0;
    for (const Curve& curve : m_curves) {
        const auto [first, end] = keysInSight(curve);
        inSight += end - first;
    }
    return inSight > mostKeys;
}

/// The curves below are kept as a picture until the view or a track changes.
void KeyCurves::paintDense(QPainter& painter)
{
    const std::array<double, 6> view{
        m_low, m_high, m_ruler->from(), m_ruler->to(), double(m_curves.size()), double(palette().cacheKey())};
    const QSize pixels = (QSizeF(size()) * devicePixelRatioF()).toSize();
    if (m_lines.size() != pixels || m_lines.devicePixelRatio() != devicePixelRatioF()) {
        m_lines = m_dots = QImage(pixels, QImage::Format_RGB32);
        m_lines.setDevicePixelRatio(devicePixelRatioF());
        m_dots.setDevicePixelRatio(devicePixelRatioF());
        m_linesOf = {};
    }
    if (m_lines.isNull())
        return;
    if (m_linesOf != view) {
        m_linesOf = view;
        paintLines();
    }
    std::memcpy(m_dots.bits(), m_lines.constBits(), std::size_t(m_lines.sizeInBytes()));
    paintDots();
    painter.drawImage(QPointF(0.0, 0.0), m_dots);
}

void KeyCurves::paintLines()
{
    m_lines.fill(palette().color(QPalette::Base));
    {
        QPainter lines(&m_lines);
        lines.setFont(font());
        paintGrid(lines);
        lines.setRenderHint(QPainter::Antialiasing);
        if (m_curves.size() <= manyCurves)
            for (const Curve& curve : m_curves)
                paintCurve(lines, curve);
    }
    PixelPainter pixels(m_lines);
    if (m_curves.size() > manyCurves)
        for (const Curve& curve : m_curves)
            paintThin(pixels, curve);
}

/// From key to key, each so-and-so-manyth where they are too many, looked at in between where they are few:
/// places that hang on the keys, so that the lines keep their shape while the view moves.
void KeyCurves::paintThin(PixelPainter& pixels, const Curve& curve) const
{
    constexpr std::size_t mostPlaces = 12'000; // of all curves: a few milliseconds
    const std::size_t places = std::max<std::size_t>(16, mostPlaces / m_curves.size());
    const Scale scale = scaleOf(curve);
    const QRgb colour = channelColour(curve.colourChannel(), palette()).rgb();
    QPointF before;
    bool begun = false;
    const auto to = [&](Ticks time, double value) {
        const QPointF at = scale.at(time, value);
        if (begun)
            pixels.line(before, at, colour);
        before = at;
        begun = true;
    };
    Curve::Reader reader(curve);
    const auto between = [&](Ticks from, Ticks end, std::size_t parts) { // without the ends
        for (std::size_t k = 1; k < parts; ++k) {
            const Ticks time = from + static_cast<Ticks>(double(end - from) * double(k) / double(parts));
            to(time, reader.at(secondsOf(time)));
        }
    };
    auto [first, end] = keysInSight(curve);
    first -= first > 0 ? 1 : 0;
    end = std::min(end + 1, curve.size());
    std::size_t stride = 1;
    while ((end - first) / stride > places)
        stride *= 2; // seldom another one while the view moves
    first -= first % stride;
    const std::size_t parts = places / ((end - first) / stride + 1);
    const Ticks left = ticksAt(0.0), right = ticksAt(width());
    if (curve.timeOf(first) > left) {
        to(left, reader.at(secondsOf(left)));
        between(left, std::min(right, curve.timeOf(first)), places / 2);
    }
    for (std::size_t i = first; i < end; i += stride) {
        const Ticks time = curve.timeOf(i);
        to(time, curve.valueOf(i));
        if (i + 1 >= end || stride > 1)
            continue;
        const Ticks next = curve.timeOf(i + 1);
        const Key* key = curve.numberKey(i);
        if (key && key->mode == KeyMode::Constant)
            to(next, key->value);
        else if (!key || key->mode != KeyMode::Linear)
            between(time, next,
                    std::min(parts, static_cast<std::size_t>(double(next - time) * scale.perTick / 4.0)));
    }
    const Ticks last = curve.timeOf(end - 1);
    if (last < right) {
        if (stride > 1)
            to(last, curve.valueOf(end - 1));
        between(last, right, places / 2);
        to(right, reader.at(secondsOf(right)));
    }
}

/// Set as pixels, selected ones on top.
void KeyCurves::paintDots()
{
    PixelPainter pixels(m_dots);
    const QRgb accent = palette().color(QPalette::Highlight).rgb();
    for (const Curve& curve : m_curves) {
        const std::vector<Ticks>& chosen = selectedOf(curve);
        const QRgb own = channelColour(curve.colourChannel(), palette()).rgb();
        const Scale scale = scaleOf(curve);
        const auto [first, end] = keysInSight(curve);
        auto mark = chosen.begin();
        curve.eachKey(first, end, [&](Ticks time, double value) {
            mark = mark == chosen.end() || *mark >= time ? mark : std::lower_bound(mark, chosen.end(), time);
            if (mark == chosen.end() || *mark != time)
                pixels.dot(scale.at(time, value), own);
        });
    }
    for (const Curve& curve : m_curves) {
        const bool dragged = m_drag == Drag::Keys;
        const QPointF down(0.0, dragged && follows(curve) ? m_pixels : 0.0);
        const Scale scale = scaleOf(curve);
        for (const Ticks time : selectedOf(curve))
            if (const auto key = curve.find(time))
                pixels.dot(scale.at(time + (dragged ? m_offset : 0), curve.valueOf(*key)) + down, accent);
    }
}

} // namespace ramure
