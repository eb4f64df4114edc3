/// \file
/// Draws a render scene with OpenGL 3.3 core into any framebuffer. Knows no document and no widget. Holds
/// nothing that cannot be made again: after a lost context throw it away and make another.
#pragma once

#include "core/base/progress.h"
#include "widgets/view/render/camera.h"
#include "widgets/view/render/outline.h"
#include "widgets/view/render/passes/crowd_pictures.h"
#include "widgets/view/render/passes/occlusion.h"
#include "widgets/view/render/passes/picture_light.h"
#include "widgets/view/render/passes/renderer_programs.h"
#include "widgets/view/render/passes/shadow_map.h"
#include "widgets/view/render/passes/sky_texture.h"
#include "widgets/view/render/passes/smoothing.h"
#include "widgets/view/render/picture_parts.h"
#include "widgets/view/render/renderer_options.h"
#include "widgets/view/render/stream/gpu_cache.h"
#include <QSize>

class QOpenGLDebugLogger;

namespace ramure {

/// Figures of the last picture, and since the start.
struct RenderStats
{
    double uploadMs = 0.0;  ///< blocks new in the last picture
    double drawMs = 0.0;    ///< commands of the last picture issued
    double drawCpuMs = 0.0; ///< the same, as the thread's own time
    std::uint64_t pictures = 0;
    std::uint64_t shadowRedraws = 0;
    UploadStats uploads;
    CrowdCounts crowd; ///< of the last picture
};

class Renderer
{
public:
    /// Compiles the programs in the current context, which must be OpenGL 3.3 core or later.
    /// Error: Unknown (context, shader), with the driver's words.
    static Expected<std::unique_ptr<Renderer>> make();
    /// With the same context current.
    ~Renderer();

    /// Draws into \p framebuffer (its size in device pixels \p size). Leaves the framebuffer bound, blending
    /// and depth test off, no program, buffer or texture bound.
    void draw(const RenderScene& scene, const Camera& camera, QSize size, GLuint framebuffer,
              const RenderOptions& options);
    /// Sets a progress: draw() reports to it after each mesh, and stops if asked to; the framebuffer then has
    /// no picture. It is for pictures that take long, because it waits for the card each time. Null: none.
    /// Not owned.
    void setProgress(const Progress* progress) { m_progress = progress; }
    /// Makes a picture in parts, to be called again with the same arguments until it returns true: then
    /// show() shows it, and until then what was drawn before. Takes about \p ms; infinity: as long as it
    /// needs. \param sample of a picture with options.lens: 0, or one more than the last one that was made.
    /// Shown is the mean of those from 0 on: depth of field (offscreen_renderer.h).
    bool drawPart(const RenderScene& scene, const Camera& camera, QSize size, const RenderOptions& options,
                  int sample, double ms);
    /// The next part is of another picture.
    void restartParts() { m_parts.restart(); }
    /// Draws the result of the last draw() with options.smoothing, or of drawPart(), into \p framebuffer once
    /// more, in the same size.
    void show(QSize size, GLuint framebuffer);
    /// Draws the outline over a picture of the scene in \p framebuffer.
    void outline(const RenderScene& scene, const Camera& camera, QSize size, GLuint framebuffer,
                 const RenderOptions& options);
    /// Draws properties of surfaces instead of their lit look. The framebuffer's first picture gets their own
    /// colour (sRGB). The second gets their normal, in the world's axes from 0 to 1, and the depth as alpha:
    /// 1/255 is \p reach (m) behind the camera's target, 1 is \p reach in front of it. Pixels without a
    /// surface are 0. Lines, points and marks are left out. \param framebuffer has two colours and no
    /// multisampling \param sparing leaves of a few pixels have the least triangles, in a third of the time
    void drawSurfaces(const RenderScene& scene, const Camera& camera, QSize size, GLuint framebuffer,
                      double reach, bool sparing);
    /// Large scenes before they are drawn: see GpuCache::prepare. The context must be current.
    bool prepare(const RenderScene& scene, std::size_t bytes) { return m_cache.prepare(scene, bytes); }
    [[nodiscard]] std::vector<std::shared_ptr<const void>> takeReleased() { return m_cache.takeReleased(); }
    [[nodiscard]] RenderStats stats() const;

private:
    struct Picture; ///< all that one picture's passes share

    explicit Renderer(Gl& gl);
    Expected<void> compile();
    bool drawAside(const RenderScene& scene, const Camera& camera, QSize size, GLuint framebuffer,
                   const RenderOptions& options);
    void addThroughLens(QSize size, int sample);
    void upload(const RenderScene& scene);
    void setLight(ShaderProgram& program, const Picture& picture);
    void setStates(ShaderProgram& program, const RenderScene& scene, NodeId node, bool hasBranches = true);
    Picture arrange(const RenderScene& scene, const Camera& camera, QSize size, const RenderOptions& options);
    void drawInto(GLuint framebuffer, const Picture& picture, QSize size);
    void occlude(Picture& picture, QSize size);
    void castShadows(Picture& picture);
    void castNear(Picture& picture, double side);
    void drawWorld(const Picture& picture, bool depthOnly = false);
    void drawDepth(const Picture& picture);
    void drawMeshes(const Picture& picture, ShadingMode shading, bool faded);
    void beginMeshes(ShaderProgram& program, const Picture& picture, ShadingMode shading);
    ShaderProgram& programOf(const Picture& picture, const MeshItem& item, ShadingMode shading);
    void drawMesh(ShaderProgram& program, const Picture& picture, const MeshItem& item);
    void setCrowd(ShaderProgram& program, const MeshItem& item);
    void drawItem(const Picture& picture, const MeshItem& item, const GpuBlock& block);
    void drawMeshDepth(const Picture& picture, const MeshItem& item);
    void drawFaded(const Picture& picture);
    void drawOutline(const Picture& picture, GLuint target);
    void drawLines(const Picture& picture, bool hidden);
    void drawLineItem(const Picture& picture, const LineItem& item);
    void drawPoints(const Picture& picture, bool hidden);
    void drawGhosts(const Picture& picture);
    void beginState(QSize size, bool clears = true);
    void resetState();

    Gl& m_gl;
    std::unique_ptr<QOpenGLDebugLogger> m_messages; ///< null in a context that does not tell
    GpuCache m_cache;
    ShadowMap m_shadowMap, m_nearShadow;
    CrowdPictures m_crowds;
    PictureParts m_parts;
    Smoothing m_smoothing, m_large;
    Smoothing m_lensPicture, m_lensSum;
    enum class Shown : std::uint8_t { Smoothed, Shrunk, Part, PartSmoothed, Lens };
    Shown m_shown = Shown::Smoothed; ///< by show()
    int m_lensPictures = 0;          ///< in their sum
    Outline m_outline;
    Occlusion m_occlusion;
    SkyTexture m_sky;
    RendererPrograms m_programs;
    std::optional<std::pair<SceneLight, PictureLight>> m_light; ///< the lights of the last picture
    GLuint m_emptyArray = 0;
    GLuint m_noStates = 0; ///< a texture of one plain branch
    GLint m_samples = 0;   ///< samples per pixel of the current picture
    /// A rasteriser on the CPU (llvmpipe): the renderer chooses fewer samples of the shadow.
    bool m_software = false;
    RenderStats m_stats;
    const Progress* m_progress = nullptr;
    std::size_t m_drawn = 0; ///< meshes, in all passes of this picture
};

} // namespace ramure
