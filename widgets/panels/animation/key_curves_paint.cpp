// The picture of the curve editor.
#include "widgets/base/timeline_ruler.h"
#include "widgets/panels/animation/key_curves.h"
#include "widgets/panels/animation/key_texts.h"

#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace ramure {

static constexpr double keyRadius = 4.0;

NumberFormat KeyCurves::commonFormat() const
{
    NumberFormat common;
    for (const Curve& curve : m_curves) {
        const NumberFormat format = curve.format();
        if (&curve == &m_curves.front())
            common = format;
        else if (format.suffix != common.suffix || format.factor != common.factor)
            return {};
    }
    return common;
}

/// On an axis that several kinds share values stand as the tracks have them: angles of joints in radians.
QString KeyCurves::axisUnits() const
{
    QStringList units;
    for (const Curve& curve : m_curves) {
        const NumberFormat format = curve.format();
        const bool radians = format.unit == ParamUnit::Radian && format.factor != 1.0;
        QString unit = radians ? QStringLiteral("rad") : format.suffix.trimmed();
        if (unit.isEmpty())
            unit = tr("without unit");
        if (!units.contains(unit))
            units << unit;
    }
    return m_normalised || units.size() < 2 ? QString()
                                            : tr("Values: %1").arg(units.join(QStringLiteral(" · ")));
}

/// In the unit that the curves have in common; where they have none, it says which there are.
void KeyCurves::paintGrid(QPainter& painter) const
{
    const NumberFormat format = commonFormat();
    const QString units = axisUnits();
    const double low = m_low * format.factor, high = m_high * format.factor;
    const double wanted = 40.0 * (high - low) / std::max(1, height());
    const double tenth = std::pow(10.0, std::floor(std::log10(wanted)));
    double step = tenth;
    for (const double factor : {2.0, 5.0, 10.0})
        if (step < wanted)
            step = tenth * factor;
    QColor line = palette().color(QPalette::WindowText), text = line;
    line.setAlphaF(0.12f);
    text.setAlphaF(0.6f);
    const double top = units.isEmpty() ? 0.0 : 2.0 * fontMetrics().height(); // there they stand
    for (double value = std::ceil(low / step) * step; value <= high; value += step) {
        const double y = std::floor(height() * (high - value) / (high - low)) + 0.5;
        painter.setPen(line);
        painter.drawLine(QPointF(0.0, y), QPointF(width(), y));
        painter.setPen(text);
        if (!m_normalised && y > top)
            painter.drawText(QPointF(4.0, y - 2.0),
                             locale().toString(std::abs(value) < 1e-9 * step ? 0.0 : value, 'g', 6) +
                                 format.suffix);
    }
    painter.setPen(text);
    painter.drawText(QPointF(4.0, fontMetrics().ascent() + 2.0), units);
}

/// Looked at every other pixel; with many curves less often, so that a picture stays quick.
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
