#include "core/lod/card_painter.h"

#include "core/math/srgb.h"
#include "core/surface/bark/bark_maps.h"
#include "core/surface/bark/bark_tints.h"
#include "core/surface/foliage/leaf_maps.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace ramure {
namespace {

constexpr int leafPixels = 64, barkPixels = 128; ///< a side of the pictures that are drawn
constexpr float leastOpacity = 0.5F;

int wrapped(float x, int size)
{
    const float part = x - std::floor(x);
    return std::clamp(static_cast<int>(part * float(size)), 0, size - 1);
}

/// One mesh at one place, as the view sees it.
class MeshPainter
{
public:
    MeshPainter(PaintedSamples& samples, const PaintedView& view, const TriangleMesh& mesh,
                const SurfaceLook& look)
        : m_samples(samples)
        , m_view(view)
        , m_mesh(mesh)
        , m_look(look)
        , m_hasUv(look.size > 0 && !mesh.uv.empty())
        , m_hasTints(look.bark && mesh.radius.size() == mesh.positions.size())
        , m_scale(glm::vec2(float(samples.width), float(samples.height)) / (2.0F * glm::vec2(view.half)))
    {
        if (m_hasTints)
            m_tints.emplace(*look.bark);
    }

    void draw(const FoliageItem* copy)
    {
        const glm::dmat3 axes =
            glm::transpose(glm::dmat3(m_view.frame.right, m_view.frame.up, m_view.frame.backward));
        const glm::dmat3 turn = copy ? axes * glm::mat3_cast(copy->orientation) : axes;
        const double size = copy ? double(copy->size) : 1.0;
        const glm::dvec3 at = axes * ((copy ? copy->position : glm::dvec3(0.0)) - m_view.middle);
        m_tone = copy ? linearTone(copy->tone * copy->tint) : glm::vec3(1.0F);
        const auto count = m_mesh.positions.size();
        m_places.resize(count);
        m_normals.resize(m_mesh.normals.size());
        const glm::mat3 scaled(turn * size), turned(turn);
        const glm::vec3 middle(at), half(m_view.half, 0.0F), scale(m_scale, 1.0F);
        for (std::size_t v = 0; v < count; ++v)
            m_places[v] = (scaled * m_mesh.positions[v] + middle + half) * scale;
        for (std::size_t v = 0; v < m_normals.size(); ++v)
            m_normals[v] = turned * m_mesh.normals[v];
        for (std::size_t t = 0; t < m_mesh.triangles.size(); ++t)
            triangle(t);
    }

private:
    static glm::vec3 linearTone(const glm::vec3& tone)
    {
        return linearOf(glm::u8vec3(glm::clamp(255.0F * tone + 0.5F, 0.0F, 255.0F)));
    }

    void triangle(std::size_t t)
    {
        const glm::uvec3& face = m_mesh.triangles[t];
        const glm::vec3 &a = m_places[face.x], &b = m_places[face.y], &c = m_places[face.z];
        const float area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        if (!(std::abs(area) > 1e-9F))
            return;
        const auto range = [](float p, float q, float r, int most) {
            return std::pair(std::clamp(int(std::floor(std::min({p, q, r}) - 0.5F)), 0, most),
                             std::clamp(int(std::ceil(std::max({p, q, r}) + 0.5F)), 0, most));
        };
        const auto [left, right] = range(a.x, b.x, c.x, m_samples.width);
        const auto [low, high] = range(a.y, b.y, c.y, m_samples.height);
        for (int y = low; y < high; ++y)
            for (int x = left; x < right; ++x) {
                const glm::vec2 p(float(x) + 0.5F, float(y) + 0.5F);
                const float u = ((b.x - p.x) * (c.y - p.y) - (b.y - p.y) * (c.x - p.x)) / area;
                const float v = ((c.x - p.x) * (a.y - p.y) - (c.y - p.y) * (a.x - p.x)) / area;
                const float w = 1.0F - u - v;
                const std::size_t at = std::size_t(y) * std::size_t(m_samples.width) + std::size_t(x);
                const float depth = u * a.z + v * b.z + w * c.z;
                if (u >= 0.0F && v >= 0.0F && w >= 0.0F && depth > m_samples.depth[at])
                    sample(t, {u, v, w}, at, depth);
            }
    }

    void sample(std::size_t t, const glm::vec3& part, std::size_t at, float depth)
    {
        const glm::uvec3& face = m_mesh.triangles[t];
        glm::vec3 colour = m_look.colour * m_tone * (m_hasUv ? glm::vec3(1.0F) : m_look.mean);
        std::size_t pixel = 0;
        if (m_hasUv) {
            const glm::uvec3& corner = m_mesh.uvTriangles.empty() ? face : m_mesh.uvTriangles[t];
            const glm::vec2 uv =
                part.x * m_mesh.uv[corner.x] + part.y * m_mesh.uv[corner.y] + part.z * m_mesh.uv[corner.z];
            pixel = std::size_t(wrapped(uv.y, m_look.size)) * std::size_t(m_look.size) +
                    std::size_t(wrapped(uv.x, m_look.size));
            if (m_look.pixels[pixel].a < leastOpacity)
                return;
            colour *= glm::vec3(m_look.pixels[pixel]);
        }
        if (!m_mesh.colours.empty())
            colour *= linearOf(m_mesh.colours[t]);
        if (m_hasTints)
            colour *= m_tints->at(m_mesh.radius[face.x], m_mesh.positions[face.x]);
        m_samples.depth[at] = depth;
        m_samples.colour[at] = colour;
        m_samples.normal[at] = normalAt(t, part, pixel);
    }

