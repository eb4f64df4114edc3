#include "core/surface/check/self_intersections.h"

#include "core/base/parallel_chunks.h"
#include "core/math/box_pairs.h"
#include "core/math/exact_predicates.h"
#include "core/math/triangle_pairs.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace ramure {
namespace {

constexpr std::size_t listedPerKind = 10'000;
/// More colliding pairs of branches than anybody reads; only a tangle has them.
constexpr std::size_t branchPairsPerChunk = 20'000;
constexpr std::size_t facesBoxedAtATime = 16'384;

/// The up to three branches that a triangle belongs to.
struct Owners
{
    std::array<Index, 3> branch{noIndex, noIndex, noIndex};
    std::size_t count = 0;
};

/// What one chunk found.
struct Found
{
    std::array<std::uint64_t, pairKindCount> counts{};
    std::array<std::vector<FacePair>, pairKindCount> pairs;
    std::vector<CrossingBranches> branches; ///< places are sums here
    bool full = false;                      ///< a tangle: further pairs of branches are not listed
};

bool before(const CrossingBranches& a, const CrossingBranches& b)
{
    return a.first != b.first ? a.first < b.first : a.second < b.second;
}

/// Adds up what is about the same two branches. The order of the entries decides how the sums are rounded:
/// it is the same on any number of threads.
void addUp(std::vector<CrossingBranches>& list)
{
    std::stable_sort(list.begin(), list.end(), before);
    std::size_t kept = 0;
    for (const CrossingBranches& entry : list) {
        if (kept > 0 && !before(list[kept - 1], entry)) {
            list[kept - 1].facePairs += entry.facePairs;
            list[kept - 1].place += entry.place;
        } else {
            list[kept++] = entry;
        }
    }
    list.resize(kept);
}

class Finder
{
public:
    Finder(const TriangleMesh& mesh, const std::vector<Index>& parent, std::vector<Index> depth)
        : m_mesh(mesh)
        , m_parent(parent)
        , m_depth(std::move(depth))
    {
    }

    Expected<SelfIntersections> run(unsigned threads, const Progress& progress)
    {
        const auto boxes = faceBoxes(threads, progress.part(0.0, 0.05));
        RAMURE_TRY(boxes);
        const BoxPairs pairs(*boxes);
        progress.report(0.15);
        std::vector<Found> found(pairs.chunkCount());
        const bool all = forChunks(found.size(), threads, progress.part(0.15, 0.98), [&](std::size_t chunk) {
            Found& here = found[chunk];
            pairs.inChunk(chunk, [&](Index i, Index j) { test(std::min(i, j), std::max(i, j), here); });
            addUp(here.branches);
        });
        if (!all)
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        return gather(found);
    }

private:
    [[nodiscard]] Corners3 corners(const glm::uvec3& t) const
    {
        return {m_mesh.positions[t.x], m_mesh.positions[t.y], m_mesh.positions[t.z]};
    }

    /// Of the triangles that have an area.
    [[nodiscard]] Expected<std::vector<PrimitiveBounds>> faceBoxes(unsigned threads,
                                                                   const Progress& progress) const
    {
        const std::size_t faces = m_mesh.triangles.size();
        std::vector<std::vector<PrimitiveBounds>> parts((faces + facesBoxedAtATime - 1) / facesBoxedAtATime);
        const bool all = forChunks(parts.size(), threads, progress, [&](std::size_t chunk) {
            const std::size_t end = std::min(faces, (chunk + 1) * facesBoxedAtATime);
            parts[chunk].reserve(end - chunk * facesBoxedAtATime);
            for (std::size_t f = chunk * facesBoxedAtATime; f < end; ++f) {
                const auto [a, b, c] = corners(m_mesh.triangles[f]);
                const glm::vec3 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
                // Not finite where one of them is not.
                const glm::dvec3 sum = glm::dvec3(a) + glm::dvec3(b) + glm::dvec3(c);
                if (std::isfinite(sum.x + sum.y + sum.z) && viewOf(a, b, c) >= 0)
                    parts[chunk].push_back({low, high, static_cast<Index>(f)});
            }
        });
        if (!all)
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        std::vector<PrimitiveBounds> boxes;
        boxes.reserve(faces);
        for (const auto& part : parts)
            boxes.insert(boxes.end(), part.begin(), part.end());
        return boxes;
    }

