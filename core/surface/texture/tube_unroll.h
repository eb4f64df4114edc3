/// \file
/// Points around a curved axis in its unrolled coordinates: how far along, and at which azimuth.
#pragma once

#include "core/math/frame.h"
#include "core/surface/mesher/branch_mesh.h"
#include <array>
#include <utility>

namespace ramure {

/// A tube's axis as a row of frames, close enough together to read any place between two of them.
class UnrollAxis
{
public:
    /// Divides evenly by the spans of the usual numbers of cross-sections, so that these lie on nodes.
    static constexpr std::size_t steps = 12;

    struct Node
    {
        glm::dvec3 point{0.0};
        Frame frame;
        double along = 0.0;   ///< m, from the start
        double radius = 0.0;  ///< m
        double own = 0.0;     ///< m, without what it is wider at its start
        glm::dvec2 bend{0.0}; ///< along the normal and the binormal: to the inside, radius times curvature
    };
    struct Place
    {
        double along;   ///< m, 0 to length()
        double azimuth; ///< rad, -pi to pi, from the frame's normal towards its binormal
        double radial;  ///< distance from the axis, in radii there
        double beyond;  ///< how far before the start or past the end, in radii there; else 0
        /// rad, to be added to the azimuth: on a torus, squares stay squares where they are smaller on the
        /// inside of the bend. To first order in the bend.
        double crowding;
        double radius; ///< m, of the tube there
    };

    /// \param normal any vector, not along the axis's start: azimuths are counted from it. It is carried
    /// along the axis without turning about it.
    /// \param bend of the end that it goes on from. Over some diameters it gives way to the axis's own.
    void build(const TubeAxis& axis, const glm::dvec3& normal, const glm::dvec3& bend);
    /// The foot is searched from where the last one was found: neighbours should follow each other.
    Place place(const glm::dvec3& point);
    [[nodiscard]] const std::array<Node, steps + 1>& nodes() const { return m_nodes; }
    [[nodiscard]] const Node& end() const { return m_nodes.back(); }
    /// The node before a place along the axis, and the share of the way to the next, 0 to 1.
    [[nodiscard]] std::pair<std::size_t, double> find(double along) const;
    [[nodiscard]] double length() const { return m_nodes.back().along; }

private:
    void bendNodes(const glm::dvec3& before);

    std::array<Node, steps + 1> m_nodes;
    std::size_t m_last = 0;
};

} // namespace ramure
