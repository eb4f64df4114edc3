// The picture of the curve editor.
#include "widgets/animation/key_curves.h"
#include "widgets/animation/key_texts.h"
#include "widgets/timeline/timeline_ruler.h"

#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace ramure {

static constexpr double keyRadius = 4.0;
static constexpr std::size_t manyCurves = 40; ///< thin lines from here on
static constexpr std::size_t mostKeys = 2000; ///< dots from here on

void KeyCurves::paintGrid(QPainter& painter) const
{
    const double wanted = 40.0 * (m_high - m_low) / std::max(1, height());
    const double tenth = std::pow(10.0, std::floor(std::log10(wanted)));
    double step = tenth;
    for (const double factor : {2.0, 5.0, 10.0})
        if (step < wanted)
            step = tenth * factor;
    QColor line = palette().color(QPalette::WindowText), text = line;
    line.setAlphaF(0.12f);
    text.setAlphaF(0.6f);
    for (double value = std::ceil(m_low / step) * step; value <= m_high; value += step) {
        const double y = std::floor(height() * (m_high - value) / (m_high - m_low)) + 0.5;
        painter.setPen(line);
        painter.drawLine(QPointF(0.0, y), QPointF(width(), y));
        painter.setPen(text);
        if (!m_normalised)
            painter.drawText(QPointF(4.0, y - 2.0),
                             locale().toString(std::abs(value) < 1e-9 * step ? 0.0 : value, 'g', 6));
    }
}

/// Looked at every other pixel; with very many curves less often, so that a picture stays quick.
void KeyCurves::paintCurve(QPainter& painter, const Curve& curve) const
{
    constexpr double mostPlaces = 8'000.0;
    const double step = std::max(2.0, double(m_curves.size()) * width() / mostPlaces);
    const double rate = m_model->timeline().framesPerSecond;
    Curve::Reader reader(curve);
    QPolygonF line;
    line.reserve(int(width() / step) + 2);
    for (double x = 0.0; x <= width() + step; x += step) {
        const double seconds = std::clamp(m_ruler->framesAt(x) / rate, -1e6, 1e6);
        line << QPointF(x, std::clamp(yOf(curve, reader.at(seconds)), -1e5, 1e5));
    }
    // One pixel wide, a line that goes up and down all the time is drawn without its outline.
    painter.setPen(QPen(channelColour(curve.colourChannel(), palette()), m_dense ? 1.0 : 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(line);
}

std::pair<std::size_t, std::size_t> KeyCurves::keysInSight(const Curve& curve) const
{
    const auto ticksAt = [this](double x) {
        return keys::ticksOfFrame(m_model->timeline(), m_ruler->framesAt(x));
    };
    constexpr double margin = 20.0;
    return {curve.lowerBound(ticksAt(-margin)), curve.lowerBound(ticksAt(width() + margin) + 1)};
}

QPointF KeyCurves::keyPlace(const Curve& curve, std::size_t key, bool selected) const
{
    const bool dragged = selected && m_drag == Drag::Keys;
    const double y = yOf(curve, curve.valueOf(key)) + (dragged && follows(curve) ? m_pixels : 0.0);
    return {xOf(secondsOf(curve.timeOf(key) + (dragged ? m_offset : 0))), y};
}

void KeyCurves::paintHandles(QPainter& painter, const Curve& curve, std::size_t key,
                             const QPointF& place) const
{
    for (const int side : {-1, 1}) {
        if (!showsHandle(curve, key, side))
            continue;
        const QPointF end = handlePlace(curve, *curve.numberKey(key), side);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1.2));
        painter.setBrush(palette().color(QPalette::Base));
        painter.drawLine(place, end);
        painter.drawEllipse(end, keyRadius - 0.5, keyRadius - 0.5);
    }
}

