/// \file
/// The menu of a right click in the view: of a branch and its tree, of a node, or of the view itself.
#pragma once

#include "core/qt/document/document.h"
#include <QMenu>

namespace ramure {

/// The window's actions, by what they are about. Not owned.
struct ViewMenuActions
{
    QList<QAction*> branches;  ///< inspect, roll, straighten
    QList<QAction*> gestures;  ///< move, rotate, scale
    QList<QAction*> nodes;     ///< duplicate .. delete
    QList<QAction*> steps;     ///< of the selection: parents, children ..
    QList<QAction*> isolation; ///< isolate, show all
    QAction* frameSelection = nullptr;
    QList<QAction*> view;            ///< frame all, select all
    QMenu* add = nullptr;            ///< kinds of nodes
    QList<QAction*> modes, switches; ///< how the scene is drawn, what is shown of it
};

class ViewMenu : public QMenu
{
    Q_OBJECT
public:
    /// \param node noNode: of the view. \param branch noIndex: of the node
    ViewMenu(const ViewMenuActions& actions, const Document& document, NodeId node, Index branch,
             QWidget* parent);

private:
    void addTitle(QString text);
    void addBranch(const ViewMenuActions& actions, const Document& document, NodeId node, Index branch);
    void addNode(const ViewMenuActions& actions, const Node& node);
    void addView(const ViewMenuActions& actions);
};

} // namespace ramure
