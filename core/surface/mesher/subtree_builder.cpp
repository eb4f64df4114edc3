#include "core/surface/mesher/subtree_builder.h"

#include "core/math/random.h"
#include "core/surface/mesher/trunk_foot.h"
#include <algorithm>
#include <utility>

namespace ramure {

namespace {

constexpr std::size_t pollEvery = 256; ///< branches
/// Of the squared scene: far above the share of the mesh's box that cleaning up goes by, the box is never ten
/// times as wide.
constexpr double smallAreaShare = 1e-11;

} // namespace

MesherProgress::MesherProgress(const Progress& progress, std::size_t branches)
    : m_progress(progress)
    , m_branches(branches)
    , m_home(std::this_thread::get_id())
{
}

bool MesherProgress::advance(std::size_t branches)
{
    const std::size_t done = m_done.fetch_add(branches, std::memory_order_relaxed) + branches;
    if (m_progress.cancelled())
        return false;
    if (std::this_thread::get_id() == m_home && done >= m_told + pollEvery) {
        m_told = done;
        m_progress.report(std::min(1.0, static_cast<double>(done) / static_cast<double>(m_branches)));
    }
    return true;
}

SubtreeBuilder::SubtreeBuilder(const NormalSkeleton& skeleton, const BranchMeshOptions& options,
                               const MeshDivisions& divisions, MeshSink& sink)
    : m_skeleton(skeleton)
    , m_sink(sink)
    , m_context{skeleton, options, divisions, sink}
    , m_tubes(m_context)
    , m_forks(m_context, m_tubes)
{
    const double small = 2.0 * smallAreaShare * skeleton.scene * skeleton.scene;
    m_smallSquared = small * small;
}

void SubtreeBuilder::beginTree(Index root, bool clampOvershoot)
{
    m_context.clampOvershoot = clampOvershoot;
    m_base = m_skeleton.branches[root].p0;
}

void SubtreeBuilder::buildRoot(Index root)
{
    const MeshBranch& branch = m_skeleton.branches[root];
    const BranchCurve curve = meshCurve(m_skeleton, root, m_context.clampOvershoot);
    const Frame frame = frameFromTangent(hermite(curve.h0, curve.h1, curve.v0, curve.v1, 0.0).tangent);
    m_axes.build(curve, branch, frame, m_context.divisions.sections(root), m_sections, nullptr);
    TubeAxis axis = branch.tubeAxis(curve);
    const AxisSection& first = m_sections.front();
    const std::span<const RingPoint> points = m_context.divisions.ring(root, first.radius);
    std::optional<GroundPlane> ground = m_context.options.ground;
    if (ground)
        ground = ground->from(m_skeleton.origin);
    const TrunkFoot foot(branch, m_context.options, static_cast<Index>(points.size()),
                         mixBits(m_context.options.seed) + root, ground);
    axis.foot = foot.size();
    m_sink.startTube(branch.source, noIndex, axis);
    if (foot.isThere()) {
        const Index top = m_tubes.startFoot(foot, first.frame, branch.foot);
        foot.cutOff(m_sections);
        m_tubes.finish(root, m_sections, 0, {top, foot.columns(), foot.turned()}, m_ends);
    } else {
        const Index ring = m_tubes.startRoot(first, points, branch.p0, branch.source);
        m_tubes.finish(root, m_sections, 0, {ring, points}, m_ends);
    }
    inspect();
}

/// A single child goes on from its parent's last ring; its own roll turns its frames against it.
void SubtreeBuilder::continueChild(const TubeEnd& parent)
{
    const Index child = m_skeleton.childrenOf(parent.branch).front();
    const MeshBranch& branch = m_skeleton.branches[child];
    const BranchCurve curve = meshCurve(m_skeleton, child, m_context.clampOvershoot);
    m_axes.build(curve, branch, parent.section.frame, m_context.divisions.sections(child), m_sections,
                 nullptr);
    const MeshBranch& below = m_skeleton.branches[parent.branch];
    m_sink.startTube(branch.source, below.isPlate ? noIndex : below.source, branch.tubeAxis(curve));
    const std::span<const RingPoint> points = m_context.divisions.ring(parent.branch, parent.section.radius);
    m_tubes.finish(child, m_sections, 0, {parent.ring, points, -branch.rollRad}, m_ends);
}

void SubtreeBuilder::grow(const TubeEnd& end)
{
    if (m_skeleton.branches[end.branch].childCount == 1)
        continueChild(end);
    else
        m_forks.build(end, m_ends);
    inspect();
}

TubeEnd SubtreeBuilder::takeEnd()
{
    const TubeEnd end = m_ends.back();
    m_ends.pop_back();
    return end;
}

bool SubtreeBuilder::growAll(const TubeEnd& end, MesherProgress& progress)
{
    const std::size_t below = m_ends.size();
    std::size_t sincePoll = 0;
    m_ends.push_back(end);
    while (m_ends.size() > below) {
        const TubeEnd next = takeEnd();
        grow(next);
        sincePoll += m_skeleton.branches[next.branch].childCount;
        if (sincePoll >= pollEvery && !progress.advance(std::exchange(sincePoll, 0)))
            return false;
    }
    return progress.advance(sincePoll);
}

bool SubtreeBuilder::growElsewhere(TubeEnd end, std::span<const glm::vec3> ring, MesherProgress& progress)
{
    end.ring = m_sink.nextVertex();
    std::copy(ring.begin(), ring.end(), m_sink.addVertices(ring.size(), noIndex));
    return growAll(end, progress);
}

/// Looks at what was added last while it is in the cache: its share of the signed volume, and triangles so
/// small that the clean-up should look at them again.
void SubtreeBuilder::inspect()
{
    const std::size_t end = m_sink.triangles.size();
    const glm::uvec3* const triangles = m_sink.triangles.data();
    const glm::vec3* const positions = m_sink.positions.data();
    const glm::dvec3 base = m_base;
    const double small = m_smallSquared;
    double volume = m_volume;
    for (std::size_t t = m_inspected; t < end; ++t) {
        const glm::dvec3 a(positions[triangles[t].x]);
        const glm::dvec3 normal =
            glm::cross(glm::dvec3(positions[triangles[t].y]) - a, glm::dvec3(positions[triangles[t].z]) - a);
        volume += glm::dot(a - base, normal);
        if (!(glm::dot(normal, normal) > small))
            m_small.push_back(static_cast<Index>(t));
    }
    m_volume = volume;
    m_inspected = end;
}

double SubtreeBuilder::takeVolume()
{
    return std::exchange(m_volume, 0.0);
}

SinkMark SubtreeBuilder::mark() const
{
    return {m_sink.positions.size(), m_sink.triangles.size(), m_sink.tubes.size(), m_sink.forkVertices.size(),
            m_small.size()};
}

void SubtreeBuilder::rollBack(const SinkMark& mark)
{
    m_sink.positions.resize(mark.vertices);
    m_sink.owner.resize(mark.vertices);
    m_sink.triangles.resize(mark.triangles);
    m_sink.tubes.resize(mark.tubes);
    m_sink.axes.resize(mark.tubes);
    m_sink.forkVertices.resize(mark.forkVertices);
    m_small.resize(mark.small);
    m_inspected = mark.triangles;
}

void SubtreeBuilder::turnOver(std::size_t from, std::size_t to)
{
    for (std::size_t t = from; t < to; ++t)
        std::swap(m_sink.triangles[t].y, m_sink.triangles[t].z);
}

} // namespace ramure
