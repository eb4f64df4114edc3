#include "widgets/window/field_leaver.h"

#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QDialog>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMainWindow>
#include <QPointer>

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
