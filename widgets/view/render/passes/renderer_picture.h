/// \file
/// What the passes of one picture share. Internal to the files of the renderer.
#pragma once

#include "widgets/view/render/passes/renderer.h"
#include <optional>

namespace ramure {

struct Renderer::Picture
{
    const RenderScene& scene;
    const Camera& camera;
    const RenderOptions& options;
    PictureLight light;
    glm::vec2 viewport{1.0f};
    glm::dmat4 projectedView{1.0}; ///< eye-relative -> clip
    ShadowPlace shadow{};
    std::optional<ShadowPlace> near{}; ///< finer, of what is near
    int shadowTaps = 0;
    bool occluded = false; ///< what stands close by hides some of the sky
    double aspect = 1.0;

    /// World axes and scale, the origin in the eye: keeps floats precise wherever the scene lies.
    [[nodiscard]] glm::dmat4 relative(const glm::dmat4& world) const
    {
        glm::dmat4 moved = world;
        moved[3] -= glm::dvec4(camera.eye(), 0.0);
        return moved;
    }
    /// How large the nearest copy can be; infinity of what is no copy.
    [[nodiscard]] double copyPixels(const MeshItem& item) const;
    [[nodiscard]] bool isOfSmall(const MeshItem& item) const;
    /// Copies of a picture need its texture coordinates, and are never of the least.
    [[nodiscard]] LeafDetail detailOf(const MeshItem& item) const;
    /// There is a ground, and its depth is linear over the picture.
    [[nodiscard]] bool isLevel() const { return options.ground && !camera.orthographic; }
    [[nodiscard]] float lift() const { return camera.orthographic ? 2e-4f : 4e-5f; }
};

} // namespace ramure
