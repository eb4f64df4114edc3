/// \file
/// Freed memory stays with the program for the next result.
#pragma once

#include <cstdlib> // tells whose library it is
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace ramure {

/// Call once, when a program starts. Every change of a parameter makes tens of megabytes anew and frees the
/// old ones. Given back to the system and taken again, each page of them is cleared and mapped once more:
/// that is a quarter of the time of a rebuild. Up to half a gigabyte stays. One arena, because those of other
/// threads give back what they free whatever one says; nothing here allocates often on many threads.
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
