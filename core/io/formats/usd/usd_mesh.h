/// \file
/// What is inside the prims of meshes, copies and lines of a USD layer. Internal to the formats.
#pragma once

#include "core/io/export_scene.h"
#include "core/io/formats/usd/usd_text.h"
#include <limits>
#include <optional>
#include <span>

namespace ramure::usd {

/// The smallest box around points, empty at first.
struct Box
{
    glm::dvec3 low{std::numeric_limits<double>::max()}, high{std::numeric_limits<double>::lowest()};

    void take(const glm::dvec3& point);
    [[nodiscard]] bool isEmpty() const { return !(low.x <= high.x); }
};
/// Writes `float3[] extent`, unless the box is empty.
void writeExtent(Text& text, const Box& box);

/// How a mesh is coloured, all linear.
struct Colours
{
    glm::vec3 factor{1.0F};   ///< times the colours of the mesh, if it has some
    glm::vec3 constant{1.0F}; ///< else
    bool isHanded = false;    ///< what holds the mesh says its colours: none are written
    bool isPainted = false;   ///< its coordinates are places in the picture of all colours
};

/// Points, faces, normals, coordinates, colours. \param textured with texture coordinates
void writeMesh(Text& text, const TriangleMesh& mesh, bool textured, bool twoSided, const Colours& colours);
/// Points, normals and extents over time. \param rate codes a second
void writeShapes(Text& text, const TriangleMesh& mesh, const ExportShapes& shapes, double rate);
/// A colour of sRGB bytes, linear.
glm::vec3 linearColour(const glm::u8vec3& colour);
/// Mean of the colours of a mesh, linear; white of none.
glm::vec3 meanOf(const TriangleMesh& mesh);
/// The subset of triangles on which bark is young, if there are some. \param bind the line that binds its
/// material
void writeYoung(Text& text, std::span<const Index> triangles, const std::string& bind);
/// The triangles of a mesh that are nearer to the skin of twigs than to bark.
std::vector<Index> youngTriangles(const TriangleMesh& mesh, const BarkParams& bark);
/// `primvars:season`, per vertex the number that says when its piece turns.
void writePhases(Text& text, const ExportSeasons& seasons, Index vertices);

/// Everything of a PointInstancer but its prototype. \param prototype its path \param colour linear, times
/// the tints of the copies; none: the prototype has its own colours
void writeCopies(Text& text, const ExportCopies& copies, const std::string& prototype,
                 const std::optional<glm::vec3>& colour);
/// Segments as BasisCurves.
void writeLines(Text& text, const LinePart& lines);

/// Errors: Invalid, a coordinate of \p name is not a finite number.
Expected<void> checkFinite(const TriangleMesh& mesh, const std::string& name);
Expected<void> checkFinite(const ExportCopies& copies);
/// The same of a place.
Expected<void> checkFinite(const glm::dmat4& place, const std::string& name);

} // namespace ramure::usd
