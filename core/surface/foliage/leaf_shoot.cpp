#include "core/surface/foliage/leaf_shoot.h"

#include "core/math/angle.h"
#include "core/math/reproducible.h"
#include "core/surface/foliage/leaf_table.h"
#include "core/surface/foliage/leaf_turns.h"
#include "core/surface/mesh/normals.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace ramure {
namespace {

/// Of the stem at its foot and at its end, and how far it reaches into the bark.
constexpr double footRadius = 0.016, endRadius = 0.008, sunkStem = 0.02;
/// sRGB, of young bark.
constexpr glm::vec3 youngBark(98.0F, 84.0F, 66.0F);

/// The fraction of a number by the golden section: spread evenly, the same wherever it is asked for.
double spread(int i)
{
    const double x = (i + 1) * 0.6180339887498949;
    return x - std::floor(x);
}

class ShootBuilder
{
public:
    ShootBuilder(const TriangleMesh& leaf, const LeafForm& form)
        : m_leaf(leaf)
        , m_form(form)
        , m_turns(leafTurns(form.arrangement, form.whorl))
    {
        const LeafRow& row = leafRow(form.shape);
        m_gap = row.internode / row.length;
        m_nodes = (form.perShoot - 2 + m_turns.perNode) / m_turns.perNode; // the last leaf ends the stem
        m_length = m_gap * (m_nodes + 0.25);
        m_pieces = std::clamp(form.detail - 1, 1, m_nodes);
        m_wood =
            glm::u8vec3(glm::min(255.0F * youngBark / glm::vec3(leafColour(form.shape, form.turns)), 255.0F));
    }

    TriangleMesh build()
    {
        for (int i = 0; i + 1 < m_form.perShoot; ++i) {
            const int node = i / m_turns.perNode;
            const double around = node * m_turns.fromNodeToNode +
                                  2.0 * pi * (i % m_turns.perNode) / m_turns.perNode +
                                  0.35 * (spread(i) - 0.5);
            addLeaf(m_gap * (node + 0.65 + 0.2 * spread(node)), around,
                    m_form.angle * (0.8 + 0.35 * spread(i + 7)), i);
        }
        addLeaf(m_length, 0.25 * pi, 0.15 * m_form.angle, m_form.perShoot - 1);
        addStem();
        computeNormals(m_mesh);
        return std::move(m_mesh);
    }

private:
    /// Where a leaf stands: on the stem as it is drawn.
    [[nodiscard]] glm::dvec3 onStem(double y) const
    {
        const double piece = m_length / m_pieces, from = piece * std::floor(y / piece);
        return from >= m_length ? stemAt(m_length)
                                : glm::mix(stemAt(from), stemAt(from + piece), (y - from) / piece);
    }
    /// The stem bows a little towards the light, and from node to node.
    [[nodiscard]] glm::dvec3 stemAt(double y) const
    {
        const double share = y / m_length;
        return {0.05 * m_length * maths::sin(2.6 * share), y, 0.09 * m_length * share * share};
    }

    void addLeaf(double y, double around, double angle, int number)
    {
        const auto [sine, cosine] = maths::sincos(around);
        const auto [away, ahead] = maths::sincos(angle);
        // Petioles bend until the leaves of a shoot lie beside each other, not above.
        const glm::dvec3 out(cosine, 0.0, m_turns.level ? 0.15 * sine : 0.55 * sine);
        const glm::dvec3 way = glm::normalize(away * out + glm::dvec3(0.0, ahead, 0.0));
        const auto across = [&way](const glm::dvec3& v) { return v - glm::dot(v, way) * way; };
        const double twist = 0.5 * (spread(number + 3) - 0.5);
        const glm::dvec3 upper = glm::normalize(across({twist, 0.3, 1.0}));
        const glm::dvec3 right = glm::cross(way, upper);
        const double share = y / m_length;
        const double size = (1.0 - 0.35 * (1.0 - share) * (1.0 - share) - 0.2 * share * share) *
                            (0.9 + 0.2 * spread(number + 11));
        const auto shade = static_cast<float>(0.86 + 0.14 * spread(number + 5));
        const glm::dvec3 foot = onStem(y);
        const auto first = static_cast<Index>(m_mesh.positions.size());
        for (const glm::vec3& p : m_leaf.positions)
            m_mesh.positions.emplace_back(
                foot + size * (double(p.x) * right + double(p.y) * way + double(p.z) * upper));
        m_mesh.uv.insert(m_mesh.uv.end(), m_leaf.uv.begin(), m_leaf.uv.end());
        for (const glm::uvec3& t : m_leaf.triangles)
            m_mesh.triangles.push_back(t + first);
        for (const glm::u8vec3& colour : m_leaf.colours)
            m_mesh.colours.emplace_back(shade * glm::vec3(colour) + 0.5F);
    }

