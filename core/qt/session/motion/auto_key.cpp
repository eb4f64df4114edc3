#include "core/qt/session/motion/auto_key.h"

#include "core/qt/document/document_command.h"
#include "core/qt/document/key_edits.h"
#include "core/qt/session/motion/player.h"
#include "core/rig/tracks/keyed_track.h"
#include <string_view>

namespace ramure {
namespace {

std::optional<PlacementPart> placementPart(const ParamDef& def)
{
    const std::string_view key = def.key;
    if (key == "tree.translation")
        return PlacementPart::Translation;
    if (key == "tree.rotation")
        return PlacementPart::Rotation;
    if (key == "tree.scale")
        return PlacementPart::Scale;
    return std::nullopt;
}

std::vector<Channel> channelsOf(const ParamDef& def)
{
    const auto part = placementPart(def);
    if (part == PlacementPart::Rotation)
        return {{ChannelPart::GlobalOrientation, 0, 0}};
    std::vector<Channel> channels;
    const std::uint8_t count = def.type == ParamType::Vec3 ? 3 : 1;
    for (std::uint8_t c = 0; c < count; ++c)
        channels.push_back(!part ? Channel{ChannelPart::Parameter, c, paramId(def)}
                           : *part == PlacementPart::Translation
                               ? Channel{ChannelPart::GlobalTranslation, c, 0}
                               : Channel{ChannelPart::GlobalScale, c, 0});
    return channels;
}

bool hasKey(const AnyTrack& track, Ticks time)
{
    return std::visit([time](const auto& held) { return held.find(time).has_value(); }, track);
}

glm::dvec3 partOf(const PlacementParams& placement, PlacementPart part)
{
    return part == PlacementPart::Translation ? placement.translation
           : part == PlacementPart::Rotation  ? placement.rotation
                                              : placement.scale;
}

double number(const ParamValue& value, std::uint8_t component)
{
    if (const auto* vector = std::get_if<glm::dvec3>(&value))
        return (*vector)[component];
    if (const auto* whole = std::get_if<std::int64_t>(&value))
        return double(*whole);
    const auto* real = std::get_if<double>(&value);
    return real ? *real : 0.0;
}

Expected<TrackEdit> keyed(const Node& node, const Channel& channel, Ticks time, double value)
{
    auto track = withKey<Track>(node.animation.find(channel), time, value);
    RAMURE_TRY(track);
    return TrackEdit{node.id, channel, std::move(*track)};
}

} // namespace

bool isKeyable(const ParamDef& def)
{
    return (def.flags & paramAnimatable) != 0 || placementPart(def);
}

AutoKey::AutoKey(Document* document, Player* player, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_player(player)
{
}

void AutoKey::setOn(bool on)
{
    if (on == m_on)
        return;
    m_on = on;
    emit changed(on);
}

Ticks AutoKey::now() const
{
    return keys::ticksOfFrame(m_document->scene().timeline(), double(m_player->frame()));
}

KeyState AutoKey::state(const std::vector<NodeId>& nodes, const ParamDef& def) const
{
    if (!isKeyable(def))
        return KeyState::None;
    bool any = false, all = !nodes.empty();
    const std::vector<Channel> channels = channelsOf(def);
    const Ticks time = now();
    for (const NodeId id : nodes) {
        const Node* node = m_document->scene().find(id);
        for (const Channel& channel : channels) {
            const auto track = node ? node->animation.find(channel) : nullptr;
            any = any || track;
            all = all && track && hasKey(*track, time);
        }
        if (any && !all)
            break; // nothing that follows changes that
    }
    return all ? KeyState::Here : any ? KeyState::Animated : KeyState::None;
}

ParamValue AutoKey::value(NodeId id, const ParamDef& def) const
{
    const Node& node = *m_document->scene().find(id);
    ParamValue value = def.get(node.params);
    if (!isKeyable(def))
        return value;
    if (const auto part = placementPart(def))
        return partOf(placementAt({node.params.tree, globalTracks(node.animation)}, secondsOf(now()),
                                  *part == PlacementPart::Rotation),
                      *part);
    for (const Channel& channel : channelsOf(def))
        if (const auto track = node.animation.find(channel)) {
            const double at = valueAt(std::get<Track>(*track), secondsOf(now()));
            if (auto* vector = std::get_if<glm::dvec3>(&value))
                (*vector)[channel.component] = at;
            else if (auto* whole = std::get_if<std::int64_t>(&value))
                *whole = std::llround(at);
            else
                value = at;
        }
    return clampValue(def, value);
}

bool AutoKey::takes(const std::vector<NodeId>& nodes, const ParamDef& def) const
{
    return isKeyable(def) && (m_on || state(nodes, def) != KeyState::None);
}

Expected<void> AutoKey::set(const std::vector<NodeId>& nodes, const ParamDef& def, const ParamValue& value,
                            std::optional<int> component, GestureId gesture)
{
    if (auto good = checkValue(def, value); !good)
        return good;
    if (const auto part = placementPart(def))
        return setPlacement(nodes, def, *part, std::get<glm::dvec3>(value), component, gesture);
    std::vector<TrackEdit> edits;
    for (const NodeId id : nodes) {
        const Node* node = m_document->scene().find(id);
        if (!node || !hasParam(node->kind, def))
            continue;
        for (const Channel& channel : channelsOf(def)) {
            if (component && *component != channel.component)
                continue;
            auto edit = keyed(*node, channel, now(), number(value, channel.component));
            RAMURE_TRY(edit);
            edits.push_back(std::move(*edit));
        }
    }
    return edit::setTracks(*m_document, edits, tr("Set Key"), gesture);
}

Expected<NodeAnimation> AutoKey::withKeys(const Node& node, const ParamDef& def,
                                          const ParamValue& value) const
{
    NodeAnimation animation = node.animation;
    for (const Channel& channel : channelsOf(def)) {
        auto edit = keyed(node, channel, now(), number(value, channel.component));
        RAMURE_TRY(edit);
        animation.set(channel, std::move(edit->track));
    }
    return animation;
}

/// One component of several nodes: each keeps its own others.
Expected<void> AutoKey::setPlacement(const std::vector<NodeId>& nodes, const ParamDef& def,
                                     PlacementPart part, const glm::dvec3& value,
                                     std::optional<int> component, GestureId gesture)
{
    std::vector<NodePlacing> places;
    for (const NodeId id : nodes) {
        const Node* node = m_document->scene().find(id);
        if (!node || !hasParam(node->kind, def))
            continue;
        NodePlacing place{id, {node->params.tree, globalTracks(node->animation)}, true, true};
        glm::dvec3 wanted = value;
        if (component) {
            wanted = partOf(placementAt(place.values, secondsOf(now())), part);
            wanted[*component] = value[*component];
        }
        auto made = withPlacementSet(place.values, now(), part, wanted, component);
        RAMURE_TRY(made);
        place.values = std::move(*made);
        places.push_back(std::move(place));
    }
    return edit::placeNodes(*m_document, places, tr("Set Key"), gesture);
}

Expected<void> AutoKey::toggle(const std::vector<NodeId>& nodes, const ParamDef& def)
{
    if (state(nodes, def) != KeyState::Here)
        return edit::insertKeys(*m_document, nodes, channelsOf(def), now());
    KeySelection here;
    for (const NodeId id : nodes)
        for (const Channel& channel : channelsOf(def))
            here[{id, channel}] = {now()};
    return keys::remove(*m_document, here);
}

KeyState AutoKey::state(NodeId node, const Channel& channel) const
{
    const auto track = keys::find(m_document->scene(), {node, channel});
    if (!track)
        return KeyState::None;
    return std::get<Track>(*track).find(now()) ? KeyState::Here : KeyState::Animated;
}

double AutoKey::value(NodeId node, const Channel& channel) const
{
    if (const auto track = keys::find(m_document->scene(), {node, channel}))
        return valueAt(std::get<Track>(*track), secondsOf(now()));
    return restValue(m_document->scene().find(node)->params, channel);
}

bool AutoKey::takes(NodeId node, const Channel& channel) const
{
    return m_on || state(node, channel) != KeyState::None;
}

Expected<void> AutoKey::set(NodeId node, const Channel& channel, double value, GestureId gesture)
{
    return insert(node, {{channel, value}}, tr("Set Key"), gesture);
}

Expected<void> AutoKey::insert(NodeId node, const std::vector<std::pair<Channel, double>>& values,
                               const QString& text, GestureId gesture)
{
    const Node* found = m_document->scene().find(node);
    if (!found)
        return unknownNode(node);
    std::vector<TrackEdit> edits;
    for (const auto& [channel, value] : values) {
        auto edit = keyed(*found, channel, now(), value);
        RAMURE_TRY(edit);
        edits.push_back(std::move(*edit));
    }
    return edit::setTracks(*m_document, edits, text, gesture);
}

Expected<void> AutoKey::toggle(NodeId node, const Channel& channel)
{
    if (state(node, channel) != KeyState::Here)
        return edit::insertKeys(*m_document, {node}, {channel}, now());
    return keys::remove(*m_document, {{{node, channel}, {now()}}});
}

} // namespace ramure
