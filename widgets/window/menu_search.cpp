#include "widgets/window/menu_search.h"

#include "widgets/base/action_list.h"
#include "widgets/dialogs/palette/palette_match.h"
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QScreen>
#include <QWidgetAction>
#include <algorithm>
#include <utility>

namespace ramure {
namespace {

/// What can be chosen in a menu and below it, with the titles that lead there.
void listChoices(const QMenu& menu, const QString& above, QList<std::pair<QAction*, QString>>& choices)
{
    for (QAction* action : menu.actions()) {
        if (action->isSeparator() || !action->isEnabled() || !action->isVisible())
            continue;
        if (const QMenu* below = action->menu())
            listChoices(*below,
                        (above.isEmpty() ? above : above + QStringLiteral(" › ")) + plainText(action->text()),
                        choices);
        else
            choices.append({action, above});
    }
}

bool isTyping(const QKeyEvent& key)
{
    const bool plain = !(key.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier));
    return plain &&
           (key.key() == Qt::Key_Backspace || (!key.text().isEmpty() && key.text().front().isPrint()));
}

} // namespace

MenuSearch::MenuSearch(QMenu* menu)
    : QObject(menu)
    , m_menu(menu)
{
    auto* box = new QWidget;
    m_field = new QLineEdit(box);
    m_field->setPlaceholderText(tr("Type to find"));
    m_field->setAccessibleName(tr("Find in this menu"));
    m_field->setClearButtonEnabled(true);
    auto* layout = new QHBoxLayout(box);
    layout->setContentsMargins(6, 4, 6, 4);
    layout->addWidget(m_field);
    auto* top = new QWidgetAction(menu);
    top->setDefaultWidget(box);
    m_top = top;
    menu->insertAction(menu->actions().value(0), top);
    menu->installEventFilter(this);
    m_field->installEventFilter(this);
    connect(m_field, &QLineEdit::textChanged, this, &MenuSearch::find);
    // Behind what was chosen: it stands for an action of the menu, and is no longer needed then.
    connect(menu, &QMenu::aboutToHide, m_field, &QLineEdit::clear, Qt::QueuedConnection);
}

void MenuSearch::putBack()
{
    for (QAction* action : std::exchange(m_found, {}))
        action->deleteLater();
    for (const QPointer<QAction>& action : std::exchange(m_hidden, {}))
        if (action)
            action->setVisible(true);
}

void MenuSearch::find(const QString& typed)
{
    for (QAction* action : std::as_const(m_found))
        m_menu->removeAction(action);
    putBack();
    if (typed.trimmed().isEmpty())
        return;
    QList<std::pair<QAction*, QString>> choices;
    listChoices(*m_menu, {}, choices);
    choices.removeIf([this](const auto& choice) { return choice.first == m_top; });
    std::vector<PaletteItem> items;
    for (const auto& [action, way] : std::as_const(choices)) {
        PaletteItem& item = items.emplace_back();
        item.title = plainText(action->text());
        item.place = way;
        item.words = action->toolTip();
    }
    for (QAction* action : m_menu->actions())
        if (action != m_top && action->isVisible()) {
            action->setVisible(false);
            m_hidden += action;
        }
    for (const std::size_t i : rankedItems(items, typed, {})) {
        const auto& [action, way] = choices[qsizetype(i)];
        auto* found = new QAction(action->icon(), action->text(), this);
        if (!way.isEmpty())
            found->setText(found->text() + u'\t' + way);
        found->setToolTip(action->toolTip());
        connect(found, &QAction::triggered, action, &QAction::trigger);
        m_found += found;
        if (m_found.size() == qsizetype(most))
            break;
    }
    if (m_found.isEmpty()) {
        m_found += new QAction(tr("Nothing here is called that"), this);
        m_found.front()->setEnabled(false);
    }
    m_menu->addActions(m_found);
    m_menu->setActiveAction(m_found.front());
    const QRect room = m_menu->screen()->availableGeometry(); // it is wider now
    m_menu->move(std::max(room.left(), std::min(m_menu->x(), room.right() - m_menu->width())), m_menu->y());
}

/// Letters go to the field, whether it has the focus or not, and all other keys to the menu.
bool MenuSearch::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::KeyPress && event->type() != QEvent::ShortcutOverride)
        return QObject::eventFilter(watched, event);
    auto* key = static_cast<QKeyEvent*>(event);
    const bool types = isTyping(*key) && !(key->text() == QStringLiteral(" ") && m_field->text().isEmpty());
    if (watched == m_menu && types) {
        if (event->type() == QEvent::ShortcutOverride)
            event->accept();
        else
            QCoreApplication::sendEvent(m_field, event);
        return true;
    }
    const bool moves = key->key() == Qt::Key_Up || key->key() == Qt::Key_Down ||
                       key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter ||
                       key->key() == Qt::Key_Escape;
    if (watched == m_field && moves && event->type() == QEvent::KeyPress) {
        QCoreApplication::sendEvent(m_menu, event);
        return true;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace ramure
