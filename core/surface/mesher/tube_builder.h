/// \file
/// Plain tubes: rings, the strips between them, and the caps of roots and tips.
#pragma once

#include "core/surface/mesher/branch_axis.h"
#include "core/surface/mesher/mesh_divisions.h"
#include "core/surface/mesher/mesh_sink.h"
#include "core/surface/mesher/trunk_foot.h"

namespace ramure {

/// What all parts of the mesher share.
struct MesherContext
{
    const NormalSkeleton& skeleton;
    const BranchMeshOptions& options;
    const MeshDivisions& divisions;
    MeshSink& sink;
    bool clampOvershoot = false; ///< for the tree at hand
};

/// A branch whose tube is in the mesh up to its last ring; its children are not.
struct TubeEnd
{
    Index branch = noIndex;
    Index ring = 0;      ///< first vertex of the last ring
    Index ringCount = 0; ///< its points
    AxisSection section;
};

/// Adds a ring of a section; returns its first vertex.
Index addRing(const AxisSection& section, std::span<const RingPoint> points, Index owner, MeshSink& sink);
/// Where a ring's point lies.
glm::dvec3 ringPosition(const AxisSection& section, const RingPoint& point);
/// May section k follow section \p last of the same tube, and does it leave room for the end? The end always
/// may. \param leastGap m, between two sections
bool keepsSection(const std::vector<AxisSection>& sections, std::size_t last, std::size_t k, double leastGap);
/// How far the second section's frame is turned, about its tangent, against the first one's carried straight
/// to it. Nothing for neighbours; where sections in between were left out, the way around them may have
/// turned the frame.
double twistBetween(const AxisSection& first, const AxisSection& second);
/// Plans the fork at the end of a branch with two children or more.
void planFork(const MesherContext& context, Index branch, const AxisSection& end, ForkPlanner& planner,
              ForkLayout& layout);

/// The ring a tube goes on from.
struct TubeStart
{
    Index ring;                        ///< first vertex
    std::span<const RingPoint> points; ///< a regular ring, or a foot's columns
    double turned = 0.0;               ///< of the points against the section's frame, rad
};

class TubeBuilder
{
public:
    explicit TubeBuilder(const MesherContext& context)
        : m_context(context)
    {
    }
    /// The flat end of a root; returns its ring's first vertex.
    Index startRoot(const AxisSection& section, std::span<const RingPoint> points, const glm::dvec3& pole,
                    Index owner);
    /// The rings of a trunk's foot, closed below; returns its highest ring's first vertex.
    Index startFoot(const TrunkFoot& foot, const Frame& frame, Index owner);
    /// Continues a tube from its section \p from, where \p start is its ring, up to its end. Tips are closed;
    /// other ends are appended to \p ends.
    void finish(Index branch, const std::vector<AxisSection>& sections, std::size_t from,
                const TubeStart& start, std::vector<TubeEnd>& ends);
    /// The ring at the end of a branch: split where it forks, regular elsewhere. Valid until the next call.
    std::span<const RingPoint> endRing(Index branch, const AxisSection& end);
    /// Closes or hands on a tube that has reached its end, a ring of \p count points.
    void end(Index branch, const AxisSection& section, Index ring, std::size_t count,
             std::vector<TubeEnd>& ends);

private:
    void closeFoot(const TrunkFoot& foot, Index pole);
    void closeCut(const AxisSection& section, Index ring, Index count, Index owner);
    void closeTorn(const AxisSection& section, Index ring, Index count, const MeshBranch& own);
    void evenStrip(Index lower, Index upper, Index count);
    void looseStrip(const TubeStart& lower, std::span<const RingPoint> upperPoints, Index upper);

    const MesherContext& m_context;
    ForkPlanner m_planner;
    ForkLayout m_layout;
};

} // namespace ramure
