/// \file
/// How much of the sky's light reaches each pixel past what stands close by: in forks, behind petioles, where
/// a trunk meets the ground. From the depth alone (resources/shaders/occlusion.frag names the source).
#pragma once

#include "widgets/view/render/camera.h"
#include "widgets/view/render/picture_parts.h"
#include <QSize>

namespace ramure {

/// Every function needs the context current in which the first was called.
class Occlusion
{
public:
    struct Programs
    {
        ShaderProgram& gather;
        ShaderProgram& blur;
    };

    explicit Occlusion(Gl& gl);
    ~Occlusion();
    Occlusion(const Occlusion&) = delete;
    Occlusion& operator=(const Occlusion&) = delete;

    /// Binds a framebuffer without colours, of this size, for the depth of the picture. False where the
    /// driver refuses it; then another framebuffer must be bound. \param clears it, too
    [[nodiscard]] bool begin(QSize size, bool clears);
    /// \param clip eye-relative -> clip space, that the depth was drawn with \param radius of what counts as
    /// close, m. Any vertex array must be bound. Leaves another framebuffer bound.
    void end(const Camera& camera, const glm::dmat4& clip, double radius, const Programs& programs,
             PictureParts& parts);
    /// Returns a texture of one colour, 0 .. 1; 0 before the first begin, and if the driver refused it.
    [[nodiscard]] GLuint texture() const { return m_textures[2]; }

private:
    void free();

    Gl& m_gl;
    QSize m_size;
    GLuint m_textures[3]{}; ///< depth, rough, smooth
    GLuint m_framebuffers[3]{};
};

} // namespace ramure
