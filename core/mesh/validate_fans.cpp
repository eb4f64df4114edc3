#include "core/mesh/validate_parts.h"
#include <algorithm>
#include <bit>
#include <cstring>
#include <tuple>

namespace ramure::validation {

namespace {

/// Vertices or faces between two looks at the stop token.
constexpr Index chunk = 1u << 16;

using Lanes = Index __attribute__((vector_size(16)));

Lanes load(const Index* from)
{
    Lanes lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
}

/// True only where the \p degree (3..8) faces around a vertex are one closed fan: the face after each is the
/// only one whose next vertex is its previous one, and going from face to face passes all of them once. All
/// edges at the vertex are then manifold and consistent, and no two of the faces are the same.
bool isClosedFan(const Index* next, const Index* previous, Index degree)
{
    const Lanes low = load(previous);
    const Lanes high = load(previous + 4);
    Lanes lowMatches{};
    Lanes highMatches{};
    for (Index j = 0; j < degree; ++j) {
        const Lanes wanted = Lanes{} + next[j];
        const Lanes bit = Lanes{} + (1u << j);
        lowMatches |= Lanes(low == wanted) & bit;
        highMatches |= Lanes(high == wanted) & bit;
    }
    Index followers[nearDegree]; // of face i: the set of faces that may come after it
    std::memcpy(followers, &lowMatches, sizeof lowMatches);
    std::memcpy(followers + 4, &highMatches, sizeof highMatches);
    Index seen = 0;
    Index several = 0;
    unsigned face = 0;
    for (Index step = 0; step < degree; ++step) {
        const Index set = followers[face];
        several |= set & (set - 1u);
        face = static_cast<unsigned>(std::countr_zero(set | 0x80u)) & 7u;
        seen |= (1u << face) & set;
    }
    return several == 0 && seen == (1u << degree) - 1u;
}

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

} // namespace

Expected<Corners> collectCorners(const TriangleMesh& mesh, const Progress& progress)
{
    const Index vertices = mesh.vertexCount();
    Corners out;
    out.degree = LargeBuffer<std::uint8_t>(vertices);
    out.near = LargeBuffer<NearCorners>(vertices);
    std::fill_n(out.degree.data(), vertices, std::uint8_t(0));
    const auto put = [&out, degree = out.degree.data(), near = out.near.data()](Index v, Index next,
                                                                                Index previous) {
        const Index at = degree[v];
        if (at < nearDegree) {
            near[v].next[at] = next;
            near[v].previous[at] = previous;
            degree[v] = static_cast<std::uint8_t>(at + 1);
        } else {
            degree[v] = nearDegree + 1;
            out.far.push_back({v, next, previous});
        }
    };
    const Index faces = mesh.faceCount();
    for (Index begin = 0; begin < faces; begin += chunk) {
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        for (Index face = begin; face < std::min(faces, begin + chunk); ++face) {
            const glm::uvec3& t = mesh.triangles[face];
            if (hasRepeatedVertex(t))
                continue;
            ++out.faces;
            put(t.x, t.y, t.z);
            put(t.y, t.z, t.x);
            put(t.z, t.x, t.y);
        }
        progress.report(double(begin) / double(faces));
    }
    std::stable_sort(out.far.begin(), out.far.end(),
                     [](const FarCorner& a, const FarCorner& b) { return a.vertex < b.vertex; });
    return out;
}

namespace {

/// All faces around a vertex that has more than lie near.
struct GatheredFan
{
    std::vector<Index> next, previous;

    /// \p far is moved behind the vertex's corners.
    void gather(Index v, const NearCorners& near, Index nearCount, const FarCorner*& far,
                const FarCorner* end)
    {
        next.assign(near.next, near.next + nearCount);
        previous.assign(near.previous, near.previous + nearCount);
        for (; far != end && far->vertex == v; ++far) {
            next.push_back(far->next);
            previous.push_back(far->previous);
        }
    }
};

} // namespace

Expected<FanResult> checkFans(const TriangleMesh& mesh, const Corners& corners, DefectLog& log,
                              const Progress& progress)
{
    FanInspector inspector(log);
    ComponentFinder components(mesh.vertexCount());
    GatheredFan fan;
    std::vector<bool> isSmallestOfTwins;
    std::int64_t edgeEnds = 0;
    const FarCorner* far = corners.far.data();
    const FarCorner* const farEnd = far + corners.far.size();
    for (Index v = 0; v < mesh.vertexCount(); ++v) {
        if (v % chunk == 0 && progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        const Index degree = corners.degree[v];
        const NearCorners& near = corners.near[v];
        __builtin_prefetch(&near +
                           24); // the only large array of this pass; the processor may look past its end
        if (degree >= 3 && degree <= nearDegree && isClosedFan(near.next, near.previous, degree)) {
            components.visit(v, near.next, degree);
            edgeEnds += degree;
            continue;
        }
        if (degree == 0)
            continue;
        fan.gather(v, near, std::min(degree, nearDegree), far, farEnd);
        const auto count = static_cast<Index>(fan.next.size());
        edgeEnds += inspector.inspect(v, fan.next.data(), fan.previous.data(), count);
        fan.next.insert(fan.next.end(), fan.previous.begin(), fan.previous.end());
        components.visit(v, fan.next.data(), 2 * count);
        if (inspector.hasDuplicates()) {
            isSmallestOfTwins.resize(mesh.positions.size());
            isSmallestOfTwins[v] = true;
        }
    }
    if (!isSmallestOfTwins.empty())
        logDuplicateFaces(mesh, isSmallestOfTwins, log);
    progress.report(1.0);
    return FanResult{edgeEnds / 2, components.finish()};
}

} // namespace ramure::validation
