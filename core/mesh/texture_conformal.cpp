#include "core/mesh/texture_conformal.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

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
    m_first.clear();
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
    const glm::dvec3 first = place[1] - place[0], second = place[2] - place[0];
    const double square = glm::dot(first, first), part = glm::dot(first, second);
    const double doubled = std::sqrt(std::max(square * glm::dot(second, second) - part * part, 0.0));
    if (!(doubled > 1e-9 * square))
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

void ConformalRelaxer::link()
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
inline void ConformalRelaxer::measure(Triangle& t) const
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
        // The edges opposite to the second and third corner, less the value times their conjugates.
        const Complex& value = t.value;
        const Complex second{value.re * t.x2 + value.im * t.y2 - t.x2,
                             value.im * t.x2 - value.re * t.y2 - t.y2};
        const Complex third{t.x1 - value.re * t.x1, -value.im * t.x1};
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
        for (Index i = m_first[vertex]; i < m_first[vertex + 1]; ++i) {
            const Triangle& triangle = m_triangles[m_uses[i].triangle];
            const Complex& w = triangle.slope[m_uses[i].place];
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
        for (Index i = m_first[vertex]; i < m_first[vertex + 1]; ++i) {
            Triangle& triangle = m_triangles[m_uses[i].triangle];
            const Complex& w = triangle.slope[m_uses[i].place];
            triangle.value.re += w.re * step.re - w.im * step.im;
            triangle.value.im += w.re * step.im + w.im * step.re;
        }
    }
}

void ConformalRelaxer::run(const Effort& effort)
{
    if (m_moved.size() != m_z.size())
        measure(true);
    if (m_stretched && m_first.size() != m_z.size() + 1)
        link();
    for (int round = 0; round < effort.evenRounds + effort.choosyRounds && m_stretched; ++round) {
        const bool choosy = round >= effort.evenRounds;
        weigh(choosy);
        for (int i = 0; i < (choosy ? effort.choosySweeps : effort.evenSweeps); ++i)
            sweep();
        measure(false);
    }
}

} // namespace ramure