    /// Three sides, and a tip that the last leaf covers.
    void addStem()
    {
        const auto first = static_cast<Index>(m_mesh.positions.size());
        for (int i = 0; i < m_pieces; ++i) {
            const double share = static_cast<double>(i) / m_pieces;
            const double radius = footRadius + (endRadius - footRadius) * share;
            const glm::dvec3 centre = i == 0 ? glm::dvec3(0.0, -sunkStem, 0.0) : stemAt(m_length * share);
            for (int k = 0; k < 3; ++k) {
                const auto [sine, cosine] = maths::sincos(2.0 * pi * k / 3.0 + 0.5 * pi);
                m_mesh.positions.emplace_back(centre + glm::dvec3(radius * cosine, 0.0, -radius * sine));
            }
        }
        m_mesh.positions.emplace_back(stemAt(m_length));
        m_mesh.uv.resize(m_mesh.positions.size(), {0.5F, 0.0F});
        const auto end = static_cast<Index>(m_mesh.positions.size() - 1);
        for (int i = 0; i < m_pieces; ++i)
            for (Index k = 0; k < 3; ++k) {
                const Index ring = first + static_cast<Index>(3 * i), a = ring + k, b = ring + (k + 1) % 3;
                if (i + 1 == m_pieces) {
                    face({a, end, b});
                } else {
                    face({a, b + 3, b});
                    face({a, a + 3, b + 3});
                }
            }
    }
    void face(const glm::uvec3& triangle)
    {
        m_mesh.triangles.push_back(triangle);
        m_mesh.colours.push_back(m_wood);
    }

    const TriangleMesh& m_leaf;
    const LeafForm& m_form;
    LeafTurns m_turns;
    double m_gap = 0.0, m_length = 0.0;
    int m_nodes = 1, m_pieces = 1; ///< leaves stand at nodes; the stem is drawn in so many straight pieces
    glm::u8vec3 m_wood;            ///< what makes young bark of the plant's own colour
    TriangleMesh m_mesh;
};

} // namespace

TriangleMesh shootOf(const TriangleMesh& leaf, const LeafForm& form)
{
    if (form.perShoot < 2 || leaf.empty())
        return leaf;
    return ShootBuilder(leaf, form).build();
}

double bladeArea(const LeafForm& form)
{
    const TriangleMesh leaf = leafMesh(form);
    const LeafRow& row = leafRow(form.shape);
    // Half of the surface of a round needle is this much more than its shadow, which its triangles are (Chen,
    // Black: "Defining leaf area index for non-flat leaves", 1992).
    const double round = row.family == LeafFamily::Shoot && !row.flat ? 0.5 * pi : 1.0;
    double area = 0.0;
    for (std::size_t t = 0; t < leaf.triangles.size(); ++t) {
        if (leaf.colours[t].r != leaf.colours[t].g ||
            leaf.colours[t].g != leaf.colours[t].b) // stalks and wood
            continue;
        const glm::uvec3& corner = leaf.triangles[t];
        const glm::dvec3 a(leaf.positions[corner.x]), b(leaf.positions[corner.y]),
            c(leaf.positions[corner.z]);
        area += 0.5 * glm::length(glm::cross(b - a, c - a));
    }
    return round * area;
}

} // namespace ramure
