#include "tests/support/mesh_checker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <sstream>
#include <tuple>

namespace ramure::test {
namespace {

constexpr Index examplesPerKind = 3;

/// Counts a defect and describes the first few of its kind.
template <class... Parts>
void note(CheckedMesh& result, Index& counter, const char* kind, const Parts&... place)
{
    if (counter++ < examplesPerKind) {
        std::ostringstream text;
        text << "  " << kind << ":";
        ((text << ' ' << place), ...);
        result.examples += text.str() + '\n';
    }
}

std::string at(const glm::vec3& p)
{
    std::ostringstream text;
    text.precision(9);
    text << '(' << p.x << ", " << p.y << ", " << p.z << ')';
    return text.str();
}

class Sets
{
public:
    explicit Sets(Index count)
        : m_parent(count)
    {
        std::iota(m_parent.begin(), m_parent.end(), 0u);
    }
    Index find(Index i)
    {
        while (m_parent[i] != i)
            i = m_parent[i] = m_parent[m_parent[i]];
        return i;
    }
    void join(Index a, Index b) { m_parent[find(a)] = find(b); }

private:
    std::vector<Index> m_parent;
};

struct EdgeUse
{
    Index low, high, face;
    bool upward; ///< the face runs from low to high
    bool operator<(const EdgeUse& o) const
    {
        return std::tie(low, high, face, upward) < std::tie(o.low, o.high, o.face, o.upward);
    }
};

class Checker
{
public:
    explicit Checker(const TriangleMesh& mesh)
        : m_mesh(mesh)
    {
    }

    CheckedMesh run()
    {
        m_result.vertices = m_mesh.vertexCount();
        m_result.faces = m_mesh.faceCount();
        positions();
        collectFaces();
        edges();
        fans();
        duplicateFaces();
        components();
        owners();
        if (!m_mesh.normals.empty())
            normals();
        return m_result;
    }

private:
    [[nodiscard]] glm::dvec3 point(Index v) const { return glm::dvec3(m_mesh.positions[v]); }

    [[nodiscard]] glm::dvec3 areaVector(const glm::uvec3& t) const
    {
        return 0.5 * glm::cross(point(t.y) - point(t.x), point(t.z) - point(t.x));
    }

    void positions()
    {
        glm::dvec3 low(INFINITY), high(-INFINITY);
        std::vector<Index> order(m_mesh.positions.size());
        std::iota(order.begin(), order.end(), 0u);
        for (const Index v : order) {
            const glm::vec3& p = m_mesh.positions[v];
            if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
                note(m_result, m_result.nonFinite, "position that is no number, vertex", v);
                continue;
            }
            low = glm::min(low, glm::dvec3(p));
            high = glm::max(high, glm::dvec3(p));
        }
        const glm::dvec3 diagonal = high - low;
        m_areaFloor = low.x <= high.x ? 1e-14 * glm::dot(diagonal, diagonal) : 0.0;
        if (m_result.nonFinite != 0)
            return;
        const auto tuple = [this](Index v) {
            const glm::vec3& p = m_mesh.positions[v];
            return std::make_tuple(p.x, p.y, p.z);
        };
        std::sort(order.begin(), order.end(),
                  [&](Index a, Index b) { return tuple(a) != tuple(b) ? tuple(a) < tuple(b) : a < b; });
        for (std::size_t i = 1; i < order.size(); ++i)
            if (tuple(order[i]) == tuple(order[i - 1]))
                note(m_result, m_result.duplicateVertices, "duplicate vertices", order[i - 1], order[i],
                     at(m_mesh.positions[order[i]]), owner(order[i - 1]), owner(order[i]));
    }

    [[nodiscard]] std::string owner(Index v) const
    {
        return v < m_mesh.branch.size() ? "branch " + std::to_string(m_mesh.branch[v]) : std::string();
    }

    void collectFaces()
    {
        const Index count = m_mesh.vertexCount();
        std::vector<bool> used(count, false);
        for (Index f = 0; f < m_mesh.faceCount(); ++f) {
            const glm::uvec3& t = m_mesh.triangles[f];
            if (t.x >= count || t.y >= count || t.z >= count) {
                note(m_result, m_result.badIndices, "index out of range, face", f);
                continue;
            }
            used[t.x] = used[t.y] = used[t.z] = true;
            const bool repeated = t.x == t.y || t.y == t.z || t.z == t.x;
            const double area = glm::length(areaVector(t));
            if (repeated || !(area >= m_areaFloor) || area == 0.0)
                note(m_result, m_result.degenerateFaces, "degenerate face", f, t.x, t.y, t.z, "area", area,
                     "floor", m_areaFloor, at(m_mesh.positions[t.x]), owner(t.x), owner(t.y), owner(t.z));
            if (!repeated)
                m_faces.push_back(f);
        }
        for (Index v = 0; v < count; ++v)
            if (!used[v])
                note(m_result, m_result.isolatedVertices, "isolated vertex", v, owner(v));
    }

