#include "core/qt/session/export/foliage_copies.h"

#include "core/params/param_def.h"
#include "core/params/source_facts.h"
#include "core/surface/foliage/foliage_texture.h"
#include "core/surface/foliage/place_foliage.h"
#include <algorithm>

namespace ramure {
namespace {

const char* kindName(const char* param, std::size_t kind)
{
    return findParam(param)->items[kind].name;
}

glm::dmat4 placeOf(const FoliageItem& item)
{
    glm::dmat4 place = glm::mat4_cast(item.orientation);
    for (int column = 0; column < 3; ++column)
        place[column] *= double(item.size);
    place[3] = glm::dvec4(item.position, 1.0);
    return place;
}

/// \param skin of the merged mesh, whose pieces are the items in their order; null: they rest.
void addCopies(ExportCopies& out, const FoliageInstances& all, const std::vector<FoliageItem>& items,
               const Skin* skin)
{
    const NodeMotion& motion = all.motion;
    const bool hasBones = skin && motion.bones && !items.empty(), moves = hasBones && !all.rides;
    const auto perItem = static_cast<Index>(hasBones ? skin->vertices / items.size() : 0);
    out.copies.reserve(items.size());
    for (const FoliageItem& item : items) {
        const Index first = perItem * static_cast<Index>(out.copies.size());
        const glm::dmat4 place = placeOf(item);
        out.copies.push_back(
            {moves ? skinMatrix(skin->of(first), *motion.bones, motion.method) * place : place,
             item.tone * item.tint, item.branch, all.skeleton.key[item.branch], item.number});
        if (hasBones && all.rides)
            out.follows.push_back(skin->of(first));
    }
}

} // namespace

ExportCopies leafInstances(const FoliageInstances& all)
{
    ExportCopies out;
    out.kind = kindName("foliage.leaf", static_cast<std::size_t>(all.foliage.form.shape));
    TriangleMesh shape = oneLeaf(all.foliage.form, trunkRadius(all.params), all.model);
    if (all.texture && all.model == FoliageModel::Fine)
        addLeafTexture(shape, all.foliage.form);
    out.shape = std::make_shared<const TriangleMesh>(std::move(shape));
    addCopies(out, all, all.foliage.leaves, all.motion.leaves.get());
    return out;
}

ExportCopies appleInstances(const FoliageInstances& all)
{
    ExportCopies out;
    out.kind = kindName("foliage.fruit", static_cast<std::size_t>(all.foliage.fruit.kind));
    TriangleMesh shape = oneApple(all.foliage.fruit, trunkRadius(all.params), all.model);
    if (all.texture && all.model == FoliageModel::Fine)
        addAppleTexture(shape, all.foliage.fruit);
    out.shape = std::make_shared<const TriangleMesh>(std::move(shape));
    addCopies(out, all, all.foliage.apples, all.motion.apples.get());
    return out;
}

} // namespace ramure
