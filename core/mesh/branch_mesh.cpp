#include "core/mesh/branch_mesh.h"

#include "core/base/large_buffer.h"
#include "core/mesh/fork_builder.h"
#include "core/mesh/mesh_cleanup.h"
#include "core/mesh/normals.h"
#include <algorithm>
#include <cmath>
#include <string>

namespace ramure {

namespace {

constexpr std::size_t pollEvery = 256; ///< branches
/// Of the squared scene: far above the share of the mesh's box that cleaning up goes by, the box is never ten
/// times as wide.
constexpr double smallAreaShare = 1e-11;
constexpr double thinnest = 1e-4; ///< of the scene: no radius is halved to less
constexpr int slimmings = 10; ///< at most so often are the radii of a tree halved that came out inside out

/// Builds tube after tube. Depth first with its own stack, so that a skeleton may be as deep as it likes.
class BranchMesher
{
public:
    BranchMesher(MesherContext& context, NormalSkeleton& skeleton)
        : m_context(context)
        , m_skeleton(skeleton)
        , m_tubes(context)
        , m_forks(context, m_tubes)
    {
    }
    Expected<void> run(const Progress& progress);
    /// Triangles that may be too small; all others are well above the limit.
    [[nodiscard]] const std::vector<Index>& smallTriangles() const { return m_small; }

private:
    Expected<void> buildTree(Index root, const Progress& progress);
    void inspect();
    void slimDown(Index root);
    void turnOver(std::size_t firstTriangle);
    void buildRoot(Index root);
    void continueChild(const TubeEnd& parent);

