#include "core/lod/collision_chain.h"

#include "core/lod/billboard.h"
#include "core/math/reproducible.h"
#include <algorithm>
#include <numbers>

namespace ramure {
namespace {

constexpr double thickShare = 0.2; ///< of the thickest wood
constexpr double straight = 0.94;  ///< cosine of how far a run bends at most
constexpr double taper = 0.6;      ///< the thin end of a run over its thick end, at least
constexpr int sides = 8;
constexpr double pointShare = 0.5; ///< how far a piece goes beyond its ends, in its radius there

struct Run
{
    glm::dvec3 from, to;
    double thick, thin;
};

/// The pieces of wood that is at least so thick. A run goes on into the thickest child.
std::vector<Run> runsOf(const Skeleton& tree, double least)
{
    std::vector<Run> runs;
    std::vector<std::size_t> runOf(tree.size(), 0);
    std::vector<char> isContinued(tree.size(), 0);
    for (Index b = 0; b < tree.size(); ++b) {
        if (tree.a0[b] < least || !(glm::distance(tree.p0[b], tree.p1[b]) > 0.0))
            continue;
        const Index parent = tree.parent[b];
        const bool isOn = parent != noIndex && tree.a0[parent] >= least && !isContinued[parent];
        if (isOn) {
            Run& run = runs[runOf[parent]];
            const glm::dvec3 was = glm::normalize(run.to - run.from), now = tree.p1[b] - tree.p0[b];
            const bool isLast = run.to == tree.p0[b];
            if (isLast && glm::dot(was, glm::normalize(now)) > straight && tree.a1[b] > taper * run.thick &&
                tree.a0[b] <= run.thick) {
                isContinued[parent] = 1;
                runOf[b] = runOf[parent];
                run.to = tree.p1[b];
                run.thin = tree.a1[b];
                continue;
            }
        }
        runOf[b] = runs.size();
        runs.push_back({tree.p0[b], tree.p1[b], std::max(tree.a0[b], tree.a1[b]), tree.a1[b]});
    }
    return runs;
}

TriangleMesh pieceOf(const Run& run)
{
    TriangleMesh out;
    const glm::dvec3 along = glm::normalize(run.to - run.from);
    const ViewFrame frame = viewFrame(along);
    const double thin = std::max(run.thin, 0.1 * run.thick);
    out.positions.emplace_back(run.from - pointShare * run.thick * along);
    for (const auto& [middle, radius] : {std::pair(run.from, run.thick), std::pair(run.to, thin)})
        for (int k = 0; k < sides; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / sides;
            out.positions.emplace_back(
                middle + radius * (maths::cos(angle) * frame.right + maths::sin(angle) * frame.up));
        }
    out.positions.emplace_back(run.to + pointShare * thin * along);
    constexpr Index last = 2 * sides + 1;
    for (Index k = 0; k < sides; ++k) {
        const Index next = (k + 1) % sides, a = 1 + k, b = 1 + next, c = a + sides, d = b + sides;
        out.triangles.emplace_back(0, b, a);
        out.triangles.emplace_back(a, b, d);
        out.triangles.emplace_back(a, d, c);
        out.triangles.emplace_back(last, c, d);
    }
    return out;
}

} // namespace

std::vector<TriangleMesh> collisionChain(const Skeleton& tree)
{
    if (tree.size() == 0)
        return {};
    double least = thickShare * *std::ranges::max_element(tree.a0);
    std::vector<Run> runs = runsOf(tree, least);
    while (runs.size() > mostCollisionPieces) {
        least *= 1.15;
        runs = runsOf(tree, least);
    }
    std::vector<TriangleMesh> out;
    for (const Run& run : runs)
        out.push_back(pieceOf(run));
    return out;
}

} // namespace ramure
