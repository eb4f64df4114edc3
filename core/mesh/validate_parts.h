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

/// Most faces around a vertex that are kept in one place; few vertices have more.
inline constexpr Index nearDegree = 8;

/// The faces around a vertex, as pairs: the vertex after it and the vertex before it in the face. One cache
/// line, so that filling and reading are one access each. Only what the vertex's degree says is written.
struct alignas(64) NearCorners
{
    Index next[nearDegree];
    Index previous[nearDegree];
};

/// One more face around a vertex that has more than nearDegree of them.
struct FarCorner
{
    Index vertex, next, previous;
};

/// For every vertex the faces around it, in their order.
struct Corners
{
    LargeBuffer<std::uint8_t> degree; ///< nearDegree + 1 stands for all that is more
    LargeBuffer<NearCorners> near;
    std::vector<FarCorner> far; ///< by vertex
    Index faces = 0;            ///< those without a repeated vertex
};
/// Errors: Invalid for an index out of range, Cancelled.
Expected<Corners> collectCorners(const TriangleMesh& mesh, const Progress& progress);

/// Connected pieces of the mesh: of[v] < count for vertices with corners, noIndex for all others. Numbered by
/// their first vertex.
struct Components
{
    LargeBuffer<Index> of;
    Index count = 0;
};

/// What the look at the faces around every vertex finds out besides the defects.
struct FanResult
{
    std::int64_t edges = 0; ///< distinct ones
    Components components;
};
/// Logs edges, non-manifold vertices and duplicate faces.
Expected<FanResult> checkFans(const TriangleMesh& mesh, const Corners& corners, DefectLog& log,
                              const Progress& progress);

/// Logs every vertex at the position of an earlier one (bits compared, -0 = 0).
void findDuplicateVertices(std::span<const glm::vec3> positions, DefectLog& log);

/// Finds the components while the vertices pass by in their order, each with its neighbours: a vertex takes
/// the label of the neighbours before it, and where these differ the labels are one component.
class ComponentFinder
{
public:
    explicit ComponentFinder(Index vertices);

    /// \p neighbours of \p v, at least one; neighbours that come later are passed over. Call for ascending v.
    void visit(Index v, const Index* neighbours, Index count)
    {
        Index lowest = noIndex;
        Index highest = 0;
        for (Index i = 0; i < count; ++i) {
            const Index label =
                m_label[neighbours[i]]; // 0 = none yet, which is the highest when 1 is taken off
            lowest = label - 1u < lowest ? label - 1u : lowest;
            highest = label > highest ? label : highest;
        }
        if (highest == 0)
            m_label[v] = newLabel();
        else {
            m_label[v] = lowest + 1u;
            if (lowest + 1u != highest)
                joinAll(neighbours, count, lowest);
        }
    }
    /// Every label becomes the number of its component.
    Components finish();

private:
    Index newLabel();
    Index rootOf(Index label);
    void joinAll(const Index* neighbours, Index count, Index label);

    LargeBuffer<Index> m_label; ///< plus 1
    std::vector<Index> m_parent;
};

} // namespace ramure::validation
