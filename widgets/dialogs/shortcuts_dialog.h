/// \file
/// Keyboard shortcuts: every action by its menu, found by typing, with keys of the user's choice.
#pragma once

#include "widgets/base/action_list.h"
#include <QDialog>

class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace ramure {

class Preferences;

class ShortcutsDialog : public QDialog
{
    Q_OBJECT
public:
    /// Nothing is owned; all must outlive the dialog. Changes are applied and stored at once.
    ShortcutsDialog(ActionSet* set, const QList<QMenu*>& menus, Preferences* preferences,
                    QWidget* parent = nullptr);
    ~ShortcutsDialog() override;

    /// Selects the row of this action; a search that hides it is cleared.
    void select(const QString& actionId);
    /// Gives the selected action these keys. False, with the reason shown, where another action has them.
    bool assign(const QKeySequence& keys);
    void resetSelected();
    void resetAll();
    /// Returns the text about a conflict of the typed keys with another action. Empty: they are free.
    [[nodiscard]] QString conflict() const;

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void build();
    void fill();
    QTreeWidgetItem* addHeading(const QString& text);
    void addRows();
    void addGestures();
    void filter(const QString& text);
    void selectSeen();
    void showSelected();
    void showKeys();
    void store(QAction* action, const QKeySequence& keys);
    [[nodiscard]] QAction* selectedAction() const;
    [[nodiscard]] QString ownerOf(const QKeySequence& keys, const QAction* except) const;

    ActionSet* m_set;
    QList<QMenu*> m_menus;
    Preferences* m_preferences;
    QList<ListedAction> m_listed;
    QLineEdit* m_search;
    QTreeWidget* m_tree;
    QKeySequenceEdit* m_edit;
    QLabel* m_conflict;
    QPushButton* m_remove;
    QPushButton* m_reset;
    QPushButton* m_resetAll;
};

} // namespace ramure