    void edges()
    {
        m_edges.reserve(m_faces.size() * 3);
        for (const Index f : m_faces) {
            const glm::uvec3& t = m_mesh.triangles[f];
            for (int k = 0; k < 3; ++k) {
                const Index a = t[k], b = t[(k + 1) % 3];
                m_edges.push_back({std::min(a, b), std::max(a, b), f, a < b});
            }
        }
        std::sort(m_edges.begin(), m_edges.end());
        for (std::size_t i = 0, end = 0; i < m_edges.size(); i = end) {
            const EdgeUse& e = m_edges[i];
            while (end < m_edges.size() && m_edges[end].low == e.low && m_edges[end].high == e.high)
                ++end;
            if (end - i == 1)
                note(m_result, m_result.boundaryEdges, "boundary edge", e.low, e.high,
                     at(m_mesh.positions[e.low]), owner(e.low), owner(e.high));
            else if (end - i > 2)
                note(m_result, m_result.crowdedEdges, "edge of", end - i, "faces", e.low, e.high,
                     at(m_mesh.positions[e.low]), owner(e.low), owner(e.high));
            else if (e.upward == m_edges[i + 1].upward)
                note(m_result, m_result.misorientedEdges, "edge run along twice the same way", e.low, e.high,
                     at(m_mesh.positions[e.low]), owner(e.low), owner(e.high));
        }
    }

    /// The fan of a vertex, seen as the edges opposite to it, is one closed polygon: count the connected
    /// pieces.
    void fans()
    {
        std::vector<std::vector<std::pair<Index, Index>>> links(m_mesh.positions.size());
        for (const Index f : m_faces) {
            const glm::uvec3& t = m_mesh.triangles[f];
            links[t.x].emplace_back(t.y, t.z);
            links[t.y].emplace_back(t.z, t.x);
            links[t.z].emplace_back(t.x, t.y);
        }
        for (Index v = 0; v < m_mesh.vertexCount(); ++v) {
            std::map<Index, Index> number;
            for (const auto& [a, b] : links[v]) {
                number.try_emplace(a, static_cast<Index>(number.size()));
                number.try_emplace(b, static_cast<Index>(number.size()));
            }
            Sets sets(static_cast<Index>(number.size()));
            for (const auto& [a, b] : links[v])
                sets.join(number[a], number[b]);
            Index pieces = 0;
            for (Index i = 0; i < number.size(); ++i)
                pieces += sets.find(i) == i ? 1 : 0;
            if (pieces > 1)
                note(m_result, m_result.pinchedVertices, "vertex with more than one fan", v,
                     at(m_mesh.positions[v]), owner(v));
        }
    }

    void duplicateFaces()
    {
        std::vector<std::array<Index, 4>> faces;
        faces.reserve(m_faces.size());
        for (const Index f : m_faces) {
            const glm::uvec3& t = m_mesh.triangles[f];
            std::array<Index, 3> corners{t.x, t.y, t.z};
            std::sort(corners.begin(), corners.end());
            faces.push_back({corners[0], corners[1], corners[2], f});
        }
        std::sort(faces.begin(), faces.end());
        for (std::size_t i = 1; i < faces.size(); ++i)
            if (std::equal(faces[i].begin(), faces[i].begin() + 3, faces[i - 1].begin()))
                note(m_result, m_result.duplicateFaces, "duplicate faces", faces[i - 1][3], faces[i][3]);
    }

    void components()
    {
        Sets sets(m_mesh.vertexCount());
        for (const Index f : m_faces) {
            sets.join(m_mesh.triangles[f].x, m_mesh.triangles[f].y);
            sets.join(m_mesh.triangles[f].y, m_mesh.triangles[f].z);
        }
        std::map<Index, Index> number;
        std::vector<glm::dvec3> origin; // a point of the piece, so that a far-off piece keeps its digits
        const auto piece = [&](Index v) -> CheckedComponent& {
            const auto [it, fresh] = number.try_emplace(sets.find(v), static_cast<Index>(number.size()));
            if (fresh) {
                m_result.components.emplace_back();
                origin.push_back(point(v));
            }
            return m_result.components[it->second];
        };
        std::vector<bool> seen(m_mesh.positions.size(), false);
        for (const Index f : m_faces) {
            const glm::uvec3& t = m_mesh.triangles[f];
            CheckedComponent& c = piece(t.x);
            const glm::dvec3 o = origin[number[sets.find(t.x)]];
            ++c.faces;
            ++c.euler;
            c.volume += glm::dot(point(t.x) - o, glm::cross(point(t.y) - o, point(t.z) - o)) / 6.0;
            for (int k = 0; k < 3; ++k)
                if (!seen[t[k]]) {
                    seen[t[k]] = true;
                    ++c.vertices;
                    ++c.euler;
                }
        }
        for (std::size_t i = 0; i < m_edges.size(); ++i)
            if (i == 0 || m_edges[i].low != m_edges[i - 1].low || m_edges[i].high != m_edges[i - 1].high)
                --piece(m_edges[i].low).euler;
    }

    void owners()
    {
        const std::size_t count = m_mesh.positions.size();
        if (!m_mesh.branch.empty() && m_mesh.branch.size() != count)
            note(m_result, m_result.badOwners, "branch ids", m_mesh.branch.size(), "for vertices", count);
        if (!m_mesh.level.empty() && m_mesh.level.size() != count)
            note(m_result, m_result.badOwners, "levels", m_mesh.level.size(), "for vertices", count);
    }

