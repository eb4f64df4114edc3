#include "core/surface/mesher/fork_untangle.h"

#include <algorithm>
#include <glm/common.hpp>
#include <limits>
#include <tuple>

namespace ramure {

namespace {

constexpr int mostRounds = 24, patience = 8; ///< rounds, and those without gain
constexpr double step = 0.6;                 ///< of the way to the middle of the neighbours

} // namespace

/// Edges once for each triangle they are of; what has but one is the border.
void ForkUntangler::prepare(const ForkCheck& check, const MeshSink& sink, Index firstFree)
{
    m_edges.clear();
    Index last = 0;
    m_first = noIndex;
    for (const Index face : check.faces()) {
        const glm::uvec3& t = sink.triangles[face];
        for (int k = 0; k < 3; ++k) {
            m_edges.push_back({t[k], t[(k + 1) % 3]});
            m_first = std::min(m_first, t[k]);
            last = std::max(last, t[k]);
        }
    }
    const std::size_t count = last - m_first + 1;
    m_isFixed.assign(count, 0);
    std::fill_n(m_isFixed.begin(), std::min<std::size_t>(count, firstFree - std::min(firstFree, m_first)), 1);
    std::vector<Edge> sorted = m_edges;
    for (Edge& edge : sorted)
        if (edge.from > edge.to)
            std::swap(edge.from, edge.to);
    const auto key = [](const Edge& edge) { return std::tuple(edge.from, edge.to); };
    std::ranges::sort(sorted, {}, key);
    for (std::size_t i = 0; i < sorted.size();) {
        std::size_t next = i + 1;
        while (next < sorted.size() && key(sorted[next]) == key(sorted[i]))
            ++next;
        if (next == i + 1)
            m_isFixed[sorted[i].from - m_first] = m_isFixed[sorted[i].to - m_first] = 1;
        i = next;
    }
}

/// Around the triangles. False where nothing is free to move.
bool ForkUntangler::smooth(MeshSink& sink, const std::vector<Index>& tangled)
{
    enum : std::uint8_t { Away, Beside, Tangled };
    m_state.assign(m_isFixed.size(), Away);
    for (const Index face : tangled)
        for (int k = 0; k < 3; ++k)
            m_state[sink.triangles[face][k] - m_first] = Tangled;
    m_sum.assign(m_isFixed.size(), glm::dvec4(0.0));
    for (const Edge& edge : m_edges) {
        std::uint8_t& from = m_state[edge.from - m_first];
        std::uint8_t& to = m_state[edge.to - m_first];
        if (from == Tangled || to == Tangled) {
            from = std::max<std::uint8_t>(from, Beside);
            to = std::max<std::uint8_t>(to, Beside);
        }
        m_sum[edge.from - m_first] += glm::dvec4(sink.positions[edge.to], 1.0);
    }
    bool moved = false;
    for (std::size_t v = 0; v < m_isFixed.size(); ++v) {
        if (m_state[v] == Away || m_isFixed[v])
            continue;
        glm::vec3& position = sink.positions[m_first + v];
        const glm::dvec3 middle = glm::dvec3(m_sum[v]) / m_sum[v].w;
        position = glm::vec3(glm::mix(glm::dvec3(position), middle, step));
        moved = true;
    }
    return moved;
}

void ForkUntangler::untangle(const ForkCheck& check, MeshSink& sink, Index firstFree)
{
    prepare(check, sink, firstFree);
    const auto begin = sink.positions.begin() + m_first;
    const auto end = begin + std::ptrdiff_t(m_isFixed.size());
    m_best.assign(begin, end);
    std::vector<Index> tangled;
    std::size_t least = std::numeric_limits<std::size_t>::max();
    for (int round = 0, idle = 0; round < mostRounds && idle < patience && least > 0; ++round, ++idle) {
        tangled.clear();
        // What begins with more pairs than triangles is a knot, which stays one.
        check.find(sink, round == 0 ? check.faceCount() + 1 : std::numeric_limits<std::size_t>::max(),
                   tangled);
        if (round == 0 && tangled.size() / 2 > check.faceCount())
            return;
        if (tangled.size() / 2 < least) {
            least = tangled.size() / 2;
            m_best.assign(begin, end);
            idle = 0;
        }
        if (least == 0 || !smooth(sink, tangled))
            break;
    }
    std::ranges::copy(m_best, begin);
}

} // namespace ramure
