#include "core/pipeline/tree_pipeline.h"

#include "core/base/stopwatch.h"
#include "core/generators/sources.h"
#include "core/math/stage_hash.h"
#include "core/params/source_facts.h"
#include "core/params/tree_edit_table.h"
#include "core/pipeline/bark_feet.h"
#include "core/pipeline/draft_tubes.h"
#include "core/pipeline/longest_life.h"
#include "core/pipeline/stage_cache.h"
#include "core/pipeline/stage_hashes.h"
#include "core/recipe/edit_context.h"
#include "core/skeleton/packed_skeleton.h"
#include "core/surface/foliage/place_foliage.h"
#include "core/surface/mesher/build_branch_mesh.h"
#include "core/surface/mesher/mesh_divisions.h"
#include "core/surface/season/foliage_on_day.h"
#include "core/surface/texture/cut_wood.h"
#include <algorithm>
#include <chrono>
#include <numeric>
#include <optional>
#include <tuple>

namespace ramure {
namespace {

struct MeshedBranches
{
    std::shared_ptr<const BranchMesh> mesh;
    std::shared_ptr<const MeshReport> report;
    std::shared_ptr<const TriangleMesh> cuts;
    std::shared_ptr<const TextureStage> texture;
};

struct MeshedFoliage
{
    std::shared_ptr<const Foliage> foliage;
    DeferredMesh leaves, apples;
};

template <class T> std::size_t bytesOf(const std::vector<T>& list)
{
    return list.capacity() * sizeof(T);
}
std::size_t bytesOf(const GrownSymbols& grown)
{
    return grown.letters.capacity() + bytesOf(grown.word.modules) + bytesOf(grown.word.numbers) +
           bytesOf(grown.word.keys) + (grown.history ? grown.history->bytes() : 0);
}
std::size_t bytesOf(const Skeleton& s)
{
    return bytesOf(s.parent) + bytesOf(s.p0) + bytesOf(s.p1) + bytesOf(s.a0) + bytesOf(s.a1) +
           bytesOf(s.level) + bytesOf(s.key) + bytesOf(s.source) + bytesOf(s.organs) + bytesOf(s.axisStarts) +
           bytesOf(s.bare) + bytesOf(s.sawn) + bytesOf(s.loose) + bytesOf(s.rolls);
}
std::size_t bytesOf(const TreeAxes& tree)
{
    return bytesOf(tree.axes) + bytesOf(tree.nodes) + bytesOf(tree.axisOf) + bytesOf(tree.forksBelow) +
           bytesOf(tree.start);
}
/// What hands made of it.
struct EditedTree
{
    EditContext context;
    Skeleton skeleton; ///< of the context
};
/// The tree as the steps before the last change have left it: whoever drags a value of step 7 runs the steps
/// from there on alone.
struct RecipeStart
{
    std::uint64_t grown = 0;    ///< StageHashes::grown
    std::vector<TreeEdit> last; ///< the list that was made last
    std::optional<EditContext> before;
};

/// Whether each step alone has found its place: edits that look for it by likeness look together.
bool areSettled(const EditReport& report, std::span<const TreeEdit> steps)
{
    return std::ranges::equal(report, steps, [](const EditOutcome& outcome, const TreeEdit& step) {
        const bool isIdle =
            outcome.state == EditState::Idle && infoOf(step.operation).group != StepGroup::Hand;
        return isIdle || outcome.state == EditState::ByAddress || outcome.state == EditState::Off ||
               outcome.state == EditState::Frozen || outcome.state == EditState::Waits;
    });
}

/// All steps, from where \p start is the same.
EditContext runRecipe(const Skeleton& grown, const NodeParams& params,
                      const std::shared_ptr<const TreeAxes>& axes, RecipeStart& start,
                      const Progress& progress)
{
    const std::span<const TreeEdit> steps = params.edits;
    const auto differs = std::ranges::mismatch(start.last, steps).in2;
    const auto same = static_cast<std::size_t>(differs - steps.begin());
    start.last = params.edits;
    const auto fromGround = [&](std::size_t count) {
        return EditContext(grown, steps.first(count), axes, treeSeed(params), progress);
    };
    if (same <= stepsFrozen(steps) ||
        same == steps.size()) { // the next change most likely comes behind the last step
        start.before = fromGround(steps.size());
        return EditContext(*start.before);
    }
    std::optional<EditContext> before =
        start.before ? start.before->upTo(steps.first(same), progress) : std::nullopt;
    start.before = before ? std::move(*before) : fromGround(same);
    std::optional<EditContext> all = start.before->upTo(steps, progress);
    if (all && areSettled(all->report(), steps))
        return std::move(*all);
    start.before.reset();
    return fromGround(steps.size());
}

std::size_t bytesOf(const EditedTree& edited)
{
    return bytesOf(edited.skeleton) + edited.context.bytes();
}
std::size_t bytesOf(const SimplifiedSkeleton& s)
{
    return bytesOf(s.skeleton) + bytesOf(s.mergedInto);
}
std::size_t bytesOf(const SectionSet& set)
{
    return bytesOf(set.sections);
}
std::size_t bytesOf(const MeshedBranches& m)
{
    const BranchMesh& mesh = *m.mesh;
    return bytesOf(mesh.mesh) + bytesOf(mesh.tubes) + bytesOf(mesh.axes) + bytesOf(mesh.forkVertices) +
           bytesOf(mesh.repairs) + bytesOf(m.report->defects) + (m.cuts ? bytesOf(*m.cuts) : 0) +
           m.texture->bytes();
}
std::size_t bytesOf(const Foliage& f)
{
    return bytesOf(f.leaves) + bytesOf(f.apples);
}
std::size_t bytesOf(const MeshedFoliage& f)
{
    return bytesOf(*f.foliage) + f.leaves.bytes() + f.apples.bytes();
}

SimplifiedSkeleton untouched(const Skeleton& skeleton)
{
    SimplifiedSkeleton same{skeleton, std::vector<Index>(skeleton.size())};
    std::iota(same.mergedInto.begin(), same.mergedInto.end(), Index(0));
    return same;
}

Expected<void> checkMeshSize(Index branches, const NodeParams& all)
{
    const bool hasBudget = all.mesh.targetTriangles > 0;
    SectionParams params = all.sections;
    if (hasBudget)
        params.radialDivisions = leastSides;
    const auto faces = [&](std::int64_t length, std::int64_t radial) {
        return 2 * std::size_t(branches) * static_cast<std::size_t>(length) *
               static_cast<std::size_t>(radial);
    };
    const std::size_t wanted = faces(params.lengthDivisions, params.radialDivisions);
    if (wanted <= maxMeshFaces)
        return {};
    auto error =
        fail(ErrorCode::Limit,
             RAMURE_NOOP("%1 branches would make a mesh of about %2 triangles, more than the limit of %3"),
             {std::to_string(branches), std::to_string(wanted), std::to_string(maxMeshFaces)});
    const SectionParams usual;
    const bool tooManyBranches = faces(usual.lengthDivisions, usual.radialDivisions) > maxMeshFaces;
    error.value().path = tooManyBranches ? sourceFacts(all).sizeKey
                         : hasBudget     ? "sections.lengthDivisions"
                                         : "sections.radialDivisions";
    return error;
}

/// At least so many branches are left after merging: runs end at forks.
Index leastAfterMerging(const Skeleton& skeleton)
{
    std::vector<Index> children(skeleton.size(), 0);
    for (const Index parent : skeleton.parent)
        if (parent != noIndex)
            ++children[parent];
    return static_cast<Index>(
        std::count_if(skeleton.parent.begin(), skeleton.parent.end(),
                      [&children](Index parent) { return parent == noIndex || children[parent] > 1; }));
}

/// Before the copy that simplification makes: of millions of branches it would be large, for nothing.
Expected<void> checkBeforeMerging(const Skeleton& skeleton, const NodeParams& params)
{
    auto all = checkMeshSize(skeleton.size(), params);
    if (all || !params.simplify.enabled)
        return all;
    return checkMeshSize(leastAfterMerging(skeleton), params);
}

Expected<MeshedBranches> meshBranches(const Skeleton& skeleton, const NodeParams& params,
                                      std::span<const double> rolls, const Progress& progress)
{
    const BranchMeshOptions options{params.sections, params.mesh,      true,
                                    rolls,           treeSeed(params), groundOf(params)};
    auto made = buildCheckedBranchMesh(skeleton, options, progress);
    RAMURE_TRY(made);
    const auto mesh = std::make_shared<const BranchMesh>(std::move(made->mesh));
    const bool isCut = !skeleton.sawn.empty() || !skeleton.loose.empty();
    return MeshedBranches{mesh, std::make_shared<const MeshReport>(std::move(made->report)),
                          isCut ? std::make_shared<const TriangleMesh>(cutWood(*mesh, skeleton)) : nullptr,
                          std::make_shared<const TextureStage>(mesh)};
}

/// \param branches that plants' leaves and fruit stand on; null: they are faithful, or it is a draft, which
/// has none.
Expected<Foliage> foliageOn(const Skeleton& skeleton, const NodeParams& params, const BranchMesh* branches,
                            const Progress& progress)
{
    auto placed = placedFoliage(skeleton, params, progress);
    if (placed && branches)
        standOnBark(*placed, *branches, skeleton.size(), trunkRadius(params), progress);
    return placed;
}

/// \param isSketch of a draft. Views draw copies: of a plant's leaves a draft has but cards. A day of a year
/// costs no mesh: both are merged when somebody looks at them.
MeshedFoliage meshFoliage(const std::shared_ptr<const SimplifiedSkeleton>& tree, const NodeParams& params,
                          const std::shared_ptr<const Foliage>& placed, bool isSketch)
{
    const Skeleton& skeleton = tree->skeleton;
    const FoliageModel model = isSketch ? FoliageModel::Rough : FoliageModel::Fine;
    const double alpha = trunkRadius(params);
    const auto foliage =
        hasDay(params.season)
            ? std::make_shared<const Foliage>(foliageOnDay(*placed, skeleton, params.season, alpha))
            : placed;
    const auto later = [](const TriangleMesh& one, std::size_t count, auto make) {
        const auto pieces = static_cast<Index>(count);
        return DeferredMesh(pieces * one.vertexCount(), pieces * one.faceCount(), std::move(make));
    };
    return {foliage,
            later(oneLeaf(foliage->form, alpha, model), foliage->leaves.size(),
                  [=] { return buildLeaves(tree->skeleton, *foliage, alpha, model); }),
            later(oneApple(foliage->fruit, alpha, FoliageModel::Fine), foliage->apples.size(),
                  [=] { return buildApples(tree->skeleton, *foliage, alpha, FoliageModel::Fine); })};
}

} // namespace

struct TreePipeline::Cache
{
    StageCache<GrownSymbols> symbols{bytesOf};
    LongestLife life;
    StageCache<Skeleton> skeleton{bytesOf};
    StageCache<TreeAxes> axes{bytesOf}; ///< of trees with edits, as they have grown
    StageCache<EditedTree> edited{bytesOf};
    RecipeStart start;
    std::pair<std::uint64_t, double> grownIn; ///< StageHashes::grown, and the seconds that it took
    StageCache<SimplifiedSkeleton> simplified{bytesOf};
    StageCache<SectionSet> sections{bytesOf};
    StageCache<MeshedBranches> branches{bytesOf};
    StageCache<Foliage> placed{bytesOf};
    StageCache<MeshedFoliage> foliage{bytesOf};

