#include "core/params/colonisation_rows.h"
#include "core/params/dress_rows.h"
#include "core/params/grown_tree_rows.h"
#include "core/params/growth_rows.h"
#include "core/params/node_rows.h"
#include "core/params/scatter_rows.h"
#include "core/params/step_rows.h"
#include "core/params/tree_edit_table.h"
#include "core/params/weber_penn_rows.h"
#include <algorithm>

namespace ramure {
namespace {

template <std::size_t... sizes> constexpr auto joined(const std::array<ParamDef, sizes>&... parts)
{
    std::array<ParamDef, (sizes + ...)> all{};
    auto end = all.begin();
    ((end = std::ranges::copy(parts, end).out), ...);
    return all;
}

/// In the order of the interface; those of steps, which no node has, come last.
constexpr auto table =
    joined(rows::growthRows, rows::weberPennRows, rows::weberPennLevel<0>, rows::weberPennLevel<1>,
           rows::weberPennLevel<2>, rows::weberPennLevel<3>, rows::colonisationRows, rows::grownTreeRows,
           rows::modelRows, rows::dressRows, rows::nodeRows, rows::scatterRows, rows::stepRows);

constexpr std::array facts{rows::grammarFacts, rows::weberPennFacts, rows::colonisationFacts,
                           rows::growthFacts, rows::drawnFacts};
static_assert(facts.size() == firstSources.size());

} // namespace

const SourceFacts& sourceFacts(const NodeParams& params)
{
    return *std::ranges::find(facts, params.generator.kind, &SourceFacts::source);
}

double trunkRadius(const NodeParams& params)
{
    return sourceFacts(params).trunkRadius(params);
}

std::span<const ParamDef> allParams()
{
    return table;
}

std::span<const ParamDef> paramTable()
{
    return allParams().first(table.size() - rows::stepRows.size());
}

const ParamDef* findParam(std::string_view key)
{
    const auto found =
        std::ranges::find(table, key, [](const ParamDef& def) { return std::string_view(def.key); });
    return found == table.end() ? nullptr : &*found;
}

ParamId paramId(const ParamDef& def)
{
    return static_cast<ParamId>(&def - table.data());
}

bool hasParam(NodeKind kind, const ParamDef& def)
{
    return (def.kinds & kindBit(kind)) != 0;
}

} // namespace ramure
