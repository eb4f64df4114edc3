#include "widgets/dialogs/shortcuts_dialog.h"

#include "widgets/base/action_set.h"
#include "widgets/base/named.h"
#include "widgets/base/silence.h"
#include "widgets/base/theme/icons.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/dialogs/gesture_keys.h"
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSet>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

namespace ramure {
namespace {

enum Column { TextColumn, KeysColumn, ColumnCount };
constexpr int actionRole = Qt::UserRole;
constexpr QSize startSize(640, 620);

QAction* actionOf(const QTreeWidgetItem* item)
{
    return item ? item->data(TextColumn, actionRole).value<QAction*>() : nullptr;
}

/// One begins with the other: Qt would find the keys ambiguous.
bool overlap(const QKeySequence& a, const QKeySequence& b)
{
    return !a.isEmpty() && !b.isEmpty() &&
           (a.matches(b) != QKeySequence::NoMatch || b.matches(a) != QKeySequence::NoMatch);
}

} // namespace

ShortcutsDialog::ShortcutsDialog(ActionSet* set, const QList<QMenu*>& menus, Preferences* preferences,
                                 QWidget* parent)
    : QDialog(parent)
    , m_set(set)
    , m_menus(menus)
    , m_preferences(preferences)
    , m_search(new QLineEdit(this))
    , m_tree(new QTreeWidget(this))
    , m_edit(new QKeySequenceEdit(this))
    , m_conflict(new QLabel(this))
    , m_remove(new QPushButton(tr("No keys"), this))
    , m_reset(new QPushButton(tr("Reset"), this))
{
    build();
    setWindowTitle(tr("Keyboard shortcuts"));
    m_tree->setAccessibleName(tr("Keyboard shortcuts"));
    m_search->setPlaceholderText(tr("Search actions or keys"));
    m_search->setAccessibleName(m_search->placeholderText());
    m_tree->setHeaderLabels({tr("Action"), tr("Keys")});
    fill();
    connect(m_search, &QLineEdit::textChanged, this, &ShortcutsDialog::filter);
    connect(m_tree, &QTreeWidget::currentItemChanged, this, &ShortcutsDialog::showSelected);
    connect(m_tree, &QTreeWidget::itemDoubleClicked, m_edit, qOverload<>(&QWidget::setFocus));
    connect(m_edit, &QKeySequenceEdit::editingFinished, this, [this] {
        QAction* action = selectedAction();
        if (action && m_edit->keySequence() != action->shortcut())
            assign(m_edit->keySequence());
    });
    connect(m_remove, &QPushButton::clicked, this, [this] { assign({}); });
    connect(m_reset, &QPushButton::clicked, this, &ShortcutsDialog::resetSelected);
    connect(m_resetAll, &QPushButton::clicked, this, &ShortcutsDialog::resetAll);
    m_search->setFocus();
    resize(startSize);
}

ShortcutsDialog::~ShortcutsDialog()
{
    silenceChildren(this);
}

void ShortcutsDialog::build()
{
    auto* layout = layoutOf<QVBoxLayout>(this, 10, {16, 16, 16, 16});
    m_search->setClearButtonEnabled(true);
    m_search->addAction(icon("search"), QLineEdit::LeadingPosition);
    m_tree->setObjectName(QStringLiteral("shortcutList"));
    m_tree->setColumnCount(ColumnCount);
    m_tree->setUniformRowHeights(true);
    m_tree->header()->setStretchLastSection(false);
    m_tree->header()->setSectionResizeMode(TextColumn, QHeaderView::Stretch);
    m_tree->header()->setSectionResizeMode(KeysColumn, QHeaderView::ResizeToContents);
    layout->addWidget(m_search);
    layout->addWidget(m_tree, 1);
    auto* line = new QHBoxLayout;
    line->setSpacing(8);
    auto* label = new QLabel(tr("&Keys:"), this);
    label->setBuddy(m_edit);
    m_edit->setObjectName(QStringLiteral("keys"));
    line->addWidget(label);
    line->addWidget(m_edit, 1);
    line->addWidget(m_remove);
    line->addWidget(m_reset);
    layout->addLayout(line);
    m_conflict->setObjectName(QStringLiteral("problem"));
    m_conflict->setWordWrap(true);
    layout->addWidget(m_conflict);
    auto* buttons = new QDialogButtonBox(this);
    m_resetAll = buttons->addButton(tr("Reset all"), QDialogButtonBox::ResetRole);
    QPushButton* close = buttons->addButton(tr("Close"), QDialogButtonBox::RejectRole);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    for (QPushButton* button : {m_remove, m_reset, m_resetAll, close})
        button->setAutoDefault(false); // Enter belongs to the fields
}

void ShortcutsDialog::fill()
{
    const QString kept = selectedAction() ? selectedAction()->objectName() : QString();
    m_listed = listedActions(*m_set, m_menus);
    m_tree->clear();
    addRows();
    m_tree->expandAll();
    showKeys();
    if (!kept.isEmpty())
        select(kept);
    filter(m_search->text());
    showSelected();
}

/// Menu by menu, what stands in the menu itself before its submenus; then the gestures. Submenus that come
/// without any keys, such as the long lists of trees, stand below all else.
void ShortcutsDialog::addRows()
{
    const QString separator = QStringLiteral(" › ");
    const auto submenuOf = [&](const ListedAction& listed) {
        const qsizetype end = listed.text.lastIndexOf(separator);
        return end < 0 ? QString() : listed.menu + separator + listed.text.left(end);
    };
    QSet<QString> withKeys{QString()};
    for (const ListedAction& listed : m_listed)
        if (!m_set->defaultShortcut(listed.action).isEmpty())
            withKeys += submenuOf(listed);
    QList<ListedAction> rows = m_listed;
    for (auto first = rows.begin(), last = first; first != rows.end(); first = last) {
        last = std::find_if(first, rows.end(), [first](const auto& row) { return row.menu != first->menu; });
        std::stable_partition(first, last, [&](const auto& row) { return submenuOf(row).isEmpty(); });
    }
    QTreeWidgetItem* heading = nullptr;
    for (const bool isLater : {false, true}) {
        if (isLater)
            addGestures();
        for (const ListedAction& listed : rows) {
            const QString submenu = submenuOf(listed);
            if (withKeys.contains(submenu) == isLater)
                continue;
            const QString title = isLater ? submenu : listed.menu;
            if (!heading || heading->text(TextColumn) != title)
                heading = addHeading(title);
            auto* item = new QTreeWidgetItem(
                heading, {isLater ? listed.text.mid(submenu.size() - listed.menu.size()) : listed.text});
            item->setIcon(TextColumn, listed.action->icon());
            item->setData(TextColumn, actionRole, QVariant::fromValue(listed.action));
            item->setToolTip(TextColumn, listed.action->statusTip());
        }
    }
}

QTreeWidgetItem* ShortcutsDialog::addHeading(const QString& text)
{
    auto* heading = new QTreeWidgetItem(m_tree, {text});
    heading->setFlags(Qt::ItemIsEnabled);
    QFont bold = heading->font(TextColumn);
    bold.setBold(true);
    heading->setFont(TextColumn, bold);
    return heading;
}

/// To be read and found, not to be changed.
void ShortcutsDialog::addGestures()
{
    for (const GestureKeys& group : gestureKeys()) {
        QTreeWidgetItem* heading = addHeading(group.title);
        for (const GestureKey& key : group.keys) {
            auto* item = new QTreeWidgetItem(heading, {key.text, key.keys});
            for (const int column : {TextColumn, KeysColumn})
                item->setToolTip(column, key.text + QLatin1Char('\n') + tr("These keys cannot be changed."));
        }
    }
}

void ShortcutsDialog::showKeys()
{
    for (int i = 0; i < m_tree->topLevelItemCount(); ++i) {
        QTreeWidgetItem* heading = m_tree->topLevelItem(i);
        for (int j = 0; j < heading->childCount(); ++j) {
            QTreeWidgetItem* item = heading->child(j);
            const QAction* action = actionOf(item);
            if (!action)
                continue;
            const bool own = action->shortcut() != m_set->defaultShortcut(action);
            item->setText(KeysColumn, action->shortcut().toString(QKeySequence::NativeText));
            QFont font = m_tree->font();
            font.setBold(own); // as changed parameters are
            item->setFont(KeysColumn, font);
            item->setToolTip(KeysColumn, own ? tr("Changed; as supplied: %1")
                                                   .arg(m_set->defaultShortcut(action).isEmpty()
                                                            ? tr("no keys")
                                                            : m_set->defaultShortcut(action).toString(
                                                                  QKeySequence::NativeText))
                                             : QString());
        }
    }
}

void ShortcutsDialog::filter(const QString& text)
{
    const QStringList words = text.split(u' ', Qt::SkipEmptyParts);
    for (int i = 0; i < m_tree->topLevelItemCount(); ++i) {
        QTreeWidgetItem* heading = m_tree->topLevelItem(i);
        bool any = false;
        for (int j = 0; j < heading->childCount(); ++j) {
            QTreeWidgetItem* item = heading->child(j);
            const QString all =
                heading->text(TextColumn) + u' ' + item->text(TextColumn) + u' ' + item->text(KeysColumn);
            const bool fits = std::all_of(words.begin(), words.end(), [&](const QString& word) {
                return all.contains(word, Qt::CaseInsensitive);
            });
            item->setHidden(!fits);
            any = any || fits;
        }
        heading->setHidden(!any);
    }
    selectSeen();
}

/// Keys go to the selected row: it has to be one that is seen.
void ShortcutsDialog::selectSeen()
{
    if (m_tree->currentItem() && !m_tree->currentItem()->isHidden())
        return;
    QTreeWidgetItemIterator first(m_tree, QTreeWidgetItemIterator::NotHidden);
    while (*first && !actionOf(*first))
        ++first;
    m_tree->setCurrentItem(*first);
}

QAction* ShortcutsDialog::selectedAction() const
{
    return actionOf(m_tree->currentItem());
}

void ShortcutsDialog::select(const QString& actionId)
{
    for (QTreeWidgetItemIterator it(m_tree); *it; ++it) {
        const QAction* action = actionOf(*it);
        if (!action || action->objectName() != actionId)
            continue;
        if ((*it)->isHidden())
            m_search->clear();
        m_tree->setCurrentItem(*it);
        return;
    }
}

void ShortcutsDialog::showSelected()
{
    const QAction* action = selectedAction();
    m_edit->setEnabled(action);
    m_edit->setKeySequence(action ? action->shortcut() : QKeySequence());
    m_remove->setEnabled(action && !action->shortcut().isEmpty());
    m_reset->setEnabled(action && action->shortcut() != m_set->defaultShortcut(action));
    m_conflict->clear();
}

QString ShortcutsDialog::ownerOf(const QKeySequence& keys, const QAction* except) const
{
    for (const ListedAction& listed : m_listed)
        if (listed.action != except && overlap(listed.action->shortcut(), keys))
            return listed.menu + QStringLiteral(" › ") + listed.text;
    return {};
}

bool ShortcutsDialog::assign(const QKeySequence& keys)
{
    QAction* action = selectedAction();
    if (!action)
        return false;
    const QString owner = ownerOf(keys, action);
    if (!owner.isEmpty()) {
        m_conflict->setText(tr("%1 already belongs to “%2”. Take it away there first, or choose other keys.")
                                .arg(keys.toString(QKeySequence::NativeText), owner));
        return false;
    }
    store(action, keys);
    showSelected();
    return true;
}

void ShortcutsDialog::store(QAction* action, const QKeySequence& keys)
{
    const bool own = keys != m_set->defaultShortcut(action);
    m_preferences->setShortcut(action->objectName(), own ? std::optional(keys) : std::nullopt);
    m_set->setShortcuts(m_preferences->shortcuts());
    showKeys();
}

void ShortcutsDialog::resetSelected()
{
    if (const QAction* action = selectedAction())
        assign(m_set->defaultShortcut(action));
}

void ShortcutsDialog::resetAll()
{
    m_preferences->clearShortcuts();
    m_set->setShortcuts({});
    showKeys();
    showSelected();
}

QString ShortcutsDialog::conflict() const
{
    return m_conflict->text();
}

void ShortcutsDialog::keyPressEvent(QKeyEvent* event)
{
    // Enter in the search goes to what was found.
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (enter && m_search->hasFocus() && selectedAction()) {
        m_edit->setFocus();
        return;
    }
    QDialog::keyPressEvent(event);
}

} // namespace ramure
