#include "core/base/wide_clone.h"
#include "core/mesh/validate_parts.h"
#include <algorithm>
#include <bit>
#include <cstring>
#include <tuple>

namespace ramure::validation {

namespace {

/// Vertices between two looks at the stop token.
constexpr Index chunk = 1u << 16;

using Lanes [[gnu::vector_size(32)]] = Index;

/// Eight sets of up to eight elements, one a byte: the byte of set i is byteOf(i).
using Sets = std::uint64_t;
constexpr unsigned byteOf(unsigned i)
{
    return i / 2 + 4 * (i % 2);
}

/// The first \p degree sets with the first \p degree elements.
constexpr std::array<Sets, nearDegree + 1> fullSets = [] {
    std::array<Sets, nearDegree + 1> out{};
    for (unsigned degree = 0; degree <= nearDegree; ++degree)
        for (unsigned i = 0; i < degree; ++i)
            out[degree] |= ((Sets(1) << degree) - 1u) << (8 * byteOf(i));
    return out;
}();

/// Full where there is no face: the same sets with another degree are another arrangement.
constexpr std::array<Sets, nearDegree + 1> setsBeyond = [] {
    std::array<Sets, nearDegree + 1> out{};
    for (unsigned degree = 0; degree <= nearDegree; ++degree)
        for (unsigned i = degree; i < nearDegree; ++i)
            out[degree] |= Sets(0xFF) << (8 * byteOf(i));
    return out;
}();

/// For each of the faces around a vertex: the set of the faces whose next vertex is its previous one, which
/// may come after it. Sets and elements from the degree on mean nothing.
template <unsigned Columns>
[[gnu::always_inline]] inline Sets followers(const Index* next, const Index* previous)
{
    Lanes wanted;
    std::memcpy(&wanted, previous, sizeof wanted);
    Lanes found{};
    for (unsigned j = 0; j < Columns; ++j)
        found |= Lanes(wanted == Lanes{} + next[j]) & (Lanes{} + (1u << j));
    Sets pairs[4];
    std::memcpy(pairs, &found, sizeof pairs);
    return pairs[0] | pairs[1] << 8 | pairs[2] << 16 | pairs[3] << 24;
}

/// All ones from lane \p degree on.
constexpr std::array<std::array<Index, nearDegree>, nearDegree + 1> beyondDegree = [] {
    std::array<std::array<Index, nearDegree>, nearDegree + 1> out{};
    for (unsigned degree = 0; degree <= nearDegree; ++degree)
        for (unsigned i = degree; i < nearDegree; ++i)
            out[degree][i] = noIndex;
    return out;
}();

/// The lowest of \p degree (up to 8) indices.
[[gnu::always_inline]] inline Index lowestOf(const Index* indices, Index degree)
{
    Lanes lanes, beyond;
    std::memcpy(&lanes, indices, sizeof lanes);
    std::memcpy(&beyond, beyondDegree[degree].data(), sizeof beyond);
    lanes |= beyond;
    using Half [[gnu::vector_size(16)]] = Index;
    Half low, high;
    std::memcpy(&low, &lanes, sizeof low);
    std::memcpy(&high, reinterpret_cast<const char*>(&lanes) + sizeof low, sizeof high);
    low = low < high ? low : high;
    return std::min(std::min(low[0], low[1]), std::min(low[2], low[3]));
}

/// True only where the \p degree (3..8) faces around a vertex are one closed fan: the face after each is the
/// only one that may come after it, and going from face to face passes all of them once. All edges at the
/// vertex are then manifold and consistent, and no two of the faces are the same.
bool areClosedFan(Sets sets, Index degree)
{
    Index seen = 0;
    Index several = 0;
    unsigned face = 0;
    for (Index step = 0; step < degree; ++step) {
        const auto set = static_cast<Index>(sets >> (8 * byteOf(face)) & 0xFFu);
        several |= set & (set - 1u);
        face = static_cast<unsigned>(std::countr_zero(set | 0x80u)) & 7u;
        seen |= (1u << face) & set;
    }
    return several == 0 && seen == (1u << degree) - 1u;
}

/// Closed fans come in few arrangements: those found closed are remembered.
class KnownFans
{
public:
    /// \p degree 3..8; there is something to read behind the corners.
    [[gnu::always_inline]] bool isClosedFan(const Index* next, const Index* previous, Index degree)
    {
        const Sets all = degree <= 6 ? followers<6>(next, previous) : followers<8>(next, previous);
        const Sets sets = (all & fullSets[degree]) | setsBeyond[degree];
        Sets& known = m_known[sets * 0x9E3779B97F4A7C15u >> 56];
        if (known == sets)
            return true;
        if (!areClosedFan(sets, degree))
            return false;
        known = sets;
        return true;
    }

private:
    std::array<Sets, 256> m_known = unknown();

