/// \file
/// Shadows of leaves on voxels: the light model of Palubicki et al. (2009), section 4.1.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace ramure {

/// Every leaf adds a b^-q to the (2q + 1)^2 voxels of each layer q = 0 .. depth below it. It is not added to
/// them one by one: sums over the rectangles of a layer answer how many leaves shade a voxel. Integers, so
/// that the order in which leaves come changes nothing.
class ShadowGrid
{
public:
    static constexpr int depth = 6;
    static constexpr std::size_t maxVoxels = std::size_t(1) << 24;

    /// Forgets all leaves. False: the box has more than maxVoxels. \param voxel m, edge.
    bool reset(const glm::dvec3& min, const glm::dvec3& max, double voxel);
    /// \param weight of its shadow; 16 is a leaf. \pre inside the box.
    void add(const glm::dvec3& at, std::int32_t weight);
    /// More leaves than so many sixteenths in a voxel shade each other, not what is below.
    static constexpr std::int32_t densest = 24;
    /// To be called once after the last leaf.
    void sum();

    /// Leaves over a point, those of layer q by a b^-q.
    [[nodiscard]] double shadowAt(const glm::dvec3& at, double a);
    /// Where it gets lighter: minus the gradient of the shadow, per voxel.
    [[nodiscard]] glm::dvec3 lighter(const glm::dvec3& at, double a);

private:
    [[nodiscard]] double shadow(int x, int y, int z);
    [[nodiscard]] double sumOver(int x, int y, int z) const;

    glm::dvec3 m_min{0.0};
    double m_scale = 1.0; ///< voxels a metre
    int m_x = 0, m_y = 0, m_z = 0;
    std::vector<std::int32_t> m_sums; ///< layer by layer, with a row and a column of zeros before each
    std::vector<double> m_known; ///< shadows that were asked for: many buds share a voxel, more a neighbour
    std::vector<std::uint64_t> m_isKnown; ///< a bit a voxel
};

} // namespace ramure
