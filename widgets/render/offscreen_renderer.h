/// \file
/// A picture without a window: own surface, context and framebuffer. Needs a QGuiApplication on its thread
/// and an OpenGL 3.3 context behind it (platform xcb, or offscreen with DISPLAY set).
#pragma once

#include "core/base/error.h"
#include "widgets/render/camera.h"
#include "widgets/render/render_scene.h"
#include "widgets/render/renderer_options.h"
#include <QImage>
#include <QSize>

namespace ramure {

/// \param size in pixels, 1..16384 each way.
/// \returns an image in Format_ARGB32 (opaque where options.world is on).
/// Errors: Invalid (size), Unknown (no OpenGL 3.3 context here, or a framebuffer the driver refuses).
Expected<QImage> renderImage(const RenderScene& scene, const Camera& camera, QSize size,
                             const RenderOptions& options = {});

} // namespace ramure
