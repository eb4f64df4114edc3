/// \file
/// A terrain: hills on a square grid, the same for the same seed everywhere.
///
/// Gradient noise (Perlin: Improving noise, 2002) in octaves: each has hills of half the width and
/// \c roughness times the height of the one before. The widest are half a side wide. The ground at the
/// middle is at height 0, so that something can stand there.
#pragma once

#include "core/base/error.h"
#include "core/params/arm_params.h"
#include "core/surface/mesh/triangle_mesh.h"

namespace ramure {

/// How high the ground is anywhere.
class TerrainHeights
{
public:
    /// Errors: those of checkPart.
    static Expected<TerrainHeights> of(const TerrainParams& params);
    TerrainHeights(TerrainHeights&&) noexcept;
    ~TerrainHeights();

    /// m, in the space of the terrain. \pre a place of the terrain: neither is over half a side
    [[nodiscard]] double at(double x, double z) const;
    [[nodiscard]] bool isOn(double x, double z) const;

private:
    class Octave;
    explicit TerrainHeights(const TerrainParams& params);
    [[nodiscard]] double sum(double x, double z) const;

    std::vector<Octave> m_octaves;
    double m_half = 0.0, m_middle = 0.0;
};

/// To look at, with normals and texture coordinates 0..1: a sheet, or a block of earth with sharp edges,
/// whose triangles are coloured: white above, soil on the sides. Errors: those of checkPart.
Expected<TriangleMesh> buildTerrain(const TerrainParams& params);
/// The same with every position once: a block is closed and manifold. For files and checks.
Expected<TriangleMesh> terrainSolid(const TerrainParams& params);

} // namespace ramure
