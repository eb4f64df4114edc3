/// \file
/// Memory that the mesher keeps from one mesh to the next: the first touch of fresh pages costs more than
/// writing a mesh into used ones.
#pragma once

#include "core/mesh/mesh_sink.h"
#include <memory>
#include <vector>

namespace ramure {

struct BranchMesh;

/// One per thread that builds meshes; only what share() gives may end on another. What it holds is of no
/// meaning between two meshes.
class MeshScratch
{
public:
    MeshScratch();
    /// An empty sink, with memory where one was kept.
    std::unique_ptr<MeshSink> takeSink();
    void keepSink(std::unique_ptr<MeshSink> sink);
    /// The arrays of a mesh that nobody needs any more, or none; whatever size they have.
    TriangleMesh takeArrays();
    void keepArrays(TriangleMesh&& mesh);
    /// A mesh that gives its arrays back when nobody needs it any more, on whatever thread that is, even when
    /// this is gone.
    std::shared_ptr<const BranchMesh> share(BranchMesh&& mesh);

private:
    struct Arrays;
    std::vector<std::unique_ptr<MeshSink>> m_sinks;
    std::shared_ptr<Arrays> m_arrays;
};

} // namespace ramure
