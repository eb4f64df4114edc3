/// \file
/// Memory that the mesher keeps from one mesh to the next: the first touch of fresh pages costs more than
/// writing a mesh into used ones.
#pragma once

#include "core/mesh/mesh_sink.h"
#include <memory>
#include <utility>
#include <vector>

namespace ramure {

/// Not thread-safe: one per thread that builds meshes. What it holds is of no meaning between two meshes.
class MeshScratch
{
public:
    /// An empty sink, with memory where one was kept.
    std::unique_ptr<MeshSink> takeSink();
    void keepSink(std::unique_ptr<MeshSink> sink);
    /// The arrays of a mesh that nobody needs any more, or none; whatever size they have.
    TriangleMesh takeArrays() { return std::exchange(m_arrays, {}); }
    void keepArrays(TriangleMesh&& mesh);

private:
    std::vector<std::unique_ptr<MeshSink>> m_sinks;
    TriangleMesh m_arrays;
};

} // namespace ramure
