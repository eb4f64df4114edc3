#include "core/surface/mesh/largest_index.h"
#include "core/surface/proof/validate_parts.h"

namespace ramure::validation {

namespace {

/// Faces of each lane between two looks at the stop token.
constexpr std::size_t facesAtATime = std::size_t(1) << 12;
/// Faces that follow each other share vertices: what is written for one must arrive before the next can go
/// on. Faces from distant places, taken in turns, do not wait for each other.
constexpr std::size_t laneCount = 4;

/// Calls \p use(face) once for all faces without a repeated vertex, and before that \p accept(faces) for some
/// of them at a time, which stay in the cache; false where that says so, and where cancelled.
template <class Accept, class Use>
bool forFaces(const TriangleMesh& mesh, const Progress& progress, Accept&& accept, Use&& use)
{
    const auto take = [&use](const glm::uvec3* face) {
        const glm::uvec3 t = *face; // a copy: use() writes indices
        if (!hasRepeatedVertex(t))
            use(t);
    };
    const glm::uvec3* const faces = mesh.triangles.data();
    const std::size_t lane = mesh.triangles.size() / laneCount;
    for (std::size_t begin = 0; begin < lane; begin += facesAtATime) {
        if (progress.cancelled())
            return false;
        const std::size_t end = std::min(lane, begin + facesAtATime);
        for (std::size_t k = 0; k < laneCount; ++k)
            if (!accept(std::span(faces + k * lane + begin, end - begin)))
                return false;
        for (std::size_t i = begin; i < end; ++i)
            for (std::size_t k = 0; k < laneCount; ++k)
                take(faces + k * lane + i);
        progress.report(double(begin) / double(lane));
    }
    const std::size_t inLanes = laneCount * lane;
    if (!accept(std::span(mesh.triangles).subspan(inLanes)))
        return false;
    for (std::size_t i = inLanes; i < mesh.triangles.size(); ++i)
        take(faces + i);
    return true;
}

} // namespace

// Counting sort: how many corners each vertex has, where they begin, and then the corners. What it writes
// lies as close together as the faces do.
Expected<Corners> collectCorners(const TriangleMesh& mesh, const Progress& progress)
{
    const Index vertices = mesh.vertexCount();
    Corners out;
    out.end = LargeBuffer<Index>(vertices);
    Index* const at = out.end.data();
    std::fill_n(at, vertices, 0u);
    const auto exist = [vertices](std::span<const glm::uvec3> faces) {
        return faces.empty() || largestIndex(faces) < vertices;
    };
    const auto stopped = [&mesh] {
        const auto indices = checkIndices(mesh);
        return indices ? fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled")) : fail(indices.error());
    };
    const auto count = [at](glm::uvec3 t) {
        ++at[t.x];
        ++at[t.y];
        ++at[t.z];
    };
    if (!forFaces(mesh, progress.part(0.0, 0.3), exist, count))
        return stopped();
    Index corners = 0;
    for (Index v = 0; v < vertices; ++v) {
        const Index degree = at[v];
        at[v] = corners;
        corners += degree;
    }
    out.faces = corners / 3;
    out.at = LargeBuffer<Corner>(std::size_t(corners) + nearDegree);
    std::fill_n(out.at.data() + corners, nearDegree, Corner{noIndex, noIndex});
    const auto put = [at, to = out.at.data()](glm::uvec3 t) {
        to[at[t.x]++] = {t.y, t.z};
        to[at[t.y]++] = {t.z, t.x};
        to[at[t.z]++] = {t.x, t.y};
    };
    const auto known = [](std::span<const glm::uvec3>) { return true; };
    if (!forFaces(mesh, progress.part(0.3, 1.0), known, put))
        return stopped();
    return out;
}

} // namespace ramure::validation
