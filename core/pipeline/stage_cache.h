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
    static constexpr std::size_t budgetBytes = std::size_t(256) << 20;

    /// Null where it is not kept.
    std::shared_ptr<const T> find(std::uint64_t hash)
    {
        const auto entry = std::ranges::find(m_entries, hash, &Entry::hash);
        if (entry == m_entries.end())
            return nullptr;
        m_entries.splice(m_entries.begin(), m_entries, entry);
        return m_entries.front().result;
    }
    void keep(std::uint64_t hash, std::shared_ptr<const T> result, std::size_t bytes)
    {
        m_entries.push_front({hash, std::move(result), bytes});
        m_bytes += bytes;
        shrink();
    }
    void setCapacity(std::size_t capacity)
    {
        m_capacity = std::max<std::size_t>(capacity, 1);
        shrink();
    }
    [[nodiscard]] std::size_t size() const { return m_entries.size(); }

private:
    struct Entry
    {
        std::uint64_t hash;
        std::shared_ptr<const T> result;
        std::size_t bytes;
    };

    void shrink()
    {
        while (m_entries.size() > 1 && (m_entries.size() > m_capacity || m_bytes > budgetBytes)) {
            m_bytes -= m_entries.back().bytes;
            m_entries.pop_back();
        }
    }

    std::list<Entry> m_entries; ///< newest first
    std::size_t m_capacity = 8;
    std::size_t m_bytes = 0;
};

} // namespace ramure
