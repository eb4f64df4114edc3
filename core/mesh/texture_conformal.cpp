#include "core/mesh/texture_conformal.h"

#include <algorithm>
#include <cmath>

namespace ramure {

namespace {

constexpr double halfK2 = 0.035; ///< k² at which a triangle counts half: stretched by 1.45
constexpr double calmK = 0.06;   ///< of triangles that wake nobody: stretched by 1.13
constexpr double foldedK = 0.98; ///< next to no area
constexpr double leastRoom = 0.02;
constexpr double leastSize = 0.01; ///< |a|² of triangles that have collapsed
constexpr double beyond = 1.2;     ///< of the way to where the energy is least: gets there in fewer sweeps

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
void ConformalRelaxer::measure(bool all)
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
        if (t.stretch > calmK * calmK) {
            m_stretched = true;
            for (const Index corner : t.corner)
                m_awake[corner] = m_free[corner];
        }
    }
}

/// What the triangles count around vertices that are awake.
void ConformalRelaxer::weigh(bool choosy)
{
    for (Triangle& t : m_triangles) {
        if ((m_awake[t.corner[0]] | m_awake[t.corner[1]] | m_awake[t.corner[2]]) == 0)
            continue;
        const auto& [x1, x2, y2] = t.flat;
        // The edges opposite to the second and third corner, less the value times their conjugates.
        const Complex& value = t.value;
        const Complex second{value.re * x2 + value.im * y2 - x2, value.im * x2 - value.re * y2 - y2};
        const Complex third{x1 - value.re * x1, -value.im * x1};
        t.slope[1] = times(second, t.inverse);
        t.slope[2] = times(third, t.inverse);
        t.slope[0] = {-t.slope[1].re - t.slope[2].re, -t.slope[1].im - t.slope[2].im};
        // Next to folding a triangle counts more and more, as in an energy that would be infinite there.
        const double room = std::max(1.0 - t.stretch, leastRoom);
        const double excess = choosy ? t.stretch / halfK2 : 0.0;
        t.weight = (1.0 + t.stretch) / ((1.0 + excess * excess) * room * room * room);
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
        const Complex step{share * pull.re, share * pull.im};
        m_z[vertex].re += step.re;
        m_z[vertex].im += step.im;
        for (const TrianglesAround::Use& use : m_around.of(vertex)) {
            Triangle& triangle = m_triangles[use.triangle];
            const Complex& w = triangle.slope[use.place];
            triangle.value.re += w.re * step.re - w.im * step.im;
            triangle.value.im += w.re * step.im + w.im * step.re;
        }
    }
}

void ConformalRelaxer::run(const Effort& effort)
{
    if (m_moved.size() != m_z.size())
        measure(true);
    if (m_stretched && !m_around.isLinked(m_z.size()))
        m_around.link(std::span<const Triangle>(m_triangles), m_z.size());
    for (int round = 0; round < effort.evenRounds + effort.choosyRounds && m_stretched; ++round) {
        const bool choosy = round >= effort.evenRounds;
        weigh(choosy);
        for (int i = 0; i < (choosy ? effort.choosySweeps : effort.evenSweeps); ++i)
            sweep();
        measure(false);
    }
}

} // namespace ramure
