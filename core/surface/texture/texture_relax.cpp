#include "core/surface/texture/texture_relax.h"

#include "core/math/reproducible.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ramure {

namespace {

constexpr double goodK = 1.0 / 9.0; ///< stretched by 1.25
constexpr double boundK = 0.9 * goodK;
constexpr double foldedK = 0.98; ///< next to no area
constexpr double leastRoom = 0.02;
constexpr double leastSize = 0.01; ///< |a|² of triangles that have collapsed
constexpr double farK = 0.5;       ///< stretched by 3: what is worse is drawn back, hopeless or not
// Excess of k at which a triangle pulls a quarter as much, in the first and in the last round.
constexpr double firstScale = 0.07, lastScale = 0.02;
constexpr double momentum = 0.8; ///< of a round's moves, carried into the next
constexpr int patience = 4;      ///< rounds without gain, after which no more is hoped for
constexpr double inertia = 0.1;  ///< of triangles without excess

} // namespace

void TextureRelaxer::clear()
{
    m_z.clear();
    m_free.clear();
    m_awake.clear();
    m_triangles.clear();
}

void TextureRelaxer::addVertex(const glm::dvec2& uv, bool isFree)
{
    m_z.push_back({uv.x, uv.y});
    m_free.push_back(isFree ? 1 : 0);
}

void TextureRelaxer::addTriangle(const std::array<Index, 3>& corner, const std::array<glm::dvec3, 3>& place,
                                 const std::array<double, 3>& shift)
{
    const glm::dvec3 first = place[1] - place[0], second = place[2] - place[0];
    const double square = glm::dot(first, first), part = glm::dot(first, second);
    const double doubled = std::sqrt(std::max(square * glm::dot(second, second) - part * part, 0.0));
    if (!(doubled > 1e-9 * square)) // it has no shape to keep
        return;
    const double x1 = std::sqrt(square);
    Triangle& added = m_triangles.emplace_back();
    added.corner = corner;
    added.x1 = x1;
    added.x2 = part / x1;
    added.y2 = doubled / x1;
    added.shift1 = shift[1] - shift[0];
    added.shift2 = shift[2] - shift[0];
}

void TextureRelaxer::link()
{
    m_first.assign(m_z.size() + 1, 0);
    for (const Triangle& triangle : m_triangles)
        for (const Index corner : triangle.corner)
            ++m_first[corner];
    Index sum = 0;
    for (Index& first : m_first)
        first = sum += first;
    m_uses.resize(sum);
    for (Index t = static_cast<Index>(m_triangles.size()); t-- > 0;)
        for (Index c = 3; c-- > 0;)
            m_uses[--m_first[m_triangles[t].corner[c]]] = {t, c};
}

/// How much a triangle is stretched. With z = a x + b conj(x), the sum of the corners' z times their opposite
/// edges is b times 2i the doubled area, and a with the conjugate edges.
inline void TextureRelaxer::measure(Triangle& t) const
{
    const Complex &from = m_z[t.corner[0]], &to1 = m_z[t.corner[1]], &to2 = m_z[t.corner[2]];
    const Complex way1{to1.re - from.re + t.shift1, to1.im - from.im};
    const Complex way2{to2.re - from.re + t.shift2, to2.im - from.im};
    const double re = t.x1 * way2.re - t.x2 * way1.re, im = t.x1 * way2.im - t.x2 * way1.im;
    const Complex r{re + t.y2 * way1.im, im - t.y2 * way1.re};
    const Complex q{re - t.y2 * way1.im, im + t.y2 * way1.re};
    const double b = r.re * r.re + r.im * r.im, a = q.re * q.re + q.im * q.im;
    const double doubled = t.x1 * t.y2;
    const double size = 1.0 / std::max({a, 0.25 * b, leastSize * 4.0 * doubled * doubled});
    t.stretch = std::min(b * size, 4.0);
    t.inverse = {q.re * size, -q.im * size};
    t.value = times(r, t.inverse);
}

/// Which triangles are bad, and who is to move for them. Those that have not moved are as they were.
void TextureRelaxer::measure()
{
    for (Triangle& t : m_triangles)
        if (m_awake.empty() || isAwake(t))
            measure(t);
    m_awake.assign(m_z.size(), 0);
    m_folded = false;
    m_bad = 0;
    for (const Triangle& t : m_triangles) {
        m_folded = m_folded || !(t.stretch <= foldedK * foldedK); // or no number
        m_bad += t.stretch >= goodK * goodK ? 1 : 0;
        if (t.stretch > boundK * boundK)
            for (const Index corner : t.corner)
                m_awake[corner] = m_free[corner];
    }
}

inline void TextureRelaxer::differentiate(Triangle& t)
{
    // The edges opposite to the second and third corner, less the value times their conjugates.
    const Complex& value = t.value;
    const Complex second{value.re * t.x2 + value.im * t.y2 - t.x2, value.im * t.x2 - value.re * t.y2 - t.y2};
    const Complex third{t.x1 - value.re * t.x1, -value.im * t.x1};
    t.slope[1] = times(second, t.inverse);
    t.slope[2] = times(third, t.inverse);
    t.slope[0] = {-t.slope[1].re - t.slope[2].re, -t.slope[1].im - t.slope[2].im};
}

/// What the excess of triangles counts around vertices that are awake.
void TextureRelaxer::weigh(double scale)
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

inline void TextureRelaxer::move(Index vertex, const Complex& step)
{
    m_z[vertex].re += step.re;
    m_z[vertex].im += step.im;
    for (const Use& use : usesOf(vertex)) {
        Triangle& triangle = m_triangles[use.triangle];
        const Complex by = times(triangle.slope[use.place], step);
        triangle.value.re += by.re;
        triangle.value.im += by.im;
    }
}

inline TextureRelaxer::Around TextureRelaxer::around(Index vertex) const
{
    double slopeX = 0.0, slopeY = 0.0, xx = 0.0, xy = 0.0, yy = 0.0, even = 0.0;
    for (const Use& use : usesOf(vertex)) {
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

void TextureRelaxer::sweep()
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

/// Moves all that is awake by a share of what the last round has moved it (Nesterov).
void TextureRelaxer::goOn(double share)
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

bool TextureRelaxer::run(int rounds, double enough)
{
    measure();
    const auto most = static_cast<Index>(enough * double(m_triangles.size()));
    if (m_bad <= most)
        return false;
    if (m_folded) {
        std::erase_if(m_triangles, [](const Triangle& t) { return !(t.stretch <= foldedK * foldedK); });
        measure();
    }
    link();
    m_before = m_best = m_z;
    const Index first = m_bad;
    Index fewest = first;
    const double shrink = maths::pow(lastScale / firstScale, 1.0 / std::max(rounds - 1, 1));
    double scale = firstScale;
    for (int round = 0, last = 0; round < rounds && round - last < patience && fewest > most;
         ++round, scale *= shrink) {
        weigh(scale);
        sweep();
        sweep();
        goOn(round > 0 ? momentum : 0.0);
        measure();
        if (m_folded || m_bad >= fewest)
            continue;
        fewest = m_bad;
        last = round + 1;
        m_best = m_z;
    }
    m_z.swap(m_best);
    return fewest < first;
}

} // namespace ramure
