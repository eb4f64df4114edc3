#include "core/io/formats/glb/glb_parts.h"

#include "core/math/reproducible.h"
#include "core/math/srgb.h"
#include "core/surface/bark/bark_tints.h"
#include "core/surface/proof/validate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <tuple>

namespace ramure::glb {

/// Each edge of a closed mesh is walked once either way, so that what edges weigh adds up to nothing. Of
/// leaves, most of a tree, it does not, and they need no proof.
static bool mayBeClosed(const TriangleMesh& mesh)
{
    std::uint64_t sum = 0;
    for (const glm::uvec3& t : mesh.triangles)
        for (int c = 0; c < 3; ++c) {
            const std::uint64_t from = t[c], to = t[(c + 1) % 3];
            const std::uint64_t edge = (std::min(from, to) << 32U) | std::max(from, to);
            const std::uint64_t weight = (edge ^ (edge >> 29U)) * 0x9e3779b97f4a7c15U;
            sum += from < to ? weight : 0 - weight;
        }
    return sum == 0;
}

bool isClosed(const TriangleMesh& mesh)
{
    if (!mayBeClosed(mesh))
        return false;
    const auto report = validateMesh(mesh);
    return report && report->faces > 0 && report->boundaryEdges == 0 && report->nonManifoldEdges == 0 &&
           report->inconsistentEdges == 0 && report->nonManifoldVertices == 0;
}

/// IEC 61966-2-1.
static float linear(double c)
{
    return static_cast<float>(c <= 0.04045 ? c / 12.92 : maths::pow((c + 0.055) / 1.055, 2.4));
}

glm::vec3 linear(const glm::vec3& colour)
{
    return {linear(double(colour.r)), linear(double(colour.g)), linear(double(colour.b))};
}

float linear(std::uint8_t channel)
{
    return static_cast<float>(linearOf(channel));
}

namespace {

std::uint16_t linearBits(std::uint8_t channel)
{
    static const std::array<std::uint16_t, 256> table = [] {
        std::array<std::uint16_t, 256> all{};
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i] = static_cast<std::uint16_t>(std::lround(65535.0F * linear(static_cast<std::uint8_t>(i))));
        return all;
    }();
    return table[channel];
}

glm::u16vec4 linearBits(const glm::u8vec3& colour)
{
    return {linearBits(colour.r), linearBits(colour.g), linearBits(colour.b), 65535};
}

/// Splits the vertices of a mesh; of those at one position each leads to the next.
class Splitter
{
public:
    Splitter(const TriangleMesh& mesh, bool textured)
        : m_mesh(mesh)
        , m_hasUv(textured && !mesh.uv.empty())
        , m_hasColours(!mesh.colours.empty())
        , m_first(mesh.positions.size(), noIndex)
    {
        const std::size_t count = mesh.positions.size() + mesh.positions.size() / 8;
        m_next.reserve(count);
        m_out.from.reserve(count);
        m_out.positions.reserve(count);
        m_out.normals.reserve(mesh.normals.empty() ? 0 : count);
        m_out.uv.reserve(m_hasUv ? count : 0);
        m_out.colours.reserve(m_hasColours ? count : 0);
        m_out.indices.reserve(3 * mesh.triangles.size());
    }

    Vertices run()
    {
        for (std::size_t t = 0; t < m_mesh.triangles.size(); ++t) {
            const glm::u16vec4 colour = m_hasColours ? linearBits(m_mesh.colours[t]) : glm::u16vec4(65535);
            for (int k = 0; k < 3; ++k) {
                const Index position = m_mesh.triangles[t][k];
                const Index vertex = vertexOf(position, cornerUv(t, k), colour);
                if (vertex != m_first[position]) {
                    m_out.mergeIndices.push_back(static_cast<Index>(m_out.indices.size()));
                    m_out.mergeValues.push_back(m_first[position]);
                }
                m_out.indices.push_back(vertex);
            }
        }
        return std::move(m_out);
    }

private:
    [[nodiscard]] glm::vec2 cornerUv(std::size_t triangle, int corner) const
    {
        if (!m_hasUv)
            return glm::vec2(0.0F);
        const glm::uvec3& at =
            m_mesh.uvTriangles.empty() ? m_mesh.triangles[triangle] : m_mesh.uvTriangles[triangle];
        const glm::vec2& uv = m_mesh.uv[at[corner]];
        return {uv.x, 1.0F - uv.y}; // ours start at the lowest row of a picture
    }

