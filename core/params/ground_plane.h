/// \file
/// The ground that a tree stands on, as the plane that it is near the tree's foot.
#pragma once

#include "core/base/lazy.h"
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>

namespace ramure {

struct NodeParams;

/// In tree space, m: y = height + grade.x x + grade.y z.
struct GroundPlane
{
    double height = 0.0;
    glm::dvec2 grade{0.0}; ///< how far it rises in a metre along X and along Z

    /// m, how far a place is over it
    [[nodiscard]] double above(const glm::dvec3& place) const
    {
        return place.y - height - grade.x * place.x - grade.y * place.z;
    }
    /// The same seen from another place.
    [[nodiscard]] GroundPlane from(const glm::dvec3& place) const { return {-above(place), grade}; }
    bool operator==(const GroundPlane&) const = default;
};

using LazyGround = Lazy<std::optional<GroundPlane>>;
/// The ground that the scene has under a tree: derived from it (core/scene/standing_ground.h) and in no file.
/// The plane is looked for when it is first needed. Two are equal where the same surfaces lie at the same
/// places.
struct StandingGround
{
    std::uint64_t hash = 0;
    std::shared_ptr<const LazyGround> plane; ///< null: the scene has no ground

    /// Nothing: none is near.
    [[nodiscard]] std::optional<GroundPlane> nearby() const { return plane ? **plane : std::nullopt; }
    bool operator==(const StandingGround& other) const { return hash == other.hash; }
};

/// Returns the ground that a tree stands on: what the scene says, else the slope that it grows on; nothing
/// where that is level.
std::optional<GroundPlane> groundOf(const NodeParams& params);

} // namespace ramure
