#include "widgets/view/render/passes/occlusion.h"

#include <algorithm>

namespace ramure {

Occlusion::Occlusion(Gl& gl)
    : m_gl(gl)
{
}

Occlusion::~Occlusion()
{
    free();
}

void Occlusion::free()
{
    if (m_textures[0] == 0)
        return;
    m_gl.glDeleteFramebuffers(3, m_framebuffers);
    m_gl.glDeleteTextures(3, m_textures);
    std::ranges::fill(m_textures, 0u);
}

bool Occlusion::begin(QSize size, bool clears)
{
    if (m_textures[0] == 0 || size != m_size) {
        free();
        m_size = size;
        m_gl.glGenTextures(3, m_textures);
        m_gl.glGenFramebuffers(3, m_framebuffers);
        for (int i = 0; i < 3; ++i) {
            const bool depth = i == 0;
            m_gl.glBindTexture(GL_TEXTURE_2D, m_textures[i]);
            m_gl.glTexImage2D(GL_TEXTURE_2D, 0, depth ? GL_DEPTH_COMPONENT24 : GL_R8, size.width(),
                              size.height(), 0, depth ? GL_DEPTH_COMPONENT : GL_RED,
                              depth ? GL_UNSIGNED_INT : GL_UNSIGNED_BYTE, nullptr);
            m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
            for (const GLenum filter : {GLenum(GL_TEXTURE_MIN_FILTER), GLenum(GL_TEXTURE_MAG_FILTER)})
                m_gl.glTexParameteri(GL_TEXTURE_2D, filter, i == 2 ? GL_LINEAR : GL_NEAREST);
            for (const GLenum wrap : {GLenum(GL_TEXTURE_WRAP_S), GLenum(GL_TEXTURE_WRAP_T)})
                m_gl.glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
            m_gl.glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffers[i]);
            m_gl.glFramebufferTexture2D(GL_FRAMEBUFFER, depth ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0,
                                        GL_TEXTURE_2D, m_textures[i], 0);
            if (depth) {
                m_gl.glDrawBuffer(GL_NONE);
                m_gl.glReadBuffer(GL_NONE);
            }
            if (m_gl.glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
                free();
                return false;
            }
        }
        m_gl.glBindTexture(GL_TEXTURE_2D, 0);
    }
    m_gl.glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffers[0]);
    m_gl.glViewport(0, 0, size.width(), size.height());
    if (clears)
        m_gl.glClear(GL_DEPTH_BUFFER_BIT);
    return true;
}

void Occlusion::end(const Camera& camera, const glm::dmat4& clip, double radius, const Programs& programs,
                    PictureParts& parts)
{
    m_gl.glDisable(GL_DEPTH_TEST);
    const double atTarget = m_size.height() / camera.heightAtTarget();
    const float pixels = float(camera.orthographic ? atTarget : atTarget * camera.distance);
    for (int pass = 1; pass < 3; ++pass) {
        ShaderProgram& program = pass == 1 ? programs.gather : programs.blur;
        m_gl.glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffers[pass]);
        program.bind();
        program.set("uDepth", 0);
        program.set("uSource", 1);
        for (const int unit : {1, 0}) {
            m_gl.glActiveTexture(GL_TEXTURE0 + GLenum(unit));
            m_gl.glBindSampler(GLuint(unit), 0);
            m_gl.glBindTexture(GL_TEXTURE_2D, m_textures[pass == 1 ? 0 : unit]);
        }
        program.set("uBack", glm::mat4(glm::inverse(clip)));
        program.set("uRadius", float(radius));
        program.set("uPixels", glm::vec4(glm::vec3(camera.backward()), pixels));
        program.set("uParallel", camera.orthographic);
        parts.rows([this] { m_gl.glDrawArrays(GL_TRIANGLES, 0, 3); });
    }
    m_gl.glUseProgram(0); // its samplers do not suit what is bound when the next target is cleared
    m_gl.glEnable(GL_DEPTH_TEST);
}

} // namespace ramure
