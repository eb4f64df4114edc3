#include "tests/support/self_intersections.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/MP_Float.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>
#include <algorithm>
#include <map>
#include <set>
#include <sstream>

namespace ramure::test {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Box = CGAL::Box_intersection_d::Box_with_handle_d<double, 3, const glm::uvec3*>;
using Vector = CGAL::Simple_cartesian<CGAL::MP_Float>::Vector_3; ///< sums and products are exact

Vector exact(const glm::vec3& v)
{
    return {double(v.x), double(v.y), double(v.z)};
}

/// All that a triangle covers near one of its corners, without end: the rays between two of its sides.
struct Wedge
{
    Wedge(const glm::vec3& corner, const glm::vec3& a, const glm::vec3& b)
        : first(exact(a) - exact(corner))
        , last(exact(b) - exact(corner))
        , normal(CGAL::cross_product(first, last))
    {
    }
    /// \p ray lies in the wedge's plane.
    [[nodiscard]] bool holds(const Vector& ray) const
    {
        return CGAL::cross_product(first, ray) * normal >= 0 && CGAL::cross_product(ray, last) * normal >= 0;
    }

    Vector first, last, normal;
};

/// Two triangles with this corner in common have more in common exactly when they share a ray from it.
bool shareRay(const Wedge& s, const Wedge& t)
{
    const Vector along = CGAL::cross_product(s.normal, t.normal);
    if (along == CGAL::NULL_VECTOR) // one plane
        return s.holds(t.first) || s.holds(t.last) || t.holds(s.first) || t.holds(s.last);
    return (s.holds(along) && t.holds(along)) || (s.holds(-along) && t.holds(-along));
}

/// Two triangles on one side have more in common exactly when they leave it in the same direction.
bool leaveTogether(const Wedge& s, const Wedge& t)
{
    return CGAL::cross_product(s.normal, t.normal) == CGAL::NULL_VECTOR && s.normal * t.normal > 0;
}

/// From branches to how they are related.
class Family
{
public:
    explicit Family(const std::vector<Index>& parent)
        : m_lines(parent.size())
    {
        for (Index branch = 0; branch < parent.size(); ++branch) {
            for (Index at = branch; at != noIndex; at = parent[at])
                m_lines[branch].push_back(at);
            std::reverse(m_lines[branch].begin(), m_lines[branch].end());
        }
    }
    [[nodiscard]] bool isKnown() const { return !m_lines.empty(); }

