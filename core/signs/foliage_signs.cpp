// Signs that are measured on the leaves.
#include "core/math/angle.h"
#include "core/math/reproducible.h"
#include "core/params/source_facts.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/signs/sign_rows.h"
#include "core/surface/foliage/leaf_measures.h"
#include "core/surface/foliage/leaf_table.h"
#include "core/surface/foliage/place_foliage.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

namespace ramure::signs {
namespace {

constexpr std::size_t fewLeaves = 200; ///< of which a mean says little

/// Lightness L*, and the hue in degrees, of an sRGB colour by its components 0..1 (CIE 1976, D65).
struct Seen
{
    double lightness = 0.0, hueDeg = 0.0;
};

Seen seen(const glm::dvec3& srgb)
{
    const auto linear = [](double c) {
        return c <= 0.04045 ? c / 12.92 : maths::pow((c + 0.055) / 1.055, 2.4);
    };
    const glm::dvec3 c(linear(srgb.r), linear(srgb.g), linear(srgb.b));
    const glm::dvec3 xyz(glm::dot(c, {0.4124, 0.3576, 0.1805}) / 0.95047,
                         glm::dot(c, {0.2126, 0.7152, 0.0722}),
                         glm::dot(c, {0.0193, 0.1192, 0.9505}) / 1.08883);
    const auto f = [](double t) {
        return t > 216.0 / 24389.0 ? maths::pow(t, 1.0 / 3.0) : (24389.0 / 27.0 * t + 16.0) / 116.0;
    };
    const double y = f(xyz.y);
    return {116.0 * y - 16.0, maths::atan2(200.0 * (y - f(xyz.z)), 500.0 * (f(xyz.x) - y)) / oneDegree};
}

/// The mean angle between the upper sides of the leaves of a shoot and their mean direction.
void addNormals(Rows& rows, const Foliage& foliage, const TriangleMesh& leaf)
{
    TreeSign sign{
        "leafNormals", "leaf normals", "degrees", {},
        0.0,           15.0,           75.0,      "mean angle of the blades of one shoot to their mean"};
    glm::dvec3 within(0.0);
    double area = 0.0;
    for (const glm::uvec3& t : leaf.triangles) {
        const glm::dvec3 a(leaf.positions[t.x]);
        const glm::dvec3 across =
            glm::cross(glm::dvec3(leaf.positions[t.y]) - a, glm::dvec3(leaf.positions[t.z]) - a);
        within += across;
        area += glm::length(across);
    }
    // Of unit vectors whose mean is m long the mean angle is about acos(m).
    const double own = area > 0.0 ? glm::length(within) / area : 1.0;
    std::map<Index, std::pair<glm::dvec3, double>> twigs;
    for (const FoliageItem& item : foliage.leaves) {
        auto& [sum, count] = twigs[item.branch];
        sum += item.orientation * (area > 0.0 ? within / area : glm::dvec3(0.0, 0.0, 1.0));
        count += 1.0;
    }
    double angles = 0.0, counted = 0.0;
    for (const auto& [branch, twig] : twigs) {
        const double mean = foliage.form.perShoot > 1 ? own : glm::length(twig.first) / twig.second;
        angles += twig.second * maths::acos(std::clamp(mean, 0.0, 1.0)) / oneDegree;
        counted += twig.second;
    }
    rows.push_back(measured(std::move(sign), angles / counted));
}

/// How far leaves differ in lightness and in hue.
void addColours(Rows& rows, const Foliage& foliage)
{
    const glm::dvec3 full(glm::dvec3(leafColour(foliage.form.shape, foliage.form.turns)) / 255.0);
    double sum = 0.0, squares = 0.0;
    std::vector<double> hues;
    for (const FoliageItem& leaf : foliage.leaves) {
        const Seen own = seen(full * glm::dvec3(leaf.tone * leaf.tint));
        sum += own.lightness;
        squares += own.lightness * own.lightness;
        hues.push_back(own.hueDeg);
    }
    const double count = double(hues.size()), mean = sum / count;
    const double variance = std::max(0.0, squares / count - mean * mean);
    rows.push_back(measured({"leafLightness",
                             "lightness of leaves",
                             "",
                             {},
                             0.0,
                             0.04,
                             0.10,
                             "standard deviation of L* over its mean"},
                            std::sqrt(variance) / mean));
    std::ranges::sort(hues);
    const auto at = [&](double share) { return hues[std::size_t(share * (count - 1.0))]; };
    rows.push_back(measured({"leafHue",
                             "hue of leaves",
                             "degrees",
                             {},
                             0.0,
                             3.0,
                             9.0,
                             "half of what nine tenths of the leaves span"},
                            0.5 * (at(0.95) - at(0.05))));
}

/// The shadow of the crown on a plane across one direction.
class Shadow
{
public:
    Shadow(const Foliage& foliage, const glm::dvec3& way)
        : m_right(glm::normalize(glm::cross(way, {0.0, 1.0, 0.0})))
        , m_up(glm::cross(m_right, way))
    {
        m_low = glm::dvec2(1e300);
        glm::dvec2 high(-1e300);
        for (const FoliageItem& leaf : foliage.leaves) {
            m_low = glm::min(m_low, on(leaf.position));
            high = glm::max(high, on(leaf.position));
        }
        m_pixel = std::max({high.x - m_low.x, high.y - m_low.y, 1e-9}) / double(side - 2);
        m_low -= m_pixel;
    }

