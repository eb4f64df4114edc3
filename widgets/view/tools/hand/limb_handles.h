/// \file
/// Three places of a limb to take it by: foot, middle and tip. As large in the picture whatever the limb is,
/// so that a thin twig is hit, too.
#pragma once

#include "widgets/view/tools/tool_context.h"

class QPainter;

namespace ramure {

class LimbHandles
{
public:
    /// Those of this limb, until another one is shown; of nothing: those that are shown stay.
    void show(ToolContext& context, const std::optional<LimbHit>& limb);
    void hide() { m_places.clear(); }
    /// The limb at the handle that the pointer is at, from so many logical pixels on: reach.
    [[nodiscard]] std::optional<LimbHit> at(const ToolContext& context, const PickView& view,
                                            const glm::dvec2& pixel) const;
    void paint(QPainter& painter, const ToolContext& context, const PickView& view) const;

    static constexpr double reach = 8.0;

private:
    std::vector<LimbHit> m_places;
};

} // namespace ramure
