/// \file
/// Vectors of numbers that can be counted with.
#pragma once

#include <cmath>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace ramure {

template <glm::length_t n, class T> bool isFinite(const glm::vec<n, T>& v)
{
    for (glm::length_t i = 0; i < n; ++i)
        if (!std::isfinite(v[i]))
            return false;
    return true;
}

} // namespace ramure
