/// \file
/// The crown to be filled (a solid of revolution about the trunk, or solids of the scene) and the points in
/// it.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/params/colonisation_params.h"
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ramure {

inline constexpr std::size_t maxProfilePairs = 64;

/// Parses pairs of height and radius, both as shares in [0, 1], in the order of the text. Errors: Syntax with
/// the column of the fault; heights must grow, some radius must be over 0, and 2 to 64 pairs are needed.
Expected<std::vector<glm::dvec2>> parseProfile(std::string_view text);

/// Writes pairs as a text that parseProfile() reads.
std::string profileText(const std::vector<glm::dvec2>& pairs);

/// Radius by height, both as shares of the crown.
class CrownOutline
{
public:
    /// Errors: those of parseProfile(), path "colonisation.profile".
    static Expected<CrownOutline> of(const ColonisationParams& params);
    /// Nothing where \p pairs are none that parseProfile() could give.
    static std::optional<CrownOutline> through(std::vector<glm::dvec2> pairs);

    /// 0 outside of [0, 1]. A profile's curve goes through its pairs and never beyond two neighbours:
    /// Fritsch, Carlson: "Monotone piecewise cubic interpolation" (SIAM J. Numer. Anal. 17, 1980).
    [[nodiscard]] double radiusAt(double height) const;
    /// The largest of all radii.
    [[nodiscard]] double widest() const;

private:
    CrownEnvelope m_envelope = CrownEnvelope::Sphere;
    std::vector<glm::dvec2> m_pairs;
    std::vector<double> m_slopes;
};

/// Returns the points of the crown in tree space, m. Point number i depends on \p seed and i alone. Points
/// inside obstacles are left out. Errors: those of CrownOutline and of GrowthSpace; Invalid (obstacles leave
/// none), Cancelled.
Expected<std::vector<glm::dvec3>> crownPoints(const ColonisationParams& params, std::uint64_t seed,
                                              const Progress& progress = {});

} // namespace ramure
