/// \file
/// Rounds the valleys of a fork: where two tubes meet, wood grows over the crease.
#pragma once

#include "core/surface/mesher/fork_lift.h"

namespace ramure {

/// A smooth union of the tubes, evaluated at the vertices that a fork has anyway. A tube swells by
///     softness * reach / 4 * (1 - d / reach)^2 * min(1, 1 - cos a)
/// where its sibling's surface is d away and the two surfaces face directions that are an angle a apart: the
/// polynomial smooth minimum of two distances, but none of it where both tubes are still one and the same, at
/// the ring they start from. A vertex of a wall, as far from both, is moved that far out of the valley.
class ForkSoftener
{
public:
    /// \param reach of the smaller radius; \param softness 0..1. Either 0: nothing is moved.
    void begin(std::span<const ForkChild> children, double reach, double softness);
    /// Forks the walls of which reach far up the shortest child are softened less, or not at all: there is no
    /// room. \param ringHeight arc length of a wall's vertex.
    void limit(double ringHeight);
    [[nodiscard]] bool isOn() const { return m_softness > 0.0; }
    /// Moves the vertex of a wall between two or three children, lifted to where their tubes come apart, out
    /// of the valley, and \p along to the arc length it has there. False where it stays.
    bool soften(const std::array<Index, 3>& child, glm::dvec3& position, double& along);
    /// Does a sibling come near a cross-section of a child? Only there does the tube swell.
    [[nodiscard]] bool comesNear(Index child, const AxisSection& section);
    /// How far (m) the tube asked about last swells at a point of its surface, \p out being the unit vector
    /// away from its axis.
    [[nodiscard]] double swelling(const AxisSection& section, const glm::dvec3& point,
                                  const glm::dvec3& out) const;

private:
    [[nodiscard]] double bulge(double reach, double away, double cosine) const;

    std::span<const ForkChild> m_children;
    double m_reach = 0.0, m_softness = 0.0;
    std::vector<AxisTable::Away> m_away; ///< of the vertex at hand
    std::vector<Index> m_near;           ///< children near the cross-section at hand
};

} // namespace ramure
