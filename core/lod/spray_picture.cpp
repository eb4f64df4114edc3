#include "core/lod/spray_picture.h"

#include "core/surface/foliage/leaf_maps.h"
#include "core/surface/foliage/leaf_table.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

namespace ramure {
namespace {

constexpr int fine = 2;     ///< samples a pixel, each way
constexpr int blades = 128; ///< pixels a side of the picture of one leaf
constexpr int keptMips = 4;

/// What is seen at the samples of one card.
struct Canvas
{
    Canvas(int width, int height)
        : width(width)
        , height(height)
        , depth(std::size_t(width) * std::size_t(height), -std::numeric_limits<float>::infinity())
        , colour(depth.size(), glm::vec3(0.0F))
        , normal(depth.size(), glm::vec3(0.0F))
    {
    }
    int width, height;
    std::vector<float> depth; ///< towards the eye; minus infinity: nothing is there
    std::vector<glm::vec3> colour, normal;
};

/// Draws the triangles of a twig as they are seen along an axis.
class TwigPainter
{
public:
    TwigPainter(const TriangleMesh& twig, const SprayFrame& frame, const LeafMaps& leaf,
                const glm::vec3& tone, int across)
        : m_twig(twig)
        , m_frame(frame)
        , m_leaf(leaf)
        , m_tone(tone)
        , m_across(across)
        , m_right(2 - across)
    {
    }

    void draw(Canvas& canvas) const
    {
        for (std::size_t f = 0; f < m_twig.triangles.size(); ++f)
            drawTriangle(canvas, m_twig.triangles[f], m_twig.colours[f]);
    }

private:
    /// To the right, up, and towards the eye.
    [[nodiscard]] glm::vec3 seen(const glm::vec3& v) const
    {
        return {v[m_right], v.y, m_across == 2 ? v.z : -v.x};
    }
    [[nodiscard]] glm::vec3 onCanvas(Index vertex, const Canvas& canvas) const
    {
        const glm::vec3 at = seen(m_twig.positions[vertex] - glm::vec3(m_frame.middle));
        const glm::vec3 half(float(m_frame.half[m_right]), float(m_frame.half.y), 1.0F);
        return {(0.5F + 0.5F * at.x / half.x) * float(canvas.width),
                (0.5F + 0.5F * at.y / half.y) * float(canvas.height), at.z};
    }
    [[nodiscard]] glm::vec3 colourAt(const glm::vec2& uv) const
    {
        const auto pixel = [&](float x) {
            return std::clamp(int(x * float(m_leaf.size)), 0, m_leaf.size - 1);
        };
        const glm::u8vec3 own =
            m_leaf.colour[std::size_t(pixel(uv.y)) * std::size_t(m_leaf.size) + std::size_t(pixel(uv.x))];
        return m_tone * glm::vec3(own) / glm::max(glm::vec3(m_leaf.blade), glm::vec3(1.0F));
    }
    void drawTriangle(Canvas& canvas, const glm::uvec3& face, const glm::u8vec3& tone) const
    {
        const glm::vec3 a = onCanvas(face.x, canvas), b = onCanvas(face.y, canvas),
                        c = onCanvas(face.z, canvas);
        const float area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        if (std::abs(area) < 1e-9F)
            return;
        const auto range = [](float p, float q, float r, int most) {
            return std::pair(std::clamp(int(std::floor(std::min({p, q, r}) - 0.5F)), 0, most),
                             std::clamp(int(std::ceil(std::max({p, q, r}) + 0.5F)), 0, most));
        };
        const auto [left, right] = range(a.x, b.x, c.x, canvas.width);
        const auto [low, high] = range(a.y, b.y, c.y, canvas.height);
        for (int y = low; y < high; ++y)
            for (int x = left; x < right; ++x) {
                const glm::vec2 p(float(x) + 0.5F, float(y) + 0.5F);
                const float u = ((b.x - p.x) * (c.y - p.y) - (b.y - p.y) * (c.x - p.x)) / area;
                const float v = ((c.x - p.x) * (a.y - p.y) - (c.y - p.y) * (a.x - p.x)) / area;
                const float w = 1.0F - u - v;
                const std::size_t at = std::size_t(y) * std::size_t(canvas.width) + std::size_t(x);
                const float depth = u * a.z + v * b.z + w * c.z;
                if (u < 0.0F || v < 0.0F || w < 0.0F || depth <= canvas.depth[at])
                    continue;
                canvas.depth[at] = depth;
                const glm::vec2 uv = u * m_twig.uv[face.x] + v * m_twig.uv[face.y] + w * m_twig.uv[face.z];
                canvas.colour[at] = glm::vec3(tone) / 255.0F * colourAt(uv);
                glm::vec3 normal = seen(u * m_twig.normals[face.x] + v * m_twig.normals[face.y] +
                                        w * m_twig.normals[face.z]);
                canvas.normal[at] = normal.z < 0.0F ? -normal : normal; // both sides are seen
            }
    }

