#include "widgets/panels/animation/key_curve.h"

#include "widgets/panels/animation/key_texts.h"

#include <algorithm>
#include <numbers>

namespace ramure {

static constexpr double degrees = 180.0 / std::numbers::pi;

std::vector<KeyCurve> KeyCurve::curvesOf(const TrackRef& ref, const NodeAnimation::TrackPtr& track)
{
    std::vector<KeyCurve> curves;
    KeyCurve curve;
    curve.m_ref = {ref, 0};
    curve.m_track = track;
    curve.m_number = std::get_if<Track>(track.get());
    curve.m_turn = std::get_if<OrientationTrack>(track.get());
    if (curve.m_turn)
        curve.m_angles = std::make_shared<const std::vector<glm::dvec3>>(anglesOfKeys(*curve.m_turn));
    for (int component = 0; component < (curve.m_turn ? 3 : 1); ++component) {
        curve.m_ref.component = component;
        curve.findBounds();
        curves.push_back(curve);
    }
    return curves;
}

void KeyCurve::findBounds()
{
    m_low = m_high = size() == 0 ? 0.0 : valueOf(0);
    eachKey(0, size(), [this](Ticks, double value) {
        m_low = std::min(m_low, value);
        m_high = std::max(m_high, value);
    });
}

double KeyCurve::unit() const
{
    return isAngle() ? 1.0 / degrees : 1.0;
}

NumberFormat KeyCurve::format() const
{
    NumberFormat format = channelFormat(m_ref.track.channel);
    if (isAngle())
        format.factor = 1.0;
    return format;
}

QString KeyCurve::text() const
{
    const QString channel = channelText(m_ref.track.channel);
    return isAngle() ? QStringLiteral("%1 %2").arg(channel, QStringLiteral("XYZ").mid(m_ref.component, 1))
                     : channel;
}

Channel KeyCurve::colourChannel() const
{
    return isAngle() ? Channel{ChannelPart::GlobalTranslation, static_cast<std::uint8_t>(m_ref.component), 0}
                     : m_ref.track.channel;
}

std::size_t KeyCurve::size() const
{
    return m_number ? m_number->size() : m_turn->size();
}

Ticks KeyCurve::timeOf(std::size_t key) const
{
    return m_number ? m_number->keys()[key].time : m_turn->keys()[key].time;
}

double KeyCurve::valueOf(std::size_t key) const
{
    return m_number ? m_number->keys()[key].value : (*m_angles)[key][m_ref.component] * degrees;
}

std::size_t KeyCurve::lowerBound(Ticks time) const
{
    return m_number ? m_number->lowerBound(time) : m_turn->lowerBound(time);
}

std::optional<std::size_t> KeyCurve::find(Ticks time) const
{
    return m_number ? m_number->find(time) : m_turn->find(time);
}

const Key* KeyCurve::numberKey(std::size_t key) const
{
    return m_number ? &m_number->keys()[key] : nullptr;
}

double KeyCurve::Reader::at(double seconds)
{
    if (m_curve.m_number)
        return valueAt(*m_curve.m_number, seconds, m_cursor);
    const std::size_t behind = m_curve.lowerBound(ticksOf(seconds) + 1);
    const std::size_t key = behind == 0 ? 0 : behind - 1;
    if (m_key != key)
        m_near = (*m_curve.m_angles)[key];
    m_key = key;
    m_near = anglesOf(valueAt(*m_curve.m_turn, seconds, m_cursor), m_near);
    return m_near[m_curve.m_ref.component] * degrees;
}

} // namespace ramure
