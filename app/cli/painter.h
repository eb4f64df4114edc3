/// \file
/// Pictures of scenes on the command line, with a display of our own where there is none.
#pragma once

#include "app/cli/virtual_display.h"
#include "core/evaluate/evaluator.h"
#include "widgets/view/render/passes/offscreen_renderer.h"
#include "widgets/view/render/scene_builder.h"
#include <QGuiApplication>
#include <optional>

namespace ramure::cli {

/// The platform without windows of Qt: all it needs is the X server behind DISPLAY, where it finds OpenGL.
class Painter
{
public:
    /// Call it once. Errors: those of VirtualDisplay and OffscreenRenderer.
    Expected<void> begin();
    /// \pre begin() went well
    Expected<QImage> draw(const RenderScene& scene, const Camera& camera, QSize size,
                          const RenderOptions& options, const Progress& progress = {});
    /// The same for what surfaces are: see OffscreenRenderer::drawSurfaces.
    Expected<SurfacePictures> drawSurfaces(const RenderScene& scene, const Camera& camera, QSize size,
                                           double reach, bool sparing);
    [[nodiscard]] bool hasBegun() const { return m_renderer.has_value(); }

private:
    VirtualDisplay m_display;
    char m_name[11] = "ramure-cli";
    char* m_argv[2] = {m_name, nullptr};
    int m_argc = 1;
    std::optional<QGuiApplication> m_application;
    std::optional<OffscreenRenderer> m_renderer;
};

/// Builds the visible scene at its time. \param view what is shown of it. Errors: those of its trees; Invalid
/// (nothing in it).
Expected<RenderScene> renderSceneOf(EvaluatedScene& now, const SceneView& view = SceneView());
/// From the front, all that is visible.
Camera cameraFor(const RenderScene& scene, QSize size);

} // namespace ramure::cli
