/// \file
/// Skeletons that break meshers. Every animal is made from its family and a seed alone, by the program's own
/// generator (RandomStream::Test), so that a number in a test report names the same skeleton again on every
/// machine (with another compiler than GCC, which draws arguments in another order, it may name another one
/// of the family).
#pragma once

#include "core/skeleton/skeleton.h"
#include "core/surface/mesher/branch_mesh.h"
#include <cstdint>
#include <string>
#include <vector>

namespace ramure::test {

enum class ZooFamily : std::uint8_t {
    FewChildren,        ///< random trees of 0 to 5 children a branch
    ManyChildren,       ///< random trees of up to 20 children a branch
    Bush,               ///< 21 to 64 children on one branch
    Roots,              ///< several roots, some of them one and the same branch
    CoincidentSiblings, ///< siblings with the same ends, some with other radii
    NearTwins,          ///< siblings apart by 1e-5 .. 0.2 rad, of equal or other length
    ZeroLength,         ///< branches of no length: inside, at tips, in chains
    ZeroRoots,          ///< roots of no length, with and without children
    ZeroRadii,          ///< radii of 0 at one end, at both, everywhere
    Antiparallel,       ///< children that run straight back through their parent
    SameDirection,      ///< several children straight ahead, of other lengths
    PlanarFan,          ///< children in one plane, at equal angles, on both sides and at right angles
    Symmetric,          ///< children along the axes and on regular cones: exactly cocircular sites
    ShortChildren,      ///< children of 0.05 times their parent's length
    Thick,              ///< radii of up to 20 times the length
    RadiusJumps,        ///< a child's radius has nothing to do with its parent's
    AlmostZero,         ///< lengths of 1e-9 .. 1e-2 among ordinary ones
    ThereAndBack,       ///< paths that return to where they have been: ends coincide across generations
    DeepChain,          ///< thousands of branches, one after the other
    TinyScale,          ///< a random tree of 1e-6 m
    HugeScale,          ///< a random tree of 1e6 m
    FarOff,             ///< a random tree up to 100 times its size from the origin
    Grammar,            ///< random grammars: the same fork at every level, turned by one angle
    Mixture,            ///< every branch draws one of the above troubles
};
inline constexpr int zooFamilyCount = static_cast<int>(ZooFamily::Mixture) + 1;

const char* zooName(ZooFamily family);
/// The skeleton keeps Skeleton's invariants and has finite numbers; everything else may be wrong with it.
Skeleton zooSkeleton(ZooFamily family, std::uint64_t seed);

/// A skeleton with the options to build it with.
struct Specimen
{
    std::string name; ///< "NearTwins seed 17, 8 x 4, twins 0.25": enough to make it again
    Skeleton skeleton;
    BranchMeshOptions options;   ///< without the roll: a copy of the specimen would share it
    std::vector<double> rollRad; ///< one per branch, or empty

    /// Valid as long as the specimen lives.
    [[nodiscard]] BranchMeshOptions meshOptions() const
    {
        BranchMeshOptions all = options;
        all.rollRad = rollRad;
        return all;
    }
};
/// Specimen \p number of an endless row: the families take turns; the options are drawn from the number.
Specimen specimen(std::uint64_t number);

/// What to do with specimens in a test run: from 0 up to RAMURE_FUZZ_COUNT (environment), or \p usual.
std::uint64_t fuzzCount(std::uint64_t usual);

} // namespace ramure::test
