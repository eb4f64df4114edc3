#include "tests/support/self_intersections.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>
#include <algorithm>
#include <sstream>

namespace ramure::test {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Box = CGAL::Box_intersection_d::Box_with_handle_d<double, 3, const glm::uvec3*>;

/// The up to three branches a triangle belongs to.
struct Owners
{
    std::array<Index, 3> branch{noIndex, noIndex, noIndex};
    std::size_t count = 0;
};

class Counter
{
public:
    Counter(const TriangleMesh& mesh, const std::vector<Index>& parent)
        : m_mesh(mesh)
        , m_parent(parent)
        , m_depth(parent.size(), 0)
    {
        for (std::size_t i = 0; i < parent.size(); ++i)
            for (Index up = parent[i]; up != noIndex; up = parent[up])
                ++m_depth[i];
        m_points.reserve(mesh.positions.size());
        for (const glm::vec3& p : mesh.positions)
            m_points.emplace_back(double(p.x), double(p.y), double(p.z));
    }

    SelfIntersections run()
    {
        std::vector<Box> boxes;
        boxes.reserve(m_mesh.triangles.size());
        for (const glm::uvec3& t : m_mesh.triangles)
            if (!CGAL::collinear(m_points[t.x], m_points[t.y], m_points[t.z]))
                boxes.emplace_back(m_points[t.x].bbox() + m_points[t.y].bbox() + m_points[t.z].bbox(), &t);
        CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [this](const Box& a, const Box& b) {
            const Index i = face(a), j = face(b);
            test(std::min(i, j), std::max(i, j));
        });
        std::sort(m_result.pairs.begin(), m_result.pairs.end(), [](const auto& a, const auto& b) {
            return a.first != b.first ? a.first < b.first : a.second < b.second;
        });
        return std::move(m_result);
    }

private:
    [[nodiscard]] Index face(const Box& box) const
    {
        return static_cast<Index>(box.handle() - m_mesh.triangles.data());
    }

    [[nodiscard]] Kernel::Triangle_3 triangle(const glm::uvec3& t) const
    {
        return {m_points[t.x], m_points[t.y], m_points[t.z]};
    }

    void test(Index i, Index j)
    {
        if (!meet(m_mesh.triangles[i], m_mesh.triangles[j]))
            return;
        const PairKind kind = kindOf(owners(m_mesh.triangles[i]), owners(m_mesh.triangles[j]));
        Index* const counts[] = {&m_result.same, &m_result.siblings, &m_result.parentChild, &m_result.far};
        ++*counts[static_cast<std::size_t>(kind)];
        m_result.pairs.push_back({kind, i, j});
    }

    /// The corners of both turned so that those in common come first, in the same order.
    [[nodiscard]] bool meet(const glm::uvec3& s, const glm::uvec3& t) const
    {
        std::array<Index, 3> common{};
        std::size_t count = 0;
        for (int k = 0; k < 3; ++k)
            if (s[k] == t.x || s[k] == t.y || s[k] == t.z)
                common[count++] = s[k];
        switch (count) {
        case 0:
            return CGAL::do_intersect(triangle(s), triangle(t));
        case 1:
            return meetBeyond(s, t, common[0]);
        case 2:
            return overlapAtEdge(s, t, common[0], common[1]);
        default:
            return true;
        }
    }

    /// Two triangles with one vertex in common have more in common exactly when the side of one that is
    /// opposite to it reaches the other.
    [[nodiscard]] bool meetBeyond(const glm::uvec3& s, const glm::uvec3& t, Index vertex) const
    {
        return CGAL::do_intersect(oppositeSide(s, vertex), triangle(t)) ||
               CGAL::do_intersect(oppositeSide(t, vertex), triangle(s));
    }

    [[nodiscard]] Kernel::Segment_3 oppositeSide(const glm::uvec3& t, Index vertex) const
    {
        const int k = t.x == vertex ? 0 : t.y == vertex ? 1 : 2;
        return {m_points[t[(k + 1) % 3]], m_points[t[(k + 2) % 3]]};
    }

