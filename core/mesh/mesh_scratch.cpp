#include "core/mesh/mesh_scratch.h"

namespace ramure {

std::unique_ptr<MeshSink> MeshScratch::takeSink()
{
    if (m_sinks.empty())
        return std::make_unique<MeshSink>();
    std::unique_ptr<MeshSink> sink = std::move(m_sinks.back());
    m_sinks.pop_back();
    sink->clear();
    return sink;
}

void MeshScratch::keepArrays(TriangleMesh&& mesh)
{
    m_arrays.positions = std::move(mesh.positions); // those that the mesher fills, no others
    m_arrays.normals = std::move(mesh.normals);
    m_arrays.triangles = std::move(mesh.triangles);
    m_arrays.branch = std::move(mesh.branch);
    m_arrays.level = std::move(mesh.level);
}

void MeshScratch::keepSink(std::unique_ptr<MeshSink> sink)
{
    m_sinks.push_back(std::move(sink));
}

} // namespace ramure