    const TriangleMesh& m_twig;
    const SprayFrame& m_frame;
    const LeafMaps& m_leaf;
    glm::vec3 m_tone;
    int m_across, m_right;
};

/// A cell of the picture from the samples of its card.
void take(const Canvas& canvas, int left, int low, SprayMaps& maps)
{
    constexpr auto samples = float(fine * fine);
    for (int y = 0; y < canvas.height / fine; ++y)
        for (int x = 0; x < canvas.width / fine; ++x) {
            glm::vec3 colour(0.0F), normal(0.0F);
            float covered = 0.0F;
            for (int s = 0; s < fine * fine; ++s) {
                const std::size_t at = std::size_t(fine * y + s / fine) * std::size_t(canvas.width) +
                                       std::size_t(fine * x + s % fine);
                if (std::isinf(canvas.depth[at]))
                    continue;
                covered += 1.0F;
                colour += canvas.colour[at];
                normal += canvas.normal[at];
            }
            const std::size_t to = std::size_t(low + y) * std::size_t(maps.size) + std::size_t(left + x);
            if (covered == 0.0F)
                continue;
            colour = glm::clamp(colour / covered + 0.5F, 0.0F, 255.0F);
            maps.colour[to] = {glm::u8vec3(colour), std::uint8_t(255.0F * covered / samples + 0.5F)};
            normal = glm::length(normal) > 1e-6F ? glm::normalize(normal) : glm::vec3(0.0F, 0.0F, 1.0F);
            maps.normal[to] = glm::u8vec3(128.0F + 127.0F * normal);
        }
}

/// Colours beside the leaves go on as those of their neighbours, so that no edge is dark from afar: of what
/// is not covered each pixel takes the mean of the smallest square around it that has some.
void fillBeside(SprayMaps& maps)
{
    struct Sum
    {
        glm::vec3 colour{0.0F};
        float weight = 0.0F;
    };
    std::vector<std::vector<Sum>> pyramid;
    const int size = maps.size;
    std::vector<Sum> level(maps.colour.size());
    for (std::size_t i = 0; i < level.size(); ++i)
        if (maps.colour[i].a > 0)
            level[i] = {float(maps.colour[i].a) * glm::vec3(maps.colour[i]), float(maps.colour[i].a)};
    for (int side = size; side > 1; side /= 2) {
        pyramid.push_back(level);
        std::vector<Sum> next(std::size_t(side / 2) * std::size_t(side / 2));
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const Sum& from = pyramid.back()[std::size_t(y) * std::size_t(side) + std::size_t(x)];
                Sum& to = next[std::size_t(y / 2) * std::size_t(side / 2) + std::size_t(x / 2)];
                to.colour += from.colour;
                to.weight += from.weight;
            }
        level = std::move(next);
    }
    pyramid.push_back(level);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            glm::u8vec4& pixel = maps.colour[std::size_t(y) * std::size_t(size) + std::size_t(x)];
            for (std::size_t k = 1; pixel.a == 0 && k < pyramid.size(); ++k) {
                const std::size_t side = std::size_t(size) >> k;
                const Sum& sum = pyramid[k][(std::size_t(y) >> k) * side + (std::size_t(x) >> k)];
                if (sum.weight == 0.0F)
                    continue;
                pixel = {glm::u8vec3(sum.colour / sum.weight + 0.5F), 0};
                break;
            }
        }
}

