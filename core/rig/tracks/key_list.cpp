#include "core/rig/tracks/key_list.h"

#include <algorithm>
#include <utility>

namespace ramure {

template <class KeyType> void KeyList<KeyType>::cut(std::span<const KeyType> keys, Pages& into)
{
    const std::size_t pages = (keys.size() + mostInPage - 1) / mostInPage;
    for (std::size_t i = 0; i < pages; ++i) {
        const std::size_t from = keys.size() * i / pages, to = keys.size() * (i + 1) / pages;
        auto page = std::make_shared<Page>();
        page->keys.assign(keys.begin() + static_cast<std::ptrdiff_t>(from),
                          keys.begin() + static_cast<std::ptrdiff_t>(to));
        page->times.reserve(to - from);
        for (const KeyType& key : page->keys)
            page->times.push_back(key.time);
        into.push_back({std::move(page), 0});
    }
}

template <class KeyType> void KeyList<KeyType>::count()
{
    m_size = 0;
    for (PageRef& ref : m_pages) {
        ref.start = m_size;
        m_size += ref.page->keys.size();
    }
    m_pagesPerKey = m_size > 0 ? double(m_pages.size()) / double(m_size) : 0.0;
}

template <class KeyType> std::size_t KeyList<KeyType>::searchedPage(std::size_t index) const
{
    const auto behind =
        std::upper_bound(m_pages.begin(), m_pages.end(), index,
                         [](std::size_t wanted, const PageRef& ref) { return wanted < ref.start; });
    return static_cast<std::size_t>(behind - m_pages.begin()) - 1;
}

template <class KeyType> std::size_t KeyList<KeyType>::lowerBound(Ticks time) const
{
    // The page before the first one that begins at this time or later.
    auto page = std::lower_bound(m_pages.begin(), m_pages.end(), time, [](const PageRef& ref, Ticks wanted) {
        return ref.page->times.front() < wanted;
    });
    if (page == m_pages.begin())
        return 0;
    --page;
    const std::vector<Ticks>& times = page->page->times;
    return page->start +
           static_cast<std::size_t>(std::lower_bound(times.begin(), times.end(), time) - times.begin());
}

template <class KeyType> std::size_t KeyList<KeyType>::upperBound(double ticks) const
{
    auto page =
        std::upper_bound(m_pages.begin(), m_pages.end(), ticks, [](double wanted, const PageRef& ref) {
            return wanted < double(ref.page->times.front());
        });
    if (page == m_pages.begin())
        return 0;
    --page;
    const std::vector<Ticks>& times = page->page->times;
    const auto behind = std::upper_bound(times.begin(), times.end(), ticks,
                                         [](double wanted, Ticks key) { return wanted < double(key); });
    return page->start + static_cast<std::size_t>(behind - times.begin());
}

template <class KeyType>
std::vector<KeyType> KeyList<KeyType>::copied(std::size_t first, std::size_t last) const
{
    std::vector<KeyType> keys;
    keys.reserve(last - first);
    while (first < last) {
        const PageRef& ref = m_pages[pageOf(first)];
        const auto from = ref.page->keys.begin() + static_cast<std::ptrdiff_t>(first - ref.start);
        const std::size_t many = std::min(last - first, ref.page->keys.size() - (first - ref.start));
        keys.insert(keys.end(), from, from + static_cast<std::ptrdiff_t>(many));
        first += many;
    }
    return keys;
}

template <class KeyType> void KeyList<KeyType>::assign(std::span<const KeyType> keys)
{
    const Pages before = std::exchange(m_pages, {});
    std::size_t done = 0;
    for (const PageRef& ref : before) { // at their old places: edits of values move nothing
        const std::size_t many = std::min(ref.page->keys.size(), keys.size() - done);
        const std::span<const KeyType> part = keys.subspan(done, many);
        if (std::equal(part.begin(), part.end(), ref.page->keys.begin(), ref.page->keys.end()))
            m_pages.push_back(ref);
        else
            cut(part, m_pages);
        done += many;
    }
    cut(keys.subspan(done), m_pages);
    count();
}

template <class KeyType>
void KeyList<KeyType>::splice(std::size_t first, std::size_t last, std::span<const KeyType> keys)
{
    if (m_pages.empty())
        return assign(keys);
    constexpr std::size_t leastInPage = mostInPage / 8;
    std::size_t from = pageOf(std::min(first, m_size - 1));
    std::size_t to = last > first ? pageOf(last - 1) : from; // the last page concerned
    const auto end = [&] { return m_pages[to].start + m_pages[to].page->keys.size(); };
    // Small pages go together with a neighbour, or a track that shrinks would be all crumbs.
    if (end() - m_pages[from].start - (last - first) + keys.size() < leastInPage) {
        if (to + 1 < m_pages.size())
            ++to;
        else if (from > 0)
            --from;
    }
    std::vector<KeyType> all = copied(m_pages[from].start, first);
    all.insert(all.end(), keys.begin(), keys.end());
    const std::vector<KeyType> behind = copied(last, end());
    all.insert(all.end(), behind.begin(), behind.end());
    Pages fresh;
    cut(all, fresh);
    const auto at = m_pages.erase(m_pages.begin() + static_cast<std::ptrdiff_t>(from),
                                  m_pages.begin() + static_cast<std::ptrdiff_t>(to) + 1);
    m_pages.insert(at, std::make_move_iterator(fresh.begin()), std::make_move_iterator(fresh.end()));
    count();
}

template <class KeyType>
void KeyList<KeyType>::overwrite(std::span<const std::size_t> indices, std::span<const KeyType> keys)
{
    for (std::size_t i = 0; i < indices.size();) {
        PageRef& ref = m_pages[pageOf(indices[i])];
        auto page = std::make_shared<Page>(*ref.page);
        for (; i < indices.size() && indices[i] - ref.start < page->keys.size(); ++i) {
            page->keys[indices[i] - ref.start] = keys[i];
            page->times[indices[i] - ref.start] = keys[i].time;
        }
        ref.page = std::move(page);
    }
}

template <class KeyType> void KeyList<KeyType>::overwrite(std::size_t first, std::span<const KeyType> keys)
{
    while (!keys.empty()) {
        PageRef& ref = m_pages[pageOf(first)];
        const auto at = static_cast<std::ptrdiff_t>(first - ref.start);
        const std::size_t many = std::min(keys.size(), ref.page->keys.size() - (first - ref.start));
        const std::span<const KeyType> part = keys.first(many);
        if (!std::equal(part.begin(), part.end(), ref.page->keys.begin() + at)) {
            auto page = std::make_shared<Page>(*ref.page);
            std::copy(part.begin(), part.end(), page->keys.begin() + at);
            std::transform(part.begin(), part.end(), page->times.begin() + at,
                           [](const KeyType& key) { return key.time; });
            ref.page = std::move(page);
        }
        first += many;
        keys = keys.subspan(many);
    }
}

template <class KeyType> bool KeyList<KeyType>::operator==(const KeyList& other) const
{
    if (m_size != other.m_size)
        return false;
    std::size_t a = 0, b = 0; // pages
    for (std::size_t at = 0; at < m_size;) {
        const PageRef &mine = m_pages[a], &its = other.m_pages[b];
        const std::size_t myEnd = mine.start + mine.page->keys.size();
        const std::size_t itsEnd = its.start + its.page->keys.size();
        const std::size_t end = std::min(myEnd, itsEnd);
        const bool shared = mine.page == its.page && mine.start == its.start;
        const auto part = [at, end](const PageRef& ref) {
            return std::span<const KeyType>(ref.page->keys).subspan(at - ref.start, end - at);
        };
        const std::span<const KeyType> myPart = part(mine), itsPart = part(its);
        if (!shared && !std::equal(myPart.begin(), myPart.end(), itsPart.begin()))
            return false;
        at = end;
        a += end == myEnd ? 1 : 0;
        b += end == itsEnd ? 1 : 0;
    }
    return true;
}

template class KeyList<Key>;
template class KeyList<OrientationKey>;

} // namespace ramure
