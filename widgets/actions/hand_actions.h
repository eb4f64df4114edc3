/// \file
/// Shaping trees by hand: the tools with their buttons and keys, the Shape menu, and actions on the selected
/// branches that need no tool.
#pragma once

#include "core/qt/document/document.h"
#include <QObject>

class QAction;
class QActionGroup;
class QMenu;

namespace ramure {

class ActionSet;
class HandSettings;
class ViewportHost;

class HandActions : public QObject
{
    Q_OBJECT
public:
    /// Nothing is owned; all must outlive the actions. \param tools the group of which one tool is chosen;
    /// these tools join it
    HandActions(Document* document, ViewportHost* host, QActionGroup* tools, ActionSet* set, QObject* parent);

    void fillMenu(QMenu* editMenu);
    [[nodiscard]] QList<QAction*> toolActions() const { return m_tools; }
    /// The same as HandToolRow::group divides them.
    [[nodiscard]] QList<QList<QAction*>> toolGroups() const;
    /// Actions for the menus of a branch: those that act at once, and the menu of tools.
    [[nodiscard]] QList<QAction*> branchActions() const;

signals:
    void messageRaised(const QString& text);

private:
    void keepSelected();
    [[nodiscard]] bool hasBranch() const;
    void report(const Expected<void>& done);

    Document* m_document;
    HandSettings* m_settings;
    ActionSet* m_set;
    QList<QAction*> m_tools;
    QMenu* m_menu = nullptr;
};

} // namespace ramure