float bestCutoff(const SprayMaps& maps)
{
    const double whole = coverageOfMips(maps, 0.5F, 1).front();
    float best = 0.5F;
    double least = std::numeric_limits<double>::max();
    for (int step = 0; step <= 20; ++step) {
        const float cutoff = 0.5F - 0.02F * float(step);
        double off = 0.0;
        for (const double share : coverageOfMips(maps, cutoff, keptMips))
            off = std::max(off, std::abs(share - whole));
        if (off < least) {
            least = off;
            best = cutoff;
        }
    }
    return best;
}

} // namespace

std::vector<double> coverageOfMips(const SprayMaps& maps, float cutoff, int levels)
{
    std::vector<double> out;
    std::vector<float> alpha(maps.colour.size());
    std::ranges::transform(maps.colour, alpha.begin(),
                           [](const glm::u8vec4& p) { return float(p.a) / 255.0F; });
    for (int side = maps.size; levels > 0 && side > 0; --levels, side /= 2) {
        const auto opaque = std::ranges::count_if(alpha, [cutoff](float a) { return a >= cutoff; });
        out.push_back(double(opaque) / double(alpha.size()));
        std::vector<float> next(std::size_t(side / 2) * std::size_t(side / 2));
        for (std::size_t i = 0; i < next.size(); ++i) {
            const std::size_t half = std::size_t(side / 2), x = 2 * (i % half), y = 2 * (i / half);
            const std::size_t row = std::size_t(side);
            next[i] = 0.25F * (alpha[y * row + x] + alpha[y * row + x + 1] + alpha[(y + 1) * row + x] +
                               alpha[(y + 1) * row + x + 1]);
        }
        alpha = std::move(next);
    }
    return out;
}

Expected<SprayMaps> sprayMaps(const SprayAtlas& atlas, int size, const Progress& progress)
{
    if (size < leastSpraySize || size > mostSpraySize || (size & (size - 1)) != 0)
        return fail(ErrorCode::Invalid,
                    RAMURE_NOOP("the picture of twigs has %1 to %2 pixels a side, a power of two, not %3"),
                    {std::to_string(leastSpraySize), std::to_string(mostSpraySize), std::to_string(size)});
    const auto leaf = leafMaps(atlas.form.shape, blades);
    RAMURE_TRY(leaf);
    SprayMaps out;
    out.size = size;
    out.colour.assign(std::size_t(size) * std::size_t(size), glm::u8vec4(0));
    out.normal.assign(out.colour.size(), glm::u8vec3(128, 128, 255));
    const LeafForm& form = atlas.form; // on a day of the year tints are whole colours
    const glm::vec3 tone = form.onDay ? glm::vec3(255.0F) : glm::vec3(leafColour(form.shape, form.turns));
    const int cell = size / SprayAtlas::across;
    for (int twig = 0; twig < SprayAtlas::count; ++twig) {
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        const TriangleMesh& mesh = atlas.twigs[std::size_t(twig)];
        const SprayFrame frame = sprayFrame(mesh);
        for (const int across : {2, 0}) {
            Canvas canvas(fine * cell / 2, fine * cell);
            TwigPainter(mesh, frame, *leaf, tone, across).draw(canvas);
            take(canvas, cell * (twig % SprayAtlas::across) + (across == 0 ? cell / 2 : 0),
                 cell * (twig / SprayAtlas::across), out);
        }
        progress.report(double(twig + 1) / SprayAtlas::count);
    }
    fillBeside(out);
    out.cutoff = bestCutoff(out);
    return out;
}

} // namespace ramure