    void test(Index i, Index j, Found& found) const
    {
        const glm::uvec3 &s = m_mesh.triangles[i], &t = m_mesh.triangles[j];
        if (!facesMeet(m_mesh.positions, s, t))
            return;
        const Owners a = owners(s), b = owners(t);
        const PairKind kind = kindOf(a, b);
        const auto k = static_cast<std::size_t>(kind);
        ++found.counts[k];
        if (found.pairs[k].size() < listedPerKind)
            found.pairs[k].push_back({kind, i, j});
        if (kind == PairKind::Far)
            noteBranches(a.branch[0], b.branch[0], corners(s), corners(t), found);
    }

    static void noteBranches(Index a, Index b, const Corners3& s, const Corners3& t, Found& found)
    {
        const auto lowest = [](const Corners3& c) { return glm::min(c[0], glm::min(c[1], c[2])); };
        const auto highest = [](const Corners3& c) { return glm::max(c[0], glm::max(c[1], c[2])); };
        const glm::dvec3 low(glm::max(lowest(s), lowest(t))), high(glm::min(highest(s), highest(t)));
        const CrossingBranches entry{std::min(a, b), std::max(a, b), 1, 0.5 * (low + high)};
        std::vector<CrossingBranches>& list = found.branches;
        // As a rule the pair before was of the same two.
        if (!list.empty() && list.back().first == entry.first && list.back().second == entry.second) {
            ++list.back().facePairs;
            list.back().place += entry.place;
            return;
        }
        if (found.full)
            return;
        list.push_back(entry);
        if (list.size() < 2 * branchPairsPerChunk)
            return;
        addUp(list);
        found.full = list.size() >= branchPairsPerChunk;
    }

    [[nodiscard]] Owners owners(const glm::uvec3& t) const
    {
        Owners result;
        if (m_parent.empty())
            return result;
        Index deepest = 0;
        for (int k = 0; k < 3; ++k)
            deepest = std::max(deepest, m_depth[m_mesh.branch[t[k]]]);
        for (int k = 0; k < 3; ++k) {
            const Index b = m_mesh.branch[t[k]];
            const auto end = result.branch.begin() + static_cast<std::ptrdiff_t>(result.count);
            if (m_depth[b] == deepest && std::find(result.branch.begin(), end, b) == end)
                result.branch[result.count++] = b;
        }
        return result;
    }

    [[nodiscard]] PairKind kindOf(const Owners& a, const Owners& b) const
    {
        if (m_parent.empty())
            return PairKind::Same;
        PairKind closest = PairKind::Far;
        for (std::size_t i = 0; i < a.count; ++i)
            for (std::size_t j = 0; j < b.count; ++j)
                closest = std::min(closest, kindOf(a.branch[i], b.branch[j]));
        return closest;
    }

    [[nodiscard]] PairKind kindOf(Index a, Index b) const
    {
        if (a == b)
            return PairKind::Same;
        if (m_parent[a] == m_parent[b] && m_parent[a] != noIndex)
            return PairKind::Siblings;
        return m_parent[a] == b || m_parent[b] == a ? PairKind::ParentChild : PairKind::Far;
    }

