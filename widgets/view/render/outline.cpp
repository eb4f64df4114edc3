#include "widgets/view/render/outline.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace ramure {
namespace {

constexpr int reach = 4;             ///< texels, as in outline_spread.frag
constexpr Index runLength = 64;      ///< faces that a thinned mesh keeps or leaves out together
constexpr float fineOffset = 3.0f;   ///< logical pixels from a branch to the line's middle
constexpr float wholeOffset = 4.0f;  ///< from a whole node
constexpr float coarseOffset = 6.0f; ///< from one with a crown
constexpr float lineWidth = 2.0f;    ///< logical pixels

/// Adds where a box is on the screen; false where part of it is behind the eye.
bool addProjected(const Box& box, const Camera& camera, double aspect, glm::dvec2& low, glm::dvec2& high)
{
    for (int i = 0; i < 8; ++i) {
        const auto ndc = camera.project(box.corner(i), aspect);
        if (!ndc)
            return false;
        low = glm::min(low, *ndc);
        high = glm::max(high, *ndc);
    }
    return true;
}

} // namespace

std::optional<OutlineExtent> outlineExtent(const RenderScene& scene, const Camera& camera,
                                           const glm::vec2& picture)
{
    const double aspect = double(picture.x) / std::max(1.0, double(picture.y));
    glm::dvec2 low(1.0), high(-1.0);
    bool any = false, all = true, whole = true, dense = false;
    const auto add = [&](const Box& box) {
        if (box.empty())
            return;
        any = true;
        all = all && addProjected(box, camera, aspect, low, high);
    };
    for (const MeshItem& item : scene.meshes) {
        if (!item.outlined)
            continue;
        add((item.motion.moves() ? item.box : item.outlined->box).transformed(item.world));
        whole = whole && !item.outlined->ofBranches;
        // Leaves and fruit, or a mesh that is not drawn whole: what shows between them is no shape.
        dense = dense || item.copies || !item.outlined->runs.empty();
    }
    for (const LineItem& item : scene.lines) {
        if (item.outlined == OutlinedLines::None)
            continue;
        add(item.lines->box.transformed(item.world));
        all = all && !item.motion.moves();
        whole = whole && item.outlined == OutlinedLines::All && item.pickable;
    }
    if (!any)
        return std::nullopt;
    OutlineExtent extent{glm::vec2(0.0f), picture, whole, whole && dense};
    if (!all)
        return extent;
    const float room = 4.0f * coarseOffset;
    extent.low = glm::max((0.5f + 0.5f * glm::vec2(low)) * picture - room, glm::vec2(0.0f));
    extent.high = glm::min((0.5f + 0.5f * glm::vec2(high)) * picture + room, picture);
    if (extent.low.x >= extent.high.x || extent.low.y >= extent.high.y)
        return std::nullopt;
    return extent;
}

OutlinedFaces outlinedBranches(const TriangleMesh& mesh, const std::vector<bool>& branches)
{
    OutlinedFaces faces;
    faces.ofBranches = true;
    const auto isOne = [&](Index vertex) {
        const Index branch = mesh.branch[vertex];
        return branch < branches.size() && branches[branch];
    };
    for (Index f = 0; f < mesh.faceCount(); ++f) {
        const glm::uvec3& t = mesh.triangles[f];
        if (!isOne(t.x) && !isOne(t.y) && !isOne(t.z))
            continue;
        for (int corner = 0; corner < 3; ++corner)
            faces.box.add(glm::dvec3(mesh.positions[t[corner]]));
        if (!faces.runs.empty() && faces.runs.back().first + faces.runs.back().second == f)
            ++faces.runs.back().second;
        else
            faces.runs.emplace_back(f, 1);
    }
    return faces;
}

// Half of what is kept are the largest faces, a trunk's: gaps between those would be too wide to close. The
// rest is spread evenly.
OutlinedFaces outlinedWhole(const DeferredMesh& whole, const Box& box, Index most)
{
    OutlinedFaces faces;
    faces.box = box;
    const Index count = whole.faceCount();
    if (most == 0 || count <= most)
        return faces;
    const TriangleMesh& mesh = *whole;
    const Index runs = (count + runLength - 1) / runLength;
    std::vector<std::pair<float, Index>> sizes; // twice a run's area, and which
    for (Index run = 0; run < runs; ++run) {
        float area = 0.0f;
        for (Index f = run * runLength; f < std::min(count, (run + 1) * runLength); ++f) {
            const glm::uvec3& t = mesh.triangles[f];
            area += glm::length(glm::cross(mesh.positions[t.y] - mesh.positions[t.x],
                                           mesh.positions[t.z] - mesh.positions[t.x]));
        }
        sizes.emplace_back(area, run);
    }
    const Index half = std::max<Index>(1, most / runLength / 2);
    std::ranges::nth_element(sizes, sizes.begin() + half, std::greater<>());
    std::vector<bool> kept(runs, false);
    for (Index i = 0; i < half; ++i) {
        kept[sizes[i].second] = true;
        kept[static_cast<Index>(std::uint64_t(i) * runs / half)] = true;
    }
    for (Index run = 0; run < runs; ++run) {
        const Index first = run * runLength, faceCount = std::min(runLength, count - first);
        if (!kept[run])
            continue;
        if (!faces.runs.empty() && faces.runs.back().first + faces.runs.back().second == first)
            faces.runs.back().second += faceCount;
        else
            faces.runs.emplace_back(first, faceCount);
    }
    return faces;
}

Outline::Outline(Gl& gl)
    : m_gl(gl)
{
}

