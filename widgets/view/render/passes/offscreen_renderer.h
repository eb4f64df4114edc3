/// \file
/// Pictures without a window: own surface, context and framebuffer. Needs a QGuiApplication and an OpenGL 3.3
/// context behind it (platform xcb, or offscreen with DISPLAY set).
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "widgets/view/render/camera.h"
#include "widgets/view/render/render_scene.h"
#include "widgets/view/render/renderer_options.h"
#include <QImage>
#include <QSize>
#include <memory>

namespace ramure {

/// Properties of surfaces, to be lit later. Both pictures are in Format_ARGB32, and transparent without a
/// surface.
struct SurfacePictures
{
    QImage colour; ///< their own, sRGB; opaque
    QImage normal; ///< in the world's axes, 0 and 255 for -1 and 1; alpha: the depth, 1 the farthest, 255 the
                   ///< nearest
};

/// Many pictures, on any one thread.
class OffscreenRenderer
{
public:
    /// On the thread of the QGuiApplication, as the destructor: the surface may be a window of the system.
    OffscreenRenderer();
    ~OffscreenRenderer();
    OffscreenRenderer(const OffscreenRenderer&) = delete;
    OffscreenRenderer& operator=(const OffscreenRenderer&) = delete;

    /// On the thread that will draw. Errors: Unknown (no OpenGL 3.3 context here, or none beside that of the
    /// application's thread).
    Expected<void> begin();
    /// After begin(), on its thread. \param size in pixels, 1..16384 each way.
    /// \returns an image in Format_ARGB32 (opaque where options.world is on).
    /// Errors: Invalid (size), Unknown (a framebuffer the driver refuses), Cancelled.
    Expected<QImage> draw(const RenderScene& scene, const Camera& camera, QSize size,
                          const RenderOptions& options = {}, const Progress& progress = {});
    /// Like draw(), with one sample a pixel. \param reach m before and behind the camera's target that the
    /// depth covers \param sparing leaves of a few pixels have the least triangles
    Expected<SurfacePictures> drawSurfaces(const RenderScene& scene, const Camera& camera, QSize size,
                                           double reach, bool sparing);
    /// On the thread of begin().
    void end();

private:
    struct Private;
    std::unique_ptr<Private> d;
};

/// For a job's thread: wherever its last owner is, it ends on the thread of the QGuiApplication, on which it
/// has to be made. A work that is left to itself may be that owner.
std::shared_ptr<OffscreenRenderer> rendererForJob();

/// One picture, on the thread of the QGuiApplication. Errors: those of begin() and draw().
Expected<QImage> renderImage(const RenderScene& scene, const Camera& camera, QSize size,
                             const RenderOptions& options = {});

} // namespace ramure
