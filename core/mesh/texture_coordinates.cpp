#include "core/mesh/texture_coordinates.h"

#include "core/mesh/texture_tube.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace ramure {

namespace {

constexpr double turn = 2.0 * std::numbers::pi;
constexpr double leastAround = 6.0;    ///< tiles around the thinnest branch, where the size is chosen for it
constexpr double mostAround = 1e6;     ///< more of them than floats tell apart
constexpr std::size_t pollEvery = 256; ///< tubes

/// Unrolls tube after tube, parents first, and strings their coordinates together.
class CoordinateBuilder
{
public:
    CoordinateBuilder(const BranchMesh& mesh, double tileSize);
    void addTube(std::size_t index);
    TextureCoordinates take() { return std::move(m_result); }

private:
    [[nodiscard]] TubeTextureEnd parentOf(std::size_t index) const;
    void gather(Index first, Index end);
    void write(Index first);
    glm::uvec3 place(const glm::uvec3& triangle);
    Index add(Index vertex, const glm::dvec2& uv);

    const BranchMesh& m_mesh;
    TubeTexture m_tube;
    TextureCoordinates m_result;
    std::vector<Index> m_slot;          ///< per vertex: its place in the tube at hand, if it is in there
    std::vector<Index> m_coordinate;    ///< per vertex: its first coordinate, or noIndex
    std::vector<std::uint8_t> m_isWall; ///< per vertex
    std::vector<Index> m_tubeOf;        ///< per branch
    std::vector<TubeTextureEnd> m_ends; ///< per tube
    std::vector<Index> m_plain, m_shifted, m_flat; ///< per vertex of the tube: its coordinates
};

CoordinateBuilder::CoordinateBuilder(const BranchMesh& mesh, double tileSize)
    : m_mesh(mesh)
    , m_tube(tileSize)
    , m_slot(mesh.mesh.positions.size(), 0)
    , m_coordinate(mesh.mesh.positions.size(), noIndex)
    , m_isWall(mesh.mesh.positions.size(), 0)
    , m_ends(mesh.tubes.size())
{
    for (const ForkVertex& fork : mesh.forkVertices)
        m_isWall[fork.vertex] = 1;
    Index branches = 0;
    for (const TubeRange& tube : mesh.tubes)
        branches = std::max(branches, tube.branch + 1);
    m_tubeOf.assign(branches, noIndex);
    const std::size_t expected = mesh.mesh.positions.size() * 3 / 2;
    m_result.uv.reserve(expected);
    m_result.vertex.reserve(expected);
    m_result.corners.resize(mesh.mesh.triangles.size());
    m_result.tileSize = tileSize;
}

TubeTextureEnd CoordinateBuilder::parentOf(std::size_t index) const
{
    const Index parent = m_mesh.tubes[index].parent;
    if (parent == noIndex || parent >= m_tubeOf.size() || m_tubeOf[parent] == noIndex)
        return {};
    return m_ends[m_tubeOf[parent]];
}

void CoordinateBuilder::gather(Index first, Index end)
{
    m_tube.begin();
    for (Index t = first; t < end; ++t) {
        glm::uvec3 corners;
        for (int c = 0; c < 3; ++c) {
            const Index vertex = m_mesh.mesh.triangles[t][c];
            const std::span<const TubeTextureVertex> known = m_tube.vertices();
            Index& slot = m_slot[vertex];
            if (slot >= known.size() || known[slot].vertex != vertex) {
                const bool onWall = m_isWall[vertex] != 0;
                const Index coordinate = m_coordinate[vertex];
                const bool onParent = !onWall && coordinate != noIndex;
                slot = m_tube.addVertex(vertex, m_mesh.mesh.positions[vertex], onParent, onWall,
                                        onParent ? m_result.uv[coordinate] : glm::vec2(0.0f));
            }
            corners[c] = slot;
        }
        m_tube.addTriangle(corners);
    }
}

Index CoordinateBuilder::add(Index vertex, const glm::dvec2& uv)
{
    const auto index = static_cast<Index>(m_result.uv.size());
    m_result.uv.emplace_back(uv);
    m_result.vertex.push_back(vertex);
    if (m_coordinate[vertex] == noIndex)
        m_coordinate[vertex] = index;
    return index;
}

void CoordinateBuilder::write(Index first)
{
    const std::span<const TubeTextureVertex> vertices = m_tube.vertices();
    m_plain.assign(vertices.size(), noIndex);
    m_shifted.assign(vertices.size(), noIndex);
    m_flat.assign(vertices.size(), noIndex);
    // A ring's vertices get their place on the tube first: children go on from there, not from a cap.
    for (std::size_t i = 0; i < vertices.size(); ++i)
        if (!vertices[i].isPole)
            m_plain[i] = add(vertices[i].vertex, {vertices[i].u, vertices[i].v});
    const std::span<const glm::uvec3> triangles = m_tube.triangles();
    for (std::size_t t = 0; t < triangles.size(); ++t)
        m_result.corners[first + t] = place(triangles[t]);
}

/// The coordinates of a triangle's corners.
glm::uvec3 CoordinateBuilder::place(const glm::uvec3& triangle)
{
    const std::span<const TubeTextureVertex> vertices = m_tube.vertices();
    const bool cap = m_tube.isCap(triangle);
    const std::array<bool, 3> beyond = m_tube.beyondSeam(triangle);
    std::array<glm::vec2, 3> uv;
    std::array<Index*, 3> slot{};
    for (int c = 0; c < 3; ++c) {
        const TubeTextureVertex& vertex = vertices[triangle[c]];
        const auto corner = static_cast<std::size_t>(c);
        std::vector<Index>& kind = cap ? m_flat : beyond[corner] ? m_shifted : m_plain;
        slot[corner] = &kind[triangle[c]];
        uv[corner] = cap ? glm::vec2(m_tube.onDisc(vertex, m_mesh.mesh.positions[vertex.vertex]))
                         : glm::vec2(vertex.u + (beyond[corner] ? vertex.around : 0.0), vertex.v);
    }
    const glm::dvec2 a(uv[0]), ab = glm::dvec2(uv[1]) - a, ac = glm::dvec2(uv[2]) - a;
    const bool folded = !(ab.x * ac.y - ab.y * ac.x > 0.0);
    const std::array<glm::dvec2, 3> apart = folded ? m_tube.apart(triangle) : std::array<glm::dvec2, 3>{};
    m_result.apart += folded ? 1 : 0;
    glm::uvec3 out;
    for (int c = 0; c < 3; ++c) {
        const auto corner = static_cast<std::size_t>(c);
        const Index vertex = vertices[triangle[c]].vertex;
        if (folded)
            out[c] = add(vertex, apart[corner]);
        else if (*slot[corner] == noIndex)
            out[c] = *slot[corner] = add(vertex, uv[corner]);
        else
            out[c] = *slot[corner];
    }
    return out;
}

void CoordinateBuilder::addTube(std::size_t index)
{
    const TubeRange& tube = m_mesh.tubes[index];
    const Index end =
        index + 1 < m_mesh.tubes.size() ? m_mesh.tubes[index + 1].firstTriangle : m_mesh.mesh.faceCount();
    gather(tube.firstTriangle, end);
    m_tube.unroll(m_mesh.axes[index], parentOf(index));
    m_ends[index] = m_tube.end();
    m_result.cut += m_tube.isCut() ? 1 : 0;
    m_tubeOf[tube.branch] = static_cast<Index>(index);
    write(tube.firstTriangle);
}

double tileFor(const BranchMesh& mesh, double wanted)
{
    if (wanted > 0.0)
        return wanted;
    double thinnest = std::numeric_limits<double>::infinity();
    for (const TubeAxis& axis : mesh.axes)
        thinnest = std::min(thinnest, 0.5 * (axis.a0 + axis.a1));
    return turn * thinnest / leastAround;
}

Expected<void> check(const BranchMesh& mesh, const TextureOptions& options)
{
    const bool usable = !mesh.tubes.empty() && mesh.axes.size() == mesh.tubes.size() &&
                        mesh.tubes.front().firstTriangle == 0 &&
                        mesh.tubes.back().firstTriangle <= mesh.mesh.faceCount();
    if (!usable)
        return fail(ErrorCode::Invalid,
                    RAMURE_NOOP("The mesh does not say which triangles belong to which tube"));
    if (!std::isfinite(options.tileSize) || options.tileSize < 0.0)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("The size of a texture tile is not a usable number"));
    double thickest = 0.0;
    for (const TubeAxis& axis : mesh.axes)
        thickest = std::max({thickest, axis.a0, axis.a1});
    if (turn * thickest > mostAround * tileFor(mesh, options.tileSize))
        return fail(ErrorCode::Invalid, RAMURE_NOOP("The texture tile is too small for the tree"));
    return {};
}

} // namespace

