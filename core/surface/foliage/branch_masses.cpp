#include "core/surface/foliage/branch_masses.h"

namespace ramure {

static constexpr double appleMass = 0.075;

std::vector<double> branchMasses(const Skeleton& skeleton, const Foliage& foliage)
{
    std::vector<double> masses = skeleton.a1;
    std::vector<bool> carriesApple(masses.size(), false);
    for (const FoliageItem& apple : foliage.apples)
        if (apple.branch < masses.size())
            carriesApple[apple.branch] = true;
    for (std::size_t i = masses.size(); i-- > 0;) {
        masses[i] += carriesApple[i] ? appleMass : 0.0;
        if (skeleton.parent[i] != noIndex)
            masses[skeleton.parent[i]] += masses[i];
    }
    return masses;
}

} // namespace ramure
