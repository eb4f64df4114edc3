#include "core/math/assignment.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace ramure {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

class Assignment
{
public:
    Assignment(Index rows, Index columns, std::span<const AssignmentEdge> edges, double aloneCost)
        : m_edges(edges.begin(), edges.end())
        , m_first(rows + 1, 0)
        , m_columnOf(rows, noIndex)
        , m_rowOf(columns, noIndex)
        , m_rowPrice(rows, 0.0)
        , m_columnPrice(columns, 0.0)
        , m_distance(columns, infinite)
        , m_from(columns, noIndex)
        , m_isPassed(columns, false)
        , m_alone(aloneCost)
    {
        std::ranges::stable_sort(m_edges, {}, &AssignmentEdge::row);
        for (const AssignmentEdge& edge : m_edges)
            ++m_first[edge.row + 1];
        for (Index row = 0; row < rows; ++row)
            m_first[row + 1] += m_first[row];
    }

    std::vector<Index> run()
    {
        for (Index row = 0; row < m_columnOf.size(); ++row)
            place(row);
        return std::move(m_columnOf);
    }

private:
    using Way = std::pair<double, Index>; ///< distance and column

    /// Looks from a row at \p distance on to its columns, and at leaving it alone.
    void look(Index row, double distance)
    {
        if (const double alone = distance + m_alone - m_rowPrice[row]; alone < m_leastAlone) {
            m_leastAlone = alone;
            m_left = row;
        }
        for (Index e = m_first[row]; e < m_first[row + 1]; ++e) {
            const AssignmentEdge& edge = m_edges[e];
            if (m_isPassed[edge.column])
                continue; // rounding would find a shorter way in a circle
            const double way = distance + edge.cost - m_rowPrice[row] - m_columnPrice[edge.column];
            if (way >= m_distance[edge.column])
                continue;
            if (m_distance[edge.column] == infinite)
                m_touched.push_back(edge.column);
            m_distance[edge.column] = way;
            m_from[edge.column] = row;
            m_queue.emplace(way, edge.column);
        }
    }

    void place(Index row)
    {
        m_leastAlone = infinite;
        m_queue = {};
        std::vector<Index> passed;
        look(row, 0.0);
        Index end = noIndex;
        double whole = m_leastAlone;
        while (!m_queue.empty() && m_queue.top().first < m_leastAlone) {
            const auto [way, column] = m_queue.top();
            m_queue.pop();
            if (way > m_distance[column])
                continue;
            if (m_rowOf[column] == noIndex) {
                end = column;
                whole = way;
                break;
            }
            passed.push_back(column);
            m_isPassed[column] = true;
            look(m_rowOf[column], way);
        }
        if (end == noIndex)
            whole = m_leastAlone;
        m_rowPrice[row] += whole;
        for (const Index column : passed) {
            m_rowPrice[m_rowOf[column]] += whole - m_distance[column];
            m_columnPrice[column] -= whole - m_distance[column];
            m_isPassed[column] = false;
        }
        // Along the way back each row takes the next one's column.
        Index free = end;
        if (end == noIndex)
            free = std::exchange(m_columnOf[m_left], noIndex); // the one that is left gives up its own
        while (free != noIndex) {
            const Index taker = m_from[free];
            m_rowOf[free] = taker;
            free = std::exchange(m_columnOf[taker], free);
        }
        for (const Index column : m_touched)
            m_distance[column] = infinite;
        m_touched.clear();
    }

    std::vector<AssignmentEdge> m_edges;
    std::vector<Index> m_first; ///< of each row's edges
    std::vector<Index> m_columnOf, m_rowOf;
    std::vector<double> m_rowPrice, m_columnPrice;
    std::vector<double> m_distance; ///< by column, of the row being placed
    std::vector<Index> m_from, m_touched;
    std::vector<bool> m_isPassed; ///< columns whose rows were looked from
    std::priority_queue<Way, std::vector<Way>, std::greater<>> m_queue;
    double m_alone, m_leastAlone = 0.0;
    Index m_left = noIndex; ///< who stays alone at least cost
};

} // namespace

std::vector<Index> leastCostAssignment(Index rows, Index columns, std::span<const AssignmentEdge> edges,
                                       double aloneCost)
{
    return Assignment(rows, columns, edges, aloneCost).run();
}

} // namespace ramure
