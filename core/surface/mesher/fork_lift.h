/// \file
/// How high above a fork its tubes come apart: where the vertices of the walls between them lie.
#pragma once

#include "core/surface/mesher/branch_axis.h"
#include <limits>
#include <optional>
#include <span>

namespace ramure {

/// A child at a fork.
struct ForkChild
{
    Index branch = noIndex; ///< of the NormalSkeleton
    Index source = noIndex; ///< of the input
    std::vector<AxisSection> sections;
    AxisTable table;
};

/// The way a wall vertex is lifted along: of every arc length, a point between two or three of the axes
/// there. Between three it is the centre of the circle through them, as far as it does not lie too far aside;
/// between two it is \p out (m) aside of their middle.
struct WallPath
{
    std::array<Index, 3> child{noIndex, noIndex, noIndex};
    std::size_t count = 2;
    glm::dvec3 aside{0.0}; ///< unit, across the wall
    /// Unit, towards the point of the ring the wall begins at: down there it leans this way.
    glm::dvec3 atRing{0.0};
    double leansUpTo = 0.0; ///< m, arc length
    double out = 0.0;
    /// A limb, the first child, that leaves a stem, the second, to its side: the path is a line along the
    /// limb's surface, \p out (m) aside of its axis and this far (m) towards where the stem goes.
    bool onLimb = false;
    double up = 0.0;
};

/// Two children's tubes along their common way, coarsely: about where do they come apart?
class ValleyGuess
{
public:
    /// The children of one fork, whose pairs are asked about next.
    void begin(std::span<const ForkChild> children);
    void build(const WallPath& path);
    /// Arc length at which the point \p out (m) aside of the middle leaves both tubes; the length of the
    /// fork's shortest where it does not before.
    [[nodiscard]] double exitAt(double out) const;

private:
    static constexpr std::size_t places = 11;
    /// Squared distance of a point from a tube's surface: a + 2 b out + c out out.
    struct Side
    {
        double a, b, c;
        [[nodiscard]] double at(double out) const { return a + out * (2.0 * b + c * out); }
    };
    std::array<double, places> m_along;
    std::vector<std::array<AxisTable::Place, places>> m_axes; ///< per child
    std::array<std::array<Side, 2>, places> m_sides;
};

class ForkLift
{
public:
    struct Lifted
    {
        glm::dvec3 position{0.0};
        double along = 0.0; ///< m, arc length on the axes
    };

    static constexpr double margin = 0.06; ///< of a tube's radius: how far outside its own tubes a wall lies

    void begin(std::span<const ForkChild> children) { m_children = children; }
    /// Where a line along a limb's surface leaves the stem; near its end where it never does. \p guess: an
    /// arc length near the place.
    [[nodiscard]] Lifted liftOnLimb(const WallPath& path, double guess) const;
    /// Where a path leaves all tubes; tubes that never come apart end their wall where the shorter one ends.
    /// \param guess an arc length near the place, or 0. \param most a third tube lifts the vertex no higher.
    [[nodiscard]] Lifted lift(const WallPath& path, double guess,
                              double most = std::numeric_limits<double>::max()) const;
    [[nodiscard]] glm::dvec3 pointAt(const WallPath& path, double along) const;
    /// What the point at an arc length owes to each of the axes.
    [[nodiscard]] std::array<double, 3> weightsAt(const WallPath& path, double along) const;
    [[nodiscard]] double meanRadius(const WallPath& path) const;

private:
    enum class Tubes { Own, All };
    [[nodiscard]] bool isCovered(const WallPath& path, const glm::dvec3& point, double along) const;
    [[nodiscard]] double room(const WallPath& path, double along, Tubes tubes) const;
    [[nodiscard]] std::optional<double> exitHeight(const WallPath& path, double reach, double guess,
                                                   Tubes tubes) const;

    std::span<const ForkChild> m_children;
};

} // namespace ramure
