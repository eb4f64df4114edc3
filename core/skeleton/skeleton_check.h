/// \file
/// Can a mesh be built from these numbers?
#pragma once

#include "core/base/error.h"
#include "core/skeleton/skeleton.h"

namespace ramure {

/// Errors: Invalid, with the first branch that has a number which is not finite, a negative radius, a parent
/// that comes after it, or a coordinate or radius beyond 1e12 m.
Expected<void> checkForMesh(const Skeleton& skeleton);

} // namespace ramure
