#include "widgets/panels/validation/report_model.h"

#include "widgets/base/defect_place.h"
#include "widgets/base/texts/branch_names.h"
#include "widgets/base/texts/fact_text.h"
#include "widgets/panels/validation/kind_texts.h"
#include <QLocale>
#include <algorithm>

namespace ramure {
namespace {

constexpr int roughDecimals = 2; ///< the viewport shows it exactly; here it only tells top from bottom

/// Where in the list those stand that are wanted.
template <class List, class Wanted> std::vector<std::size_t> indices(const List& list, Wanted&& wanted)
{
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < list.size(); ++i)
        if (wanted(list[i]))
            found.push_back(i);
    return found;
}

} // namespace

QString defectName(const Defect& defect)
{
    switch (defect.kind) {
    case DefectKind::BoundaryEdge:
    case DefectKind::NonManifoldEdge:
    case DefectKind::InconsistentEdge:
        return ReportModel::tr("Edge %1–%2").arg(defect.a).arg(defect.b);
    case DefectKind::NonManifoldVertex:
    case DefectKind::IsolatedVertex:
        return ReportModel::tr("Vertex %1").arg(defect.a);
    case DefectKind::DuplicateVertex:
        return ReportModel::tr("Vertices %1 and %2").arg(defect.a).arg(defect.b);
    case DefectKind::DuplicateFace:
        return ReportModel::tr("Faces %1 and %2").arg(defect.a).arg(defect.b);
    case DefectKind::DegenerateFace:
        break;
    }
    return ReportModel::tr("Face %1").arg(defect.a);
}

QString repairName(const RepairNote& note)
{
    if (note.other == noIndex)
        return ReportModel::tr("Branch %1").arg(note.branch);
    return ReportModel::tr("Branch %1, now with %2").arg(note.branch).arg(note.other);
}

QString crossingName(const FacePair& pair)
{
    return ReportModel::tr("Faces %1 and %2").arg(pair.first).arg(pair.second);
}

QString collisionName(const Collision& collision)
{
    NumberFormat depth;
    depth.decimals = 1;
    depth.factor = 1000.0;
    depth.suffix = QStringLiteral("\u00a0mm");
    // The depth first: the branches have a column of their own, should there be no room.
    return ReportModel::tr("%3 deep: branches %1 and %2")
        .arg(collision.first)
        .arg(collision.second)
        .arg(depth.text(collision.depth));
}

QString thinTriangleName(const WorstFace& face)
{
    return ReportModel::tr("Face %1, %2")
        .arg(face.face)
        .arg(facttext::angle(face.smallestAngleRad, AngleUnit::Degrees));
}

void ReportModel::setSource(ReportSource source)
{
    const auto sameDefects = [](const MeshReport& a, const MeshReport& b) {
        for (int kind = 0; kind < defectKindCount; ++kind)
            if (a.count(static_cast<DefectKind>(kind)) != b.count(static_cast<DefectKind>(kind)))
                return false;
        return a.defects.size() == b.defects.size();
    };
    if (source.branches == m_source.branches && source.analysis == m_source.analysis && source.report &&
        m_source.report && sameDefects(*source.report, *m_source.report)) {
        m_source = std::move(source);
        return;
    }
    beginResetModel();
    m_source = std::move(source);
    m_rows.reset();
    makeGroups();
    endResetModel();
}

KindText ReportModel::textOf(const Kind& kind) const
{
    const auto* crossing = std::get_if<PairKind>(&kind);
    if (crossing && m_source.analysis)
        return KindTexts::ofCrossing(*crossing, *m_source.analysis);
    return std::visit([](auto one) { return KindTexts::of(one); }, kind);
}

void ReportModel::makeGroups()
{
    m_groups.clear();
    addDefects();
    addFindings();
    addRepairs();
}

void ReportModel::addGroup(const Kind& kind, std::uint64_t total, std::vector<std::size_t> items)
{
    if (total == 0)
        return;
    items.resize(std::min<std::size_t>(items.size(), mostRows));
    m_groups.push_back({kind, total, std::move(items), false});
}

void ReportModel::addDefects()
{
    if (!m_source.report)
        return;
    const MeshReport& report = *m_source.report;
    for (int k = 0; k < defectKindCount; ++k) {
        const auto kind = static_cast<DefectKind>(k);
        addGroup(kind, report.count(kind),
                 indices(report.defects, [&](const Defect& defect) { return defect.kind == kind; }));
    }
}

