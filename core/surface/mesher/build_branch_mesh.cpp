#include "core/surface/mesher/build_branch_mesh.h"

#include "core/base/large_buffer.h"
#include "core/base/parallel.h"
#include "core/math/frame.h"
#include "core/math/reproducible.h"
#include "core/params/param_def.h"
#include "core/surface/mesh/bark_relief.h"
#include "core/surface/mesh/mesh_cleanup.h"
#include "core/surface/mesh/normals.h"
#include "core/surface/mesher/branch_mesher.h"
#include "core/surface/mesher/fork_fairing.h"
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>

namespace ramure {

namespace {

/// A mesh for a budget is built again with what the last one taught, at most so often.
constexpr int mostTrials = 4;
constexpr double goodEnough = 0.035;            ///< of the triangles wanted: no further trial
constexpr std::size_t grain = 65536;            ///< vertices
constexpr std::int64_t trianglesOfRelief = 400; ///< about, by which one makes the mesh finer

Expected<void> checkOptions(const Skeleton& skeleton, const BranchMeshOptions& options)
{
    if (options.lengthDivisions < leastSections || options.lengthDivisions > mostSections ||
        options.radialDivisions < leastSides || options.radialDivisions > mostSides)
        return fail(ErrorCode::Invalid,
                    RAMURE_NOOP("A branch is divided into %1 to %2 cross-sections of %3 to %4 points"),
                    {std::to_string(leastSections), std::to_string(mostSections), std::to_string(leastSides),
                     std::to_string(mostSides)});
    if (!options.rollRad.empty() && options.rollRad.size() != skeleton.size())
        return fail(ErrorCode::Invalid, RAMURE_NOOP("There must be one roll per branch"));
    if (!std::ranges::all_of(options.rollRad, [](double roll) { return std::isfinite(roll); }))
        return fail(ErrorCode::Invalid, RAMURE_NOOP("A roll is not a usable number"));
    const auto wanted = static_cast<double>(options.targetTriangles);
    const bool hasBudget = options.targetTriangles > 0;
    const auto along = static_cast<double>(hasBudget ? leastSections : options.lengthDivisions);
    const auto around = static_cast<double>(hasBudget ? leastSides : options.radialDivisions);
    const double faces = 2.0 * skeleton.size() * (along + 2.0) * (around + 8.0);
    if (std::max(faces, 1.1 * wanted) > 2147483648.0)
        return fail(ErrorCode::Limit, RAMURE_NOOP("The mesh would have more than 2^31 faces"));
    return checkPart<MeshParams>(&NodeParams::mesh, options);
}

/// A mesh, its skeleton, and the triangles the clean-up should look at.
struct Built
{
    NormalSkeleton skeleton;
    BranchMesh mesh;
    std::vector<Index> small;
};

class Builder
{
public:
    Builder(const NormalSkeleton& normal, const BranchMeshOptions& options)
        : m_normal(normal)
        , m_options(options)
    {
    }
    Expected<Built> byDivisions(const Progress& progress)
    {
        return build(
            {static_cast<int>(m_options.lengthDivisions), static_cast<int>(m_options.radialDivisions)},
            progress);
    }
    Expected<Built> byBudget(const Progress& progress);

private:
    Expected<Built> build(const MeshDivisions& divisions, const Progress& progress);

