/// \file
/// A mesh's defects, what crosses and collides in it, its thinnest triangles and the mesher's repairs as a
/// tree: one row per kind that occurs, below it one row each, made when the kind is opened.
#pragma once

#include "core/pipeline/tree_pipeline.h"
#include "core/surface/check/mesh_analysis.h"
#include "core/surface/mesher/branch_mesh.h"
#include "core/surface/proof/validate.h"
#include "widgets/base/texts/branch_rows.h"
#include <QAbstractItemModel>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace ramure {

struct KindText;

/// What the model shows, shared with the result it comes from. All may be null.
struct ReportSource
{
    std::shared_ptr<const MeshReport> report;
    std::shared_ptr<const BranchMesh> branches;
    TreeResult tree{}; ///< its skeletons
    std::shared_ptr<const MeshAnalysis> analysis{};
};

/// Kinds of rows that have no enumeration of their own.
enum class FindingKind : std::uint8_t {
    Collision,    ///< branches far from each other that run through each other
    ThinTriangle, ///< the worst shaped ones
};

/// "Edge 3–17", "Vertices 4 and 5" ...
QString defectName(const Defect& defect);
/// "Branch 12 with 14": a repair note in words.
QString repairName(const RepairNote& note);
/// "Faces 3 and 17", "Branches 3 and 17, 12 mm deep", "Face 3, 0.6°".
QString crossingName(const FacePair& pair);
QString collisionName(const Collision& collision);
QString thinTriangleName(const WorstFace& face);

class ReportModel : public QAbstractItemModel
{
    Q_OBJECT
public:
    enum Column { WhatColumn, BranchColumn, PlaceColumn, columnTotal };
    using Kind = std::variant<DefectKind, SkeletonRepair, PairKind, FindingKind>;
    static constexpr Index mostRows = 10'000; ///< below one kind

    using QAbstractItemModel::QAbstractItemModel;

    /// Rows are kept where the same mesh comes with a report of the same defects (OpenMesh's opinion came
    /// later).
    void setSource(ReportSource source);
    [[nodiscard]] const ReportSource& source() const { return m_source; }

    [[nodiscard]] Kind
    kind(const QModelIndex& index) const; ///< of a row or of the row above it; index must be valid
    [[nodiscard]] QModelIndex kindIndex(const Kind& kind) const;
    /// What it is called and what it means, in the mesh that is shown.
    [[nodiscard]] KindText textOf(const Kind& kind) const;
    /// Null for the rows of kinds.
    [[nodiscard]] const Defect* defect(const QModelIndex& index) const;
    [[nodiscard]] const RepairNote* repair(const QModelIndex& index) const;
    [[nodiscard]] const FacePair* crossing(const QModelIndex& index) const;
    [[nodiscard]] const Collision* collision(const QModelIndex& index) const;
    [[nodiscard]] const WorstFace* thinTriangle(const QModelIndex& index) const;

    [[nodiscard]] QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    [[nodiscard]] QModelIndex parent(const QModelIndex& child) const override;
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] bool hasChildren(const QModelIndex& parent = {}) const override;
    [[nodiscard]] bool canFetchMore(const QModelIndex& parent) const override;
    void fetchMore(const QModelIndex& parent) override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    struct Group
    {
        Kind kind;
        std::uint64_t total = 0;        ///< counted, also beyond mostRows
        std::vector<std::size_t> items; ///< places in the report's or the mesh's list
        bool fetched = false;
    };

    void makeGroups();
    void addDefects();
    void addFindings();
    void addRepairs();
    void addGroup(const Kind& kind, std::uint64_t total, std::vector<std::size_t> items);
    /// Where the row stands in the list of its kind; nothing for the rows of other kinds.
    [[nodiscard]] std::optional<std::size_t> itemOf(const QModelIndex& index, const Kind& kind) const;
    [[nodiscard]] QString nameOf(const QModelIndex& index) const;
    /// noIndex where a defect is of none.
    [[nodiscard]] std::vector<Index> branchesOf(const QModelIndex& index) const;
    /// As the scene panel calls them, a line each.
    [[nodiscard]] QString branchNames(const QModelIndex& index) const;
    [[nodiscard]] std::optional<glm::dvec3> placeOf(const QModelIndex& index) const;
    [[nodiscard]] bool isGroup(const QModelIndex& index) const { return index.internalId() == 0; }
    [[nodiscard]] const Group& groupOf(const QModelIndex& index) const;
    [[nodiscard]] QString groupText(const Group& group) const;
    [[nodiscard]] QString itemText(const QModelIndex& index) const;

    ReportSource m_source;
    std::vector<Group> m_groups;
    mutable std::optional<BranchRows> m_rows; ///< made for the first names
};

} // namespace ramure
