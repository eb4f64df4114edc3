/// \file
/// How well texture coordinates fit a mesh.
#pragma once

#include "core/surface/texture/texture_coordinates.h"

namespace ramure {

/// Tiles per metre on the branches of one level: the root of area in the texture over area in space.
struct TextureLevel
{
    Index level = 0;
    Index triangles = 0;
    double tilesPerMetre = 0.0;
};

/// The map of a triangle to the texture plane has two singular values; their ratio is its stretch (1: squares
/// stay squares), a negative determinant means it is mirrored.
struct TextureReport
{
    static constexpr double goodStretch = 1.25;

    Index triangles = 0;
    Index stretched = 0;    ///< triangles with goodStretch or more
    Index mirrored = 0;     ///< or without area in the texture
    double stretch95 = 1.0; ///< 95 of 100 triangles are stretched less
    double worstStretch = 1.0;
    std::vector<TextureLevel> levels; ///< by ascending level
    /// The largest difference of a level's tiles per metre from the trunk's, as a share of the trunk's.
    double unevenness = 0.0;

    [[nodiscard]] double goodShare() const
    {
        return triangles > 0 ? 1.0 - double(stretched) / double(triangles) : 1.0;
    }
};

/// Returns the stretch of one triangle; infinite if it has no area in the texture, negative if it is
/// mirrored.
double textureStretch(const std::array<glm::vec3, 3>& place, const std::array<glm::vec2, 3>& uv);
/// \p coordinates must be those of \p mesh.
TextureReport textureReport(const BranchMesh& mesh, const TextureCoordinates& coordinates);

} // namespace ramure
