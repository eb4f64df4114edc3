#include "widgets/base/action_set.h"

#include "widgets/base/theme/icons.h"
#include <QCoreApplication>
#include <QRegularExpression>
#include <algorithm>

namespace ramure {

ActionSet::ActionSet(QObject* parent)
    : QObject(parent)
{
}

QAction* ActionSet::add(const ActionSpec& spec)
{
    auto* action = new QAction(this);
    action->setObjectName(QString::fromLatin1(spec.id));
    action->setShortcut(spec.shortcut);
    if (spec.icon)
        action->setIcon(icon(spec.icon));
    m_entries.push_back({spec, action});
    setTexts(m_entries.back());
    return action;
}

void ActionSet::adopt(QAction* action)
{
    if (action->objectName().isEmpty() || find(action->objectName()))
        return;
    m_entries.push_back({{nullptr, nullptr, nullptr, action->shortcut()}, action});
}

QKeySequence ActionSet::defaultShortcut(const QAction* action) const
{
    const auto found =
        std::ranges::find_if(m_entries, [action](const Entry& entry) { return entry.action == action; });
    return found == m_entries.end() ? QKeySequence() : found->spec.shortcut;
}

void ActionSet::setShortcuts(const QMap<QString, QKeySequence>& changed)
{
    for (const Entry& entry : m_entries) {
        entry.action->setShortcut(changed.value(entry.action->objectName(), entry.spec.shortcut));
        setTexts(entry);
    }
}

void ActionSet::setTip(QAction* action, const QString& tip)
{
    const auto found =
        std::ranges::find_if(m_entries, [action](const Entry& entry) { return entry.action == action; });
    if (found == m_entries.end() || found->tip == tip)
        return;
    found->tip = tip;
    setTexts(*found);
}

void ActionSet::setText(QAction* action, const QString& text)
{
    const auto found =
        std::ranges::find_if(m_entries, [action](const Entry& entry) { return entry.action == action; });
    if (found == m_entries.end() || found->text == text)
        return;
    found->text = text;
    setTexts(*found);
}

QAction* ActionSet::find(const QString& id) const
{
    const auto found =
        std::ranges::find_if(m_entries, [&](const Entry& entry) { return entry.action->objectName() == id; });
    return found == m_entries.end() ? nullptr : found->action;
}

QList<QAction*> ActionSet::actions() const
{
    QList<QAction*> all;
    for (const Entry& entry : m_entries)
        all += entry.action;
    return all;
}

void ActionSet::setTexts(const Entry& entry)
{
    if (!entry.spec.text)
        return; // its maker names it
    const auto text = [&entry](const char* english) {
        return QCoreApplication::translate(entry.spec.context, english);
    };
    const QString shown = entry.text.isEmpty() ? text(entry.spec.text) : entry.text;
    entry.action->setText(shown);
    QString name = shown;
    static const QRegularExpression mnemonic(QStringLiteral("&(.)"));
    name.replace(mnemonic, QStringLiteral("\\1")).remove(QStringLiteral("…"));
    if (const QKeySequence keys = entry.action->shortcut(); !keys.isEmpty())
        name += QStringLiteral(" (%1)").arg(keys.toString(QKeySequence::NativeText));
    const QString tip = !entry.tip.isEmpty() ? entry.tip : entry.spec.tip ? text(entry.spec.tip) : QString();
    entry.action->setStatusTip(tip);
    // A button with an icon alone says what it is called before it says what that does.
    entry.action->setToolTip(tip.isEmpty() ? name : name + u'\n' + tip);
}

} // namespace ramure
