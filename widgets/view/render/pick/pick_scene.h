/// \file
/// Finds the object under the cursor. Picking runs on the CPU, so that it is exact and tested without OpenGL.
/// A PickScene is built from a render scene, in the background if desired, and then only read.
///
/// Surfaces: the nearest triangle along the ray. Lines: the one nearest to the cursor in pixels; of several
/// under it the one in front. Rectangles take everything inside, also hidden objects.
#pragma once

#include "widgets/view/render/camera.h"
#include "widgets/view/render/render_scene.h"
#include <optional>
#include <stop_token>

namespace ramure {

struct PickHit
{
    NodeId node = noNode;
    Index branch = noIndex; ///< index in the simplified skeleton; noIndex for meshes without branches
    glm::dvec3 point{0.0};  ///< world
    std::optional<std::uint32_t> copy{}; ///< of a scatter: the key of the copy (ScatterPlace::key)
};

/// The picture in which to pick: its camera and size in logical pixels.
struct PickView
{
    Camera camera;
    glm::dvec2 size{1.0};

    [[nodiscard]] double aspect() const { return size.x / size.y; }
    /// Logical pixels from the upper left corner to ndc.
    [[nodiscard]] glm::dvec2 ndc(const glm::dvec2& pixel) const
    {
        return {2.0 * pixel.x / size.x - 1.0, 1.0 - 2.0 * pixel.y / size.y};
    }
    /// Returns the pixel at which a point of the world is seen; nothing behind the eye.
    [[nodiscard]] std::optional<glm::dvec2> pixel(const glm::dvec3& world) const
    {
        const auto at = camera.project(world, aspect());
        return at ? std::optional(0.5 * glm::dvec2(at->x + 1.0, 1.0 - at->y) * size) : std::nullopt;
    }
};

/// Branches of one node, ascending.
struct PickedBranches
{
    NodeId node = noNode;
    std::vector<Index> branches;
};

class PickScene
{
public:
    PickScene();
    /// Takes over what \p previous (may be null) already built for the same blocks. A stopped build finds
    /// nothing.
    PickScene(const RenderScene& scene, const PickScene* previous, const std::stop_token& stop = {});
    ~PickScene();
    PickScene(PickScene&&) noexcept;
    PickScene& operator=(PickScene&&) noexcept;

    /// \param tolerance how far from a line the cursor may be, logical pixels.
    [[nodiscard]] std::optional<PickHit> pick(const PickView& view, const glm::dvec2& pixel,
                                              double tolerance = 6.0) const;
    /// Returns where the ray under the cursor first meets a surface of this node, in the world, even if other
    /// nodes are in front (for the first of all nodes see pick). \p world is the node's present place, which
    /// may differ from the one in this scene. Nothing if this scene does not have the node's surfaces.
    [[nodiscard]] std::optional<glm::dvec3> meet(const PickView& view, const glm::dvec2& pixel, NodeId node,
                                                 const glm::dmat4& world) const;
    /// \param mesh that it must be; null: any.
    [[nodiscard]] bool hasSurface(NodeId node, const TriangleMesh* mesh = nullptr) const;
    /// Everything with a part in the rectangle of two opposite corners, by node in the order of the scene.
    [[nodiscard]] std::vector<PickedBranches> inRectangle(const PickView& view, const glm::dvec2& cornerA,
                                                          const glm::dvec2& cornerB) const;

private:
    struct Part;
    [[nodiscard]] ViewRay rayUnder(const PickView& view, const glm::dvec2& pixel) const;
    std::vector<std::shared_ptr<const Part>> m_parts;
    std::vector<CrowdItem> m_crowds; ///< that can be picked
    Box m_box;
};

} // namespace ramure
