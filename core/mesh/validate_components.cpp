#include "core/mesh/validate_parts.h"
#include <algorithm>
#include <numeric>

namespace ramure::validation {

// Union-find in which the smaller index is the parent: parents come first, so that one pass from the front
// gives every vertex its root, and the components are numbered by their first vertex whatever the order of
// the faces.
Components findComponents(const TriangleMesh& mesh, const Corners& corners)
{
    const Index vertices = mesh.vertexCount();
    Components out;
    out.of = LargeBuffer<Index>(vertices);
    Index* const parent = out.of.data();
    std::iota(parent, parent + vertices, Index(0));
    const auto rootOf = [parent](Index v) {
        while (parent[v] != v)
            v = parent[v] = parent[parent[v]];
        return v;
    };
    const auto join = [&](Index a, Index b) {
        a = rootOf(a);
        b = rootOf(b);
        parent[std::max(a, b)] = std::min(a, b);
    };
    for (const glm::uvec3& t : mesh.triangles) {
        if (parent[t.x] == parent[t.y] && parent[t.y] == parent[t.z])
            continue; // known to hang together
        if (hasRepeatedVertex(t))
            continue;
        join(t.x, t.y);
        join(t.y, t.z);
    }
    // Roots first get their number; the parent of every other vertex has been renamed before it.
    for (Index v = 0; v < vertices; ++v) {
        if (corners.degree(v) == 0)
            parent[v] = noIndex;
        else
            parent[v] = parent[v] == v ? out.count++ : parent[parent[v]];
    }
    return out;
}

} // namespace ramure::validation
