/// \file
/// Freed memory stays with the program for the next result.
#pragma once

#include <cstdlib> // tells whose library it is
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace ramure {

/// Call this once, when a program starts. Every change of a parameter allocates tens of megabytes and frees
/// the old ones. If they went back to the system, each page would be cleared and mapped again, which is a
/// quarter of the time of a rebuild. Up to half a gigabyte is kept. All threads use one arena, because other
/// arenas return freed memory regardless of the setting; no code here allocates often on many threads.
inline void keepFreedMemory()
{
#ifdef __GLIBC__
    constexpr int kept = 512 << 20;
    ::mallopt(M_ARENA_MAX, 1);
    ::mallopt(M_MMAP_THRESHOLD, kept);
    ::mallopt(M_TRIM_THRESHOLD, kept);
#endif
}

} // namespace ramure
