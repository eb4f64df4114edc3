#include "widgets/animation/key_model.h"

#include "widgets/support/targets.h"
#include <algorithm>

namespace ramure {
namespace {

void sortOnce(std::vector<Ticks>& times)
{
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
}

KeyRow channelRow(NodeId node, const Channel& channel, const AnyTrack& track)
{
    KeyRow row;
    row.kind = KeyRow::Kind::Channel;
    row.node = node;
    row.channel = channel;
    row.tracks = {{node, channel}};
    std::visit(
        [&row](const auto& held) {
            row.times.reserve(held.size());
            row.modes.reserve(held.size());
            for (const auto& key : held.keys()) {
                row.times.push_back(key.time);
                row.modes.push_back(key.mode);
            }
        },
        track);
    return row;
}

void join(std::vector<Ticks>& all, const std::vector<Ticks>& more)
{
    all.insert(all.end(), more.begin(), more.end());
}

} // namespace

KeyModel::KeyModel(Document* document, QObject* parent)
    : QObject(parent)
    , m_document(document)
{
    connect(document, &Document::changed, this, &KeyModel::follow);
    rebuild();
}

void KeyModel::follow(const Change& change)
{
    if (change.has(changeReset)) {
        m_folded.clear();
        m_hidden.clear();
        m_wanted.clear();
    }
    if (change.has(changeReset | changeTracks | changeStructure | changeNodeState | changeSelection))
        rebuild();
}

void KeyModel::setAllNodes(bool all)
{
    if (all == m_allNodes)
        return;
    m_allNodes = all;
    rebuild();
}

void KeyModel::setFolded(NodeId node, bool folded)
{
    if (folded == isFolded(node))
        return;
    if (folded)
        m_folded.insert(node);
    else
        m_folded.erase(node);
    rebuild();
}

void KeyModel::setHidden(const TrackRef& track, bool hidden)
{
    if (hidden)
        m_hidden.insert(track);
    else
        m_hidden.erase(track);
    emit rowsChanged();
}

void KeyModel::addNode(const Node& node, KeyRow& summary)
{
    KeyRow head;
    head.kind = KeyRow::Kind::Node;
    head.node = node.id;
    std::vector<KeyRow> channels;
    channels.reserve(node.animation.tracks().size());
    for (const auto& [channel, track] : node.animation.tracks()) {
        channels.push_back(channelRow(node.id, channel, *track));
        join(head.times, channels.back().times);
        head.tracks.push_back({node.id, channel});
    }
    sortOnce(head.times);
    join(summary.times, head.times);
    summary.tracks.insert(summary.tracks.end(), head.tracks.begin(), head.tracks.end());
    m_rows.push_back(std::move(head));
    if (!isFolded(node.id))
        std::move(channels.begin(), channels.end(), std::back_inserter(m_rows));
}

void KeyModel::rebuild()
{
    m_rows.clear();
    m_rows.emplace_back();
    const std::vector<NodeId> targets = targetNodes(*m_document);
    const std::set<NodeId> wanted(targets.begin(), targets.end());
    KeyRow summary;
    for (const Node& node : m_document->scene().nodes())
        if (!node.animation.empty() && (m_allNodes || wanted.empty() || wanted.count(node.id) > 0))
            addNode(node, summary);
    sortOnce(summary.times);
    m_rows.front() = std::move(summary);
    if (m_rows.size() == 1)
        m_rows.clear();
    markSelected();
    emit rowsChanged();
    emit selectionChanged();
}

std::vector<TrackRef> KeyModel::tracks() const
{
    return m_rows.empty() ? std::vector<TrackRef>() : m_rows.front().tracks;
}

void KeyModel::setSelection(const KeySelection& selection)
{
    m_wanted = selection;
    markSelected();
    emit selectionChanged();
}

/// Keys out of sight are not selected: nobody would see what a gesture does to them.
void KeyModel::markSelected()
{
    m_selection = keys::existing(m_document->scene(), m_wanted);
    const std::vector<TrackRef> inSight = tracks();
    const std::set<TrackRef> shown(inSight.begin(), inSight.end());
    std::erase_if(m_selection, [&shown](const auto& entry) { return shown.count(entry.first) == 0; });
    for (KeyRow& row : m_rows) {
        row.selected.clear();
        for (const TrackRef& ref : row.tracks)
            if (const auto found = m_selection.find(ref); found != m_selection.end())
                join(row.selected, found->second);
        if (row.kind != KeyRow::Kind::Channel)
            sortOnce(row.selected);
    }
}

void KeyModel::select(std::size_t first, std::size_t last, Ticks from, Ticks to, SelectHow how)
{
    std::set<TrackRef> tracks;
    for (std::size_t i = first; i <= last && i < m_rows.size(); ++i)
        tracks.insert(m_rows[i].tracks.begin(), m_rows[i].tracks.end());
    KeySelection named;
    bool allSelected = true;
    for (const TrackRef& ref : tracks) {
        const auto track = keys::find(m_document->scene(), ref);
        if (!track)
            continue;
        const auto present = m_selection.find(ref);
        std::visit(
            [&](const auto& held) {
                for (std::size_t i = held.lowerBound(from); i < held.size() && held.keys()[i].time <= to;
                     ++i) {
                    const Ticks time = held.keys()[i].time;
                    named[ref].push_back(time);
                    allSelected = allSelected && present != m_selection.end() &&
                                  std::binary_search(present->second.begin(), present->second.end(), time);
                }
            },
            *track);
    }
    if (how == SelectHow::Replace)
        return setSelection(named);
    KeySelection all = m_selection;
    for (const auto& [ref, times] : named) {
        std::vector<Ticks> joined;
        const std::vector<Ticks>& before = all[ref];
        if (how == SelectHow::Toggle && allSelected)
            std::set_difference(before.begin(), before.end(), times.begin(), times.end(),
                                std::back_inserter(joined));
        else
            std::set_union(before.begin(), before.end(), times.begin(), times.end(),
                           std::back_inserter(joined));
        all[ref] = std::move(joined);
    }
    setSelection(all);
}

void KeyModel::selectTimes(Ticks from, Ticks to, SelectHow how)
{
    if (!m_rows.empty())
        select(0, 0, from, to, how);
}

} // namespace ramure
