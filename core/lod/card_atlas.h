/// \file
/// What cards show: twigs of a tree, or the whole of it, and where on one picture each card has its own. The
/// pictures are drawn from it when somebody needs them (spray_picture.h).
#pragma once

#include "core/lod/billboard.h"
#include "core/params/bark_params.h"
#include "core/surface/foliage/foliage.h"
#include <cstdint>
#include <memory>
#include <string>

namespace ramure {

/// A surface that cards show.
struct ShownSurface
{
    std::shared_ptr<const TriangleMesh> mesh;
    std::vector<FoliageItem> copies{};            ///< where it stands; empty: it stands once, where it is
    LeafForm leaf{.shape = LeafShape::Faithful};  ///< whose picture it wears; Faithful: none
    BarkParams bark{.family = BarkFamily::Plain}; ///< the same of bark; Plain: none
    glm::u8vec3 colour{255};                      ///< sRGB, where it wears no picture of bark; times its own
};

/// One card: a rectangle in the space of its surfaces, and its place in the picture.
struct ShownCard
{
    std::size_t from = 0, to = 0; ///< its surfaces, the second beside the last
    ViewFrame frame;              ///< it faces \c backward
    glm::dvec3 middle{0.0};
    glm::dvec2 half{0.0};            ///< m, half its sides
    glm::vec2 low{0.0F}, high{1.0F}; ///< of its picture, from below: 0..1
};

struct CardAtlas
{
    std::string name; ///< in names of files: "sprays_oak"
    std::vector<ShownSurface> surfaces;
    std::vector<ShownCard> cards;
    std::uint64_t hash = 0; ///< of all that the pictures hang on: hashOf()
};

std::uint64_t hashOf(const CardAtlas& atlas);

/// Free pixels about the picture of a card: so many of 1024. Colours go on there, and nothing is opaque.
inline constexpr double cardGutter = 4.0;

/// The card as two triangles with coordinates on the picture and normals; white.
TriangleMesh meshOf(const ShownCard& card);

} // namespace ramure