    /// Is the face higher than the rounding of its coordinates? If not, which way it looks is chance.
    [[nodiscard]] bool hasSide(const glm::uvec3& t) const
    {
        double edge = 0.0, coordinate = 0.0;
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 p = glm::abs(point(t[k]));
            edge = std::max(edge, glm::distance(point(t[k]), point(t[(k + 1) % 3])));
            coordinate = std::max({coordinate, p.x, p.y, p.z});
        }
        return 2.0 * glm::length(areaVector(t)) > edge * coordinate * 0x1p-22;
    }

    void normals()
    {
        if (m_mesh.normals.size() != m_mesh.positions.size()) {
            note(m_result, m_result.badNormals, "normals", m_mesh.normals.size(), "for vertices",
                 m_mesh.positions.size());
            return;
        }
        std::vector<glm::dvec3> mean(m_mesh.positions.size(), glm::dvec3(0.0));
        std::vector<double> total(m_mesh.positions.size(), 0.0), doubtful(total);
        for (const Index f : m_faces) {
            const glm::uvec3& t = m_mesh.triangles[f];
            const glm::dvec3 normal = areaVector(t);
            const bool sure = hasSide(t);
            for (int k = 0; k < 3; ++k) {
                const glm::dvec3 a = point(t[(k + 1) % 3]) - point(t[k]),
                                 b = point(t[(k + 2) % 3]) - point(t[k]);
                const double angle = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
                if (sure)
                    mean[t[k]] += angle * glm::normalize(normal);
                else
                    doubtful[t[k]] += angle;
                total[t[k]] += angle;
            }
        }
        for (Index v = 0; v < m_mesh.vertexCount(); ++v) {
            const glm::dvec3 n(m_mesh.normals[v]);
            if (!(std::abs(glm::length(n) - 1.0) < 1e-4))
                note(m_result, m_result.badNormals, "normal of length", glm::length(n), "vertex", v,
                     owner(v));
            // Faces that cancel each other (a folded leaf of area) leave no outward side to speak of; faces
            // of chance may have looked the normal's way.
            else if (glm::length(mean[v]) > 0.05 * total[v] && glm::dot(n, mean[v]) + doubtful[v] <= 0.0)
                note(m_result, m_result.inwardNormals, "inward normal, vertex", v, at(m_mesh.positions[v]),
                     owner(v));
        }
    }

    const TriangleMesh& m_mesh;
    CheckedMesh m_result;
    double m_areaFloor = 0.0;
    std::vector<Index> m_faces; ///< those with three different, existing vertices
    std::vector<EdgeUse> m_edges;
};

} // namespace

bool CheckedMesh::closedManifold() const
{
    return faces > 0 && badIndices == 0 && nonFinite == 0 && boundaryEdges == 0 && crowdedEdges == 0 &&
           misorientedEdges == 0 && pinchedVertices == 0 && duplicateVertices == 0 && duplicateFaces == 0 &&
           degenerateFaces == 0 && isolatedVertices == 0;
}

bool CheckedMesh::perfect(std::size_t componentCount) const
{
    return closedManifold() && badNormals == 0 && inwardNormals == 0 && badOwners == 0 &&
           components.size() == componentCount &&
           std::all_of(components.begin(), components.end(),
                       [](const CheckedComponent& c) { return c.euler == 2 && c.volume > 0.0; });
}

double CheckedMesh::volume() const
{
    double sum = 0.0;
    for (const CheckedComponent& c : components)
        sum += c.volume;
    return sum;
}

std::string CheckedMesh::summary() const
{
    std::ostringstream text;
    text << vertices << " vertices, " << faces << " faces, " << components.size() << " components";
    const std::pair<const char*, Index> counts[] = {{"bad indices", badIndices},
                                                    {"non-finite", nonFinite},
                                                    {"boundary edges", boundaryEdges},
                                                    {"crowded edges", crowdedEdges},
                                                    {"misoriented edges", misorientedEdges},
                                                    {"pinched vertices", pinchedVertices},
                                                    {"duplicate vertices", duplicateVertices},
                                                    {"duplicate faces", duplicateFaces},
                                                    {"degenerate faces", degenerateFaces},
                                                    {"isolated vertices", isolatedVertices},
                                                    {"bad normals", badNormals},
                                                    {"inward normals", inwardNormals},
                                                    {"bad owners", badOwners}};
    for (const auto& [name, count] : counts)
        if (count != 0)
            text << ", " << name << ' ' << count;
    text << '\n' << examples;
    for (std::size_t i = 0; i < components.size(); ++i)
        if (components[i].euler != 2 || !(components[i].volume > 0.0))
            text << "  component " << i << ": " << components[i].vertices << " vertices, "
                 << components[i].faces << " faces, Euler " << components[i].euler << ", volume "
                 << components[i].volume << '\n';
    return text.str();
}

CheckedMesh checkMesh(const TriangleMesh& mesh)
{
    return Checker(mesh).run();
}

} // namespace ramure::test
