/// \file
/// Variations of a tree: other seeds, and parameters spread over ranges. The editor shows them as pictures,
/// `ramure-cli batch` takes them as a table.
#pragma once

#include "core/params/param_def.h"
#include "core/scene/scene.h"
#include <QString>
#include <vector>

namespace ramure {

/// A parameter and the range of its values, in the program's units. For a flag or a choice all values are
/// used.
struct VariedParam
{
    const ParamDef* def = nullptr;
    double from = 0.0, to = 0.0;
};

/// One tree of many: the seed, then the values, in this order.
struct Variation
{
    std::int64_t seed = 1;
    std::vector<std::pair<const ParamDef*, ParamValue>> values;
    bool operator==(const Variation&) const = default;
};

/// Can its values be spread? Numbers, flags and choices of trees that have an effect beside the others; no
/// seeds.
bool canVary(const NodeParams& params, const ParamDef& def);
/// A range around the value that the tree has, inside the slider's.
VariedParam usualRange(const NodeParams& params, const ParamDef& def);

/// \p count variations with seeds that follow each other. The values of each parameter are spread evenly over
/// its range, one in each of \p count equal parts, in an order of its own: a parameter more leaves the values
/// of the others. The same numbers give the same variations. \pre count > 0
std::vector<Variation> spreadVariations(const std::vector<VariedParam>& params, std::int64_t firstSeed,
                                        int count);

/// Returns the parameters of one variation, as a row of a batch has them. Error: path = key, a value out of
/// range.
Expected<NodeParams> variedParams(const NodeParams& like, const Variation& variation);
/// Returns the values that turn a tree into the variation, for edit::setParams: its seeds, and for the
/// parameters in \p touched the variation's value or that of \p like. \pre as for variedParams, without an
/// error
std::vector<std::pair<const ParamDef*, ParamValue>>
valuesOf(const NodeParams& like, const Variation& variation, const std::vector<const ParamDef*>& touched);
/// The parameters that the variations set, each once.
std::vector<const ParamDef*> paramsOf(const std::vector<Variation>& variations);

/// Writes the table, and beside it a project file of the tree that its rows start from, with a free name:
/// "oak.csv" and "oak-tree.ramure". Errors: Io, those of saveProjectFile.
Expected<void> saveVariations(const Node& like, const std::vector<Variation>& variations,
                              const QString& path);

} // namespace ramure
