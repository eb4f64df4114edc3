#include "core/surface/proof/validate_parts.h"
#include <algorithm>
#include <tuple>

namespace ramure::validation {

namespace {

/// Vertices between two looks at the stop token.
constexpr Index verticesAtATime = 1u << 16;

/// One of the two edges of a face at the vertex looked at.
struct EdgeUse
{
    Index other; ///< the edge's other end
    Index corner;
    Index leaves; ///< 1 where the face runs along the edge away from the vertex, else 0
    friend bool operator<(const EdgeUse& a, const EdgeUse& b)
    {
        return a.other != b.other ? a.other < b.other : a.corner < b.corner;
    }
};

/// Takes the faces around one vertex apart, whatever their number and state. Buffers are kept between
/// vertices.
class FanInspector
{
public:
    explicit FanInspector(DefectLog& log)
        : m_log(log)
    {
    }

    /// Returns the number of distinct edges at the vertex; sets hasDuplicates() where two faces whose
    /// smallest vertex is v are the same.
    std::int64_t inspect(Index v, const Corner* corners, Index degree)
    {
        m_uses.clear();
        m_group.resize(degree);
        for (Index c = 0; c < degree; ++c) {
            m_group[c] = c;
            m_uses.push_back({corners[c].next, c, 1});
            m_uses.push_back({corners[c].previous, c, 0});
        }
        std::sort(m_uses.begin(), m_uses.end());
        Index fans = degree;
        std::int64_t edges = 0;
        for (std::size_t i = 0; i < m_uses.size(); ++edges) {
            std::size_t end = i;
            unsigned leaving = 0;
            for (; end < m_uses.size() && m_uses[end].other == m_uses[i].other; ++end) {
                leaving += m_uses[end].leaves;
                fans -= join(m_uses[i].corner, m_uses[end].corner);
            }
            if (v < m_uses[i].other)
                logEdge(v, m_uses[i].other, end - i, leaving);
            i = end;
        }
        if (fans > 1)
            m_log.add(DefectKind::NonManifoldVertex, v);
        m_hasDuplicates = findTwins(v, corners, degree);
        return edges;
    }
    [[nodiscard]] bool hasDuplicates() const { return m_hasDuplicates; }

private:
    Index rootOf(Index c)
    {
        while (m_group[c] != c)
            c = m_group[c] = m_group[m_group[c]];
        return c;
    }
    Index join(Index a, Index b)
    {
        a = rootOf(a);
        b = rootOf(b);
        m_group[std::max(a, b)] = std::min(a, b);
        return a != b;
    }
    void logEdge(Index v, Index other, std::size_t uses, unsigned leaving)
    {
        if (uses == 1)
            m_log.add(DefectKind::BoundaryEdge, v, other);
        else if (uses > 2)
            m_log.add(DefectKind::NonManifoldEdge, v, other);
        else if (leaving != 1)
            m_log.add(DefectKind::InconsistentEdge, v, other);
    }
    bool findTwins(Index v, const Corner* corners, Index degree)
    {
        m_faces.clear();
        for (Index c = 0; c < degree; ++c)
            if (v < corners[c].next && v < corners[c].previous)
                m_faces.push_back(std::minmax(corners[c].next, corners[c].previous));
        std::sort(m_faces.begin(), m_faces.end());
        return std::adjacent_find(m_faces.begin(), m_faces.end()) != m_faces.end();
    }