void KeyCurves::paintKeys(QPainter& painter, const Curve& curve) const
{
    const QColor accent = palette().color(QPalette::Highlight), text = palette().color(QPalette::WindowText);
    const std::vector<Ticks>& chosen = selectedOf(curve);
    const auto [first, end] = keysInSight(curve);
    double lastX = -1e9, lastY = -1e9;
    for (std::size_t i = first; i < end; ++i) {
        const bool selected = std::binary_search(chosen.begin(), chosen.end(), curve.timeOf(i));
        const QPointF place = keyPlace(curve, i, selected);
        if (!selected && std::abs(place.x() - lastX) < 2.0 && std::abs(place.y() - lastY) < 2.0)
            continue; // not to be told apart
        lastX = place.x();
        lastY = place.y();
        if (selected && m_drag != Drag::Keys)
            paintHandles(painter, curve, i, place);
        painter.setPen(QPen(selected ? text : channelColour(curve.colourChannel(), palette()), 1.2));
        painter.setBrush(selected ? accent : palette().color(QPalette::Base));
        painter.drawEllipse(place, keyRadius, keyRadius);
    }
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

/// More keys than anyone can take by hand: a dot for each. The curves below are kept as a picture until the
/// view or a track changes.
void KeyCurves::paintDense(QPainter& painter)
{
    const std::array<double, 6> view{
        m_low, m_high, m_ruler->from(), m_ruler->to(), double(m_curves.size()), double(palette().cacheKey())};
    if (m_lines.size() != size()) {
        m_lines = m_dots = QImage(size(), QImage::Format_RGB32);
        m_linesOf = {};
    }
    if (m_linesOf != view) {
        m_linesOf = view;
        QPainter lines(&m_lines);
        lines.setFont(font());
        lines.fillRect(rect(), palette().base());
        paintGrid(lines);
        lines.setRenderHint(QPainter::Antialiasing, m_curves.size() <= manyCurves);
        for (const Curve& curve : m_curves)
            paintCurve(lines, curve);
    }
    paintDots();
    painter.drawImage(0, 0, m_dots);
}

/// Set as pixels, selected ones on top.
void KeyCurves::paintDots()
{
    for (int y = 0; y < m_lines.height(); ++y)
        std::memcpy(m_dots.scanLine(y), m_lines.constScanLine(y), std::size_t(m_lines.bytesPerLine()));
    const QRect inside = rect().adjusted(1, 1, -2, -2);
    const auto dot = [&](const QPointF& place, QRgb colour) {
        const QPoint at = place.toPoint();
        if (!inside.contains(at))
            return;
        for (int y = at.y() - 1; y <= at.y() + 1; ++y) {
            auto* line = reinterpret_cast<QRgb*>(m_dots.scanLine(y));
            std::fill(line + at.x() - 1, line + at.x() + 2, colour);
        }
    };
    const QRgb accent = palette().color(QPalette::Highlight).rgba();
    for (const bool selected : {false, true})
        for (const Curve& curve : m_curves) {
            const std::vector<Ticks>& chosen = selectedOf(curve);
            const QRgb own = channelColour(curve.colourChannel(), palette()).rgba();
            const auto [first, end] = keysInSight(curve);
            for (std::size_t i = first; !selected && i < end; ++i)
                if (!std::binary_search(chosen.begin(), chosen.end(), curve.timeOf(i)))
                    dot(keyPlace(curve, i, false), own);
            for (std::size_t i = 0; selected && i < chosen.size(); ++i)
                if (const auto key = curve.find(chosen[i]))
                    dot(keyPlace(curve, *key, true), accent);
        }
}

void KeyCurves::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    m_dense = isDense();
    if (m_dense) {
        paintDense(painter);
    } else {
        painter.fillRect(rect(), palette().base());
        paintGrid(painter);
        for (const Curve& curve : m_curves)
            paintCurve(painter, curve);
        for (const Curve& curve : m_curves)
            paintKeys(painter, curve);
    }
    const QColor accent = palette().color(QPalette::Highlight);
    painter.setPen(QPen(accent, 1.6));
    const double x = std::floor(m_ruler->xOf(double(m_frame))) + 0.5;
    painter.drawLine(QPointF(x, 0.0), QPointF(x, height()));
    if (m_drag == Drag::Box && m_moved) {
        QColor soft = accent;
        soft.setAlphaF(0.15f);
        painter.setPen(accent);
        painter.setBrush(soft);
        painter.drawRect(QRectF(m_press, m_at).normalized());
    }
    if (hasFocus()) {
        painter.setPen(accent);
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

} // namespace ramure
