#include "core/math/assignment.h"
#include "core/math/random.h"
#include "tests/support/suite.h"

#include <algorithm>
#include <set>

namespace tst_assignment {

using namespace ramure;

namespace {

/// All ways tried out.
double leastByTrying(Index row, Index rows, std::span<const AssignmentEdge> edges, double alone,
                     std::set<Index>& taken)
{
    if (row == rows)
        return 0.0;
    double least = alone + leastByTrying(row + 1, rows, edges, alone, taken);
    for (const AssignmentEdge& edge : edges)
        if (edge.row == row && taken.insert(edge.column).second) {
            least = std::min(least, edge.cost + leastByTrying(row + 1, rows, edges, alone, taken));
            taken.erase(edge.column);
        }
    return least;
}

double costOf(const std::vector<Index>& found, std::span<const AssignmentEdge> edges, double alone)
{
    double sum = 0.0;
    for (Index row = 0; row < found.size(); ++row)
        if (found[row] == noIndex)
            sum += alone;
        else
            sum += std::ranges::find_if(edges, [&](const AssignmentEdge& edge) {
                       return edge.row == row && edge.column == found[row];
                   })->cost;
    return sum;
}

} // namespace

class TestAssignment : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void nothingToPair();
    void theGreedyWayIsNotTaken();
    void asGoodAsAnyWay();
};

void TestAssignment::nothingToPair()
{
    QVERIFY(leastCostAssignment(0, 0, {}, 1.0).empty());
    QCOMPARE(leastCostAssignment(2, 3, {}, 1.0), (std::vector<Index>{noIndex, noIndex}));
    const AssignmentEdge dear[] = {{0, 0, 2.0}};
    QCOMPARE(leastCostAssignment(1, 1, dear, 1.0), std::vector<Index>{noIndex});
}

void TestAssignment::theGreedyWayIsNotTaken()
{
    const AssignmentEdge edges[] = {{0, 0, 0.1}, {0, 1, 0.2}, {1, 0, 0.3}};
    QCOMPARE(leastCostAssignment(2, 2, edges, 1.0), (std::vector<Index>{1, 0}));
}

void TestAssignment::asGoodAsAnyWay()
{
    Random random(1, RandomStream::Test);
    for (int round = 0; round < 300; ++round) {
        const Index rows = 1 + random.below(6), columns = 1 + random.below(6);
        std::vector<AssignmentEdge> edges;
        for (Index row = 0; row < rows; ++row)
            for (Index column = 0; column < columns; ++column)
                if (random.below(3) != 0)
                    edges.push_back({row, column, random.range(0.0, 3.0)});
        const std::vector<Index> found = leastCostAssignment(rows, columns, edges, 2.0);
        std::set<Index> columnsUsed, taken;
        for (const Index column : found)
            QVERIFY(column == noIndex || columnsUsed.insert(column).second);
        QVERIFY(std::abs(costOf(found, edges, 2.0) - leastByTrying(0, rows, edges, 2.0, taken)) < 1e-9);
    }
}

RAMURE_SUITE(TestAssignment)

} // namespace tst_assignment

#include "tst_assignment.moc"