    const NormalSkeleton& m_normal;
    const BranchMeshOptions& m_options;
};

Expected<Built> Builder::build(const MeshDivisions& divisions, const Progress& progress)
{
    Built built{m_normal, {}, {}};
    BranchMesher mesher(built.skeleton, m_options, divisions);
    RAMURE_TRY(mesher.run(progress));
    built.small = mesher.assemble(built.mesh);
    return built;
}

BudgetFit fitOf(double triangles, double wanted, double fineness, double finest)
{
    if (std::abs(triangles - wanted) <= budgetSlack * wanted)
        return BudgetFit::Within;
    if (fineness <= 0.0)
        return BudgetFit::Smallest;
    return fineness >= finest ? BudgetFit::Largest : BudgetFit::Nearest;
}

/// How many triangles forks take is known only once they are built: the estimate is corrected by what came
/// out, until it fits. The nearest trial is taken.
Expected<Built> Builder::byBudget(const Progress& progress)
{
    const MeshBudget budget(m_normal, m_options);
    const auto wanted = static_cast<double>(m_options.targetTriangles);
    std::optional<Built> best;
    double correction = 1.0, bestMiss = 0.0;
    for (int trial = 0; trial < mostTrials; ++trial) {
        const double fineness = budget.finenessFor(wanted * correction);
        const double from = 1.0 - maths::pow(0.4, trial), to = 1.0 - maths::pow(0.4, trial + 1);
        auto built = build({budget.shapes(), fineness, m_normal.leastGap}, progress.part(from, to));
        if (!built)
            return built;
        const auto triangles = static_cast<double>(built->mesh.mesh.triangles.size());
        const double miss = std::abs(triangles - wanted);
        built->mesh.budget = fitOf(triangles, wanted, fineness, budget.finest());
        const double estimate = budget.triangles(fineness);
        if (!best || miss < bestMiss) {
            best = std::move(*built);
            bestMiss = miss;
        }
        const double next = estimate / triangles;
        if (bestMiss <= goodEnough * wanted || budget.finenessFor(wanted * next) == fineness)
            break;
        correction = next;
    }
    return std::move(*best);
}

/// Moves vertices apart. Where branches lie in heaps, as in no tree, moving them by the least gap can turn
/// the surface inside out: then they move only as far as every mesh needs.
void moveApart(TriangleMesh& mesh, CleanupInput input, const Progress& progress)
{
    if (input.leastGap > 0.0) {
        const std::vector<glm::vec3> before = mesh.positions;
        separateVertices(mesh.positions, input, progress);
        const auto report = validateMesh(mesh, {progress.stop, {}});
        if (!report || report->valid)
            return;
        mesh.positions = before;
        input.leastGap = 0.0;
    }
    separateVertices(mesh.positions, input, progress);
}

/// Parts vertices that are near and opens triangles without area. Mostly there is nothing to do: normals are
/// computed beside the search, and again if there was.
void polish(TriangleMesh& mesh, const CleanupInput& input, bool withNormals, const Progress& progress)
{
    const bool beside = withNormals && parallelThreads() > 1;
    bool separate = false;
    parallelFor(beside ? 2 : 1, 1, [&](std::size_t part, std::size_t) {
        if (part == 0)
            separate = areSeparate(mesh.positions, input);
        else
            computeNormals(mesh);
    });
    if (!separate)
        moveApart(mesh, input, progress);
    if (withNormals && !(separate && beside))
        computeNormals(mesh);
}

/// Where a mark of the bark lies. Nothing where its branch has no length.
std::optional<Relief> reliefOf(const Organ& mark, const Skeleton& skeleton, const glm::dvec3& origin)
{
    const glm::dvec3 start = skeleton.p0[mark.branch], way = skeleton.p1[mark.branch] - start;
    const glm::dvec3 aside = mark.heading - glm::dot(mark.heading, mark.axis) * mark.axis;
    if (!(glm::length(way) > 0.0) || !(glm::length(aside) > 0.0))
        return {};
    const glm::dvec3 out = glm::normalize(aside); // it turns with its branch
    const Frame now = transported({mark.axis, out, glm::cross(mark.axis, out)}, glm::normalize(way));
    using enum Relief::Form;
    const auto form = mark.kind == OrganKind::Scar ? Scar : mark.kind == OrganKind::Hollow ? Hollow : Burr;
    return Relief{form,
                  mark.branch,
                  glm::vec3(start + mark.share * way + mark.offset - origin),
                  glm::vec3(now.normal),
                  float(mark.size),
                  float(mark.healed)};
}

/// Scars, hollows and burrs, the largest first. Of a budget they take no more than a share.
std::vector<Relief> reliefsOf(const Skeleton& skeleton, const glm::dvec3& origin, std::int64_t budget)
{
    constexpr double most = 0.06;
    std::vector<Relief> out;
    for (const Organ& organ : skeleton.organs)
        if (const auto relief = isMark(organ.kind) ? reliefOf(organ, skeleton, origin) : std::nullopt)
            out.push_back(*relief);
    std::ranges::stable_sort(out, std::greater(), &Relief::radius);
    if (budget > 0)
        out.resize(std::min(out.size(), std::size_t(most * double(budget) / double(trianglesOfRelief))));
    return out;
}

/// \return whether any found its place
bool drawMarks(BranchMesh& mesh, std::span<const Relief> reliefs)
{
    if (reliefs.empty())
        return false;
    const std::vector<glm::uvec3>& triangles = mesh.mesh.triangles;
    std::vector<ReliefHold> held(mesh.mesh.positions.size(), ReliefHold::None);
    for (const ForkVertex& fork : mesh.forkVertices)
        held[fork.vertex] = ReliefHold::Place;
    for (std::size_t tube = 0; tube < mesh.tubes.size(); ++tube)
        if (const FootSize& foot = mesh.axes[tube].foot; foot.rings > 0) {
            const std::size_t end =
                tube + 1 < mesh.tubes.size() ? mesh.tubes[tube + 1].firstTriangle : triangles.size();
            Index pole = noIndex;
            for (std::size_t t = mesh.tubes[tube].firstTriangle; t < end; ++t)
                pole = std::min({pole, triangles[t].x, triangles[t].y, triangles[t].z});
            std::fill_n(held.begin() + pole, 1 + foot.rings * foot.points, ReliefHold::Triangles);
        }
    const std::vector<Index> first = drawReliefs(mesh.mesh, reliefs, held);
    if (first.empty())
        return false;
    for (TubeRange& tube : mesh.tubes)
        tube.firstTriangle = first[tube.firstTriangle];
    return true;
}

/// What is known once all vertices stand in their order.
void finish(Built& built, const Skeleton& skeleton)
{
    BranchMesh& result = built.mesh;
    TriangleMesh& mesh = result.mesh;
    const glm::dvec3 origin = built.skeleton.origin;
    mesh.level.resize(mesh.branch.size());
    parallelFor(mesh.branch.size(), grain, [&](std::size_t from, std::size_t to) {
        for (std::size_t v = from; v < to; ++v)
            mesh.level[v] = skeleton.level[mesh.branch[v]];
        if (origin != glm::dvec3(0.0))
            for (std::size_t v = from; v < to; ++v)
                mesh.positions[v] = glm::vec3(glm::dvec3(mesh.positions[v]) + origin);
    });
    if (origin != glm::dvec3(0.0))
        for (TubeAxis& axis : result.axes) {
            axis.curve.h0 += origin;
            axis.curve.h1 += origin;
        }
    result.repairs = std::move(built.skeleton.repairs);
    result.roots = built.skeleton.roots;
    result.leastGap = built.skeleton.leastGap;
}

} // namespace

const char* budgetText(BudgetFit fit)
{
    switch (fit) {
    case BudgetFit::NotAsked:
    case BudgetFit::Within:
        return "";
    case BudgetFit::Smallest:
        return RAMURE_NOOP(
            "So many branches cannot be drawn with the triangle budget: this is their smallest mesh");
    case BudgetFit::Largest:
        return RAMURE_NOOP(
            "The triangle budget is more than these branches can take: this is their finest mesh");
    case BudgetFit::Nearest:
        return RAMURE_NOOP("No mesh fits the triangle budget: this is the nearest");
    }
    return "";
}

namespace {

/// What is built, and the triangles that may have no area; null: any of them may.
struct Shaped
{
    Built built;
    bool anyIsSuspect = false;