    MesherContext& m_context;
    NormalSkeleton& m_skeleton;              ///< that of the context
    std::size_t m_done = 0, m_sincePoll = 0; ///< branches
    TubeBuilder m_tubes;
    ForkBuilder m_forks;
    AxisBuilder m_axes;
    std::vector<TubeEnd> m_ends; ///< a stack: the last is next
    std::vector<AxisSection> m_sections;
    Index m_inspected = 0;       ///< triangles
    double m_volume = 0.0;       ///< six times the signed volume of the tree at hand
    double m_smallSquared = 0.0; ///< of a triangle's doubled area
    glm::dvec3 m_base{0.0};
    std::vector<Index> m_small;
};

void BranchMesher::buildRoot(Index root)
{
    const MeshBranch& branch = m_skeleton.branches[root];
    const BranchCurve curve = meshCurve(m_skeleton, root, m_context.clampOvershoot);
    const Frame frame = frameFromTangent(hermite(curve.h0, curve.h1, curve.v0, curve.v1, 0.0).tangent);
    m_axes.build(curve, branch, frame, m_context.options.lengthDivisions, m_sections, nullptr);
    m_context.sink.startTube(branch.source, noIndex, {curve, branch.a0, branch.a1});
    const Index ring = m_tubes.startRoot(m_sections.front(), branch.p0, branch.source);
    m_tubes.finish(root, m_sections, 0, ring, 0.0, m_ends);
}

/// A single child goes on from its parent's last ring; its own roll turns its frames against it.
void BranchMesher::continueChild(const TubeEnd& parent)
{
    const Index child = m_skeleton.childrenOf(parent.branch).front();
    const MeshBranch& branch = m_skeleton.branches[child];
    const BranchCurve curve = meshCurve(m_skeleton, child, m_context.clampOvershoot);
    m_axes.build(curve, branch, parent.section.frame, m_context.options.lengthDivisions, m_sections, nullptr);
    m_context.sink.startTube(branch.source, m_skeleton.branches[parent.branch].source,
                             {curve, branch.a0, branch.a1});
    m_tubes.finish(child, m_sections, 0, parent.ring, -branch.rollRad, m_ends);
}

/// Looks at what was added last while it is in the cache: its share of the signed volume, and triangles so
/// small that the clean-up should look at them again.
void BranchMesher::inspect()
{
    const MeshSink& sink = m_context.sink;
    const auto end = static_cast<Index>(sink.triangles.size());
    for (; m_inspected < end; ++m_inspected) {
        const glm::uvec3& triangle = sink.triangles[m_inspected];
        const glm::dvec3 a(sink.positions[triangle.x]);
        const glm::dvec3 normal = glm::cross(glm::dvec3(sink.positions[triangle.y]) - a,
                                             glm::dvec3(sink.positions[triangle.z]) - a);
        m_volume += glm::dot(a - m_base, normal);
        if (!(glm::dot(normal, normal) > m_smallSquared))
            m_small.push_back(m_inspected);
    }
}

/// Halves the radii of a whole tree: branches much thicker than long can turn their tubes inside out.
void BranchMesher::slimDown(Index root)
{
    std::vector<MeshBranch>& branches = m_skeleton.branches;
    Index branch = root;
    do {
        for (double* radius : {&branches[branch].a0, &branches[branch].a1})
            *radius = std::max(0.5 * *radius, std::min(*radius, thinnest * m_skeleton.scene));
        ++branch;
    } while (branch < branches.size() && branches[branch].parent != noIndex);
}

void BranchMesher::turnOver(std::size_t firstTriangle)
{
    std::vector<glm::uvec3>& triangles = m_context.sink.triangles;
    for (std::size_t t = firstTriangle; t < triangles.size(); ++t)
        std::swap(triangles[t].y, triangles[t].z);
}

Expected<void> BranchMesher::buildTree(Index root, const Progress& progress)
{
    const auto total = static_cast<double>(m_skeleton.branches.size());
    m_volume = 0.0;
    m_base = m_skeleton.branches[root].p0;
    buildRoot(root);
    inspect();
    while (!m_ends.empty()) {
        const TubeEnd parent = m_ends.back();
        m_ends.pop_back();
        const Index children = m_skeleton.branches[parent.branch].childCount;
        if (children == 1)
            continueChild(parent);
        else
            m_forks.build(parent, m_ends);
        inspect();
        m_sincePoll += children;
        if (m_sincePoll < pollEvery)
            continue;
        m_done += m_sincePoll;
        m_sincePoll = 0;
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("Cancelled"));
        progress.report(std::min(1.0, static_cast<double>(m_done) / total));
    }
    return {};
}

Expected<void> BranchMesher::run(const Progress& progress)
{
    if (progress.cancelled())
        return fail(ErrorCode::Cancelled, RAMURE_NOOP("Cancelled"));
    const double small = 2.0 * smallAreaShare * m_skeleton.scene * m_skeleton.scene;
    m_smallSquared = small * small;
    MeshSink& sink = m_context.sink;
    for (Index root = 0; root < m_skeleton.branches.size(); ++root) {
        if (m_skeleton.branches[root].parent != noIndex)
            continue;
        const std::size_t vertices = sink.positions.size(), triangles = sink.triangles.size();
        const std::size_t tubes = sink.tubes.size(), forkVertices = sink.forkVertices.size();
        m_context.clampOvershoot = m_context.options.clampOvershoot;
        for (int attempt = 0;; ++attempt) {
            if (auto built = buildTree(root, progress); !built)
                return built;
            if (m_volume > 0.0)
                break;
            if (attempt == slimmings) {
                turnOver(triangles);
                break;
            }
            if (attempt == 0)
                m_skeleton.repairs.push_back(
                    {SkeletonRepair::RadiusClamped, m_skeleton.branches[root].source, noIndex});
            // Overshooting curves are tamed first; thick tubes that still turn inside out are made thinner.
            if (m_context.clampOvershoot)
                slimDown(root);
            m_context.clampOvershoot = true;
            sink.positions.resize(vertices);
            sink.owner.resize(vertices);
            sink.triangles.resize(triangles);
            sink.tubes.resize(tubes);
            sink.axes.resize(tubes);
            sink.forkVertices.resize(forkVertices);
            m_inspected = static_cast<Index>(triangles);
            while (!m_small.empty() && m_small.back() >= m_inspected)
                m_small.pop_back();
        }
    }
    return {};
}

Expected<void> checkOptions(const Skeleton& skeleton, const BranchMeshOptions& options)
{
    if (options.lengthDivisions < 2 || options.lengthDivisions > 64)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("Length divisions must be between 2 and 64"));
    if (options.radialDivisions < 3 || options.radialDivisions > 128)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("Radial divisions must be between 3 and 128"));
    if (!options.rollRad.empty() && options.rollRad.size() != skeleton.size())
        return fail(ErrorCode::Invalid, RAMURE_NOOP("There must be one roll per branch"));
    const bool finite = std::all_of(options.rollRad.begin(), options.rollRad.end(),
                                    [](double roll) { return std::isfinite(roll); });
    if (!finite || !std::isfinite(options.nearTwinRatio) || options.nearTwinRatio < 0.0)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("A roll or the near-twin ratio is not a usable number"));
    const double faces =
        2.0 * skeleton.size() * (options.lengthDivisions + 2.0) * (options.radialDivisions + 8.0);
    if (faces > 2147483648.0)
        return fail(ErrorCode::Limit, RAMURE_NOOP("The mesh would have more than 2^31 faces"));
    return {};
}

