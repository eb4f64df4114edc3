#include "core/surface/foliage/leaf_damage.h"

#include "core/math/random.h"
#include "core/surface/foliage/leaf_table.h"
#include <glm/common.hpp>

namespace ramure {

void damageLeaves(const Skeleton& skeleton, double share, Foliage& foliage)
{
    if (!(share > 0.0))
        return;
    constexpr glm::vec3 yellow(0xB4, 0x9A, 0x3C), brown(0x7A, 0x56, 0x30);
    const glm::vec3 whole(leafColour(foliage.form.shape, foliage.form.turns));
    for (FoliageItem& leaf : foliage.leaves) {
        Random random(skeleton.key[leaf.branch], RandomStream::LeafDamage, leaf.number);
        if (random.unit() >= share)
            continue;
        const auto hue = static_cast<float>(random.unit()),
                   much = static_cast<float>(random.range(0.25, 0.8));
        leaf.size *= static_cast<float>(random.range(0.6, 0.95));
        leaf.tint =
            glm::mix(leaf.tint, glm::min(glm::mix(yellow, brown, hue) / whole, glm::vec3(1.0F)), much);
    }
}

} // namespace ramure
