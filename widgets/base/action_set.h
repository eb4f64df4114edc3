/// \file
/// Every action of the program in one list. Actions are rows of tables: menus, tool bars, the palette and the
/// dialog of shortcuts find them by their ids.
#pragma once

#include <QAction>
#include <QCoreApplication>
#include <QKeySequence>
#include <QMap>
#include <QObject>
#include <functional>
#include <vector>

class QMenu;

namespace ramure {

/// Texts of actions: Actions::tr("&Undo").
struct Actions
{
    Q_DECLARE_TR_FUNCTIONS(Actions)
};

constexpr int noKeys = 0;

struct ActionRow
{
    QByteArray id;              ///< "file.open"; the action's objectName
    QString text;               ///< with a mnemonic
    const char* icon = nullptr; ///< name in resources/icons, or null
    QKeySequence keys = {};
    QString tip = {};                     ///< empty: the text serves
    std::function<void()> run = {};       ///< null: others connect to it
    std::function<bool()> isEnabled = {}; ///< asked by ActionSet::update; null: it is enabled
    std::function<bool()> isOn = {};      ///< likewise; null: the action is not checkable
};

class ActionSet : public QObject
{
    Q_OBJECT
public:
    explicit ActionSet(QObject* parent = nullptr);

    /// The action belongs to the set. \param owner with whose end it no longer runs
    QAction* add(QObject* owner, const ActionRow& row);
    QList<QAction*> add(QObject* owner, std::initializer_list<ActionRow> rows);
    /// Takes in an action that was made elsewhere and keeps its own texts (presets, panels, languages). It
    /// needs an objectName; the shortcut it has now is its default. Does nothing where the set has it
    /// already.
    void adopt(QAction* action);
    /// Updates which actions of \p owner are enabled and checked.
    void update(const QObject* owner);
    /// The keys an action has without the user's changes.
    [[nodiscard]] QKeySequence defaultShortcut(const QAction* action) const;
    /// Gives every action its default, or what \p changed says by the action's id.
    void setShortcuts(const QMap<QString, QKeySequence>& changed);
    /// The tip of an action of the table for now: why it is off, say. Empty: the table's tip again.
    void setTip(QAction* action, const QString& tip);
    /// Replaces the text of an action, with a mnemonic, for example to name its target. An empty text
    /// restores the table's text.
    void setText(QAction* action, const QString& text);
    /// Null where there is none.
    [[nodiscard]] QAction* find(const QString& id) const;
    [[nodiscard]] QAction* find(const char* id) const { return find(QLatin1String(id)); }
    /// \pre there are such actions.
    [[nodiscard]] QList<QAction*> find(std::initializer_list<const char*> ids) const;
    [[nodiscard]] QList<QAction*> actions() const;
    /// Appends actions to \p menu. \param ids null: a separator
    void fill(QWidget* menu, std::initializer_list<const char*> ids) const;

private:
    struct Entry
    {
        ActionRow row; ///< for adopted actions only the shortcut is set
        QAction* action;
        const QObject* owner = nullptr;
        QString tip = {};  ///< for now; empty: the row's
        QString text = {}; ///< for now; empty: the row's
    };
    static void showTexts(const Entry& entry);
    [[nodiscard]] Entry* entryOf(const QAction* action);

    std::vector<Entry> m_entries;
};

} // namespace ramure
