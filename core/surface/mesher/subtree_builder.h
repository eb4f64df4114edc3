/// \file
/// Builds tube after tube into a sink: a whole tree, or all that grows on the end of one tube.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/surface/mesher/fork_builder.h"
#include "core/surface/mesher/tube_builder.h"
#include <atomic>
#include <thread>

namespace ramure {

/// How much is in a sink.
struct SinkMark
{
    std::size_t vertices = 0, triangles = 0, tubes = 0, forkVertices = 0, small = 0;
};

/// How far a mesh is, told by several threads; only the one that made it reports, and only upwards.
class MesherProgress
{
public:
    MesherProgress(const Progress& progress, std::size_t branches);
    /// So many branches more are done. False: stop.
    bool advance(std::size_t branches);
    [[nodiscard]] bool cancelled() const { return m_progress.cancelled(); }

private:
    const Progress& m_progress;
    const std::size_t m_branches;
    const std::thread::id m_home;
    std::atomic<std::size_t> m_done = 0;
    std::size_t m_told = 0; ///< by the thread at home
};

/// Depth first with its own stack, so that a skeleton may be as deep as it likes. One per thread.
class SubtreeBuilder
{
public:
    SubtreeBuilder(const NormalSkeleton& skeleton, const BranchMeshOptions& options,
                   const MeshDivisions& divisions, MeshSink& sink);
    SubtreeBuilder(const SubtreeBuilder&) = delete;
    SubtreeBuilder& operator=(const SubtreeBuilder&) = delete;

    /// What follows belongs to this tree.
    void beginTree(Index root, bool clampOvershoot);
    void buildRoot(Index root);
    /// The tubes of all children of the branch that ends here; their ends go on the stack.
    void grow(const TubeEnd& end);
    /// The end to go on from, if there is one; it leaves the stack.
    [[nodiscard]] bool hasEnd(std::size_t above = 0) const { return m_ends.size() > above; }
    TubeEnd takeEnd();
    /// All that grows on an end. False: stopped.
    bool growAll(const TubeEnd& end, MesherProgress& progress);
    /// The same where the end's ring is in another sink, at these places: copies of its points come first.
    bool growElsewhere(TubeEnd end, std::span<const glm::vec3> ring, MesherProgress& progress);

    [[nodiscard]] SinkMark mark() const;
    /// Forgets everything after a mark.
    void rollBack(const SinkMark& mark);
    /// Six times the signed volume under the triangles since the last call.
    double takeVolume();
    /// Turns the triangles of a range inside out.
    void turnOver(std::size_t from, std::size_t to);
    [[nodiscard]] MeshSink& sink() { return m_sink; }
    /// Triangles that may be too small; all others are well above the limit.
    [[nodiscard]] const std::vector<Index>& smallTriangles() const { return m_small; }

private:
    void continueChild(const TubeEnd& parent);
    void inspect();

    const NormalSkeleton& m_skeleton;
    MeshSink& m_sink;
    MesherContext m_context;
    TubeBuilder m_tubes;
    ForkBuilder m_forks;
    AxisBuilder m_axes;
    std::vector<TubeEnd> m_ends; ///< a stack: the last is next
    std::vector<AxisSection> m_sections;
    std::size_t m_inspected = 0; ///< triangles
    double m_volume = 0.0;
    double m_smallSquared = 0.0; ///< of a triangle's doubled area
    glm::dvec3 m_base{0.0};
    std::vector<Index> m_small;
};

} // namespace ramure
