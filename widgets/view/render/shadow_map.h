/// \file
/// The sun's depth picture of everything that throws a shadow, fitted to it: works for a bonsai and for a
/// forest.
#pragma once

#include "widgets/view/render/gpu_cache.h"
#include <optional>

namespace ramure {

/// Where the map lies in the world.
struct ShadowFit
{
    glm::dmat4 clip{1.0}; ///< world -> clip space of the map
    double side = 1.0;    ///< of the square that the map covers, m
    double depth = 1.0;   ///< range of its depth, m
};
/// \param casters world box of what throws shadows, not empty; \param sun unit, towards it; \param size in
/// texels.
ShadowFit fitShadow(const Box& casters, const glm::dvec3& sun, int size);

/// Every function needs the map's context current.
class ShadowMap
{
public:
    static constexpr int size = 2048;

    explicit ShadowMap(Gl& gl);
    ~ShadowMap();
    ShadowMap(const ShadowMap&) = delete;
    ShadowMap& operator=(const ShadowMap&) = delete;

    /// Redraws the map if what throws shadows or the sun has changed. Binds its own framebuffer and viewport.
    /// \returns nothing where there is no caster.
    std::optional<ShadowFit> update(const RenderScene& scene, const glm::dvec3& sun, GpuCache& cache,
                                    ShaderProgram& program);
    /// Binds the depth to two units: one that compares, one that reads.
    void bind(GLenum compareUnit, GLenum readUnit);
    [[nodiscard]] std::uint64_t redraws() const { return m_redraws; }

private:
    struct Caster
    {
        const MeshItem* item; ///< of the scene at hand
        std::shared_ptr<const TriangleMesh> mesh;
        std::shared_ptr<const MeshCopies> copies;
        ItemMotion motion;
        glm::dmat4 world;
        bool operator==(const Caster& other) const
        {
            return mesh == other.mesh && copies == other.copies && motion == other.motion &&
                   world == other.world;
        }
    };
    void create();

    Gl& m_gl;
    GLuint m_texture = 0;
    GLuint m_framebuffer = 0;
    GLuint m_compareSampler = 0;
    GLuint m_readSampler = 0;
    std::vector<Caster> m_drawn;
    glm::dvec3 m_sun{0.0};
    std::uint64_t m_redraws = 0;
    ShadowFit m_fit;
};

} // namespace ramure
