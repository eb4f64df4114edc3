/// \file
/// The scene panel: nodes and the branches of trees, a search, selection both ways with the document.
#pragma once

#include "core/qt/document/document.h"
#include "widgets/panels/scene/scene_model.h"
#include <QWidget>
#include <set>
#include <tuple>

class QItemSelection;
class QMenu;
class QModelIndex;
class QStackedLayout;

namespace ramure {

class Preferences;
class SceneResults;
class SceneSearch;
class SceneTree;
class SelectActions;

class ScenePanel : public QWidget
{
    Q_OBJECT
public:
    /// Neither is owned; both must outlive the panel.
    ScenePanel(Document* document, Preferences* preferences, QWidget* parent = nullptr);

    [[nodiscard]] SceneModel* model() const { return m_model; }
    [[nodiscard]] SceneTree* view() const { return m_view; }
    /// Results of a search.
    [[nodiscard]] SceneResults* results() const { return m_results; }
    [[nodiscard]] SceneTree* resultView() const { return m_list; }
    [[nodiscard]] SceneSearch* search() const { return m_search; }
    /// Sets the context menu: actions on nodes, those of the Select menu, and further ones if branches are
    /// selected.
    void setMenuActions(const QList<QAction*>& actions, const SelectActions* selects = nullptr,
                        const QList<QAction*>& branches = {});
    /// Sets the function that returns the playhead's time in seconds: see SceneModel::setTime.
    void setTime(std::function<double()> time);
    [[nodiscard]] QSize sizeHint() const override { return {360, 260}; }

    /// Shows or hides a column, from now on also in the next session. Names are always shown.
    void chooseColumn(SceneModel::Column column, bool on);

public slots:
    /// Starts editing the name of the active node.
    void renameActive();
    void focusSearch();
    /// Tints the row of a branch, or the one that it is folded away in; of noNode none.
    void showPointed(ramure::NodeId node, ramure::Index branch);

signals:
    /// The row under the mouse: a node and what branches the row stands for, none of a node's; noNode where
    /// there is no row.
    void pointedAt(ramure::NodeId node, const std::vector<ramure::Index>& branches);
    /// For the status bar: why an edit was refused.
    void messageRaised(const QString& text);
    /// The selection should be brought into the middle of the view.
    void frameRequested();

private:
    void connectParts();
    void prepareView(SceneTree* view, const char* name);
    void follow(const Change& change);
    void takeSelection(); ///< from the view to the document
    void showSelection(); ///< from the document to the view
    [[nodiscard]] bool isSearching() const { return m_searching; }
    [[nodiscard]] SceneTree* presentView() const { return isSearching() ? m_list : m_view; }
    [[nodiscard]] QModelIndex toScene(const QModelIndex& index) const;
    [[nodiscard]] QModelIndex nodeRow(NodeId node) const;
    [[nodiscard]] QModelIndex branchRow(NodeId node, Index branch, bool whole) const;
    [[nodiscard]] bool isWhole(const BranchRows& rows, Index axis) const;
    [[nodiscard]] std::vector<QModelIndex> selectedBranchRows() const;
    [[nodiscard]] QModelIndex activeRow() const;
    [[nodiscard]] Selection viewSelection() const;
    [[nodiscard]] bool isSelectionShown() const;
    void addUnlisted(Selection& chosen) const;
    [[nodiscard]] Selection listed(Selection selection) const;
    void enterList();
    [[nodiscard]] QItemSelection documentSelection() const;
    void selectResults();
    void showResults();
    void toggleState(const QModelIndex& index);
    void noteExpanded(const QModelIndex& index, bool expanded);
    void restoreExpanded(NodeId node);
    void showMenu(const QPoint& position);
    void showColumns(); ///< shows the columns chosen in the preferences
    void fillColumnMenu(QMenu* menu);
    void showHeaderMenu(const QPoint& position);

    Document* m_document;
    Preferences* m_preferences;
    SceneModel* m_model;
    SceneResults* m_results;
    SceneSearch* m_search;
    SceneTree* m_view;
    SceneTree* m_list;
    QStackedLayout* m_stack;
    QList<QAction*> m_menuActions, m_branchActions;
    const SelectActions* m_selects = nullptr;
    bool m_syncing = false;
    bool m_searching = false;
    /// Unfolded axes and branch rows, by node and key of the first branch. They stay unfolded when the tree
    /// is computed anew.
    using Unfolded = std::tuple<NodeId, std::uint64_t, SceneRow::Kind>;
    std::set<Unfolded> m_expanded;
};

} // namespace ramure
