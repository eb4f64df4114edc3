/// \file
/// The Edit menu: undo, redo, another random tree, and what happens to the selected nodes.
#pragma once

#include "core/qt/document/document.h"
#include "widgets/base/chooser.h"
#include "widgets/view/render/camera.h"
#include <QObject>
#include <functional>
#include <map>
#include <optional>

class QAction;
class QMenu;

namespace ramure {

class ActionSet;
class DeletedSelection;
struct NodeKindRow;

class EditActions : public QObject
{
    Q_OBJECT
public:
    /// Nothing is owned; all must outlive the actions.
    EditActions(Document* document, Chooser* chooser, ActionSet* set, QObject* parent);

    void fillMenu(QMenu* menu);
    [[nodiscard]] QMenu* addMenu() const { return m_addMenu; } ///< after fillMenu
    /// Actions for the context menu of a node.
    [[nodiscard]] QList<QAction*> nodeActions() const;
    /// For one copy of a scatter. \param parent owns them
    QList<QAction*> copyActions(NodeId scatter, std::uint32_t key, QObject* parent);

    /// From where the artist looks: a new camera stands there.
    void setEye(std::function<Camera()> eye) { m_eye = std::move(eye); }

    void newTree();
    /// \param preset as namedTree takes it \param place world; nothing: where there is room.
    void addTree(const QString& preset, const std::optional<glm::dvec3>& place = {});
    /// True if a preset that is dropped on the node can replace it: it is a tree that can be changed.
    [[nodiscard]] bool canBecome(NodeId tree) const;
    /// \pre canBecome.
    void makeLike(NodeId tree, const QString& preset);
    void addKind(const NodeKindRow& row);
    /// \param shape name of an item of primitive.shape, \param label name of the new node.
    void addPrimitive(const char* shape, const QString& label);

signals:
    void renameRequested();
    /// Others of this tree's kind are wished for.
    void moreRequested(NodeId tree);
    /// Many variations of this tree are wished for.
    void variationsRequested(NodeId tree);
    void messageRaised(const QString& text);
    /// The copies are selected, at the places of their originals.
    void duplicated();
    /// The selected nodes are called so now: "tree", "3 nodes"; empty where there are none.
    void targetNamed(const QString& words);

private:
    void addRows();
    void follow(const Change& change);
    void update();
    [[nodiscard]] bool canVary() const;
    void updateTexts();
    void updateUndoTexts();
    void removeSelected();
    void duplicateSelected();
    void straightenSelected();
    [[nodiscard]] int goingBranches() const;
    [[nodiscard]] std::vector<std::uint64_t> selectedBends() const;
    void toggleVisible();
    void toggleLocked();
    [[nodiscard]] NodeId parentOfNew() const;
    [[nodiscard]] std::vector<NodeId> whatCanBeCopied() const;
    void addNode(Node node);
    void report(const Error& error);
    template <class Value> void reportFailure(const Expected<Value>& done)
    {
        if (!done)
            report(done.error());
    }
    [[nodiscard]] std::vector<NodeId> selected() const { return m_document->selection().nodes; }

    Document* m_document;
    Chooser* m_chooser;
    ActionSet* m_set;
    DeletedSelection* m_deleted;
    std::function<Camera()> m_eye;
    QList<QAction*> m_addKinds; ///< add a node that needs no further input, one action per kind
    QMenu* m_addMenu = nullptr;
};

/// Keeps the space bar for the widgets that need it (check boxes, buttons), although it is the shortcut of
/// "New tree".
class SpaceKeeper : public QObject
{
    Q_OBJECT
public:
    using QObject::QObject;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace ramure
