#include "widgets/base/texts/branch_names.h"

namespace ramure {

BranchNames::BranchNames()
    : m_trunk(tr("Trunk"))
    , m_trunkOfMany(tr("Trunk %1"))
    , m_limb(tr("Limb %1 of the trunk, %2 m up"))
    , m_limbOfMany(tr("Limb %1 of trunk %2, %3 m up"))
    , m_bough(tr("Bough %1 of limb %2, %3 m along"))
    , m_twigOfBough(tr("Twig %1 of bough %2, %3 m along"))
    , m_twig(tr("Twig %1 of twig %2, %3 m along"))
    , m_branch(tr("%1, branch %2 of %3"))
    , m_part(tr("Branch %1 of %2"))
{
}

QString BranchNames::metres(double length) const
{
    return m_locale.toString(length, 'f', length < 0.995 ? 2 : 1);
}

QString BranchNames::axis(const BranchRows& rows, Index axis) const
{
    const Index above = rows.above(axis);
    const QString number = counted(rows.number(axis));
    if (above == noIndex)
        return rows.isOneOfTrunks(axis) ? m_trunkOfMany.arg(number) : m_trunk;
    const QString place = metres(rows.along(axis));
    switch (rows.order(axis)) {
    case 1:
        return rows.isOneOfTrunks(above) ? m_limbOfMany.arg(number, counted(rows.number(above)), place)
                                         : m_limb.arg(number, place);
    case 2:
        return m_bough.arg(number, counted(rows.number(above)), place);
    case 3:
        return m_twigOfBough.arg(number, counted(rows.number(above)), place);
    default:
        return m_twig.arg(number, counted(rows.number(above)), place);
    }
}

QString BranchNames::branch(const BranchRows& rows, Index branch) const
{
    const Index axis = rows.axisOf(branch);
    const std::size_t count = rows.branches(axis).size();
    const QString name = this->axis(rows, axis);
    return count == 1 ? name
                      : m_branch.arg(name, counted(rows.place(branch)), m_locale.toString(qulonglong(count)));
}

QString BranchNames::part(const BranchRows& rows, Index branch) const
{
    const std::size_t count = rows.branches(rows.axisOf(branch)).size();
    return m_part.arg(counted(rows.place(branch)), m_locale.toString(qulonglong(count)));
}

QString BranchNames::way(const BranchRows& rows, Index axis) const
{
    QString text = this->axis(rows, axis);
    for (Index at = rows.above(axis); at != noIndex; at = rows.above(at))
        text += u'\n' + this->axis(rows, at);
    return text;
}

} // namespace ramure
