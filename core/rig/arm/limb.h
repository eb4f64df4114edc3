/// \file
/// Inverse kinematics on a chain of branches: the hand drags a twig and the limb it grows on follows, thin
/// branches more than thick ones. It uses the same damped least squares as an arm; each branch turns any way
/// about its start. The results are bends (core/skeleton/bend.h).
#pragma once

#include "core/skeleton/skeleton.h"
#include <glm/gtc/quaternion.hpp>
#include <map>

namespace ramure {

struct LimbOptions
{
    std::size_t branches = 8; ///< number of branches that turn, from the grabbed one towards the root
    /// A branch gives way in proportion to length / radius^stiffness: 0 = all alike, 4 = as beams do.
    double stiffness = 2.0;
    double mostTurnRad = 1.0471975511965976; ///< most turn of a branch from its start, rad; 60 degrees
};

/// Returns how many branches, from \p branch towards the root, a light pull may turn. Branches thicker than
/// twice that branch stay, and so does the root with all below. 0 for the root itself. \pre \p branch exists
std::size_t limbLength(const Skeleton& skeleton, Index branch);

class Limb
{
public:
    using Bends = std::map<std::uint64_t, glm::dvec3>; ///< by Skeleton::key

    /// \param skeleton as it is now; \param bendRad the bends it was made with; branches that are missing
    /// have none. \param branch that the hand holds at its end. \pre it exists
    Limb(const Skeleton& skeleton, const Bends& bendRad, Index branch, const LimbOptions& options);

    /// Returns the place of the end of the grabbed branch, in tree space.
    [[nodiscard]] glm::dvec3 tip() const;
    /// Turns the limb so that its tip comes to \p target, or as near as it gets. The result depends on the
    /// target alone, not on the targets before. Not finite: nothing changes. Tree space.
    /// \return m short of the target
    double pullTo(const glm::dvec3& target);
    /// The bends of the branches of the chain, each of them, as they are now.
    [[nodiscard]] Bends bends() const;
    [[nodiscard]] std::size_t branchCount() const { return m_links.size(); }

private:
    struct Link
    {
        std::uint64_t key = 0;
        glm::dvec3 along{0.0}; ///< from its start to its end, unbent
        double give = 1.0;     ///< how easily it turns, at most 1
        glm::dquat bend{1.0, 0.0, 0.0, 0.0};
    };
    using Chain = std::vector<Link>; ///< from the root towards the tip

    /// Computes where each link starts and, last, where the tip is, and how the links before each one turn
    /// it.
    void place(const Chain& chain);
    [[nodiscard]] bool turned(const Chain& from, const glm::dvec3& error, double damping, Chain& to) const;
    [[nodiscard]] std::vector<glm::dvec3> turnsFor(const Chain& from, const std::vector<glm::dvec3>& stops,
                                                   const glm::dvec3& error, double damping) const;
    [[nodiscard]] glm::dvec3 stopOf(const Chain& from, std::size_t link) const;

    Chain m_atGrab, m_links;
    double m_mostTurn;
    glm::dvec3 m_foot{0.0};                   ///< start of the first link
    glm::dquat m_carried{1.0, 0.0, 0.0, 0.0}; ///< turn by the branches below the chain
    double m_reach = 0.0;
    std::vector<glm::dvec3> m_points;
    std::vector<glm::dquat> m_before;
};

} // namespace ramure