    static constexpr std::array<Sets, 256> unknown()
    {
        std::array<Sets, 256> out{};
        out.fill(~Sets(0)); // all may come after all: no fan
        return out;
    }
};

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
    std::int64_t inspect(Index v, const Index* next, const Index* previous, Index degree)
    {
        m_uses.clear();
        m_group.resize(degree);
        for (Index c = 0; c < degree; ++c) {
            m_group[c] = c;
            m_uses.push_back({next[c], c, 1});
            m_uses.push_back({previous[c], c, 0});
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
        m_hasDuplicates = findTwins(v, next, previous, degree);
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
    bool findTwins(Index v, const Index* next, const Index* previous, Index degree)
    {
        m_faces.clear();
        for (Index c = 0; c < degree; ++c)
            if (v < next[c] && v < previous[c])
                m_faces.push_back(std::minmax(next[c], previous[c]));
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
    KnownFans known{};
    ComponentFinder components{mesh.vertexCount()};
    std::vector<bool> isSmallestOfTwins{};
    std::vector<Index> neighbours{};
    FanResult result{}; ///< with ends of edges instead of edges

    void inspect(Index v, Index begin, Index degree)
    {
        neighbours.assign(&corners.next[begin], &corners.next[begin] + degree);
        neighbours.insert(neighbours.end(), &corners.previous[begin], &corners.previous[begin] + degree);
        const Index lowest = *std::min_element(neighbours.begin(), neighbours.end());
        if (!components.takeIntoRun(v, lowest))
            components.visit(v, neighbours.data(), 2 * degree);
        result.edges += inspector.inspect(v, &corners.next[begin], &corners.previous[begin], degree);
        if (inspector.hasDuplicates()) {
            isSmallestOfTwins.resize(mesh.positions.size());
            isSmallestOfTwins[v] = true;
        }
    }
};

/// The vertices from \p from on, as far as \p to.
RAMURE_WIDE_CLONE void walk(FanWalk& w, Index from, Index to)
{
    const Index* const next = w.corners.next.data();
    const Index* const previous = w.corners.previous.data();
    const Index* const ends = w.corners.end.data();
    Index begin = w.corners.begin(from);
    for (Index v = from; v < to; ++v) {
        const Index end = ends[v];
        const Index degree = end - begin;
        if (degree >= 3 && degree <= nearDegree &&
            w.known.isClosedFan(next + begin, previous + begin, degree)) {
            w.result.edges += degree;
            ++w.result.vertices;
            if (!w.components.takeIntoRun(v, lowestOf(next + begin, degree)))
                w.components.visit(v, next + begin, degree);
        } else if (degree != 0) {
            ++w.result.vertices;
            w.inspect(v, begin, degree);
        } else {
            w.components.leaveOut(v);
        }
        begin = end;
    }
}

} // namespace

Expected<FanResult> checkFans(const TriangleMesh& mesh, const Corners& corners, DefectLog& log,
                              const Progress& progress)
{
    FanWalk fans{mesh, corners, log};
    for (Index from = 0; from < mesh.vertexCount(); from += chunk) {
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        walk(fans, from, from + std::min(chunk, mesh.vertexCount() - from));
    }
    if (!fans.isSmallestOfTwins.empty())
        logDuplicateFaces(mesh, fans.isSmallestOfTwins, log);
    progress.report(1.0);
    fans.result.edges /= 2;
    fans.result.components = fans.components.finish();
    return std::move(fans.result);
}

} // namespace ramure::validation
