#include "widgets/window/view_menu.h"

#include "widgets/base/texts/branch_names.h"

namespace ramure {

ViewMenu::ViewMenu(const ViewMenuActions& actions, const Document& document, NodeId node, Index branch,
                   QWidget* parent)
    : QMenu(parent)
{
    setObjectName(QStringLiteral("viewMenu"));
    const Node* clicked = document.scene().find(node);
    if (clicked && branch != noIndex)
        addBranch(actions, document, node, branch);
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

/// Called as what is selected: the limb, or the branch alone.
void ViewMenu::addBranch(const ViewMenuActions& actions, const Document& document, NodeId node, Index branch)
{
    const NodeResult* tree = document.result(node);
    if (tree && tree->tree.simplified && branch < tree->tree.simplified->skeleton.size()) {
        const BranchRows rows(tree->tree);
        const BranchNames names;
        addTitle(document.selection().branches.size() > 1 ? names.axis(rows, rows.axisOf(branch))
                                                          : names.branch(rows, branch));
    }
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
