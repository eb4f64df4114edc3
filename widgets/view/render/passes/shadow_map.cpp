#include "widgets/view/render/passes/shadow_map.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace ramure {

namespace {

/// World -> axes whose Z is towards the sun.
glm::dmat4 sunView(const glm::dvec3& sun)
{
    const glm::dvec3 helper = std::abs(sun.y) < 0.99 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 x = glm::normalize(glm::cross(helper, sun));
    const glm::dvec3 y = glm::cross(sun, x);
    glm::dmat4 view(1.0);
    for (int i = 0; i < 3; ++i) {
        view[i][0] = x[i];
        view[i][1] = y[i];
        view[i][2] = sun[i];
    }
    return view;
}

/// \param c middle of a square of \p side, in sunView.
ShadowFit fitted(const glm::dmat4& view, const Box& seen, const glm::dvec3& c, double side)
{
    const double pad = 0.01 * (seen.size().z + side);
    ShadowFit fit;
    fit.side = side;
    fit.depth = seen.size().z + 2.0 * pad;
    fit.clip = glm::ortho(c.x - 0.5 * side, c.x + 0.5 * side, c.y - 0.5 * side, c.y + 0.5 * side,
                          -(seen.max.z + pad), -(seen.min.z - pad)) *
               view;
    return fit;
}

} // namespace

ShadowFit fitShadow(const Box& casters, const glm::dvec3& sun, int size)
{
    const glm::dmat4 view = sunView(sun);
    const Box seen = casters.transformed(view);
    // A rim of some texels keeps the soft edges inside; a flat or tiny box still has a volume.
    const double side = std::max({seen.size().x, seen.size().y, 1e-3}) * (1.0 + 40.0 / size);
    return fitted(view, seen, seen.centre(), side);
}

ShadowFit fitShadow(const Box& casters, const glm::dvec3& sun, const ShadowFocus& focus)
{
    const glm::dmat4 view = sunView(sun);
    return fitted(view, casters.transformed(view), glm::dvec3(view * glm::dvec4(focus.centre, 1.0)),
                  2.0 * focus.radius);
}

ShadowPlace placeOf(const ShadowFit& fit, const glm::dvec3& eye)
{
    const glm::dmat4 half(glm::dvec4(0.5, 0.0, 0.0, 0.0), glm::dvec4(0.0, 0.5, 0.0, 0.0),
                          glm::dvec4(0.0, 0.0, 0.5, 0.0), glm::dvec4(0.5, 0.5, 0.5, 1.0));
    return {glm::mat4(half * fit.clip * glm::translate(glm::dmat4(1.0), eye)),
            glm::vec3(fit.side / ShadowMap::size, fit.side, fit.depth)};
}

ShadowMap::ShadowMap(Gl& gl)
    : m_gl(gl)
{
}

ShadowMap::~ShadowMap()
{
    if (m_framebuffer == 0)
        return;
    m_gl.glDeleteFramebuffers(1, &m_framebuffer);
    m_gl.glDeleteTextures(1, &m_texture);
    m_gl.glDeleteSamplers(1, &m_compareSampler);
    m_gl.glDeleteSamplers(1, &m_readSampler);
}

void ShadowMap::create()
{
    m_gl.glGenTextures(1, &m_texture);
    m_gl.glBindTexture(GL_TEXTURE_2D, m_texture);
    m_gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, size, size, 0, GL_DEPTH_COMPONENT,
                      GL_UNSIGNED_INT, nullptr);
    m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    m_gl.glGenSamplers(1, &m_compareSampler);
    m_gl.glGenSamplers(1, &m_readSampler);
    for (const GLuint sampler : {m_compareSampler, m_readSampler}) {
        const bool compares = sampler == m_compareSampler;
        const GLint filter = compares ? GL_LINEAR : GL_NEAREST;
        m_gl.glSamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, filter);
        m_gl.glSamplerParameteri(sampler, GL_TEXTURE_MAG_FILTER, filter);
        m_gl.glSamplerParameteri(sampler, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        m_gl.glSamplerParameteri(sampler, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        if (compares) {
            m_gl.glSamplerParameteri(sampler, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
            m_gl.glSamplerParameteri(sampler, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
        }
    }
    m_gl.glGenFramebuffers(1, &m_framebuffer);
    m_gl.glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    m_gl.glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, m_texture, 0);
    m_gl.glDrawBuffer(GL_NONE);
    m_gl.glReadBuffer(GL_NONE);
}

std::optional<ShadowFit> ShadowMap::update(const RenderScene& scene, const glm::dvec3& sun, GpuCache& cache,
                                           const DepthPrograms& programs, PictureParts& parts,
                                           PictureParts::Pass pass, LeafDetail detail,
                                           const std::optional<ShadowFocus>& focus)
{
    std::vector<Caster> casters;
    const auto add = [&casters](const std::vector<MeshItem>& items) {
        for (const MeshItem& item : items)
            if (item.castsShadow && !item.mesh.empty())
                casters.push_back(
                    {&item, item.mesh, item.copies, item.places, item.images, item.motion, item.world});
    };
    add(scene.meshes);
    add(focus ? scene.nearCasters : scene.farCasters);
    if (casters.empty() || scene.casters.empty())
        return std::nullopt;
    const bool isWindy =
        std::ranges::any_of(casters, [](const Caster& c) { return c.motion.wind != nullptr; });
    const WindMoment wind = isWindy ? cache.wind() : WindMoment();
    const bool isNew =
        !(casters == m_drawn && sun == m_sun && focus == m_focus && detail == m_detail && wind == m_wind);
    if ((!isNew && m_isWhole) || !parts.enter(pass, QSize(size, size)))
        return m_fit;
    if (m_framebuffer == 0)
        create();
    m_fit = focus ? fitShadow(scene.casters, sun, *focus) : fitShadow(scene.casters, sun, size);
    m_gl.glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    m_gl.glViewport(0, 0, size, size);
    m_gl.glEnable(GL_DEPTH_TEST);
    m_gl.glDepthMask(GL_TRUE);
    m_gl.glDepthFunc(GL_LESS);
    m_gl.glDisable(GL_CULL_FACE);
    if (isNew)
        m_gl.glClear(GL_DEPTH_BUFFER_BIT);
    for (const Caster& caster : casters) {
        ShaderProgram& program = programs.of(*caster.item);
        program.bind();
        if (DepthPrograms::cuts(*caster.item))
            cache.bindPictures(program, *caster.item);
        cache.bindMotion(program, caster.motion);
        program.set("uClip", glm::mat4(m_fit.clip * caster.world));
        cache.drawTriangles(cache.item(*caster.item), parts,
                            DepthPrograms::cuts(*caster.item) ? LeafDetail::All : detail);
    }
    m_gl.glBindVertexArray(0);
    m_drawn = std::move(casters);
    m_sun = sun;
    m_wind = wind;
    m_focus = focus;
    m_detail = detail;
    m_isWhole = parts.isWhole();
    m_redraws += isNew ? 1 : 0;
    return m_fit;
}

void ShadowMap::bind(GLenum compareUnit, GLenum readUnit)
{
    if (m_texture == 0)
        create();
    for (const GLenum unit : {compareUnit, readUnit}) {
        m_gl.glActiveTexture(GL_TEXTURE0 + unit);
        m_gl.glBindTexture(GL_TEXTURE_2D, m_texture);
        m_gl.glBindSampler(unit, unit == compareUnit ? m_compareSampler : m_readSampler);
    }
    m_gl.glActiveTexture(GL_TEXTURE0);
}

} // namespace ramure
