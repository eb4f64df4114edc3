#include "core/pipeline/separate_branches.h"

#include "core/params/tree_edit_table.h"
#include "core/pipeline/branch_mover.h"
#include "core/pipeline/tree_context.h"
#include "core/skeleton/bend.h"
#include "core/skeleton/branch_steps.h"
#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace ramure {
namespace {

using Bends = std::map<std::uint64_t, glm::dvec3>; ///< by Skeleton::key, of the tree that it began with
using BranchPair = std::pair<std::uint64_t, std::uint64_t>; ///< keys

/// A tree with its bends, and what is wrong with its mesh.
struct Candidate
{
    Bends bends; ///< all branches that have one
    TreeResult tree;
    MeshAnalysis analysis;

    [[nodiscard]] const Skeleton& skeleton() const { return tree.simplified->skeleton; }
    [[nodiscard]] std::set<BranchPair> pairs() const
    {
        std::set<BranchPair> found;
        for (const Collision& c : analysis.collisions)
            found.emplace(skeleton().key[c.first], skeleton().key[c.second]);
        return found;
    }
};

bool isBetter(const Candidate& now, const Candidate& before)
{
    const auto measure = [](const Candidate& c) {
        return std::pair(c.analysis.collisions.size(), c.analysis.crossings.count(PairKind::Far));
    };
    return now.tree.report->valid && measure(now) < measure(before) &&
           now.analysis.crossings.aroundForks() <= before.analysis.crossings.aroundForks();
}

class Separator
{
public:
    Separator(TreePipeline& pipeline, const NodeParams& params, const SeparateOptions& options,
              const Progress& progress)
        : m_pipeline(pipeline)
        , m_params(params)
        , m_options(options)
        , m_progress(progress)
    {
    }

    Expected<Separation> run()
    {
        auto best = look({});
        RAMURE_TRY(best);
        m_start = best->tree;
        m_axes = axesOf(*m_start.skeleton);
        Separation result;
        result.before = best->analysis.collisions.size();
        for (int round = 1; round < m_options.rounds && !best->analysis.collisions.empty(); ++round) {
            auto next = improved(*best);
            RAMURE_TRY(next);
            if (!*next)
                break;
            best = std::move(**next);
            const double solved = 1.0 - double(best->analysis.collisions.size()) /
                                            double(std::max<std::size_t>(result.before, 1));
            m_progress.report(std::max(solved, double(round) / double(m_options.rounds)));
        }
        result.steps = stepsOf(best->bends);
        result.rest = best->analysis.collisions;
        m_progress.report(1.0);
        return result;
    }

private:
    std::vector<TreeEdit> stepsOf(const Bends& bends) const
    {
        if (bends.empty())
            return {};
        const Skeleton& skeleton = m_start.simplified->skeleton;
        std::vector<glm::dvec3> turns(skeleton.size(), glm::dvec3(0.0));
        for (Index i = 0; i < skeleton.size(); ++i)
            if (const auto found = bends.find(skeleton.key[i]); found != bends.end())
                turns[i] = found->second;
        const EditContext tree = contextOf(m_start, m_params);
        std::vector<TreeEdit> steps;
        for (TreeEdit& step : bendSteps(m_axes, *m_start.simplified, turns))
            if (auto ready = tree.prepared(std::move(step), true))
                steps.push_back(std::move(*ready));
        return steps;
    }
    Expected<Candidate> look(const Bends& bends)
    {
        const Progress quiet{m_progress.stop, {}};
        auto tree = m_pipeline.evaluate(withSteps(m_params, stepsOf(bends)), Stage::Mesh, quiet);
        RAMURE_TRY(tree);
        auto analysis = analyseMesh(*tree->branches, tree->simplified->skeleton, m_options.threads, quiet);
        RAMURE_TRY(analysis);
        return Candidate{bends, std::move(*tree), std::move(*analysis)};
    }

    /// One round: turns for all pairs, and as much of that taken back as made things worse. Then other
    /// branches are turned. Nothing where no turn helps.
    Expected<std::optional<Candidate>> improved(const Candidate& from)
    {
        for (; m_failed < m_options.rounds; ++m_failed) {
            Bends changes = proposed(from);
            if (changes.empty())
                break;
            for (int attempt = 0; attempt < 3 && !changes.empty(); ++attempt) {
                Bends bends = from.bends;
                for (const auto& [key, bend] : changes)
                    bends[key] = bend;
                auto next = look(bends);
                RAMURE_TRY(next);
                if (isBetter(*next, from))
                    return std::optional(std::move(*next));
                const std::set<std::uint64_t> guilty = suspects(from, *next, changes);
                m_banned.insert(guilty.begin(), guilty.end());
                std::erase_if(changes, [&](const auto& change) { return guilty.contains(change.first); });
            }
            for (const auto& change : changes)
                m_banned.insert(change.first);
        }
        return std::optional<Candidate>();
    }

