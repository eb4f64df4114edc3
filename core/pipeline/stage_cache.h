/// \file
/// The last results of one stage, by the hash of what they were made from.
#pragma once

#include <algorithm>
#include <cstdint>
#include <list>
#include <memory>

namespace ramure {

/// Least recently used results go first: when there are more than the capacity, or when together they are
/// larger than the budget; the newest always stays.
template <class T> class StageCache
{
public:
    static constexpr std::size_t usualBudget = std::size_t(256) << 20;
    /// Tells the memory that a result holds. It is asked again each time the cache is used, because a result
    /// may grow while it is kept: a mesh gets its texture coordinates later.
    using BytesOf = std::size_t (*)(const T&);

    explicit StageCache(BytesOf bytesOf)
        : m_bytesOf(bytesOf)
    {
    }
    /// Null where it is not kept.
    std::shared_ptr<const T> find(std::uint64_t hash)
    {
        const auto entry = std::ranges::find(m_entries, hash, &Entry::hash);
        if (entry == m_entries.end())
            return nullptr;
        m_entries.splice(m_entries.begin(), m_entries, entry);
        shrink();
        return m_entries.front().result;
    }
    void keep(std::uint64_t hash, std::shared_ptr<const T> result)
    {
        m_entries.push_front({hash, std::move(result)});
        shrink();
    }
    void setCapacity(std::size_t capacity)
    {
        m_capacity = std::max<std::size_t>(capacity, 1);
        shrink();
    }
    void setBudget(std::size_t bytes)
    {
        m_budget = bytes;
        shrink();
    }
    [[nodiscard]] std::size_t size() const { return m_entries.size(); }
    /// The memory of all results that are kept.
    [[nodiscard]] std::size_t bytes() const
    {
        std::size_t sum = 0;
        for (const Entry& entry : m_entries)
            sum += m_bytesOf(*entry.result);
        return sum;
    }

private:
    struct Entry
    {
        std::uint64_t hash;
        std::shared_ptr<const T> result;
    };

    void shrink()
    {
        while (m_entries.size() > 1 && (m_entries.size() > m_capacity || bytes() > m_budget))
            m_entries.pop_back();
    }

    std::list<Entry> m_entries; ///< newest first
    std::size_t m_capacity = 8;
    std::size_t m_budget = usualBudget;
    BytesOf m_bytesOf;
};

} // namespace ramure
