/// \file
/// Memory that the mesher keeps from one mesh to the next: the first touch of fresh pages costs more than
/// writing a mesh into used ones.
#pragma once

#include "core/surface/mesh/mesh_arrays.h"
#include "core/surface/mesher/mesh_sink.h"
#include <memory>
#include <vector>

namespace ramure {

struct BranchMesh;

/// One per thread that builds meshes; only what share() gives may end on another. What it holds is of no
/// meaning between two meshes.
class MeshScratch
{
public:
    /// An empty sink, with memory where one was kept.
    std::unique_ptr<MeshSink> takeSink();
    void keepSink(std::unique_ptr<MeshSink> sink);
    /// See MeshArrays.
    TriangleMesh takeArrays() { return m_arrays.take(); }
    void keepArrays(TriangleMesh&& mesh) { m_arrays.keep(std::move(mesh)); }
    std::shared_ptr<const BranchMesh> share(BranchMesh&& mesh);

private:
    std::vector<std::unique_ptr<MeshSink>> m_sinks;
    MeshArrays m_arrays;
};

} // namespace ramure
