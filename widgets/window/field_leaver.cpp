#include "widgets/window/field_leaver.h"

#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QDialog>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenuBar>
#include <QPointer>
#include <QScrollBar>

namespace ramure {

FieldLeaver::FieldLeaver(QMainWindow* window, QWidget* view)
    : QObject(window)
    , m_window(window)
    , m_view(view)
{
    qApp->installEventFilter(this);
}

bool FieldLeaver::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::MouseButtonPress)
        pressedOn(qobject_cast<QWidget*>(watched));
    if (event->type() != QEvent::KeyPress || watched != QApplication::focusWidget())
        return false;
    const int key = static_cast<QKeyEvent*>(event)->key();
    auto* field = static_cast<QWidget*>(watched);
    if ((key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Escape) && isOurs(field)) {
        // The field takes the key first.
        const QPointer<QWidget> kept = field;
        QMetaObject::invokeMethod(
            this,
            [this, kept] {
                if (kept)
                    leave(kept);
            },
            Qt::QueuedConnection);
    }
    return false;
}

/// On what takes no keys itself: those that follow are for the view, not for the field. Bars that scroll
/// what the field is about, and menus, whose actions may be about its text, leave it alone.
void FieldLeaver::pressedOn(const QWidget* pressed)
{
    const QWidget* field = QApplication::focusWidget();
    if (!field || !pressed || !isOurs(field) || pressed->window() != field->window())
        return;
    if (qobject_cast<const QScrollBar*>(pressed) || qobject_cast<const QMenuBar*>(pressed))
        return;
    for (const QWidget* around = pressed; around; around = around->parentWidget())
        if (around == field || (around->isEnabled() && (around->focusPolicy() & Qt::ClickFocus)))
            return; // it has the keys, or gets them
    leave(field);
}

bool FieldLeaver::isOurs(const QWidget* field) const
{
    if (!qobject_cast<const QLineEdit*>(field) && !qobject_cast<const QAbstractSpinBox*>(field))
        return false;
    for (const QWidget* around = field->parentWidget(); around; around = around->parentWidget()) {
        if (around == m_window)
            return true;
        if (qobject_cast<const QDialog*>(around) || qobject_cast<const QAbstractItemView*>(around))
            return false;
    }
    return false;
}

void FieldLeaver::leave(const QWidget* field)
{
    if (QApplication::focusWidget() != field || field->property("refused").toBool())
        return;
    if (field->window() != m_window)
        m_window->activateWindow();
    m_view->setFocus(Qt::OtherFocusReason);
}

} // namespace ramure
