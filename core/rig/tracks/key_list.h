/// \file
/// The keys of a track, in pages that lists share: a copy costs a few words, and an edit only the pages it
/// touches, so that a step of undo of a track with 100,000 keys is small and made at once.
#pragma once

#include "core/rig/tracks/key.h"
#include <compare>
#include <cstddef>
#include <iterator>
#include <memory>
#include <span>
#include <vector>

namespace ramure {

/// A sorted list of keys; who fills it sees to the order. Pages never change once they are made: lists may be
/// copied and read from several threads. KeyType: Key or OrientationKey.
template <class KeyType> class KeyList
{
public:
    class Iterator;
    using value_type = KeyType;
    using const_iterator = Iterator;

    /// Keys of one page at most; smaller tracks are one page.
    static constexpr std::size_t mostInPage = 512;

    [[nodiscard]] std::size_t size() const { return m_size; }
    [[nodiscard]] bool empty() const { return m_size == 0; }
    /// \pre index < size()
    [[nodiscard]] const KeyType& operator[](std::size_t index) const
    {
        const PageRef& ref = m_pages[pageOf(index)];
        return ref.page->keys[index - ref.start];
    }
    /// The time of a key, found in less memory than the key itself.
    [[nodiscard]] Ticks timeOf(std::size_t index) const
    {
        const PageRef& ref = m_pages[pageOf(index)];
        return ref.page->times[index - ref.start];
    }
    /// The keys from this one up to the end of its page: for quick ways along many. \pre index < size()
    [[nodiscard]] std::span<const KeyType> runFrom(std::size_t index) const
    {
        const PageRef& ref = m_pages[pageOf(index)];
        return std::span<const KeyType>(ref.page->keys).subspan(index - ref.start);
    }
    [[nodiscard]] const KeyType& front() const { return m_pages.front().page->keys.front(); }
    [[nodiscard]] const KeyType& back() const { return m_pages.back().page->keys.back(); }
    [[nodiscard]] Iterator begin() const { return {this, 0}; }
    [[nodiscard]] Iterator end() const { return {this, m_size}; }
    [[nodiscard]] std::vector<KeyType> toVector() const { return copied(0, m_size); }
    /// Keys first .. last - 1.
    [[nodiscard]] std::vector<KeyType> copied(std::size_t first, std::size_t last) const;
    /// Index of the first key not before \p time; size() where there is none.
    [[nodiscard]] std::size_t lowerBound(Ticks time) const;
    /// Index of the first key behind \p ticks.
    [[nodiscard]] std::size_t upperBound(double ticks) const;

    /// Takes other keys; pages that hold the same as before stay.
    void assign(std::span<const KeyType> keys);
    /// Puts \p keys in the place of the keys first .. last - 1. \pre first <= last <= size()
    void splice(std::size_t first, std::size_t last, std::span<const KeyType> keys);

    /// Changes keys in their places. \param indices ascending, each once; as many as \p keys
    void overwrite(std::span<const std::size_t> indices, std::span<const KeyType> keys);
    /// The same for those from \p first on; pages that would not change stay.
    void overwrite(std::size_t first, std::span<const KeyType> keys);

    /// Calls \p visit(address, bytes) for the memory of each page: lists that share a page say the same
    /// address.
    template <class Visit> void eachPage(Visit&& visit) const
    {
        for (const PageRef& ref : m_pages)
            visit(ref.page.get(), ref.page->keys.size() * (sizeof(KeyType) + sizeof(Ticks)));
    }

    /// Pages that both share are not looked at.
    bool operator==(const KeyList& other) const;

private:
    struct Page
    {
        std::vector<KeyType> keys; ///< never empty
        std::vector<Ticks> times;  ///< theirs: close together for the search
    };
    struct PageRef
    {
        std::shared_ptr<const Page> page;
        std::size_t start = 0; ///< index of its first key
    };
    using Pages = std::vector<PageRef>;

    static void cut(std::span<const KeyType> keys, Pages& into);
    [[nodiscard]] std::size_t pageOf(std::size_t index) const
    {
        // Pages are about equally full: the guess is right, or next to it, but for much edited tracks.
        std::size_t page = m_pages.size() == 1 ? 0 : static_cast<std::size_t>(double(index) * m_pagesPerKey);
        if (m_pages[page].start <= index && index - m_pages[page].start < m_pages[page].page->keys.size())
            return page;
        return searchedPage(index);
    }
    [[nodiscard]] std::size_t searchedPage(std::size_t index) const;
    void count();

    Pages m_pages;
    std::size_t m_size = 0;
    double m_pagesPerKey = 0.0;
};

template <class KeyType> class KeyList<KeyType>::Iterator
{
public:
    using iterator_category = std::random_access_iterator_tag;
    using value_type = KeyType;
    using difference_type = std::ptrdiff_t;
    using pointer = const KeyType*;
    using reference = const KeyType&;

    Iterator() = default;
    Iterator(const KeyList* list, std::size_t index)
        : m_list(list)
        , m_index(static_cast<difference_type>(index))
    {
    }
    reference operator*() const { return (*m_list)[static_cast<std::size_t>(m_index)]; }
    pointer operator->() const { return &**this; }
    reference operator[](difference_type by) const { return *(*this + by); }
    Iterator& operator++() { return *this += 1; }
    Iterator& operator--() { return *this += -1; }
    Iterator operator++(int)
    {
        const Iterator before = *this;
        ++*this;
        return before;
    }
    Iterator operator--(int)
    {
        const Iterator before = *this;
        --*this;
        return before;
    }
    Iterator& operator+=(difference_type by)
    {
        m_index += by;
        return *this;
    }
    Iterator& operator-=(difference_type by) { return *this += -by; }
    friend Iterator operator+(Iterator it, difference_type by) { return it += by; }
    friend Iterator operator+(difference_type by, Iterator it) { return it += by; }
    friend Iterator operator-(Iterator it, difference_type by) { return it -= by; }
    friend difference_type operator-(const Iterator& a, const Iterator& b) { return a.m_index - b.m_index; }
    bool operator==(const Iterator& other) const { return m_index == other.m_index; }
    std::strong_ordering operator<=>(const Iterator& other) const { return m_index <=> other.m_index; }

private:
    const KeyList* m_list = nullptr;
    difference_type m_index = 0;
};

extern template class KeyList<Key>;
extern template class KeyList<OrientationKey>;

} // namespace ramure