/// What is far from each other is listed by branches, everything else by triangles.
void ReportModel::addFindings()
{
    if (!m_source.analysis)
        return;
    const MeshAnalysis& found = *m_source.analysis;
    for (const PairKind kind : {PairKind::Same, PairKind::Siblings, PairKind::ParentChild})
        addGroup(kind, found.crossings.count(kind),
                 indices(found.crossings.pairs, [&](const FacePair& pair) { return pair.kind == kind; }));
    const auto all = [](const auto&) { return true; };
    addGroup(FindingKind::Collision, found.collisions.size(), indices(found.collisions, all));
    addGroup(FindingKind::ThinTriangle, found.quality.worst.size(), indices(found.quality.worst, all));
}

void ReportModel::addRepairs()
{
    if (!m_source.branches)
        return;
    for (int k = 0; k < repairKindCount; ++k) {
        const auto kind = static_cast<SkeletonRepair>(k);
        std::vector<std::size_t> items =
            indices(m_source.branches->repairs, [&](const RepairNote& note) { return note.kind == kind; });
        const std::size_t total = items.size();
        addGroup(kind, total, std::move(items));
    }
}

const ReportModel::Group& ReportModel::groupOf(const QModelIndex& index) const
{
    return m_groups[isGroup(index) ? static_cast<std::size_t>(index.row())
                                   : static_cast<std::size_t>(index.internalId() - 1)];
}

ReportModel::Kind ReportModel::kind(const QModelIndex& index) const
{
    return groupOf(index).kind;
}

QModelIndex ReportModel::kindIndex(const Kind& kind) const
{
    for (std::size_t i = 0; i < m_groups.size(); ++i)
        if (m_groups[i].kind == kind)
            return index(static_cast<int>(i), 0);
    return {};
}

std::optional<std::size_t> ReportModel::itemOf(const QModelIndex& index, const Kind& wanted) const
{
    if (!index.isValid() || isGroup(index) || kind(index).index() != wanted.index())
        return std::nullopt;
    // Of the kinds without a type of their own the value decides, too.
    if (std::holds_alternative<FindingKind>(wanted) && kind(index) != wanted)
        return std::nullopt;
    return groupOf(index).items[static_cast<std::size_t>(index.row())];
}

const Defect* ReportModel::defect(const QModelIndex& index) const
{
    const auto item = itemOf(index, DefectKind{});
    return item ? &m_source.report->defects[*item] : nullptr;
}

const RepairNote* ReportModel::repair(const QModelIndex& index) const
{
    const auto item = itemOf(index, SkeletonRepair{});
    return item ? &m_source.branches->repairs[*item] : nullptr;
}

const FacePair* ReportModel::crossing(const QModelIndex& index) const
{
    const auto item = itemOf(index, PairKind{});
    return item ? &m_source.analysis->crossings.pairs[*item] : nullptr;
}

const Collision* ReportModel::collision(const QModelIndex& index) const
{
    const auto item = itemOf(index, FindingKind::Collision);
    return item ? &m_source.analysis->collisions[*item] : nullptr;
}

const WorstFace* ReportModel::thinTriangle(const QModelIndex& index) const
{
    const auto item = itemOf(index, FindingKind::ThinTriangle);
    return item ? &m_source.analysis->quality.worst[*item] : nullptr;
}

QModelIndex ReportModel::index(int row, int column, const QModelIndex& parent) const
{
    if (!hasIndex(row, column, parent))
        return {};
    return createIndex(row, column, parent.isValid() ? static_cast<quintptr>(parent.row()) + 1 : quintptr(0));
}

QModelIndex ReportModel::parent(const QModelIndex& child) const
{
    if (!child.isValid() || isGroup(child))
        return {};
    return createIndex(static_cast<int>(child.internalId()) - 1, 0, quintptr(0));
}

int ReportModel::rowCount(const QModelIndex& parent) const
{
    if (!parent.isValid())
        return static_cast<int>(m_groups.size());
    if (!isGroup(parent) || parent.column() != 0)
        return 0;
    const Group& group = groupOf(parent);
    return group.fetched ? static_cast<int>(group.items.size()) : 0;
}

int ReportModel::columnCount(const QModelIndex&) const
{
    return columnTotal;
}

bool ReportModel::hasChildren(const QModelIndex& parent) const
{
    if (!parent.isValid())
        return !m_groups.empty();
    return isGroup(parent) && parent.column() == 0 && !groupOf(parent).items.empty();
}

bool ReportModel::canFetchMore(const QModelIndex& parent) const
{
    return parent.isValid() && hasChildren(parent) && !groupOf(parent).fetched;
}

