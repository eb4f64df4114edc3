#include "core/surface/mesher/branch_mesher.h"

#include "core/base/large_buffer.h"
#include "core/base/parallel.h"
#include "core/surface/mesher/mesh_pieces.h"
#include <algorithm>
#include <atomic>
#include <optional>

namespace ramure {

namespace {

constexpr double thinnest = 1e-4; ///< of the scene: no radius is halved to less
constexpr int slimmings = 10; ///< at most so often are the radii of a tree halved that came out inside out
/// Triangles of a task, about: enough that handing it out costs nothing, few enough that all threads get
/// some.
constexpr double mostInTask = 16384.0, leastInTask = 256.0;

} // namespace

/// What one thread needs; where it puts its tasks one after the other.
struct BranchMesher::Worker
{
    MeshSink sink;
    SubtreeBuilder builder;

    Worker(const NormalSkeleton& skeleton, const BranchMeshOptions& options, const MeshDivisions& divisions)
        : builder(skeleton, options, divisions, sink)
    {
    }
};

BranchMesher::BranchMesher(NormalSkeleton& skeleton, const BranchMeshOptions& options,
                           const MeshDivisions& divisions)
    : m_skeleton(skeleton)
    , m_options(options)
    , m_divisions(divisions)
    , m_alone(parallelThreads() == 1)
    , m_trunk(skeleton, options, divisions, m_trunkSink)
{
    reserve(weigh());
}

BranchMesher::~BranchMesher() = default;

/// Triangles of the whole mesh, about.
double BranchMesher::weigh()
{
    const std::vector<MeshBranch>& branches = m_skeleton.branches;
    m_weight.assign(branches.size(), 0.0);
    double whole = 0.0;
    for (std::size_t b = branches.size(); b-- > 0;) {
        const auto branch = static_cast<Index>(b);
        const double own = 2.0 * m_divisions.sections(branch) *
                           static_cast<double>(m_divisions.ring(branch, branches[b].a0).size());
        whole += own;
        if (branches[b].parent != noIndex)
            m_weight[branches[b].parent] += m_weight[b] + own;
    }
    return whole;
}

/// What is built alone goes straight into the arrays of the result.
void BranchMesher::reserve(double triangles)
{
    if (!m_alone)
        return;
    const auto count = static_cast<std::size_t>(triangles);
    reserveHuge(m_trunkSink.positions, count / 2);
    reserveHuge(m_trunkSink.owner, count / 2);
    reserveHuge(m_trunkSink.triangles, count);
}

Index BranchMesher::treeAfter(Index root) const
{
    const auto end = static_cast<Index>(m_skeleton.branches.size());
    do
        ++root;
    while (root < end && m_skeleton.branches[root].parent != noIndex);
    return root;
}

/// Halves the radii of a whole tree: branches much thicker than long can turn their tubes inside out.
void BranchMesher::slimDown(Index root)
{
    for (Index branch = root, after = treeAfter(root); branch < after; ++branch)
        for (double* radius : {&m_skeleton.branches[branch].a0, &m_skeleton.branches[branch].a1})
            *radius = std::max(0.5 * *radius, std::min(*radius, thinnest * m_skeleton.scene));
}

std::unique_ptr<BranchMesher::Worker> BranchMesher::borrow()
{
    const std::scoped_lock lock(m_mutex);
    if (m_idle.empty())
        return std::make_unique<Worker>(m_skeleton, m_options, m_divisions);
    std::unique_ptr<Worker> worker = std::move(m_idle.back());
    m_idle.pop_back();
    return worker;
}

bool BranchMesher::fill(MeshTask& task, SubtreeBuilder& builder, MesherProgress& progress)
{
    task.sink = &builder.sink();
    task.from = builder.mark();
    bool going = true;
    if (task.end.branch == noIndex) {
        for (Index root = task.root; going && root < task.after; root = treeAfter(root))
            going = buildSmallTree(builder, root, task.repairs, progress);
    } else {
        builder.beginTree(task.root, task.clampOvershoot);
        const glm::vec3* ring = m_trunkSink.positions.data() + task.end.ring;
        going = m_alone ? builder.growAll(task.end, progress)
                        : builder.growElsewhere(task.end, {ring, task.end.ringCount}, progress);
        task.volume = builder.takeVolume();
    }
    task.to = builder.mark();
    if (m_alone)
        return going;
    const std::vector<Index>& small = builder.smallTriangles();
    task.small.assign(small.begin() + static_cast<std::ptrdiff_t>(task.from.small), small.end());
    return going;
}

bool BranchMesher::runTask(MeshTask& task, MesherProgress& progress)
{
    if (progress.cancelled())
        return false;
    std::unique_ptr<Worker> worker = borrow();
    const bool going = fill(task, worker->builder, progress);
    const std::scoped_lock lock(m_mutex);
    m_idle.push_back(std::move(worker));
    return going;
}

bool BranchMesher::runTasks(MesherProgress& progress)
{
    std::atomic<bool> going = true;
    parallelFor(m_tasks.size() - m_done, 1, [&](std::size_t from, std::size_t to) {
        for (std::size_t task = m_done + from; task < m_done + to; ++task)
            if (!runTask(m_tasks[task], progress))
                going = false;
    });
    for (; m_done < m_tasks.size(); ++m_done) {
        const MeshTask& task = m_tasks[m_done];
        m_taskVolume += task.volume;
        m_skeleton.repairs.insert(m_skeleton.repairs.end(), task.repairs.begin(), task.repairs.end());
    }
    return going;
}

/// Tasks wait for other threads, or are done at once where there are none.
bool BranchMesher::putOff(MeshTask task, MesherProgress& progress)
{
    task.trunk = m_trunk.mark();
    m_trunkVolume += m_trunk.takeVolume();
    if (!m_alone) {
        m_tasks.push_back(std::move(task));
        return true;
    }
    const bool going = fill(task, m_trunk, progress);
    m_taskVolume += task.volume;
    m_skeleton.repairs.insert(m_skeleton.repairs.end(), task.repairs.begin(), task.repairs.end());
    return going;
}

template <class Build, class Undo, class TurnOver>
bool BranchMesher::buildTree(Index root, std::vector<RepairNote>& repairs, const Build& build,
                             const Undo& undo, const TurnOver& turnOver)
{
    bool clampOvershoot = m_options.clampOvershoot;
    for (int attempt = 0;; ++attempt) {
        const std::optional<double> volume = build(clampOvershoot);
        if (!volume)
            return false;
        if (*volume > 0.0)
            return true;
        if (attempt == slimmings) {
            turnOver();
            return true;
        }
        if (attempt == 0)
            repairs.push_back({SkeletonRepair::RadiusClamped, m_skeleton.branches[root].source, noIndex});
        // Overshooting curves are tamed first; thick tubes that still turn inside out are made thinner.
        if (clampOvershoot)
            slimDown(root);
        clampOvershoot = true;
        undo();
    }
}

bool BranchMesher::buildSmallTree(SubtreeBuilder& builder, Index root, std::vector<RepairNote>& repairs,
                                  MesherProgress& progress)
{
    const SinkMark before = builder.mark();
    const auto build = [&](bool clampOvershoot) -> std::optional<double> {
        builder.beginTree(root, clampOvershoot);
        builder.buildRoot(root);
        if (builder.hasEnd() && !builder.growAll(builder.takeEnd(), progress))
            return std::nullopt;
        return builder.takeVolume();
    };
    return buildTree(
        root, repairs, build, [&] { builder.rollBack(before); },
        [&] { builder.turnOver(before.triangles, builder.mark().triangles); });
}

/// The thick part of a tree; what is left to grow on it is put off.
bool BranchMesher::buildTrunk(Index root, bool clampOvershoot, MesherProgress& progress)
{
    m_trunk.beginTree(root, clampOvershoot);
    m_trunk.buildRoot(root);
    while (m_trunk.hasEnd()) {
        const TubeEnd end = m_trunk.takeEnd();
        bool going = true;
        if (const double weight = m_weight[end.branch]; weight <= mostInTask && weight >= leastInTask) {
            MeshTask task;
            task.end = end;
            task.root = root;
            task.clampOvershoot = clampOvershoot;
            going = putOff(std::move(task), progress);
        } else {
            m_trunk.grow(end);
            going = progress.advance(m_skeleton.branches[end.branch].childCount);
        }
        if (!going)
            return false;
    }
    m_trunkVolume += m_trunk.takeVolume();
    return m_alone || runTasks(progress);
}

bool BranchMesher::buildBigTree(Index root, MesherProgress& progress)
{
    const SinkMark before = m_trunk.mark();
    const std::size_t firstTask = m_tasks.size();
    const auto build = [&](bool clampOvershoot) -> std::optional<double> {
        m_trunkVolume = m_taskVolume = 0.0;
        if (!buildTrunk(root, clampOvershoot, progress))
            return std::nullopt;
        return m_trunkVolume + m_taskVolume;
    };
    const auto undo = [&] {
        m_trunk.rollBack(before);
        m_tasks.resize(firstTask);
        m_done = firstTask;
    };
    const auto turnOver = [&] {
        m_trunk.turnOver(before.triangles, m_trunk.mark().triangles);
        for (std::size_t task = firstTask; task < m_tasks.size(); ++task) {
            std::vector<glm::uvec3>& triangles = m_tasks[task].sink->triangles;
            for (std::size_t t = m_tasks[task].from.triangles; t < m_tasks[task].to.triangles; ++t)
                std::swap(triangles[t].y, triangles[t].z);
        }
    };
    return buildTree(root, m_skeleton.repairs, build, undo, turnOver);
}

Expected<void> BranchMesher::run(const Progress& progress)
{
    const auto end = static_cast<Index>(m_skeleton.branches.size());
    MesherProgress told(progress, end);
    progress.report(0.0);
    bool going = !progress.cancelled();
    for (Index root = 0, after = 0; going && root < end; root = after) {
        after = treeAfter(root);
        if (m_weight[root] > mostInTask) {
            going = buildBigTree(root, told);
            continue;
        }
        MeshTask trees; // small ones, one after the other
        trees.root = root;
        double weight = m_weight[root] + leastInTask;
        while (after < end && weight + m_weight[after] < mostInTask) {
            weight += m_weight[after] + leastInTask;
            after = treeAfter(after);
        }
        trees.after = after;
        going = putOff(std::move(trees), told);
    }
    going = going && (m_alone || runTasks(told));
    if (!going)
        return fail(ErrorCode::Cancelled, RAMURE_NOOP("Cancelled"));
    progress.report(1.0); // however little of it fell to this thread
    return {};
}

std::vector<Index> BranchMesher::assemble(BranchMesh& mesh)
{
    if (!m_alone)
        return assemblePieces(m_trunkSink, m_trunk.smallTriangles(), m_tasks, mesh);
    mesh.mesh.positions = std::move(m_trunkSink.positions);
    mesh.mesh.triangles = std::move(m_trunkSink.triangles);
    mesh.mesh.branch = std::move(m_trunkSink.owner);
    mesh.tubes = std::move(m_trunkSink.tubes);
    mesh.axes = std::move(m_trunkSink.axes);
    mesh.forkVertices = std::move(m_trunkSink.forkVertices);
    return m_trunk.smallTriangles();
}

} // namespace ramure
