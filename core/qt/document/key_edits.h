/// \file
/// Edits of keys in any tracks of any nodes. Each function is one step of undo, or none if nothing would
/// change. Errors are those of edit::setTracks and of tracks, and then nothing changes.
#pragma once

#include "core/qt/document/commands.h"
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace ramure {

struct TrackRef
{
    NodeId node = noNode;
    Channel channel;
    auto operator<=>(const TrackRef&) const = default;
};

/// One line of the curve editor: a number, or an angle (0, 1, 2 = about X, Y, Z) of an orientation.
struct CurveRef
{
    TrackRef track;
    int component = 0;
    auto operator<=>(const CurveRef&) const = default;
};

/// Keys by their times, ascending, each once. It may name keys that are gone: they count as not selected.
using KeySelection = std::map<TrackRef, std::vector<Ticks>>;

/// Maps times: scaled about the pivot, then moved.
struct Retiming
{
    Ticks pivot = 0;
    double factor = 1.0; ///< below 0: mirrored, finite
    Ticks offset = 0;

    [[nodiscard]] Ticks of(Ticks time) const;
    bool operator==(const Retiming&) const = default;
};

/// Keys in the clipboard: tracks of the copied keys alone.
struct KeyClip
{
    std::vector<std::pair<TrackRef, AnyTrack>> tracks;
    Ticks first = 0; ///< time of the first key
};

namespace keys {

/// Null where there is no such node or no key.
NodeAnimation::TrackPtr find(const Scene& scene, const TrackRef& ref);
/// Returns the part of the selection that exists.
KeySelection existing(const Scene& scene, const KeySelection& selection);
std::size_t count(const KeySelection& selection);
/// First and last time; nothing where nothing is selected.
std::optional<std::pair<Ticks, Ticks>> spanOf(const KeySelection& selection);
/// Returns the times of all keys of these nodes, ascending, each time once.
std::vector<Ticks> timesOf(const Scene& scene, std::span<const NodeId> nodes);
/// The time of a frame, and the nearest whole step (a frame, a second) to a time.
Ticks ticksOfFrame(const TimelineSettings& settings, double frame);
Ticks snapped(Ticks time, double stepsPerSecond);
/// The time of the next key behind \p time, or before it, of all these tracks.
std::optional<Ticks> nextTime(const Scene& scene, const std::vector<TrackRef>& tracks, Ticks time,
                              bool forward);

/// Moves, scales or mirrors; returns the keys at their new times. Keys that come to lie on others take their
/// place. Mirrored keys are passed through backwards: handles and easings change sides, and each takes the
/// mode of the key that was before it.
Expected<KeySelection> retime(Document& document, const KeySelection& selection, const Retiming& retiming,
                              const QString& text);
/// Copies, moved or scaled; the keys themselves stay. Returns the copies.
Expected<KeySelection> duplicate(Document& document, const KeySelection& selection, const Retiming& retiming);
Expected<KeySelection> snap(Document& document, const KeySelection& selection, double stepsPerSecond,
                            const QString& text);
/// A key with the value there is at this time, in each of these tracks that has none then.
Expected<void> insert(Document& document, const std::vector<TrackRef>& tracks, Ticks time);
Expected<void> remove(Document& document, const KeySelection& selection);
/// Changes mode, easing, handle types; times must stay.
Expected<void> reshape(Document& document, const KeySelection& selection,
                       const std::function<void(KeyShape&)>& change, const QString& text);
/// Changes values of number keys; of orientations nothing.
Expected<void> changeValues(Document& document, const KeySelection& selection,
                            const std::function<double(const TrackRef&, double)>& change, const QString& text,
                            GestureId gesture = 0);
/// Moves keys in time, and their values by their curve's share of \p values (of angles radians: the keys' own
/// three angles, see anglesOfKeys). Returns them at their new times.
Expected<KeySelection> shift(Document& document, const KeySelection& selection, Ticks offset,
                             const std::map<CurveRef, double>& values, const QString& text);
/// Puts a number key in the place of the one at its time.
Expected<void> replace(Document& document, const TrackRef& ref, const Key& key, const QString& text,
                       GestureId gesture);
/// Changes values of orientation keys; of numbers nothing.
Expected<void> changeOrientations(Document& document, const KeySelection& selection,
                                  const std::function<glm::dquat(const glm::dquat&)>& change,
                                  const QString& text, GestureId gesture = 0);
/// Sets the extrapolation of every track with a selected key.
Expected<void> extrapolate(Document& document, const KeySelection& selection, bool before, bool behind,
                           Extrapolation extrapolation);

KeyClip copied(const Scene& scene, const KeySelection& selection);
/// Keys of one node go to each of \p targets, where those have the channels (without targets: back to where
/// they are from); keys of several nodes go to the nodes they are from. Keys at the same times are replaced.
/// Error Invalid: nothing fits.
Expected<KeySelection> paste(Document& document, const KeyClip& clip, const std::vector<NodeId>& targets,
                             Ticks offset);

} // namespace keys
} // namespace ramure
