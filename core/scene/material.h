/// \file
/// The look of surfaces: the three parts of a tree, and every other node by its kind and its parameters. All
/// code that draws or writes a surface asks here and guesses nothing.
#pragma once

#include "core/params/bark_params.h"
#include "core/params/fruit_params.h"
#include "core/params/leaf_params.h"
#include "core/params/picture_params.h"
#include <glm/vec3.hpp>
#include <memory>
#include <string>

namespace ramure {

struct Foliage;
struct Node;
struct NodeParams;
struct CardAtlas;

struct Material
{
    std::string name;
    glm::u8vec3 colour{255}; ///< sRGB; triangles that have a colour of their own are tinted by it
    bool phong = false;      ///< with highlights; else Lambert (SPEC A3)
    bool twoSided = false;   ///< open surfaces, seen from behind as well
    float glint = 0.22f;     ///< strength of the highlights
    float through = 0.0f;    ///< share of the light from behind that shines through: of leaves
    float variety = 0.0f;    ///< how far the colour goes from branch to branch
    bool tones = false;      ///< the colours of triangles are its own, a little darker: it stays one material
    /// Of leaves on a day of the year: the colours of the mesh are whole ones that pigments give, and what
    /// shines through follows from them (leaf_pigments.h).
    bool pigments = false;
    bool hidden = false;                       ///< what wears it is not seen: leaves of a winter
    glm::u8vec3 mean{255}, passed{255};        ///< sRGB, if so: of all leaves, and what shines through them
    BarkParams bark{};                         ///< for bark: its pictures, if it has a family
    LeafShape leaf = LeafShape::Faithful;      ///< for leaves: their pictures, if a plant's
    std::shared_ptr<const CardAtlas> sprays{}; ///< for cards: what their pictures show
    PictureParams pictures{};                  ///< image files that replace generated pictures
    bool operator==(const Material&) const = default;
};

/// Returns the material of bark; its colour is the mean of the bark's picture.
Material barkMaterial(const BarkParams& bark = {}, const PictureParams& pictures = {});
/// Returns the material of leaves. Leaves of a plant have a name of their own, leaves_birch, and the colours
/// of their mesh are tones. \param turn the season is not summer: tones refer to the brightest colour of the
/// year.
Material leavesMaterial(LeafShape shape = LeafShape::Faithful, bool turn = false,
                        const PictureParams& pictures = {});
/// Returns the material of a tree's leaves as they are, on a day of the year or not.
Material leavesMaterial(const Foliage& foliage, const PictureParams& pictures = {});
/// Returns the material of the cards of a level, on which twigs of \p leaves are seen.
Material spraysMaterial(Material leaves, std::shared_ptr<const CardAtlas> sprays);
/// Returns the material of the cards of a billboard.
Material billboardMaterial(std::shared_ptr<const CardAtlas> tree);
/// Fruit and flowers bring colours of their own.
Material applesMaterial(FruitKind kind = FruitKind::Faithful, const PictureParams& pictures = {});
/// Returns the material of wood that a cut lays open. The colours of its mesh are tones.
Material woodMaterial();
/// Returns the material of a node that is no tree. \param params at the time (paramsAt).
Material nodeMaterial(const Node& node, const NodeParams& params);

} // namespace ramure
