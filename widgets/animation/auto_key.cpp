#include "widgets/animation/auto_key.h"

#include "core/document/player.h"
#include "widgets/animation/key_edits.h"

namespace ramure {
namespace {

std::vector<Channel> channelsOf(const ParamDef& def)
{
    std::vector<Channel> channels;
    const std::uint8_t count = def.type == ParamType::Vec3 ? 3 : 1;
    for (std::uint8_t c = 0; c < count; ++c)
        channels.push_back({ChannelPart::Parameter, c, paramId(def)});
    return channels;
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

Expected<void> noKeyHere()
{
    return fail(ErrorCode::Invalid, RAMURE_NOOP("this parameter has keys, but none at this frame: insert "
                                                "one with the button beside it, or switch auto-key on"));
}

/// The track with a key of this value; it goes on as the key before it does.
Expected<TrackEdit> keyed(const Node& node, const Channel& channel, Ticks time, double value)
{
    const auto present = node.animation.find(channel);
    Track track = present ? std::get<Track>(*present) : Track();
    Key key;
    if (!track.empty()) {
        const std::size_t at = track.lowerBound(time + 1);
        key = track.keys()[at == 0 ? 0 : at - 1];
    }
    key.time = time;
    key.value = value;
    if (auto good = track.insert(key); !good)
        return fail(std::move(good.error()));
    return TrackEdit{node.id, channel, std::make_shared<const AnyTrack>(std::move(track))};
}

} // namespace

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
    if ((def.flags & paramAnimatable) == 0)
        return KeyState::None;
    bool any = false, all = !nodes.empty();
    for (const NodeId id : nodes)
        for (const Channel& channel : channelsOf(def)) {
            const auto track = keys::find(m_document->scene(), {id, channel});
            any = any || track;
            all = all && track && std::get<Track>(*track).find(now());
        }
    return all ? KeyState::Here : any ? KeyState::Animated : KeyState::None;
}

ParamValue AutoKey::value(NodeId id, const ParamDef& def) const
{
    const Node& node = *m_document->scene().find(id);
    ParamValue value = def.get(node.params);
    if ((def.flags & paramAnimatable) == 0)
        return value;
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
    return (def.flags & paramAnimatable) != 0 && (m_on || state(nodes, def) != KeyState::None);
}

Expected<void> AutoKey::set(const std::vector<NodeId>& nodes, const ParamDef& def, const ParamValue& value,
                            std::optional<int> component, GestureId gesture)
{
    if (!m_on && state(nodes, def) == KeyState::Animated)
        return noKeyHere();
    if (auto good = checkValue(def, value); !good)
        return good;
    std::vector<TrackEdit> edits;
    for (const NodeId id : nodes) {
        const Node* node = m_document->scene().find(id);
        if (!node || !hasParam(node->kind, def))
            continue;
        for (const Channel& channel : channelsOf(def)) {
            if (component && *component != channel.component)
                continue;
            auto edit = keyed(*node, channel, now(), number(value, channel.component));
            if (!edit)
                return fail(std::move(edit.error()));
            edits.push_back(std::move(*edit));
        }
    }
    return edit::setTracks(*m_document, edits, tr("Set Key"), gesture);
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
    if (!m_on && state(node, channel) == KeyState::Animated)
        return noKeyHere();
    return insert(node, {{channel, value}}, tr("Set Key"), gesture);
}

Expected<void> AutoKey::insert(NodeId node, const std::vector<std::pair<Channel, double>>& values,
                               const QString& text, GestureId gesture)
{
    const Node* found = m_document->scene().find(node);
    if (!found)
        return fail(ErrorCode::Unknown, RAMURE_NOOP("there is no node %1"), {std::to_string(node)});
    std::vector<TrackEdit> edits;
    for (const auto& [channel, value] : values) {
        auto edit = keyed(*found, channel, now(), value);
        if (!edit)
            return fail(std::move(edit.error()));
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
