#include "core/mesh/branch_mesh.h"

#include "core/mesh/fork_builder.h"
#include "core/mesh/mesh_cleanup.h"
#include "core/mesh/normals.h"
#include <algorithm>
#include <string>

namespace ramure {

namespace {

constexpr double tipHeight = 0.35; ///< of the radius: how far a tip is rounded beyond the branch's end
constexpr std::size_t pollEvery = 256;
constexpr int slimmings = 10; ///< at most so often are the radii of a tree halved that came out inside out

/// Builds tube after tube. Depth first with its own stack, so that a skeleton may be as deep as it likes.
class BranchMesher
{
public:
    BranchMesher(const MesherContext& context, NormalSkeleton& skeleton)
        : m_context(context)
        , m_skeleton(skeleton)
        , m_fork(context)
    {
    }
    Expected<void> run(const Progress& progress);

private:
    Expected<void> buildTree(Index root, const Progress& progress);
    [[nodiscard]] double volumeSince(std::size_t firstTriangle) const;
    void slimDown(Index root);
    void turnOver(std::size_t firstTriangle);
    void startRoot(Index root);
    void finishTube(const TubeStart& start);
    void advance(const TubeStart& start, Index& ring, bool endsInFork);
    void evenStrip(Index lower, Index upper);
    void looseStrip(Index lower, double lowerAzimuth, std::span<const double> upperAzimuths, Index upper,
                    const AxisSection& section);
    void closeTip(Index ring, const AxisSection& end, Index owner);
    [[nodiscard]] Index radial() const { return static_cast<Index>(m_context.options.radialDivisions); }

