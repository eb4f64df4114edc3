/// \file
/// Trees at a time: what the pipeline makes of them, moved by their physics. For files and pictures; the
/// editor plays with core/session/player.h.
#pragma once

#include "core/evaluate/tree_run.h"
#include "core/session/exporter.h"
#include "core/session/moving_arms.h"
#include <map>

namespace ramure {

/// Keeps one run per tree, so that the frames of a sequence cost one run together. Not thread-safe.
class MovingSource
{
public:
    /// \param rest gives the trees at rest; it must outlive this object's sources.
    /// \param timeline says whether, and where, the end of a loop blends into its beginning.
    explicit MovingSource(TreeSource rest, const TimelineSettings& timeline = {});
    MovingSource(const MovingSource&) = delete;
    MovingSource& operator=(const MovingSource&) = delete;

    /// A source of the trees at \p timeSeconds (the step round(T / stepSeconds), SPEC A7): skeletons,
    /// sections, meshes and foliage are all in their place of then, skinned as skin.method says; the report
    /// is of the moved mesh, restBranches the mesh at rest. Times up to 0 give the trees at rest. Valid as
    /// long as this object. Errors: those of the rest; Invalid for a time that is no number or beyond
    /// maxPhysicsSteps; Cancelled.
    [[nodiscard]] TreeSource at(double timeSeconds);
    /// The arms beside the trees, for ExportOptions::arms.
    [[nodiscard]] MovingArms& arms() { return m_arms; }

private:
    /// \p node with its parameters of the time; \p physics without.
    Expected<TreeResult> moved(const Node& node, const PhysicsParams& physics, Stage last, double timeSeconds,
                               const Progress& progress);

    TreeSource m_rest;
    TimelineSettings m_timeline;
    std::map<NodeId, TreeRun> m_runs;
    MovingArms m_arms;
};

} // namespace ramure