    /// New bends by the model, the deepest pair first.
    Bends proposed(const Candidate& from)
    {
        const Skeleton& skeleton = from.skeleton();
        BranchMover mover(skeleton, repairedParents(skeleton, from.tree.branches->repairs),
                          {m_options.clearance, m_options.mostTurnRad});
        std::vector<glm::dvec3> bends(skeleton.size(), glm::dvec3(0.0));
        std::vector<bool> banned(skeleton.size(), false);
        for (Index i = 0; i < skeleton.size(); ++i) {
            if (const auto known = from.bends.find(skeleton.key[i]); known != from.bends.end())
                bends[i] = known->second;
            banned[i] = m_banned.contains(skeleton.key[i]);
        }
        std::vector<glm::dquat> turned = bendRotations(skeleton, bends);
        Bends changes;
        for (const Collision& collision : from.analysis.collisions) {
            if (m_progress.cancelled())
                break; // the mesh that comes next says so
            if (collision.depth > 0.0 && !mover.areClose(collision.first, collision.second))
                continue; // a turn before has parted them
            const auto turn = mover.partingTurn(collision.first, collision.second, banned);
            if (!turn)
                continue;
            mover.apply(*turn);
            for (const Index branch : mover.subtree(turn->branch))
                turned[branch] = glm::normalize(turn->rotation * turned[branch]);
            const Index parent = skeleton.parent[turn->branch];
            const glm::dquat base = parent == noIndex ? glm::dquat(1.0, 0.0, 0.0, 0.0) : turned[parent];
            changes[skeleton.key[turn->branch]] = bendVector(glm::conjugate(base) * turned[turn->branch]);
        }
        return changes;
    }

    /// The turned branches that carry one of a new pair, or stand at a fork where triangles cross; all where
    /// none of these explains it.
    std::set<std::uint64_t> suspects(const Candidate& from, const Candidate& next, const Bends& changes) const
    {
        const Skeleton& skeleton = next.skeleton();
        const std::set<BranchPair> before = from.pairs();
        std::set<Index> troubled;
        for (const Collision& c : next.analysis.collisions)
            if (!before.contains({skeleton.key[c.first], skeleton.key[c.second]}))
                troubled.insert({c.first, c.second});
        const TriangleMesh& mesh = next.tree.branches->mesh;
        const bool forksSuffer =
            next.analysis.crossings.aroundForks() > from.analysis.crossings.aroundForks();
        for (const FacePair& pair : next.analysis.crossings.pairs)
            if (forksSuffer && pair.kind != PairKind::Far)
                for (const Index face : {pair.first, pair.second})
                    for (int k = 0; k < 3; ++k)
                        troubled.insert(mesh.branch[mesh.triangles[face][k]]);
        std::set<std::uint64_t> guilty;
        for (Index at : troubled)
            for (; at != noIndex; at = skeleton.parent[at])
                if (changes.contains(skeleton.key[at]))
                    guilty.insert(skeleton.key[at]);
        if (guilty.empty())
            for (const auto& change : changes)
                guilty.insert(change.first);
        return guilty;
    }

    TreePipeline& m_pipeline;
    const NodeParams& m_params;
    const SeparateOptions& m_options;
    const Progress& m_progress;
    TreeResult m_start;               ///< before any bend of this treatment
    TreeAxes m_axes;                  ///< axes of its skeleton
    std::set<std::uint64_t> m_banned; ///< by key: turning them made things worse
    int m_failed = 0;
};

} // namespace

NodeParams withSteps(NodeParams params, std::span<const TreeEdit> steps)
{
    for (const TreeEdit& step : steps) {
        params.edits.push_back(step);
        params.edits.back().id = newEditId(std::span(params.edits).first(params.edits.size() - 1), step);
    }
    return params;
}

Expected<Separation> separateBranches(TreePipeline& pipeline, const NodeParams& params,
                                      const SeparateOptions& options, const Progress& progress)
{
    return Separator(pipeline, params, options, progress).run();
}

} // namespace ramure
