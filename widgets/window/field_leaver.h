/// \file
/// A number or a text that is entered, or given up, is done with: the keys after it are the view's again.
#pragma once

#include <QObject>

class QMainWindow;
class QWidget;

namespace ramure {

class FieldLeaver : public QObject
{
public:
    /// A press elsewhere, on what takes no keys itself, and Return and Esc in a field of one line, in \p
    /// window or in a panel that floats beside it, bring the focus to \p view: unless the field itself gave
    /// it to something else, or what was typed is refused. Dialogs, texts of several lines and names in lists
    /// are left alone. Neither is owned.
    FieldLeaver(QMainWindow* window, QWidget* view);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] bool isOurs(const QWidget* field) const;
    void leave(const QWidget* field);
    void pressedOn(const QWidget* pressed);

    QMainWindow* m_window;
    QWidget* m_view;
};

} // namespace ramure
