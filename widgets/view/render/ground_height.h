/// \file
/// How deep the ground lies: at y = 0, or under the lowest point that an object of the scene ever reaches.
#pragma once

#include "core/scene/scene.h"
#include "widgets/view/render/render_scene.h"

namespace ramure {

/// Keeps what it found until something changes that it depends on; the time on show is not among that, so
/// that the ground stays where it is while the scene plays.
class GroundHeight
{
public:
    /// Metres, at most 0. Trees and arms stand on the ground and do not move it; primitives, imported meshes
    /// and terrains do, over the whole timeline, looked at some tens of times. \param built holds the meshes
    /// of the objects that are shown, in their own space.
    double of(const Scene& scene, const RenderScene& built);

private:
    struct Stamp
    {
        std::vector<double> numbers;
        std::vector<std::shared_ptr<const void>> held; ///< no address is used twice while it is compared
        bool operator==(const Stamp&) const = default;
    };
    static Stamp stampOf(const Scene& scene, const RenderScene& built);

    Stamp m_stamp;
    double m_height = 0.0;
};

} // namespace ramure
