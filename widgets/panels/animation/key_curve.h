/// \file
/// One line of the curve editor: the value of a number over time, or one of the three angles of an
/// orientation.
#pragma once

#include "core/qt/document/key_edits.h"
#include "core/rig/tracks/euler.h"
#include "widgets/base/texts/number_format.h"
#include <algorithm>

namespace ramure {

class KeyCurve
{
public:
    /// One curve of a number, three of an orientation.
    static std::vector<KeyCurve> curvesOf(const TrackRef& ref, const NodeAnimation::TrackPtr& track);

    [[nodiscard]] const CurveRef& ref() const { return m_ref; }
    [[nodiscard]] const NodeAnimation::TrackPtr& track() const { return m_track; }
    [[nodiscard]] bool isAngle() const { return m_angles != nullptr; }
    /// Returns the track's value for one unit of the curve: angles are shown in degrees.
    [[nodiscard]] double unit() const;
    /// How its values are shown; they are degrees already where it is an angle.
    [[nodiscard]] NumberFormat format() const;
    /// "Location X", "Rotation Z".
    [[nodiscard]] QString text() const;
    /// Returns the channel whose colour the curve has: that of its axis.
    [[nodiscard]] Channel colourChannel() const;
    [[nodiscard]] std::size_t size() const;
    [[nodiscard]] Ticks timeOf(std::size_t key) const;
    [[nodiscard]] double valueOf(std::size_t key) const;
    [[nodiscard]] std::size_t lowerBound(Ticks time) const;
    [[nodiscard]] std::optional<std::size_t> find(Ticks time) const;
    /// Null where there are no handles to show: of angles.
    [[nodiscard]] const Key* numberKey(std::size_t key) const;
    /// Along the keys first .. end - 1: \p visit(time, value).
    template <class Visit> void eachKey(std::size_t first, std::size_t end, Visit&& visit) const
    {
        while (first < end)
            if (m_number)
                first = eachOf(m_number->keys().runFrom(first), first, end, visit,
                               [](const Key& key, std::size_t) { return key.value; });
            else
                first = eachOf(m_turn->keys().runFrom(first), first, end, visit,
                               [this](const OrientationKey&, std::size_t i) { return valueOf(i); });
    }
    [[nodiscard]] double low() const { return m_low; } ///< of the keys
    [[nodiscard]] double high() const { return m_high; }

    /// Values one after the other, from left to right: angles go on from where they were.
    class Reader
    {
    public:
        explicit Reader(const KeyCurve& curve)
            : m_curve(curve)
        {
        }
        double at(double seconds);

    private:
        const KeyCurve& m_curve;
        TrackCursor m_cursor;
        std::optional<std::size_t> m_key; ///< from which the angles go on
        glm::dvec3 m_near{0.0};
    };

private:
    template <class Run, class Visit, class Value>
    static std::size_t eachOf(Run run, std::size_t first, std::size_t end, Visit&& visit, Value&& value)
    {
        run = run.first(std::min(run.size(), end - first));
        for (const auto& key : run) {
            visit(key.time, value(key, first));
            ++first;
        }
        return first;
    }
    void findBounds();

    CurveRef m_ref;
    NodeAnimation::TrackPtr m_track;
    const Track* m_number = nullptr; ///< in m_track, one of the two
    const OrientationTrack* m_turn = nullptr;
    std::shared_ptr<const std::vector<glm::dvec3>> m_angles; ///< of the keys, rad
    double m_low = 0.0, m_high = 0.0;
};

} // namespace ramure
