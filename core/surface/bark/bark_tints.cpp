#include "core/surface/bark/bark_tints.h"

#include "core/math/srgb.h"
#include "core/surface/bark/bark_maps.h"
#include <algorithm>
#include <glm/common.hpp>

namespace ramure {

static glm::vec3 factorOf(const glm::u8vec3& colour, const glm::u8vec3& old)
{
    const glm::vec3 factor = linearOf(colour) / glm::max(linearOf(old), 1e-3F);
    return factor / std::max({factor.r, factor.g, factor.b, 1.0F});
}

BarkTints::BarkTints(const BarkParams& bark)
    : m_family(bark.family)
    , m_young(factorOf(youngColour(bark), meanColour(bark)))
    , m_limb(factorOf(limbColour(bark), meanColour(bark)))
{
}

glm::vec3 BarkTints::at(float radius, const glm::vec3& place) const
{
    const glm::vec3 bare = glm::mix(m_limb, glm::vec3(1.0F), barkRipeness(m_family, double(radius)));
    const glm::vec3 aged = glm::mix(m_young, bare, barkAge(m_family, double(radius)));
    const glm::vec3 worn = glm::mix(glm::vec3(1.0F), weatheredBark, barkWeather(place));
    return aged * worn * worn; // squared: about linear
}

} // namespace ramure
