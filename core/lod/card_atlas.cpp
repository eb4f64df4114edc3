#include "core/lod/card_atlas.h"

#include "core/math/stage_hash.h"
#include "core/pipeline/stage_hashes.h"
#include <string_view>

namespace ramure {

std::uint64_t hashOf(const CardAtlas& atlas)
{
    StageHash hash(2);
    const auto addAll = [&hash](const auto& values) {
        hash.add(std::string_view(reinterpret_cast<const char*>(values.data()),
                                  values.size() * sizeof(values[0])));
    };
    for (const ShownSurface& surface : atlas.surfaces) {
        addAll(surface.mesh->positions);
        addAll(surface.mesh->colours);
        for (const FoliageItem& copy : surface.copies) {
            for (int k = 0; k < 3; ++k)
                hash.add(copy.position[k]).add(double(copy.tint[k]));
            for (int k = 0; k < 4; ++k)
                hash.add(copy.orientation[k]);
            hash.add(double(copy.size)).add(double(copy.tone));
        }
        hash.add(std::uint64_t(surface.leaf.shape)).add(surface.leaf.onDay).add(surface.leaf.turns);
        hash.add(barkHash(surface.bark));
        for (int k = 0; k < 3; ++k)
            hash.add(surface.colour[k]);
    }
    for (const ShownCard& card : atlas.cards)
        for (const double number : {card.half.x, card.half.y, double(card.low.x), double(card.low.y),
                                    double(card.high.x), double(card.high.y)})
            hash.add(number);
    return hash.value();
}

TriangleMesh meshOf(const ShownCard& card)
{
    TriangleMesh out;
    for (const glm::vec2& at : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)}) {
        const glm::dvec2 away = card.half * (2.0 * glm::dvec2(at) - 1.0);
        out.positions.emplace_back(card.middle + away.x * card.frame.right + away.y * card.frame.up);
        out.normals.emplace_back(card.frame.backward);
        out.uv.push_back(glm::mix(card.low, card.high, at));
    }
    out.triangles = {{0, 1, 2}, {0, 2, 3}};
    out.colours.assign(2, glm::u8vec3(255));
    return out;
}

} // namespace ramure