    [[nodiscard]] SelfIntersections gather(std::vector<Found>& found) const
    {
        SelfIntersections all;
        all.kindsKnown = !m_parent.empty();
        std::vector<FacePair> ofKind;
        for (std::size_t k = 0; k < std::size_t(pairKindCount); ++k) {
            ofKind.clear();
            for (const Found& part : found) {
                all.counts[k] += part.counts[k];
                ofKind.insert(ofKind.end(), part.pairs[k].begin(), part.pairs[k].end());
            }
            std::sort(ofKind.begin(), ofKind.end(), [](const FacePair& a, const FacePair& b) {
                return a.first != b.first ? a.first < b.first : a.second < b.second;
            });
            ofKind.resize(std::min(ofKind.size(), listedPerKind));
            all.pairs.insert(all.pairs.end(), ofKind.begin(), ofKind.end());
        }
        for (Found& part : found) {
            all.branches.insert(all.branches.end(), part.branches.begin(), part.branches.end());
            part.branches = {};
        }
        addUp(all.branches);
        for (CrossingBranches& entry : all.branches)
            entry.place /= static_cast<double>(entry.facePairs);
        return all;
    }

    const TriangleMesh& m_mesh;
    const std::vector<Index>& m_parent;
    std::vector<Index> m_depth;
};

tl::unexpected<Error> bad()
{
    return fail(ErrorCode::Invalid, RAMURE_NOOP("the mesh refers to something that it does not have"));
}

/// Of every branch, its distance from the root. A chained sibling may stand before its parent. Error:
/// Invalid (a parent out of range, a circle).
Expected<std::vector<Index>> depthsOf(const std::vector<Index>& parent)
{
    constexpr Index unknown = noIndex, open = noIndex - 1;
    std::vector<Index> depth(parent.size(), unknown), way;
    for (Index i = 0; i < parent.size(); ++i) {
        Index at = i;
        for (; at != noIndex && at < parent.size() && depth[at] == unknown; at = parent[at]) {
            depth[at] = open;
            way.push_back(at);
        }
        if (at != noIndex && (at >= parent.size() || depth[at] == open))
            return bad();
        for (Index below = at == noIndex ? 0 : depth[at] + 1; !way.empty(); way.pop_back())
            depth[way.back()] = below++;
    }
    return depth;
}

Expected<void> checkInput(const TriangleMesh& mesh, const std::vector<Index>& parent)
{
    const Index vertices = mesh.vertexCount();
    Index highest = 0;
    for (const glm::uvec3& t : mesh.triangles)
        highest = std::max({highest, t.x, t.y, t.z});
    if (!mesh.triangles.empty() && highest >= vertices)
        return bad();
    if (parent.empty())
        return {};
    const bool owned =
        mesh.branch.size() == mesh.positions.size() &&
        std::all_of(mesh.branch.begin(), mesh.branch.end(), [&](Index b) { return b < parent.size(); });
    return owned ? Expected<void>{} : bad();
}

} // namespace

Expected<SelfIntersections> findSelfIntersections(const TriangleMesh& mesh, const std::vector<Index>& parent,
                                                  unsigned threads, const Progress& progress)
{
    static const std::vector<Index> none;
    const std::vector<Index>& known = mesh.branch.empty() ? none : parent;
    RAMURE_TRY(checkInput(mesh, known));
    auto depths = depthsOf(known);
    RAMURE_TRY(depths);
    return Finder(mesh, known, std::move(*depths)).run(threads, progress);
}

std::vector<Index> repairedParents(const Skeleton& skeleton, const std::vector<RepairNote>& repairs)
{
    std::vector<Index> standsFor(skeleton.size()), parent = skeleton.parent;
    for (Index i = 0; i < skeleton.size(); ++i)
        standsFor[i] = i;
    for (const RepairNote& note : repairs) {
        if (note.kind == SkeletonRepair::SiblingsMerged || note.kind == SkeletonRepair::ZeroLengthContracted)
            standsFor[note.branch] = note.other;
        else if (note.kind == SkeletonRepair::SiblingChained || note.kind == SkeletonRepair::RootsJoined)
            parent[note.branch] = note.other;
    }
    for (Index& p : parent)
        while (p != noIndex && standsFor[p] != p)
            p = standsFor[p];
    return parent;
}

} // namespace ramure
