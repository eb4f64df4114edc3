/// \file
/// The tool bar at the view's left edge: groups of tools in two columns, so that all of them are seen in a
/// low window, too.
#pragma once

#include <QFrame>
#include <QList>

class QAction;
class QGridLayout;
class QToolButton;

namespace ramure {

class ToolBox : public QFrame
{
    Q_OBJECT
public:
    using QFrame::QFrame;

    /// Below those before it. Nothing is owned.
    void addGroup(const QList<QAction*>& tools);
    /// All buttons, in the order of the tools.
    [[nodiscard]] const QList<QToolButton*>& buttons() const { return m_buttons; }

private:
    QGridLayout* grid();

    QList<QToolButton*> m_buttons;
    QGridLayout* m_grid = nullptr;
};

} // namespace ramure
