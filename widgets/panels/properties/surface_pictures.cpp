#include "widgets/panels/properties/surface_pictures.h"

#include "core/scene/material.h"
#include "core/surface/bark/bark_maps.h"
#include "core/surface/foliage/foliage_texture.h"
#include "core/surface/foliage/leaf_maps.h"
#include "core/surface/foliage/place_foliage.h"
#include "widgets/view/render/surface_images.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>

namespace ramure {
namespace {

const glm::vec3 toLight = glm::normalize(glm::vec3(-0.5f, 0.6f, 0.7f)); ///< x right, y up, z to the eye
constexpr float ambient = 0.35f;
constexpr int oversampling = 2; ///< drawn so many times larger, for smooth edges

/// \param light of it falls on the surface, linear; 1 shows the colour as it is.
QRgb shaded(const glm::u8vec3& colour, float light)
{
    const auto channel = [light](std::uint8_t value) {
        const float linear = std::pow(float(value) / 255.0f, 2.2f) * light;
        return static_cast<int>(255.0f * std::pow(std::clamp(linear, 0.0f, 1.0f), 1.0f / 2.2f) + 0.5f);
    };
    return qRgb(channel(colour.r), channel(colour.g), channel(colour.b));
}

QImage smooth(const QImage& large)
{
    return large.scaled(large.size() / oversampling, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

glm::vec3 normalOf(const glm::u8vec3& stored)
{
    return (glm::vec3(stored) - 128.0f) / 127.0f;
}

/// Draws the triangles of a leaf or a fruit, seen from +Z, into a square picture.
class OrganPainter
{
public:
    OrganPainter(const TriangleMesh& mesh, const Material& material, const std::optional<LeafMaps>& maps,
                 int size)
        : m_mesh(mesh)
        , m_material(material)
        , m_maps(maps)
        , m_picture(size, size, QImage::Format_ARGB32)
        , m_height(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), -1e9f)
    {
        m_picture.fill(Qt::transparent);
        glm::vec2 low(1e9f), high(-1e9f);
        for (const glm::vec3& p : mesh.positions) {
            low = glm::min(low, glm::vec2(p));
            high = glm::max(high, glm::vec2(p));
        }
        const glm::vec2 extent = glm::max(high - low, glm::vec2(1e-6f));
        m_scale = 0.94f * float(size) / std::max(extent.x, extent.y);
        m_middle = 0.5f * (low + high);
    }

    QImage paint()
    {
        for (Index face = 0; face < m_mesh.faceCount(); ++face)
            paintFace(face);
        return m_picture;
    }

private:
    [[nodiscard]] glm::vec2 onPicture(const glm::vec3& p) const
    {
        const float half = 0.5f * float(m_picture.width());
        return {half + m_scale * (p.x - m_middle.x), half - m_scale * (p.y - m_middle.y)};
    }

    void paintFace(Index face)
    {
        const glm::uvec3 corners = m_mesh.triangles[face];
        const glm::vec2 a = onPicture(m_mesh.positions[corners.x]),
                        b = onPicture(m_mesh.positions[corners.y]),
                        c = onPicture(m_mesh.positions[corners.z]);
        const float area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        if (std::abs(area) < 1e-9f)
            return;
        const int last = m_picture.width() - 1;
        const auto from = [last](float v) { return std::clamp(static_cast<int>(std::floor(v)), 0, last); };
        for (int y = from(std::min({a.y, b.y, c.y})); y <= from(std::max({a.y, b.y, c.y})); ++y)
            for (int x = from(std::min({a.x, b.x, c.x})); x <= from(std::max({a.x, b.x, c.x})); ++x) {
                const glm::vec2 p(float(x) + 0.5f, float(y) + 0.5f);
                const float u = ((b.x - p.x) * (c.y - p.y) - (b.y - p.y) * (c.x - p.x)) / area;
                const float v = ((c.x - p.x) * (a.y - p.y) - (c.y - p.y) * (a.x - p.x)) / area;
                if (u >= 0.0f && v >= 0.0f && u + v <= 1.0f)
                    paintPixel(face, x, y, {u, v, 1.0f - u - v});
            }
    }

    void paintPixel(Index face, int x, int y, const glm::vec3& weights)
    {
        const glm::uvec3 corners = m_mesh.triangles[face];
        const auto mixedAt = [&](const glm::uvec3& which, const auto& values) {
            return weights.x * values[which.x] + weights.y * values[which.y] + weights.z * values[which.z];
        };
        const auto mixed = [&](const auto& values) { return mixedAt(corners, values); };
        const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(m_picture.width()) +
                        static_cast<std::size_t>(x);
        const float height = mixed(m_mesh.positions).z;
        if (height <= m_height[at])
            return;
        m_height[at] = height;
        glm::vec3 normal = m_mesh.normals.empty() ? glm::vec3(0, 0, 1) : mixed(m_mesh.normals);
        if (normal.z < 0.0f)
            normal = -normal; // both sides are seen
        glm::vec3 colour = glm::vec3(m_material.colour) / 255.0f;
        if (m_maps && !m_mesh.uv.empty()) {
            const glm::uvec3 places = m_mesh.uvTriangles.empty() ? corners : m_mesh.uvTriangles[face];
            const glm::vec2 uv = mixedAt(places, m_mesh.uv) * float(m_maps->size);
            const auto texel = [this](float value) {
                return static_cast<std::size_t>(std::clamp(static_cast<int>(value), 0, m_maps->size - 1));
            };
            const std::size_t place = texel(uv.y) * static_cast<std::size_t>(m_maps->size) + texel(uv.x);
            if (!m_maps->coverage.empty() && m_maps->coverage[place] < 128)
                return;
            colour *= glm::vec3(m_maps->colour[place]) / glm::max(glm::vec3(m_maps->blade), 1.0f);
            const glm::vec3 relief = normalOf(m_maps->normal[place]);
            normal += glm::vec3(relief.x, relief.y, 0.0f);
        }
        if (!m_mesh.colours.empty())
            colour *= glm::vec3(m_mesh.colours[face]) / 255.0f;
        const float light = ambient + 1.1f * std::max(0.0f, glm::dot(glm::normalize(normal), toLight));
        m_picture.setPixel(x, y, shaded(glm::u8vec3(glm::clamp(colour * 255.0f, 0.0f, 255.0f)), light));
    }

    const TriangleMesh& m_mesh;
    const Material& m_material;
    const std::optional<LeafMaps>& m_maps; ///< where it has coverage, some of the surface is not there
    QImage m_picture;
    std::vector<float> m_height;
    float m_scale = 1.0f;
    glm::vec2 m_middle{0.0f};
};

/// The bark at a place of the tile, or its one colour.
struct BarkSample
{
    glm::u8vec3 colour;
    glm::vec3 normal{0, 0, 1};
    float open = 1.0f, gloss = 0.0f;
};

BarkSample sampleOf(const std::optional<BarkMaps>& maps, const Material& material, double u, double v)
{
    if (!maps)
        return {material.colour};
    const auto texel = [&maps](double value) {
        return static_cast<std::size_t>((value - std::floor(value)) * maps->size) %
               static_cast<std::size_t>(maps->size);
    };
    const std::size_t at = texel(v) * static_cast<std::size_t>(maps->size) + texel(u);
    return {maps->colour[at], normalOf(maps->normal[at]), float(maps->occlusion[at]) / 255.0f,
            1.0f - float(maps->roughness[at]) / 255.0f};
}

std::vector<glm::u8vec3> colourOf(const std::vector<glm::u8vec4>& pixels)
{
    return {pixels.begin(), pixels.end()};
}

/// The image files of a leaf or a fruit, as if they were the maps of a leaf.
LeafMaps imageMaps(const Material& material)
{
    const SurfaceImages images = surfaceImages(material);
    LeafMaps maps{images.size, images.base, colourOf(images.colour), colourOf(images.normal), {}, {}, {}};
    for (const glm::u8vec4& each : images.colour)
        maps.coverage.push_back(each.a);
    return maps;
}

QRgb barkPixel(const BarkSample& sample, const glm::vec3& right, const glm::vec3& up,
               const glm::vec3& outward)
{
    const glm::vec3 normal =
        glm::normalize(sample.normal.x * right + sample.normal.y * up + sample.normal.z * outward);
    const glm::vec3 half = glm::normalize(toLight + glm::vec3(0, 0, 1));
    const float glint = sample.gloss * std::pow(std::max(0.0f, glm::dot(normal, half)), 24.0f);
    const float light = std::max(0.0f, glm::dot(normal, toLight));
    return shaded(sample.colour, sample.open * ambient + 1.1f * light + 0.6f * glint);
}

} // namespace

QImage leafPicture(const LeafParams& leaf, bool turns, int size, const PictureParams& pictures)
{
    LeafForm form = leafForm(leaf);
    form.turns = turns;
    form.perShoot = 1;
    form.length = 0.0; // the picture has no scale
    TriangleMesh mesh = oneLeaf(form, 1.0, FoliageModel::Fine);
    if (mesh.uv.empty())
        addLeafTexture(mesh, form);
    const Material material = leavesMaterial(leaf.shape, turns, pictures);
    std::optional<LeafMaps> maps;
    if (!pictures.isEmpty()) {
        maps = imageMaps(material);
    } else if (leaf.shape != LeafShape::Faithful) {
        if (auto made = leafMaps(leaf.shape, std::clamp(size, leastLeafSize, mostLeafSize)))
            maps = std::move(*made);
        if (maps)
            maps->coverage.clear(); // the mesh has the outline
    }
    return smooth(OrganPainter(mesh, material, maps, oversampling * size).paint());
}

QImage fruitPicture(const FruitParams& fruit, int size, const PictureParams& pictures)
{
    const FruitForm form = fruitForm(fruit);
    TriangleMesh mesh = fruitMesh(form);
    const Material material = applesMaterial(fruit.kind, pictures);
    std::optional<LeafMaps> maps;
    if (!pictures.isEmpty()) {
        addAppleTexture(mesh, form);
        mesh.colours.clear(); // the picture takes their place
        maps = imageMaps(material);
    }
    return smooth(OrganPainter(mesh, material, maps, oversampling * size).paint());
}

QImage barkPicture(const Material& material, int size, const Progress& progress)
{
    const BarkParams& bark = material.bark;
    std::optional<BarkMaps> maps;
    if (!material.pictures.isEmpty()) {
        const SurfaceImages images = surfaceImages(material);
        const std::size_t count = images.colour.size();
        maps = {images.size, colourOf(images.colour), colourOf(images.normal), {}, {}, {}, 0.0f};
        maps->occlusion.assign(count, 255); // it is in the colour
        for (const glm::u8vec4& each : images.normal)
            maps->roughness.push_back(material.pictures.roughness.empty() ? 255 : each.a);
    } else if (bark.family != BarkFamily::Plain) {
        auto made = barkMaps(bark, std::clamp(oversampling * size, leastBarkSize, mostBarkSize), progress);
        if (!made)
            return {};
        maps = std::move(*made);
    }
    size *= oversampling;
    QImage picture(2 * size, size, QImage::Format_ARGB32);
    picture.fill(Qt::transparent);
    const glm::vec3 right(1, 0, 0), up(0, 1, 0), outward(0, 0, 1);
    const double gap = std::max(2.0, 0.03 * size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const double across = 2.0 * (x + 0.5) / size - 1.0, above = 1.0 - 2.0 * (y + 0.5) / size;
            const double square = across * across + above * above;
            if (square < 0.94 * 0.94) {
                const glm::vec3 n = glm::normalize(
                    glm::vec3(float(across), float(above), float(std::sqrt(0.94 * 0.94 - square))));
                const double around = std::atan2(double(n.x), double(n.z)) / std::numbers::pi;
                const double along = std::asin(std::clamp(double(n.y), -1.0, 1.0)) / std::numbers::pi;
                const glm::vec3 side = glm::normalize(glm::vec3(n.z, 0.0f, -n.x) + glm::vec3(1e-6f, 0, 0));
                picture.setPixel(
                    x, y, barkPixel(sampleOf(maps, material, around, along), side, glm::cross(n, side), n));
            }
            if (x > gap && y > gap && x + gap < size && y + gap < size)
                picture.setPixel(
                    size + x, y,
                    barkPixel(sampleOf(maps, material, 0.5 * (across + 1.0), 0.5 * (above + 1.0)), right, up,
                              outward));
        }
    return smooth(picture);
}

} // namespace ramure
