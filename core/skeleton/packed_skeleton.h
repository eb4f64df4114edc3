/// \file
/// A whole skeleton as bytes, for files that keep one: little-endian, without loss.
#pragma once

#include "core/base/error.h"
#include "core/skeleton/skeleton.h"
#include <string>
#include <string_view>

namespace ramure {

/// \pre as generators and edits make it, not simplified: Skeleton::source counts up
std::string packSkeleton(const Skeleton& skeleton);
/// Errors: Invalid: the bytes are not those of packSkeleton, or break an invariant of Skeleton.
Expected<Skeleton> unpackSkeleton(std::string_view bytes);

} // namespace ramure
