#include "core/lod/growth_mesh.h"

#include "core/generators/growth/whole_life.h"
#include "core/generators/sources.h"
#include "core/generators/tree_life.h"
#include "core/lod/life_pose.h"
#include "core/lod/tree_levels.h"
#include "core/params/tree_edit_table.h"
#include "core/rig/pose/skin.h"
#include "core/surface/mesh/normals.h"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace ramure {
namespace {

/// Triangles that an axis needs, about, with its bends and its fork.
constexpr double trianglesOfAxis = 60.0;
/// Ages at which axes are weighed against each other.
constexpr int weighings = 9;

tl::unexpected<Error> refused(const char* path, const char* text, std::vector<std::string> args = {})
{
    return fail(Error{ErrorCode::Invalid, text, std::move(args), {}, path});
}

Expected<void> check(const NodeParams& params, const GrowthMeshOptions& options)
{
    if (growthYears(params) <= 0.0 || params.growth.habit != GrowthHabit::Branching)
        return refused("generator.kind",
                       RAMURE_NOOP("only a tree that grows by years and branches can grow as "
                                   "one mesh"));
    for (const TreeEdit& edit : params.edits)
        if (edit.enabled && !(edit.year > 0.0 && canLiveOn(edit)))
            return refused(
                "edits",
                RAMURE_NOOP("the step \"%1\" is not part of the tree's life: it cannot grow with it"),
                {infoOf(edit.operation).label});
    if (options.keys < 2 || options.keys > mostGrowthKeys)
        return refused("keys", RAMURE_NOOP("2 to %1 key shapes expected"), {std::to_string(mostGrowthKeys)});
    if (!(options.from >= 0.25) || !(options.from < params.growth.age))
        return refused(
            "growth.age",
            RAMURE_NOOP("the growth begins at 0.25 years or later, and before the tree's own age"));
    return {};
}

class GrowthMesher
{
public:
    GrowthMesher(const NodeParams& params, const GrowthMeshOptions& options, const GrowthHistory& history)
        : m_params(params)
        , m_options(options)
        , m_history(history)
    {
    }

    Expected<GrowthMesh> run(const Progress& progress)
    {
        m_life = wholeLife(m_history, wantedAxes());
        if (m_life.skeleton.empty())
            return refused("growth.age", RAMURE_NOOP("nothing has grown"));
        RAMURE_TRY(build(progress.part(0.0, 0.6)));
        auto skin = bindBranches(*m_level.branches, m_level.wood.skeleton, true);
        RAMURE_TRY(skin);
        const LifePose pose(m_history, m_life, m_level.wood);
        RAMURE_TRY(chooseKeys(pose, progress.part(0.6, 0.9)));
        GrowthMesh out;
        out.error = m_error;
        for (const std::size_t key : m_keys)
            out.keys.push_back(keyOf(pose.at(m_ages[key]), *skin, m_ages[key]));
        TriangleMesh bark = *m_level.bark;
        bark.positions = out.keys.back().positions;
        bark.normals = out.keys.back().normals;
        if (m_options.texture)
            RAMURE_TRY(addTexture(bark, progress.part(0.9, 1.0)));
        out.bark = std::make_shared<const TriangleMesh>(std::move(bark));
        return out;
    }

private:
    [[nodiscard]] std::vector<bool> wantedAxes() const
    {
        std::vector<double> ages;
        for (int i = 0; i < weighings; ++i)
            ages.push_back(std::lerp(m_options.from, m_params.growth.age, double(i) / (weighings - 1)));
        const std::vector<double> share = greatestShares(m_history, ages);
        std::vector<Index> order(share.size());
        std::iota(order.begin(), order.end(), Index(0));
        // What carries an axis has at least its share, and stands before it.
        std::ranges::stable_sort(order, [&](Index a, Index b) { return share[a] > share[b]; });
        order.resize(std::min(order.size(),
                              std::max<std::size_t>(1, static_cast<std::size_t>(double(m_options.triangles) /
                                                                                trianglesOfAxis))));
        std::vector<bool> wanted(share.size(), false);
        for (const Index axis : order)
            wanted[axis] = share[axis] > 0.0;
        return wanted;
    }

