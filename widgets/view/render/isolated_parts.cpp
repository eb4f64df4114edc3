#include "widgets/view/render/isolated_parts.h"

namespace ramure {
namespace {

bool isShown(const BranchFlags& shown, Index branch)
{
    return branch < shown.size() && shown[branch];
}

/// Vertices by their new numbers.
class Gathering
{
public:
    explicit Gathering(const TriangleMesh& from)
        : m_from(from)
        , m_place(from.positions.size(), noIndex)
    {
    }

    Index take(Index vertex)
    {
        Index& place = m_place[vertex];
        if (place != noIndex)
            return place;
        place = made.vertexCount();
        made.positions.push_back(m_from.positions[vertex]);
        if (!m_from.normals.empty())
            made.normals.push_back(m_from.normals[vertex]);
        made.branch.push_back(m_from.branch[vertex]);
        if (!m_from.level.empty())
            made.level.push_back(m_from.level[vertex]);
        if (m_from.uv.size() == m_from.positions.size())
            made.uv.push_back(m_from.uv[vertex]);
        if (!m_from.radius.empty())
            made.radius.push_back(m_from.radius[vertex]);
        return place;
    }

    TriangleMesh made;

private:
    const TriangleMesh& m_from;
    std::vector<Index> m_place;
};

} // namespace

BranchFlags branchFlags(std::size_t count, const std::vector<Index>& branches)
{
    BranchFlags flags(count, false);
    for (const Index branch : branches)
        if (branch < count)
            flags[branch] = true;
    return flags;
}

TriangleMesh onlyBranches(const TriangleMesh& mesh, const BranchFlags& shown)
{
    if (mesh.branch.size() != mesh.positions.size())
        return mesh;
    Gathering gathering(mesh);
    const bool hasColours = mesh.colours.size() == mesh.triangles.size();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const glm::uvec3& triangle = mesh.triangles[t];
        bool any = false;
        for (int corner = 0; corner < 3; ++corner)
            any = any || isShown(shown, mesh.branch[triangle[corner]]);
        if (!any)
            continue;
        const Index a = gathering.take(triangle.x);
        const Index b = gathering.take(triangle.y);
        const Index c = gathering.take(triangle.z);
        gathering.made.triangles.emplace_back(a, b, c);
        if (hasColours)
            gathering.made.colours.push_back(mesh.colours[t]);
    }
    return std::move(gathering.made);
}

LineSet onlyBranches(const LineSet& lines, const BranchFlags& shown)
{
    LineSet kept;
    for (const LineSegment& segment : lines.segments) {
        if (segment.branch != noIndex && !isShown(shown, segment.branch))
            continue;
        kept.segments.push_back(segment);
        kept.box.add(glm::dvec3(segment.a));
        kept.box.add(glm::dvec3(segment.b));
    }
    return kept;
}

PointSet onlyBranches(const PointSet& points, const BranchFlags& shown)
{
    PointSet kept;
    for (const PointMark& mark : points.points) {
        if (mark.branch != noIndex && !isShown(shown, mark.branch))
            continue;
        kept.points.push_back(mark);
        kept.box.add(glm::dvec3(mark.position));
    }
    return kept;
}

} // namespace ramure
