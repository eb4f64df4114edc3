/// \file
/// How the colour of bark goes from twigs to the trunk and from patch to patch, as factors of its picture:
/// for those who have no shader that does it.
#pragma once

#include "core/params/bark_params.h"
#include <glm/vec3.hpp>

namespace ramure {

class BarkTints
{
public:
    /// \pre the family is not Plain.
    explicit BarkTints(const BarkParams& bark);

    /// Linear, 0..1: what is lighter than old bark keeps its hue alone. \param radius m, of the wood there.
    /// \param place in the tree, m.
    [[nodiscard]] glm::vec3 at(float radius, const glm::vec3& place) const;

private:
    BarkFamily m_family;
    glm::vec3 m_young, m_limb;
};

} // namespace ramure
