/// \file
/// The scene as a tree for item views: nodes; below a tree node its trunks, fetched on demand; below each
/// axis (trunk, limb, bough, twig: see branch_rows.h) the axes that spring from it. An axis of several
/// branches has them in a row of its own, above the others.
///
/// An index carries no pointer: its internal id names a node, or a node with an axis or a branch. The model
/// keeps its own copy of the hierarchy, compares it with the document after each change and tells views only
/// of the rows that differ.
#pragma once

#include "core/qt/document/document.h"
#include "widgets/base/texts/branch_names.h"
#include <QAbstractItemModel>
#include <functional>
#include <map>
#include <memory>

namespace ramure {

/// What a row of the scene model stands for.
struct SceneRow
{
    enum Kind {
        Node,
        Axis,
        Branches, ///< the row above the single branches of an axis
        Branch,   ///< one of several of an axis
    };
    Kind kind = Node;
    NodeId node = noNode;
    Index index = noIndex; ///< of the axis or the branch
    bool operator==(const SceneRow&) const = default;
};

class SceneModel : public QAbstractItemModel
{
    Q_OBJECT
public:
    enum Column {
        NameColumn,
        VisibleColumn,
        LockedColumn,
        LengthColumn,
        RadiusColumn,
        ChildrenColumn,
        OrderColumn
    };
    static constexpr int columns = 7;
    /// Besides Qt's roles: is this the eye or the lock of a node?
    static constexpr int isSwitchRole = Qt::UserRole;

    /// \p document is not owned and must outlive the model.
    explicit SceneModel(Document* document, QObject* parent = nullptr);
    ~SceneModel() override;

    /// noNode for the invalid index.
    [[nodiscard]] NodeId nodeAt(const QModelIndex& index) const;
    [[nodiscard]] static SceneRow rowAt(const QModelIndex& index);
    /// The branches that a row stands for, from foot to tip; none where it is a node.
    [[nodiscard]] std::span<const Index> branchesAt(const QModelIndex& index) const;
    [[nodiscard]] QModelIndex nodeIndex(NodeId node, int column = NameColumn) const;
    // These fetch the branches of the tree where they are not there yet; invalid where there is no such
    // thing.
    [[nodiscard]] QModelIndex axisIndex(NodeId node, Index axis, int column = NameColumn);
    /// The row of the axis where that has no other branch.
    [[nodiscard]] QModelIndex branchIndex(NodeId node, Index branch, int column = NameColumn);
    /// Null until the branches were fetched.
    [[nodiscard]] const BranchRows* branches(NodeId node) const;
    /// Fetches them where they are not there yet; null where the node has none.
    const BranchRows* fetchBranches(NodeId node);
    [[nodiscard]] QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    [[nodiscard]] QModelIndex parent(const QModelIndex& index) const override;
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] bool hasChildren(const QModelIndex& parent = {}) const override;
    [[nodiscard]] bool canFetchMore(const QModelIndex& parent) const override;
    void fetchMore(const QModelIndex& parent) override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    /// Name, visible and locked; through the document's commands.
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    [[nodiscard]] Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
    [[nodiscard]] QStringList mimeTypes() const override;
    [[nodiscard]] QMimeData* mimeData(const QModelIndexList& indexes) const override;
    [[nodiscard]] bool canDropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                                       const QModelIndex& parent) const override;
    bool dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                      const QModelIndex& parent) override;
    /// Texts in another language.
    /// The time in seconds at which a node that is dropped keeps its place; without it 0.
    void setTime(std::function<double()> time) { m_time = std::move(time); }
    /// Nodes that are dropped stay where they are in the world (as it is at first), or keep their position,
    /// rotation and scale and so go with their new parent.
    void setDropKeepsWorld(bool keeps) { m_dropKeepsWorld = keeps; }
    /// In the interface's language.
    [[nodiscard]] const BranchNames& names() const { return m_names; }

signals:
    /// An edit was refused; the error's text in the interface's language.
    void refused(const QString& text);
    /// The branches of a tree were replaced by others, or came for the first time.
    void branchesReplaced(ramure::NodeId node);

private:
    struct Item
    {
        NodeId parent = noNode;
        std::vector<NodeId> children;
        std::unique_ptr<BranchRows> branches;
        bool fetched = false;        ///< somebody asked for the branches
        std::size_t toldCount = 0;   ///< of the rows below, when views were told last
        mutable std::size_t row = 0; ///< among its siblings, when it was asked for last
    };

    void follow(const Change& change);
    void tellCount(NodeId node);
    void rebuild();
    void syncStructure();
    void removeGone(NodeId parent);
    void arrange(NodeId parent);
    void moveItem(NodeId node, NodeId newParent, int row);
    void insertItem(NodeId node, NodeId parent, int row);
    void takeOut(NodeId node);
    void syncBranches(NodeId node);
    void replaceBranches(NodeId node, const std::shared_ptr<const SimplifiedSkeleton>& skeleton);
    [[nodiscard]] std::shared_ptr<const SimplifiedSkeleton> skeletonOf(NodeId node) const;
    [[nodiscard]] int rowOf(NodeId node) const;
    [[nodiscard]] QModelIndex rowIndex(const SceneRow& row, int column) const;
    [[nodiscard]] std::size_t countBelow(const SceneRow& row) const;
    [[nodiscard]] std::size_t countToTell(const SceneRow& row) const;
    [[nodiscard]] const Item& item(NodeId node) const { return m_items.at(node); }
    [[nodiscard]] QVariant nodeData(const Node& node, int column, int role) const;
    [[nodiscard]] QVariant axisData(const BranchRows& rows, Index axis, int column, int role) const;
    [[nodiscard]] QVariant branchData(const BranchRows& rows, Index branch, int column, int role) const;
    [[nodiscard]] QVariant branchesData(const BranchRows& rows, Index axis, int column, int role) const;
    [[nodiscard]] QString branchCount(NodeId node) const;
    [[nodiscard]] static QString numberInReports(Index branch);
    bool report(const Expected<void>& done);

    Document* m_document;
    std::function<double()> m_time;
    bool m_dropKeepsWorld = true;
    BranchNames m_names;
    std::map<NodeId, Item> m_items; ///< noNode is the invisible root
};

} // namespace ramure