    /// The mesh of all ages, by the mesher of the levels of detail. A small tree has no mesh as fine as
    /// asked.
    Expected<void> build(const Progress& progress)
    {
        TreeResult tree;
        tree.skeleton = tree.grown = std::make_shared<const Skeleton>(m_life.skeleton);
        tree.simplified = std::make_shared<const SimplifiedSkeleton>(simplify(m_life.skeleton, 0.0));
        LevelOptions one;
        one.count = 1;
        for (std::int64_t triangles = m_options.triangles;; triangles /= 2) {
            one.budgets = {triangles};
            auto levels = treeLevels(tree, m_params, one, {true, false, false, false}, progress);
            if (!levels && levels.error().code == ErrorCode::Limit && triangles >= 2 * leastBudget)
                continue;
            RAMURE_TRY(levels);
            m_level = std::move(levels->front());
            return {};
        }
    }

    /// That of the wood as it is at last, with its own radii.
    Expected<void> addTexture(TriangleMesh& bark, const Progress& progress) const
    {
        auto grown = std::make_shared<BranchMesh>(*m_level.branches);
        grown->mesh.positions = bark.positions;
        for (TubeAxis& axis : grown->axes) {
            axis.a0 /= WholeLife::slenderness;
            axis.a1 /= WholeLife::slenderness;
        }
        const auto texture = TextureStage(std::move(grown)).coordinates(m_params.texture, progress);
        RAMURE_TRY(texture);
        wear(bark, **texture);
        return {};
    }

    /// One key after the other where the tree is farthest from what there is.
    Expected<void> chooseKeys(const LifePose& pose, const Progress& progress)
    {
        const double last = m_params.growth.age;
        m_ages = {m_options.from};
        for (double age = std::floor(m_options.from) + 1.0; age < last; age += 1.0)
            m_ages.push_back(age);
        m_ages.push_back(last);
        for (const double age : m_ages) {
            progress.report((age - m_options.from) / (last - m_options.from));
            if (progress.cancelled())
                return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
            m_ends.push_back(pose.at(age).ends());
        }
        m_keys = {0, m_ages.size() - 1};
        while (true) {
            m_error = 0.0;
            std::size_t worst = 0;
            for (std::size_t k = 0; k + 1 < m_keys.size(); ++k)
                for (std::size_t i = m_keys[k] + 1; i < m_keys[k + 1]; ++i)
                    if (const double miss = missAt(i, m_keys[k], m_keys[k + 1]); miss > m_error) {
                        m_error = miss;
                        worst = i;
                    }
            if (m_error <= 0.0 || m_keys.size() >= std::size_t(m_options.keys))
                return {};
            m_keys.insert(std::ranges::upper_bound(m_keys, worst), worst);
        }
    }

    /// m: how far the living ends at an age are at most from the straight way between two others. What is
    /// shed on that way counts for nothing.
    [[nodiscard]] double missAt(std::size_t age, std::size_t before, std::size_t after) const
    {
        const double part = (m_ages[age] - m_ages[before]) / (m_ages[after] - m_ages[before]);
        double most = 0.0;
        for (std::size_t b = 0; b < m_ends[age].size(); ++b) {
            const LifePose::End &from = m_ends[before][b], &to = m_ends[after][b], &now = m_ends[age][b];
            if (std::max(from.reach, now.reach) > to.reach)
                continue;
            most = std::max(most, glm::distance(now.at, glm::mix(from.at, to.at, part)));
        }
        return most;
    }

    [[nodiscard]] GrowthKey keyOf(const LifePose::Placed& placed, const Skin& skin, double age) const
    {
        TriangleMesh mesh = *m_level.bark;
        placed.move(m_level.bark->positions, skin, mesh.positions);
        computeNormals(mesh);
        return {age, std::move(mesh.positions), std::move(mesh.normals)};
    }

    const NodeParams& m_params;
    const GrowthMeshOptions& m_options;
    const GrowthHistory& m_history;
    WholeLife m_life;
    TreeLevel m_level;
    std::vector<double> m_ages;                     ///< all that are looked at
    std::vector<std::vector<LifePose::End>> m_ends; ///< by those
    std::vector<std::size_t> m_keys;                ///< numbers of those
    double m_error = 0.0;
};

} // namespace

Expected<GrowthMesh> growthMesh(const NodeParams& params, const GrowthMeshOptions& options,
                                const Progress& progress)
{
    RAMURE_TRY(check(params, options));
    const auto grown = growSymbols(params, progress.part(0.0, 0.3));
    RAMURE_TRY(grown);
    return GrowthMesher(params, options, *grown->history).run(progress.part(0.3, 1.0));
}

} // namespace ramure
