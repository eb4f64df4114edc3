#include "core/surface/foliage/leaf_blade.h"

#include "core/math/reproducible.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace ramure {
namespace {

/// Both halves of a blade, point by point from the foot on: each point and triangle has its mirror image.
class Halves
{
public:
    Halves() { m_blade.points.emplace_back(0.0, 0.0); }

    /// On the midrib.
    Index onMidrib(double y)
    {
        m_blade.points.emplace_back(0.0, y);
        return static_cast<Index>(m_blade.points.size() - 1);
    }
    /// On the right; its mirror image is the next point.
    Index beside(double x, double y)
    {
        m_blade.points.emplace_back(x, y);
        m_blade.points.emplace_back(-x, y);
        m_blade.halfWidth = std::max(m_blade.halfWidth, x);
        return static_cast<Index>(m_blade.points.size() - 2);
    }
    /// Counter-clockwise on the right.
    void triangle(Index a, Index b, Index c)
    {
        m_blade.triangles.emplace_back(a, b, c);
        m_blade.triangles.emplace_back(mirrored(a), mirrored(c), mirrored(b));
    }
    FlatBlade take() { return std::move(m_blade); }

private:
    [[nodiscard]] Index mirrored(Index i) const { return m_blade.points[i].x > 0.0 ? i + 1 : i; }
    FlatBlade m_blade;
};

/// The outline of a smooth blade.
struct Outline
{
    double base, tip, half;

    [[nodiscard]] double widest() const { return base / (base + tip); }
    /// Half the width at a share of the length, 0 < u < 1.
    [[nodiscard]] double at(double u) const
    {
        const double w = widest();
        return half * maths::pow(u / w, base) * maths::pow((1.0 - u) / (1.0 - w), tip);
    }
    /// Stations stand closer where the shorter part of the blade is; the middle one at its widest.
    [[nodiscard]] double station(double share) const
    {
        const double w = std::clamp(widest(), 0.2, 0.8);
        return share < 0.5 ? 2.0 * share * w : w + (2.0 * share - 1.0) * (1.0 - w);
    }
};

/// What stands out from the straight edge between two stations, as points from the lower to the upper.
struct Edge
{
    bool fine = false; ///< the rounding of a smooth outline, and teeth
    double teeth = 0.0;
    bool hasLobes = false, pointed = false;
    bool coarse = false; ///< one point a lobe

    [[nodiscard]] std::vector<glm::dvec2> between(const glm::dvec2& from, const glm::dvec2& to,
                                                  const Outline& outline, bool last) const
    {
        const double rise = to.y - from.y;
        const auto widthAt = [&](double share) { return outline.at(std::min(from.y + share * rise, 0.97)); };
        if (hasLobes && pointed)
            return last ? std::vector<glm::dvec2>{}
                        : std::vector{glm::dvec2(std::max(from.x, widthAt(0.6)), from.y + 0.8 * rise)};
        if (hasLobes && coarse && (last || from.x > 0.0))
            return {last ? glm::dvec2(from.x, from.y + 0.55 * rise)
                         : glm::dvec2(std::max(from.x, widthAt(0.55)), from.y + 0.60 * rise)};
        if (hasLobes && last) // a round cap: blunt outlines are cut straight there
            return {{1.10 * from.x, from.y + 0.30 * rise}, {0.66 * from.x, from.y + 0.78 * rise}};
        if (hasLobes && from.x <= 0.0) // a small lobe where the blade runs into its stalk
            return {{widthAt(0.55), from.y + 0.50 * rise}};
        if (hasLobes)
            return {{std::max(from.x, widthAt(0.35)), from.y + 0.30 * rise},
                    {std::max(to.x, 0.92 * widthAt(0.75)), from.y + 0.80 * rise}};
        const double y = from.y + 0.55 * rise, chord = glm::mix(from.x, to.x, 0.55);
        const double out = last || from.x <= 0.0 ? 0.0 : teeth * outline.half;
        const double x = std::max(y > 0.02 ? outline.at(y) : 0.0, chord) + out;
        if (!fine || x < chord + 0.04 * outline.half)
            return {};
        return {{x, y}};
    }
};

} // namespace

FlatBlade bladeOf(const LeafRow& row, double width, int stations, bool fine)
{
    const Outline outline{row.base, row.tip, 0.5 * row.width * width};
    const bool hasLobes = row.lobes > 0;
    const bool coarse = hasLobes && stations < 3;
    const int count = coarse ? std::max(row.lobes - 1, 1) : hasLobes ? row.lobes : stations;
    const Edge edge{fine, row.teeth, hasLobes, row.pointed, coarse};
    Halves halves;
    Index below = 0, besideBelow = 0; // the foot is on the midrib and on the edge
    glm::dvec2 from(0.0);
    if (row.notch > 0.0) {
        const Index inner = halves.beside(0.35 * outline.half, -row.notch);
        const Index outer = halves.beside(0.80 * outline.half, -0.55 * row.notch);
        halves.triangle(0, inner, outer);
        besideBelow = outer;
        from = {0.80 * outline.half, -0.55 * row.notch};
    }
    for (int k = 1; k <= count + 1; ++k) {
        const bool last = k > count;
        const double share = k / (count + (hasLobes ? 0.8 : 1.0));
        const double y = last ? 1.0 : hasLobes ? share : outline.station(share);
        const double x = last ? 0.0 : outline.at(y) * (hasLobes ? 1.0 - row.depth : 1.0);
        const bool onMidrib = !coarse || last || k == (count + 1) / 2;
        const Index middle = onMidrib ? halves.onMidrib(y) : below,
                    side = last ? middle : halves.beside(x, y);
        if (!last && onMidrib)
            halves.triangle(below, side, middle);
        if (besideBelow != below)
            halves.triangle(below, besideBelow, side);
        if (k > 1 || !hasLobes || !row.pointed) {
            Index at = noIndex;
            for (const glm::dvec2& point : edge.between(from, {x, y}, outline, last)) {
                const Index out = halves.beside(point.x, point.y);
                if (at != noIndex)
                    halves.triangle(besideBelow, at, out);
                at = out;
            }
            if (at != noIndex)
                halves.triangle(besideBelow, at, side);
        }
        below = middle;
        besideBelow = side;
        from = {x, y};
    }
    return halves.take();
}