Expected<TextureCoordinates> textureCoordinates(const BranchMesh& mesh, const TextureOptions& options,
                                                const Progress& progress)
{
    if (auto checked = check(mesh, options); !checked)
        return fail(checked.error());
    CoordinateBuilder builder(mesh, tileFor(mesh, options.tileSize));
    for (std::size_t i = 0; i < mesh.tubes.size(); ++i) {
        if (i % pollEvery == 0) {
            if (progress.cancelled())
                return fail(ErrorCode::Cancelled, RAMURE_NOOP("Cancelled"));
            progress.report(double(i) / double(mesh.tubes.size()));
        }
        builder.addTube(i);
    }
    return builder.take();
}

TriangleMesh splitByTexture(const BranchMesh& mesh, const TextureCoordinates& coordinates)
{
    TriangleMesh split;
    const std::size_t count = coordinates.uv.size();
    split.triangles = coordinates.corners;
    split.uv = coordinates.uv;
    split.positions.reserve(count);
    split.normals.reserve(count);
    split.branch.reserve(count);
    split.level.reserve(count);
    for (const Index vertex : coordinates.vertex) {
        split.positions.push_back(mesh.mesh.positions[vertex]);
        split.normals.push_back(mesh.mesh.normals[vertex]);
        split.branch.push_back(mesh.mesh.branch[vertex]);
        split.level.push_back(mesh.mesh.level[vertex]);
    }
    return split;
}

} // namespace ramure
