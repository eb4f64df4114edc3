#include "core/print/thinned_mesh.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <OpenMesh/Tools/Decimater/Observer.hh>
#include <algorithm>

namespace ramure {
namespace {

struct Traits : OpenMesh::DefaultTraits
{
    VertexAttributes(OpenMesh::Attributes::Status);
    FaceAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Normal);
    EdgeAttributes(OpenMesh::Attributes::Status);
    HalfedgeAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::PrevHalfedge);
};
using Structure = OpenMesh::TriMesh_ArrayKernelT<Traits>;
using Decimater = OpenMesh::Decimater::DecimaterT<Structure>;

/// Squared distances times areas, of a grain of 1.
constexpr double usualLoss = 0.004;
constexpr float mostTurn = 60.0F; ///< degrees that a triangle may turn by in one collapse

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
    structure.update_face_normals();
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
    Structure structure;
    if (!fill(structure, mesh, options))
        return fail(ErrorCode::Invalid,
                    RAMURE_NOOP("a mesh that is no closed surface cannot be thinned out"));
    Decimater decimater(structure);
    OpenMesh::Decimater::ModQuadricT<Structure>::Handle quadric;
    OpenMesh::Decimater::ModNormalFlippingT<Structure>::Handle flips;
    decimater.add(quadric);
    decimater.add(flips);
    decimater.module(quadric).set_max_err(usualLoss, false);
    decimater.module(flips).set_max_normal_deviation(mostTurn);
    if (!decimater.initialize())
        return fail(ErrorCode::Invalid,
                    RAMURE_NOOP("a mesh that is no closed surface cannot be thinned out"));
    Watcher watcher(progress, 0.4 * double(mesh.triangles.size()));
    decimater.set_observer(&watcher);
    // What costs nothing first; then, where that does not do, what costs least. A collapse takes two faces.
    const std::size_t left = mesh.triangles.size() - 2 * decimater.decimate();
    if (left > options.mostTriangles && !progress.cancelled()) {
        decimater.module(quadric).unset_max_err();
        decimater.decimate((left - options.mostTriangles + 1) / 2);
    }
    if (progress.cancelled())
        return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
    return remaining(structure, mesh);
}

} // namespace ramure