    void forEach(const auto& change)
    {
        const auto all =
            std::tie(symbols, skeleton, axes, edited, simplified, sections, branches, placed, foliage);
        std::apply([&](auto&... caches) { (change(caches), ...); }, all);
    }
};

namespace {

/// The result from the cache, or made and kept.
template <class T, class Make>
Expected<std::shared_ptr<const T>> cached(StageCache<T>& cache, std::uint64_t hash, const Progress& progress,
                                          Make&& make)
{
    if (progress.cancelled())
        return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
    if (auto kept = cache.find(hash))
        return kept;
    Expected<T> made = make();
    RAMURE_TRY(made);
    auto result = std::make_shared<const T>(std::move(*made));
    cache.keep(hash, result);
    return result;
}

/// Adds the time that it lives for.
class GrowClock
{
public:
    explicit GrowClock(double& seconds)
        : m_seconds(seconds)
    {
    }
    ~GrowClock() { m_seconds += 1e-3 * m_watch.elapsed().wallMs; }
    GrowClock(const GrowClock&) = delete;
    GrowClock& operator=(const GrowClock&) = delete;

private:
    double& m_seconds;
    Stopwatch m_watch;
};

/// The stages in their order, each into its place in the result. C is TreePipeline::Cache, which is private
/// there.
template <class C> class Evaluation
{
public:
    Evaluation(const NodeParams& params, C& cache, const Progress& progress)
        : m_params(params)
        , m_hashes(params)
        , m_cache(cache)
        , m_progress(progress)
    {
        if (const std::size_t frozen = stepsFrozen(params.edits); frozen > 0)
            m_frozen = params.edits[frozen - 1].frozen.pointer();
    }

    Expected<TreeResult> run(Stage last)
    {
        m_meshes = last >= Stage::Sections;
        RAMURE_TRY(upTo(last));
        m_progress.report(1.0);
        return std::move(m_result);
    }
    Expected<TreeResult> runDraft()
    {
        if (m_cache.branches.find(m_hashes[Stage::Mesh]))
            return run(Stage::Foliage);
        RAMURE_TRY(upTo(Stage::Simplified));
        const Skeleton& skeleton = m_result.simplified->skeleton;
        RAMURE_TRY(checkMeshSize(skeleton.size(), m_params));
        NodeParams coarse = m_params;
        coarse.sections = draftDivisions(m_params.sections, skeleton.size());
        Evaluation draft(coarse, m_cache, m_progress);
        return draft.upTo(Stage::Sections).and_then([&] { return draft.foliage(); }).map([&] {
            TreeResult& result = draft.m_result;
            const auto points = static_cast<int>(coarse.sections.radialDivisions);
            result.draftTubes = std::make_shared<const TriangleMesh>(
                buildDraftTubes(result.simplified->skeleton, *result.sections, points));
            return std::move(result);
        });
    }

private:
    Expected<void> upTo(Stage last)
    {
        using Step = Expected<void> (Evaluation::*)();
        constexpr std::pair<Stage, Step> steps[] = {
            {Stage::Symbols, &Evaluation::symbols},       {Stage::Skeleton, &Evaluation::skeleton},
            {Stage::Simplified, &Evaluation::simplified}, {Stage::Sections, &Evaluation::sections},
            {Stage::Mesh, &Evaluation::branches},         {Stage::Foliage, &Evaluation::foliage},
        };
        for (const auto& [stage, step] : steps) {
            if (stage > last)
                break;
            if (auto done = (this->*step)(); !done)
                return done;
        }
        return {};
    }
    Expected<void> symbols()
    {
        if (m_frozen) {
            m_grown = std::make_shared<const GrownSymbols>();
            m_result.symbols = std::shared_ptr<const std::string>(m_grown, &m_grown->letters);
            return {};
        }
        return cached(m_cache.symbols, m_hashes[Stage::Symbols], m_progress,
                      [&] {
                          const Progress progress = m_progress.part(0.0, 0.05);
                          const GrowClock clock(m_growSeconds);
                          return m_hashes.life() != 0 ? m_cache.life.grow(m_hashes.life(), m_params, progress)
                                                      : growSymbols(m_params, progress);
                      })
            .map([&](auto made) {
                m_result.symbols = std::shared_ptr<const std::string>(made, &made->letters);
                m_grown = std::move(made);
            });
    }
    Expected<void> skeleton()
    {
        return cached(m_cache.skeleton, m_hashes.grown(), m_progress,
                      [&] {
                          const GrowClock clock(m_growSeconds);
                          return m_frozen ? unpackSkeleton(m_frozen->bytes)
                                          : growSkeleton(*m_grown, m_params, m_progress.part(0.05, 0.1));
                      })
            .and_then([&](auto made) {
                if (m_growSeconds > 0.0 && !m_frozen)
                    m_cache.grownIn = {m_hashes.grown(), m_growSeconds};
                if (m_cache.grownIn.first == m_hashes.grown())
                    m_result.sourceSeconds = m_cache.grownIn.second;
                m_result.grown = made;
                m_result.skeleton = std::move(made);
                return edited();
            });
    }
    Expected<void> edited()
    {
        if (m_params.edits.empty())
            return {};
        const Skeleton& grown = *m_result.grown;
        const auto axes = cached(m_cache.axes, m_hashes.grown(), m_progress,
                                 [&]() -> Expected<TreeAxes> { return axesOf(grown); });
        RAMURE_TRY(axes);
        return cached(m_cache.edited, m_hashes[Stage::Skeleton], m_progress,
                      [&]() -> Expected<EditedTree> {
                          if (m_cache.start.grown != m_hashes.grown())
                              m_cache.start = {m_hashes.grown(), {}, std::nullopt};
                          EditContext context =
                              runRecipe(grown, m_params, *axes, m_cache.start, m_progress.part(0.05, 0.1));
                          if (m_progress.cancelled()) {
                              m_cache.start = {};
                              return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
                          }
                          Skeleton skeleton = context.skeleton();
                          return EditedTree{std::move(context), std::move(skeleton)};
                      })
            .map([&](auto made) {
                m_result.skeleton = std::shared_ptr<const Skeleton>(made, &made->skeleton);
                m_result.edited = std::shared_ptr<const EditContext>(made, &made->context);
                m_result.edits = std::shared_ptr<const EditReport>(made, &made->context.report());
            });
    }
    Expected<void> simplified()
    {
        const SimplifyParams& params = m_params.simplify;
        const Skeleton& skeleton = *m_result.skeleton;
        if (auto ok = checkBeforeMerging(skeleton, m_params); m_meshes && !ok)
            return ok;
        return cached(m_cache.simplified, m_hashes[Stage::Simplified], m_progress,
                      [&]() -> Expected<SimplifiedSkeleton> {
                          return params.enabled ? simplify(skeleton, params.rotationThreshold,
                                                           m_progress.part(0.1, 0.12))
                                                : untouched(skeleton);
                      })
            .map([&](auto made) { m_result.simplified = std::move(made); });
    }
    Expected<void> sections()
    {
        m_progress.report(0.12);
        const Skeleton& skeleton = m_result.simplified->skeleton;
        if (auto ok = checkMeshSize(skeleton.size(), m_params); !ok)
            return ok;
        const int divisions = static_cast<int>(m_params.sections.lengthDivisions);
        return cached(m_cache.sections, m_hashes[Stage::Sections], m_progress,
                      [&]() -> Expected<SectionSet> {
                          return buildSections(skeleton, divisions, skeleton.rollOfEach());
                      })
            .map([&](auto made) { m_result.sections = std::move(made); });
    }
    Expected<void> branches()
    {
        const Skeleton& skeleton = m_result.simplified->skeleton;
        return cached(m_cache.branches, m_hashes[Stage::Mesh], m_progress,
                      [&] {
                          return meshBranches(skeleton, m_params, skeleton.rollOfEach(),
                                              m_progress.part(0.2, 0.9));
                      })
            .map([&](auto made) {
                m_result.branches = made->mesh;
                m_result.report = made->report;
                m_result.cuts = made->cuts;
                m_result.texture = made->texture;
            });
    }
    Expected<void> foliage()
    {
        const bool stands =
            m_params.leaf.shape != LeafShape::Faithful || m_params.fruit.kind != FruitKind::Faithful;
        const BranchMesh* const bark = stands ? m_result.branches.get() : nullptr;
        std::uint64_t hash = m_hashes[Stage::Foliage];
        if (bark) // which a draft has not: its foliage keeps a place of its own
            hash = StageHash(hash).add(m_hashes[Stage::Mesh]).value();
        if (hasDay(m_params.season) && m_params.leaf.season > 0.0) // which does not count then
            hash = StageHash(hash).add(true).value();
        const Skeleton& skeleton = m_result.simplified->skeleton;
        const auto placed = cached(m_cache.placed, hash, m_progress, [&] {
            return foliageOn(skeleton, m_params, bark, m_progress.part(0.9, 0.95));
        });
        RAMURE_TRY(placed);
        const bool isSketch = !bark && m_params.leaf.shape != LeafShape::Faithful;
        return cached(m_cache.foliage, StageHash(hash).add(m_hashes[Stage::Season]).value(), m_progress,
                      [&]() -> Expected<MeshedFoliage> {
                          return meshFoliage(m_result.simplified, m_params, *placed, isSketch);
                      })
            .map([&](auto made) {
                m_result.placed = *placed;
                m_result.foliage = made->foliage;
                m_result.leaves = made->leaves;
                m_result.apples = made->apples;
            });
    }

    const NodeParams& m_params;
    StageHashes m_hashes;
    C& m_cache;
    const Progress& m_progress;
    std::shared_ptr<const GrownSymbols> m_grown;
    double m_growSeconds = 0.0;
    std::shared_ptr<const FrozenTree> m_frozen; ///< null: the tree grows
    TreeResult m_result;
    bool m_meshes = true; ///< there will be sections and a mesh
};

} // namespace

TreePipeline::TreePipeline()
    : m_cache(std::make_unique<Cache>())
{
}

TreePipeline::~TreePipeline() = default;

template <class Run> static Expected<TreeResult> timed(const NodeParams& params, Run&& run)
{
    const auto start = std::chrono::steady_clock::now();
    RAMURE_TRY(checkParams(params));
    Expected<TreeResult> result = run();
    if (result)
        result->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

Expected<TreeResult> TreePipeline::evaluate(const NodeParams& params, Stage last, const Progress& progress)
{
    return timed(params, [&] { return Evaluation<Cache>(params, *m_cache, progress).run(last); });
}

Expected<TreeResult> TreePipeline::evaluateDraft(const NodeParams& params, const Progress& progress)
{
    return timed(params, [&] { return Evaluation<Cache>(params, *m_cache, progress).runDraft(); });
}

void TreePipeline::setCacheSize(std::size_t perStage)
{
    m_cache->forEach([&](auto& cache) { cache.setCapacity(perStage); });
}

void TreePipeline::setCacheBudget(std::size_t bytesPerStage)
{
    m_cache->forEach([&](auto& cache) { cache.setBudget(bytesPerStage); });
}

} // namespace ramure
