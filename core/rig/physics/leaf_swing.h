/// \file
/// Leaves of plants that swing on their petioles: in the wind, in the air that their twigs are carried
/// through, under their own weight as the twigs turn, and fluttering.
///
/// There is no state: how a leaf hangs is a function of the tree's state and the time, so that any seek gives
/// what playing gives. A leaf is light and its drag great; it answers the waves of the wind as a damped
/// spring does that they have driven for long (core/rig/physics/wind.h), and all else at once. In still air,
/// on a twig at rest, it stands as it was placed.
#pragma once

#include "core/rig/physics/physics_state.h"
#include "core/rig/physics/wind.h"
#include "core/rig/pose/skin.h"
#include <array>

namespace ramure {

/// The swing of each leaf: tan(angle / 2) times the axis about which it swings, in tree space at rest.
struct LeafBends
{
    std::vector<float> x, y, z;
    void resize(std::size_t leaves);
    /// Goes the share \p weight (0..1) of the way to \p other, of as many leaves.
    void blend(const LeafBends& other, float weight);
};

class LeafSwing
{
public:
    /// \param foliage leaves of a plant, those of a branch in a row. \param alpha TurtleParams::alpha.
    /// \param anchors what each leaf hangs on (bindFoliage).
    LeafSwing(const Skeleton& skeleton, const Foliage& foliage, double alpha, BarkAnchors anchors);

    [[nodiscard]] std::size_t size() const { return m_give.size(); }
    [[nodiscard]] double reach() const { return m_reach; } ///< m, of the longest leaf from its foot
    /// \param params in force at the state. \param leaf its stiffness and flutter.
    void swing(const TreeBody& body, const PhysicsState& state, const PhysicsParams& params,
               const LeafParams& leaf, LeafBends& out);
    /// A bone for each leaf: it goes where its foot goes, which stays on the bark, and turns about it.
    /// \param branches the pose. \param bends of swing(). \param out one per leaf.
    void pose(std::span<const RigidTransform> branches, SkinMethod method, const LeafBends& bends,
              std::span<RigidTransform> out);

private:
    using FeltTwig = std::array<float, 11>;
    void addTwig(const Skeleton& skeleton, Index branch);
    void addLeaf(const FoliageItem& leaf, std::uint64_t branchKey);
    void carry(std::span<const RigidTransform> branches, SkinMethod method);
    [[nodiscard]] std::vector<FeltTwig> feltAt(const TreeBody& body, const PhysicsState& state,
                                               const PhysicsParams& params, const LeafParams& leaf);

    BarkAnchors m_anchors;
    Deformer m_deformer;
    std::vector<glm::vec3> m_corners; ///< current corners of the anchors
    double m_reach = 0.0;
    double m_hertz = 1.0; ///< at which leaves swing by themselves, at stiffness 1
    double m_drag = 1.0;  ///< by the area of a leaf
    double m_loose = 1.0; ///< by the length of its petiole
    // By branch with leaves.
    std::vector<Index> m_branches;
    std::vector<std::size_t> m_ends;    ///< one past its last leaf
    std::vector<std::uint32_t> m_notes; ///< at which they flutter
    // By leaf. Directions at rest: of the petiole, and of the upper side.
    std::vector<float> m_alongX, m_alongY, m_alongZ, m_upperX, m_upperY, m_upperZ;
    std::vector<float> m_give;       ///< how far a load turns it, about 1
    std::vector<float> m_sin, m_cos; ///< phase of its flutter
    std::vector<glm::dvec3> m_foot;
    TreeBody m_places; ///< the twigs as the wind sees them: places alone
    WindField m_wind;
};

} // namespace ramure
