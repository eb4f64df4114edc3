/// \file
/// One OpenGL program made of the shaders in resources/shaders, with its uniforms by name.
#pragma once

#include "core/base/error.h"
#include <QByteArray>
#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLShaderProgram>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <memory>
#include <string_view>

namespace ramure {

using Gl = QOpenGLFunctions_3_3_Core;

/// Names of files in resources/shaders; several vertex or fragment parts are joined in their order.
struct ShaderSources
{
    std::vector<const char*> vertex;
    const char* geometry = nullptr;
    std::vector<const char*> fragment;
    const char* defines = ""; ///< lines put after the version
};

/// What a driver is given to compile; \c geometry is empty where there is none.
struct ShaderTexts
{
    QByteArray vertex, geometry, fragment;
};
ShaderTexts composed(const ShaderSources& sources);

/// All functions need the context current that compiled the program. Unknown uniform names are ignored: the
/// compiler removes those that a variant does not use.
class ShaderProgram
{
public:
    /// Error: Unknown, with the driver's log.
    static Expected<std::unique_ptr<ShaderProgram>> make(Gl& gl, const ShaderSources& sources);

    void bind();
    void set(const char* name, bool value);
    void set(const char* name, int value);
    void set(const char* name, float value);
    void set(const char* name, const glm::vec2& value);
    void set(const char* name, const glm::vec3& value);
    void set(const char* name, const glm::vec4& value);
    void set(const char* name, const glm::mat3& value);
    void set(const char* name, const glm::mat4& value);

private:
    explicit ShaderProgram(Gl& gl);
    int location(const char* name);

    Gl& m_gl;
    QOpenGLShaderProgram m_program;
    std::map<std::string_view, int> m_locations; ///< keyed by literals
};

} // namespace ramure
