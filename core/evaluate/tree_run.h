/// \file
/// One tree's motion: its physics as a run that can be entered anywhere, and the skins that follow it. For
/// the player and for files alike.
#pragma once

#include "core/evaluate/node_motion.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/rig/physics/fruit_swing.h"
#include "core/rig/physics/leaf_swing.h"
#include "core/rig/physics/physics_cache.h"
#include <optional>

namespace ramure {

class TreeRun final : public NodeRun
{
public:
    /// Takes the tree at rest, up to its foliage, and its parameters. Returns true if it is another tree than
    /// before; its run begins anew with the physics of \p params. Errors: those of bindBranches and
    /// bindFoliage.
    Expected<bool> setTree(const TreeResult& rest, const NodeParams& params);
    /// Sets the parameters of the physics, with the tracks that change them, up to a time. If \p live, other
    /// values act from the present step on and the past stays; otherwise the whole run is made with them.
    /// Returns true if it is another run than before. \pre setTree() gave a tree; this holds for the next
    /// function too.
    bool setPhysics(const PhysicsParams& params, const NodeAnimation& animation, double seconds,
                    bool live = false);
    Expected<NodeMotion> motionAt(double seconds, const TimelineSettings& timeline,
                                  const Progress& progress) override;

    /// Limits the memory of the states that the run keeps. A run without a tree keeps none.
    void setMemoryLimit(std::size_t bytes)
    {
        if (m_cache)
            m_cache->setMemoryLimit(bytes);
    }
    [[nodiscard]] std::size_t bytes() const { return m_cache ? m_cache->bytes() : 0; }
    [[nodiscard]] PhysicsCache& cache() { return *m_cache; }
    [[nodiscard]] const PhysicsCache& cache() const { return *m_cache; }
    [[nodiscard]] const PhysicsParams& params() const { return m_params; }
    /// The number that the physics has for a fruit of the tree: it knows all that were placed, so that a day
    /// is no other run. noIndex: it has none.
    [[nodiscard]] Index fruitOfPhysics(Index apple) const;
    /// Returns true if parameters changed within the run.
    [[nodiscard]] bool isMixed() const { return m_mixed; }

private:
    bool setBody(const TreeResult& rest, const NodeParams& params);
    Expected<void> setSkins(const TreeResult& rest, SkinMethod method);
    Expected<void> setLeaves(const TreeResult& rest, bool smooth);
    /// How a tree stands at a step.
    struct Stand
    {
        Pose pose;
        LeafBends bends;
        std::vector<glm::dvec3> fruit; ///< how fast each is carried
    };
    [[nodiscard]] std::vector<RigidTransform> bones(); ///< the tree's present pose
    Expected<void> seek(std::int64_t step, Stand& stand, const Progress& progress);
    void setTrackedPhysics(const PhysicsParams& params, const NodeAnimation& animation, double seconds);

    std::shared_ptr<const SimplifiedSkeleton> m_skeleton;
    std::shared_ptr<const Foliage> m_weighed, m_foliage; ///< as it was placed, and on the day
    double m_alpha = 0.0;
    std::unique_ptr<PhysicsCache> m_cache;
    PhysicsParams m_params;
    NodeAnimation m_animation;    ///< tracks of the parameters, if the physics has any
    std::int64_t m_scripted = -1; ///< steps that have been told theirs
    bool m_mixed = false;
    NodeMotion m_motion; ///< meshes and skins; the rest is of the moment asked for last
    bool m_smooth = false;
    LeafParams m_leaf;
    std::shared_ptr<const Foliage> m_leavesOf, m_swingOf;
    std::optional<LeafSwing> m_swing; ///< of all leaves that were placed; only for trees with plant leaves
    std::vector<Index> m_hanging;     ///< which of them hang on the day
    std::vector<RigidTransform> m_leafBones;
    FruitSwing m_fruit;
    Stand m_now, m_earlier;
};

/// Returns the tree as it stands in a motion: skeletons, sections, meshes and foliage are moved, and the
/// report is that of the moved mesh. \pre \p tree is at rest, and the motion is its own. Errors: Cancelled.
Expected<TreeResult> movedTree(TreeResult tree, const NodeMotion& motion, const Progress& progress);

} // namespace ramure
