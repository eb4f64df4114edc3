/// \file
/// Every action of the program in one list: texts, icons and shortcuts stand in tables, so that they can be
/// translated again, shown in a dialog and tested together.
#pragma once

#include <QAction>
#include <QKeySequence>
#include <QObject>
#include <vector>

namespace ramure {

struct ActionSpec
{
    const char* id;   ///< "file.open"; the action's objectName
    const char* text; ///< English, with a mnemonic, context "Actions"
    const char* icon; ///< of resources/icons, or null
    QKeySequence shortcut;
    const char* tip = nullptr; ///< English, context "Actions"; null: the text serves
};

class ActionSet : public QObject
{
    Q_OBJECT
public:
    explicit ActionSet(QObject* parent = nullptr);

    /// The action belongs to the set.
    QAction* add(const ActionSpec& spec);
    /// Null where there is none.
    [[nodiscard]] QAction* find(const QString& id) const;
    [[nodiscard]] QList<QAction*> actions() const;
    /// Texts in the present language.
    void retranslate();

private:
    struct Entry
    {
        ActionSpec spec;
        QAction* action;
    };
    static void translate(const Entry& entry);

    std::vector<Entry> m_entries;
};

} // namespace ramure
