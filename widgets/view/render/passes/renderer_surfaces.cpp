// What surfaces are, for billboards: colour, normal and depth in one pass.
#include "widgets/view/render/passes/renderer_picture.h"

namespace ramure {

/// What only one of many has.
void Renderer::setCrowd(ShaderProgram& program, const MeshItem& item)
{
    program.set("uMean", item.mean);
    program.set("uFlat", item.flat);
    if (item.crown)
        program.set("uCrownPlace", glm::mat4(item.crown->place));
}

void Renderer::drawSurfaces(const RenderScene& scene, const Camera& camera, QSize size, GLuint framebuffer,
                            double reach, bool sparing)
{
    constexpr GLenum targets[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    RenderOptions options;
    options.quality = sparing ? Quality::Good : Quality::Best; // which draws all triangles of leaves
    options.sparing = sparing;
    options.shadows = options.world = options.outline = false;
    options.samples = 0;
    m_cache.beginPicture({});
    m_cache.restAttributes();
    upload(scene);
    const Picture picture = arrange(scene, camera, size, options);
    m_gl.glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    m_gl.glDrawBuffers(2, targets);
    beginState(size);
    m_samples = 0;
    const glm::vec2 depth(camera.distance + reach, 0.5 / reach);
    for (const MeshItem& item : scene.meshes) {
        if (item.isMark)
            continue;
        ShaderProgram& base = m_cache.item(item).hasColours()                ? *m_programs.meshColours
                              : item.paint != Paint::Material || item.images ? *m_programs.mesh
                              : item.bark                                    ? *m_programs.bark
                              : item.leaf                                    ? *m_programs.leaf
                                                                             : *m_programs.plain;
        ShaderProgram& program = base.with(item.motion.isStill(), switches::still)
                                     .with(true, switches::unmarked)
                                     .with(true, switches::surfaces);
        beginMeshes(program, picture, ShadingMode::Solid);
        program.set("uDepth", depth);
        drawMesh(program, picture, item);
    }
    m_cache.freeUnused();
    m_gl.glDrawBuffers(1, targets);
    resetState();
    ++m_stats.pictures;
}

} // namespace ramure
