/// \file
/// A picture drawn aside and then copied with its edges smoothed: anti-aliasing for software rasterisers,
/// where multisampling costs five times the picture itself.
#pragma once

#include "widgets/view/render/shader_program.h"
#include <QSize>

namespace ramure {

/// Every function needs the context current in which the first was called.
class Smoothing
{
public:
    /// \param format of its colours
    explicit Smoothing(Gl& gl, GLenum format = GL_RGBA8);
    ~Smoothing();
    Smoothing(const Smoothing&) = delete;
    Smoothing& operator=(const Smoothing&) = delete;

    /// The framebuffer to draw into, of this size; 0 where the driver refuses it.
    GLuint begin(QSize size);
    /// Copies what was drawn into \p target. Depth test and blending must be off, any vertex array bound.
    void end(GLuint target, ShaderProgram& program);

private:
    void free();

    Gl& m_gl;
    GLenum m_format;
    QSize m_size;
    GLuint m_colour = 0;
    GLuint m_depth = 0;
    GLuint m_framebuffer = 0;
};

} // namespace ramure
