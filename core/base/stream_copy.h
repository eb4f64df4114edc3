/// \file
/// Copying into arrays so large that nothing of them will be in the caches when it is read.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#ifdef __x86_64__
#include <emmintrin.h>
#endif

namespace ramure {

/// Copies like std::memcpy, but past the caches: they need not read the overwritten memory, and keep their
/// contents. Other threads see the copy after endStreamCopies().
inline void streamCopy(void* to, const void* from, std::size_t bytes)
{
#ifdef __x86_64__
    constexpr std::size_t unit = sizeof(__m128i);
    auto* at = static_cast<char*>(to);
    const auto* source = static_cast<const char*>(from);
    const std::size_t apart = reinterpret_cast<std::uintptr_t>(at) % unit;
    const std::size_t head = std::min(bytes, apart == 0 ? 0 : unit - apart);
    std::memcpy(at, source, head);
    std::size_t i = head;
    for (; i + unit <= bytes; i += unit)
        _mm_stream_si128(reinterpret_cast<__m128i*>(at + i),
                         _mm_loadu_si128(reinterpret_cast<const __m128i*>(source + i)));
    std::memcpy(at + i, source + i, bytes - i);
#else
    std::memcpy(to, from, bytes);
#endif
}

inline void endStreamCopies()
{
#ifdef __x86_64__
    _mm_sfence();
#endif
}

} // namespace ramure
