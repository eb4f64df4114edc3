#include "widgets/window/field_leaver.h"

#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenuBar>
#include <QPointer>
#include <QScrollBar>
#include <QToolButton>

namespace ramure {

/// The × at the end of a field (QLineEdit::setClearButtonEnabled).
static bool isClearButton(const QObject* pressed)
{
    const auto* button = qobject_cast<const QToolButton*>(pressed);
    return button && qobject_cast<const QLineEdit*>(button->parent()) && button->defaultAction() &&
           button->defaultAction()->objectName() == QLatin1String("_q_qlineeditclearaction");
}

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
    if (event->type() == QEvent::MouseButtonRelease && isClearButton(watched))
        leaveSoon(static_cast<QWidget*>(watched->parent()));
    const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    auto* field = isKey && watched == QApplication::focusWidget() ? static_cast<QWidget*>(watched) : nullptr;
    if (!field || !isOurs(field))
        return false;
    const auto* key = static_cast<QKeyEvent*>(event);
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* line = qobject_cast<const QLineEdit*>(field);
        const bool undoes = key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo);
        if (!line || line->isModified() || !undoes)
            return false;
        event->ignore();
        return true;
    }
    const bool isEscape = key->key() == Qt::Key_Escape;
    if (isEscape || key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter)
        leaveSoon(field, isEscape);
    return false;
}

/// After the field itself has had the key or the click. \param givesUp Esc: a search is given up with its
/// text.
void FieldLeaver::leaveSoon(QWidget* field, bool givesUp)
{
    const QPointer<QWidget> kept = field;
    QMetaObject::invokeMethod(
        this,
        [this, kept, givesUp] {
            if (!kept || !isOurs(kept))
                return;
            if (auto* line = qobject_cast<QLineEdit*>(kept); givesUp && line && line->isClearButtonEnabled())
                line->clear();
            leave(kept);
        },
        Qt::QueuedConnection);
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
