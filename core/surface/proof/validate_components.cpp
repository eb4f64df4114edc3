#include "core/surface/proof/validate_parts.h"

namespace ramure::validation {

ComponentFinder::ComponentFinder(Index vertices)
    : m_piece(vertices)
{
}

Index ComponentFinder::rootOf(Index piece)
{
    while (m_parent[piece] != piece)
        piece = m_parent[piece] = m_parent[m_parent[piece]];
    return piece;
}

/// False where they were one already.
bool ComponentFinder::join(Index a, Index b)
{
    if (m_parent[a] == m_parent[b])
        return false;
    a = rootOf(a);
    b = rootOf(b);
    // The smaller one is the parent: the order of the edges does not matter.
    m_parent[std::max(a, b)] = std::min(a, b);
    return a != b;
}

void ComponentFinder::visit(Index v, const Index* neighbours, Index count)
{
    const Index begin = m_runs.back().begin;
    const bool continues =
        std::any_of(neighbours, neighbours + count, [&](Index n) { return n >= begin && n < v; });
    if (!continues) {
        m_runs.push_back({v, static_cast<Index>(m_parent.size())});
        m_parent.push_back(m_runs.back().piece);
        m_piece[v] = m_runs.back().piece;
    }
    bool areNewlyJoined = false;
    for (Index i = 0; i < count; ++i)
        if (neighbours[i] < m_runs.back().begin)
            areNewlyJoined |= join(m_runs.back().piece, m_piece[neighbours[i]]);
    while (areNewlyJoined && m_runs.size() > 2 &&
           rootOf(m_runs.back().piece) == rootOf(m_runs[m_runs.size() - 2].piece))
        m_runs.pop_back();
}

Components ComponentFinder::finish()
{
    Components out;
    // Parents come before their children, and have their number when these ask for it.
    for (Index piece = 0; piece < m_parent.size(); ++piece)
        m_parent[piece] = m_parent[piece] == piece ? out.count++ : m_parent[m_parent[piece]];
    if (out.count <= 1)
        return out;
    for (std::size_t v = 0; v < m_piece.size(); ++v)
        m_piece[v] = m_piece[v] == noIndex ? noIndex : m_parent[m_piece[v]];
    out.of = std::move(m_piece);
    return out;
}

} // namespace ramure::validation
