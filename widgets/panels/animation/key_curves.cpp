#include "widgets/panels/animation/key_curves.h"

#include "widgets/base/timeline_ruler.h"
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace ramure {

KeyCurves::KeyCurves(KeyModel* model, KeyCommands* commands, TimelineRuler* ruler, QWidget* parent)
    : QWidget(parent)
    , m_model(model)
    , m_commands(commands)
    , m_ruler(ruler)
{
    setObjectName(QStringLiteral("keyCurves"));
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Curves"));
    connect(model, &KeyModel::rowsChanged, this, &KeyCurves::followModel);
    connect(model, &KeyModel::selectionChanged, this, qOverload<>(&QWidget::update));
    connect(&model->document()->history(), &UndoHistory::gestureEnded, this, &KeyCurves::giveUp);
    connect(ruler, &TimelineRuler::viewChanged, this, qOverload<>(&QWidget::update));
    takeCurves();
}

/// The dope sheet may be on show instead.
void KeyCurves::followModel()
{
    m_stale = true;
    if (isVisible())
        takeCurves();
    else
        m_fitted = false;
}

void KeyCurves::showEvent(QShowEvent* event)
{
    if (m_stale)
        takeCurves();
    QWidget::showEvent(event);
}

void KeyCurves::takeCurves()
{
    m_stale = false;
    std::map<TrackRef, std::vector<Curve>> before;
    for (Curve& curve : m_curves)
        before[curve.ref().track].push_back(std::move(curve));
    m_curves.clear();
    for (const TrackRef& ref : m_model->tracks()) {
        const auto track = keys::find(m_model->document()->scene(), ref);
        if (!track || m_model->isHidden(ref))
            continue;
        const auto kept = before.find(ref);
        const bool same = kept != before.end() && kept->second.front().track() == track;
        std::vector<Curve> curves = same ? std::move(kept->second) : Curve::curvesOf(ref, track);
        std::move(curves.begin(), curves.end(), std::back_inserter(m_curves));
    }
    m_linesOf = {};
    m_fitted = m_fitted && !m_curves.empty(); // others are new to whoever looks
    if (!m_fitted && isVisible())
        fitAll();
    update();
}

const KeyCurves::Curve* KeyCurves::curveOf(const CurveRef& ref) const
{
    const auto found = std::find_if(m_curves.begin(), m_curves.end(),
                                    [&ref](const Curve& curve) { return curve.ref() == ref; });
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
    m_linesOf = {};
    fit();
}

double KeyCurves::xOf(double seconds) const
{
    return m_ruler->xOf(seconds * m_model->timeline().framesPerSecond);
}

Ticks KeyCurves::ticksAt(double x) const
{
    return keys::ticksOfFrame(m_model->timeline(), m_ruler->framesAt(x));
}

/// Normalised, the keys of every curve go from 0 to 1; one without any change stands at the middle.
double KeyCurves::yOf(const Curve& curve, double value) const
{
    if (m_normalised)
        value = curve.high() > curve.low() ? (value - curve.low()) / (curve.high() - curve.low())
                                           : value - curve.low() + 0.5;
    return height() * (m_high - value) / (m_high - m_low);
}

double KeyCurves::unitsPerPixel(const Curve& curve) const
{
    const double scale = m_normalised && curve.high() > curve.low() ? curve.high() - curve.low() : 1.0;
    return scale * (m_high - m_low) / std::max(1, height());
}

QPointF KeyCurves::placeOf(const TrackRef& ref, Ticks time, double value) const
{
    return placeOf(CurveRef{ref, 0}, time, value);
}

QPointF KeyCurves::placeOf(const CurveRef& ref, Ticks time, double value) const
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

const std::vector<Ticks>& KeyCurves::selectedOf(const Curve& curve) const
{
    static const std::vector<Ticks> none;
    const auto found = m_model->selection().find(curve.ref().track);
    return found == m_model->selection().end() ? none : found->second;
}

bool KeyCurves::follows(const Curve& curve) const
{
    const Curve* hit = curveOf(m_hit.ref);
    const bool angle = hit && hit->isAngle();
    return curve.isAngle() == angle && (!angle || curve.ref().component == m_hit.ref.component);
}

bool KeyCurves::showsHandle(const Curve& curve, std::size_t key, int side) const
{
    const Key* number = curve.numberKey(key);
    if (!number)
        return false;
    return side > 0 ? number->mode == KeyMode::Bezier && key + 1 < curve.size()
                    : key > 0 && curve.numberKey(key - 1)->mode == KeyMode::Bezier;
}

void KeyCurves::fitKeys(bool all)
{
    if (m_stale)
        takeCurves();
    if (m_curves.empty())
        return;
    m_fitted = true;
    double low = 1e300, high = -1e300;
    Ticks from = mostTicks, to = -mostTicks;
    const auto take = [&](const Curve& curve, std::size_t key) {
        low = std::min(low, curve.valueOf(key));
        high = std::max(high, curve.valueOf(key));
        from = std::min(from, curve.timeOf(key));
        to = std::max(to, curve.timeOf(key));
    };
    for (const Curve& curve : m_curves) {
        for (std::size_t i = 0; all && i < curve.size(); ++i)
            take(curve, i);
        for (const Ticks time : selectedOf(curve))
            if (const auto key = all ? std::nullopt : curve.find(time))
                take(curve, *key);
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

} // namespace ramure
