/// \file
/// The passes of validateMesh, one per file. Internal to core/mesh/validate*.cpp.
#pragma once

#include "core/base/large_buffer.h"
#include "core/mesh/validate.h"
#include <array>
#include <span>

namespace ramure::validation {

/// Counts all defects and lists the first of each kind, in the order in which they are added.
class DefectLog
{
public:
    static constexpr std::size_t listedPerKind = 10'000;

    void add(DefectKind kind, Index a, Index b = noIndex)
    {
        Kind& entry = m_kinds[static_cast<std::size_t>(kind)];
        ++entry.count;
        if (entry.listed.size() < listedPerKind)
            entry.listed.push_back({kind, a, b});
    }
    [[nodiscard]] Index count(DefectKind kind) const { return m_kinds[static_cast<std::size_t>(kind)].count; }
    /// All that is listed, kind after kind.
    [[nodiscard]] std::vector<Defect> all() const;

private:
    struct Kind
    {
        Index count = 0;
        std::vector<Defect> listed;
    };
    std::array<Kind, defectKindCount> m_kinds;
};

/// A face with a repeated vertex has no edges to speak of: it is degenerate, and left out of everything else.
inline bool hasRepeatedVertex(const glm::uvec3& t)
{
    return t.x == t.y || t.y == t.z || t.z == t.x;
}

/// Errors: Invalid (a face refers to a missing vertex), Limit (more faces than can be counted).
Expected<void> checkIndices(const TriangleMesh& mesh);

/// For every vertex the faces around it, as pairs: the vertex after it and the vertex before it in the face.
/// Those of v are at [first[v], first[v + 1]) in the order of the faces.
struct Corners
{
    LargeBuffer<Index> first; ///< one more than there are vertices
    LargeBuffer<Index> next;  ///< padded, so that whole registers may be read at any corner
    LargeBuffer<Index> previous;
    Index faces = 0; ///< those without a repeated vertex

    [[nodiscard]] Index degree(Index v) const { return first[v + 1] - first[v]; }
};
Expected<Corners> collectCorners(const TriangleMesh& mesh, const Progress& progress);

/// Looks at the faces around every vertex: logs edges, non-manifold vertices and duplicate faces.
/// Returns the number of distinct edges.
Expected<std::int64_t> checkFans(const TriangleMesh& mesh, const Corners& corners, DefectLog& log,
                                 const Progress& progress);

/// Logs every vertex at the position of an earlier one (bits compared, -0 = 0).
void findDuplicateVertices(std::span<const glm::vec3> positions, DefectLog& log);

/// Connected pieces of the mesh: of[v] < count for vertices with corners, noIndex for all others.
struct Components
{
    LargeBuffer<Index> of;
    Index count = 0;
};
Components findComponents(const TriangleMesh& mesh, const Corners& corners);

} // namespace ramure::validation
