/// \file
/// Where the mesh of a whole life is at an age. Internal to growth_mesh.cpp.
#pragma once

#include "core/generators/growth/whole_life.h"
#include "core/lod/level_twigs.h"
#include "core/rig/pose/skin.h"
#include <glm/gtc/quaternion.hpp>

namespace ramure {

class LifePose
{
public:
    /// Where a branch of the pruned tree ends.
    struct End
    {
        glm::dvec3 at{0.0};
        Index reach = 0; ///< how much of it stands: 0 nothing, then the last metamer and 1
    };
    /// What takes a branch from the mesh to an age: along it and across it, each by its own scale.
    struct Branch
    {
        glm::dvec3 from{0.0}, foot{0.0};        ///< where it starts in the mesh, and at the age
        glm::dvec3 along{0.0, 1.0, 0.0};        ///< unit, in the mesh
        glm::dquat turn{1.0, 0.0, 0.0, 0.0};    ///< to its direction at the age
        double restLength = 0.0, length = 0.0;  ///< m; negative: folded back
        double restCover = 0.0, cover = 0.0;    ///< m, its first part, which belongs to the fork below
        double restCrotch = 0.0, crotch = 0.0;  ///< m, its last part, which belongs to the fork above
        double footScale = 1.0, endScale = 1.0; ///< of radii
        Index reach = 0;                        ///< see End
        bool isWhole = false;                   ///< its last metamer stands

        [[nodiscard]] glm::dvec3 point(const glm::dvec3& rest) const;
        [[nodiscard]] glm::dvec3 end() const { return foot + turn * along * length; }
    };
    struct Placed
    {
        std::vector<Branch> branches;

        [[nodiscard]] std::vector<End> ends() const;
        /// \param skin of the mesh to the branches of the pruned tree. \pre as many places as points
        void move(std::span<const glm::vec3> points, const Skin& skin, std::span<glm::vec3> places) const;
    };

    /// All are kept by reference. \param wood of life.skeleton, of which the mesh was made
    LifePose(const GrowthHistory& history, const WholeLife& life, const PrunedTree& wood);
    [[nodiscard]] Placed at(double age) const;

private:
    void place(Index branch, const WoodAtAge& wood, Placed& placed) const;
    void hide(Index branch, const Branch* below, Branch& now) const;
    [[nodiscard]] double scaleOf(Index metamer, const WoodAtAge& wood) const;
    [[nodiscard]] Index lastAlive(Index branch, const WoodAtAge& wood) const;

    const GrowthHistory& m_history;
    const WholeLife& m_life;
    const PrunedTree& m_wood;
    std::vector<Index> m_end;   ///< by branch: metamer
    std::vector<Index> m_first; ///< by branch: the first metamer of its own
    std::vector<bool> m_goesOn; ///< by branch: its parent is of the same axis
    std::vector<Branch> m_rest;
};

} // namespace ramure
