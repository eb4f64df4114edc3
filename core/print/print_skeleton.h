/// \file
/// A skeleton at the size of a print, without what could not be printed.
#pragma once

#include "core/print/print_options.h"
#include "core/skeleton/skeleton.h"

namespace ramure {

struct PrintSkeleton
{
    Skeleton
        skeleton; ///< m of the print; the thickest root stands at the origin, all roots at or above y = 0
    double scale = 1.0;           ///< of the print against the tree
    Index thickened = 0, cut = 0; ///< branches; one that was shortened counts as cut
    glm::dvec3 foot{0.0};         ///< m, in the tree: what stands at the origin of the print
    std::vector<Index> numberOf;  ///< by branch of the tree: the one it has become; noIndex: it was cut
};

/// How much a twig may be thicker than its share, which is what it would be at the print's scale. One that
/// would have to be more is cut, with all that grows on it.
inline constexpr double mostThickening = 1.5;

/// At a given scale. \param thinnest m, diameter. The skeleton is empty where nothing is thick enough.
PrintSkeleton printSkeletonAt(const Skeleton& tree, double scale, double thinnest);

/// The largest scale at which what is left is no higher than \p height, m: cutting twigs makes a tree lower,
/// so this is not the ratio of two heights. Error: Invalid (nothing would be left, with the height that would
/// do; a tree that does not rise above its foot).
Expected<PrintSkeleton> printSkeleton(const Skeleton& tree, double height, double thinnest);

} // namespace ramure
