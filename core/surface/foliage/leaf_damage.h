/// \file
/// Leaves that insects, fungi or drought have marked.
#pragma once

#include "core/surface/foliage/foliage.h"

namespace ramure {

/// Makes some leaves smaller and withers them in part, by chance: each by its own address, so that more
/// damage marks those of less, too. \param share of the leaves, 0..1
void damageLeaves(const Skeleton& skeleton, double share, Foliage& foliage);

} // namespace ramure
