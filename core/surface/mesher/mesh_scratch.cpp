#include "core/surface/mesher/mesh_scratch.h"

#include "core/surface/mesher/branch_mesh.h"
#include <utility>

namespace ramure {

namespace {

constexpr std::size_t mostKeptBytes = std::size_t(128) << 20; ///< of one sink

} // namespace

std::unique_ptr<MeshSink> MeshScratch::takeSink()
{
    if (m_sinks.empty())
        return std::make_unique<MeshSink>();
    std::unique_ptr<MeshSink> sink = std::move(m_sinks.back());
    m_sinks.pop_back();
    sink->clear();
    return sink;
}

std::shared_ptr<const BranchMesh> MeshScratch::share(BranchMesh&& mesh)
{
    return {new BranchMesh(std::move(mesh)), [arrays = m_arrays](BranchMesh* done) mutable {
                arrays.keep(std::move(done->mesh));
                delete done;
            }};
}

void MeshScratch::keepSink(std::unique_ptr<MeshSink> sink)
{
    const std::size_t bytes = sink->positions.capacity() * sizeof(glm::vec3) +
                              sink->owner.capacity() * sizeof(Index) +
                              sink->triangles.capacity() * sizeof(glm::uvec3);
    if (bytes > mostKeptBytes) // of an uncommonly large mesh: the next one is hardly as large
        return;
    m_sinks.push_back(std::move(sink));
}

} // namespace ramure
