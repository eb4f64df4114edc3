/// \file
/// What the dope sheet and the curves show: a summary row, a row per node, a row per channel with a track;
/// and which keys are selected. The selection of keys is no part of undo.
#pragma once

#include "core/qt/document/key_edits.h"
#include <QObject>
#include <set>

namespace ramure {

struct KeyRow
{
    enum class Kind : std::uint8_t { Summary, Node, Channel };

    Kind kind = Kind::Summary;
    NodeId node = noNode; ///< of Node and Channel
    Channel channel;      ///< of Channel
    std::vector<TrackRef> tracks;
    std::vector<Ticks> times;      ///< of all keys, ascending, each once
    std::vector<KeyMode> modes;    ///< of Channel: one per time
    std::vector<Ticks> selected;   ///< of `times`, those with a selected key
    NodeAnimation::TrackPtr track; ///< of Channel: what times and modes were read from
};

/// How a selection goes together with the one before.
enum class SelectHow : std::uint8_t { Replace, Add, Toggle };

class KeyModel : public QObject
{
    Q_OBJECT
public:
    /// \param document is not owned and must outlive the model.
    explicit KeyModel(Document* document, QObject* parent = nullptr);

    [[nodiscard]] Document* document() const { return m_document; }
    [[nodiscard]] const TimelineSettings& timeline() const { return m_document->scene().timeline(); }
    /// Returns the rows of the selected nodes, or of all nodes with keys if none is selected or all are
    /// wanted.
    [[nodiscard]] const std::vector<KeyRow>& rows() const { return m_rows; }
    /// All tracks in sight, those in folded rows too.
    [[nodiscard]] std::vector<TrackRef> tracks() const;
    void setAllNodes(bool all);
    [[nodiscard]] bool isFolded(NodeId node) const { return m_folded.count(node) > 0; }
    void setFolded(NodeId node, bool folded);
    [[nodiscard]] bool isHidden(const TrackRef& track) const { return m_hidden.count(track) > 0; }
    /// Hidden channels have no curve; their keys stay.
    void setHidden(const TrackRef& track, bool hidden);
    /// Curves are looked at: keys of hidden channels are then out of sight, and none of them is selected.
    void setCurvesShown(bool shown);

    /// The selected keys that are there.
    [[nodiscard]] const KeySelection& selection() const { return m_selection; }
    void setSelection(const KeySelection& selection);
    /// The keys of rows first..last with times from..to.
    void select(std::size_t first, std::size_t last, Ticks from, Ticks to, SelectHow how);
    /// All keys in sight at these times.
    void selectTimes(Ticks from, Ticks to, SelectHow how);

signals:
    void rowsChanged();
    void selectionChanged();

private:
    void follow(const Change& change);
    void rebuild();
    struct Before;
    bool addNode(const Node& node, Before& before);
    void markSelected();
    [[nodiscard]] bool isOutOfSight(const TrackRef& track) const { return m_curves && isHidden(track); }

    Document* m_document;
    std::vector<KeyRow> m_rows;
    KeySelection m_selection; ///< what is there
    KeySelection m_wanted;    ///< what was selected: keys come back by undo and redo
    std::set<NodeId> m_folded;
    std::set<TrackRef> m_hidden;
    bool m_allNodes = false;
    bool m_curves = false;
};

} // namespace ramure
