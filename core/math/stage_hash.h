/// \file
/// A 64-bit hash over the inputs of a stage. Chained: the hash of one stage is the first input of the next.
#pragma once

#include "core/math/random.h"
#include <bit>
#include <concepts>
#include <cstdint>
#include <string_view>

namespace ramure {

class StageHash
{
public:
    explicit StageHash(std::uint64_t before)
        : m_state(before)
    {
    }
    StageHash& add(std::integral auto value) { return addBits(static_cast<std::uint64_t>(value)); }
    StageHash& add(double value) { return addBits(std::bit_cast<std::uint64_t>(value)); }
    /// The length goes in too: "ab", "c" and "a", "bc" differ.
    StageHash& add(std::string_view text)
    {
        addBits(text.size());
        std::uint64_t word = 0;
        for (std::size_t i = 0; i < text.size(); ++i) {
            word = word << 8 | static_cast<unsigned char>(text[i]);
            if (i % 8 == 7)
                addBits(word);
        }
        return addBits(word);
    }
    [[nodiscard]] std::uint64_t value() const { return m_state; }

private:
    StageHash& addBits(std::uint64_t bits)
    {
        m_state = mixBits(m_state * 0x9E3779B97F4A7C15ull + bits + 1);
        return *this;
    }

    std::uint64_t m_state;
};

} // namespace ramure
