#include "core/surface/texture/texture_conformal.h"

#include "core/math/reproducible.h"
#include <algorithm>
#include <cmath>

namespace ramure {

namespace {

constexpr double calmK = 0.06;   ///< of triangles that wake nobody: stretched by 1.13
constexpr double foldedK = 0.98; ///< next to no area
constexpr double leastRoom = 0.02;
constexpr double leastSize = 0.01; ///< |a|² of triangles that have collapsed
constexpr double beyond = 1.2;     ///< of the way to where the energy is least: gets there in fewer sweeps
constexpr double boundK = 0.9 * ConformalRelaxer::goodK; ///< what fit() lets pass
constexpr double farK = 0.5; ///< stretched by 3: what is worse is drawn back, hopeless or not
// Excess of k at which a triangle pulls a quarter as much, in the first and in the last round.
constexpr double firstScale = 0.1, lastScale = 0.02;
constexpr double mostMomentum = 0.95; ///< of a round's moves, carried into the next
constexpr double warmUpShare = 0.015; ///< of the rounds: until momentum is half
constexpr double inertia = 0.1;       ///< of triangles without excess

} // namespace

void ConformalRelaxer::clear()
{
    m_z.clear();
    m_free.clear();
    m_triangles.clear();
    m_around.clear();
    m_awake.clear();
    m_moved.clear();
}

void ConformalRelaxer::addVertex(const glm::dvec2& uv, bool isFree)
{
    m_z.push_back({uv.x, uv.y});
    m_free.push_back(isFree ? 1 : 0);
    m_awake.push_back(0);
}

void ConformalRelaxer::addTriangle(const std::array<Index, 3>& corner, const std::array<glm::dvec3, 3>& place,
                                   const std::array<double, 3>& shift)
{
    FlatCorners flat;
    if (!layFlat(place, flat))
        return;
    Triangle& added = m_triangles.emplace_back();
    added.corner = corner;
    added.flat = flat;
    added.shift1 = shift[1] - shift[0];
    added.shift2 = shift[2] - shift[0];
}

/// How much a triangle is stretched. With z = a x + b conj(x), the sum of the corners' z times their opposite
/// edges is b times 2i the doubled area, and a with the conjugate edges.
inline void ConformalRelaxer::measure(Triangle& t) const
{
    const auto& [x1, x2, y2] = t.flat;
    const Complex &from = m_z[t.corner[0]], &to1 = m_z[t.corner[1]], &to2 = m_z[t.corner[2]];
    const Complex way1{to1.re - from.re + t.shift1, to1.im - from.im};
    const Complex way2{to2.re - from.re + t.shift2, to2.im - from.im};
    const double re = x1 * way2.re - x2 * way1.re, im = x1 * way2.im - x2 * way1.im;
    const Complex r{re + y2 * way1.im, im - y2 * way1.re};
    const Complex q{re - y2 * way1.im, im + y2 * way1.re};
    const double b = r.re * r.re + r.im * r.im, a = q.re * q.re + q.im * q.im;
    const double doubled = x1 * y2;
    const double size = 1.0 / std::max({a, 0.25 * b, leastSize * 4.0 * doubled * doubled});
    t.stretch = std::min(b * size, 4.0);
    t.inverse = {q.re * size, -q.im * size};
    t.value = times(r, t.inverse);
}

/// Who is awake. \param all triangles have moved, or only those around vertices that were awake.
/// \param calm k of triangles that wake nobody.
void ConformalRelaxer::measure(bool all, double calm)
{
    m_moved.swap(m_awake);
    m_awake.assign(m_z.size(), 0);
    m_folded = m_stretched = false;
    m_bad = 0;
    for (Triangle& t : m_triangles) {
        if (all || (m_moved[t.corner[0]] | m_moved[t.corner[1]] | m_moved[t.corner[2]]) != 0)
            measure(t);
        m_folded = m_folded || !(t.stretch <= foldedK * foldedK); // or no number
        m_bad += t.stretch >= goodK * goodK ? 1 : 0;
        if (t.stretch > calm * calm) {
            m_stretched = true;
            for (const Index corner : t.corner)
                m_awake[corner] = m_free[corner];
        }
    }
}

inline void ConformalRelaxer::differentiate(Triangle& t)
{
    const auto& [x1, x2, y2] = t.flat;
    // The edges opposite to the second and third corner, less the value times their conjugates.
    const Complex& value = t.value;
    const Complex second{value.re * x2 + value.im * y2 - x2, value.im * x2 - value.re * y2 - y2};
    const Complex third{x1 - value.re * x1, -value.im * x1};
    t.slope[1] = times(second, t.inverse);
    t.slope[2] = times(third, t.inverse);
    t.slope[0] = {-t.slope[1].re - t.slope[2].re, -t.slope[1].im - t.slope[2].im};
}

/// What the triangles count around vertices that are awake.
void ConformalRelaxer::weigh()
{
    for (Triangle& t : m_triangles) {
        if (!isAwake(t))
            continue;
        differentiate(t);
        // Next to folding a triangle counts more and more, as in an energy that would be infinite there.
        const double room = std::max(1.0 - t.stretch, leastRoom);
        t.weight = (1.0 + t.stretch) / (room * room * room);
    }
}

/// What their excess counts.
void ConformalRelaxer::weighExcess(double scale)
{
    for (Triangle& t : m_triangles) {
        if (!isAwake(t))
            continue;
        differentiate(t);
        t.weight = t.barrier = 1.0;
        if (t.stretch <= boundK * boundK)
            continue;
        const double part = (std::sqrt(t.stretch) - boundK) / scale, sum = 1.0 + part * part;
        const double room = std::max(1.0 - t.stretch, leastRoom);
        t.barrier = 1.0 / (room * room * room);
        t.weight = t.barrier / (sum * sum);
    }
}

inline void ConformalRelaxer::move(Index vertex, const Complex& step)
{
    m_z[vertex].re += step.re;
    m_z[vertex].im += step.im;
    for (const TrianglesAround::Use& use : m_around.of(vertex)) {
        Triangle& triangle = m_triangles[use.triangle];
        const Complex& w = triangle.slope[use.place];
        triangle.value.re += w.re * step.re - w.im * step.im;
        triangle.value.im += w.re * step.im + w.im * step.re;
    }
}

void ConformalRelaxer::sweep()
{
    for (Index vertex = 0; vertex < m_z.size(); ++vertex) {
        if (m_awake[vertex] == 0)
            continue;
        Complex pull;
        double size = 0.0;
        for (const TrianglesAround::Use& use : m_around.of(vertex)) {
            const Triangle& triangle = m_triangles[use.triangle];
            const Complex& w = triangle.slope[use.place];
            const Complex& r = triangle.value;
            pull.re += triangle.weight * (w.re * r.re + w.im * r.im);
            pull.im += triangle.weight * (w.re * r.im - w.im * r.re);
            size += triangle.weight * (w.re * w.re + w.im * w.im);
        }
        if (!(size > 0.0))
            continue;
        const double share = -beyond / size;
        move(vertex, {share * pull.re, share * pull.im});
    }
}

inline ConformalRelaxer::Around ConformalRelaxer::around(Index vertex) const
{
    double slopeX = 0.0, slopeY = 0.0, xx = 0.0, xy = 0.0, yy = 0.0, even = 0.0;
    for (const TrianglesAround::Use& use : m_around.of(vertex)) {
        const Triangle& triangle = m_triangles[use.triangle];
        const Complex w = triangle.slope[use.place], r = triangle.value;
        const double weight = triangle.weight;
        const double square = r.re * r.re + r.im * r.im, size = w.re * w.re + w.im * w.im;
        even += inertia * weight * size;
        if (square <= boundK * boundK)
            continue;
        const double k = std::sqrt(square), inverse = 1.0 / k;
        const double far = std::max(k - farK, 0.0);
        const double pull = weight * (k - boundK) + triangle.barrier * far;
        // Second derivatives: so much along the value, and so much across it.
        const double radial = far > 0.0 ? weight + triangle.barrier : weight;
        const double across = pull * inverse, more = radial - across;
        const double x = (w.re * r.re + w.im * r.im) * inverse, y = (w.re * r.im - w.im * r.re) * inverse;
        slopeX += pull * x;
        slopeY += pull * y;
        even += across * size;
        xx += more * x * x;
        yy += more * y * y;
        xy += more * x * y;
    }
    return {{slopeX, slopeY}, xx + even, xy, yy + even};
}

void ConformalRelaxer::sweepExcess()
{
    for (Index vertex = 0; vertex < m_z.size(); ++vertex) {
        if (m_awake[vertex] == 0)
            continue;
        const Around sum = around(vertex);
        const double determinant = sum.xx * sum.yy - sum.xy * sum.xy;
        if (!(determinant > 0.0) || (sum.slope.re == 0.0 && sum.slope.im == 0.0))
            continue;
        const double share = -1.0 / determinant;
        move(vertex, {share * (sum.yy * sum.slope.re - sum.xy * sum.slope.im),
                      share * (sum.xx * sum.slope.im - sum.xy * sum.slope.re)});
    }
}

void ConformalRelaxer::relax(int rounds, int sweeps)
{
    measure(true, calmK);
    if (m_stretched && !m_around.isLinked(m_z.size()))
        m_around.link(std::span<const Triangle>(m_triangles), m_z.size());
    for (int round = 0; round < rounds && m_stretched; ++round) {
        weigh();
        for (int i = 0; i < sweeps; ++i)
            sweep();
        measure(false, calmK);
    }
}

/// Moves all that is awake by a share of what the last round has moved it (Nesterov).
void ConformalRelaxer::goOn(double share)
{
    for (Index vertex = 0; vertex < m_z.size(); ++vertex) {
        const Complex now = m_z[vertex], before = m_before[vertex];
        m_before[vertex] = now;
        if (m_awake[vertex] == 0)
            continue;
        m_z[vertex].re += share * (now.re - before.re);
        m_z[vertex].im += share * (now.im - before.im);
    }
}

void ConformalRelaxer::fit(int rounds, Index enough)
{
    constexpr Index none = noIndex;
    measure(false, boundK);
    if (!m_folded && m_bad <= enough)
        return;
    m_before = m_best = m_z;
    Index fewest = m_folded ? none : m_bad;
    const double shrink = maths::pow(lastScale / firstScale, 1.0 / std::max(rounds - 1, 1));
    const double warmUp = warmUpShare * double(rounds);
    double scale = firstScale;
    for (int round = 0; round < rounds && m_stretched && fewest > enough; ++round, scale *= shrink) {
        weighExcess(scale);
        sweepExcess();
        sweepExcess();
        goOn(std::min(mostMomentum, double(round) / (double(round) + warmUp)));
        measure(false, boundK);
        if (m_folded || m_bad >= fewest)
            continue;
        fewest = m_bad;
        m_best = m_z;
    }
    if (fewest == none)
        return;
    m_z.swap(m_best);
    measure(true, boundK);
}

} // namespace ramure
