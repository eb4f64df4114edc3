#include "widgets/panels/inspector/section_model.h"

#include "widgets/base/texts/fact_text.h"

namespace ramure {
namespace {

constexpr int tableDecimals = 4;

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
    switch (column) {
    case SectionColumn:
        return tr("Section");
    case ParameterColumn:
        return tr("Parameter t");
    case ArcLengthColumn:
        return tr("Arc length");
    case CentreColumn:
        return tr("Centre");
    case TangentColumn:
        return tr("Tangent");
    case NormalColumn:
        return tr("Normal");
    case BinormalColumn:
        return tr("Binormal");
    case RadiusColumn:
        return tr("Radius");
    case CurvatureColumn:
        return tr("Curvature");
    case TwistPerMetreColumn:
        return tr("Twist per metre");
    case TwistColumn:
        return tr("Twist");
    default:
        return {};
    }
}

QString SectionModel::columnHelp(int column)
{
    switch (column) {
    case SectionColumn:
        return tr("Counted from 1 at the branch's start.");
    case ParameterColumn:
        return tr("Where the section is on the branch's curve: 0 at its start, 1 at its end.");
    case ArcLengthColumn:
        return tr("Way along the curve from the branch's start.");
    case CentreColumn:
        return tr("In the tree's space, Y up.");
    case TangentColumn:
        return tr("Where the curve goes; the section lies across it.");
    case NormalColumn:
        return tr("Points from the centre to the first point of the section's circle.");
    case BinormalColumn:
        return tr("Tangent × normal: a quarter turn on from the normal.");
    case RadiusColumn:
        return tr("Of the section's circle.");
    case CurvatureColumn:
        return tr("One over the radius of the circle that fits the curve here; 0 where it is straight.");
    case TwistPerMetreColumn:
        return tr("How fast the frame turns about the curve beyond what carrying it along needs: 0 for "
                  "rotation-minimising frames.");
    case TwistColumn:
        return tr(
            "How far the frame is turned about the curve since the parent's end: the roll by hand and the "
            "twist up to here.");
    default:
        return {};
    }
}

QString SectionModel::valueText(const SectionFacts& section, int column, AngleUnit unit, int decimals)
{
    switch (column) {
    case SectionColumn:
        return facttext::number(section.section + 1.0, 0);
    case ParameterColumn:
        return facttext::number(section.t, 4);
    case ArcLengthColumn:
        return facttext::length(section.arcLength);
    case CentreColumn:
        return facttext::point(section.centre, decimals);
    case TangentColumn:
        return facttext::vector(section.tangent, decimals);
    case NormalColumn:
        return facttext::vector(section.normal, decimals);
    case BinormalColumn:
        return facttext::vector(section.binormal, decimals);
    case RadiusColumn:
        return facttext::length(section.radius);
    case CurvatureColumn:
        return facttext::curvature(section.curvature);
    case TwistPerMetreColumn:
        return facttext::anglePerMetre(section.twistRadPerMetre, unit);
    case TwistColumn:
        return facttext::angle(section.twistRad, unit);
    default:
        return {};
    }
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