    DefectLog& m_log;
    std::vector<EdgeUse> m_uses;
    std::vector<Index> m_group; ///< of a corner: a corner it hangs together with
    std::vector<std::pair<Index, Index>> m_faces;
    bool m_hasDuplicates = false;
};

/// Names the faces that are the same as an earlier one, among those whose smallest vertex is marked.
void logDuplicateFaces(const TriangleMesh& mesh, const std::vector<bool>& isSmallestOfTwins, DefectLog& log)
{
    struct SortedFace
    {
        std::array<Index, 3> v;
        Index face;
        bool operator<(const SortedFace& o) const { return std::tie(v, face) < std::tie(o.v, o.face); }
    };
    std::vector<SortedFace> faces;
    for (Index face = 0; face < mesh.faceCount(); ++face) {
        const glm::uvec3& t = mesh.triangles[face];
        SortedFace entry{{t.x, t.y, t.z}, face};
        std::sort(entry.v.begin(), entry.v.end());
        if (isSmallestOfTwins[entry.v[0]] && !hasRepeatedVertex(t))
            faces.push_back(entry);
    }
    std::sort(faces.begin(), faces.end());
    std::vector<std::pair<Index, Index>> twins; // later face, first face
    for (std::size_t i = 0, first = 0; i < faces.size(); ++i) {
        if (faces[i].v != faces[first].v)
            first = i;
        if (i != first)
            twins.emplace_back(faces[i].face, faces[first].face);
    }
    std::sort(twins.begin(), twins.end());
    for (const auto& [later, first] : twins)
        log.add(DefectKind::DuplicateFace, later, first);
}

/// What the way over all vertices takes along.
struct FanWalk
{
    const TriangleMesh& mesh;
    const Corners& corners;
    DefectLog& log;
    FanInspector inspector{log};
    FanFinder finder{};
    ComponentFinder components{mesh.vertexCount()};
    std::vector<bool> isSmallestOfTwins{};
    std::vector<Index> neighbours{};
    FanResult result{}; ///< with ends of edges instead of edges

    void inspect(Index v, Index begin, Index degree)
    {
        takeNeighbours(begin, degree, true);
        const Index lowest = *std::min_element(neighbours.begin(), neighbours.end());
        if (!components.takeIntoRun(v, lowest))
            components.visit(v, neighbours.data(), 2 * degree);
        result.edges += inspector.inspect(v, &corners.at[begin], degree);
        if (inspector.hasDuplicates()) {
            isSmallestOfTwins.resize(mesh.positions.size());
            isSmallestOfTwins[v] = true;
        }
    }
    /// In a closed fan each neighbour comes next once.
    void takeNeighbours(Index begin, Index degree, bool previousToo)
    {
        neighbours.clear();
        for (Index c = begin; c < begin + degree; ++c)
            neighbours.push_back(corners.at[c].next);
        for (Index c = begin; c < begin + degree && previousToo; ++c)
            neighbours.push_back(corners.at[c].previous);
    }
};

/// Vertices whose fans are found together.
constexpr Index together = 512;

/// The vertices from \p from on, as far as \p to.
void walk(FanWalk& w, Index from, Index to)
{
    std::array<Index, together> lowest;
    const Index* const ends = w.corners.end.data();
    std::int64_t edges = 0, vertices = 0;
    for (Index first = from; first < to; first += together) {
        const Index last = first + std::min(together, to - first);
        w.finder.find(w.corners, first, last, lowest.data());
        Index begin = w.corners.begin(first);
        for (Index v = first; v < last; ++v) {
            const Index end = ends[v];
            const Index degree = end - begin;
            const Index low = lowest[v - first];
            edges += low != noIndex ? degree : 0;
            vertices += degree != 0 ? 1 : 0;
            if (low != noIndex) {
                if (!w.components.takeIntoRun(v, low)) {
                    w.takeNeighbours(begin, degree, false);
                    w.components.visit(v, w.neighbours.data(), degree);
                }
            } else if (degree != 0) {
                w.inspect(v, begin, degree);
            } else {
                w.components.leaveOut(v);
            }
            begin = end;
        }
    }
    w.result.edges += edges;
    w.result.vertices += vertices;
}

} // namespace

Expected<FanResult> checkFans(const TriangleMesh& mesh, const Corners& corners, DefectLog& log,
                              const Progress& progress)
{
    FanWalk fans{mesh, corners, log};
    for (Index from = 0; from < mesh.vertexCount(); from += verticesAtATime) {
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        walk(fans, from, from + std::min(verticesAtATime, mesh.vertexCount() - from));
    }
    if (!fans.isSmallestOfTwins.empty())
        logDuplicateFaces(mesh, fans.isSmallestOfTwins, log);
    progress.report(1.0);
    fans.result.edges /= 2;
    fans.result.components = fans.components.finish();
    return std::move(fans.result);
}

} // namespace ramure::validation
