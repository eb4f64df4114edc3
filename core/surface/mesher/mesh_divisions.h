/// \file
/// How finely each branch of a mesh is divided, along and around.
#pragma once

#include "core/surface/mesher/fork_layout.h"
#include "core/surface/mesher/skeleton_normalise.h"
#include <span>
#include <vector>

namespace ramure {

inline constexpr int leastSections = 2, mostSections = 64; ///< cross-sections of a branch, both ends included
inline constexpr int leastSides = 3, mostSides = 128;      ///< points of a cross-section
/// The side of a cross-section of its points' number n is at least this times its radius by n, but for
/// triangles to pentagons, whose sides are longer than the radius. A circle would have 2 pi.
inline constexpr double sidesOfRadius = 6.0;

/// The divisions that a branch needs, by its shape. At a fineness of 1 a tube departs from its smooth surface
/// by at most a metre, at 10 by a hundredth of that. A number between two whole ones is rounded up for some
/// branches and down for others, by each branch's own threshold, so that the sum over many follows the
/// fineness smoothly.
struct BranchShape
{
    double spans = 0.0;          ///< between cross-sections, at a fineness of 1
    double spansThreshold = 0.0; ///< in [0, 1), added before the number is cut to a whole one
    int fewestSections = leastSections;
    double sidesThreshold = 0.0;
    double hidden = 0.0; ///< share of its surface inside its siblings, about
    /// About its fork: sides of the children, as a share of its own, and limbs of ForkLayout::stem.
    double wallSides = 1.0, arches = 0.0;
};

/// Either every branch the same, or each by its shape.
class MeshDivisions
{
public:
    /// Every branch the same.
    MeshDivisions(int sections, int sides);
    /// \param shapes one per branch of the mesher's skeleton, which must outlive this object.
    /// \param leastGap m, a branch has no more sides than are so long; 0: any number
    MeshDivisions(std::span<const BranchShape> shapes, double fineness, double leastGap);

    /// The regular ring around a branch where it is this thick.
    [[nodiscard]] std::span<const RingPoint> ring(Index branch, double radius) const
    {
        return m_shapes.empty() ? m_rings.front() : ringByShape(branch, radius);
    }
    /// Cross-sections of a branch, both ends included.
    [[nodiscard]] int sections(Index branch) const;

private:
    [[nodiscard]] std::span<const RingPoint> ringByShape(Index branch, double radius) const;

    int m_sections = leastSections;
    double m_fineness = 0.0, m_leastGap = 0.0;
    std::span<const BranchShape> m_shapes; ///< empty: all the same
    /// Rings of leastSides points, one more, ... or a single ring.
    std::vector<std::vector<RingPoint>> m_rings;
};

/// Points on a circle of this radius that a fineness asks for, before rounding and limits.
double sidesAskedFor(double radius, double fineness);

/// Finds the fineness for a number of triangles.
class MeshBudget
{
public:
    MeshBudget(const NormalSkeleton& skeleton, const MeshParams& params);

    [[nodiscard]] std::span<const BranchShape> shapes() const { return m_shapes; }
    /// About how many triangles a mesh of this fineness has; rises with it.
    [[nodiscard]] double triangles(double fineness) const;
    /// The fineness at which triangles() is \p wanted, at least 0 (coarsest), at most finest().
    [[nodiscard]] double finenessFor(double wanted) const;
    /// No branch can be divided more.
    [[nodiscard]] double finest() const { return m_finest; }

private:
    void measure(Index branch);
    void measureFork(Index parent);

    const NormalSkeleton& m_skeleton;
    const MeshParams& m_params;
    std::vector<BranchShape> m_shapes;
    double m_finest = 1.0;
};

} // namespace ramure
