/// \file
/// Marks in the bark of a closed mesh: the roll around a scar, a hollow, a burr. The surface is made finer
/// there and moved along one direction, so that it stays one closed surface which does not cross itself.
#pragma once

#include "core/surface/mesh/triangle_mesh.h"
#include <span>

namespace ramure {

struct Relief
{
    enum class Form : std::uint8_t { Scar, Hollow, Burr };

    Form form = Form::Scar;
    Index branch = noIndex; ///< of the vertices in whose surface it lies
    glm::vec3 from{0.0F},
        out{0.0F, 1.0F, 0.0F}; ///< a place within the wood, and the way to its surface, unit
    float radius = 0.0F;       ///< m
    float healed = 0.0F;       ///< of a scar, in its radii: wood that has grown since; at 1 it is closed
};

/// The reach of a relief, of its radius: nothing beyond moves.
inline constexpr float reliefReach = 1.7F;

/// What a relief may do to a vertex of the mesh.
enum class ReliefHold : std::uint8_t {
    None,
    Place,    ///< it must not move
    Triangles ///< nor may its triangles change
};

/// Draws what finds its place. There is none where the surface bends away within the reach, where a vertex
/// that is held lies in it, or where an earlier one lies. Relief that is no number or wider than the wood is
/// left out. New vertices follow the branches of the edges on which they were made; normals are left alone.
/// \param mesh closed, with branches; without colours, levels and texture coordinates
/// \param held by vertex
/// \return by old triangle, and one more: the first of the triangles that have taken its place, in the order
/// of the old ones; empty: nothing was drawn
std::vector<Index> drawReliefs(TriangleMesh& mesh, std::span<const Relief> reliefs,
                               const std::vector<ReliefHold>& held);

} // namespace ramure
