/// \file
/// Parameters of a scatter: where copies of its children stand. The member initialisers are the defaults.
#pragma once

#include <cstdint>
#include <string>

namespace ramure {

/// The rules of a scatter (core/scatter/scatter.h), in its own space.
struct ScatterParams
{
    std::int64_t seed = 1;
    std::int64_t count = 200;            ///< at most so many instances; 0: as many as the spacing lets stand
    double spacing = 4.0;                ///< m, between two instances at least
    double width = 80.0, depth = 80.0;   ///< m, of the area along X and Z, with the origin in its middle
    std::string ground;                  ///< name of a node that they stand on; empty: all terrains
    std::string density;                 ///< path of a picture over the area; empty: the same everywhere
    double steepest = 0.61;              ///< rad: steeper ground carries none
    double lowest = -1e4, highest = 1e4; ///< m: ground beyond these heights carries none
    double clearance = 0.0;              ///< m, from solids that are obstacles
    double clusters = 0.0;               ///< 0 evenly spread, 1 in clusters alone
    double clusterSize = 15.0;           ///< m
    std::string shares;                  ///< "3 1": of the children in their order; missing ones are 1
    double leastScale = 0.85, mostScale = 1.15;
    double turn = 1.0;      ///< of a full turn by which they may be turned about the vertical
    double alignment = 0.0; ///< 0 upright, 1 square to the ground
    bool stand = false;     ///< they grow up together, and most die of shade
    double age = 60.0;      ///< years, of a stand
    std::string removed;    ///< keys of instances that are left out, hexadecimal
    bool operator==(const ScatterParams&) const = default;
};

} // namespace ramure
