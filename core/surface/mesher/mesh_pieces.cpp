#include "core/surface/mesher/mesh_pieces.h"

#include "core/base/large_buffer.h"
#include "core/base/parallel.h"
#include <algorithm>

namespace ramure {

namespace {

SinkMark operator+(const SinkMark& a, const SinkMark& b)
{
    return {a.vertices + b.vertices, a.triangles + b.triangles, a.tubes + b.tubes,
            a.forkVertices + b.forkVertices, a.small + b.small};
}

SinkMark operator-(const SinkMark& a, const SinkMark& b)
{
    return {a.vertices - b.vertices, a.triangles - b.triangles, a.tubes - b.tubes,
            a.forkVertices - b.forkVertices, a.small - b.small};
}

/// What a task adds: not the copies of a ring that is there already.
SinkMark sizeOf(const MeshTask& task)
{
    SinkMark size = task.to - task.from;
    size.vertices -= task.end.branch == noIndex ? 0 : task.end.ringCount;
    return size;
}

template <class T> void makeRoom(std::vector<T>& array, std::size_t count)
{
    reserveHuge(array, count);
    array.resize(count);
}

/// Ranges of sinks, renumbered while they are copied to their places.
class Assembly
{
public:
    Assembly(const MeshSink& trunk, const std::vector<Index>& smallOfTrunk,
             const std::vector<MeshTask>& tasks, BranchMesh& mesh)
        : m_trunk(trunk)
        , m_smallOfTrunk(smallOfTrunk)
        , m_tasks(tasks)
        , m_mesh(mesh)
        , m_end{trunk.positions.size(), trunk.triangles.size(), trunk.tubes.size(), trunk.forkVertices.size(),
                smallOfTrunk.size()}
    {
    }
    std::vector<Index> run();

private:
    /// Where the trunk's segment before a task ends; after the last task, its end.
    [[nodiscard]] const SinkMark& cut(std::size_t i) const
    {
        return i < m_tasks.size() ? m_tasks[i].trunk : m_end;
    }
    void copySegment(std::size_t i);
    void copyTask(std::size_t i);
    template <class Map>
    void copy(const MeshSink& sink, const SinkMark& from, const SinkMark& to, const SinkMark& target,
              const Map& vertexOf);

    const MeshSink& m_trunk;
    const std::vector<Index>& m_smallOfTrunk;
    const std::vector<MeshTask>& m_tasks;
    BranchMesh& m_mesh;
    const SinkMark m_end;
    std::vector<SinkMark> m_shift; ///< per task: all that the tasks before it add; one more for the end
    std::vector<Index> m_place;    ///< per vertex of the trunk: its final number
    std::vector<Index> m_small;
};

template <class Map>
void Assembly::copy(const MeshSink& sink, const SinkMark& from, const SinkMark& to, const SinkMark& target,
                    const Map& vertexOf)
{
    const auto range = [](const auto& list, std::size_t first, std::size_t last, auto& into, std::size_t at) {
        std::copy(list.data() + first, list.data() + last, into.data() + at);
    };
    range(sink.positions, from.vertices, to.vertices, m_mesh.mesh.positions, target.vertices);
    range(sink.owner, from.vertices, to.vertices, m_mesh.mesh.branch, target.vertices);
    glm::uvec3* out = m_mesh.mesh.triangles.data() + target.triangles;
    for (std::size_t t = from.triangles; t < to.triangles; ++t) {
        const glm::uvec3& triangle = sink.triangles[t];
        *out++ = {vertexOf(triangle.x), vertexOf(triangle.y), vertexOf(triangle.z)};
    }
    range(sink.axes, from.tubes, to.tubes, m_mesh.axes, target.tubes);
    const auto triangles = static_cast<Index>(target.triangles - from.triangles);
    for (std::size_t t = from.tubes; t < to.tubes; ++t) {
        TubeRange& tube = m_mesh.tubes[target.tubes + t - from.tubes] = sink.tubes[t];
        tube.firstTriangle += triangles;
    }
    for (std::size_t f = from.forkVertices; f < to.forkVertices; ++f) {
        ForkVertex& fork = m_mesh.forkVertices[target.forkVertices + f - from.forkVertices] =
            sink.forkVertices[f];
        fork.vertex = vertexOf(fork.vertex);
    }
}

void Assembly::copySegment(std::size_t i)
{
    const SinkMark from = i > 0 ? m_tasks[i - 1].trunk : SinkMark{}, to = cut(i);
    const SinkMark target = from + m_shift[i];
    copy(m_trunk, from, to, target, [&](Index vertex) { return m_place[vertex]; });
    for (std::size_t s = from.small; s < to.small; ++s)
        m_small[target.small + s - from.small] = m_smallOfTrunk[s] + static_cast<Index>(m_shift[i].triangles);
}

void Assembly::copyTask(std::size_t i)
{
    const MeshTask& task = m_tasks[i];
    const SinkMark target = task.trunk + m_shift[i];
    SinkMark from = task.from;
    const Index ring = task.end.branch == noIndex ? 0 : m_place[task.end.ring];
    from.vertices += task.end.branch == noIndex ? 0 : task.end.ringCount;
    const auto copies = static_cast<Index>(task.from.vertices), own = static_cast<Index>(from.vertices);
    const Index toRing = ring - copies, toOwn = static_cast<Index>(target.vertices) - own;
    copy(*task.sink, from, task.to, target,
         [=](Index vertex) { return vertex + (vertex < own ? toRing : toOwn); });
    for (std::size_t s = 0; s < task.small.size(); ++s)
        m_small[target.small + s] =
            task.small[s] - static_cast<Index>(from.triangles) + static_cast<Index>(target.triangles);
}

std::vector<Index> Assembly::run()
{
    m_shift.resize(m_tasks.size() + 1);
    for (std::size_t i = 0; i < m_tasks.size(); ++i)
        m_shift[i + 1] = m_shift[i] + sizeOf(m_tasks[i]);
    m_place.resize(m_end.vertices);
    for (std::size_t i = 0, vertex = 0; i <= m_tasks.size(); ++i)
        for (; vertex < cut(i).vertices; ++vertex)
            m_place[vertex] = static_cast<Index>(vertex + m_shift[i].vertices);

    const SinkMark total = m_end + m_shift.back();
    makeRoom(m_mesh.mesh.positions, total.vertices);
    makeRoom(m_mesh.mesh.branch, total.vertices);
    makeRoom(m_mesh.mesh.triangles, total.triangles);
    m_mesh.tubes.resize(total.tubes);
    m_mesh.axes.resize(total.tubes);
    m_mesh.forkVertices.resize(total.forkVertices);
    m_small.resize(total.small);
    parallelFor(2 * m_tasks.size() + 1, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            i % 2 == 0 ? copySegment(i / 2) : copyTask(i / 2);
    });
    return std::move(m_small);
}

} // namespace

std::vector<Index> assemblePieces(const MeshSink& trunk, const std::vector<Index>& smallOfTrunk,
                                  const std::vector<MeshTask>& tasks, BranchMesh& mesh)
{
    return Assembly(trunk, smallOfTrunk, tasks, mesh).run();
}

} // namespace ramure
