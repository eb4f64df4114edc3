/// \file
/// Every action of the program in one list: texts, icons and shortcuts stand in tables, so that they can be
/// shown in a dialog and tested together.
#pragma once

#include <QAction>
#include <QKeySequence>
#include <QMap>
#include <QObject>
#include <vector>

namespace ramure {

struct ActionSpec
{
    const char* id;   ///< "file.open"; the action's objectName
    const char* text; ///< English, with a mnemonic
    const char* icon; ///< of resources/icons, or null
    QKeySequence shortcut;
    const char* tip = nullptr;       ///< as the text; null: the text serves
    const char* context = "Actions"; ///< of both for the translator
};

class ActionSet : public QObject
{
    Q_OBJECT
public:
    explicit ActionSet(QObject* parent = nullptr);

    /// The action belongs to the set.
    QAction* add(const ActionSpec& spec);
    /// Takes in an action that was made elsewhere and keeps its own texts (presets, panels, languages). It
    /// needs an objectName; the shortcut it has now is its default. Does nothing where the set has it
    /// already.
    void adopt(QAction* action);
    /// The keys an action has without the user's changes.
    [[nodiscard]] QKeySequence defaultShortcut(const QAction* action) const;
    /// Gives every action its default, or what \p changed says by the action's id.
    void setShortcuts(const QMap<QString, QKeySequence>& changed);
    /// The tip of an action of the table for now, in the present language: why it is off, say. Empty: the
    /// table's tip again.
    void setTip(QAction* action, const QString& tip);
    /// What an action of the table says for now, with a mnemonic, in the present language: what it would act
    /// on, say. Empty: the table's text again.
    void setText(QAction* action, const QString& text);
    /// Null where there is none.
    [[nodiscard]] QAction* find(const QString& id) const;
    [[nodiscard]] QList<QAction*> actions() const;

private:
    struct Entry
    {
        ActionSpec spec; ///< of adopted actions only the shortcut
        QAction* action;
        QString tip = {};  ///< for now; empty: the spec's
        QString text = {}; ///< for now; empty: the spec's
    };
    static void setTexts(const Entry& entry);

    std::vector<Entry> m_entries;
};

} // namespace ramure