    const MesherContext& m_context;
    NormalSkeleton& m_skeleton; ///< that of the context
    std::size_t m_done = 0;
    ForkBuilder m_fork;
    AxisBuilder m_axes;
    EndPlanner m_ends;
    StripPatch m_strip;
    std::vector<TubeStart> m_stack, m_starts;
    std::vector<AxisSection> m_sections;
    std::vector<double> m_regular;
    std::vector<UnrolledVertex> m_lower, m_upper;
};

/// Two regular rings whose points face each other.
void BranchMesher::evenStrip(Index lower, Index upper)
{
    const Index n = radial();
    for (Index k = 0; k < n; ++k) {
        const Index next = k + 1 < n ? k + 1 : 0;
        m_context.sink.addTriangle(lower + k, lower + next, upper + k);
        m_context.sink.addTriangle(lower + next, upper + next, upper + k);
    }
}

/// A regular ring, turned by \p lowerAzimuth, and any other.
void BranchMesher::looseStrip(Index lower, double lowerAzimuth, std::span<const double> upperAzimuths,
                              Index upper, const AxisSection& section)
{
    m_lower.clear();
    m_upper.clear();
    for (Index k = 0; k < radial(); ++k)
        m_lower.push_back({m_regular[k] + lowerAzimuth, 0.0, lower + k});
    for (std::size_t k = 0; k < upperAzimuths.size(); ++k)
        m_upper.push_back({upperAzimuths[k], section.radius, upper + static_cast<Index>(k)});
    m_strip.zip(m_lower, m_upper, section.radius);
    m_strip.write(m_context.sink);
}

void BranchMesher::closeTip(Index ring, const AxisSection& end, Index owner)
{
    const Index pole =
        m_context.sink.addVertex(end.centre + tipHeight * end.radius * end.frame.tangent, owner);
    for (Index k = 0; k < radial(); ++k)
        m_context.sink.addTriangle(ring + k, ring + (k + 1) % radial(), pole);
}

/// The root's flat end and its first ring.
void BranchMesher::startRoot(Index root)
{
    const MeshBranch& branch = m_context.skeleton.branches[root];
    const BranchCurve curve = meshCurve(m_context.skeleton, root, m_context.options.clampOvershoot);
    const Frame frame = frameFromTangent(hermite(curve.h0, curve.h1, curve.v0, curve.v1, 0.0).tangent);
    m_axes.build(curve, branch, frame, m_context.options.lengthDivisions, m_sections, nullptr);
    const Index pole = m_context.sink.addVertex(branch.p0, branch.source);
    const Index ring = addRing(m_sections.front(), m_regular, branch.source, m_context.sink);
    for (Index k = 0; k < radial(); ++k)
        m_context.sink.addTriangle(ring + (k + 1) % radial(), ring + k, pole);
    m_stack.push_back({root, frame, ring, 0});
}

/// Rings and strips from where the tube stands to its end; \p ring becomes the end ring.
void BranchMesher::advance(const TubeStart& start, Index& ring, bool endsInFork)
{
    const MeshBranch& branch = m_context.skeleton.branches[start.branch];
    const std::size_t end = m_sections.size() - 1;
    // A single child's first ring is its parent's last: its own roll turns the frame against it.
    double lowerAzimuth = start.section == 0 && branch.parent != noIndex ? -branch.rollRad : 0.0;
    std::size_t last = start.section;
    for (std::size_t k = last + 1; k <= end; ++k) {
        if (!keepsSection(m_sections, last, k))
            continue;
        last = k;
        const bool split = k == end && endsInFork;
        const std::vector<double>& azimuths = split ? m_ends.azimuths() : m_regular;
        const Index next = addRing(m_sections[k], azimuths, branch.source, m_context.sink);
        if (split || lowerAzimuth != 0.0)
            looseStrip(ring, lowerAzimuth, azimuths, next, m_sections[k]);
        else
            evenStrip(ring, next);
        ring = next;
        lowerAzimuth = 0.0;
    }
}

void BranchMesher::finishTube(const TubeStart& start)
{
    const MeshBranch& branch = m_context.skeleton.branches[start.branch];
    m_axes.build(meshCurve(m_context.skeleton, start.branch, m_context.options.clampOvershoot), branch,
                 start.frame, m_context.options.lengthDivisions, m_sections, nullptr);
    const AxisSection end = m_sections.back();
    const bool fork = m_ends.plan(m_context, start.branch, end);
    Index ring = start.firstVertex;
    advance(start, ring, fork);
    if (branch.childCount == 0) {
        closeTip(ring, end, branch.source);
    } else if (!fork) {
        m_stack.push_back({m_context.skeleton.childrenOf(start.branch).front(), end.frame, ring, 0});
    } else {
        m_fork.build(start.branch, end, m_ends.layout(), ring, m_starts);
        m_stack.insert(m_stack.end(), m_starts.rbegin(), m_starts.rend());
    }
}

/// Six times the signed volume of what was added last.
double BranchMesher::volumeSince(std::size_t firstTriangle) const
{
    const MeshSink& sink = m_context.sink;
    const glm::dvec3 base(sink.positions[sink.triangles[firstTriangle].x]);
    double volume = 0.0;
    for (std::size_t t = firstTriangle; t < sink.triangles.size(); ++t) {
        const glm::uvec3& triangle = sink.triangles[t];
        const glm::dvec3 a = glm::dvec3(sink.positions[triangle.x]) - base;
        const glm::dvec3 b = glm::dvec3(sink.positions[triangle.y]) - base;
        const glm::dvec3 c = glm::dvec3(sink.positions[triangle.z]) - base;
        volume += glm::dot(a, glm::cross(b, c));
    }
    return volume;
}

/// Halves the radii of a whole tree: branches much thicker than long can turn their tubes inside out.
void BranchMesher::slimDown(Index root)
{
    std::vector<MeshBranch>& branches = m_skeleton.branches;
    Index branch = root;
    do {
        branches[branch].a0 *= 0.5;
        branches[branch].a1 *= 0.5;
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
    startRoot(root);
    while (!m_stack.empty()) {
        if (m_done++ % pollEvery == 0) {
            if (progress.cancelled())
                return fail(ErrorCode::Cancelled, RAMURE_NOOP("Cancelled"));
            progress.report(std::min(1.0, static_cast<double>(m_done) / total));
        }
        const TubeStart start = m_stack.back();
        m_stack.pop_back();
        finishTube(start);
    }
    return {};
}

Expected<void> BranchMesher::run(const Progress& progress)
{
    m_regular.clear();
    for (Index k = 0; k < radial(); ++k)
        m_regular.push_back(regularAzimuth(k, m_context.options.radialDivisions));
    MeshSink& sink = m_context.sink;
    for (Index root = 0; root < m_skeleton.branches.size(); ++root) {
        if (m_skeleton.branches[root].parent != noIndex)
            continue;
        const std::size_t vertices = sink.positions.size(), triangles = sink.triangles.size();
        for (int attempt = 0;; ++attempt) {
            if (auto built = buildTree(root, progress); !built)
                return built;
            if (volumeSince(triangles) > 0.0)
                break;
            if (attempt == slimmings) {
                turnOver(triangles);
                break;
            }
            if (attempt == 0)
                m_skeleton.repairs.push_back(
                    {SkeletonRepair::RadiusClamped, m_skeleton.branches[root].source, noIndex});
            slimDown(root);
            sink.positions.resize(vertices);
            sink.owner.resize(vertices);
            sink.triangles.resize(triangles);
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

void reserve(MeshSink& sink, const NormalSkeleton& skeleton, const BranchMeshOptions& options)
{
    const std::size_t rings =
        skeleton.branches.size() * static_cast<std::size_t>(options.lengthDivisions - 1);
    const std::size_t vertices = rings * static_cast<std::size_t>(options.radialDivisions) + 8 * rings / 3;
    sink.positions.reserve(vertices);
    sink.owner.reserve(vertices);
    sink.triangles.reserve(2 * vertices);
}

BranchMesh assemble(MeshSink& sink, NormalSkeleton& normal, const Skeleton& skeleton)
{
    BranchMesh result;
    if (normal.origin != glm::dvec3(0.0))
        for (glm::vec3& position : sink.positions)
            position = glm::vec3(glm::dvec3(position) + normal.origin);
    result.mesh.positions = std::move(sink.positions);
    result.mesh.triangles = std::move(sink.triangles);
    result.mesh.branch = std::move(sink.owner);
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
    const MesherContext context{*normal, options, sink};
    BranchMesher mesher(context, *normal);
    if (auto done = mesher.run(progress.part(0.0, 0.85)); !done)
        return fail(done.error());
    BranchMesh result = assemble(sink, *normal, skeleton);
    separateVertices(result.mesh.positions, result.mesh.triangles, progress);
    progress.report(0.95);
    computeNormals(result.mesh);
    if (progress.cancelled())
        return fail(ErrorCode::Cancelled, RAMURE_NOOP("Cancelled"));
    progress.report(1.0);
    return result;
}

} // namespace ramure
