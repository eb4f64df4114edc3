#include "core/surface/mesh/largest_index.h"

#include "core/base/wide_clone.h"
#include <algorithm>

namespace ramure {
namespace {

RAMURE_WIDEST_CLONE Index largestOf(const Index* indices, std::size_t count)
{
    Index largest = 0;
    for (std::size_t i = 0; i < count; ++i)
        largest = std::max(largest, indices[i]);
    return largest;
}

} // namespace

Index largestIndex(std::span<const glm::uvec3> triangles)
{
    return triangles.empty() ? 0 : largestOf(&triangles.front().x, 3 * triangles.size());
}

} // namespace ramure
