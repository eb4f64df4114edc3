/// \file
/// More versions of a function for processors with wider vectors, chosen when the program starts.
/// RAMURE_WIDE_CLONE is for vectors of eight floats. RAMURE_WIDEST_CLONE adds sixteen, for functions that
/// only compute with many numbers side by side.
///
/// All versions give the same bytes, because none fuses operations and all add in a fixed order. (Sanitizers
/// start too late for such a choice.)
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(RAMURE_SANITIZED)
#define RAMURE_WIDE_CLONE [[gnu::target_clones("avx2", "default")]]
#define RAMURE_WIDEST_CLONE [[gnu::target_clones("arch=x86-64-v4", "avx2", "default")]]
#else
#define RAMURE_WIDEST_CLONE
#define RAMURE_WIDE_CLONE
#endif
