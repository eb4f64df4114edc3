#include "widgets/view/render/crown_marks.h"

#include "core/evaluate/evaluator.h"
#include "core/generators/colonisation/crown_shape.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace ramure {
namespace {

constexpr glm::u8vec4 reachColour{86, 156, 214, 150}, pointColour{255, 196, 84, 200};

} // namespace

LineSet crownLines(const ColonisationParams& params)
{
    LineSet set;
    const auto outline = CrownOutline::of(params);
    if (!outline)
        return set;
    constexpr int around = 48, along = 40, meridian = 6, ring = 8;
    const auto at = [&](int turn, int step) {
        const double angle = 2.0 * std::numbers::pi * turn / around, height = step / double(along);
        const double aside = params.crownRadius * outline->radiusAt(height);
        return glm::vec3(glm::dvec3(aside * std::cos(angle), params.crownBase + params.crownHeight * height,
                                    aside * std::sin(angle)));
    };
    const auto add = [&set](const glm::vec3& from, const glm::vec3& to) {
        if (from == to)
            return;
        set.segments.push_back({from, to, 1.0f, 1.0f, reachColour, noIndex});
        set.box.add(from);
        set.box.add(to);
    };
    for (int turn = 0; turn < around; ++turn)
        for (int step = 0; step <= along; ++step) {
            if (turn % meridian == 0 && step < along)
                add(at(turn, step), at(turn, step + 1));
            if (step % ring == 0)
                add(at(turn, step), at(turn + 1, step));
        }
    return set;
}

PointSet crownMarks(const ColonisationParams& params, std::uint64_t seed)
{
    PointSet set;
    ColonisationParams shown = params;
    shown.points = std::min(shown.points, mostCrownMarks);
    const auto points = crownPoints(shown, seed);
    for (const glm::dvec3& point : points.value_or(std::vector<glm::dvec3>())) {
        set.points.push_back({glm::vec3(point), 3.0f, pointColour, noIndex});
        set.box.add(set.points.back().position);
    }
    return set;
}

void addCrowns(RenderScene& built, EvaluatedScene& now, const std::vector<NodeId>& selected)
{
    for (std::size_t i = 0; i < now.scene().nodes().size(); ++i) {
        const Node& node = now.scene().nodes()[i];
        if (node.kind != NodeKind::Tree || !now.scene().isShown(node.id) ||
            std::ranges::find(selected, node.id) == selected.end())
            continue;
        const NodeParams params = now.params(node);
        if (params.generator.kind != EditOperation::Colonisation)
            continue;
        const auto seed = static_cast<std::uint64_t>(params.grammar.seed);
        LineItem lines;
        lines.lines = std::make_shared<const LineSet>(crownLines(params.colonisation));
        PointItem points;
        points.points = std::make_shared<const PointSet>(crownMarks(params.colonisation, seed));
        lines.world = points.world = now.transforms()[i].geometry;
        lines.node = points.node = node.id;
        lines.throughSurfaces = points.throughSurfaces = true;
        built.lines.push_back(std::move(lines));
        built.points.push_back(std::move(points));
    }
}

} // namespace ramure
