/// \file
/// One OpenGL program made of the shaders in resources/shaders, with its uniforms by name.
#pragma once

#include "core/base/error.h"
#include <QByteArray>
#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLShaderProgram>
#include <array>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace ramure {

using Gl = QOpenGLFunctions_3_3_Core;

/// Lines that turn a part of the shaders off.
namespace switches {
inline constexpr const char* still = "#define STILL\n";       ///< no bones
inline constexpr const char* unmarked = "#define UNMARKED\n"; ///< nothing is selected or hovered
inline constexpr const char* one = "#define ONE_SHADOW\n";    ///< no map of the near shadow
inline constexpr const char* meadow = "#define MEADOW\n";     ///< the plain sky and ground
inline constexpr const char* level = "#define LEVEL\n"; ///< a ground in perspective: its depth is linear
inline constexpr const char* depthOnly = "#define DEPTH_ONLY\n"; ///< draws the depth of the ground alone
inline constexpr const char* picture = "#define PICTURE\n";      ///< the sky is an artist's picture
inline constexpr const char* surfaces =
    "#define SURFACES\n"; ///< draws properties of surfaces instead of their lit look
inline constexpr std::array all{still, unmarked, one, meadow, level, depthOnly, picture, surfaces};
} // namespace switches

/// Names of files in resources/shaders; several vertex or fragment parts are joined in their order.
struct ShaderSources
{
    std::vector<const char*> vertex;
    const char* geometry = nullptr;
    std::vector<const char*> fragment;
    const char* defines = ""; ///< lines put after the version
};

/// Sources for the driver to compile; \c geometry is empty if there is none.
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

    /// Returns this program with one more line after the version, compiled at the first request. A switch
    /// known at compile time removes the code that it turns off, of which software rasterisers otherwise run
    /// both ways. Returns the program itself if not \p asked, or if the driver refuses. \param define a
    /// literal
    ShaderProgram& with(bool asked, const char* define);
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
    ShaderProgram(Gl& gl, const ShaderSources& sources);
    int location(const char* name);

    Gl& m_gl;
    QOpenGLShaderProgram m_program;
    ShaderSources m_sources;
    std::string m_defines;
    std::map<std::string_view, std::unique_ptr<ShaderProgram>>
        m_variants;                              ///< null: refused; keyed by literals
    std::map<std::string_view, int> m_locations; ///< keyed by literals
};

} // namespace ramure
