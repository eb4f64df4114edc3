/// \file
/// Parameters of primitives and of the surface of objects. The member initialisers are the defaults.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace ramure {

/// The values are positions in the table's list of items; files have the names.
enum class PrimitiveShape : std::uint8_t {
    Cylinder,   ///< on the origin, along the axis; radius, height, sides
    Sphere,     ///< about the origin; radius, sides
    Box,        ///< about the origin; size
    Cone,       ///< on the origin, along the axis; radius, height, sides
    Plane,      ///< about the origin, across the axis; size x and z
    FrameCross, ///< three arrows along X, Y and Z; height is their length, radius their thickness
};
enum class PrimitiveAxis : std::uint8_t { X, Y, Z };

struct PrimitiveParams
{
    PrimitiveShape shape = PrimitiveShape::Cylinder;
    double radius = 0.5;  ///< m
    double height = 1.0;  ///< m
    glm::dvec3 size{1.0}; ///< m
    std::int64_t sides = 20;
    PrimitiveAxis axis = PrimitiveAxis::Y;
    bool operator==(const PrimitiveParams&) const = default;
};

/// Surface of primitives and imported meshes.
struct SurfaceParams
{
    glm::dvec3 color{0.72, 0.72, 0.72}; ///< red, green, blue as screens have them, 0..1
    bool operator==(const SurfaceParams&) const = default;
};

} // namespace ramure
