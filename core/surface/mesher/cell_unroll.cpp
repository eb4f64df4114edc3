#include "core/surface/mesher/cell_unroll.h"

#include "core/math/angle.h"

#include <algorithm>
#include <cmath>

namespace ramure {

namespace {

constexpr double leastIncrement = 0.02; ///< rad, between neighbours on a wall

double shortWay(double angle)
{
    return angle - fullTurn * std::round(angle / fullTurn);
}

/// In (0, 2 pi].
double onwards(double angle)
{
    const double part = angle - fullTurn * std::floor(angle / fullTurn);
    return part > 1e-9 ? part : part + fullTurn;
}

/// std::atan2(y, x) to 1e-5 rad, in a third of the time: enough to say which vertices are neighbours.
double azimuth(double x, double y)
{
    const double ax = std::abs(x), ay = std::abs(y), high = std::max(ax, ay);
    if (!(high > 0.0))
        return 0.0;
    // Abramowitz and Stegun 4.4.49.
    const double part = std::min(ax, ay) / high, square = part * part;
    const double even =
        0.9998660 + square * (-0.3302995 + square * (0.1801410 + square * (-0.0851330 + square * 0.0208351)));
    double angle = part * even;
    if (ay > ax)
        angle = 0.25 * fullTurn - angle;
    if (x < 0.0)
        angle = 0.5 * fullTurn - angle;
    return y < 0.0 ? -angle : angle;
}

double azimuthOf(const ForkChild& child, const glm::dvec3& point, double along)
{
    const std::vector<AxisSection>& sections = child.sections;
    std::size_t k = 0;
    while (k + 2 < sections.size() && sections[k + 1].along < along)
        ++k;
    const AxisSection &a = sections[k], &b = sections[k + 1];
    const double span = b.along - a.along;
    const double part = span > 0.0 ? std::clamp((along - a.along) / span, 0.0, 1.0) : 0.0;
    const glm::dvec3 away = point - child.table.pointAt(along);
    const glm::dvec3 normal = a.frame.normal + (b.frame.normal - a.frame.normal) * part;
    const glm::dvec3 binormal = a.frame.binormal + (b.frame.binormal - a.frame.binormal) * part;
    return azimuth(glm::dot(away, normal), glm::dot(away, binormal));
}

} // namespace

/// Gives the vertices after \p from, up to \p steps of them, azimuths that increase by \p total in all.
void CellUnroller::smoothRun(const std::vector<CellVertex>& boundary, std::size_t from, std::size_t steps,
                             double total, std::vector<UnrolledVertex>& out)
{
    const std::size_t count = boundary.size();
    m_increments.resize(steps);
    double sum = 0.0;
    for (std::size_t i = 0; i < steps; ++i) {
        m_increments[i] = shortWay(out[(from + i + 1) % count].azimuth - out[(from + i) % count].azimuth);
        sum += m_increments[i];
    }
    if (std::abs(sum - total) > 1e-3) // the child's axis does not pass through its cell
        for (std::size_t i = 0; i < steps; ++i)
            m_increments[i] = glm::length(boundary[(from + i + 1) % count].position -
                                          boundary[(from + i) % count].position);
    sum = 0.0;
    for (const double increment : m_increments)
        sum += std::max(increment, 0.0);
    const double scale = std::abs(sum) > 0.0 ? total / sum : 0.0;
    const double least = std::min(leastIncrement, 0.5 * total / static_cast<double>(steps));
    sum = 0.0;
    for (double& increment : m_increments) {
        increment = std::max(increment * scale, least);
        sum += increment;
    }
    for (std::size_t i = 0; i + 1 < steps; ++i)
        out[(from + i + 1) % count].azimuth =
            out[(from + i) % count].azimuth + m_increments[i] * (total / sum);
}

void CellUnroller::unroll(const std::vector<CellVertex>& boundary, const ForkChild& child, Index self,
                          double rollRad, std::vector<UnrolledVertex>& out)
{
    const std::size_t count = boundary.size();
    out.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const CellVertex& from = boundary[i];
        out[i].vertex = from.vertex;
        out[i].shared = {noIndex, noIndex};
        std::size_t others = 0;
        for (const Index sharer : from.cells)
            if (sharer != noIndex && sharer != self)
                out[i].shared[others++] = sharer;
        if (from.onRing) {
            out[i].along = 0.0;
            out[i].azimuth = from.azimuth - rollRad;
        } else {
            out[i].along = child.table.footOf(from.position, from.lifted);
            out[i].azimuth = azimuthOf(child, from.position, out[i].along);
        }
    }
    if (!boundary[0].onRing) {
        smoothRun(boundary, 0, count, fullTurn, out);
        return;
    }
    std::size_t i = 0;
    while (i < count) {
        const std::size_t next = (i + 1) % count;
        if (boundary[i].onRing && boundary[next].onRing) {
            out[next].azimuth = out[i].azimuth + onwards(out[next].azimuth - out[i].azimuth);
            ++i;
            continue;
        }
        std::size_t steps = 1;
        while (!boundary[(i + steps) % count].onRing)
            ++steps;
        const std::size_t end = (i + steps) % count;
        const double total = onwards(out[end].azimuth - out[i].azimuth);
        smoothRun(boundary, i, steps, total, out);
        if (end != 0)
            out[end].azimuth = out[i].azimuth + total;
        i += steps;
    }
}

double alongAt(const std::vector<UnrolledVertex>& row, double azimuth)
{
    const std::size_t count = row.size();
    const double first = row.front().azimuth;
    const double at = first + (azimuth - first) - fullTurn * std::floor((azimuth - first) / fullTurn);
    std::size_t i = 0;
    while (i + 1 < count && row[i + 1].azimuth <= at)
        ++i;
    const UnrolledVertex &a = row[i], &b = row[(i + 1) % count];
    const double span = (i + 1 < count ? b.azimuth : b.azimuth + fullTurn) - a.azimuth;
    const double part = span > 0.0 ? std::clamp((at - a.azimuth) / span, 0.0, 1.0) : 0.0;
    return a.along + (b.along - a.along) * part;
}

} // namespace ramure