    /// Those of a triangle's corners whose line is the longest.
    [[nodiscard]] std::set<Index> owners(const std::array<Index, 3>& corners) const
    {
        std::map<std::size_t, std::set<Index>> byLength;
        for (const Index branch : corners)
            byLength[m_lines[branch].size()].insert(branch);
        return byLength.rbegin()->second;
    }
    /// By the steps down to each from the last one that both lines have.
    [[nodiscard]] PairKind relation(Index a, Index b) const
    {
        const std::vector<Index>&lineA = m_lines[a], &lineB = m_lines[b];
        const auto [forkA, forkB] = std::mismatch(lineA.begin(), lineA.end(), lineB.begin(), lineB.end());
        if (forkA == lineA.begin())
            return PairKind::Far; // two trees
        const auto steps = std::minmax({lineA.end() - forkA, lineB.end() - forkB});
        if (steps.second > 1)
            return PairKind::Far;
        if (steps.first == 1)
            return PairKind::Siblings;
        return steps.second == 1 ? PairKind::ParentChild : PairKind::Same;
    }

private:
    std::vector<std::vector<Index>> m_lines; ///< of each branch, from its root to itself
};

class Counter
{
public:
    Counter(const TriangleMesh& mesh, const std::vector<Index>& parent)
        : m_mesh(mesh)
        , m_family(parent)
    {
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
            if (meet(*a.handle(), *b.handle()))
                note(face(a), face(b));
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

    void note(Index i, Index j)
    {
        const PairKind kind = kindOf(m_mesh.triangles[i], m_mesh.triangles[j]);
        Index* const counts[] = {&m_result.same, &m_result.siblings, &m_result.parentChild, &m_result.far};
        ++*counts[static_cast<std::size_t>(kind)];
        m_result.pairs.push_back({kind, std::min(i, j), std::max(i, j)});
    }

    [[nodiscard]] PairKind kindOf(const glm::uvec3& s, const glm::uvec3& t) const
    {
        if (!m_family.isKnown())
            return PairKind::Same;
        const auto owners = [this](const glm::uvec3& face) {
            return m_family.owners({m_mesh.branch[face.x], m_mesh.branch[face.y], m_mesh.branch[face.z]});
        };
        PairKind closest = PairKind::Far;
        for (const Index a : owners(s))
            for (const Index b : owners(t))
                closest = std::min(closest, m_family.relation(a, b));
        return closest;
    }

    [[nodiscard]] bool meet(const glm::uvec3& s, const glm::uvec3& t) const
    {
        std::vector<Index> shared, ofS, ofT; // corners of both, of one alone
        for (int k = 0; k < 3; ++k) {
            const bool isShared = s[k] == t.x || s[k] == t.y || s[k] == t.z;
            (isShared ? shared : ofS).push_back(s[k]);
            if (t[k] != s.x && t[k] != s.y && t[k] != s.z)
                ofT.push_back(t[k]);
        }
        switch (shared.size()) {
        case 0:
            return CGAL::do_intersect(triangle(s), triangle(t));
        case 1:
            return mayMeet(s, ofT) && mayMeet(t, ofS) &&
                   shareRay(wedge(shared[0], ofS[0], ofS[1]), wedge(shared[0], ofT[0], ofT[1]));
        case 2:
            return mayMeet(s, ofT) &&
                   leaveTogether(wedge(shared[0], shared[1], ofS[0]), wedge(shared[0], shared[1], ofT[0]));
        default:
            return true;
        }
    }

    /// Spares the exact numbers most of the work: corners that lie all on one side of the plane of \p t.
    [[nodiscard]] bool mayMeet(const glm::uvec3& t, const std::vector<Index>& corners) const
    {
        const auto side = [&](Index corner) {
            return CGAL::orientation(m_points[t.x], m_points[t.y], m_points[t.z], m_points[corner]);
        };
        const CGAL::Orientation first = side(corners.front());
        return first == CGAL::COPLANAR || (corners.size() > 1 && side(corners.back()) != first);
    }

    [[nodiscard]] Kernel::Triangle_3 triangle(const glm::uvec3& t) const
    {
        return {m_points[t.x], m_points[t.y], m_points[t.z]};
    }

    [[nodiscard]] Wedge wedge(Index corner, Index a, Index b) const
    {
        return {m_mesh.positions[corner], m_mesh.positions[a], m_mesh.positions[b]};
    }

    const TriangleMesh& m_mesh;
    const Family m_family;
    std::vector<Kernel::Point_3> m_points;
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
    std::map<Index, Index> gone, moved; // to the branch that stands for it; to its other parent
    for (const RepairNote& note : repairs) {
        if (note.kind == SkeletonRepair::SiblingChained || note.kind == SkeletonRepair::RootsJoined)
            moved[note.branch] = note.other;
        else if (note.kind == SkeletonRepair::SiblingsMerged ||
                 note.kind == SkeletonRepair::ZeroLengthContracted)
            gone[note.branch] = note.other;
    }
    std::vector<Index> parents;
    for (Index branch = 0; branch < skeleton.size(); ++branch) {
        Index parent = moved.contains(branch) ? moved[branch] : skeleton.parent[branch];
        while (gone.contains(parent))
            parent = gone[parent];
        parents.push_back(parent);
    }
    return parents;
}

} // namespace ramure::test