    Index vertexOf(Index position, const glm::vec2& uv, const glm::u16vec4& colour)
    {
        Index last = noIndex;
        for (Index at = m_first[position]; at != noIndex; at = m_next[at]) {
            if ((!m_hasUv || m_out.uv[at] == uv) && (!m_hasColours || m_out.colours[at] == colour))
                return at;
            last = at;
        }
        const auto added = static_cast<Index>(m_out.positions.size());
        (last == noIndex ? m_first[position] : m_next[last]) = added;
        m_next.push_back(noIndex);
        m_out.from.push_back(position);
        m_out.positions.push_back(m_mesh.positions[position]);
        if (!m_mesh.normals.empty())
            m_out.normals.push_back(m_mesh.normals[position]);
        if (m_hasUv)
            m_out.uv.push_back(uv);
        if (m_hasColours)
            m_out.colours.push_back(colour);
        return added;
    }

    const TriangleMesh& m_mesh;
    bool m_hasUv, m_hasColours;
    std::vector<Index> m_first, m_next;
    Vertices m_out;
};

} // namespace

Json windExtras(const WindColumns& wind)
{
    Json out;
    for (const WindProfileFacts& facts : windProfiles())
        if (facts.profile == wind.profile)
            out["profile"] = facts.name;
    if (wind.profile == WindProfile::Crysis) {
        out["bendScale"] = wind.settings.bendScale;
        out["branchAmp"] = wind.settings.branchAmp;
        out["detailAmp"] = wind.settings.detailAmp;
    }
    return out;
}

Vertices verticesOf(const TriangleMesh& mesh, bool textured)
{
    return Splitter(mesh, textured).run();
}

void addAges(Vertices& vertices, const TriangleMesh& mesh, const BarkParams& bark)
{
    const BarkTints tints(bark);
    vertices.colours.reserve(vertices.from.size());
    for (const Index from : vertices.from) {
        vertices.colours.emplace_back(65535.0F * tints.at(mesh.radius[from], mesh.positions[from]) + 0.5F,
                                      65535);
    }
}

void addTangents(Vertices& vertices)
{
    const auto& [positions, normals, uv] = std::tie(vertices.positions, vertices.normals, vertices.uv);
    std::vector<glm::vec3> along(positions.size(), glm::vec3(0.0F)), across = along;
    for (std::size_t i = 0; i < vertices.indices.size(); i += 3) {
        const Index* corner = &vertices.indices[i];
        const glm::vec3 e1 = positions[corner[1]] - positions[corner[0]],
                        e2 = positions[corner[2]] - positions[corner[0]];
        const glm::vec2 d1 = uv[corner[1]] - uv[corner[0]], d2 = uv[corner[2]] - uv[corner[0]];
        // Rows of pictures are counted from the top, y of normals goes up.
        const float turn = d1.x * -d2.y + d2.x * d1.y < 0.0F ? -1.0F : 1.0F;
        for (int k = 0; k < 3; ++k) {
            along[corner[k]] += turn * (d1.y * e2 - d2.y * e1);
            across[corner[k]] += turn * (d1.x * e2 - d2.x * e1);
        }
    }
    vertices.tangents.reserve(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const glm::vec3& n = normals[i];
        glm::vec3 tangent = along[i] - glm::dot(n, along[i]) * n;
        if (!(glm::dot(tangent, tangent) > 1e-30F)) // a place where the picture is a point: any will do
            tangent = glm::cross(n, std::abs(n.x) < 0.7F ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0));
        tangent = glm::normalize(tangent);
        const float side = glm::dot(glm::cross(n, tangent), across[i]) < 0.0F ? -1.0F : 1.0F;
        vertices.tangents.emplace_back(tangent, side);
    }
}

} // namespace ramure::glb
