#include "widgets/validation/report_model.h"

#include "widgets/inspector/fact_text.h"
#include "widgets/validation/defect_place.h"
#include "widgets/validation/kind_texts.h"
#include <QLocale>
#include <algorithm>

namespace ramure {
namespace {

constexpr int placeDecimals = 2; ///< the viewport shows it exactly; here it only tells top from bottom

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

void ReportModel::setSource(ReportSource source)
{
    const auto sameDefects = [](const MeshReport& a, const MeshReport& b) {
        for (int kind = 0; kind < defectKindCount; ++kind)
            if (a.count(static_cast<DefectKind>(kind)) != b.count(static_cast<DefectKind>(kind)))
                return false;
        return a.defects.size() == b.defects.size();
    };
    if (source.branches == m_source.branches && source.report && m_source.report &&
        sameDefects(*source.report, *m_source.report)) {
        m_source = std::move(source);
        return;
    }
    beginResetModel();
    m_source = std::move(source);
    makeGroups();
    endResetModel();
}

void ReportModel::makeGroups()
{
    m_groups.clear();
    if (m_source.report) {
        const MeshReport& report = *m_source.report;
        for (int k = 0; k < defectKindCount; ++k) {
            Group group{static_cast<DefectKind>(k), report.count(static_cast<DefectKind>(k)), {}, false};
            for (std::size_t i = 0; i < report.defects.size() && group.items.size() < mostRows; ++i)
                if (report.defects[i].kind == static_cast<DefectKind>(k))
                    group.items.push_back(i);
            if (group.total > 0)
                m_groups.push_back(std::move(group));
        }
    }
    if (!m_source.branches)
        return;
    for (int k = 0; k < repairKindCount; ++k) {
        Group group{static_cast<SkeletonRepair>(k), 0, {}, false};
        const std::vector<RepairNote>& notes = m_source.branches->repairs;
        for (std::size_t i = 0; i < notes.size(); ++i) {
            if (notes[i].kind != static_cast<SkeletonRepair>(k))
                continue;
            ++group.total;
            if (group.items.size() < mostRows)
                group.items.push_back(i);
        }
        if (group.total > 0)
            m_groups.push_back(std::move(group));
    }
}

void ReportModel::retranslate()
{
    emit headerDataChanged(Qt::Horizontal, 0, columnTotal - 1);
    if (m_groups.empty())
        return;
    emit dataChanged(index(0, 0), index(rowCount() - 1, columnTotal - 1), {Qt::DisplayRole});
    for (int row = 0; row < rowCount(); ++row) {
        const QModelIndex top = index(row, 0);
        if (rowCount(top) > 0)
            emit dataChanged(index(0, 0, top), index(rowCount(top) - 1, columnTotal - 1, top),
                             {Qt::DisplayRole});
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

const Defect* ReportModel::defect(const QModelIndex& index) const
{
    if (!index.isValid() || isGroup(index) || !std::holds_alternative<DefectKind>(kind(index)))
        return nullptr;
    return &m_source.report->defects[groupOf(index).items[static_cast<std::size_t>(index.row())]];
}

const RepairNote* ReportModel::repair(const QModelIndex& index) const
{
    if (!index.isValid() || isGroup(index) || !std::holds_alternative<SkeletonRepair>(kind(index)))
        return nullptr;
    return &m_source.branches->repairs[groupOf(index).items[static_cast<std::size_t>(index.row())]];
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
    const QString name = std::visit([](auto kind) { return kindText(kind).name; }, group.kind);
    const QLocale locale;
    if (group.total <= group.items.size())
        return tr("%1: %2").arg(name, locale.toString(group.total));
    return tr("%1: %2, the first %3 listed")
        .arg(name, locale.toString(group.total),
             locale.toString(static_cast<qulonglong>(group.items.size())));
}

QString ReportModel::itemText(const QModelIndex& index) const
{
    const Defect* bad = defect(index);
    const RepairNote* note = repair(index);
    static const TriangleMesh none;
    const TriangleMesh& mesh = m_source.branches ? m_source.branches->mesh : none;
    if (index.column() == WhatColumn)
        return bad ? defectName(*bad) : repairName(*note);
    if (index.column() == BranchColumn) {
        const Index branch = bad ? defectBranch(mesh, *bad) : note->branch;
        return branch == noIndex ? QStringLiteral("—") : QString::number(branch);
    }
    std::optional<glm::dvec3> place;
    if (bad)
        place = defectMiddle(mesh, *bad);
    else if (m_source.simplified && note->branch < m_source.simplified->skeleton.size())
        place = m_source.simplified->skeleton.p0[note->branch];
    return place ? facttext::vector(*place, placeDecimals) : QStringLiteral("—");
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
        const KindText text = std::visit([](auto kind) { return kindText(kind); }, kind(index));
        return text.meaning;
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
