#include "widgets/view/render/light/crown_light.h"

#include "core/math/box.h"
#include "core/surface/foliage/place_foliage.h"
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace ramure {
namespace {

constexpr int longestSide = 32;    ///< cells
constexpr double fromBelow = 0.35; ///< the ground's light, of the sky's

double areaOf(const TriangleMesh& mesh)
{
    double twice = 0.0;
    for (const glm::uvec3& t : mesh.triangles)
        twice += double(glm::length(glm::cross(mesh.positions[t.y] - mesh.positions[t.x],
                                               mesh.positions[t.z] - mesh.positions[t.x])));
    return 0.5 * twice;
}

/// What is kept of the light on its way through the cells, from every side.
class Ways
{
public:
    Ways(const glm::ivec3& cells, std::vector<float> depth)
        : m_cells(cells)
        , m_depth(std::move(depth))
        , m_kept(m_depth.size())
        , m_sum(m_depth.size(), glm::vec4(0.0f))
    {
    }
    /// Adds the light that comes from the cells' neighbours in a direction, those from theirs and so on.
    void add(const glm::ivec3& way)
    {
        const glm::vec3 unit = glm::normalize(glm::vec3(way));
        const float half = 0.5f * glm::length(glm::vec3(way));
        const float weight = float(glm::mix(fromBelow, 1.0, 0.5 + 0.5 * double(unit.y)));
        const auto at = [](int i, int count, int step) { return step > 0 ? count - 1 - i : i; };
        for (int k = 0; k < m_cells.z; ++k)
            for (int j = 0; j < m_cells.y; ++j)
                for (int i = 0; i < m_cells.x; ++i) {
                    const glm::ivec3 cell(at(i, m_cells.x, way.x), at(j, m_cells.y, way.y),
                                          at(k, m_cells.z, way.z));
                    const std::size_t here = indexOf(cell);
                    float kept = std::exp(-half * m_depth[here]);
                    if (const glm::ivec3 next = cell + way; isIn(next))
                        kept *= m_kept[indexOf(next)] * std::exp(-half * m_depth[indexOf(next)]);
                    m_kept[here] = kept;
                    m_sum[here] += weight * kept * glm::vec4(unit, 1.0f);
                }
        m_most += weight;
    }
    [[nodiscard]] std::vector<glm::u8vec4> light() const
    {
        std::vector<glm::u8vec4> light;
        light.reserve(m_sum.size());
        for (const glm::vec4& sum : m_sum) {
            const glm::vec3 out = glm::vec3(sum) / std::max(glm::length(glm::vec3(sum)), 1e-6f);
            light.emplace_back(glm::u8vec3(127.5f * out + 128.0f),
                               static_cast<std::uint8_t>(255.0f * std::min(sum.w / m_most, 1.0f)));
        }
        return light;
    }

private:
    [[nodiscard]] bool isIn(const glm::ivec3& cell) const
    {
        return glm::all(glm::greaterThanEqual(cell, glm::ivec3(0))) && glm::all(glm::lessThan(cell, m_cells));
    }
    [[nodiscard]] std::size_t indexOf(const glm::ivec3& cell) const
    {
        return static_cast<std::size_t>((cell.z * m_cells.y + cell.y) * m_cells.x + cell.x);
    }

    glm::ivec3 m_cells;
    std::vector<float> m_depth; ///< optical, across one cell
    std::vector<float> m_kept;
    std::vector<glm::vec4> m_sum;
    float m_most = 0.0f;
};

} // namespace

CrownLight crownLight(const Foliage& foliage, double alpha)
{
    CrownLight made;
    Box box;
    for (const FoliageItem& leaf : foliage.leaves)
        box.add(leaf.position);
    const glm::dvec3 size = box.empty() ? glm::dvec3(0.0) : box.size();
    const double longest = std::max({size.x, size.y, size.z});
    if (!(longest > 0.0))
        return made;
    const double cell = longest / (longestSide - 4);
    // Two cells of free air around it.
    const glm::dvec3 low = box.min - 2.0 * cell;
    made.cells = glm::ivec3(glm::ceil(size / cell)) + 4;
    made.place = glm::translate(glm::scale(glm::dmat4(1.0), 1.0 / (cell * glm::dvec3(made.cells))), -low);
    std::vector<float> depth(static_cast<std::size_t>(made.cells.x * made.cells.y * made.cells.z), 0.0f);
    // Seen from anywhere, leaves of all directions cover half of their area.
    const double share = 0.5 * areaOf(oneLeaf(foliage.form, alpha, FoliageModel::Fine)) / (cell * cell);
    for (const FoliageItem& leaf : foliage.leaves) {
        const glm::ivec3 at = glm::min(glm::ivec3((leaf.position - low) / cell), made.cells - 1);
        depth[static_cast<std::size_t>((at.z * made.cells.y + at.y) * made.cells.x + at.x)] +=
            float(share * double(leaf.size) * double(leaf.size));
    }
    Ways ways(made.cells, std::move(depth));
    for (int way = 0; way < 27; ++way)
        if (way != 13)
            ways.add(glm::ivec3(way % 3, way / 3 % 3, way / 9) - 1);
    made.light = ways.light();
    return made;
}

} // namespace ramure