FlatBlade needleOf(const LeafRow& row, double width)
{
    const Outline outline{row.base, row.tip, 0.5 * row.width * width};
    const double x = outline.half, y = std::max(outline.widest(), 0.25);
    return {{{0.0, 0.0}, {x, y}, {0.0, 1.0}, {-x, y}}, {{0, 1, 3}, {1, 2, 3}}, x};
}

namespace {

/// The rim of a star, as its points' angles from +Y (to the right) and distances from the foot.
struct RimPoint
{
    double angle, radius;
};

/// From right to left.
std::vector<RimPoint> lobedRim(const LeafRow& row, int detail)
{
    const double gap = row.spread / row.lobes, middle = 0.5 * (row.lobes - 1);
    const auto length = [&](int lobe) {
        return 1.0 - row.dwindle * maths::pow(std::abs(lobe - middle) / middle, 1.3);
    };
    const double shoulder = 1.0 - 0.4 * row.depth, broad = 0.4 - 0.25 * row.depth;
    std::vector<RimPoint> rim{{0.5 * row.spread, 0.7 * (1.0 - row.depth) * length(0)}};
    for (int i = 0; i < row.lobes; ++i) {
        const double to = (middle - i) * gap, own = length(i);
        if (detail > 2)
            rim.push_back({to + (0.5 * broad + 0.25) * gap, 0.88 * shoulder * own});
        if (detail > 1)
            rim.push_back({to + broad * gap, shoulder * own});
        rim.push_back({to, own});
        if (detail > 1)
            rim.push_back({to - broad * gap, shoulder * own});
        if (detail > 2)
            rim.push_back({to - (0.5 * broad + 0.25) * gap, 0.88 * shoulder * own});
        const bool last = i + 1 == row.lobes;
        const double bay = last ? 0.7 * own : 0.5 * (own + length(i + 1));
        rim.push_back({to - 0.5 * gap, (1.0 - row.depth) * bay});
    }
    return rim;
}

/// A fan with a cleft in its middle and a wavy rim.
std::vector<RimPoint> fanRim(const LeafRow& row, int detail)
{
    const int pieces = 4 + 2 * detail;
    std::vector<RimPoint> rim;
    for (int i = 0; i <= pieces; ++i) {
        const bool cleft = 2 * i == pieces, outer = i == 0 || i == pieces;
        const double radius = cleft ? 1.0 - row.depth : outer ? 0.86 : i % 2 == 0 ? 0.95 : 1.0;
        rim.push_back({row.spread * (0.5 - static_cast<double>(i) / pieces), radius});
    }
    return rim;
}

} // namespace

FlatBlade starOf(const LeafRow& row, double width, int detail)
{
    FlatBlade blade;
    blade.points.emplace_back(0.0, 0.0);
    for (const RimPoint& at : row.lobes > 0 ? lobedRim(row, detail) : fanRim(row, detail)) {
        const auto [sine, cosine] = maths::sincos(at.angle);
        blade.points.emplace_back(row.width * width * at.radius * sine, at.radius * cosine);
        blade.halfWidth = std::max(blade.halfWidth, blade.points.back().x);
    }
    for (Index i = 2; i < blade.points.size(); ++i)
        blade.triangles.emplace_back(0, i - 1, i);
    return blade;
}

BladeBend::BladeBend(const LeafForm& form, double halfWidth, double curlShare, double wedge)
    : m_fold(form.fold)
    , m_curl(form.curl * curlShare)
    , m_cup(0.5 * form.cup)
    , m_halfWidth(halfWidth)
    , m_wedge(wedge)
{
}

glm::dvec3 BladeBend::at(const glm::dvec2& point) const
{
    const double away = std::abs(point.x), side = point.x < 0.0 ? -1.0 : 1.0;
    const double rise = std::clamp(m_fold + m_cup * away / m_halfWidth, -1.4, 1.4);
    const auto [up, out] = maths::sincos(rise);
    glm::dvec3 bent(away * out, point.y, away * up);
    if (std::abs(m_curl) > 1e-6) {
        const double radius = 1.0 / m_curl;
        // Towards the centre of the curl there is no room beyond it.
        if (bent.z * m_curl < 0.0)
            bent.z /= 1.0 + 1.25 * std::abs(bent.z * m_curl);
        const auto [sine, cosine] = maths::sincos(m_curl * point.y);
        bent = {bent.x, sine * (radius + bent.z), cosine * (radius + bent.z) - radius};
    }
    if (m_wedge > 0.0)
        bent.x = std::min(bent.x, std::max(m_wedge * bent.y, 0.0));
    return {side * bent.x, bent.y, bent.z};
}

} // namespace ramure
