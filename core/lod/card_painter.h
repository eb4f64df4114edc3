/// \file
/// Draws surfaces straight (orthographic) onto samples, without OpenGL and without light: the same bytes on
/// every machine. Pictures of cards are made with it, and levels are compared.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/lod/card_atlas.h"
#include <optional>

namespace ramure {

/// What is seen at each sample of a rectangle; rows from below.
struct PaintedSamples
{
    PaintedSamples(int width, int height);
    [[nodiscard]] bool isCovered(std::size_t at) const;
    /// What is there stays behind all that is drawn later.
    void moveBack();

    int width, height;
    std::vector<float> depth;      ///< m towards the eye; minus infinity: nothing is there
    std::vector<glm::vec3> colour; ///< linear, 0..1
    std::vector<glm::vec3> normal; ///< unit, in the axes of the view; z goes to the eye
};

/// What a surface looks like at the places of its texture coordinates.
struct SurfaceLook
{
    int size = 0;                   ///< pixels a side; 0: no picture
    std::vector<glm::vec4> pixels;  ///< linear colour, opacity; rows from below
    std::vector<glm::vec3> normals; ///< tangent space; empty: flat
    glm::vec3 colour{1.0F};         ///< linear; multiplies all
    glm::vec3 mean{1.0F};           ///< of the pixels: what a mesh without coordinates has
    std::optional<BarkParams> bark; ///< that ages with the radius of the wood
};

/// The look of leaves or bark with its picture, or of its one colour. Errors: Cancelled.
Expected<SurfaceLook> lookOf(const ShownSurface& surface, const Progress& progress = {});

/// A straight view of a rectangle about a place.
struct PaintedView
{
    ViewFrame frame;
    glm::dvec3 middle{0.0};
    glm::dvec2 half{1.0}; ///< m
};

/// Draws a surface over what is there, where it is nearer to the eye. \pre mesh and copies of the surface are
/// finite
void paint(PaintedSamples& samples, const PaintedView& view, const ShownSurface& surface,
           const SurfaceLook& look);

} // namespace ramure
