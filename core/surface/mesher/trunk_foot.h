/// \file
/// The foot of a trunk: its cross-section becomes lobes on the way down, the lobes run out over the ground as
/// roots, and the roots sink into it. On a slope all of it is sheared along the trunk: uphill roots enter the
/// ground higher, downhill they reach lower.
#pragma once

#include "core/surface/mesher/branch_axis.h"
#include "core/surface/mesher/fork_layout.h"
#include "core/surface/mesher/skeleton_normalise.h"
#include <array>
#include <span>
#include <vector>

namespace ramure {

/// None where no roots are asked for. \param sides of the trunk above its foot, at least leastSides
FootSize footSize(const MeshParams& params, Index sides);

/// m, from where the trunk begins, \p place, up to where it is round on all sides. \param radius of the trunk
/// there; \param ground as for TrunkFoot
double footHeight(const MeshParams& params, double radius, const std::optional<GroundPlane>& ground,
                  const glm::dvec3& place);

/// A foot in place. Its rings follow each other from the lowest, which lies under the ground, to the highest,
/// which is a circle on the trunk; all have one number of points, and points of one number make a column.
class TrunkFoot
{
public:
    static constexpr std::size_t crestSteps = 48;

    /// None where the trunk has none, leans too far or has no length. \param trunk stands on the ground at
    /// its p0; \param sides around it above the foot; \param seed makes the roots of each tree its own;
    /// \param ground near it, in the space of p0; nothing: level at p0.
    TrunkFoot(const MeshBranch& trunk, const MeshParams& params, Index sides, std::uint64_t seed,
              const std::optional<GroundPlane>& ground = std::nullopt);

    [[nodiscard]] bool isThere() const { return m_size.rings > 0; }
    [[nodiscard]] const FootSize& size() const { return m_size; }
    /// The azimuths of all columns on the highest ring, from the first column on.
    [[nodiscard]] std::span<const RingPoint> columns() const { return m_columns; }
    /// rad, of the first column in the frame of the trunk.
    [[nodiscard]] double turned() const { return m_turned; }
    /// \param frame of the trunk
    [[nodiscard]] glm::dvec3 at(Index ring, Index column, const Frame& frame) const;
    /// Takes the sections of the trunk's tube that are within the foot away; one at its top comes first.
    void cutOff(std::vector<AxisSection>& sections) const;
    /// The middle of the lowest ring.
    [[nodiscard]] glm::dvec3 pole() const;
    /// Points of each tongue, the valley after it the last of them.
    [[nodiscard]] Index pointsOfRoot() const { return m_size.points / m_size.roots; }

private:
    struct Root
    {
        double azimuth;       ///< rad, in the trunk's frame
        double before, after; ///< rad, to the valleys on both sides
        double height;        ///< m, at which it leaves the trunk
        double length;        ///< m, about how far from the trunk it sinks
        double ridge;         ///< m, how high it runs over the ground
        double fork;          ///< m, how far from the trunk it forks, if it does
        double wander, lag;   ///< rad, how far it turns to the side, half of it so many m away
        double back, backLag; ///< the same, further away
        std::array<double, crestSteps + 1>
            crest; ///< m, the crest's height, at places ever further from the trunk
    };
    /// A root is one tongue, or two where it forks. Places across a root are -1 and 1 in the valleys beside
    /// it.
    struct Tongue
    {
        Index root;
        double crest;       ///< place across the root
        double from, to;    ///< of its valleys, of which 0 is a fork's crotch
        double reach = 1.0; ///< of the root's length
    };
    struct Column
    {
        Index tongue;
        double side;    ///< -1 and 1 in the tongue's valleys, 0 on its crest
        double profile; ///< of the tongue's reach: 1 on its crest, 0 in its valleys
    };
    void placeRoots(const MeshParams& params, std::uint64_t seed);
    void placeTongues(Index forks, std::uint64_t seed);
    void placeColumns();
    [[nodiscard]] double heightOf(Index ring, double beside) const;
    [[nodiscard]] static double crestHeight(const Root& root, double out);
    [[nodiscard]] static double crestOf(const Root& root, double height);
    [[nodiscard]] double outOf(const Column& column, double height) const;
    [[nodiscard]] double azimuthOf(const Column& column, double out) const;
    [[nodiscard]] bool isLevel() const { return m_grade == glm::dvec3(0.0) && m_offset == 0.0; }
    void standOn(const GroundPlane& ground);

    FootSize m_size;
    glm::dvec3 m_start{0.0}, m_way{0.0, 1.0, 0.0}; ///< where the trunk stands, and its unit direction
    double m_top = 0.0, m_height = 0.0, m_radius = 0.0;
    double m_turned = 0.0;
    double m_sunk = 0.0;     ///< m under the ground, a depth that crests come near to
    glm::dvec3 m_grade{0.0}; ///< m that the ground rises in a metre along X and Z
    double m_offset = 0.0;   ///< m, of the ground over m_start
    double m_follow = 1.0;   ///< share of what the ground asks for that the trunk itself has room for
    std::vector<Root> m_roots;
    std::vector<Tongue> m_tongues;
    std::vector<Column> m_columnOf;
    std::vector<RingPoint> m_columns;
};

} // namespace ramure
