#include "widgets/view/view_click.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWidget>
#include <utility>

namespace ramure {

ViewClick::ViewClick(QWidget* view, std::function<void(std::optional<QPointF>)> done)
    : QObject(view)
    , m_view(view)
    , m_done(std::move(done))
{
    view->setFocus();
    view->installEventFilter(this);
    QApplication::setOverrideCursor(Qt::CrossCursor);
}

ViewClick::~ViewClick()
{
    if (m_done)
        QApplication::restoreOverrideCursor();
}

bool ViewClick::eventFilter(QObject* watched, QEvent* event)
{
    std::optional<QPointF> at;
    bool isEnd = false;
    switch (event->type()) {
    case QEvent::ShortcutOverride: // Esc lays no tool down
    case QEvent::KeyPress:
        if (static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape)
            break;
        event->accept();
        isEnd = event->type() == QEvent::KeyPress;
        if (!isEnd)
            return true;
        break;
    case QEvent::MouseButtonPress: {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        if (mouse->button() == Qt::LeftButton)
            at = mouse->position();
        isEnd = true;
        break;
    }
    default:
        break;
    }
    if (!isEnd)
        return QObject::eventFilter(watched, event);
    m_view->removeEventFilter(this);
    QApplication::restoreOverrideCursor();
    deleteLater();
    std::exchange(m_done, nullptr)(at);
    return true;
}

} // namespace ramure
