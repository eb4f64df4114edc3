/// \file
/// Copies of a scatter that grow as a stand.
#pragma once

#include "core/scatter/scatter.h"

namespace ramure {

/// Lets the trees among the copies grow up together to the scatter's age: most die of shade, the others get
/// their sizes from their heights, and of prototypes of one species each takes the one that is most nearly as
/// high. What is no tree stays as it is. \param prototypes as prototypesOf() gives them. Errors: those of
/// grownStand(), path = the parameter's key.
Expected<ScatterPlaces> grownPlaces(const ScatterParams& params, const std::vector<const Node*>& prototypes,
                                    ScatterPlaces sown, const Progress& progress);

} // namespace ramure
