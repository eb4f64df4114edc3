#include "core/print/thinned_mesh.h"

#include "core/base/parallel.h"
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <OpenMesh/Tools/Decimater/Observer.hh>
#include <algorithm>
#include <atomic>
#include <cstdint>
#include <glm/common.hpp>
#include <limits>
#include <thread>

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
        // One that stays has faces which are not here: what else it is a neighbour of is not known.
        if (status(to).locked() || left == right)
            return false;
        Neighbours ofFrom, ofTo;
        if (!hasFour(left) || !hasFour(right) || !ofFrom.collect(*this, from) || !ofTo.collect(*this, to))
            return false;
        int common = 0;
        for (int i = 0; i < ofFrom.count; ++i)
            common += static_cast<int>(std::count(ofTo.all, ofTo.all + ofTo.count, ofFrom.all[i]));
        return common == 2;
    }
    /// Asked for between left and right, where both have three faces: these were refused above.
    [[nodiscard]] HalfedgeHandle find_halfedge(VertexHandle, VertexHandle) const // NOLINT
    {
        return HalfedgeHandle();
    }

private:
    [[nodiscard]] bool hasFour(VertexHandle vertex) const
    {
        const HalfedgeHandle first = halfedge_handle(vertex);
        HalfedgeHandle at = first;
        for (int i = 0; i < 3; ++i) {
            at = next_halfedge_handle(opposite_halfedge_handle(at));
            if (at == first)
                return false;
        }
        return true;
    }

    struct Neighbours
    {
        static constexpr int most = 80; // of more, none is taken
        int all[most];
        int count = 0;

        bool collect(const Structure& mesh, VertexHandle of)
        {
            count = 0;
            const HalfedgeHandle first = mesh.halfedge_handle(of);
            HalfedgeHandle at = first;
            do {
                if (count == most)
                    return false;
                all[count++] = mesh.to_vertex_handle(at).idx();
                at = mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(at));
            } while (at != first);
            return true;
        }
    };
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

/// Told only on the thread that the whole was called on.
class Watcher : public OpenMesh::Decimater::Observer
{
public:
    static constexpr std::size_t interval = 5'000;

    Watcher(const Progress& progress, std::atomic<std::size_t>& done, double collapses)
        : Observer(interval)
        , m_progress(progress)
        , m_done(done)
        , m_collapses(std::max(collapses, 1.0))
    {
    }
    void notify(std::size_t) override
    {
        const std::size_t done = m_done += interval;
        if (std::this_thread::get_id() == m_thread)
            m_progress.report(std::min(1.0, double(done) / m_collapses));
    }
    [[nodiscard]] bool abort() const override { return m_progress.cancelled(); }
    /// \pre on the caller's thread
    void setThread(std::thread::id thread) { m_thread = thread; }

private:
    const Progress& m_progress;
    std::atomic<std::size_t>& m_done;
    double m_collapses;
    std::thread::id m_thread;
};

using Triangles = std::vector<glm::uvec3>;

/// Some faces of a mesh. Vertices that other faces share stay, so that the parts still fit.
struct Part
{
    Triangles triangles;     ///< of the mesh's vertices
    Index mostTriangles = 0; ///< 0: only what costs nothing goes
};

/// What is thinned out, and what all parts have in common.
struct Whole
{
    const TriangleMesh& mesh;
    const ThinningOptions& options;
    std::vector<std::uint8_t> parts; ///< by vertex: 1 in one part, 2 in several
    const Progress& progress;
    std::thread::id caller = std::this_thread::get_id();
    std::atomic<std::size_t> collapses{0};
};

