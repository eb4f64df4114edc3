#include "widgets/base/action_set.h"

#include "widgets/base/theme/icons.h"
#include <QRegularExpression>
#include <QWidget>
#include <algorithm>

namespace ramure {

ActionSet::ActionSet(QObject* parent)
    : QObject(parent)
{
}

QAction* ActionSet::add(QObject* owner, const ActionRow& row)
{
    auto* action = new QAction(this);
    action->setObjectName(QLatin1String(row.id));
    action->setShortcut(row.keys);
    action->setCheckable(row.isOn != nullptr);
    if (row.icon)
        action->setIcon(icon(row.icon));
    if (row.run)
        connect(action, &QAction::triggered, owner, [this, owner, run = row.run, isOn = row.isOn] {
            run();
            if (isOn)
                update(owner); // a click has changed the mark, whatever came of it
        });
    m_entries.push_back({row, action, owner});
    showTexts(m_entries.back());
    return action;
}

QList<QAction*> ActionSet::add(QObject* owner, std::initializer_list<ActionRow> rows)
{
    QList<QAction*> added;
    for (const ActionRow& row : rows)
        added += add(owner, row);
    return added;
}

void ActionSet::adopt(QAction* action)
{
    if (action->objectName().isEmpty() || find(action->objectName()))
        return;
    m_entries.push_back({{{}, {}, nullptr, action->shortcut()}, action});
}

void ActionSet::update(const QObject* owner)
{
    for (const Entry& entry : m_entries) {
        if (entry.owner != owner)
            continue;
        if (entry.row.isEnabled)
            entry.action->setEnabled(entry.row.isEnabled());
        if (entry.row.isOn)
            entry.action->setChecked(entry.row.isOn());
    }
}

QKeySequence ActionSet::defaultShortcut(const QAction* action) const
{
    const auto found = std::ranges::find(m_entries, action, &Entry::action);
    return found == m_entries.end() ? QKeySequence() : found->row.keys;
}

void ActionSet::setShortcuts(const QMap<QString, QKeySequence>& changed)
{
    for (const Entry& entry : m_entries) {
        entry.action->setShortcut(changed.value(entry.action->objectName(), entry.row.keys));
        showTexts(entry);
    }
}

void ActionSet::setTip(QAction* action, const QString& tip)
{
    if (Entry* entry = entryOf(action); entry && entry->tip != tip) {
        entry->tip = tip;
        showTexts(*entry);
    }
}

void ActionSet::setText(QAction* action, const QString& text)
{
    if (Entry* entry = entryOf(action); entry && entry->text != text) {
        entry->text = text;
        showTexts(*entry);
    }
}

QAction* ActionSet::find(const QString& id) const
{
    const auto found =
        std::ranges::find(m_entries, id, [](const Entry& entry) { return entry.action->objectName(); });
    return found == m_entries.end() ? nullptr : found->action;
}

QList<QAction*> ActionSet::find(std::initializer_list<const char*> ids) const
{
    QList<QAction*> found;
    for (const char* id : ids)
        found += find(id);
    return found;
}

QList<QAction*> ActionSet::actions() const
{
    QList<QAction*> all;
    for (const Entry& entry : m_entries)
        all += entry.action;
    return all;
}

void ActionSet::fill(QWidget* menu, std::initializer_list<const char*> ids) const
{
    for (const char* id : ids)
        if (id) {
            menu->addAction(find(id));
        } else {
            auto* separator = new QAction(menu);
            separator->setSeparator(true);
            menu->addAction(separator);
        }
}

ActionSet::Entry* ActionSet::entryOf(const QAction* action)
{
    const auto found = std::ranges::find(m_entries, action, &Entry::action);
    return found == m_entries.end() ? nullptr : &*found;
}

void ActionSet::showTexts(const Entry& entry)
{
    if (entry.row.id.isEmpty())
        return; // its maker names it
    QString name = entry.text.isEmpty() ? entry.row.text : entry.text;
    entry.action->setText(name);
    static const QRegularExpression mnemonic(QStringLiteral("&(.)"));
    name.replace(mnemonic, QStringLiteral("\\1")).remove(QStringLiteral("…"));
    if (const QKeySequence keys = entry.action->shortcut(); !keys.isEmpty())
        name += QStringLiteral(" (%1)").arg(keys.toString(QKeySequence::NativeText));
    const QString& tip = entry.tip.isEmpty() ? entry.row.tip : entry.tip;
    entry.action->setStatusTip(tip);
    // A button with an icon alone says what it is called before it says what that does.
    entry.action->setToolTip(tip.isEmpty() ? name : name + u'\n' + tip);
}

} // namespace ramure
