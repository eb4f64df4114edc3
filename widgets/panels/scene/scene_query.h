/// \file
/// What is typed into the search field of the scene panel, as a question about nodes and branches.
///
///     query      = { word | condition }                all must hold
///     condition  = quantity comparison number [ unit ] | ( "order" | "children" ) number | "terminal"
///     quantity   = "length" | "radius" | "order" | "children" | "number", or its name in the interface's
///                  language, or the beginning of either
///     comparison = "<" | "<=" | "=" | "!=" | ">=" | ">"
///
/// Words are parts of names, in any case: of nodes, and of axes (trunk, limb 3). A query with a condition
/// asks about single branches only: nodes have none of these quantities. The length is that of the whole
/// trunk, limb or twig that a branch belongs to. Lengths are in metres where no unit stands ("5 mm"); the
/// point and the comma are decimal signs.
#pragma once

#include "core/base/error.h"
#include "core/scene/scene.h"
#include "widgets/base/texts/branch_names.h"
#include <QString>
#include <QStringList>
#include <vector>

namespace ramure {

enum class BranchQuantity {
    Length,
    Radius,
    Order,
    Children, ///< branches that begin at its end
    Number,   ///< its index, as reports and files count
};

/// The names of the quantities and of "terminal" in the interface's language, for the query and its help.
QString quantityName(BranchQuantity quantity);
QString terminalName();

class SceneQuery
{
public:
    /// Errors: Syntax (a comparison without quantity or number, with the place that is meant as argument).
    static Expected<SceneQuery> parse(const QString& typed);

    [[nodiscard]] bool isEmpty() const { return m_words.isEmpty() && m_conditions.empty(); }
    [[nodiscard]] bool matchesNode(const QString& name) const;
    /// With a condition it finds branches, otherwise axes.
    [[nodiscard]] bool findsBranches() const { return !m_conditions.empty(); }
    /// Returns the matching branches of one tree, ascending.
    [[nodiscard]] std::vector<Index> matches(const BranchRows& rows, const BranchNames& names) const;

private:
    enum class Comparison { Less, LessEqual, Equal, NotEqual, GreaterEqual, Greater };
    struct Condition
    {
        BranchQuantity quantity = BranchQuantity::Length;
        Comparison comparison = Comparison::Equal;
        double number = 0.0;

        [[nodiscard]] bool holds(const BranchRows& rows, Index branch) const;
    };
    [[nodiscard]] bool hasWords(const QString& name) const;

    QStringList m_words;
    std::vector<Condition> m_conditions;
};

} // namespace ramure
