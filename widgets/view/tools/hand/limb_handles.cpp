#include "widgets/view/tools/hand/limb_handles.h"

#include "core/evaluate/evaluator.h"
#include <QPainter>

namespace ramure {
namespace {

std::optional<glm::dvec2> pixelOf(const ToolContext& context, const PickView& view, const LimbHit& place)
{
    const glm::dmat4 world = EvaluatedScene(context.document.scene()).transforms(place.node).geometry;
    return view.pixel(glm::dvec3(world * glm::dvec4(place.seen, 1.0)));
}

} // namespace

void LimbHandles::show(ToolContext& context, const std::optional<LimbHit>& limb)
{
    if (!limb || (!m_places.empty() && m_places.front().address == limb->address))
        return;
    m_places.clear();
    const auto branches = context.limbs.limb(context.document, limb->node, limb->address);
    const TreeAxes* axes = context.limbs.axes(context.document, limb->node);
    if (branches.empty() || !axes || limb->axis >= axes->axes.size())
        return;
    const double length = axes->axes[limb->axis].length;
    const std::vector<LimbSpan> spans = context.limbs.spans(context.document, limb->node);
    for (const double share : {0.0, 0.5, 1.0})
        for (const Index b : branches) {
            const double whole = spans[b].to - spans[b].from;
            if (share * length > spans[b].to && b != branches.back())
                continue;
            const double t =
                whole > 0.0 ? std::clamp((share * length - spans[b].from) / whole, 0.0, 1.0) : 0.0;
            if (auto place = context.limbs.onBranch(context.document, limb->node, b, t))
                m_places.push_back(*place);
            break;
        }
}

std::optional<LimbHit> LimbHandles::at(const ToolContext& context, const PickView& view,
                                       const glm::dvec2& pixel) const
{
    std::optional<LimbHit> nearest;
    double least = reach;
    for (const LimbHit& place : m_places)
        if (const auto seen = pixelOf(context, view, place); seen && glm::length(*seen - pixel) <= least) {
            least = glm::length(*seen - pixel);
            nearest = place;
        }
    return nearest;
}

void LimbHandles::paint(QPainter& painter, const ToolContext& context, const PickView& view) const
{
    constexpr double radius = 4.5;
    painter.setPen(QPen(QColor(16, 22, 28, 200), 1.4));
    painter.setBrush(QColor(255, 255, 255, 230));
    for (const LimbHit& place : m_places)
        if (const auto seen = pixelOf(context, view, place))
            painter.drawEllipse(QPointF(seen->x, seen->y), radius, radius);
}

} // namespace ramure