template <class T> void reserveHuge(std::vector<T>& vector, std::size_t count)
{
    vector.reserve(count);
    adviseHugePages(vector.data(), count * sizeof(T));
}

void reserve(MeshSink& sink, const NormalSkeleton& skeleton, const BranchMeshOptions& options)
{
    const std::size_t rings =
        skeleton.branches.size() * static_cast<std::size_t>(options.lengthDivisions - 1);
    const std::size_t vertices = rings * static_cast<std::size_t>(options.radialDivisions) + 8 * rings / 3;
    reserveHuge(sink.positions, vertices);
    reserveHuge(sink.owner, vertices);
    reserveHuge(sink.triangles, 2 * vertices);
}

BranchMesh assemble(MeshSink& sink, NormalSkeleton& normal, const Skeleton& skeleton)
{
    BranchMesh result;
    if (normal.origin != glm::dvec3(0.0)) {
        for (glm::vec3& position : sink.positions)
            position = glm::vec3(glm::dvec3(position) + normal.origin);
        for (TubeAxis& axis : sink.axes) {
            axis.curve.h0 += normal.origin;
            axis.curve.h1 += normal.origin;
        }
    }
    result.mesh.positions = std::move(sink.positions);
    result.mesh.triangles = std::move(sink.triangles);
    result.mesh.branch = std::move(sink.owner);
    result.tubes = std::move(sink.tubes);
    result.axes = std::move(sink.axes);
    result.forkVertices = std::move(sink.forkVertices);
    result.mesh.level.resize(result.mesh.branch.size());
    for (std::size_t v = 0; v < result.mesh.branch.size(); ++v)
        result.mesh.level[v] = skeleton.level[result.mesh.branch[v]];
    result.repairs = std::move(normal.repairs);
    result.roots = normal.roots;
    return result;
}

} // namespace

Expected<BranchMesh> buildBranchMesh(const Skeleton& skeleton, const BranchMeshOptions& options,
                                     const Progress& progress)
{
    if (auto checked = checkOptions(skeleton, options); !checked)
        return fail(checked.error());
    auto normal = normaliseSkeleton(skeleton, options, progress);
    if (!normal)
        return fail(normal.error());
    MeshSink sink;
    reserve(sink, *normal, options);
    MesherContext context{*normal, options, sink, regularRing(options.radialDivisions), false};
    BranchMesher mesher(context, *normal);
    if (auto done = mesher.run(progress.part(0.0, 0.85)); !done)
        return fail(done.error());
    BranchMesh result = assemble(sink, *normal, skeleton);
    // Moved away from the origin, positions were rounded again: then every triangle is looked at.
    const bool rounded = normal->origin != glm::dvec3(0.0);
    separateVertices(result.mesh.positions, result.mesh.triangles, progress,
                     rounded ? nullptr : &mesher.smallTriangles());
    progress.report(0.95);
    computeNormals(result.mesh);
    if (progress.cancelled())
        return fail(ErrorCode::Cancelled, RAMURE_NOOP("Cancelled"));
    progress.report(1.0);
    return result;
}

} // namespace ramure
