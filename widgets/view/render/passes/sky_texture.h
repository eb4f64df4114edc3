/// \file
/// The graphics card's copy of an artist's sky.
#pragma once

#include "widgets/view/render/light/picture_sky.h"
#include "widgets/view/render/shader_program.h"

namespace ramure {

class SkyTexture
{
public:
    explicit SkyTexture(Gl& gl)
        : m_gl(gl)
    {
    }
    ~SkyTexture();
    SkyTexture(const SkyTexture&) = delete;
    SkyTexture& operator=(const SkyTexture&) = delete;

    /// Uploads another picture than the last; null frees it.
    void bind(GLenum unit, const std::shared_ptr<const PictureSky>& picture);

private:
    Gl& m_gl;
    GLuint m_texture = 0;
    std::shared_ptr<const PictureSky> m_picture; ///< that the texture is of
};

} // namespace ramure
