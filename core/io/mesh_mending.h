/// \file
/// Repairs that all mesh readers share: polygons, coordinates far from the origin, colours of vertices,
/// invalid normals, points without faces. Internal to core/io.
#pragma once

#include "core/io/mesh_file.h"
#include <array>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace ramure::reading {

/// The smallest box around positions that come block by block.
class Bounds
{
public:
    void take(std::span<const glm::vec3> positions);
    /// The point that becomes the origin of the moved positions, see farOrigin.
    [[nodiscard]] glm::dvec3 origin() const;

private:
    static constexpr std::size_t lanes =
        12; ///< x y z of four vertices: as many numbers as a processor compares
    static constexpr float none = std::numeric_limits<float>::infinity();
    std::array<float, lanes> m_low = filled(none), m_high = filled(-none);

    static constexpr std::array<float, lanes> filled(float value)
    {
        std::array<float, lanes> out{};
        out.fill(value);
        return out;
    }
};

/// Returns the point that must become the origin of a mesh with these bounds so that single precision holds
/// its shape: a round place near its middle. It is 0 if the mesh lies near the origin, for its size, or \p
/// low is above \p high.
glm::dvec3 farOrigin(const glm::dvec3& low, const glm::dvec3& high);
glm::dvec3 farOrigin(std::span<const glm::vec3> positions);
glm::dvec3 farOrigin(std::span<const glm::dvec3> positions);
/// Returns the positions relative to \p origin, as floats.
std::vector<glm::vec3> movedFrom(const glm::dvec3& origin, std::span<const glm::dvec3> positions);
/// Returns the note that coordinates were moved by \p origin.
std::string farNote(const glm::dvec3& origin);

/// A polygon that was read as a fan, which it may not be.
struct Polygon
{
    std::size_t firstTriangle;
    std::size_t corners;
};

/// Polygons as they are read: each stands in the triangles as a fan at first.
class PolygonList
{
public:
    /// Keeps the polygon whose fan ends the triangles, unless its vertices are known and it is a fan.
    void take(std::span<const glm::uvec3> triangles, std::size_t corners,
              std::span<const glm::vec3> positions);
    /// Cuts polygons that are no fans, and their texture triangles (as many, fewer or none) alike.
    void cut(std::span<const glm::vec3> positions, std::span<glm::uvec3> triangles,
             std::span<glm::uvec3> texture, std::vector<std::string>& notes);

private:
    bool gather(std::span<const glm::uvec3> triangles, const Polygon& polygon,
                std::span<const glm::vec3> positions);

    std::vector<Polygon> m_polygons;
    std::vector<glm::vec3> m_corners; ///< corners of the current polygon
};

/// Computes colours of triangles from those of their vertices. Each is the mean of the corners for which this
/// triangle is the last one, or of all corners if there is none. writePly chooses them in the same way, so
/// its files come back equal.
std::vector<glm::u8vec3> triangleColours(std::span<const glm::uvec3> triangles,
                                         std::span<const glm::u8vec3> ofVertices);
/// From 0 to 1 each; where one is above 1, all are from 0 to 255, which is noted.
std::vector<glm::u8vec3> colourBytes(std::span<const glm::vec3> colours, std::vector<std::string>& notes);

/// True where all are finite and none is zero.
bool areNormals(std::span<const glm::vec3> normals);
/// Replaces vertex normals that are zero or no numbers by those of the faces, and notes it. A vertex without
/// a triangle gets +Y.
void mendNormals(TriangleMesh& mesh, std::vector<std::string>& notes);

/// Error: Invalid, points without a triangle.
Expected<void> checkFaces(std::size_t points, std::size_t triangles, const std::string& file);

/// "12 zero bytes ..."; nothing is noted where there are none.
void notePadding(std::size_t bytes, std::vector<std::string>& notes);

} // namespace ramure::reading
