/// \file
/// The sun's depth picture of everything that throws a shadow, fitted to it: works for a bonsai and for a
/// forest.
#pragma once

#include "widgets/view/render/stream/gpu_cache.h"
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

/// A place that a second, finer map is for.
struct ShadowFocus
{
    glm::dvec3 centre{0.0}; ///< world
    double radius = 1.0;    ///< m
    bool operator==(const ShadowFocus&) const = default;
};
/// The same depth, less of the sides: all that throws a shadow into the place.
ShadowFit fitShadow(const Box& casters, const glm::dvec3& sun, const ShadowFocus& focus);

/// For shaders, which have positions relative to the eye.
struct ShadowPlace
{
    glm::mat4 place{1.0f}; ///< -> 0..1 on the map and in depth
    glm::vec3 scale{1.0f}; ///< m: one texel, the side, the depth
};
ShadowPlace placeOf(const ShadowFit& fit, const glm::dvec3& eye);

/// What draws depth alone.
struct DepthPrograms
{
    ShaderProgram& whole;
    ShaderProgram& cut; ///< of surfaces that a picture cuts out
    static bool cuts(const MeshItem& item) { return item.images && item.images->isCut; }
    ShaderProgram& of(const MeshItem& item) const
    {
        return (cuts(item) ? cut : whole).with(item.motion.isStill(), switches::still);
    }
};

/// Every function needs the map's context current.
class ShadowMap
{
public:
    static constexpr int size = 2048;

    explicit ShadowMap(Gl& gl);
    ~ShadowMap();
    ShadowMap(const ShadowMap&) = delete;
    ShadowMap& operator=(const ShadowMap&) = delete;

    /// Redraws the map if what throws shadows, the sun or the focus has changed. Binds its own framebuffer
    /// and viewport. \param pass of the \p parts that it is. \returns nothing where there is no caster.
    std::optional<ShadowFit> update(const RenderScene& scene, const glm::dvec3& sun, GpuCache& cache,
                                    const DepthPrograms& programs, PictureParts& parts,
                                    PictureParts::Pass pass, LeafDetail detail,
                                    const std::optional<ShadowFocus>& focus = {});
    /// Binds the depth to two units: one that compares, one that reads.
    void bind(GLenum compareUnit, GLenum readUnit);
    [[nodiscard]] std::uint64_t redraws() const { return m_redraws; }

private:
    struct Caster
    {
        const MeshItem* item; ///< of the scene at hand
        DeferredMesh mesh;
        std::shared_ptr<const MeshCopies> copies;
        std::shared_ptr<const std::vector<MeshCopy>> places;
        std::shared_ptr<const SurfaceImages> images;
        ItemMotion motion;
        glm::dmat4 world;
        bool operator==(const Caster& other) const
        {
            return mesh == other.mesh && copies == other.copies && places == other.places &&
                   images == other.images && motion == other.motion && world == other.world;
        }
    };
    void create();

    Gl& m_gl;
    GLuint m_texture = 0;
    GLuint m_framebuffer = 0;
    GLuint m_compareSampler = 0;
    GLuint m_readSampler = 0;
    std::vector<Caster> m_drawn;
    bool m_isWhole = false; ///< all of them are
    glm::dvec3 m_sun{0.0};
    WindMoment m_wind; ///< where something stands in it
    std::optional<ShadowFocus> m_focus;
    LeafDetail m_detail = LeafDetail::Few;
    std::uint64_t m_redraws = 0;
    ShadowFit m_fit;
};

} // namespace ramure
