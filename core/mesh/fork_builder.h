/// \file
/// One fork: its walls, and every child's tube up to the first cross-section that is complete.
#pragma once

#include "core/mesh/cell_unroll.h"
#include "core/mesh/fork_walls.h"
#include "core/mesh/strip_patch.h"

namespace ramure {

/// Where a tube stands: the last cross-section that is in the mesh.
struct TubeStart
{
    Index branch = noIndex;
    Frame frame;           ///< the parent's end frame, before the branch's own roll
    Index firstVertex = 0; ///< of the ring
    Index section = 0;     ///< 0: the parent's end ring (or a root's first)
};

/// What all parts of the mesher share.
struct MesherContext
{
    const NormalSkeleton& skeleton;
    const BranchMeshOptions& options;
    MeshSink& sink;
};

/// Azimuth of point k of a regular ring.
double regularAzimuth(Index k, int radialDivisions);
/// Adds a ring of the section's radius; \p azimuths are in the section's frame. Returns its first vertex.
Index addRing(const AxisSection& section, std::span<const double> azimuths, Index owner, MeshSink& sink);
/// May section k follow section \p last of the same tube, and does it leave room for the end? The end always
/// may.
bool keepsSection(const std::vector<AxisSection>& sections, std::size_t last, std::size_t k);

/// Plans the ring at the end of a branch: split by its fork, or regular.
class EndPlanner
{
public:
    /// \param end the branch's last section. \returns true where the branch ends in a fork; then layout()
    /// holds it.
    bool plan(const MesherContext& context, Index branch, const AxisSection& end);
    [[nodiscard]] const ForkLayout& layout() const { return m_layout; }
    [[nodiscard]] const std::vector<double>& azimuths() const { return m_azimuths; }

private:
    ForkPlanner m_planner;
    ForkLayout m_layout;
    std::vector<double> m_azimuths;
    std::vector<glm::dvec3> m_directions;
};

class ForkBuilder
{
public:
    explicit ForkBuilder(const MesherContext& context)
        : m_context(context)
    {
    }
    /// \param branch its end ring is in the mesh, from \p firstVertex on, at the azimuths of \p layout around
    /// \p end. \param starts gets one entry per child, in order.
    void build(Index branch, const AxisSection& end, const ForkLayout& layout, Index firstVertex,
               std::vector<TubeStart>& starts);

private:
    TubeStart startTube(Index child, const Frame& frame);
    void insertPartialRings(Index child, std::size_t full);
    [[nodiscard]] bool isFree(Index child, const glm::dvec3& point, double along) const;

    const MesherContext& m_context;
    AxisBuilder m_axes;
    EndPlanner m_ends;
    ForkWalls m_walls;
    ForkRing m_ring;
    CellUnroller m_unroller;
    StripPatch m_patch;
    std::vector<ForkChild> m_children; ///< never shrinks: the first m_count are in use
    std::size_t m_count = 0;
    std::vector<CellVertex> m_boundary;
    std::vector<UnrolledVertex> m_front, m_upper;
};

} // namespace ramure
