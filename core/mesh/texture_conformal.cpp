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

ConformalRelaxer::Complex ConformalRelaxer::times(const Complex& a, const Complex& b)
{
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

void ConformalRelaxer::clear()
{
    m_z.clear();
    m_free.clear();
    m_triangles.clear();
    m_first.clear();
    m_awake.clear();
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
    const double x1 = std::sqrt(square), x2 = part / x1, y2 = doubled / x1;
    Triangle& added = m_triangles.emplace_back();
    added.corner = corner;
    added.opposite = {Complex{x2 - x1, y2}, Complex{-x2, -y2}, Complex{x1, 0.0}};
    for (std::size_t c = 0; c < 3; ++c) {
        added.shift.re += added.opposite[c].re * shift[c];
        added.shift.im += added.opposite[c].im * shift[c];
    }
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

/// Residuals anew, and what each triangle counts.
void ConformalRelaxer::weigh(Weights weights)
{
    std::fill(m_awake.begin(), m_awake.end(), std::uint8_t(0));
    m_folded = m_stretched = false;
    m_bad = 0;
    for (Triangle& triangle : m_triangles) {
        Complex r = triangle.shift;
        // With conjugate edges the same sum gives a instead of b; shifts are real.
        Complex q{triangle.shift.re, -triangle.shift.im};
        for (std::size_t c = 0; c < 3; ++c) {
            const Complex& w = triangle.opposite[c];
            const Complex& z = m_z[triangle.corner[c]];
            const double rr = w.re * z.re, ii = w.im * z.im, ri = w.re * z.im, ir = w.im * z.re;
            r.re += rr - ii;
            r.im += ri + ir;
            q.re += rr + ii;
            q.im += ri - ir;
        }
        // Both are 2i times the doubled area too large.
        const double b = r.re * r.re + r.im * r.im, a = q.re * q.re + q.im * q.im;
        const double doubled = triangle.opposite[2].re * triangle.opposite[0].im;
        const double size = 1.0 / std::max({a, 0.25 * b, leastSize * 4.0 * doubled * doubled});
        const double k2 = std::min(b * size, 4.0);
        m_folded = m_folded || !(k2 <= foldedK * foldedK); // or no number
        if (k2 > calmK * calmK) {
            m_stretched = true;
            for (const Index corner : triangle.corner)
                m_awake[corner] = m_free[corner];
        }
        m_bad += k2 >= goodK * goodK ? 1 : 0;
        const Complex inverse{q.re * size, -q.im * size};
        const Complex value = times(r, inverse);
        for (std::size_t c = 0; c < 3; ++c) {
            const Complex &w = triangle.opposite[c], turned = times(value, {w.re, -w.im});
            triangle.slope[c] = times({w.re - turned.re, w.im - turned.im}, inverse);
        }
        triangle.value = value;
        // Next to folding a triangle counts more and more, as in an energy that would be infinite there.
        const double room = std::max(1.0 - k2, leastRoom);
        const double excess = weights == Weights::Choosy ? k2 / halfK2 : 0.0;
        triangle.weight = (1.0 + k2) / ((1.0 + excess * excess) * room * room * room);
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

void ConformalRelaxer::run(int rounds, int sweeps, Weights weights)
{
    weigh(weights);
    if (m_stretched && m_first.size() != m_z.size() + 1)
        link();
    for (int round = 0; round < rounds && m_stretched; ++round) {
        for (int i = 0; i < sweeps; ++i)
            sweep();
        weigh(weights);
    }
}

} // namespace ramure
