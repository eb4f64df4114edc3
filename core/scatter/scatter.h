/// \file
/// A scatter: copies of prototypes, which are the nodes below it, stand on the ground by rules. The rules are
/// the node's parameters (core/params/scatter_params.h); where the copies stand follows from them and is in
/// no file. What moves does not matter: the ground, obstacles and the scatter itself stand as they do at
/// rest. Whoever wants the stand of another age gives a node with the parameters of that time.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/scene/scene.h"
#include <glm/gtc/quaternion.hpp>
#include <memory>
#include <mutex>
#include <vector>

namespace ramure {

inline constexpr std::size_t mostInstances = 1'000'000;

/// Where one copy stands, in the space of the scatter.
struct ScatterPlace
{
    glm::dvec3 position{0.0}; ///< m
    double size = 1.0;
    glm::dquat turn{1.0, 0.0, 0.0, 0.0}; ///< unit
    std::uint32_t prototype = 0;         ///< its number among prototypesOf()
    std::uint32_t key = 0; ///< the same copy keeps it when other numbers of instances, scales, turns, shares
                           ///< or heights are wanted
    bool operator==(const ScatterPlace&) const = default;
};

using ScatterPlaces = std::vector<ScatterPlace>;
using SharedPlaces = std::shared_ptr<const ScatterPlaces>;

/// T * R * S of a place.
glm::dmat4 placeMatrix(const ScatterPlace& place);

/// The nodes that a scatter copies: the visible trees and shapes directly below it, in their order.
std::vector<const Node*> prototypesOf(const Scene& scene, NodeId scatter);
/// How a prototype's own geometry stands in a copy: as in its node, but for the node's translation. A point
/// of it is seen at worldMatrix(scatter) * placeMatrix(place) * prototypeMatrix(prototype).
glm::dmat4 prototypeMatrix(const Node& prototype);

/// Returns the places of all copies, in an order in which any beginning is spread over the whole area. There
/// are none where there is nothing to copy.
/// Errors, path = the parameter's key: Unknown (scatter.ground names no node); Invalid (it names a node
/// without a surface, or one below the scatter; neither a number nor a spacing; shares or keys that are not
/// numbers); Limit (over mostInstances); those of readGreyPicture for the map of density; Cancelled.
Expected<SharedPlaces> scatterPlaces(const Scene& scene, const Node& scatter, const Progress& progress = {});

/// Remembers the places of scatters while nothing changes that they follow from. Any thread may ask.
class ScatterMemory
{
public:
    /// scatterPlaces(), or what it gave before.
    Expected<SharedPlaces> places(const Scene& scene, const Node& scatter, const Progress& progress = {});

private:
    struct Known
    {
        NodeId node = noNode;
        std::uint64_t hash = 0;
        SharedPlaces places;
    };
    std::mutex m_mutex;
    std::vector<Known> m_known;
};

/// Equal where the places are equal, without working them out.
std::uint64_t scatterHash(const Scene& scene, const Node& scatter);

} // namespace ramure
