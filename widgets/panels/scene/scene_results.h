/// \file
/// What a search of the scene found, as a flat list with the columns of the scene model.
#pragma once

#include "core/qt/document/selection.h"
#include "widgets/panels/scene/scene_query.h"
#include <QAbstractTableModel>
#include <vector>

namespace ramure {

class SceneModel;
struct Change;
class Document;

class SceneResults : public QAbstractTableModel
{
    Q_OBJECT
public:
    /// Neither is owned; both must outlive the list.
    SceneResults(Document* document, SceneModel* scene, QObject* parent = nullptr);

    /// Searches, and again after each change of the scene, until the query is empty.
    void setQuery(const SceneQuery& query);
    [[nodiscard]] int nodeCount() const { return static_cast<int>(m_nodes.size()); }
    /// Axes or branches, as the query says.
    [[nodiscard]] int branchCount() const { return rowCount() - nodeCount(); }
    [[nodiscard]] bool listsBranches() const { return m_listsBranches; }
    /// All that was found: the nodes, and the branches of one tree (\p preferred, where it has some, else the
    /// first that has), because branches of one tree can be selected.
    [[nodiscard]] Selection everything(NodeId preferred) const;

    /// The same row in the scene model.
    [[nodiscard]] QModelIndex toScene(const QModelIndex& index) const;
    /// Invalid where the search did not find it.
    [[nodiscard]] QModelIndex nodeIndex(NodeId node) const;
    /// The row that has the branch, perhaps with others of its axis.
    [[nodiscard]] QModelIndex branchIndex(NodeId node, Index branch) const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

private:
    struct Found
    {
        NodeId node = noNode;
        int first = 0;           ///< row of the first
        std::vector<Index> list; ///< branches or axes
    };

    void follow(const Change& change);
    void search();
    [[nodiscard]] const Found& treeAt(int row) const;

    Document* m_document;
    SceneModel* m_scene;
    SceneQuery m_query;
    std::vector<NodeId> m_nodes;
    std::vector<Found> m_trees; ///< in the scene's order; none is empty
    int m_rows = 0;
    bool m_listsBranches = false; ///< and not axes
};

} // namespace ramure
