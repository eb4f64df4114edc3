/// \file
/// A line around the selection, visible through everything in front of it. The selection is drawn into a
/// small mask, and the line is drawn at the right distance from it. Thin twigs and gaps between leaves, for
/// which a wider mesh would fail, cost no more.
#pragma once

#include "widgets/view/render/camera.h"
#include "widgets/view/render/render_scene.h"
#include "widgets/view/render/shader_program.h"
#include <optional>

namespace ramure {

/// The region in which the line may run.
struct OutlineExtent
{
    glm::vec2 low{0.0f}, high{0.0f}; ///< device pixels from the lower left
    bool coarse = false;             ///< whole nodes only: narrow gaps are closed
    bool dense = false;              ///< with a crown among them: wider ones, too
};

/// Nothing where nothing is outlined, or nothing of it can be seen. \param picture device pixels.
std::optional<OutlineExtent> outlineExtent(const RenderScene& scene, const Camera& camera,
                                           const glm::vec2& picture);

/// The runs of faces of some branches.
OutlinedFaces outlinedBranches(const TriangleMesh& mesh, const std::vector<bool>& branches);
/// All of a mesh; of one of many small faces about \p most, which close to the same outline. 0: always all.
OutlinedFaces outlinedWhole(const DeferredMesh& whole, const Box& box, Index most);

/// Every function needs the context current in which the first was called.
class Outline
{
public:
    struct Programs
    {
        ShaderProgram& rows;
        ShaderProgram& columns;
        ShaderProgram& closing; ///< along rows
        ShaderProgram& ink;
    };

    explicit Outline(Gl& gl);
    ~Outline();
    Outline(const Outline&) = delete;
    Outline& operator=(const Outline&) = delete;

    /// Clears and binds the mask; depth is all that is drawn into it. False where the driver refuses it.
    bool begin(const OutlineExtent& extent, const glm::vec2& picture, double pixelRatio);
    [[nodiscard]] glm::vec2 maskSize() const { return glm::vec2(m_width, m_height); }
    /// Draws these faces of the vertex array that is bound. \param count of all its indices.
    void mask(const OutlinedFaces& faces, GLsizei count);
    /// Draws the line into \p target, blending; any vertex array must be bound. Leaves the depth test off.
    void end(GLuint target, const Programs& programs, float opacity);

private:
    void allocate(int width, int height);
    void free();
    void pass(GLuint framebuffer, GLuint source, ShaderProgram& program);

    Gl& m_gl;
    int m_width = 0, m_height = 0;    ///< size of the mask, texels
    GLuint m_textures[3] = {0, 0, 0}; ///< the mask's depths, distances along rows, distances
    GLuint m_framebuffers[3] = {0, 0, 0};
    OutlineExtent m_extent;
    glm::vec2 m_picture{1.0f};
    float m_scale = 2.0f; ///< pixels per texel
    float m_ratio = 1.0f;
    std::vector<GLsizei> m_counts; ///< kept between pictures
    std::vector<const void*> m_offsets;
};

} // namespace ramure
