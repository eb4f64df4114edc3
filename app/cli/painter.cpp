#include "app/cli/painter.h"
#include "app/cli/input.h"
#include <map>

namespace ramure::cli {

Expected<void> Painter::begin()
{
    RAMURE_TRY(m_display.ensure());
    // Whatever the user's desktop needs (wayland, a wrong name): this one needs nothing but the X server.
    qputenv("QT_QPA_PLATFORM", "offscreen");
    m_application.emplace(m_argc, m_argv);
    m_renderer.emplace();
    if (const auto begun = m_renderer->begin(); !begun)
        return fail(ErrorCode::Unknown,
                    "%1: the driver of the X server at DISPLAY=%2 has none (Debian package libgl1-mesa-dri; "
                    "where DISPLAY is not set, Xvfb is started)",
                    {begun.error().message(), qgetenv("DISPLAY").toStdString()});
    return {};
}

Expected<QImage> Painter::draw(const RenderScene& scene, const Camera& camera, QSize size,
                               const RenderOptions& options, const Progress& progress)
{
    return m_renderer->draw(scene, camera, size, options, progress);
}

Expected<SurfacePictures> Painter::drawSurfaces(const RenderScene& scene, const Camera& camera, QSize size,
                                                double reach, bool sparing)
{
    return m_renderer->drawSurfaces(scene, camera, size, reach, sparing);
}

Expected<RenderScene> renderSceneOf(EvaluatedScene& now, const SceneView& view)
{
    const Scene& scene = now.scene();
    const auto nodes = treesOrShapes(scene);
    RAMURE_TRY(nodes);
    std::map<NodeId, TreeResult> results;
    for (const Node* node : *nodes) {
        if (!scene.isShown(node->id))
            continue;
        auto result = evaluateTree(now, *node, nodes->size() > 1, rowOf(view.mode).stage);
        RAMURE_TRY(result);
        results.emplace(node->id, std::move(*result));
    }
    const auto resultOf = [&](NodeId id) {
        const auto found = results.find(id);
        return found == results.end() ? nullptr : &found->second;
    };
    return SceneBuilder().build(now, resultOf, view);
}

Camera cameraFor(const RenderScene& scene, QSize size)
{
    Camera camera;
    camera.frame(scene.framePoints(), double(size.width()) / double(size.height()));
    return camera;
}

} // namespace ramure::cli
