/// \file
/// Shares the trees of a skeleton out among threads. What is built, and in which order, depends on the
/// skeleton alone: the same bytes come out on one thread and on many.
#pragma once

#include "core/surface/mesher/mesh_sink.h"
#include "core/surface/mesher/subtree_builder.h"
#include <memory>
#include <mutex>

namespace ramure {

/// A part of the work for one thread: all that grows on an end, or some whole trees.
struct MeshTask
{
    TubeEnd end;     ///< its ring is in the trunk's sink; no branch: whole trees
    Index root = 0;  ///< of the tree it belongs to, or the first tree
    Index after = 0; ///< of whole trees: the root after the last
    bool clampOvershoot = false;
    SinkMark trunk;           ///< what the trunk held when this was put off: it comes right after
    MeshSink* sink = nullptr; ///< where it has been built,
    SinkMark from, to;        ///< and in which range; copies of the end's ring come first
    std::vector<Index> small; ///< its triangles that may be too small, in that sink
    double volume = 0.0;      ///< six times the signed one
    std::vector<RepairNote> repairs;
};

class BranchMesher
{
public:
    BranchMesher(NormalSkeleton& skeleton, const BranchMeshOptions& options, const MeshDivisions& divisions);
    ~BranchMesher();
    BranchMesher(const BranchMesher&) = delete;
    BranchMesher& operator=(const BranchMesher&) = delete;

    /// Builds all trees. Errors: Cancelled.
    Expected<void> run(const Progress& progress);
    /// Moves what was built into \p mesh, in its final order; positions are relative to the skeleton's
    /// origin. Returns the triangles that may be too small; all others are well above the limit.
    std::vector<Index> assemble(BranchMesh& mesh);

private:
    struct Worker;
    double weigh();
    void reserve(double triangles);
    [[nodiscard]] Index treeAfter(Index root) const;
    /// Builds a tree, again with tamer curves and thinner branches where it came out inside out.
    template <class Build, class Undo, class TurnOver>
    bool buildTree(Index root, std::vector<RepairNote>& repairs, const Build& build, const Undo& undo,
                   const TurnOver& turnOver);
    bool buildBigTree(Index root, MesherProgress& progress);
    bool buildSmallTree(SubtreeBuilder& builder, Index root, std::vector<RepairNote>& repairs,
                        MesherProgress& progress);
    bool buildTrunk(Index root, bool clampOvershoot, MesherProgress& progress);
    bool putOff(MeshTask task, MesherProgress& progress);
    bool runTasks(MesherProgress& progress);
    bool runTask(MeshTask& task, MesherProgress& progress);
    bool fill(MeshTask& task, SubtreeBuilder& builder, MesherProgress& progress);
    void slimDown(Index root);
    std::unique_ptr<Worker> borrow();

    NormalSkeleton& m_skeleton;
    const BranchMeshOptions& m_options;
    const MeshDivisions& m_divisions;
    const bool m_alone; ///< one thread: everything goes straight into the trunk's sink
    MeshSink m_trunkSink;
    SubtreeBuilder m_trunk;
    std::vector<double> m_weight; ///< triangles of all that grows on a branch, about
    std::vector<MeshTask> m_tasks;
    std::size_t m_done = 0;                         ///< tasks
    double m_trunkVolume = 0.0, m_taskVolume = 0.0; ///< six times that of the tree at hand
    std::mutex m_mutex;                             ///< of the workers
    std::vector<std::unique_ptr<Worker>> m_idle;
};

} // namespace ramure