    [[nodiscard]] CleanupInput toClean() const
    {
        return {built.mesh.mesh.triangles, anyIsSuspect ? nullptr : &built.small, built.mesh.leastGap};
    }
};

Expected<Shaped> shape(const Skeleton& skeleton, const BranchMeshOptions& options, const Progress& progress)
{
    RAMURE_TRY(checkOptions(skeleton, options));
    const auto normal = normaliseSkeleton(skeleton, options, progress);
    RAMURE_TRY(normal);
    const std::vector<Relief> marks = reliefsOf(skeleton, normal->origin, options.targetTriangles);
    BranchMeshOptions without = options;
    if (options.targetTriangles > 0)
        without.targetTriangles -= trianglesOfRelief * std::int64_t(marks.size());
    Builder builder(*normal, without);
    auto built = options.targetTriangles > 0 ? builder.byBudget(progress) : builder.byDivisions(progress);
    RAMURE_TRY(built);
    finishForks(built->mesh, options);
    const bool isMarked = drawMarks(built->mesh, marks);
    finish(*built, skeleton);
    // Moved away from the origin, positions were rounded again: then every triangle is looked at.
    return Shaped{std::move(*built), isMarked || normal->origin != glm::dvec3(0.0)};
}

} // namespace

Expected<BranchMesh> buildBranchMesh(const Skeleton& skeleton, const BranchMeshOptions& options,
                                     const Progress& progress)
{
    auto shaped = shape(skeleton, options, progress.part(0.0, 0.85));
    RAMURE_TRY(shaped);
    TriangleMesh& mesh = shaped->built.mesh.mesh;
    mesh.normals.resize(options.withNormals ? mesh.normals.size() : 0);
    polish(mesh, shaped->toClean(), options.withNormals, progress);
    if (progress.cancelled())
        return fail(ErrorCode::Cancelled, RAMURE_NOOP("Cancelled"));
    progress.report(1.0);
    return std::move(shaped->built.mesh);
}

Expected<CheckedBranchMesh> buildCheckedBranchMesh(const Skeleton& skeleton, const BranchMeshOptions& options,
                                                   const Progress& progress)
{
    auto shaped = shape(skeleton, options, progress.part(0.0, 0.8));
    RAMURE_TRY(shaped);
    TriangleMesh& mesh = shaped->built.mesh.mesh;
    const CleanupInput input = shaped->toClean();
    if (!areSeparate(mesh.positions, input))
        moveApart(mesh, input, progress);
    auto report = validateMesh(mesh, progress.part(0.8, 1.0), [&] { computeNormals(mesh); });
    RAMURE_TRY(report);
    return CheckedBranchMesh{std::move(shaped->built.mesh), std::move(*report)};
}

} // namespace ramure
