/// \file
/// What the parameters of a source say of the tree that it will grow. How it grows stands in
/// core/generators/sources.h.
#pragma once

#include "core/params/node_params.h"

namespace ramure {

/// What a source does with solids of the scene that have a role (GrowthRole).
enum class SolidUse : std::uint8_t {
    None,
    Around, ///< it grows around obstacles
    Fills,  ///< it also fills those below the tree that say so, where there are any
    Needs,  ///< it also fills them, and nothing grows without
};

/// One row per source, beside the rows of its parameters.
struct SourceFacts
{
    EditOperation source;
    const char* sizeKey;                      ///< the parameter that most likely makes a tree too large
    double (*trunkRadius)(const NodeParams&); ///< see trunkRadius()
    double (*reach)(const NodeParams&);       ///< m: how far the crown usually reaches from the trunk
    SolidUse (*solids)(const NodeParams&) = [](const NodeParams&) { return SolidUse::None; };
};
/// The facts of the source that a tree begins with.
const SourceFacts& sourceFacts(const NodeParams& params);

/// Returns the radius of a tree's trunk at the ground in m, before random variation. The sizes of leaves,
/// fruit and motion refer to it. For a grammar it is the turtle's step (SPEC A1). If the trunk's radius
/// follows from the points that it serves, it is known only after growth; then the usual share of the height
/// is returned.
double trunkRadius(const NodeParams& params);

} // namespace ramure
