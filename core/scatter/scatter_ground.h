/// \file
/// What copies of a scatter stand on, and what they keep away from, as seen from above.
#pragma once

#include "core/base/error.h"
#include "core/math/bvh.h"
#include "core/scene/scene.h"
#include <optional>

namespace ramure {

/// Triangles of several solids in the space of a scatter.
class SurfaceFromAbove
{
public:
    struct Place
    {
        double height = 0.0;
        glm::dvec3 normal{0.0, 1.0, 0.0}; ///< unit, never downwards
    };
    /// Takes the nodes' shapes. Errors: those of EvaluatedScene::solid.
    static Expected<SurfaceFromAbove> of(const Scene& scene, const Node& scatter,
                                         const std::vector<const Node*>& solids);

    [[nodiscard]] bool empty() const { return m_triangles.empty(); }
    /// The highest place over or under (x, z).
    [[nodiscard]] std::optional<Place> at(double x, double z) const;
    /// Is anything of it, on a map, nearer to (x, z) than \p distance?
    [[nodiscard]] bool isNear(double x, double z, double distance) const;

private:
    using Triangle = std::array<glm::dvec3, 3>;
    std::vector<Triangle> m_triangles;
    Bvh m_tree;
    double m_top = 0.0;
};

/// The nodes that a scatter's copies stand on; none: the level ground. Errors: see scatterPlaces().
Expected<std::vector<const Node*>> groundsOf(const Scene& scene, const Node& scatter);
/// The solids that its copies keep away from: obstacles that are no ground of it and not below a scatter.
std::vector<const Node*> obstaclesOf(const Scene& scene, const std::vector<const Node*>& grounds);

} // namespace ramure
