/// \file
/// The rigid pieces into which Pivot Painter 2 divides a tree: stems and leaves, each turning about its foot
/// on its parent. Each has a texel. Stems too deep for a texel move with the deepest ancestor that has one.
///
/// Limits are those of the material functions of Unreal Engine 4.27 to 5: chains of four pieces, 30,000
/// pieces (Epic Games, "Pivot Painter Tool 2.0", dev.epicgames.com).
#pragma once

#include "core/game_wind/wind_tree.h"

namespace ramure {

inline constexpr Index mostElements = 30'000, mostElementDepth = 4;
/// m: the least extent that the engine decodes from a texel of 8 bits.
inline constexpr double leastExtent = 0.08;

struct WindElement
{
    Index parent = 0; ///< stands before it; of a root itself
    Index depth = 0;  ///< 0: a root
    glm::dvec3 pivot{0.0};
    glm::dvec3 axis{0.0, 1.0, 0.0}; ///< unit: where it goes from there
    double extent = leastExtent;    ///< m, along the axis
};

struct WindElements
{
    std::vector<WindElement> elements; ///< at least one
    std::vector<Index> ofStem;         ///< per stem
    std::vector<Index> ofLeaf;         ///< per leaf; that of its stem where leavesGoAlong
    bool leavesGoAlong = false;        ///< they are too many for pieces of their own
};

/// The parameters of the foliage shader, which has four groups of them, one per depth.
struct PivotMotion
{
    double turns[mostElementDepth] = {0.01, 0.015, 0.02, 0.04}; ///< turn of a whole element at a gust of 1
    double gustOffset = 0.5;
    double falloff = 0.25;             ///< share of the extent; nearer to the pivot an element turns less
    double speed = 0.25, across = 0.1; ///< movement of the gust texture per second, along and across the wind
    double worldScale = 1024.0;        ///< cm: the texture comes again
    double shelterBias = -1.25, shelterScale = -0.444;
};
/// A leaf of any mesh: the place where it stands and its vertex that is farthest from there, m.
struct WindLeaf
{
    Index branch = noIndex;
    glm::dvec3 foot{0.0}, tip{0.0};
};
/// Cuts the tree into pieces. \param leaves those of all meshes. Error: Limit (more trunks than pieces).
Expected<WindElements> windElements(const WindTree& tree, std::span<const WindLeaf> leaves);
/// Measures the leaves of a mesh. See windOfItems() for what the mesh must hold.
std::vector<WindLeaf> windLeaves(const TriangleMesh& mesh, std::span<const FoliageItem> items);

/// Two textures of the same size, a texel for each element, row by row from the top: where it turns with the
/// number of its parent, and its axis with its extent. Lengths in cm; X as the tree's, Y its Z and Z its Y,
/// as the engine reads a GLB (GLTF::ConvertVec3 of its importer).
struct PivotTextures
{
    Index width = 1, height = 1;   ///< powers of two
    std::vector<glm::vec4> pivots; ///< rgb: cm; a: packedIndex() of the parent
    std::vector<glm::vec4> axes;   ///< rgb: 0.5 + half of it; a: extent / 2048 cm

    /// Returns the texel in which a vertex of the element looks up its data; rows count from the top.
    [[nodiscard]] glm::vec2 placeOf(Index element) const
    {
        const Index row = element / width;
        return {(float(element % width) + 0.5F) / float(width), (float(row) + 0.5F) / float(height)};
    }
};
PivotTextures pivotTextures(const WindElements& elements);
/// The float whose bits, as a half of 16 bits, are the index + 1024: what
/// ms_PivotPainter2_UnpackIntegerAsFloat decodes. Textures of halves hold it exactly. \pre index <=
/// mostElements
float packedIndex(Index index);

} // namespace ramure
