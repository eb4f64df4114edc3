#include "core/scene/material.h"

#include "core/params/param_def.h"
#include "core/scene/object_mesh.h"
#include "core/surface/bark/bark_maps.h"
#include "core/surface/foliage/foliage.h"
#include "core/surface/foliage/leaf_table.h"
#include "core/surface/mesh/plain_colours.h"

namespace ramure {

/// A picture of the colour takes the place of the colour; one of the opacity opens the surface.
static void wear(Material& material, const PictureParams& pictures)
{
    material.pictures = pictures;
    if (!pictures.colour.empty())
        material.colour = glm::u8vec3(255);
    material.twoSided = material.twoSided || !pictures.opacity.empty();
}

Material barkMaterial(const BarkParams& bark, const PictureParams& pictures)
{
    Material out{"bark", plainBark, false, false};
    if (bark.family != BarkFamily::Plain) {
        out.name.append("_").append(
            findParam("bark.family")->items[static_cast<std::size_t>(bark.family)].name);
        out.colour = meanColour(bark);
        out.bark = bark;
    }
    wear(out, pictures);
    return out;
}

Material leavesMaterial(LeafShape shape, bool turn, const PictureParams& pictures)
{
    Material leaves{"leaves", plainLeaf, true, true};
    leaves.glint = 0.05f;
    leaves.through = 0.5f;
    leaves.variety = 0.45f;
    if (shape != LeafShape::Faithful) {
        leaves.name.append("_").append(
            findParam("foliage.leaf")->items[static_cast<std::size_t>(shape)].name);
        leaves.colour = leafColour(shape, turn);
        leaves.variety = 0.15f;
        leaves.tones = true;
        if (!turn) // the pictures are those of summer
            leaves.leaf = shape;
    }
    wear(leaves, pictures);
    return leaves;
}

Material leavesMaterial(const Foliage& foliage, const PictureParams& pictures)
{
    const LeafForm& form = foliage.form;
    Material leaves = leavesMaterial(form.shape, form.turns || form.onDay, pictures);
    if (!form.onDay)
        return leaves;
    leaves.colour = glm::u8vec3(255);
    leaves.through = 1.0f;
    leaves.pigments = true;
    leaves.mean = glm::u8vec3(foliage.meanColour + 0.5f);
    leaves.passed = glm::u8vec3(foliage.meanThrough + 0.5f);
    return leaves;
}

Material spraysMaterial(Material leaves, std::shared_ptr<const CardAtlas> sprays)
{
    leaves.name.append("_sprays");
    leaves.leaf = LeafShape::Faithful;
    leaves.colour = glm::u8vec3(255);
    leaves.sprays = std::move(sprays);
    return leaves;
}

Material billboardMaterial(std::shared_ptr<const CardAtlas> tree)
{
    Material out{"billboard", glm::u8vec3(255), false, true};
    out.sprays = std::move(tree);
    return out;
}

Material applesMaterial(FruitKind kind, const PictureParams& pictures)
{
    Material fruit{"fruit", plainFruit, true, false};
    if (kind != FruitKind::Faithful) {
        fruit.name =
            std::string("fruit_") + findParam("foliage.fruit")->items[static_cast<std::size_t>(kind)].name;
        fruit.colour = glm::u8vec3(255);
    }
    if (kind == FruitKind::Blossom) { // petals are thin
        fruit.phong = false;
        fruit.through = 0.8F;
    }
    wear(fruit, pictures);
    return fruit;
}

Material woodMaterial()
{
    Material wood{"wood", {0xE2, 0xC5, 0x98}, false, false};
    wood.tones = true;
    return wood;
}

Material nodeMaterial(const Node& node, const NodeParams& params)
{
    const bool mayBeOpen = node.mesh || isOpenSurface(node); // what was read may be open anywhere
    Material out{"surface", glm::u8vec3(params.surface.color * 255.0 + 0.5), node.kind != NodeKind::Terrain,
                 mayBeOpen};
    wear(out, params.surfacePictures);
    return out;
}

} // namespace ramure