    void draw(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
    {
        const glm::dvec2 p = place(a), q = place(b), r = place(c);
        const double twice = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
        if (twice == 0.0)
            return;
        const auto clamped = [](double x) { return std::clamp(int(std::floor(x)), 0, side - 1); };
        for (int y = clamped(std::min({p.y, q.y, r.y})); y <= clamped(std::max({p.y, q.y, r.y})); ++y)
            for (int x = clamped(std::min({p.x, q.x, r.x})); x <= clamped(std::max({p.x, q.x, r.x})); ++x) {
                const glm::dvec2 at(x + 0.5, y + 0.5);
                const double u = ((q.x - at.x) * (r.y - at.y) - (q.y - at.y) * (r.x - at.x)) / twice;
                const double v = ((r.x - at.x) * (p.y - at.y) - (r.y - at.y) * (p.x - at.x)) / twice;
                if (u >= 0.0 && v >= 0.0 && u + v <= 1.0)
                    m_dark[std::size_t(y) * side + std::size_t(x)] = true;
            }
    }

    /// m² of the crown's outline, and the share of it that is light. The outline is of squares that hold some
    /// leaf and whose neighbours do.
    [[nodiscard]] std::pair<double, double> outline() const
    {
        constexpr int block = 16, blocks = side / block;
        std::vector<double> dark(std::size_t(blocks) * blocks, 0.0);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                if (m_dark[std::size_t(y) * side + std::size_t(x)])
                    dark[std::size_t(y / block) * blocks + std::size_t(x / block)] += 1.0;
        double pixels = 0.0, light = 0.0;
        for (int y = 1; y + 1 < blocks; ++y)
            for (int x = 1; x + 1 < blocks; ++x) {
                bool isInside = true;
                for (int n = 0; n < 9; ++n)
                    isInside = isInside &&
                               dark[std::size_t(y + n / 3 - 1) * blocks + std::size_t(x + n % 3 - 1)] > 0.0;
                if (!isInside)
                    continue;
                pixels += block * block;
                light += block * block - dark[std::size_t(y) * blocks + std::size_t(x)];
            }
        return {pixels * m_pixel * m_pixel, pixels > 0.0 ? light / pixels : 1.0};
    }

private:
    static constexpr int side = 1024;
    [[nodiscard]] glm::dvec2 on(const glm::dvec3& at) const
    {
        return {glm::dot(at, m_right), glm::dot(at, m_up)};
    }
    [[nodiscard]] glm::dvec2 place(const glm::dvec3& at) const { return (on(at) - m_low) / m_pixel; }

    glm::dvec3 m_right, m_up;
    glm::dvec2 m_low;
    double m_pixel = 1.0;
    std::vector<bool> m_dark = std::vector<bool>(std::size_t(side) * side, false);
};

/// How much the leaves stand in clumps: leaves by chance over so much of the picture would leave exp(-G L) of
/// it light (Beer and Lambert; at 57.5 degrees from the zenith G is a half whatever the angles of the
/// leaves).
void addGaps(Rows& rows, const Foliage& foliage, double alpha, const Progress& progress)
{
    TreeSign sign{"crownGaps", "clumping of leaves",
                  "",          {},
                  0.0,         0.5,
                  0.95,        "-2 ln P over the leaf area of the crown's outline, seen at 57.5 degrees"};
    constexpr int views = 4;
    LeafForm form = foliage.form;
    form.detail = 1;
    const TriangleMesh leaf = oneLeaf(form, alpha, FoliageModel::Fine);
    const double all = leafMeasures(foliage, alpha, 1.0).area;
    double clumping = 0.0;
    for (int view = 0; view < views && !progress.cancelled(); ++view) {
        const auto [sine, cosine] = maths::sincos(fullTurn * view / views);
        const auto [out, up] = maths::sincos(57.5 * oneDegree);
        Shadow shadow(foliage, glm::dvec3(out * cosine, -up, out * sine));
        for (const FoliageItem& item : foliage.leaves) {
            const glm::dmat3 turn = double(item.size) * glm::mat3_cast(item.orientation);
            const auto at = [&](Index v) { return item.position + turn * glm::dvec3(leaf.positions[v]); };
            for (const glm::uvec3& t : leaf.triangles)
                shadow.draw(at(t.x), at(t.y), at(t.z));
        }
        const auto [area, light] = shadow.outline();
        clumping += -2.0 * maths::log(std::clamp(light, 1e-6, 1.0)) * area / all / views;
    }
    rows.push_back(measured(std::move(sign), clumping));
}

} // namespace

Expected<void> addFoliage(Rows& rows, const NodeParams& params, TreePipeline& pipeline,
                          const Progress& progress)
{
    const auto tree = pipeline.evaluate(params, Stage::Foliage, progress.part(0.0, 0.5));
    RAMURE_TRY(tree);
    const Foliage& foliage = *tree->foliage;
    if (foliage.form.shape == LeafShape::Faithful || foliage.leaves.size() < fewLeaves) {
        for (const auto& [key, label] :
             {std::pair("leafNormals", "leaf normals"), std::pair("leafLightness", "lightness of leaves"),
              std::pair("leafHue", "hue of leaves"), std::pair("crownGaps", "clumping of leaves")})
            rows.push_back(absent({key, label}, "fewer than two hundred leaves of a plant"));
        return {};
    }
    const double alpha = trunkRadius(params);
    addNormals(rows, foliage, oneLeaf(foliage.form, alpha, FoliageModel::Fine));
    addColours(rows, foliage);
    addGaps(rows, foliage, alpha, progress.part(0.5, 1.0));
    if (progress.cancelled())
        return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
    return {};
}

} // namespace ramure::signs
