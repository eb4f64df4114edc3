/// \file
/// The tool bar at the view's left edge: groups of tools in two columns, in a low window in three, so that
/// all of them are seen.
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
    explicit ToolBox(QWidget* parent = nullptr);

    /// Below those before it. Nothing is owned.
    void addGroup(const QList<QAction*>& tools);
    /// All buttons, in the order of the tools.
    [[nodiscard]] QList<QToolButton*> buttons() const;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void place(int columns);
    [[nodiscard]] int heightOf(int columns) const;

    QList<QList<QToolButton*>> m_groups;
    QList<QFrame*> m_lines; ///< between them
    QGridLayout* m_grid = nullptr;
    int m_columns = 2;
};

} // namespace ramure