    [[nodiscard]] bool overlapAtEdge(const glm::uvec3& s, const glm::uvec3& t, Index a, Index b) const
    {
        const Point& p = m_points[s.x ^ s.y ^ s.z ^ a ^ b];
        const Point& q = m_points[t.x ^ t.y ^ t.z ^ a ^ b];
        return CGAL::coplanar(m_points[a], m_points[b], p, q) &&
               CGAL::coplanar_orientation(m_points[a], m_points[b], p, q) == CGAL::POSITIVE;
    }

    [[nodiscard]] Owners owners(const glm::uvec3& t) const
    {
        Owners result;
        if (m_parent.empty())
            return result;
        Index deepest = 0;
        for (int k = 0; k < 3; ++k)
            deepest = std::max(deepest, m_depth[m_mesh.branch[t[k]]]);
        for (int k = 0; k < 3; ++k) {
            const Index b = m_mesh.branch[t[k]];
            const auto end = result.branch.begin() + static_cast<std::ptrdiff_t>(result.count);
            if (m_depth[b] == deepest && std::find(result.branch.begin(), end, b) == end)
                result.branch[result.count++] = b;
        }
        return result;
    }

    [[nodiscard]] PairKind kindOf(const Owners& a, const Owners& b) const
    {
        if (m_parent.empty())
            return PairKind::Same;
        PairKind closest = PairKind::Far;
        for (std::size_t i = 0; i < a.count; ++i)
            for (std::size_t j = 0; j < b.count; ++j)
                closest = std::min(closest, kindOf(a.branch[i], b.branch[j]));
        return closest;
    }

    [[nodiscard]] PairKind kindOf(Index a, Index b) const
    {
        if (a == b)
            return PairKind::Same;
        if (m_parent[a] == m_parent[b] && m_parent[a] != noIndex)
            return PairKind::Siblings;
        return m_parent[a] == b || m_parent[b] == a ? PairKind::ParentChild : PairKind::Far;
    }

    const TriangleMesh& m_mesh;
    const std::vector<Index>& m_parent;
    std::vector<Index> m_depth;
    std::vector<Point> m_points;
    SelfIntersections m_result;
};

} // namespace

std::string SelfIntersections::summary(const TriangleMesh& mesh) const
{
    std::ostringstream text;
    text << "same " << same << ", siblings " << siblings << ", parent-child " << parentChild << ", far "
         << far << '\n';
    static constexpr const char* names[] = {"same", "siblings", "parent-child", "far"};
    std::array<int, 4> shown{};
    for (const IntersectingPair& pair : pairs) {
        const auto kind = static_cast<std::size_t>(pair.kind);
        if (shown[kind]++ >= 5)
            continue;
        text << "  " << names[kind] << ':';
        for (const Index f : {pair.first, pair.second}) {
            const glm::uvec3& t = mesh.triangles[f];
            const glm::vec3 middle = (mesh.positions[t.x] + mesh.positions[t.y] + mesh.positions[t.z]) / 3.0f;
            text << " face " << f << " (" << middle.x << ", " << middle.y << ", " << middle.z << ')';
            if (!mesh.branch.empty())
                text << " of branches " << mesh.branch[t.x] << ' ' << mesh.branch[t.y] << ' '
                     << mesh.branch[t.z];
        }
        text << '\n';
    }
    return text.str();
}

SelfIntersections findSelfIntersections(const TriangleMesh& mesh, const std::vector<Index>& parent)
{
    return Counter(mesh, mesh.branch.empty() ? std::vector<Index>() : parent).run();
}

std::vector<Index> repairedParents(const Skeleton& skeleton, const std::vector<RepairNote>& repairs)
{
    std::vector<Index> standsFor(skeleton.size()), parent = skeleton.parent;
    for (Index i = 0; i < skeleton.size(); ++i)
        standsFor[i] = i;
    for (const RepairNote& note : repairs) {
        if (note.kind == SkeletonRepair::SiblingsMerged || note.kind == SkeletonRepair::ZeroLengthContracted)
            standsFor[note.branch] = note.other;
        else if (note.kind == SkeletonRepair::SiblingChained)
            parent[note.branch] = note.other;
    }
    for (Index& p : parent)
        while (p != noIndex && standsFor[p] != p)
            p = standsFor[p];
    return parent;
}

} // namespace ramure::test