void ReportModel::fetchMore(const QModelIndex& parent)
{
    if (!canFetchMore(parent))
        return;
    Group& group = m_groups[static_cast<std::size_t>(parent.row())];
    beginInsertRows(parent, 0, static_cast<int>(group.items.size()) - 1);
    group.fetched = true;
    endInsertRows();
}

QString ReportModel::groupText(const Group& group) const
{
    const QString name = textOf(group.kind).name;
    const QLocale locale;
    if (group.total <= group.items.size())
        return tr("%1: %2").arg(name, locale.toString(static_cast<qulonglong>(group.total)));
    return tr("%1: %2, the first %3 listed")
        .arg(name, locale.toString(static_cast<qulonglong>(group.total)),
             locale.toString(static_cast<qulonglong>(group.items.size())));
}

QString ReportModel::nameOf(const QModelIndex& index) const
{
    if (const Defect* bad = defect(index))
        return defectName(*bad);
    if (const FacePair* pair = crossing(index))
        return crossingName(*pair);
    if (const Collision* found = collision(index))
        return collisionName(*found);
    if (const WorstFace* face = thinTriangle(index))
        return thinTriangleName(*face);
    return repairName(*repair(index));
}

std::vector<Index> ReportModel::branchesOf(const QModelIndex& index) const
{
    static const TriangleMesh none;
    const TriangleMesh& mesh = m_source.branches ? m_source.branches->mesh : none;
    if (const Defect* bad = defect(index))
        return {defectBranch(mesh, *bad)};
    if (const FacePair* pair = crossing(index)) {
        const Index first = faceBranch(mesh, pair->first), second = faceBranch(mesh, pair->second);
        return first == second ? std::vector{first} : std::vector{first, second};
    }
    if (const Collision* found = collision(index))
        return {found->first, found->second};
    if (const WorstFace* face = thinTriangle(index))
        return {faceBranch(mesh, face->face)};
    return {repair(index)->branch};
}

QString ReportModel::branchNames(const QModelIndex& index) const
{
    if (!m_source.tree.simplified)
        return {};
    if (!m_rows)
        m_rows.emplace(m_source.tree);
    const BranchNames names;
    QStringList all;
    for (const Index branch : branchesOf(index))
        if (branch < m_rows->skeleton().size())
            all += names.branch(*m_rows, branch);
    return all.join(QLatin1Char('\n'));
}

std::optional<glm::dvec3> ReportModel::placeOf(const QModelIndex& index) const
{
    if (const Collision* found = collision(index))
        return found->place;
    if (const RepairNote* note = repair(index)) {
        const bool known =
            m_source.tree.simplified && note->branch < m_source.tree.simplified->skeleton.size();
        return known ? std::optional(m_source.tree.simplified->skeleton.p0[note->branch]) : std::nullopt;
    }
    if (!m_source.branches)
        return std::nullopt;
    const TriangleMesh& mesh = m_source.branches->mesh;
    if (const Defect* bad = defect(index))
        return defectMiddle(mesh, *bad);
    if (const FacePair* pair = crossing(index))
        return facesMiddle(mesh, {pair->first, pair->second});
    return facesMiddle(mesh, {thinTriangle(index)->face, noIndex});
}

QString ReportModel::itemText(const QModelIndex& index) const
{
    if (index.column() == WhatColumn)
        return nameOf(index);
    if (index.column() == BranchColumn) {
        QStringList numbers;
        for (const Index branch : branchesOf(index))
            numbers += branch == noIndex ? QStringLiteral("—") : QString::number(branch);
        return numbers.join(QStringLiteral(", "));
    }
    const std::optional<glm::dvec3> place = placeOf(index);
    return place ? facttext::vector(*place, roughDecimals) : QStringLiteral("—");
}

QVariant ReportModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    if (role == Qt::DisplayRole) {
        if (!isGroup(index))
            return itemText(index);
        return index.column() == WhatColumn ? QVariant(groupText(groupOf(index))) : QVariant();
    }
    if (role == Qt::ToolTipRole) {
        const QString meaning = textOf(kind(index)).meaning;
        const QString names = isGroup(index) ? QString() : branchNames(index);
        return names.isEmpty() ? meaning : names + QStringLiteral("\n\n") + meaning;
    }
    return {};
}

QVariant ReportModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case WhatColumn:
        return tr("What");
    case BranchColumn:
        return tr("Branch");
    case PlaceColumn:
        return tr("Place (m)");
    default:
        return {};
    }
}

} // namespace ramure
