/// \file
/// Flat blades, and what bends them. Internal to leaf_shapes.cpp.
#pragma once

#include "core/base/index.h"
#include "core/surface/foliage/leaf_shapes.h"
#include "core/surface/foliage/leaf_table.h"
#include <glm/vec2.hpp>
#include <vector>

namespace ramure {

/// In its plane: foot at the origin, midrib along +Y, 1 long. Vertex 0 is the foot.
struct FlatBlade
{
    std::vector<glm::dvec2> points;
    std::vector<glm::uvec3> triangles; ///< counter-clockwise
    double halfWidth = 0.0;
};

/// A blade of the row's outline. \param stations between foot and tip, >= 1; a lobed blade has one less of
/// its lobes at 1 and all of them above. \param fine whether its edge is rounded and has teeth. \param width
/// of what the row says.
FlatBlade bladeOf(const LeafRow& row, double width, int stations, bool fine);
/// Two triangles, widest below its middle.
FlatBlade needleOf(const LeafRow& row, double width);
/// A blade whose lobes leave its foot. \param detail 1..3.
FlatBlade starOf(const LeafRow& row, double width, int detail);

/// Folds, cups and curls a blade's points; its foot stays, tangent to +Y.
class BladeBend
{
public:
    /// \param curlShare of the form's curl. \param wedge tangent of the half angle about +Y that a leaflet
    /// keeps to, seen from above: its neighbours have the rest. 0: it has no neighbours.
    BladeBend(const LeafForm& form, double halfWidth, double curlShare = 1.0, double wedge = 0.0);
    [[nodiscard]] glm::dvec3 at(const glm::dvec2& point) const;

private:
    double m_fold, m_curl, m_cup, m_halfWidth, m_wedge;
};

} // namespace ramure
