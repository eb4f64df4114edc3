/// \file
/// Draws billboards of a scene: an atlas of views, or crossed cards (core/lod/billboard.h).
#pragma once

#include "core/base/progress.h"
#include "core/lod/billboard_picture.h"
#include "widgets/view/render/passes/offscreen_renderer.h"
#include <functional>

namespace ramure {

/// OffscreenRenderer::drawSurfaces of the scene at hand.
using DrawSurfaces =
    std::function<Expected<SurfacePictures>(const Camera& camera, QSize size, double reach, bool sparing)>;

/// Holds all that is seen of a scene, world space. A radius of 0: nothing is.
struct SceneBall
{
    glm::dvec3 middle{0.0};
    double radius = 0.0; ///< m
};
SceneBall ballOf(const RenderScene& scene);

struct BillboardAtlas
{
    BillboardPicture picture; ///< normals in the world's axes; bled within each view
    int views = 0;            ///< each way
    glm::dvec3 middle{0.0};   ///< what all look at, world
    double radius = 0.0;      ///< m: half a view's side, and how far the depth reaches both ways
};
struct BillboardCards
{
    BillboardPicture picture; ///< normals in the axes of each card; bled all over
    std::vector<BillboardCard> cards;
    TriangleMesh mesh; ///< world
};

/// One view of what is around \p middle, each pixel the mean of several samples. Not bled.
/// \param seen of the plane through the middle \param reach m that the depth tells before and behind it
/// \param sparing leaves of a few pixels have the least triangles. Errors: those of drawSurfaces.
Expected<BillboardPicture> bakeView(const DrawSurfaces& draw, const ViewFrame& frame,
                                    const glm::dvec3& middle, const PlaneRect& seen, QSize size, double reach,
                                    bool sparing);
/// \param size of the square picture, a multiple of \p views. Errors: Invalid (nothing is seen), those of
/// drawSurfaces, Cancelled.
Expected<BillboardAtlas> bakeAtlas(const DrawSurfaces& draw, const SceneBall& ball, int size, int views,
                                   const Progress& progress);
/// \param size of the square picture. Errors: Invalid (nothing is seen), those of packCards and drawSurfaces,
/// Cancelled.
Expected<BillboardCards> bakeCards(const DrawSurfaces& draw, const SceneBall& ball, int size, int standing,
                                   bool lying, const Progress& progress);

} // namespace ramure
