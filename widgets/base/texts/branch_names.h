/// \file
/// Names of branches in the interface, by order and place: "Limb 3 of the trunk, 1.9 m up".
#pragma once

#include "widgets/base/texts/branch_rows.h"
#include <QCoreApplication>
#include <QLocale>
#include <QString>

namespace ramure {

/// Names in the language of the moment at which it is made. Make one for many names: it looks the texts up
/// once.
class BranchNames
{
    Q_DECLARE_TR_FUNCTIONS(BranchNames)
public:
    BranchNames();

    /// "Bough 2 of limb 3, 0.45 m along".
    [[nodiscard]] QString axis(const BranchRows& rows, Index axis) const;
    /// Names the axis and the place of the branch in it; the axis alone if it has only this branch.
    [[nodiscard]] QString branch(const BranchRows& rows, Index branch) const;
    /// "Branch 2 of 7", below its axis.
    [[nodiscard]] QString part(const BranchRows& rows, Index branch) const;
    /// Names an axis and its ancestors, one below the other.
    [[nodiscard]] QString way(const BranchRows& rows, Index axis) const;

private:
    [[nodiscard]] QString metres(double length) const;
    [[nodiscard]] QString counted(Index number) const { return m_locale.toString(number + 1); }

    QLocale m_locale;
    QString m_trunk, m_trunkOfMany, m_limb, m_limbOfMany, m_bough, m_twigOfBough, m_twig, m_branch, m_part;
};

} // namespace ramure
