#include "widgets/base/defect_place.h"

#include <algorithm>
#include <glm/mat4x4.hpp>

namespace ramure {
namespace {

constexpr double roomShare =
    0.01; ///< of the mesh's radius: a single vertex is framed with this much around it

/// Adds what exists of a mesh to a place.
class Collector
{
public:
    Collector(const TriangleMesh& mesh, const glm::dmat4& world, DefectPlace& place)
        : m_mesh(mesh)
        , m_world(world)
        , m_place(place)
    {
    }

    void vertex(Index v)
    {
        if (v < m_mesh.vertexCount())
            m_place.points.push_back(at(v));
    }
    void edge(Index a, Index b)
    {
        if (a < m_mesh.vertexCount() && b < m_mesh.vertexCount())
            m_place.edges.push_back({at(a), at(b)});
    }
    void face(Index f)
    {
        if (f >= m_mesh.faceCount())
            return;
        const glm::uvec3& t = m_mesh.triangles[f];
        if (std::max({t.x, t.y, t.z}) < m_mesh.vertexCount())
            m_place.faces.push_back({at(t.x), at(t.y), at(t.z)});
    }

private:
    glm::dvec3 at(Index v)
    {
        const glm::dvec3 point(m_world * glm::dvec4(m_mesh.positions[v], 1.0));
        m_place.box.add(point);
        return point;
    }

    const TriangleMesh& m_mesh;
    const glm::dmat4& m_world;
    DefectPlace& m_place;
};

double worldRadius(const TriangleMesh& mesh, const glm::dmat4& world)
{
    Box box;
    for (const glm::vec3& p : mesh.positions)
        box.add(glm::dvec3(p));
    return box.transformed(world).radius();
}

bool concernsFaces(DefectKind kind)
{
    return kind == DefectKind::DuplicateFace || kind == DefectKind::DegenerateFace;
}

/// Without room around it.
DefectPlace bare(const TriangleMesh& mesh, const Defect& defect, const glm::dmat4& world)
{
    DefectPlace place;
    place.kind = defect.kind;
    Collector collect(mesh, world, place);
    switch (defect.kind) {
    case DefectKind::BoundaryEdge:
    case DefectKind::NonManifoldEdge:
    case DefectKind::InconsistentEdge:
        collect.edge(defect.a, defect.b);
        break;
    case DefectKind::NonManifoldVertex:
    case DefectKind::DuplicateVertex:
    case DefectKind::IsolatedVertex:
        collect.vertex(defect.a);
        collect.vertex(defect.b);
        break;
    case DefectKind::DuplicateFace:
    case DefectKind::DegenerateFace:
        collect.face(defect.a);
        collect.face(defect.b);
        break;
    }
    return place;
}

} // namespace

DefectPlace defectPlace(const TriangleMesh& mesh, const Defect& defect, const glm::dmat4& world)
{
    DefectPlace place = bare(mesh, defect, world);
    place.box = place.box.grown(std::max(place.box.radius(), roomShare * worldRadius(mesh, world)));
    return place;
}

DefectPlace facesPlace(const TriangleMesh& mesh, const std::array<Index, 2>& faces, const glm::dmat4& world)
{
    return defectPlace(mesh, {DefectKind::DuplicateFace, faces[0], faces[1]}, world);
}

DefectPlace pointPlace(const glm::dvec3& point, double room, const glm::dmat4& world)
{
    DefectPlace place;
    place.kind = DefectKind::DuplicateVertex; // two in one place
    place.points.emplace_back(world * glm::dvec4(point, 1.0));
    Box around;
    around.add(point - glm::dvec3(room));
    around.add(point + glm::dvec3(room));
    place.box = around.transformed(world);
    return place;
}

std::optional<glm::dvec3> facesMiddle(const TriangleMesh& mesh, const std::array<Index, 2>& faces)
{
    return defectMiddle(mesh, {DefectKind::DuplicateFace, faces[0], faces[1]});
}

Index faceBranch(const TriangleMesh& mesh, Index face)
{
    return defectBranch(mesh, {DefectKind::DegenerateFace, face});
}

std::optional<glm::dvec3> defectMiddle(const TriangleMesh& mesh, const Defect& defect)
{
    const Box box = bare(mesh, defect, glm::dmat4(1.0)).box;
    return box.empty() ? std::nullopt : std::optional(box.centre());
}

Index defectBranch(const TriangleMesh& mesh, const Defect& defect)
{
    Index vertex = defect.a;
    if (concernsFaces(defect.kind))
        vertex = defect.a < mesh.faceCount() ? mesh.triangles[defect.a].x : noIndex;
    return vertex < mesh.branch.size() ? mesh.branch[vertex] : noIndex;
}

} // namespace ramure
