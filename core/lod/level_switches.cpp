#include "core/lod/level_switches.h"

#include "core/math/box.h"
#include "core/math/reproducible.h"
#include <algorithm>
#include <limits>

namespace ramure {
namespace {

/// m: of a tree, or of details, that nobody sees.
constexpr double leastSize = 1e-9;

glm::dvec3 sizeOf(const TreeLevel& level)
{
    Box box;
    for (const auto& mesh : {level.bark, level.leaves, level.apples})
        if (mesh)
            for (const glm::vec3& p : mesh->positions)
                box.add(glm::dvec3(p));
    return glm::max(box.size(), glm::dvec3(leastSize));
}

} // namespace

LevelSwitches switchesOf(const std::vector<TreeLevel>& levels, const LevelOptions& options, double scale)
{
    const glm::dvec3 size = sizeOf(levels.front());
    // m in the scene where the tree is as high as the picture.
    const double filled = scale * size.y / (2.0 * maths::tan(0.5 * levelFovRad));
    const double aspect = std::max(size.x, size.z) / size.y * levelScreenHeight / levelScreenWidth;
    LevelSwitches out{{0.0}, {std::numeric_limits<double>::infinity()}, {}, {0.0}};
    double usual = usualShare, covered = 1.0;
    for (std::size_t i = 1; i < levels.size(); ++i, usual *= usualShareStep) {
        const double share = !options.shares.empty()      ? options.shares[i - 1]
                             : !options.distances.empty() ? filled / options.distances[i - 1]
                                                          : usual;
        out.shares.push_back(share);
        out.distances.push_back(options.distances.empty() ? filled / share : options.distances[i - 1]);
        covered = std::min(covered, share * share * aspect);
        out.coverage.push_back(covered);
        const double detail = std::max(levels[i].detail, leastSize) / size.y;
        out.unseen.push_back(std::max(out.unseen.back(), filled * detail * levelScreenHeight));
    }
    out.coverage.push_back(0.0);
    return out;
}

} // namespace ramure
