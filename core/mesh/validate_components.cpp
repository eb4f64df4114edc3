#include "core/mesh/validate_parts.h"
#include <algorithm>

namespace ramure::validation {

ComponentFinder::ComponentFinder(Index vertices)
    : m_label(vertices)
{
    std::fill_n(m_label.data(), vertices, 0u);
}

Index ComponentFinder::newLabel()
{
    m_parent.push_back(static_cast<Index>(m_parent.size()));
    return static_cast<Index>(m_parent.size());
}

Index ComponentFinder::rootOf(Index label)
{
    while (m_parent[label] != label)
        label = m_parent[label] = m_parent[m_parent[label]];
    return label;
}

void ComponentFinder::joinAll(const Index* neighbours, Index count, Index label)
{
    Index root = rootOf(label);
    for (Index i = 0; i < count; ++i) {
        if (m_label[neighbours[i]] == 0)
            continue;
        // The smaller label is the parent: the number of a component does not depend on the order of its
        // edges.
        const Index other = rootOf(m_label[neighbours[i]] - 1u);
        m_parent[std::max(root, other)] = std::min(root, other);
        root = std::min(root, other);
    }
}

Components ComponentFinder::finish()
{
    Components out;
    // Parents come before their children, and have their number when these ask for it.
    for (Index label = 0; label < m_parent.size(); ++label)
        m_parent[label] = m_parent[label] == label ? out.count++ : m_parent[m_parent[label]];
    for (std::size_t v = 0; v < m_label.size(); ++v)
        m_label[v] = m_label[v] == 0 ? noIndex : m_parent[m_label[v] - 1u];
    out.of = std::move(m_label);
    return out;
}

} // namespace ramure::validation
