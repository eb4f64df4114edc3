#include "widgets/view/render/passes/sky_texture.h"

#include <utility>

namespace ramure {

SkyTexture::~SkyTexture()
{
    m_gl.glDeleteTextures(1, &m_texture);
}

void SkyTexture::bind(GLenum unit, const std::shared_ptr<const PictureSky>& picture)
{
    m_gl.glActiveTexture(GL_TEXTURE0 + unit);
    if (std::exchange(m_picture, picture) != picture) {
        m_gl.glDeleteTextures(1, &std::as_const(m_texture));
        m_texture = 0;
        if (picture) {
            m_gl.glGenTextures(1, &m_texture);
            m_gl.glBindTexture(GL_TEXTURE_2D, m_texture);
            m_gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB9_E5, picture->width, picture->height, 0, GL_RGB,
                              GL_UNSIGNED_INT_5_9_9_9_REV, picture->pixels.data());
            m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
            m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
            m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
            m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        }
    }
    m_gl.glBindTexture(GL_TEXTURE_2D, m_texture);
    m_gl.glActiveTexture(GL_TEXTURE0);
}

} // namespace ramure
