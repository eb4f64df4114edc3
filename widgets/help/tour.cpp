#include "widgets/help/tour.h"

#include "core/qt/document/document.h"
#include "widgets/base/action_list.h"
#include "widgets/base/action_set.h"
#include "widgets/help/callout.h"
#include "widgets/view/viewport.h"
#include "widgets/view/viewport_host.h"
#include <QApplication>
#include <QDockWidget>
#include <QKeyEvent>
#include <QMainWindow>
#include <QToolBar>
#include <array>

namespace ramure {
namespace {

struct TourStep
{
    const char* title;  ///< context "Tour"
    const char* text;   ///< %1: the keys of the action
    const char* action; ///< id; null: none belongs to it
    const char* dock;   ///< what the box points at; null: the action's button in the toolbar, else the view
};

constexpr std::array steps{
    TourStep{QT_TRANSLATE_NOOP("Tour", "Look around"),
             QT_TRANSLATE_NOOP("Tour", "Hold the middle mouse button and drag to turn the view. Drag with "
                                       "Shift to move it; turn the wheel to zoom. %1 shows the whole tree."),
             "view.frameAll", nullptr},
    TourStep{QT_TRANSLATE_NOOP("Tour", "Grow another tree"),
             QT_TRANSLATE_NOOP("Tour",
                               "Press %1: the same rules grow another tree. Undo brings the first one "
                               "back."),
             "edit.newTree", nullptr},
    TourStep{QT_TRANSLATE_NOOP("Tour", "Change it"),
             QT_TRANSLATE_NOOP("Tour",
                               "Drag a number or its slider, or type a value such as 18 deg. The tree "
                               "follows while you drag. F1 on a row explains it."),
             nullptr, "propertiesDock"},
    TourStep{QT_TRANSLATE_NOOP("Tour", "Let it move"),
             QT_TRANSLATE_NOOP("Tour", "Press %1 to play: the tree moves in the wind. While it plays, drag a "
                                       "branch and let it go."),
             "play.toggle", "timelineDock"},
    TourStep{QT_TRANSLATE_NOOP("Tour", "Take it with you"),
             QT_TRANSLATE_NOOP("Tour",
                               "%1 writes the mesh for other programs, or pictures. Anything else: F3 "
                               "finds every command, F1 opens the handbook."),
             "file.export", nullptr},
};

QString tourText(const char* english)
{
    return QCoreApplication::translate("Tour", english);
}

/// Null where the action has no button there.
QWidget* toolButton(const QMainWindow& window, QAction* action)
{
    for (const QToolBar* bar : window.findChildren<QToolBar*>())
        if (QWidget* button = bar->widgetForAction(action); button && button->isVisible())
            return button;
    return nullptr;
}

} // namespace

Tour::Tour(QMainWindow* window, ActionSet* actions, Document* document)
    : QObject(window)
    , m_window(window)
    , m_actions(actions)
    , m_document(document)
{
}

int Tour::stepCount()
{
    return static_cast<int>(steps.size());
}

void Tour::start()
{
    if (!m_callout) {
        m_callout = new Callout(m_window);
        connect(m_callout, &Callout::leaveRequested, this, &Tour::leave);
        connect(m_callout, &Callout::nextRequested, this, [this] { show(m_step + 1); });
        connect(m_callout, &Callout::backRequested, this, [this] { show(m_step - 1); });
        qApp->installEventFilter(this);
    }
    show(0);
}

void Tour::leave()
{
    if (!m_callout)
        return;
    qApp->removeEventFilter(this);
    for (const QMetaObject::Connection& each : m_watched)
        disconnect(each);
    m_watched.clear();
    m_callout->hide();
    m_callout->deleteLater();
    m_callout = nullptr;
    if (auto* host = m_window->findChild<ViewportHost*>(); host && host->viewport())
        host->viewport()->setFocus();
    emit finished();
}

void Tour::show(int step)
{
    if (step >= stepCount())
        return leave();
    m_step = std::max(0, step);
    m_callout->setDone(false);
    showTexts();
    m_callout->pointAt(target());
    watch();
}

/// What the box of this step points at.
QWidget* Tour::target() const
{
    const TourStep& shown = steps[static_cast<std::size_t>(m_step)];
    if (shown.dock) {
        auto* dock = m_window->findChild<QDockWidget*>(QLatin1String(shown.dock));
        dock->show();
        dock->raise();
        return dock;
    }
    QWidget* button =
        m_step > 0 ? toolButton(*m_window, m_actions->find(QLatin1String(shown.action))) : nullptr;
    return button ? button : m_window->findChild<ViewportHost*>();
}

void Tour::showTexts()
{
    const TourStep& shown = steps[static_cast<std::size_t>(m_step)];
    QString keys;
    if (const QAction* action = shown.action ? m_actions->find(QLatin1String(shown.action)) : nullptr)
        keys = action->shortcut().isEmpty() ? plainText(action->text())
                                            : action->shortcut().toString(QKeySequence::NativeText);
    const QString text = tourText(shown.text);
    m_callout->setTexts(tourText(shown.title), keys.isEmpty() ? text : text.arg(keys), m_step, stepCount());
}

/// What was asked for is noticed when it is done; it need not be.
void Tour::watch()
{
    for (const QMetaObject::Connection& each : m_watched)
        disconnect(each);
    m_watched.clear();
    const TourStep& shown = steps[static_cast<std::size_t>(m_step)];
    if (m_step == 0) {
        if (auto* host = m_window->findChild<ViewportHost*>(); host && host->viewport())
            m_watched.push_back(connect(host->viewport(), &Viewport::cameraChanged, this,
                                        [this, view = host->viewport(), before = host->viewport()->camera()] {
                                            // Only the hand turns it; it also moves when a tree is framed.
                                            if (view->camera().yawRad != before.yawRad ||
                                                view->camera().pitchRad != before.pitchRad)
                                                done();
                                        }));
    } else if (shown.action) {
        m_watched.push_back(
            connect(m_actions->find(QLatin1String(shown.action)), &QAction::triggered, this, &Tour::done));
    } else {
        m_watched.push_back(connect(m_document, &Document::changed, this, [this](const Change& change) {
            if (change.has(changeParams))
                done();
        }));
    }
}

void Tour::done()
{
    m_callout->setDone(true);
}

/// Esc leaves from everywhere in the window; menus and dialogs have their own.
bool Tour::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress)
        return false;
    const auto* widget = qobject_cast<QWidget*>(watched);
    const bool isEscape = static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape;
    const bool isOurs = widget && widget->window() == m_window && !QApplication::activePopupWidget();
    if (!isEscape || !isOurs || QApplication::mouseButtons() != Qt::NoButton)
        return false;
    event->accept();
    if (event->type() == QEvent::KeyPress)
        QMetaObject::invokeMethod(this, &Tour::leave, Qt::QueuedConnection);
    return true;
}

} // namespace ramure
