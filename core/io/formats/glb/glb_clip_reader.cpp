#include "core/io/formats/glb/glb_clip_reader.h"

namespace ramure::glb {

namespace {

constexpr double latest = 1e6; ///< s

/// The keys of one channel.
struct Sampler
{
    std::vector<float> seconds, values;
    std::size_t components = 3;
    KeyMode mode = KeyMode::Linear;

    [[nodiscard]] bool isSpline() const { return mode == KeyMode::Bezier; }
    /// \param part 1: the value; of splines 0: the slope before it, 2: behind it
    [[nodiscard]] double at(std::size_t key, std::size_t part, std::size_t component) const
    {
        const std::size_t element = isSpline() ? 3 * key + part : key;
        return double(values[components * element + component]);
    }
};

Expected<Sampler> samplerOf(File& file, const Json& animation, std::size_t number, std::size_t components,
                            const std::string& place)
{
    const Json* samplers = member(animation, "samplers");
    if (!samplers || !samplers->is_array() || number >= samplers->size())
        return wrong(place, RAMURE_NOOP("there is no %1"), {placeOf("samplers", number)});
    const Json& json = (*samplers)[number];
    Sampler out;
    out.components = components;
    if (const std::string how = textOf(json, "interpolation"); how == "STEP")
        out.mode = KeyMode::Constant;
    else if (how == "CUBICSPLINE")
        out.mode = KeyMode::Bezier;
    auto seconds = file.floats(numberOf(json, "input"), 1, place);
    auto values = file.floats(numberOf(json, "output"), components, place);
    if (!seconds || !values)
        return fail(seconds ? values.error() : seconds.error());
    out.seconds = std::move(*seconds);
    out.values = std::move(*values);
    if (out.values.size() < out.seconds.size() * components * (out.isSpline() ? 3 : 1))
        return wrong(place, RAMURE_NOOP("fewer values than keys"));
    for (const float s : out.seconds)
        if (!(s >= 0.0F && double(s) < latest))
            return wrong(place, RAMURE_NOOP("a key at a time that cannot be"));
    return out;
}

template <class Key> Key keyAt(const Sampler& sampler, std::size_t i)
{
    Key key;
    key.time = ticksOf(double(sampler.seconds[i]));
    key.mode = sampler.mode;
    key.before = key.behind = HandleType::Free;
    return key;
}

/// A third of the way to the neighbour, as steep as the spline there (Hermite to Bézier).
Handle handle(const Sampler& sampler, std::size_t i, std::size_t neighbour, std::size_t part, std::size_t c)
{
    if (!sampler.isSpline() || neighbour >= sampler.seconds.size())
        return {};
    const double dt = (double(sampler.seconds[neighbour]) - double(sampler.seconds[i])) / 3.0;
    return {dt, dt * sampler.at(i, part, c)};
}

Expected<AnyTrack> trackOf(const Sampler& sampler, std::size_t component)
{
    std::vector<Key> keys;
    for (std::size_t i = 0; i < sampler.seconds.size(); ++i) {
        Key& key = keys.emplace_back(keyAt<Key>(sampler, i));
        key.value = sampler.at(i, 1, component);
        key.in = handle(sampler, i, i - 1, 0, component);
        key.out = handle(sampler, i, i + 1, 2, component);
    }
    auto track = Track::fromKeys(std::move(keys));
    return track ? Expected<AnyTrack>(std::move(*track)) : fail(std::move(track.error()));
}

Expected<AnyTrack> turnsOf(const Sampler& sampler)
{
    std::vector<OrientationKey> keys;
    for (std::size_t i = 0; i < sampler.seconds.size(); ++i) {
        OrientationKey& key = keys.emplace_back(keyAt<OrientationKey>(sampler, i));
        if (sampler.isSpline())
            key.mode = KeyMode::Cubic; // through the keys, smooth as theirs
        const glm::dquat turn(sampler.at(i, 1, 3), sampler.at(i, 1, 0), sampler.at(i, 1, 1),
                              sampler.at(i, 1, 2));
        key.value = glm::length(turn) > 1e-12 ? glm::normalize(turn) : glm::dquat(1.0, 0.0, 0.0, 0.0);
    }
    auto track = OrientationTrack::fromKeys(std::move(keys));
    return track ? Expected<AnyTrack>(std::move(*track)) : fail(std::move(track.error()));
}

/// One key: the value throughout.
AnyTrack constant(double value)
{
    Key key;
    key.mode = KeyMode::Linear;
    key.value = value;
    return Track::fromKeys({key}).value_or(Track());
}

/// What no channel moves stays as the node says: tracks stand for all of its place.
void fillUp(NodeAnimation& moves, const Pose& pose)
{
    for (const auto& [part, rest] : {std::pair(ChannelPart::GlobalTranslation, pose.translation),
                                     std::pair(ChannelPart::GlobalScale, pose.scale)})
        for (std::uint8_t c = 0; c < 3; ++c)
            if (!moves.find({part, c, 0}))
                moves.set({part, c, 0}, constant(rest[c]));
    if (moves.find({ChannelPart::GlobalOrientation, 0, 0}))
        return;
    OrientationKey key;
    key.mode = KeyMode::Linear;
    key.value = pose.rotation;
    moves.set({ChannelPart::GlobalOrientation, 0, 0},
              OrientationTrack::fromKeys({key}).value_or(OrientationTrack()));
}

Expected<void> addChannel(File& file, const Json& animation, const Json& channel, std::size_t nodes,
                          Clip& out, const std::string& place)
{
    const Json* target = member(channel, "target");
    const auto node = target ? numberOf(*target, "node") : std::nullopt;
    const std::string path = target ? textOf(*target, "path") : std::string();
    const bool isTurn = path == "rotation", isScale = path == "scale";
    if (!node || *node >= nodes || (!isTurn && !isScale && path != "translation"))
        return {}; // of something that extensions name
    const auto sampler =
        samplerOf(file, animation, numberOf(channel, "sampler").value_or(SIZE_MAX), isTurn ? 4 : 3, place);
    RAMURE_TRY(sampler);
    if (sampler->seconds.empty())
        return {};
    NodeAnimation& moves = out.moves[static_cast<Index>(*node)];
    const ChannelPart part = isTurn    ? ChannelPart::GlobalOrientation
                             : isScale ? ChannelPart::GlobalScale
                                       : ChannelPart::GlobalTranslation;
    for (std::uint8_t c = 0; c < (isTurn ? 1 : 3); ++c) {
        auto track = isTurn ? turnsOf(*sampler) : trackOf(*sampler, c);
        if (!track)
            return wrong(place, RAMURE_NOOP("keys that cannot be"));
        moves.set({part, c, 0}, std::move(*track));
    }
    return {};
}

} // namespace

Expected<Clip> readClip(File& file, const FileNodes& nodes)
{
    Clip out;
    const Json& animations = file.list("animations");
    if (animations.empty())
        return out;
    const Json* channels = member(animations[0], "channels");
    for (std::size_t i = 0; channels && channels->is_array() && i < channels->size(); ++i)
        RAMURE_TRY(addChannel(file, animations[0], (*channels)[i], nodes.all.size(), out,
                              "animations[0]." + placeOf("channels", i)));
    for (auto& [number, moves] : out.moves)
        fillUp(moves, nodes.all[number].pose);
    if (animations.size() > 1)
        out.notes.push_back(fail(ErrorCode::Invalid, RAMURE_NOOP("%1 animations: the first one is taken"),
                                 {std::to_string(animations.size())})
                                .value());
    return out;
}

} // namespace ramure::glb
