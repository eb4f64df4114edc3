#include "core/pipeline/bark_feet.h"

#include "core/base/parallel.h"
#include "core/surface/foliage/bark_place.h"

namespace ramure {
namespace {

constexpr std::size_t itemsAtOnce = 256;

using Tubes = std::vector<std::span<const glm::uvec3>>;

/// By branch. Those that a repair made part of another have that one's.
Tubes tubesOf(const BranchMesh& branches, std::size_t count)
{
    Tubes tubes = trianglesOfTubes(branches, count);
    for (const RepairNote& note : branches.repairs)
        if (note.branch < count && note.other < count && tubes[note.branch].empty())
            tubes[note.branch] = tubes[note.other];
    return tubes;
}

/// \param reach from an item's position along its own +Y to its foot, for a size of 1.
void move(std::vector<FoliageItem>& items, double reach, const TriangleMesh& mesh, const Tubes& tubes,
          const Progress& progress)
{
    parallelFor(items.size(), itemsAtOnce, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end && !progress.cancelled(); ++i) {
            FoliageItem& item = items[i];
            const std::span<const glm::uvec3> tube = tubes[item.branch];
            if (tube.empty())
                continue;
            const glm::dvec3 foot =
                item.position + item.orientation * glm::dvec3(0.0, reach * double(item.size), 0.0);
            const BarkPlace place = nearestOnBark(mesh, tube, foot);
            const glm::dvec3 on = place.shares.x * glm::dvec3(mesh.positions[place.triangle.x]) +
                                  place.shares.y * glm::dvec3(mesh.positions[place.triangle.y]) +
                                  place.shares.z * glm::dvec3(mesh.positions[place.triangle.z]);
            item.position += on - foot;
        }
    });
}

} // namespace

void standOnBark(Foliage& foliage, const BranchMesh& branches, std::size_t branchCount, double alpha,
                 const Progress& progress)
{
    const Tubes tubes = tubesOf(branches, branchCount);
    if (foliage.form.shape != LeafShape::Faithful)
        move(foliage.leaves, 0.0, branches.mesh, tubes, progress);
    if (foliage.fruit.kind != FruitKind::Faithful)
        move(foliage.apples, fruitRadius(foliage.fruit, alpha) * fruitReach(foliage.fruit), branches.mesh,
             tubes, progress);
}

} // namespace ramure
