#include "widgets/animation/key_curves.h"

#include "widgets/animation/key_texts.h"
#include "widgets/timeline/timeline_ruler.h"
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace ramure {

static constexpr double keyRadius = 4.0;

KeyCurves::KeyCurves(KeyModel* model, KeyCommands* commands, TimelineRuler* ruler, QWidget* parent)
    : QWidget(parent)
    , m_model(model)
    , m_commands(commands)
    , m_ruler(ruler)
{
    setObjectName(QStringLiteral("keyCurves"));
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Curves"));
    connect(model, &KeyModel::rowsChanged, this, &KeyCurves::takeCurves);
    connect(model, &KeyModel::selectionChanged, this, qOverload<>(&QWidget::update));
    connect(ruler, &TimelineRuler::viewChanged, this, qOverload<>(&QWidget::update));
    takeCurves();
}

void KeyCurves::takeCurves()
{
    m_curves.clear();
    for (const TrackRef& ref : m_model->tracks()) {
        const auto track = keys::find(m_model->document()->scene(), ref);
        const auto* number = track ? std::get_if<Track>(track.get()) : nullptr;
        if (!number || m_model->isHidden(ref))
            continue;
        const auto byValue = [](const Key& a, const Key& b) { return a.value < b.value; };
        const auto [low, high] = std::minmax_element(number->keys().begin(), number->keys().end(), byValue);
        m_curves.push_back({ref, track, low->value, high->value});
    }
    if (!m_fitted && !m_curves.empty() && isVisible())
        fit();
    update();
}

const KeyCurves::Curve* KeyCurves::curveOf(const TrackRef& ref) const
{
    const auto found = std::find_if(m_curves.begin(), m_curves.end(),
                                    [&ref](const Curve& curve) { return curve.ref == ref; });
    return found == m_curves.end() ? nullptr : &*found;
}

void KeyCurves::setFrame(qint64 frame)
{
    m_frame = frame;
    update();
}

void KeyCurves::setNormalised(bool on)
{
    m_normalised = on;
    fit();
}

double KeyCurves::xOf(double seconds) const
{
    return m_ruler->xOf(seconds * m_model->timeline().framesPerSecond);
}

/// Normalised, the keys of every curve go from 0 to 1; one without any change stands at the middle.
double KeyCurves::yOf(const Curve& curve, double value) const
{
    if (m_normalised)
        value =
            curve.high > curve.low ? (value - curve.low) / (curve.high - curve.low) : value - curve.low + 0.5;
    return height() * (m_high - value) / (m_high - m_low);
}

double KeyCurves::unitsPerPixel(const Curve& curve) const
{
    const double scale = m_normalised && curve.high > curve.low ? curve.high - curve.low : 1.0;
    return scale * (m_high - m_low) / std::max(1, height());
}

QPointF KeyCurves::placeOf(const TrackRef& ref, Ticks time, double value) const
{
    const Curve* curve = curveOf(ref);
    return curve ? QPointF(xOf(secondsOf(time)), yOf(*curve, value)) : QPointF();
}

bool KeyCurves::isSelected(const TrackRef& ref, Ticks time) const
{
    const auto found = m_model->selection().find(ref);
    return found != m_model->selection().end() &&
           std::binary_search(found->second.begin(), found->second.end(), time);
}

void KeyCurves::fit()
{
    if (m_curves.empty())
        return;
    m_fitted = true;
    double low = 1e300, high = -1e300;
    Ticks from = mostTicks, to = -mostTicks;
    const bool all = m_model->selection().empty();
    for (const Curve& curve : m_curves)
        for (const Key& key : std::get<Track>(*curve.track).keys()) {
            if (!all && !isSelected(curve.ref, key.time))
                continue;
            low = std::min(low, key.value);
            high = std::max(high, key.value);
            from = std::min(from, key.time);
            to = std::max(to, key.time);
        }
    if (from > to)
        return;
    if (m_normalised) {
        low = 0.0;
        high = 1.0;
    }
    const double pad = high > low ? 0.12 * (high - low) : std::max(1.0, 0.5 * std::abs(high));
    m_low = low - pad;
    m_high = high + pad;
    const double rate = m_model->timeline().framesPerSecond;
    const double span = std::max(4.0, (secondsOf(to) - secondsOf(from)) * rate);
    m_ruler->showFrames(secondsOf(from) * rate - 0.05 * span, secondsOf(from) * rate + 1.05 * span);
    update();
}

QPointF KeyCurves::handlePlace(const Curve& curve, const Key& key, int side) const
{
    const Handle& handle = side < 0 ? key.in : key.out;
    return {xOf(secondsOf(key.time) + handle.dt), yOf(curve, key.value + handle.dv)};
}

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
    const auto& track = std::get<Track>(*curve.track);
    const double step = std::max(2.0, double(m_curves.size()) / 40.0);
    const double rate = m_model->timeline().framesPerSecond;
    TrackCursor cursor;
    QPolygonF line;
    line.reserve(int(width() / step) + 2);
    for (double x = 0.0; x <= width() + step; x += step) {
        const double seconds = std::clamp(m_ruler->framesAt(x) / rate, -1e6, 1e6);
        line << QPointF(x, std::clamp(yOf(curve, valueAt(track, seconds, cursor)), -1e5, 1e5));
    }
    painter.setPen(QPen(channelColour(curve.ref.channel, palette()), 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(line);
}

void KeyCurves::paintKeys(QPainter& painter, const Curve& curve) const
{
    const auto& track = std::get<Track>(*curve.track);
    const QColor accent = palette().color(QPalette::Highlight), text = palette().color(QPalette::WindowText);
    const auto ticksAt = [&](double x) {
        return keys::ticksOfFrame(m_model->timeline(), m_ruler->framesAt(x));
    };
    const Ticks last = ticksAt(width() + 20.0);
    double lastX = -1e9, lastY = -1e9;
    for (std::size_t i = track.lowerBound(ticksAt(-20.0)); i < track.size() && track.keys()[i].time <= last;
         ++i) {
        const Key& key = track.keys()[i];
        const bool selected = isSelected(curve.ref, key.time);
        QPointF place(xOf(secondsOf(key.time)), yOf(curve, key.value));
        if (!selected && std::abs(place.x() - lastX) < 2.0 && std::abs(place.y() - lastY) < 2.0)
            continue; // not to be told apart
        lastX = place.x();
        lastY = place.y();
        if (selected && m_drag == Drag::Keys)
            place = {xOf(secondsOf(key.time + m_offset)), place.y() + m_pixels};
        if (selected && m_drag != Drag::Keys)
            for (const int side : {-1, 1}) {
                const bool used = side > 0 ? key.mode == KeyMode::Bezier && i + 1 < track.size()
                                           : i > 0 && track.keys()[i - 1].mode == KeyMode::Bezier;
                if (!used)
                    continue;
                const QPointF end = handlePlace(curve, key, side);
                painter.setPen(QPen(accent, 1.2));
                painter.setBrush(palette().color(QPalette::Base));
                painter.drawLine(place, end);
                painter.drawEllipse(end, keyRadius - 0.5, keyRadius - 0.5);
            }
        painter.setPen(QPen(selected ? text : channelColour(curve.ref.channel, palette()), 1.2));
        painter.setBrush(selected ? accent : palette().color(QPalette::Base));
        painter.drawEllipse(place, keyRadius, keyRadius);
    }
}

void KeyCurves::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().base());
    paintGrid(painter);
    for (const Curve& curve : m_curves)
        paintCurve(painter, curve);
    for (const Curve& curve : m_curves)
        paintKeys(painter, curve);
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
