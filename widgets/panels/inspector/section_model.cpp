#include "widgets/panels/inspector/section_model.h"

#include "widgets/base/texts/fact_text.h"
#include <iterator>

namespace ramure {
namespace {

constexpr int tableDecimals = 4;

struct ColumnRow
{
    const char *name, *help;
    QString (*text)(const SectionFacts& section, AngleUnit unit, int decimals);
};

using Facts = const SectionFacts&;

/// By SectionModel::Column.
constexpr ColumnRow columns[] = {
    {QT_TRANSLATE_NOOP("ramure::SectionModel", "Section"),
     QT_TRANSLATE_NOOP("ramure::SectionModel", "Counted from 1 at the branch's start."),
     [](Facts s, AngleUnit, int) { return facttext::number(s.section + 1.0, 0); }},
    {QT_TRANSLATE_NOOP("ramure::SectionModel", "Parameter t"),
     QT_TRANSLATE_NOOP("ramure::SectionModel",
                       "Position of the section on the branch's curve: 0 at its start, 1 at its end."),
     [](Facts s, AngleUnit, int) { return facttext::number(s.t, 4); }},
    {QT_TRANSLATE_NOOP("ramure::SectionModel", "Arc length"),
     QT_TRANSLATE_NOOP("ramure::SectionModel", "Way along the curve from the branch's start."),
     [](Facts s, AngleUnit, int) { return facttext::length(s.arcLength); }},
    {QT_TRANSLATE_NOOP("ramure::SectionModel", "Centre"),
     QT_TRANSLATE_NOOP("ramure::SectionModel", "In the tree's space, Y up."),
     [](Facts s, AngleUnit, int decimals) { return facttext::point(s.centre, decimals); }},
    {QT_TRANSLATE_NOOP("ramure::SectionModel", "Tangent"),
     QT_TRANSLATE_NOOP("ramure::SectionModel", "Direction of the curve; the section is perpendicular to it."),
     [](Facts s, AngleUnit, int decimals) { return facttext::vector(s.tangent, decimals); }},
    {QT_TRANSLATE_NOOP("ramure::SectionModel", "Normal"),
     QT_TRANSLATE_NOOP("ramure::SectionModel",
                       "Points from the centre to the first point of the section's circle."),
     [](Facts s, AngleUnit, int decimals) { return facttext::vector(s.normal, decimals); }},
    {QT_TRANSLATE_NOOP("ramure::SectionModel", "Binormal"),
     QT_TRANSLATE_NOOP("ramure::SectionModel", "Tangent × normal: a quarter turn on from the normal."),
     [](Facts s, AngleUnit, int decimals) { return facttext::vector(s.binormal, decimals); }},
    {QT_TRANSLATE_NOOP("ramure::SectionModel", "Radius"),
     QT_TRANSLATE_NOOP("ramure::SectionModel", "Radius of the section's circle."),
     [](Facts s, AngleUnit, int) { return facttext::length(s.radius); }},
    {QT_TRANSLATE_NOOP("ramure::SectionModel", "Curvature"),
     QT_TRANSLATE_NOOP(
         "ramure::SectionModel",
         "One over the radius of the circle that fits the curve here; 0 if the curve is straight."),
     [](Facts s, AngleUnit, int) { return facttext::curvature(s.curvature); }},
    {QT_TRANSLATE_NOOP("ramure::SectionModel", "Twist per metre"),
     QT_TRANSLATE_NOOP("ramure::SectionModel", "How fast the frame turns about the curve, compared with a "
                                               "rotation-minimising frame, for which it is 0."),
     [](Facts s, AngleUnit unit, int) { return facttext::anglePerMetre(s.twistRadPerMetre, unit); }},
    {QT_TRANSLATE_NOOP("ramure::SectionModel", "Twist"),
     QT_TRANSLATE_NOOP(
         "ramure::SectionModel",
         "How far the frame is turned about the curve since the parent's end: the roll by hand and the "
         "twist up to here."),
     [](Facts s, AngleUnit unit, int) { return facttext::angle(s.twistRad, unit); }},
};
static_assert(std::size(columns) == SectionModel::columnTotal);

} // namespace

void SectionModel::setFacts(std::vector<SectionFacts> facts)
{
    const int before = rowCount(), after = static_cast<int>(facts.size());
    if (after > before) {
        beginInsertRows({}, before, after - 1);
        m_facts = std::move(facts);
        endInsertRows();
    } else if (after < before) {
        beginRemoveRows({}, after, before - 1);
        m_facts = std::move(facts);
        endRemoveRows();
    } else {
        m_facts = std::move(facts);
    }
    if (!m_facts.empty())
        emit dataChanged(index(0, 0), index(after - 1, columnTotal - 1));
}

void SectionModel::setAngleUnit(AngleUnit unit)
{
    m_unit = unit;
    if (!m_facts.empty())
        emit dataChanged(index(0, TwistPerMetreColumn), index(rowCount() - 1, TwistColumn),
                         {Qt::DisplayRole});
}

int SectionModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_facts.size());
}

int SectionModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(columnTotal);
}

QString SectionModel::columnName(int column)
{
    return tr(columns[column].name);
}

QString SectionModel::columnHelp(int column)
{
    return tr(columns[column].help);
}

QString SectionModel::valueText(const SectionFacts& section, int column, AngleUnit unit, int decimals)
{
    return columns[column].text(section, unit, decimals);
}

QVariant SectionModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid))
        return {};
    if (role == Qt::DisplayRole)
        return valueText(m_facts[static_cast<std::size_t>(index.row())], index.column(), m_unit,
                         tableDecimals);
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue(Qt::Alignment(Qt::AlignRight | Qt::AlignVCenter));
    return {};
}

QVariant SectionModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::DisplayRole)
        return columnName(section);
    if (role == Qt::ToolTipRole)
        return columnHelp(section);
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue(Qt::Alignment(Qt::AlignRight | Qt::AlignVCenter));
    return {};
}

} // namespace ramure
