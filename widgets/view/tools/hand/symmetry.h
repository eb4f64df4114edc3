/// \file
/// What is done to one limb is done to those at the mirrored or turned place about the trunk, too: one
/// mechanism for all tools. A tree is never quite even, so its nearest limb there is taken that goes the same
/// way, about as long; where there is none, nothing happens.
#pragma once

#include "core/qt/document/document.h"
#include "core/skeleton/axes.h"
#include "widgets/view/tools/hand_settings.h"
#include <glm/mat3x3.hpp>
#include <vector>

namespace ramure {

/// A rotation or reflection about the trunk, tree space without bends.
struct SymmetryMap
{
    glm::dmat3 turn{1.0};
    glm::dvec3 about{0.0}; ///< stays where it is
    bool mirrors = false;

    [[nodiscard]] glm::dvec3 point(const glm::dvec3& at) const { return about + turn * (at - about); }
    /// A rotation vector: axis times angle.
    [[nodiscard]] glm::dvec3 rotation(const glm::dvec3& v) const
    {
        return (mirrors ? -1.0 : 1.0) * (turn * v);
    }
    [[nodiscard]] double angle(double rad) const { return mirrors ? -rad : rad; }
};

/// A limb that another one is at the mirrored or turned place.
struct LimbTwin
{
    Index axis = noIndex;
    std::uint64_t address = 0;
    SymmetryMap map; ///< leads from the limb to this one
};

class Symmetry
{
public:
    /// Nothing has a twin.
    Symmetry() = default;
    /// \param axes of \p drawn: the tree with its edits (TreeResult::skeleton); both must outlive this.
    /// \param sight tree space: the mirror stands in it, upright on the trunk.
    Symmetry(const TreeAxes& axes, const Skeleton& drawn, const HandOptions& options,
             const glm::dvec3& sight);

    [[nodiscard]] bool isOn() const { return m_copies > 1 || m_mirrored; }
    /// Each limb once, never \p axis itself.
    std::vector<LimbTwin> twins(Index axis);
    /// Places where there was no limb like it, since the beginning.
    [[nodiscard]] int missing() const { return m_missing; }

private:
    [[nodiscard]] std::vector<SymmetryMap> maps(Index axis) const;
    [[nodiscard]] Index nearest(Index axis, const SymmetryMap& map) const;
    [[nodiscard]] glm::dvec3 foot(Index axis) const;
    [[nodiscard]] glm::dvec3 middle(Index axis) const;
    [[nodiscard]] glm::dvec3 tip(Index axis) const;

    const TreeAxes* m_axes = nullptr;
    const Skeleton* m_drawn = nullptr;
    int m_copies = 1;
    bool m_mirrored = false;
    glm::dvec3 m_sight{0.0};
    int m_missing = 0;
};

} // namespace ramure