    /// Both sides are seen.
    [[nodiscard]] glm::vec3 normalAt(std::size_t t, const glm::vec3& part, std::size_t pixel) const
    {
        const glm::uvec3& face = m_mesh.triangles[t];
        glm::vec3 normal(0.0F, 0.0F, 1.0F);
        if (!m_normals.empty())
            normal = part.x * m_normals[face.x] + part.y * m_normals[face.y] + part.z * m_normals[face.z];
        if (m_hasUv && !m_look.normals.empty()) {
            const auto unscaled = [&](Index v) { return m_places[v] / glm::vec3(m_scale, 1.0F); };
            const glm::uvec3& corner = m_mesh.uvTriangles.empty() ? face : m_mesh.uvTriangles[t];
            const glm::vec3 e = unscaled(face.y) - unscaled(face.x), f = unscaled(face.z) - unscaled(face.x);
            const glm::vec2 d = m_mesh.uv[corner.y] - m_mesh.uv[corner.x],
                            g = m_mesh.uv[corner.z] - m_mesh.uv[corner.x];
            const float turn = d.x * g.y - g.x * d.y < 0.0F ? -1.0F : 1.0F;
            const glm::vec3 along = turn * (g.y * e - d.y * f), across = turn * (d.x * f - g.x * e);
            const glm::vec3& own = m_look.normals[pixel];
            const float size = std::max(glm::length(along), 1e-30F),
                        other = std::max(glm::length(across), 1e-30F);
            normal = own.x / size * along + own.y / other * across + own.z * normal;
        }
        if (normal.z < 0.0F)
            normal = -normal;
        const float length = glm::length(normal);
        return length > 1e-9F ? normal / length : glm::vec3(0.0F, 0.0F, 1.0F);
    }

    PaintedSamples& m_samples;
    const PaintedView& m_view;
    const TriangleMesh& m_mesh;
    const SurfaceLook& m_look;
    bool m_hasUv, m_hasTints;
    glm::vec2 m_scale; ///< samples a metre
    std::optional<BarkTints> m_tints;
    glm::vec3 m_tone{1.0F};
    std::vector<glm::vec3> m_places, m_normals;
};

template <class Maps> void takePixels(SurfaceLook& look, const Maps& maps, const glm::vec3& per)
{
    look.size = maps.size;
    for (const glm::u8vec3& pixel : maps.colour)
        look.pixels.emplace_back(linearOf(pixel) / per, 1.0F);
    look.mean = glm::vec3(0.0F);
    for (const glm::vec4& pixel : look.pixels)
        look.mean += glm::vec3(pixel) / float(look.pixels.size());
}

} // namespace

PaintedSamples::PaintedSamples(int w, int h)
    : width(w)
    , height(h)
    , depth(std::size_t(w) * std::size_t(h), -std::numeric_limits<float>::infinity())
    , colour(depth.size(), glm::vec3(0.0F))
    , normal(depth.size(), glm::vec3(0.0F))
{
}

bool PaintedSamples::isCovered(std::size_t at) const
{
    return !std::isinf(depth[at]);
}

void PaintedSamples::moveBack()
{
    for (float& each : depth)
        if (!std::isinf(each))
            each = std::numeric_limits<float>::lowest();
}

Expected<SurfaceLook> lookOf(const ShownSurface& surface, const Progress& progress)
{
    SurfaceLook look;
    look.colour = linearOf(surface.colour);
    if (surface.leaf.shape != LeafShape::Faithful) {
        const auto maps = leafMaps(surface.leaf.shape, leafPixels);
        RAMURE_TRY(maps);
        takePixels(look, *maps, glm::max(linearOf(maps->blade), glm::vec3(1e-3F)));
    } else if (surface.bark.family != BarkFamily::Plain) {
        const auto maps = barkMaps(surface.bark, barkPixels, progress);
        RAMURE_TRY(maps);
        takePixels(look, *maps, glm::vec3(1.0F));
        look.colour = glm::vec3(1.0F);
        look.bark = surface.bark;
    }
    return look;
}

void paint(PaintedSamples& samples, const PaintedView& view, const ShownSurface& surface,
           const SurfaceLook& look)
{
    MeshPainter painter(samples, view, *surface.mesh, look);
    if (surface.copies.empty())
        painter.draw(nullptr);
    for (const FoliageItem& copy : surface.copies)
        painter.draw(&copy);
}

} // namespace ramure
