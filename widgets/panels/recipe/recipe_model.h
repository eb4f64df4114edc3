/// \file
/// The recipe of one tree: the source that it begins with, then its steps in the order in which they act, a
/// row each, to be renamed, switched on and off and moved. Ten hand edits and more that follow each other
/// have a row of their own above them, to be folded. Places in the list count from 0, the source, whatever is
/// folded.
#pragma once

#include "core/params/tree_edit.h"
#include "core/qt/document/document.h"
#include "core/recipe/edit_report.h"
#include <QAbstractItemModel>

namespace ramure {

/// "Length × 1.25", in the interface's language.
QString editText(const TreeEdit& edit);
/// "Weber and Penn": the source that a recipe begins with.
QString sourceText(const NodeParams& params);

class RecipeModel : public QAbstractItemModel
{
    Q_OBJECT
public:
    enum Column { Name, Limb, Time, Columns };
    /// Id of the first row, whose values are the tree's own. No step has it.
    static constexpr std::uint64_t sourceId = 0;

    /// \p document is not owned and must outlive the model.
    explicit RecipeModel(Document* document, QObject* parent = nullptr);

    /// The tree that is selected, or the only one; noNode where there is none.
    [[nodiscard]] NodeId tree() const { return m_tree; }
    [[nodiscard]] const std::vector<TreeEdit>& edits() const { return m_edits; }
    [[nodiscard]] std::uint64_t idAt(int place) const;
    /// A place in the list; -1: there is none.
    [[nodiscard]] int rowOf(std::uint64_t id) const;
    /// The places of a row: one, or those of all edits below it.
    [[nodiscard]] std::vector<int> placesOf(const QModelIndex& index) const;
    [[nodiscard]] QModelIndex indexOf(int place, int column = Name) const;
    [[nodiscard]] bool isGroup(const QModelIndex& index) const;
    [[nodiscard]] bool hasGroups() const { return !m_groups.empty(); }
    /// Counts all places: the source and the steps.
    [[nodiscard]] int placeCount() const;
    /// Steps behind the source.
    [[nodiscard]] int editCount() const { return static_cast<int>(m_edits.size()); }
    /// \pre it is a step's, from 1 on.
    [[nodiscard]] const TreeEdit& editAt(int place) const { return m_edits[std::size_t(place - 1)]; }
    /// Returns the branches of the simplified skeleton that the row is about.
    [[nodiscard]] std::vector<Index> branchesAt(int place) const;
    /// Without a place in the tree as it is now.
    [[nodiscard]] bool isLost(int place) const;
    /// Whether the source or step does not run, because a step below holds its result.
    [[nodiscard]] bool isFrozen(int place) const;
    /// Returns the address of the axis that the edit acts on; 0: none.
    [[nodiscard]] std::uint64_t addressAt(int place) const;

    [[nodiscard]] QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    [[nodiscard]] QModelIndex parent(const QModelIndex& index) const override;
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    [[nodiscard]] Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
    [[nodiscard]] QStringList mimeTypes() const override;
    [[nodiscard]] QMimeData* mimeData(const QModelIndexList& indexes) const override;
    bool dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                      const QModelIndex& parent) override;

signals:
    /// Another list; before it the old one.
    void listChanged();
    void refused(const QString& why);

private:
    /// Hand edits that follow each other.
    struct Group
    {
        int first = 0, count = 0; ///< places
        int row = 0;              ///< of the list
    };

    void follow(const Change& change);
    void fillGroups();
    /// \pre the row is not that of a group
    [[nodiscard]] int placeOf(const QModelIndex& index) const;
    [[nodiscard]] const Group& groupOf(const QModelIndex& index) const;
    [[nodiscard]] QVariant groupData(const Group& group, int column, int role) const;
    [[nodiscard]] QVariant stepData(int place, int column, int role) const;
    void update();
    void updateLimbs();
    [[nodiscard]] NodeId treeMeant() const;
    [[nodiscard]] const EditOutcome* outcome(int place) const;
    [[nodiscard]] QVariant sourceData(int column, int role) const;
    [[nodiscard]] static QString timeText(double seconds);
    bool report(const Expected<void>& done);

    Document* m_document;
    NodeId m_tree = noNode;
    QString m_source;
    std::vector<TreeEdit> m_edits;
    std::shared_ptr<const EditReport> m_report;
    double m_sourceSeconds = 0.0; ///< TreeResult::sourceSeconds
    std::vector<QString> m_limbs; ///< by step: what it acts on
    std::vector<Group> m_groups;
    std::vector<int> m_rows; ///< of the list: a place; below 0: -1 - the number of a group
};

} // namespace ramure
