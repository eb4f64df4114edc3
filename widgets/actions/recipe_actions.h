/// \file
/// Steps that are added to a tree's recipe: modifiers, and sources with the values of a preset or their own.
#pragma once

#include "core/params/tree_edit.h"
#include "core/qt/document/document.h"
#include <QObject>
#include <memory>
#include <vector>

class QAction;
class QMenu;

namespace ramure {

class ActionSet;

class RecipeActions : public QObject
{
    Q_OBJECT
public:
    /// Nothing is owned; all must outlive the actions.
    RecipeActions(Document* document, ActionSet* set, QObject* parent);
    ~RecipeActions() override;

    /// Modifiers, sources, and sources like a preset.
    [[nodiscard]] QMenu* menu() const { return m_menu.get(); }
    /// To the recipe of the target tree: on the limb of the active branch where one is selected.
    void add(TreeEdit step);
    /// Keeps steps in a file of the user's folder: the menu offers them for every tree.
    void save(NodeId tree, const std::vector<std::uint64_t>& steps);
    /// Steps that were kept, at the end of the target tree's recipe, as one step of undo.
    void addOwn(const QString& name);

signals:
    void messageRaised(const QString& text);
    /// \param step its id
    void added(ramure::NodeId tree, quint64 step);

private:
    void fillMenu();
    void addPresets(QMenu* menu);
    void fillOwn();

    Document* m_document;
    ActionSet* m_set;
    std::unique_ptr<QMenu> m_menu;
    QMenu* m_own = nullptr;
};

} // namespace ramure
