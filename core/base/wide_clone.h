/// \file
/// One more version of a function for processors with wider vectors, chosen when the program starts.
///
/// The same bytes come out of both: neither fuses operations, and whoever uses it adds in a fixed order.
/// (Sanitizers start too late for such a choice.)
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define RAMURE_WIDE_CLONE [[gnu::target_clones("avx2", "default")]]
#else
#define RAMURE_WIDE_CLONE
#endif

/// Where a function can be written with the instructions of processors with wider vectors, beside a plain one
/// that gives the same: RAMURE_WIDE before the function, hasWideVectors() before the call.
#if defined(__x86_64__) && defined(__GNUC__)
#define RAMURE_WIDE [[gnu::target("avx2")]]
namespace ramure {
inline bool hasWideVectors()
{
    static const bool has = __builtin_cpu_supports("avx2");
    return has;
}
} // namespace ramure
#endif
