/// \file
/// The bends of one tree, a row for each limb: what a hand has turned there. They are values of branches, not
/// edits of a list (core/params/tree_edit.h), and act after those.
#pragma once

#include "core/qt/document/document.h"
#include <QString>

namespace ramure {

struct BendRow
{
    std::vector<std::uint64_t> names; ///< Skeleton::name of the branches that are bent
    std::vector<Index> branches;      ///< the same, of the simplified skeleton; empty: they are gone
    QString limb;                     ///< in the interface's language
    bool operator==(const BendRow&) const = default;

    /// Not that of an edit.
    [[nodiscard]] std::uint64_t id() const { return ~names.front(); }
};

/// In the order of the branches; behind them, by the axis that they were on, those without a place in the
/// tree as it is shown.
std::vector<BendRow> bendRows(const Document& document, NodeId tree);

} // namespace ramure
