#include "widgets/view/render/passes/smoothing.h"

namespace ramure {

Smoothing::Smoothing(Gl& gl, GLenum format)
    : m_gl(gl)
    , m_format(format)
{
}

Smoothing::~Smoothing()
{
    free();
}

void Smoothing::free()
{
    if (m_framebuffer == 0)
        return;
    m_gl.glDeleteFramebuffers(1, &m_framebuffer);
    m_gl.glDeleteTextures(1, &m_colour);
    m_gl.glDeleteRenderbuffers(1, &m_depth);
    m_framebuffer = 0;
}

GLuint Smoothing::begin(QSize size)
{
    if (m_framebuffer != 0 && size == m_size)
        return m_framebuffer;
    free();
    m_size = size;
    m_gl.glGenTextures(1, &m_colour);
    m_gl.glBindTexture(GL_TEXTURE_2D, m_colour);
    m_gl.glTexImage2D(GL_TEXTURE_2D, 0, GLint(m_format), size.width(), size.height(), 0, GL_RGBA,
                      GL_UNSIGNED_BYTE, nullptr);
    for (const GLenum filter : {GLenum(GL_TEXTURE_MIN_FILTER), GLenum(GL_TEXTURE_MAG_FILTER)})
        m_gl.glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
    for (const GLenum wrap : {GLenum(GL_TEXTURE_WRAP_S), GLenum(GL_TEXTURE_WRAP_T)})
        m_gl.glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
    m_gl.glBindTexture(GL_TEXTURE_2D, 0);
    m_gl.glGenRenderbuffers(1, &m_depth);
    m_gl.glBindRenderbuffer(GL_RENDERBUFFER, m_depth);
    m_gl.glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, size.width(), size.height());
    m_gl.glGenFramebuffers(1, &m_framebuffer);
    m_gl.glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    m_gl.glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_colour, 0);
    m_gl.glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, m_depth);
    if (m_gl.glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        free();
    return m_framebuffer;
}

void Smoothing::end(GLuint target, ShaderProgram& program)
{
    m_gl.glBindFramebuffer(GL_FRAMEBUFFER, target);
    m_gl.glActiveTexture(GL_TEXTURE0);
    m_gl.glBindSampler(0, 0);
    m_gl.glBindTexture(GL_TEXTURE_2D, m_colour);
    program.bind();
    program.set("uPicture", 0);
    m_gl.glDrawArrays(GL_TRIANGLES, 0, 3);
}

} // namespace ramure