/// Parts are in order of their faces' place along the longest side of the mesh.
std::vector<Part> partsOf(const TriangleMesh& mesh, const Triangles& triangles, double shift)
{
    constexpr std::size_t usual = 16, leastFaces = 20'000;
    glm::vec3 low(std::numeric_limits<float>::infinity()), high(-low);
    for (const glm::vec3& p : mesh.positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const glm::vec3 size = high - low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    std::vector<std::pair<float, Index>> order;
    order.reserve(triangles.size());
    for (Index i = 0; i < triangles.size(); ++i)
        order.emplace_back(mesh.positions[triangles[i].x][axis], i);
    std::sort(order.begin(), order.end());
    const std::size_t count = std::clamp<std::size_t>(triangles.size() / leastFaces, 1, usual);
    std::vector<Part> parts(count + (count > 1 && shift > 0.0 ? 1 : 0));
    for (std::size_t i = 0; i < order.size(); ++i) {
        const double place = double(i) / double(order.size()) * double(count) + (count > 1 ? shift : 0.0);
        parts[std::min(parts.size() - 1, static_cast<std::size_t>(place))].triangles.push_back(
            triangles[order[i].second]);
    }
    return parts;
}

void markShared(Whole& whole, const std::vector<Part>& parts)
{
    std::vector<Index> last(whole.mesh.positions.size(), noIndex);
    whole.parts.assign(last.size(), 0);
    for (Index number = 0; number < parts.size(); ++number)
        for (const glm::uvec3& t : parts[number].triangles)
            for (int k = 0; k < 3; ++k)
                if (last[t[k]] != number) {
                    last[t[k]] = number;
                    whole.parts[t[k]] = static_cast<std::uint8_t>(std::min(2, whole.parts[t[k]] + 1));
                }
}

/// \param vertices of the mesh, by those of the structure
bool fill(Structure& structure, const Part& part, const Whole& whole, std::vector<Index>& vertices)
{
    const auto vertex = [](Index v) { return Structure::VertexHandle(static_cast<int>(v)); };
    std::vector<Index> used;
    used.reserve(3 * part.triangles.size());
    for (const glm::uvec3& t : part.triangles)
        used.insert(used.end(), {t.x, t.y, t.z});
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    vertices = std::move(used);
    structure.reserve(vertices.size(), 3 * part.triangles.size() / 2, part.triangles.size());
    const auto& isKept = whole.options.isKept;
    for (Index i = 0; i < vertices.size(); ++i) {
        const glm::vec3 at = whole.mesh.positions[vertices[i]] / static_cast<float>(whole.options.grain);
        structure.add_vertex({at.x, at.y, at.z});
        const bool stays = whole.parts[vertices[i]] > 1 || (!isKept.empty() && isKept[vertices[i]]);
        structure.status(vertex(i)).set_locked(stays);
    }
    const auto numberOf = [&vertices](Index v) {
        return static_cast<Index>(std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin());
    };
    for (const glm::uvec3& t : part.triangles)
        if (!structure.add_face(vertex(numberOf(t.x)), vertex(numberOf(t.y)), vertex(numberOf(t.z)))
                 .is_valid())
            return false;
    return true;
}

Triangles remaining(const Structure& structure, const std::vector<Index>& vertices)
{
    Triangles out;
    for (const auto face : structure.faces()) {
        glm::uvec3 t(0);
        int k = 0;
        for (const auto corner : structure.fv_range(face))
            t[k++] = vertices[static_cast<std::size_t>(corner.idx())];
        out.push_back(t);
    }
    return out;
}

/// False where the part is no surface.
bool thin(Part& part, Whole& whole)
{
    Structure structure;
    std::vector<Index> vertices;
    if (part.triangles.empty())
        return true;
    if (!fill(structure, part, whole, vertices))
        return false;
    Decimater decimater(structure);
    Collapses::Handle collapses;
    decimater.add(collapses);
    decimater.module(collapses).set_max_err(usualLoss, false);
    if (!decimater.initialize())
        return false;
    Watcher watcher(whole.progress, whole.collapses, 0.4 * double(whole.mesh.triangles.size()));
    watcher.setThread(whole.caller);
    decimater.set_observer(&watcher);
    if (part.mostTriangles == 0) {
        decimater.decimate();
    } else if (part.triangles.size() > part.mostTriangles) {
        decimater.module(collapses).unset_max_err(); // what costs least; a collapse takes two faces
        decimater.decimate((part.triangles.size() - part.mostTriangles + 1) / 2);
    }
    part.triangles = remaining(structure, vertices);
    return true;
}

/// All faces, in parts side by side. \param most 0: only what costs nothing goes
bool thinAll(Whole& whole, Triangles& triangles, double shift, Index most)
{
    std::vector<Part> parts = partsOf(whole.mesh, triangles, shift);
    if (most > 0) // of each its share; a few are left for what is rounded up
        for (Part& part : parts)
            part.mostTriangles =
                std::max<Index>(4, static_cast<Index>(double(part.triangles.size()) * double(most) /
                                                      double(triangles.size())) -
                                       2);
    markShared(whole, parts);
    std::vector<std::uint8_t> isGood(parts.size(), 0);
    parallelFor(parts.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            isGood[i] = whole.progress.cancelled() || thin(parts[i], whole) ? 1 : 0;
    });
    triangles.clear();
    for (const Part& part : parts)
        triangles.insert(triangles.end(), part.triangles.begin(), part.triangles.end());
    return std::all_of(isGood.begin(), isGood.end(), [](std::uint8_t good) { return good != 0; });
}

TriangleMesh usedPart(const TriangleMesh& mesh, Triangles&& triangles)
{
    TriangleMesh out;
    std::vector<Index> numberOf(mesh.positions.size(), noIndex);
    for (const glm::uvec3& t : triangles)
        for (int k = 0; k < 3; ++k)
            numberOf[t[k]] = 0;
    for (Index v = 0; v < mesh.vertexCount(); ++v)
        if (numberOf[v] != noIndex) {
            numberOf[v] = out.vertexCount();
            out.positions.push_back(mesh.positions[v]);
        }
    out.triangles = std::move(triangles);
    for (glm::uvec3& t : out.triangles)
        t = {numberOf[t.x], numberOf[t.y], numberOf[t.z]};
    return out;
}

} // namespace

Expected<TriangleMesh> thinnedMesh(const TriangleMesh& mesh, const ThinningOptions& options,
                                   const Progress& progress)
{
    if (mesh.empty() || !(options.grain > 0.0))
        return fail(ErrorCode::Invalid, RAMURE_NOOP("nothing is left to print"));
    const auto noSurface = [] {
        return fail(ErrorCode::Invalid,
                    RAMURE_NOOP("a mesh that is no closed surface cannot be thinned out"));
    };
    Whole whole{mesh, options, {}, progress};
    Triangles triangles = mesh.triangles;
    // What costs nothing first, and again across the seams; then, where that does not do, what costs least.
    if (!options.isThin && !thinAll(whole, triangles, 0.0, 0))
        return noSurface();
    if (!options.isThin && partsOf(mesh, triangles, 0.0).size() > 1 && !thinAll(whole, triangles, 0.5, 0))
        return noSurface();
    const Index most = options.mostTriangles;
    for (const double shift : {0.25, 0.75, 0.0, 0.5}) {
        if (most == 0 || triangles.size() <= most || progress.cancelled())
            break;
        if (!thinAll(whole, triangles, shift, most))
            return noSurface();
    }
    if (progress.cancelled())
        return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
    return usedPart(mesh, std::move(triangles));
}

} // namespace ramure
