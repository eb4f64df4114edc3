/// \file
/// Growth towards points, node by node: the first half of growColonisation(). Internal to it.
#pragma once

#include "core/base/error.h"
#include "core/base/index.h"
#include "core/base/progress.h"
#include "core/params/colonisation_params.h"
#include <glm/vec3.hpp>
#include <vector>

namespace ramure {

/// Parents before children; node 0 is the foot.
struct ColonisedNodes
{
    std::vector<glm::dvec3> at; ///< tree space, m
    std::vector<Index> parent;  ///< noIndex: the foot
};

/// \param points in tree space, m. Errors as growColonisation().
Expected<ColonisedNodes> colonise(const ColonisationParams& params, const std::vector<glm::dvec3>& points,
                                  const Progress& progress);

} // namespace ramure
