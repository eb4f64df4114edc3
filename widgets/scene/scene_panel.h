/// \file
/// The scene panel: nodes and the branches of trees; selection both ways with the document.
#pragma once

#include "core/document/document.h"
#include <QWidget>
#include <set>

class QItemSelection;
class QModelIndex;

namespace ramure {

class SceneModel;
class SceneTree;

class ScenePanel : public QWidget
{
    Q_OBJECT
public:
    /// \param document is not owned and must outlive the panel.
    explicit ScenePanel(Document* document, QWidget* parent = nullptr);

    [[nodiscard]] SceneModel* model() const { return m_model; }
    [[nodiscard]] SceneTree* view() const { return m_view; }
    /// The menu of a right click, besides the panel's own entries.
    void setMenuActions(const QList<QAction*>& actions) { m_menuActions = actions; }
    [[nodiscard]] QSize sizeHint() const override { return {360, 260}; }

public slots:
    /// Starts editing the name of the active node.
    void renameActive();

signals:
    /// For the status bar: why an edit was refused.
    void messageRaised(const QString& text);

protected:
    void changeEvent(QEvent* event) override;

private:
    void follow(const Change& change);
    void takeSelection(); ///< from the view to the document
    void showSelection(); ///< from the document to the view
    [[nodiscard]] Selection viewSelection() const;
    [[nodiscard]] QItemSelection documentSelection() const;
    void toggleState(const QModelIndex& index);
    void noteExpanded(const QModelIndex& index, bool expanded);
    void restoreExpanded(NodeId node);
    void showMenu(const QPoint& position);
    void showHeaderMenu(const QPoint& position);
    void retranslate();

    Document* m_document;
    SceneModel* m_model;
    SceneTree* m_view;
    QList<QAction*> m_menuActions;
    bool m_syncing = false;
    /// Unfolded branches by node and key: they stay unfolded when the tree is computed anew.
    std::set<std::pair<NodeId, std::uint64_t>> m_expanded;
};

} // namespace ramure
