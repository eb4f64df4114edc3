/// \file
/// Do the tubes of one fork run through each other? Exact, and asked only where a strip is folded.
#pragma once

#include "core/surface/mesher/strip_patch.h"

namespace ramure {

class ForkCheck
{
public:
    void begin();
    /// A strip of the fork, its triangles in the sink from \p first on.
    void add(const StripPatch& strip, const MeshSink& sink, std::size_t first);
    /// What is in the sink from \p first on: the bands between the complete rings above.
    void addBands(const MeshSink& sink, std::size_t first);
    /// Is a strip folded, or a band? Only then it is worth to count.
    [[nodiscard]] bool isFolded() const { return m_isFolded; }
    [[nodiscard]] std::size_t faceCount() const { return m_faces.size(); }
    [[nodiscard]] const std::vector<Index>& faces() const { return m_faces; }
    /// Appends both triangles of each pair that runs through each other. Stops at \p most pairs (at least 1).
    void find(const MeshSink& sink, std::size_t most, std::vector<Index>& faces) const;
    /// How many pairs of the strips' triangles run through each other. Stops counting at \p most. Triangles
    /// without an area are left out.
    [[nodiscard]] std::size_t count(const MeshSink& sink, std::size_t most) const;

private:
    template <class Take> void visit(const MeshSink& sink, const Take& take) const;
    [[nodiscard]] bool meet(const MeshSink& sink, Index i, Index j) const;

    std::vector<Index> m_faces;
    std::vector<glm::vec3> m_normals; ///< of those
    bool m_isFolded = false;
};

} // namespace ramure
