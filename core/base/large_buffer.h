/// \file
/// Uninitialised working memory for passes over whole meshes.
///
/// The first touch of a fresh 4 KiB page costs more than the work done on it; large buffers therefore ask for
/// huge pages, and nothing is cleared that is overwritten anyway.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>
#ifdef __linux__
#include <sys/mman.h>
#endif

namespace ramure {

inline constexpr std::size_t hugePageSize = std::size_t(2) << 20;

/// Asks for huge pages under the part of the memory that has room for whole ones. A wish: without them it is
/// only slower.
inline void adviseHugePages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes)
{
#ifdef __linux__
    const auto begin =
        (reinterpret_cast<std::uintptr_t>(memory) + hugePageSize - 1) / hugePageSize * hugePageSize;
    const auto end = (reinterpret_cast<std::uintptr_t>(memory) + bytes) / hugePageSize * hugePageSize;
    if (memory && begin < end)
        ::madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
#endif
}

/// Reserves room for \p count elements, and asks for huge pages under it.
template <class T> void reserveHuge(std::vector<T>& array, std::size_t count)
{
    array.reserve(count);
    adviseHugePages(array.data(), count * sizeof(T));
}

/// An array of plain values whose contents are undefined until written. Movable, not copyable.
/// Throws std::bad_alloc like std::vector.
template <class T> class LargeBuffer
{
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

public:
    LargeBuffer() = default;
    explicit LargeBuffer(std::size_t count)
        : m_size(count)
    {
        if (count == 0)
            return;
        if (count > std::size_t(-1) / 2 / sizeof(T))
            throw std::bad_alloc();
        // Aligned here and not by the allocator: that looks for room for the alignment too, finds it too
        // small where the same array was freed before, and takes fresh memory.
        constexpr std::size_t alignment = std::max(alignof(T), alignof(std::max_align_t));
        const std::size_t unit = count * sizeof(T) >= hugePageSize ? hugePageSize : alignment;
        const std::size_t bytes = (count * sizeof(T) + unit - 1) / unit * unit;
        m_block = std::malloc(bytes + unit);
        if (!m_block)
            throw std::bad_alloc();
        const auto from = reinterpret_cast<std::uintptr_t>(m_block);
        m_data = reinterpret_cast<T*>((from + unit - 1) / unit * unit);
        adviseHugePages(m_data, bytes);
    }
    LargeBuffer(LargeBuffer&& other) noexcept
        : m_block(std::exchange(other.m_block, nullptr))
        , m_data(std::exchange(other.m_data, nullptr))
        , m_size(std::exchange(other.m_size, 0))
    {
    }
    LargeBuffer& operator=(LargeBuffer&& other) noexcept
    {
        std::swap(m_block, other.m_block);
        std::swap(m_data, other.m_data);
        std::swap(m_size, other.m_size);
        return *this;
    }
    ~LargeBuffer() { std::free(m_block); }

    [[nodiscard]] T* data() { return m_data; }
    [[nodiscard]] const T* data() const { return m_data; }
    [[nodiscard]] std::size_t size() const { return m_size; }
    T& operator[](std::size_t i) { return m_data[i]; }
    const T& operator[](std::size_t i) const { return m_data[i]; }

private:
    void* m_block = nullptr;
    T* m_data = nullptr;
    std::size_t m_size = 0;
};

} // namespace ramure
