/// \file
/// The nodes of a scene to read, in their order. Scenes that are copies of each other share them.
#pragma once

#include <compare>
#include <cstddef>
#include <iterator>
#include <memory>
#include <ranges>
#include <vector>

namespace ramure {

struct Node;

/// A view on the nodes of one scene: it lives as long as that scene.
class NodeList
{
public:
    using Pointers = std::vector<std::shared_ptr<Node>>;

    class Iterator
    {
    public:
        using iterator_category = std::random_access_iterator_tag;
        using value_type = Node;
        using difference_type = std::ptrdiff_t;
        using pointer = const Node*;
        using reference = const Node&;

        Iterator() = default;
        explicit Iterator(const std::shared_ptr<Node>* at)
            : m_at(at)
        {
        }
        reference operator*() const { return **m_at; }
        pointer operator->() const { return m_at->get(); }
        reference operator[](difference_type i) const { return *m_at[i]; }
        Iterator& operator+=(difference_type count)
        {
            m_at += count;
            return *this;
        }
        Iterator& operator-=(difference_type count) { return *this += -count; }
        Iterator& operator++() { return *this += 1; }
        Iterator& operator--() { return *this += -1; }
        Iterator operator++(int) { return Iterator(m_at++); }
        Iterator operator--(int) { return Iterator(m_at--); }
        friend Iterator operator+(Iterator at, difference_type count) { return at += count; }
        friend Iterator operator+(difference_type count, Iterator at) { return at += count; }
        friend Iterator operator-(Iterator at, difference_type count) { return at -= count; }
        friend difference_type operator-(Iterator a, Iterator b) { return a.m_at - b.m_at; }
        auto operator<=>(const Iterator&) const = default;

    private:
        const std::shared_ptr<Node>* m_at = nullptr;
    };

    explicit NodeList(const Pointers& nodes)
        : m_nodes(&nodes)
    {
    }
    [[nodiscard]] Iterator begin() const { return Iterator(m_nodes->data()); }
    [[nodiscard]] Iterator end() const { return begin() + static_cast<std::ptrdiff_t>(size()); }
    [[nodiscard]] std::size_t size() const { return m_nodes->size(); }
    [[nodiscard]] bool empty() const { return m_nodes->empty(); }
    [[nodiscard]] const Node& operator[](std::size_t i) const { return *(*m_nodes)[i]; }
    [[nodiscard]] const Node& front() const { return *m_nodes->front(); }
    [[nodiscard]] const Node& back() const { return *m_nodes->back(); }
    operator std::vector<Node>() const; ///< copies

private:
    const Pointers* m_nodes;
};

} // namespace ramure

/// Iterators outlive the view.
// The name is that of the library. NOLINTNEXTLINE(readability-identifier-naming)
template <> inline constexpr bool std::ranges::enable_borrowed_range<ramure::NodeList> = true;
