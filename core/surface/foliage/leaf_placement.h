/// \file
/// Where the leaves of a plant stand: node by node along every twig, each on the bark. Internal to
/// place_foliage.cpp.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/surface/foliage/foliage.h"

namespace ramure {

/// What all foliage of one tree needs.
struct Placing
{
    const Skeleton& skeleton;
    std::vector<Index> twigs;        ///< branches that carry foliage
    std::vector<std::uint8_t> isTip; ///< per branch: it has no children
    double alpha;
    std::uint64_t seed;
};

/// The error of a limit; \p path is the parameter to lower.
tl::unexpected<Error> tooMuchFoliage(const char* text, std::size_t limit, const char* path);

/// Most triangles that the leaves of one tree may have.
inline constexpr std::size_t maxLeafFaces = 40'000'000;

/// Nodes are an internode apart on a twig's curve (SPEC A4), the first past the fork; the arrangement says
/// how many leaves stand at each and how far around each is from the last. Two rows and pairs in a plane lie
/// left and right of a level twig. A twig that ends the branch has a leaf at its tip. Petioles begin on the
/// bark: at the branch's radius from its curve.
///
/// Twig b draws from Random(seed, RandomStream::TwigLeaves, key of b): more nodes keep the first ones.
/// Errors: Limit (more than maxLeaves, or than maxLeafFaces in all; path = foliage.internode).
/// \pre the shape is not Faithful.
Expected<std::vector<FoliageItem>> placeLeaves(const Placing& placing, const LeafParams& params,
                                               const Progress& progress = {});

} // namespace ramure
