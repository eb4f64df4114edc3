/// \file
/// The meshes of a USD layer as triangles. Internal to the formats.
#pragma once

#include "core/io/formats/usd/usd_layer.h"
#include "core/surface/mesh/triangle_mesh.h"

namespace ramure::usd {

inline constexpr std::size_t mostTriangles = 50'000'000; ///< of a mesh, and of all copies together

struct Shape
{
    TriangleMesh mesh;
    std::vector<Index> faceOf; ///< per triangle its face in the file
    std::size_t faces = 0;
    std::vector<std::string> notes; ///< what was left out
};

/// A mesh, or a cube, sphere, cylinder, cone or plane.
bool isSurface(const Prim& prim);

/// Faces are cut into triangles; colours are those of primvars:displayColor. Errors, with the line: Invalid
/// (an index out of range, lists that do not fit, a list of another type, no size), Limit. \pre isSurface
Expected<Shape> shapeOf(const Prim& prim);

/// The numbers of an attribute. \param components that each element has to have. Empty where there is none.
/// Error: Invalid, with the line.
Expected<std::vector<double>> numbersOf(const Prim& prim, const std::string& name, int components);
/// The same as whole numbers from 0 up to below \p end. Error: Invalid.
Expected<std::vector<Index>> indicesOf(const Prim& prim, const std::string& name, std::size_t end);
/// An error about an attribute of a prim, with its line.
tl::unexpected<Error> wrongAttribute(const Prim& prim, const std::string& name, const char* text,
                                     std::vector<std::string> args = {});
/// Where the values of an attribute stand: "vertex", "faceVarying", "uniform", "constant".
std::string interpolationOf(const Attribute& attribute);

} // namespace ramure::usd
