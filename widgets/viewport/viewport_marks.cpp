// What panels point at in the viewport: one section, one defect.
#include "widgets/validation/defect_place.h"
#include "widgets/viewport/viewport_private.h"

namespace ramure {

void Viewport::setInspectedSection(NodeId node, Index branch, Index section)
{
    const InspectedSection next{node, branch, section};
    if (d->inspected == next)
        return;
    d->inspected = next;
    wishScene();
}

void Viewport::clearInspectedSection()
{
    setInspectedSection(noNode, 0, 0);
}

void Viewport::setIsolated(NodeId node, const std::vector<Index>& branches)
{
    if (d->isolatedNode == node && d->isolatedBranches == branches)
        return;
    d->isolatedNode = node;
    d->isolatedBranches = branches;
    wishScene();
}

void Viewport::showDefect(NodeId, const DefectPlace& place)
{
    constexpr glm::u8vec4 colour{255, 0, 170, 255};
    auto lines = std::make_shared<LineSet>();
    auto points = std::make_shared<PointSet>();
    const auto line = [&](const glm::dvec3& a, const glm::dvec3& b) {
        lines->segments.push_back({glm::vec3(a), glm::vec3(b), 4.0f, 4.0f, colour, noIndex});
    };
    for (const auto& edge : place.edges)
        line(edge[0], edge[1]);
    for (const auto& face : place.faces) {
        for (std::size_t i = 0; i < 3; ++i)
            line(face[i], face[(i + 1) % 3]);
    }
    for (const glm::dvec3& point : place.points)
        points->points.push_back({glm::vec3(point), 12.0f, colour, noIndex});
    d->defectLines = std::move(lines);
    d->defectPoints = std::move(points);
    wishScene();
    frameBox(place.box);
    update();
}

void Viewport::clearDefect()
{
    if (!d->defectLines)
        return;
    d->defectLines.reset();
    d->defectPoints.reset();
    wishScene();
    update();
}

} // namespace ramure
