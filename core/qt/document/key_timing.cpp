// Edits that move keys in time.
#include "core/qt/document/key_edits_private.h"
#include "core/rig/tracks/euler.h"

#include <cmath>

namespace ramure {
namespace {

void scaleHandle(Handle& handle, double factor)
{
    handle.dt *= factor;
}

void scaleHandles(Key& key, double factor)
{
    scaleHandle(key.in, factor);
    scaleHandle(key.out, factor);
}

void scaleHandles(OrientationKey& key, double factor)
{
    for (std::size_t i = 0; i < key.in.size(); ++i) {
        scaleHandle(key.in[i], factor);
        scaleHandle(key.out[i], factor);
    }
}

Easing reversed(Easing easing, KeyMode mode)
{
    const bool endsIn = mode == KeyMode::Back || mode == KeyMode::Bounce || mode == KeyMode::Elastic;
    switch (easing) {
    case Easing::In:
        return Easing::Out;
    case Easing::Out:
        return Easing::In;
    case Easing::Auto:
        return endsIn ? Easing::In : Easing::Out;
    case Easing::InOut:
        break;
    }
    return easing;
}

/// The way from each key to the next belongs to the later one when time runs backwards.
template <class KeyType>
void takeWayBefore(KeyType& key, const KeyList<KeyType>& all, std::size_t index, bool beforeIsSelected)
{
    std::swap(key.in, key.out);
    std::swap(key.before, key.behind);
    if (!beforeIsSelected)
        return;
    const KeyShape& way = all[index - 1];
    key.mode = way.mode;
    key.easing = reversed(way.easing, way.mode);
    key.back = way.back;
    key.amplitude = way.amplitude;
    key.period = way.period;
}

template <class KeyType>
std::vector<KeyType> retimed(const KeyList<KeyType>& all, const std::vector<std::size_t>& indices,
                             const Retiming& retiming)
{
    std::vector<KeyType> changed;
    changed.reserve(indices.size());
    for (std::size_t i = 0; i < indices.size(); ++i) {
        KeyType key = all[indices[i]];
        key.time = retiming.of(key.time);
        if (retiming.factor != 1.0)
            scaleHandles(key, retiming.factor);
        if (retiming.factor < 0.0)
            takeWayBefore(key, all, indices[i], i > 0 && indices[i - 1] + 1 == indices[i]);
        changed.push_back(key);
    }
    return changed;
}

void shiftValues(std::vector<Key>& changed, const Track&, const std::vector<std::size_t>&,
                 const TrackRef& ref, const std::map<CurveRef, double>& values)
{
    if (const auto value = values.find({ref, 0}); value != values.end())
        for (Key& key : changed)
            key.value += value->second;
}

void shiftValues(std::vector<OrientationKey>& changed, const OrientationTrack& track,
                 const std::vector<std::size_t>& indices, const TrackRef& ref,
                 const std::map<CurveRef, double>& values)
{
    glm::dvec3 by(0.0);
    for (int c = 0; c < 3; ++c)
        if (const auto value = values.find({ref, c}); value != values.end())
            by[c] = value->second;
    if (by == glm::dvec3(0.0))
        return;
    const std::vector<glm::dvec3> angles = anglesOfKeys(track);
    for (std::size_t i = 0; i < changed.size(); ++i)
        changed[i].value = orientationOf(angles[indices[i]] + by);
}

} // namespace

Ticks Retiming::of(Ticks time) const
{
    if (factor == 1.0)
        return time + offset;
    // Beyond the range of times tracks refuse them; this keeps the number within a tick.
    const double most = 2.0 * double(mostTicks);
    return pivot + std::llround(std::clamp(double(time - pivot) * factor, -most, most)) + offset;
}

Expected<KeySelection> keys::retime(Document& document, const KeySelection& selection,
                                    const Retiming& retiming, const QString& text)
{
    return changeKeys(document, selection, text, 0,
                      [&](const TrackRef&, const auto& held, const auto& indices) {
                          return retimed(held.keys(), indices, retiming);
                      });
}

Expected<KeySelection> keys::duplicate(Document& document, const KeySelection& selection,
                                       const Retiming& retiming)
{
    KeySelection copies;
    auto done = eachTrack(
        document, selection, stepText(QT_TRANSLATE_NOOP("keys", "Duplicate Keys")), 0,
        [&](const TrackRef& ref, const auto& held, const auto& indices, auto& edits) -> Expected<void> {
            const auto added = retimed(held.keys(), indices, retiming);
            auto made = withAdded(held, added);
            RAMURE_TRY(made);
            copies[ref] = timesOf(added);
            edits.push_back(editOf(ref, std::move(*made)));
            return {};
        });
    RAMURE_TRY(done);
    return copies;
}

Expected<KeySelection> keys::snap(Document& document, const KeySelection& selection, double stepsPerSecond,
                                  const QString& text)
{
    return changeKeys(document, selection, text, 0,
                      [&](const TrackRef&, const auto& held, const auto& indices) {
                          auto changed = keysAt(held, indices);
                          for (auto& key : changed)
                              key.time = snapped(key.time, stepsPerSecond);
                          return changed;
                      });
}

Expected<KeySelection> keys::shift(Document& document, const KeySelection& selection, Ticks offset,
                                   const std::map<CurveRef, double>& values, const QString& text)
{
    return changeKeys(document, selection, text, 0,
                      [&](const TrackRef& ref, const auto& held, const auto& indices) {
                          auto changed = retimed(held.keys(), indices, {0, 1.0, offset});
                          shiftValues(changed, held, indices, ref, values);
                          return changed;
                      });
}

} // namespace ramure
