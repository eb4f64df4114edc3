/// \file
/// How much wood a branch mesh has on the way from the foot to the tips: cross-sections measured on its
/// triangles, through forks.
#pragma once

#include "core/surface/mesher/branch_mesh.h"
#include <array>
#include <vector>

namespace ramure {

/// How a tree carries its wood through the forks of its trunk, at worst.
struct WoodLoss
{
    double quarter = 0.0, whole = 0.0;             ///< share lost within a quarter of a diameter, within one
    double quarterHeight = 0.0, wholeHeight = 0.0; ///< m, along the trunk, where that is
};

/// A limb half its diameter from where its axis comes out, over what it is at two diameters.
struct Swelling
{
    Index branch = noIndex;
    double share = 0.0; ///< of its own radius, of the thickest child's of its fork
    double ratio = 0.0;
};

class WoodSections
{
public:
    explicit WoodSections(const BranchMesh& mesh);

    /// Up the trunk, from above its foot to where it has \p thinnest of its first radius. All wood that a
    /// section of the trunk leads to counts.
    [[nodiscard]] WoodLoss lossUpTheTrunk(double thinnest = 0.3) const;
    /// Of all branches at least \p thinnest (m) thick and long enough that leave a fork.
    [[nodiscard]] std::vector<Swelling> swellings(double thinnest) const;

private:
    static constexpr int steps = 32;
    struct Tube
    {
        std::vector<glm::dvec3> points;
        std::vector<double> along;
        std::size_t fork = none, stem = none; ///< the tube it leaves, and the thickest that leaves it
        std::vector<std::size_t> children;
        double thickness = 0.0; ///< m, the radius it starts with, without what it is wider there
        bool isLimb = false;
    };
    struct Place
    {
        glm::dvec3 point, tangent;
        double radius;
    };
    static constexpr std::size_t none = std::size_t(-1);
    static constexpr std::size_t rays = 48; ///< around a section
    /// A section: the plane across an axis, and how far the surface is there.
    struct Cut
    {
        Place place;
        glm::dvec3 u, v; ///< unit, across the axis
        std::array<double, rays> reach;
    };

    [[nodiscard]] Place at(std::size_t tube, double along) const;
    [[nodiscard]] glm::dvec3 wayOf(std::size_t tube) const;
    [[nodiscard]] bool hasForkWithin(std::size_t tube, double along, double reach) const;
    [[nodiscard]] double length(std::size_t tube) const { return m_tubes[tube].along.back(); }
    [[nodiscard]] double area(std::size_t tube, double along) const;
    void cutThrough(std::size_t tube, Cut& cut) const;
    static void shorten(glm::dvec2 start, glm::dvec2 end, Cut& cut);
    [[nodiscard]] double ownReach(std::size_t tube, double along, const Place& place,
                                  const glm::dvec3& way) const;
    [[nodiscard]] double woodAt(std::size_t tube, double along, double thinnest) const;
    [[nodiscard]] std::vector<std::size_t> together(std::size_t tube, double along) const;
    [[nodiscard]] double apart(std::size_t one, std::size_t other, double along) const;
    [[nodiscard]] std::vector<std::size_t> siblings(std::size_t tube) const;
    [[nodiscard]] double meanRadius(std::size_t tube, double along) const;

    const BranchMesh& m_mesh;
    std::vector<Tube> m_tubes;
    std::vector<std::size_t> m_roots;
};

} // namespace ramure
