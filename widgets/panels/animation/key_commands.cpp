#include "widgets/panels/animation/key_commands.h"

#include "core/qt/session/motion/player.h"
#include "widgets/base/targets.h"
#include "widgets/base/texts/core_text.h"

namespace ramure {
namespace {

std::vector<Channel> channelsOf(KeyParts parts)
{
    std::vector<Channel> channels;
    const auto add = [&channels](ChannelPart part) {
        const std::uint8_t count = Channel{part, 0, 0}.isOrientation() ? 1 : 3;
        for (std::uint8_t c = 0; c < count; ++c)
            channels.push_back({part, c, 0});
    };
    if (parts == KeyParts::Transform || parts == KeyParts::Location)
        add(ChannelPart::GlobalTranslation);
    if (parts == KeyParts::Transform || parts == KeyParts::Rotation)
        add(ChannelPart::GlobalOrientation);
    if (parts == KeyParts::Transform || parts == KeyParts::Scale)
        add(ChannelPart::GlobalScale);
    if (parts == KeyParts::Local)
        for (const ChannelPart part :
             {ChannelPart::LocalTranslation, ChannelPart::LocalOrientation, ChannelPart::LocalScale})
            add(part);
    return channels;
}

std::vector<TrackRef> tracksOf(const Scene& scene, const std::vector<NodeId>& nodes)
{
    std::vector<TrackRef> tracks;
    for (const NodeId id : nodes)
        if (const Node* node = scene.find(id))
            for (const auto& [channel, track] : node->animation.tracks())
                tracks.push_back({id, channel});
    return tracks;
}

} // namespace

KeyCommands::KeyCommands(KeyModel* model, Player* player, QObject* parent)
    : QObject(parent)
    , m_model(model)
    , m_player(player)
{
}

Ticks KeyCommands::now() const
{
    return keys::ticksOfFrame(m_model->timeline(), double(m_player->frame()));
}

Ticks KeyCommands::frameTicks() const
{
    return keys::ticksOfFrame(m_model->timeline(), 1.0);
}

void KeyCommands::setSnapping(KeySnap snap)
{
    m_snap = snap;
}

Ticks KeyCommands::snapped(Ticks time) const
{
    switch (m_snap) {
    case KeySnap::Frame:
        return keys::snapped(time, m_model->timeline().framesPerSecond);
    case KeySnap::Second:
        return keys::snapped(time, 1.0);
    case KeySnap::None:
        break;
    }
    return time;
}

void KeyCommands::report(const Expected<void>& done)
{
    if (!done)
        emit messageRaised(errorText(done.error()));
}

void KeyCommands::take(Expected<KeySelection> selection)
{
    if (selection)
        m_model->setSelection(*selection);
    else
        emit messageRaised(errorText(selection.error()));
}

bool KeyCommands::hasSelection()
{
    if (m_model->selection().empty())
        emit messageRaised(tr("No key is selected."));
    return !m_model->selection().empty();
}

void KeyCommands::insert(KeyParts parts)
{
    const std::vector<NodeId> nodes = targetNodes(document());
    if (nodes.empty())
        return emit messageRaised(tr("Select a node first: it gets the key."));
    KeySelection inserted;
    if (parts == KeyParts::Animated) {
        const auto tracks = tracksOf(document().scene(), nodes);
        if (tracks.empty())
            return emit messageRaised(tr("The selected nodes have no keys yet."));
        report(keys::insert(document(), tracks, now()));
        for (const TrackRef& ref : tracks)
            inserted[ref] = {now()};
    } else {
        report(edit::insertKeys(document(), nodes, channelsOf(parts), now()));
        for (const NodeId node : nodes)
            for (const Channel& channel : channelsOf(parts))
                inserted[{node, channel}] = {now()};
    }
    m_model->setSelection(inserted);
}

void KeyCommands::removeAtPlayhead()
{
    KeySelection here;
    for (const TrackRef& ref : tracksOf(document().scene(), targetNodes(document())))
        here[ref] = {now()};
    here = keys::existing(document().scene(), here);
    if (here.empty())
        return emit messageRaised(tr("The selected nodes have no key at this frame."));
    report(keys::remove(document(), here));
}

void KeyCommands::remove()
{
    if (hasSelection())
        report(keys::remove(document(), m_model->selection()));
}

void KeyCommands::duplicate()
{
    if (!hasSelection())
        return;
    const auto span = *keys::spanOf(m_model->selection());
    take(
        keys::duplicate(document(), m_model->selection(), {0, 1.0, span.second - span.first + frameTicks()}));
}

void KeyCommands::copy()
{
    if (!hasSelection())
        return;
    m_clip = keys::copied(document().scene(), m_model->selection());
    emit messageRaised(tr("%n key(s) copied", nullptr, int(keys::count(m_model->selection()))));
}

void KeyCommands::cut()
{
    if (!hasSelection())
        return;
    copy();
    remove();
}

void KeyCommands::paste(bool inPlace)
{
    if (!canPaste())
        return emit messageRaised(tr("No keys have been copied."));
    take(keys::paste(document(), m_clip, document().selection().nodes, inPlace ? 0 : now() - m_clip.first));
}

void KeyCommands::mirror()
{
    if (hasSelection())
        take(keys::retime(document(), m_model->selection(), {now(), -1.0, 0}, tr("Mirror Keys")));
}

void KeyCommands::snap(KeySnap to)
{
    if (!hasSelection())
        return;
    const bool seconds = to == KeySnap::Second;
    take(keys::snap(document(), m_model->selection(), seconds ? 1.0 : m_model->timeline().framesPerSecond,
                    seconds ? tr("Snap Keys to Seconds") : tr("Snap Keys to Frames")));
}

void KeyCommands::nudge(int frames)
{
    if (hasSelection())
        retime({0, 1.0, keys::ticksOfFrame(m_model->timeline(), frames)}, false);
}

void KeyCommands::retime(const Retiming& retiming, bool copies)
{
    if (copies)
        take(keys::duplicate(document(), m_model->selection(), retiming));
    else
        take(keys::retime(document(), m_model->selection(), retiming,
                          retiming.factor == 1.0 ? tr("Move Keys") : tr("Scale Keys")));
}

void KeyCommands::shift(Ticks offset, const std::map<CurveRef, double>& values)
{
    if (hasSelection())
        take(keys::shift(document(), m_model->selection(), offset, values, tr("Move Keys")));
}

void KeyCommands::replaceKey(const TrackRef& ref, const Key& key, GestureId gesture)
{
    report(keys::replace(document(), ref, key, tr("Drag Handle"), gesture));
}

void KeyCommands::setMode(KeyMode mode)
{
    if (hasSelection())
        report(keys::reshape(
            document(), m_model->selection(), [mode](KeyShape& key) { key.mode = mode; },
            tr("Change Interpolation")));
}

void KeyCommands::setEasing(Easing easing)
{
    if (hasSelection())
        report(keys::reshape(
            document(), m_model->selection(), [easing](KeyShape& key) { key.easing = easing; },
            tr("Change Easing")));
}

void KeyCommands::setHandles(HandleType type)
{
    if (hasSelection())
        report(keys::reshape(
            document(), m_model->selection(), [type](KeyShape& key) { key.before = key.behind = type; },
            tr("Change Handles")));
}

void KeyCommands::extrapolate(bool before, bool behind, Extrapolation extrapolation)
{
    if (hasSelection())
        report(keys::extrapolate(document(), m_model->selection(), before, behind, extrapolation));
}

void KeyCommands::selectAll()
{
    m_model->selectTimes(-mostTicks, mostTicks, SelectHow::Replace);
}

void KeyCommands::selectNone()
{
    m_model->setSelection({});
}

void KeyCommands::selectColumn()
{
    m_model->selectTimes(now(), now(), SelectHow::Replace);
}

void KeyCommands::selectBefore()
{
    m_model->selectTimes(-mostTicks, now(), SelectHow::Replace);
}

void KeyCommands::selectBehind()
{
    m_model->selectTimes(now(), mostTicks, SelectHow::Replace);
}

/// A key between two frames: the frame before it is shown, and counts as being there.
void KeyCommands::seekKey(bool forward)
{
    const TimelineSettings& timeline = m_model->timeline();
    const Ticks step = frameTicks();
    const Ticks from = forward ? now() + step - 1 : now();
    const auto next = keys::nextTime(document().scene(), m_model->tracks(), from, forward);
    if (!next)
        return emit messageRaised(forward ? tr("There is no key behind this frame.")
                                          : tr("There is no key before this frame."));
    m_player->seek(timeline.frameAt(secondsOf(*next)));
}

} // namespace ramure
