#include "widgets/window/view_menu.h"

#include "widgets/base/branch_names.h"

namespace ramure {

ViewMenu::ViewMenu(const ViewMenuActions& actions, const Document& document, NodeId node, Index branch,
                   QWidget* parent)
    : QMenu(parent)
{
    setObjectName(QStringLiteral("viewMenu"));
    const Node* clicked = document.scene().find(node);
    if (clicked && branch != noIndex)
        addBranch(actions, document.result(node), branch);
    if (clicked)
        addNode(actions, *clicked);
    else
        addView(actions);
}

/// Style sheets draw sections without their text.
void ViewMenu::addTitle(QString text)
{
    addSeparator();
    addAction(text.replace(u'&', QStringLiteral("&&")))->setEnabled(false);
}

void ViewMenu::addBranch(const ViewMenuActions& actions, const NodeResult* tree, Index branch)
{
    if (tree && tree->tree.simplified && branch < tree->tree.simplified->skeleton.size())
        addTitle(BranchNames().branch(BranchRows(tree->tree), branch));
    addActions(actions.branches);
}

void ViewMenu::addNode(const ViewMenuActions& actions, const Node& node)
{
    addTitle(QString::fromStdString(node.name));
    addActions(actions.gestures);
    addSeparator();
    addActions(actions.nodes);
    addSeparator();
    addAction(actions.frameSelection);
    addActions(actions.isolation);
    addMenu(tr("Select"))->addActions(actions.steps);
}

void ViewMenu::addView(const ViewMenuActions& actions)
{
    addTitle(tr("View"));
    addActions(actions.view);
    addActions(actions.isolation);
    addMenu(actions.add);
    addSeparator();
    addMenu(tr("Draw as"))->addActions(actions.modes);
    addActions(actions.switches);
}

} // namespace ramure
