/// \file
/// Where an edit of a branch was made: enough to find the place again when the tree has changed. Plain
/// numbers; core/skeleton/edit_places.h makes and reads them.
#pragma once

#include <cstdint>
#include <vector>

namespace ramure {

/// What an axis looked like. Ranks count from the base, lengths are in m, angles in rad.
struct AxisPrint
{
    std::uint64_t address = 0;
    std::uint32_t fork = 0;  ///< rank of its fork along the parent
    std::uint32_t mate = 0;  ///< rank within the fork
    std::uint32_t forks = 0; ///< that it has itself
    std::uint32_t mates = 0; ///< axes that start at its fork, itself counted
    double s = 0.0;          ///< from the parent's foot
    double share = 0.0;      ///< the same of the parent's length
    double downAngle = 0.0, azimuth = 0.0;
    double length = 0.0;
    double radius = 0.0; ///< at the foot
    bool operator==(const AxisPrint&) const = default;
};

struct BranchPlace
{
    std::uint64_t tree = 0;     ///< places of the same tree compete for a branch, those of others do not
    std::vector<AxisPrint> way; ///< from a root to the branch's own axis; empty: nothing is known
    std::uint32_t fork = 0;     ///< forks of the axis up to where the branch starts
    std::uint32_t piece = 0;    ///< steps of the turtle from there
    double share = 0.0;         ///< of the axis' length, at the middle of the branch's first step
    bool operator==(const BranchPlace&) const = default;
};

} // namespace ramure
