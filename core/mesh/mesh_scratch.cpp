#include "core/mesh/mesh_scratch.h"

#include "core/mesh/branch_mesh.h"
#include <mutex>
#include <utility>

namespace ramure {

namespace {

constexpr std::size_t mostKeptBytes = std::size_t(128) << 20; ///< of one sink, and of one mesh's arrays

template <class... T> std::size_t bytesOf(const std::vector<T>&... arrays)
{
    return (... + (arrays.capacity() * sizeof(T)));
}

} // namespace

struct MeshScratch::Arrays
{
    void keep(TriangleMesh&& from)
    {
        TriangleMesh kept; // the arrays that the mesher fills, no others
        kept.positions = std::move(from.positions);
        kept.normals = std::move(from.normals);
        kept.triangles = std::move(from.triangles);
        kept.branch = std::move(from.branch);
        kept.level = std::move(from.level);
        if (bytesOf(kept.positions, kept.normals, kept.triangles, kept.branch, kept.level) > mostKeptBytes)
            return;
        const std::scoped_lock lock(mutex);
        if (kept.triangles.capacity() >= mesh.triangles.capacity())
            std::swap(mesh, kept);
    }

    std::mutex mutex;
    TriangleMesh mesh;
};

MeshScratch::MeshScratch()
    : m_arrays(std::make_shared<Arrays>())
{
}

std::unique_ptr<MeshSink> MeshScratch::takeSink()
{
    if (m_sinks.empty())
        return std::make_unique<MeshSink>();
    std::unique_ptr<MeshSink> sink = std::move(m_sinks.back());
    m_sinks.pop_back();
    sink->clear();
    return sink;
}

TriangleMesh MeshScratch::takeArrays()
{
    const std::scoped_lock lock(m_arrays->mutex);
    return std::exchange(m_arrays->mesh, {});
}

void MeshScratch::keepArrays(TriangleMesh&& mesh)
{
    m_arrays->keep(std::move(mesh));
}

std::shared_ptr<const BranchMesh> MeshScratch::share(BranchMesh&& mesh)
{
    return {new BranchMesh(std::move(mesh)), [arrays = m_arrays](BranchMesh* done) {
                arrays->keep(std::move(done->mesh));
                delete done;
            }};
}

void MeshScratch::keepSink(std::unique_ptr<MeshSink> sink)
{
    if (bytesOf(sink->positions, sink->owner, sink->triangles) >
        mostKeptBytes) // of an uncommonly large mesh: the next one is hardly as large
        return;
    m_sinks.push_back(std::move(sink));
}

} // namespace ramure
