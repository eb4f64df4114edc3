/// \file
/// Solids that a tree fills and solids that it grows around, in tree space.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/math/random.h"
#include "core/params/growth_space.h"
#include "core/surface/mesh/mesh_rays.h"
#include <mutex>
#include <string>
#include <vector>

namespace ramure {

/// The solids of the scene that a tree fills or avoids. Any number of threads may ask. The search structures
/// are built at the first question, not by the constructor: artists drag solids, and trees grow in the
/// background.
class GrowthSpace
{
public:
    struct Solid
    {
        std::string name; ///< for errors
        std::shared_ptr<const TriangleMesh> mesh;
        GrowthRole role = GrowthRole::None;
    };

    /// \param solids with triangles; obstacles may be open: walls.
    explicit GrowthSpace(std::vector<Solid> solids);

    /// Errors, path "colonisation.envelope": Invalid (no solid is to be filled, or one has no inside).
    [[nodiscard]] Expected<void> checkEnvelope() const;
    /// Returns the highest point of the solids to be filled; 0 if there are none.
    [[nodiscard]] double top() const;
    /// Is the point inside an obstacle?
    [[nodiscard]] bool blocks(const glm::dvec3& point) const;
    /// Does an obstacle stand between the two?
    [[nodiscard]] bool blocks(const glm::dvec3& from, const glm::dvec3& to) const;
    /// Returns points above the ground inside the solids to be filled. Point number i depends on \p seed and
    /// i alone. \param surface share of them that lies on the surface. \pre checkEnvelope. Error: Cancelled.
    [[nodiscard]] Expected<std::vector<glm::dvec3>>
    points(std::int64_t count, double surface, std::uint64_t seed, const Progress& progress) const;

private:
    struct Body
    {
        std::string name;
        MeshRays rays;
        bool closed = false;
        double outward = 1.0; ///< -1: its faces look inward
    };
    struct Bodies
    {
        std::vector<Body> fills, avoids;
        std::vector<std::pair<std::size_t, Index>> faces; ///< body and triangle of the solids to be filled
        std::vector<double> area; ///< sum of the face areas up to and including this face
    };
    [[nodiscard]] static bool isInside(const Body& body, const glm::dvec3& point);
    [[nodiscard]] const Bodies& bodies() const;
    [[nodiscard]] glm::dvec3 onSurface(Random& random) const;

    std::vector<Solid> m_solids;
    glm::dvec3 m_min{0.0}, m_max{0.0}; ///< bounds of the space to be filled
    mutable std::once_flag m_once;
    mutable Bodies m_bodies;
};

} // namespace ramure