Outline::~Outline()
{
    free();
}

void Outline::free()
{
    if (m_textures[0] == 0)
        return;
    m_gl.glDeleteFramebuffers(3, m_framebuffers);
    m_gl.glDeleteTextures(3, m_textures);
    m_textures[0] = 0;
}

void Outline::allocate(int width, int height)
{
    if (m_textures[0] != 0 && width == m_width && height == m_height)
        return;
    free();
    m_width = width;
    m_height = height;
    m_gl.glGenTextures(3, m_textures);
    m_gl.glGenFramebuffers(3, m_framebuffers);
    bool complete = true;
    for (int i = 0; i < 3; ++i) {
        const bool depth = i == 0;
        m_gl.glBindTexture(GL_TEXTURE_2D, m_textures[i]);
        m_gl.glTexImage2D(GL_TEXTURE_2D, 0, depth ? GL_DEPTH_COMPONENT24 : GL_R8, width, height, 0,
                          depth ? GL_DEPTH_COMPONENT : GL_RED, depth ? GL_UNSIGNED_INT : GL_UNSIGNED_BYTE,
                          nullptr);
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
        complete = complete && m_gl.glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    }
    m_gl.glBindTexture(GL_TEXTURE_2D, 0);
    if (!complete)
        free();
}

bool Outline::begin(const OutlineExtent& extent, const glm::vec2& picture, double pixelRatio)
{
    m_extent = extent;
    m_picture = picture;
    m_ratio = static_cast<float>(pixelRatio);
    m_scale = std::max(1.0f, std::round(m_ratio * (extent.dense ? 4.0f : 2.0f)));
    GLint before = 0;
    m_gl.glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before);
    allocate(int(std::ceil(picture.x / m_scale)), int(std::ceil(picture.y / m_scale)));
    if (m_textures[0] == 0) {
        m_gl.glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(before));
        return false;
    }
    m_gl.glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffers[0]);
    m_gl.glViewport(0, 0, m_width, m_height);
    m_gl.glDisable(GL_BLEND);
    m_gl.glDepthFunc(GL_LESS);
    m_gl.glDepthMask(GL_TRUE);
    m_gl.glClear(GL_DEPTH_BUFFER_BIT);
    return true;
}

void Outline::mask(const OutlinedFaces& faces, GLsizei count)
{
    if (faces.runs.empty()) {
        if (!faces.ofBranches)
            m_gl.glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, nullptr);
        return;
    }
    m_counts.clear();
    m_offsets.clear();
    for (const auto& [first, run] : faces.runs) {
        m_counts.push_back(static_cast<GLsizei>(3 * run));
        m_offsets.push_back(reinterpret_cast<const void*>(std::uintptr_t(first) * 3 * sizeof(GLuint)));
    }
    m_gl.glMultiDrawElements(GL_TRIANGLES, m_counts.data(), GL_UNSIGNED_INT, m_offsets.data(),
                             static_cast<GLsizei>(m_counts.size()));
}

void Outline::pass(GLuint framebuffer, GLuint source, ShaderProgram& program)
{
    m_gl.glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    m_gl.glBindTexture(GL_TEXTURE_2D, source);
    program.bind();
    program.set("uSource", 0);
    m_gl.glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Outline::end(GLuint target, const Programs& programs, float opacity)
{
    const auto cut = [this](float scale, int margin) {
        const glm::ivec2 low = glm::ivec2(glm::floor(m_extent.low / scale)) - margin;
        const glm::ivec2 high = glm::ivec2(glm::ceil(m_extent.high / scale)) + margin;
        m_gl.glScissor(std::max(0, low.x), std::max(0, low.y), high.x - std::max(0, low.x),
                       high.y - std::max(0, low.y));
    };
    m_gl.glDisable(GL_DEPTH_TEST);
    m_gl.glDepthMask(GL_FALSE);
    m_gl.glEnable(GL_SCISSOR_TEST);
    m_gl.glActiveTexture(GL_TEXTURE0);
    m_gl.glBindSampler(0, 0);
    cut(m_scale, reach + 1);
    pass(m_framebuffers[1], m_textures[0], programs.rows);
    pass(m_framebuffers[2], m_textures[1], programs.columns);
    if (m_extent.coarse) { // around a crown, not around its leaves
        pass(m_framebuffers[1], m_textures[2], programs.closing);
        pass(m_framebuffers[2], m_textures[1], programs.columns);
    }

    m_gl.glBindFramebuffer(GL_FRAMEBUFFER, target);
    m_gl.glViewport(0, 0, int(m_picture.x), int(m_picture.y));
    cut(1.0f, 0);
    m_gl.glEnable(GL_BLEND);
    m_gl.glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    m_gl.glBindTexture(GL_TEXTURE_2D, m_textures[2]);
    programs.ink.bind();
    programs.ink.set("uDistance", 0);
    programs.ink.set("uTexel", 1.0f / m_picture);
    programs.ink.set("uClosed", m_extent.coarse);
    programs.ink.set("uScale", m_scale);
    programs.ink.set("uOffset", m_ratio * (m_extent.dense    ? coarseOffset
                                           : m_extent.coarse ? wholeOffset
                                                             : fineOffset));
    programs.ink.set("uWidth", m_ratio * lineWidth);
    programs.ink.set("uOpacity", opacity);
    m_gl.glDrawArrays(GL_TRIANGLES, 0, 3);
    m_gl.glDisable(GL_SCISSOR_TEST);
    m_gl.glDepthMask(GL_TRUE);
}

} // namespace ramure
