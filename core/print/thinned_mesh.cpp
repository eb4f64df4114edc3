#include "core/print/thinned_mesh.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <OpenMesh/Tools/Decimater/Observer.hh>
#include <algorithm>

namespace ramure {
namespace {

struct Traits : OpenMesh::DefaultTraits
{
    VertexAttributes(OpenMesh::Attributes::Status);
    FaceAttributes(OpenMesh::Attributes::Status);
    EdgeAttributes(OpenMesh::Attributes::Status);
    HalfedgeAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::PrevHalfedge);
};

/// OpenMesh asks whether an edge may go more often than anything else, and looks its own flags up by name for
/// that: four fifths of the whole time, measured. Of a closed mesh less is to be asked.
struct Structure : OpenMesh::TriMesh_ArrayKernelT<Traits>
{
    /// The ends have two neighbours in common, those across the edge, which keep three or more faces.
    [[nodiscard]] bool is_collapse_ok(HalfedgeHandle edge) const // NOLINT(readability-identifier-naming)
    {
        const VertexHandle from = from_vertex_handle(edge), to = to_vertex_handle(edge);
        const VertexHandle left = to_vertex_handle(next_halfedge_handle(edge));
        const VertexHandle right = to_vertex_handle(next_halfedge_handle(opposite_halfedge_handle(edge)));
        if (left == right || valence(left) < 4 || valence(right) < 4)
            return false;
        int common = 0;
        for (auto a = cvv_iter(from); a.is_valid(); ++a)
            for (auto b = cvv_iter(to); b.is_valid(); ++b)
                common += *a == *b ? 1 : 0;
        return common == 2;
    }
};
using Decimater = OpenMesh::Decimater::DecimaterT<Structure>;

/// Squared distances times areas, of a grain of 1.
constexpr double usualLoss = 0.004;
constexpr float leastCosine = 0.5F; ///< of the angle that a triangle turns by in one collapse
constexpr float leastShape = 1e-3F; ///< twice the area of a triangle by the square of its longest edge

/// Quadrics, and after them what they do not see: triangles that turn over or lose their area.
class Collapses : public OpenMesh::Decimater::ModQuadricT<Structure>
{
public:
    using Base = OpenMesh::Decimater::ModQuadricT<Structure>;
    using Handle = OpenMesh::Decimater::ModHandleT<Collapses>;
    using Base::Base;

    float collapse_priority(const CollapseInfo& info) override // NOLINT(readability-identifier-naming)
    {
        const float loss = Base::collapse_priority(info);
        return loss < 0.0F || isGood(info) ? loss : float(Base::ILLEGAL_COLLAPSE);
    }

private:
    [[nodiscard]] bool isGood(const CollapseInfo& info)
    {
        const Structure& m = mesh();
        for (auto out = m.cvoh_iter(info.v0); out.is_valid(); ++out) {
            const auto second = m.to_vertex_handle(*out);
            const auto third = m.to_vertex_handle(m.next_halfedge_handle(*out));
            if (second == info.v1 || third == info.v1)
                continue; // goes with the edge
            const auto &b = m.point(second), &c = m.point(third);
            const auto way = b - info.p1, side = c - info.p1, last = c - b;
            const auto before = (b - info.p0) % (c - info.p0), after = way % side;
            const float longest = std::max({way.sqrnorm(), side.sqrnorm(), last.sqrnorm()});
            const float along = before | after;
            const float area = after.sqrnorm();
            if (!(area > leastShape * leastShape * longest * longest) ||
                !(along > 0.0F && along * along > leastCosine * leastCosine * area * before.sqrnorm()))
                return false;
        }
        return true;
    }
};

class Watcher : public OpenMesh::Decimater::Observer
{
public:
    Watcher(const Progress& progress, double collapses)
        : Observer(20'000)
        , m_progress(progress)
        , m_collapses(std::max(collapses, 1.0))
    {
    }
    void notify(std::size_t step) override { m_progress.report(std::min(1.0, double(step) / m_collapses)); }
    [[nodiscard]] bool abort() const override { return m_progress.cancelled(); }

private:
    const Progress& m_progress;
    double m_collapses;
};

bool fill(Structure& structure, const TriangleMesh& mesh, const ThinningOptions& options)
{
    structure.reserve(mesh.positions.size(), 3 * mesh.triangles.size() / 2, mesh.triangles.size());
    for (const glm::vec3& p : mesh.positions) {
        const glm::vec3 at = p / static_cast<float>(options.grain);
        structure.add_vertex({at.x, at.y, at.z});
    }
    const auto vertex = [](Index v) { return Structure::VertexHandle(static_cast<int>(v)); };
    for (const glm::uvec3& t : mesh.triangles)
        if (!structure.add_face(vertex(t.x), vertex(t.y), vertex(t.z)).is_valid())
            return false;
    for (Index v = 0; v < options.isKept.size(); ++v)
        structure.status(vertex(v)).set_locked(options.isKept[v]);
    return true;
}

TriangleMesh remaining(const Structure& structure, const TriangleMesh& mesh)
{
    TriangleMesh out;
    std::vector<Index> numberOf(mesh.positions.size(), noIndex);
    for (Index v = 0; v < mesh.vertexCount(); ++v) {
        const Structure::VertexHandle handle(static_cast<int>(v));
        if (structure.status(handle).deleted() || structure.is_isolated(handle))
            continue;
        numberOf[v] = out.vertexCount();
        out.positions.push_back(mesh.positions[v]);
    }
    for (const auto face : structure.faces()) {
        glm::uvec3 t(0);
        int k = 0;
        for (const auto corner : structure.fv_range(face))
            t[k++] = numberOf[static_cast<std::size_t>(corner.idx())];
        out.triangles.push_back(t);
    }
    return out;
}

} // namespace

Expected<TriangleMesh> thinnedMesh(const TriangleMesh& mesh, const ThinningOptions& options,
                                   const Progress& progress)
{
    if (mesh.empty() || !(options.grain > 0.0))
        return fail(ErrorCode::Invalid, RAMURE_NOOP("nothing is left to print"));
    Structure structure;
    if (!fill(structure, mesh, options))
        return fail(ErrorCode::Invalid,
                    RAMURE_NOOP("a mesh that is no closed surface cannot be thinned out"));
    Decimater decimater(structure);
    Collapses::Handle collapses;
    decimater.add(collapses);
    decimater.module(collapses).set_max_err(usualLoss, false);
    if (!decimater.initialize())
        return fail(ErrorCode::Invalid,
                    RAMURE_NOOP("a mesh that is no closed surface cannot be thinned out"));
    Watcher watcher(progress, 0.4 * double(mesh.triangles.size()));
    decimater.set_observer(&watcher);
    // What costs nothing first; then, where that does not do, what costs least. A collapse takes two faces.
    const std::size_t left = mesh.triangles.size() - 2 * decimater.decimate();
    if (left > options.mostTriangles && !progress.cancelled()) {
        decimater.module(collapses).unset_max_err();
        decimater.decimate((left - options.mostTriangles + 1) / 2);
    }
    if (progress.cancelled())
        return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
    return remaining(structure, mesh);
}

} // namespace ramure
