/// \file
/// Takes the last folds out of a fork whose tubes run through each other whatever way it is built.
#pragma once

#include "core/surface/mesher/fork_check.h"
#include <glm/vec4.hpp>

namespace ramure {

class ForkUntangler
{
public:
    /// Moves vertices around the pairs of triangles that \p check finds to the middle of their neighbours, as
    /// far as that leaves fewer pairs. Triangles stay, and so do vertices before \p firstFree and those at
    /// the border of what is checked: the rings where tubes begin and end.
    void untangle(const ForkCheck& check, MeshSink& sink, Index firstFree);

private:
    struct Edge
    {
        Index from, to;
    };
    void prepare(const ForkCheck& check, const MeshSink& sink, Index firstFree);
    bool smooth(MeshSink& sink, const std::vector<Index>& tangled);

    Index m_first = 0; ///< vertex of the mesh: the fork's least
    std::vector<Edge> m_edges;
    std::vector<glm::dvec4> m_sum; ///< of the neighbours; w: how many
    std::vector<std::uint8_t> m_isFixed, m_state;
    std::vector<glm::vec3> m_best;
};

} // namespace ramure
