/// \file
/// Trees in the wind of a game: with the numbers that an export for it writes, moved by the formulas of its
/// engine (resources/shaders/wind.glsl).
#pragma once

#include "core/game_wind/wind_profile.h"
#include "core/skeleton/simplify.h"
#include "core/surface/foliage/foliage.h"
#include "widgets/view/render/crowd/mesh_copies.h"
#include <glm/vec2.hpp>
#include <memory>

namespace ramure {

struct TreeWind
{
    WindProfile profile = WindProfile::None; ///< None: it has no numbers for this game
    glm::vec2 direction{1.0F, 0.0F};         ///< unit, X and Z in the tree's space
    float base = 0.0F;                       ///< m: its foot
    float lean = 0.0F;                       ///< 1/m: of the trunk, by the square of the height
    float bendScale = 0.0F;                  ///< 1/m: of WindSettings
    WindTree tree;
    WindElements elements; ///< of PivotPainter
    std::vector<glm::vec4>
        texels; ///< two of each: where it turns (m), and its parent; its axis, and extent (m)
};
/// \param directionRad about +Y from +X. \param leaves, foliage null where there are none
TreeWind treeWind(WindProfile profile, double directionRad, const Skeleton& grown,
                  const SimplifiedSkeleton& simplified, const TriangleMesh* leaves, const Foliage* foliage);

/// The wind of one mesh.
struct ItemWind
{
    std::shared_ptr<const TreeWind> tree;
    std::vector<glm::vec3> places; ///< per vertex or copy: phase (0 to 1), sway (m), number of its element
    float flutter = 0.0F;          ///< of leaves: m for each m from where they hold on
};
/// \pre the mesh has a branch per vertex
ItemWind windOfMesh(const std::shared_ptr<const TreeWind>& tree, const TriangleMesh& mesh);
/// \param items what the copies were made of, those left out among them. \param shown as of leafCopies.
ItemWind windOfLeaves(const std::shared_ptr<const TreeWind>& tree, const MeshCopies& copies,
                      std::span<const FoliageItem> items, const std::vector<bool>& shown);
ItemWind windOfFruit(const std::shared_ptr<const TreeWind>& tree, const MeshCopies& copies);

} // namespace ramure
