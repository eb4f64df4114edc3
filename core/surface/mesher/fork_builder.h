/// \file
/// One fork: its walls, and every child's tube, the first complete cross-section of which closes the fork.
#pragma once

#include "core/surface/mesher/cell_unroll.h"
#include "core/surface/mesher/fork_check.h"
#include "core/surface/mesher/fork_softening.h"
#include "core/surface/mesher/fork_untangle.h"
#include "core/surface/mesher/fork_walls.h"
#include "core/surface/mesher/strip_patch.h"
#include "core/surface/mesher/tube_builder.h"
#include <array>

namespace ramure {

class ForkBuilder
{
public:
    ForkBuilder(const MesherContext& context, TubeBuilder& tubes)
        : m_context(context)
        , m_tubes(tubes)
    {
    }
    /// Builds the fork at the end of a tube and its children's tubes up to their ends, which are appended to
    /// \p ends.
    void build(const TubeEnd& parent, std::vector<TubeEnd>& ends);

private:
    /// How a fork is built; the first way that keeps its tubes apart is taken.
    struct Way
    {
        int mostSides;     ///< walls are divided as if tubes had no more sides
        bool partialRings; ///< below the first complete ones
        double softness;   ///< of the wanted one
    };
    static const std::array<Way, 8> lateWays;
    static const std::array<Way, 5> softWays;
    /// How much was in the sink, and how many ends there were, before the fork.
    struct Before
    {
        std::size_t vertices, triangles, tubes, forkVertices, ends;
    };
    void attempt(const Way& way, std::vector<TubeEnd>& ends);
    [[nodiscard]] bool isVerySoft() const;
    [[nodiscard]] bool swellsFar() const;
    void findBetterWay(const Before& before, std::vector<TubeEnd>& ends);
    void takeBack(const Before& before, std::vector<TubeEnd>& ends);
    [[nodiscard]] TubeScale scaleOf(const ForkChild& tube) const;
    void startTube(Index child, const Way& way, std::vector<TubeEnd>& ends);
    [[nodiscard]] bool keeps(const ForkChild& tube, std::size_t last, std::size_t k) const
    {
        return keepsSection(tube.sections, last, k, m_context.skeleton.leastGap);
    }
    std::size_t firstFullSection(const ForkChild& tube) const;
    std::size_t lastSectionBelow(const ForkChild& tube, std::size_t full) const;
    void trimEndRing(Index child, const AxisSection& section, Index ring, std::size_t count);
    void swellRing(const AxisSection& section, Index ring, std::size_t count);
    void swellRingsAbove(Index child, std::size_t full, Index ring);
    void insertPartialRings(Index child, std::size_t full);
    [[nodiscard]] int sidesOfChildren() const;
    [[nodiscard]] bool isFree(Index child, const glm::dvec3& point, double along) const;

    const MesherContext& m_context;
    TubeBuilder& m_tubes;
    AxisBuilder m_axes;
    ForkPlanner m_planner;
    ForkLayout m_layout;
    ForkSoftener m_softener;
    ForkWalls m_walls;
    ForkRing m_ring;
    CellUnroller m_unroller;
    StripPatch m_patch;
    ForkCheck m_check; ///< knows the strips that close the fork
    ForkUntangler m_untangler;
    bool m_isChecked = false;          ///< the fork at hand
    std::vector<ForkChild> m_children; ///< never shrinks: the first m_count are in use
    std::size_t m_count = 0;
    std::vector<CellVertex> m_boundary;
    std::vector<UnrolledVertex> m_front, m_upper;
};

} // namespace ramure
