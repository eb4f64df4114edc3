/// \file
/// The masses that branches carry, apples included.
#pragma once

#include "core/skeleton/skeleton.h"
#include "core/surface/foliage/foliage.h"
#include <vector>

namespace ramure {

/// SPEC A7 for all branches in one backward pass: a1, 0.075 more where the branch carries an apple, and the
/// masses of the children. Apples on branches that the skeleton does not have are passed over.
std::vector<double> branchMasses(const Skeleton& skeleton, const Foliage& foliage);

} // namespace ramure
