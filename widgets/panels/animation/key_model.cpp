#include "widgets/panels/animation/key_model.h"

#include "widgets/base/targets.h"
#include <algorithm>
#include <iterator>
#include <utility>

namespace ramure {
namespace {

/// All of them, ascending, each once: two by two, so that equal ones, which are the most, go early.
std::vector<Ticks> united(std::vector<const std::vector<Ticks>*> all)
{
    if (all.empty())
        return {};
    std::vector<std::vector<Ticks>> made;
    made.reserve(all.size()); // each round makes at most half as many: the addresses stay
    while (all.size() > 1) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < all.size(); i += 2) {
            const std::vector<Ticks>* one = all[i];
            if (i + 1 < all.size() && *one != *all[i + 1]) {
                made.emplace_back();
                made.back().reserve(one->size() + all[i + 1]->size());
                std::set_union(one->begin(), one->end(), all[i + 1]->begin(), all[i + 1]->end(),
                               std::back_inserter(made.back()));
                one = &made.back();
            }
            all[kept++] = one;
        }
        all.resize(kept);
    }
    return *all.front();
}

KeyRow channelRow(NodeId node, const Channel& channel, const NodeAnimation::TrackPtr& track)
{
    KeyRow row;
    row.kind = KeyRow::Kind::Channel;
    row.node = node;
    row.channel = channel;
    row.tracks = {{node, channel}};
    row.track = track;
    std::visit(
        [&row](const auto& held) {
            row.times.reserve(held.size());
            row.modes.reserve(held.size());
            while (row.times.size() < held.size())
                for (const auto& key : held.keys().runFrom(row.times.size())) {
                    row.times.push_back(key.time);
                    row.modes.push_back(key.mode);
                }
        },
        *track);
    return row;
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
    markSelected();
    emit rowsChanged();
    emit selectionChanged();
}

void KeyModel::setCurvesShown(bool shown)
{
    m_curves = shown;
    markSelected();
    emit selectionChanged();
}

/// The rows as they were: what has not changed is taken over.
struct KeyModel::Before
{
    KeyRow summary;
    std::map<NodeId, KeyRow> nodes;
    std::map<TrackRef, KeyRow> channels;

    explicit Before(std::vector<KeyRow> rows)
    {
        for (KeyRow& row : rows)
            if (row.kind == KeyRow::Kind::Summary)
                summary = std::move(row);
            else if (row.kind == KeyRow::Kind::Node)
                nodes.emplace(row.node, std::move(row));
            else
                channels.emplace(row.tracks.front(), std::move(row));
    }
    /// \param same stays true where the row has the times that it had
    KeyRow channel(NodeId node, const Channel& channel, const NodeAnimation::TrackPtr& track, bool& same)
    {
        const auto found = channels.find({node, channel});
        if (found != channels.end() && found->second.track == track)
            return std::move(found->second);
        KeyRow row = channelRow(node, channel, track);
        same = same && found != channels.end() && found->second.times == row.times;
        return row;
    }
};

/// \returns whether the node has the times that it had.
bool KeyModel::addNode(const Node& node, Before& before)
{
    KeyRow head;
    head.kind = KeyRow::Kind::Node;
    head.node = node.id;
    bool same = true;
    std::vector<KeyRow> channels;
    channels.reserve(node.animation.tracks().size());
    for (const auto& [channel, track] : node.animation.tracks()) {
        channels.push_back(before.channel(node.id, channel, track, same));
        head.tracks.push_back({node.id, channel});
    }
    const auto old = before.nodes.find(node.id);
    same = same && old != before.nodes.end() && old->second.tracks == head.tracks;
    if (same) {
        head.times = std::move(old->second.times);
    } else {
        std::vector<const std::vector<Ticks>*> all;
        for (const KeyRow& row : channels)
            all.push_back(&row.times);
        head.times = united(std::move(all));
    }
    m_rows.push_back(std::move(head));
    if (!isFolded(node.id))
        std::move(channels.begin(), channels.end(), std::back_inserter(m_rows));
    return same;
}

void KeyModel::rebuild()
{
    Before before(std::exchange(m_rows, {}));
    m_rows.emplace_back();
    const std::vector<NodeId> targets = targetNodes(*m_document);
    const std::set<NodeId> wanted(targets.begin(), targets.end());
    bool same = true;
    for (const Node& node : m_document->scene().nodes())
        if (!node.animation.empty() && (m_allNodes || wanted.empty() || wanted.count(node.id) > 0))
            same = addNode(node, before) && same;
    KeyRow summary;
    std::vector<const std::vector<Ticks>*> all;
    for (const KeyRow& row : m_rows)
        if (row.kind == KeyRow::Kind::Node) {
            summary.tracks.insert(summary.tracks.end(), row.tracks.begin(), row.tracks.end());
            all.push_back(&row.times);
        }
    same = same && summary.tracks == before.summary.tracks;
    summary.times = same ? std::move(before.summary.times) : united(std::move(all));
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
    std::erase_if(m_selection, [&](const auto& entry) {
        return shown.count(entry.first) == 0 || isOutOfSight(entry.first);
    });
    for (KeyRow& row : m_rows) {
        std::vector<const std::vector<Ticks>*> all;
        for (const TrackRef& ref : row.tracks)
            if (const auto found = m_selection.find(ref); found != m_selection.end())
                all.push_back(&found->second);
        row.selected = united(std::move(all));
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
        if (!track || isOutOfSight(ref))
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
