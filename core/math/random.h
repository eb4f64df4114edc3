/// \file
/// The program's own random generator: the same seed gives the same numbers on every machine and compiler.
///
/// SplitMix64 (Steele, Lea, Flood: "Fast splittable pseudorandom number generators", OOPSLA 2014). One stream
/// per purpose, so that changing the leaves never re-rolls the branches.
#pragma once

#include <cstdint>

namespace ramure {

/// The purposes of random streams. The values are part of the file format: a number never changes its
/// meaning.
enum class RandomStream : std::uint64_t {
    Rewrite = 1,
    Leaves = 2,
    Apples = 3,
    Wind = 4,
    Preset = 5,
    Nudge = 6,
    BranchTurn = 7,
    BranchShape = 8,
    TwigLeaves = 9,
    LeafSwing = 10,
    LeafFall = 11,
    Venation = 12,
    Ripening = 13,
    LeafDamage = 14,
    ArmStart = 20,
    Terrain = 21,
    Stems = 30,
    CrownPoints = 31,
    Roots = 32,
    Steps = 33, ///< steps of a recipe
    Scatter = 34,
    ScatterForm = 35, ///< turns, sizes and prototypes of instances
    Clusters = 36,
    Splinters = 37, ///< of broken wood
    BarkMarks = 38, ///< scars, hollows, burrs
    Stand = 39,     ///< trees of a stand
    Test = 1000
};

/// The finaliser of SplitMix64: a bijection of 64-bit words whose output bits all depend on all input bits.
constexpr std::uint64_t mixBits(std::uint64_t z)
{
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return z ^ (z >> 31);
}

class Random
{
public:
    /// \param seed the user's seed; \param stream the purpose; \param key an element of it (a branch key,
    /// say).
    constexpr Random(std::uint64_t seed, RandomStream stream, std::uint64_t key = 0)
        : m_state(mixBits(mixBits(seed + golden) + static_cast<std::uint64_t>(stream) * golden) ^
                  mixBits(key * golden))
    {
    }
    constexpr std::uint64_t next() { return mixBits(m_state += golden); }
    /// Uniform in [0, 1), 53 bits.
    constexpr double unit() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
    constexpr double range(double from, double to) { return from + (to - from) * unit(); }
    /// Uniform in 0 .. count - 1; count > 0. (Multiply-shift; the bias is under count / 2^32.)
    constexpr std::uint32_t below(std::uint32_t count)
    {
        return static_cast<std::uint32_t>(((next() >> 32) * count) >> 32);
    }

private:
    static constexpr std::uint64_t golden = 0x9E3779B97F4A7C15ull;
    std::uint64_t m_state;
};

} // namespace ramure
