/// \file
/// The passes of validateMesh, one per file. Internal to core/surface/proof/validate*.cpp.
#pragma once

#include "core/base/large_buffer.h"
#include "core/surface/proof/validate.h"
#include <algorithm>
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
    /// Takes over the kinds that it has none of itself.
    void take(const DefectLog& other);
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

/// Errors: Limit (more faces than can be counted).
Expected<void> checkSize(const TriangleMesh& mesh);
/// Errors: as checkSize(), and Invalid (a face refers to a missing vertex).
Expected<void> checkIndices(const TriangleMesh& mesh);

/// Connected pieces of the mesh. Numbered by their first vertex.
struct Components
{
    Index count = 0;
    /// Where there is more than one: < count for vertices with corners, noIndex for all others.
    LargeBuffer<Index> of;
};

/// Finds the components while the vertices pass by in their order, each with its neighbours.
///
/// A run is a range of vertices that are known to be in one piece: a vertex whose neighbours before it are
/// all in the run needs no look at them. Runs that touch and are found to be in one piece become one, so that
/// soon there is one run for all of a mesh that is one piece.
class ComponentFinder
{
public:
    explicit ComponentFinder(Index vertices);

    /// For ascending \p v. True: it belongs to the current run, and all its neighbours before it do.
    /// \p lowest: its lowest neighbour.
    bool takeIntoRun(Index v, Index lowest)
    {
        m_piece[v] = m_runs.back().piece;
        return lowest - m_runs.back().begin < v - m_runs.back().begin;
    }
    /// Where not: all neighbours of \p v. Those that come later are passed over.
    void visit(Index v, const Index* neighbours, Index count);
    /// Vertices without corners; call for all that takeIntoRun() was not called for.
    void leaveOut(Index v) { m_piece[v] = noIndex; }
    Components finish();

private:
    struct Run
    {
        Index begin, piece;
    };
    Index rootOf(Index piece);
    bool join(Index a, Index b);

    LargeBuffer<Index> m_piece;
    std::vector<Index> m_parent;                 ///< of a piece
    std::vector<Run> m_runs{{noIndex, noIndex}}; ///< they follow each other; the first stands for none
};

/// A face around a vertex: the vertex after it and the vertex before it in the face.
struct Corner
{
    Index next, previous;
};

/// For every vertex the faces around it, in a fixed order. Those of vertex v stand from end[v - 1] (0 for the
/// first) to end[v].
struct Corners
{
    LargeBuffer<Index> end;
    LargeBuffer<Corner> at; ///< nearDegree more than are used, so that as many can be read anywhere
    Index faces = 0;        ///< those without a repeated vertex

    [[nodiscard]] Index begin(Index v) const { return v == 0 ? 0 : end[v - 1]; }
    [[nodiscard]] Index degree(Index v) const { return end[v] - begin(v); }
};
/// Most faces around a vertex that are looked at together.
inline constexpr Index nearDegree = 16;
/// Errors: Cancelled, Invalid (a face refers to a missing vertex).
Expected<Corners> collectCorners(const TriangleMesh& mesh, const Progress& progress);

/// Tells vertices whose faces are one closed fan: the face after each is the only one that may come after it,
/// and going from face to face passes all of them once. All edges at the vertex are then manifold and
/// consistent, and no two of the faces are the same.
class FanFinder
{
public:
    /// \p lowest: for each vertex from \p from to \p to its lowest neighbour, where its faces are certainly
    /// one closed fan; noIndex for all others, which have to be looked at one by one.
    void find(const Corners& corners, Index from, Index to, Index* lowest);

private:
    /// For every face around a vertex the set of those that may follow it, as bits.
    using Sets = std::uint64_t;
    static constexpr std::size_t knownSets = 1024;
    static std::size_t slotOf(Sets sets) { return sets * 0x9E3779B97F4A7C15u >> 54; }

    /// Closed fans come in few arrangements: those found closed are remembered.
    std::array<Sets, knownSets> m_known = unknown();
    static constexpr std::array<Sets, knownSets> unknown()
    {
        std::array<Sets, knownSets> out{};
        out.fill(~Sets(0)); // every face after every face, also itself: there is no such vertex
        return out;
    }
};

/// What the look at the faces around every vertex finds out besides the defects.
struct FanResult
{
    std::int64_t edges = 0;    ///< distinct ones
    std::int64_t vertices = 0; ///< those with corners
    Components components;
};
/// Logs edges, non-manifold vertices and duplicate faces.
Expected<FanResult> checkFans(const TriangleMesh& mesh, const Corners& corners, DefectLog& log,
                              const Progress& progress);

/// Logs every vertex at the position of an earlier one (bits compared, -0 = 0).
void findDuplicateVertices(std::span<const glm::vec3> positions, DefectLog& log);

/// Areas and volumes.
struct Volumes
{
    double sum = 0.0;
    bool allPositive = true;
};
/// As if the mesh were one component. Logs degenerate faces. Cancelled, or where a face refers to a missing
/// vertex: what is returned means nothing.
Volumes measureFaces(const TriangleMesh& mesh, DefectLog& log, const Progress& progress);
/// The volumes of several components.
Volumes measureComponents(const TriangleMesh& mesh, const Components& components);

} // namespace ramure::validation
