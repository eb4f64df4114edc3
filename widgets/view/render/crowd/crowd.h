/// \file
/// A crowd: a few prototypes, such as trees, that stand in many places. Each prototype has forms for less and
/// less pixels. Plain data that is shared and never changes; which form stands where in a picture is found by
/// crowd_choice.h. Space: that of the node which the crowd belongs to; metres.
#pragma once

#include "core/base/error.h"
#include "core/math/bvh.h"
#include "core/scatter/scatter.h"
#include "core/scene/material.h"
#include "widgets/view/render/crowd/mesh_copies.h"
#include "widgets/view/render/light/crown_light.h"
#include <optional>

namespace ramure {

struct BarkMaps;
struct SurfaceImages;

/// One surface of a form.
struct CrowdPart
{
    std::shared_ptr<const MeshCopies> shape; ///< in the prototype's space; without copies
    Material material;
    std::shared_ptr<const BarkMaps> bark;        ///< null: none
    std::shared_ptr<const SurfaceImages> images; ///< in its place; null: none
    glm::vec3 mean{1.0f};                        ///< sRGB: of their colours
    /// Of a billboard: how far from its middle its corners look for the light in the crown; 0: it is none.
    float flat = 0.0f;
    bool closed = false; ///< its back faces are never seen
};

/// What is drawn of a prototype that has some pixels.
struct CrowdForm
{
    std::vector<CrowdPart> parts;
    std::int64_t triangles = 0;
    double leastPixels = 0.0; ///< the height down to which it is shown; 0: the last form
};

struct CrowdPrototype
{
    Box box;                         ///< around it, in the space that its places act upon
    std::vector<CrowdForm> forms;    ///< the finest first, each for less pixels; empty: it is not shown
    std::int64_t wholeTriangles = 0; ///< of the prototype itself, in the place of a form; 0: it has none
    std::shared_ptr<const CrownLight> crown; ///< light inside it; null: none
    /// From the space of the light and of the shapes to that of the box, which the places act upon.
    ScatterPlace local{}; ///< uniform: forms of what is stretched have its mean
};

class Crowd
{
public:
    /// Errors: Invalid (a place that is not finite, has no size, or a prototype that does not exist, with its
    /// number).
    static Expected<std::shared_ptr<const Crowd>> make(SharedPlaces places,
                                                       std::vector<CrowdPrototype> prototypes);

    [[nodiscard]] const std::vector<ScatterPlace>& places() const { return *m_places; }
    [[nodiscard]] const std::vector<CrowdPrototype>& prototypes() const { return m_prototypes; }
    [[nodiscard]] const Box& box() const { return m_box; }
    /// The boxes of all places whose prototype is shown.
    [[nodiscard]] const Bvh& bounds() const { return m_bounds; }
    /// Around what stands at a place.
    [[nodiscard]] Box boxOf(const ScatterPlace& place) const;
    /// All places of a prototype that is shown, as copies.
    [[nodiscard]] const std::shared_ptr<const std::vector<MeshCopy>>& copies(std::size_t prototype) const
    {
        return m_copies[prototype];
    }
    /// The place that a ray meets first, and where: each is the ellipsoid in its prototype's box.
    struct Hit
    {
        Index place = noIndex;
        double t = 0.0;
    };
    [[nodiscard]] std::optional<Hit> meet(const Ray& ray, double most) const;

private:
    Crowd() = default;

    SharedPlaces m_places;
    std::vector<CrowdPrototype> m_prototypes;
    std::vector<std::shared_ptr<const std::vector<MeshCopy>>> m_copies;
    Box m_box;
    Bvh m_bounds;
};

/// For the shader, from the space of the shapes. \param shown 255: all of its pixels (crowd_choice.h)
MeshCopy copyOf(const ScatterPlace& place, const CrowdPrototype& prototype, std::uint8_t shown = 255);

} // namespace ramure
