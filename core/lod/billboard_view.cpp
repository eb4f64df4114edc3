#include "core/lod/billboard_view.h"

#include "core/math/reproducible.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace ramure {
namespace {

/// One view as points, each as large as a pixel, seen from elsewhere.
class Splats
{
public:
    explicit Splats(int size)
        : m_size(size)
        , m_sum(std::size_t(size) * std::size_t(size), 0.0F)
    {
    }
    /// \param x \param y of the middle of a pixel, in pixels
    void add(double x, double y, float alpha)
    {
        const double left = std::floor(x - 0.5), top = std::floor(y - 0.5);
        const auto u = static_cast<float>(x - 0.5 - left), v = static_cast<float>(y - 0.5 - top);
        const int i = static_cast<int>(left), j = static_cast<int>(top);
        at(i, j, alpha * (1.0F - u) * (1.0F - v));
        at(i + 1, j, alpha * u * (1.0F - v));
        at(i, j + 1, alpha * (1.0F - u) * v);
        at(i + 1, j + 1, alpha * u * v);
    }
    void mostInto(Coverage& out) const
    {
        for (std::size_t i = 0; i < out.size(); ++i)
            out[i] = std::max(out[i], std::min(m_sum[i], 1.0F));
    }

private:
    void at(int x, int y, float share)
    {
        if (x >= 0 && y >= 0 && x < m_size && y < m_size)
            m_sum[std::size_t(y) * std::size_t(m_size) + std::size_t(x)] += share;
    }
    int m_size;
    Coverage m_sum;
};

} // namespace

Coverage coverageOf(const BillboardPicture& picture)
{
    Coverage out;
    out.reserve(picture.colour.size());
    for (const glm::u8vec4& colour : picture.colour)
        out.push_back(static_cast<float>(colour.a) / 255.0F);
    return out;
}

Coverage atlasCoverage(const BillboardPicture& atlas, int views, const glm::dvec3& direction)
{
    const int side = atlas.width / views;
    const double half = 0.5 * side;
    const ViewFrame eye = viewFrame(direction);
    Coverage out(std::size_t(side) * std::size_t(side), 0.0F);
    for (const AtlasCell cell : viewsAround(direction, views)) {
        const ViewFrame view = viewFrame(atlasDirection(cell, views));
        Splats splats(side);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const std::size_t i = atlas.at(cell.column * side + x, cell.row * side + y);
                if (atlas.colour[i].a == 0)
                    continue;
                const double depth = (atlas.normal[i].a - 1.0) / 127.0 - 1.0;
                const glm::dvec3 point = (x + 0.5 - half) / half * view.right -
                                         (y + 0.5 - half) / half * view.up + depth * view.backward;
                splats.add(half + half * glm::dot(point, eye.right), half - half * glm::dot(point, eye.up),
                           static_cast<float>(atlas.colour[i].a) / 255.0F);
            }
        splats.mostInto(out);
    }
    return out;
}

Likeness likenessOf(const Coverage& one, const Coverage& other)
{
    double lesser = 0.0, greater = 0.0;
    std::size_t both = 0, either = 0;
    for (std::size_t i = 0; i < one.size(); ++i) {
        lesser += std::min(one[i], other[i]);
        greater += std::max(one[i], other[i]);
        both += one[i] >= 0.5F && other[i] >= 0.5F ? 1 : 0;
        either += one[i] >= 0.5F || other[i] >= 0.5F ? 1 : 0;
    }
    Likeness out;
    if (greater > 0.0)
        out.soft = lesser / greater;
    if (either > 0)
        out.hard = double(both) / double(either);
    return out;
}

std::vector<glm::dvec3> hemisphereDirections(int count)
{
    const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
    std::vector<glm::dvec3> out;
    for (int i = 0; i < count; ++i) {
        const double up = 1.0 - (i + 0.5) / count;
        const double level = std::sqrt(1.0 - up * up);
        out.emplace_back(level * maths::sin(golden * i), up, level * maths::cos(golden * i));
    }
    return out;
}

} // namespace ramure
