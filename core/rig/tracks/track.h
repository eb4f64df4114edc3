/// \file
/// Tracks: keys in order of time, and the value at any time between, before and behind them. A track is a
/// value: edits give a valid track again (sorted, one key per time, handles and signs settled), whatever the
/// order they come in. Evaluation changes nothing and may be done from several threads.
#pragma once

#include "core/base/error.h"
#include "core/rig/tracks/key_list.h"
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace ramure {

/// The values of a track before its first key and behind its last one.
enum class Extrapolation : std::uint8_t {
    Hold,
    Linear,       ///< on along the curve; where that has no direction (one key, CONSTANT, easings): hold
    Repeat,       ///< again and again; exactly at an end the key of that end
    RepeatOffset, ///< ... each time further on by what one round gained (orientations: turned on)
    Mirror,       ///< there and back
};
inline constexpr int extrapolationCount = 5;
/// "hold", "linear", "repeat", "repeatOffset", "mirror": the names in files.
const char* extrapolationName(Extrapolation extrapolation);

/// How orientations go from key to key.
enum class OrientationBlend : std::uint8_t {
    Spherical,  ///< slerp, KeyMode::Cubic a smooth squad; KeyMode::Bezier always goes by components
    Classic,    ///< the same, but KeyMode::Cubic by components, made a unit again (SPEC B1)
    Components, ///< like Blender's four curves: each component alone, then normalised
};
inline constexpr int orientationBlendCount = 3;
/// "spherical", "classic", "components": the names in files.
const char* orientationBlendName(OrientationBlend blend);

/// Remembers the last segment that was read: the next time is usually in the same segment or the next one. A
/// cursor belongs to one thread; it serves any track.
struct TrackCursor
{
    std::size_t segment = 0;
};

/// The members and functions that tracks of all kinds share. KeyType: Key or OrientationKey.
template <class KeyType> class KeyTrack
{
public:
    using KeyKind = KeyType;

    KeyTrack() = default;
    /// Keys in any order; of several at one time the last counts. Errors: Invalid (a number that is not
    /// finite, a time beyond mostTicks, a quaternion without a direction), path "[i].value" and the like.
    static Expected<KeyTrack> fromKeys(std::vector<KeyType> keys);

    [[nodiscard]] const KeyList<KeyType>& keys() const { return m_keys; }
    [[nodiscard]] bool empty() const { return m_keys.empty(); }
    [[nodiscard]] std::size_t size() const { return m_keys.size(); }
    /// Index of the key at exactly this time.
    [[nodiscard]] std::optional<std::size_t> find(Ticks time) const;
    /// Index of the first key not before this time; size() where there is none.
    [[nodiscard]] std::size_t lowerBound(Ticks time) const { return m_keys.lowerBound(time); }

    /// Puts a key in, in the place of one at the same time. Errors as above; the track is unchanged then.
    Expected<void> insert(KeyType key);
    /// Takes keys out. \p indices in any order; those that do not exist are left out.
    void erase(std::span<const std::size_t> indices);
    /// Replaces keys, times included: indices[i] becomes keys[i]. A changed key takes the place of an
    /// unchanged one at the same time; of several changed ones at one time the later in the list counts.
    /// Errors as above, Unknown (an index); the track is unchanged then.
    Expected<void> replace(std::span<const std::size_t> indices, std::span<const KeyType> keys);

    /// Must be called after each change of these: if the track goes round, handles at its ends follow those
    /// on the other side.
    void settleEnds();
    Extrapolation before = Extrapolation::Hold;
    Extrapolation behind = Extrapolation::Hold;
    /// Above 0: the time is taken modulo this period, from 0 s on, before anything else.
    Ticks loop = 0;
    OrientationBlend blend = OrientationBlend::Spherical; ///< only for orientations

    bool operator==(const KeyTrack& other) const
    {
        return m_keys == other.m_keys && before == other.before && behind == other.behind &&
               loop == other.loop && blend == other.blend;
    }

    /// The keys are one round of something that repeats on both sides, or of `loop`: the last key and the
    /// first one are neighbours of those behind and before.
    [[nodiscard]] bool goesRound() const;

private:
    void settle(std::vector<KeyType> keys);
    using Range = std::pair<std::size_t, std::size_t>; ///< first and last
    void settleAround(std::vector<Range> ranges);
    [[nodiscard]] bool keepsOrder(std::span<const std::size_t> indices, std::span<const KeyType> keys) const;
    void replaceFew(std::span<const std::size_t> indices, std::span<const KeyType> keys);
    void replaceMany(std::span<const std::size_t> indices, std::span<const KeyType> keys);

    KeyList<KeyType> m_keys;
};

extern template class KeyTrack<Key>;
extern template class KeyTrack<OrientationKey>;

/// A number over time. `blend` has no meaning here and stays as it is.
using Track = KeyTrack<Key>;
/// An orientation over time. Keys are unit quaternions, each with the sign that makes the way from the key
/// before the shorter one; a turn of 180 degrees (to 1e-7) goes on about the axis of the turn before it, and
/// about the axis with the positive first coordinate where there is none before: never by chance.
using OrientationTrack = KeyTrack<OrientationKey>;

/// The value at a time. \pre the track is not empty; seconds is finite. A key's own time gives exactly its
/// value (orientations: up to the sign).
double valueAt(const Track& track, double seconds, TrackCursor& cursor);
double valueAt(const Track& track, double seconds);
/// A unit quaternion.
glm::dquat valueAt(const OrientationTrack& track, double seconds, TrackCursor& cursor);
glm::dquat valueAt(const OrientationTrack& track, double seconds);

} // namespace ramure
