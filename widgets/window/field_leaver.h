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
    /// Brings the focus from a field of one line, in \p window or in a panel that floats beside it, to \p
    /// view: after Return, Esc and the × that clears the field, and after a press elsewhere on what takes no
    /// keys itself. Esc also empties a field that has such a ×: what was searched for is given up. The focus
    /// stays where the field itself gave it to something else, or where what was typed is refused. Moving the
    /// pointer out of a field ends nothing, as in Blender: whoever types goes on. Ctrl+Z in a field where
    /// nothing was typed is the document's. Dialogs, texts of several lines and names in lists are left
    /// alone. Neither is owned.
    FieldLeaver(QMainWindow* window, QWidget* view);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] bool isOurs(const QWidget* field) const;
    void leave(const QWidget* field);
    void leaveSoon(QWidget* field, bool givesUp = false);
    void pressedOn(const QWidget* pressed);

    QMainWindow* m_window;
    QWidget* m_view;
};

} // namespace ramure
