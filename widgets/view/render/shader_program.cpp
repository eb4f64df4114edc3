#include "widgets/view/render/shader_program.h"

#include <QFile>

// Resources of a static library are only linked in when asked for; the macro must stand outside namespaces.
static void initShaderResources()
{
    Q_INIT_RESOURCE(shaders);
}

namespace ramure {
namespace {

QByteArray source(const std::vector<const char*>& names, const char* defines)
{
    QByteArray text = "#version 330 core\n";
    text += defines;
    for (const char* name : names) {
        QFile file(QStringLiteral(":/shaders/") + QLatin1String(name));
        if (file.open(QIODevice::ReadOnly))
            text += file.readAll() + '\n';
    }
    return text;
}

/// Where a program's pictures are from the start: two kinds of samplers must not share a unit, not even in a
/// program that is bound and draws nothing.
constexpr std::pair<const char*, int> units[] = {
    {"uShadowMap", 0},  {"uShadowDepth", 1}, {"uStates", 2},  {"uBones", 3},   {"uColours", 4},
    {"uBark", 5},       {"uBarkNormals", 6}, {"uCrown", 7},   {"uNearMap", 8}, {"uNearDepth", 9},
    {"uOcclusion", 10}, {"uElements", 11},   {"uPicture", 12}};

} // namespace

ShaderTexts composed(const ShaderSources& sources)
{
    initShaderResources();
    ShaderTexts texts{source(sources.vertex, sources.defines), {}, source(sources.fragment, sources.defines)};
    if (sources.geometry)
        texts.geometry = source({sources.geometry}, sources.defines);
    return texts;
}

ShaderProgram::ShaderProgram(Gl& gl, const ShaderSources& sources)
    : m_gl(gl)
    , m_sources(sources)
    , m_defines(sources.defines)
{
    m_sources.defines = m_defines.c_str();
}

Expected<std::unique_ptr<ShaderProgram>> ShaderProgram::make(Gl& gl, const ShaderSources& sources)
{
    const ShaderTexts texts = composed(sources);
    std::unique_ptr<ShaderProgram> made(new ShaderProgram(gl, sources));
    QOpenGLShaderProgram& program = made->m_program;
    const bool good =
        program.addShaderFromSourceCode(QOpenGLShader::Vertex, texts.vertex) &&
        (!sources.geometry || program.addShaderFromSourceCode(QOpenGLShader::Geometry, texts.geometry)) &&
        program.addShaderFromSourceCode(QOpenGLShader::Fragment, texts.fragment) && program.link();
    if (!good)
        return fail(ErrorCode::Unknown, RAMURE_NOOP("The graphics driver refuses a shader: %1"),
                    {program.log().toStdString()});
    made->bind();
    for (const auto& [name, unit] : units)
        made->set(name, unit);
    gl.glUseProgram(0);
    return made;
}

ShaderProgram& ShaderProgram::with(bool asked, const char* define)
{
    if (!asked)
        return *this;
    const auto [it, isNew] = m_variants.try_emplace(define);
    if (isNew) {
        const std::string defines = m_defines + define;
        ShaderSources sources = m_sources;
        sources.defines = defines.c_str();
        if (auto made = make(m_gl, sources))
            it->second = std::move(*made);
    }
    return it->second ? *it->second : *this;
}

void ShaderProgram::bind()
{
    m_program.bind();
}

int ShaderProgram::location(const char* name)
{
    const auto [it, isNew] = m_locations.try_emplace(name, -1);
    if (isNew)
        it->second = m_program.uniformLocation(name);
    return it->second;
}

void ShaderProgram::set(const char* name, bool value)
{
    m_gl.glUniform1i(location(name), value ? 1 : 0);
}

void ShaderProgram::set(const char* name, int value)
{
    m_gl.glUniform1i(location(name), value);
}

void ShaderProgram::set(const char* name, float value)
{
    m_gl.glUniform1f(location(name), value);
}

void ShaderProgram::set(const char* name, const glm::vec2& value)
{
    m_gl.glUniform2fv(location(name), 1, &value[0]);
}

void ShaderProgram::set(const char* name, const glm::vec3& value)
{
    m_gl.glUniform3fv(location(name), 1, &value[0]);
}

void ShaderProgram::set(const char* name, const glm::vec4& value)
{
    m_gl.glUniform4fv(location(name), 1, &value[0]);
}

void ShaderProgram::set(const char* name, const glm::mat3& value)
{
    m_gl.glUniformMatrix3fv(location(name), 1, GL_FALSE, &value[0][0]);
}

void ShaderProgram::set(const char* name, const glm::mat4& value)
{
    m_gl.glUniformMatrix4fv(location(name), 1, GL_FALSE, &value[0][0]);
}

} // namespace ramure
