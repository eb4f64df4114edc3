#include "core/qt/document/project/project_file.h"
#include "tests/support/hand_bench.h"
#include "tests/support/suite.h"
#include <random>

namespace tst_random_gestures {

using namespace ramure;
using test::HandBench;

/// Any gestures with any tools, one after the other: what is taken back is gone to the last byte.
class TestRandomGestures : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void undoneTheyAreGone_data()
    {
        QTest::addColumn<int>("seed");
        for (int seed = 1; seed <= 12; ++seed)
            QTest::addRow("%d", seed) << seed;
    }
    void undoneTheyAreGone();

private:
    static QByteArray bytesOf(HandBench& bench) { return writeProject(bench.document.project()); }
    static void chooseOptions(HandBench& bench, std::mt19937& random)
    {
        const auto below = [&random](int most) { return static_cast<int>(random() % unsigned(most)); };
        HandOptions options = bench.hand.options();
        options.sawThickest = 0.01 * below(20);
        for (const HandChoice& row : handChoices())
            row.choose(options, below(static_cast<int>(row.items.size())));
        for (const HandFlag& row : handFlags())
            options.*row.member = below(2) == 0;
        options.copies = 1 + below(3);
        bench.hand.setOptions(options);
    }
};

void TestRandomGestures::undoneTheyAreGone()
{
    QFETCH(int, seed);
    std::mt19937 random(static_cast<unsigned>(seed));
    const auto below = [&random](int most) { return static_cast<int>(random() % unsigned(most)); };
    HandBench bench(HandTool::None);
    std::vector<QByteArray> states{bytesOf(bench)};
    for (int gesture = 0; gesture < 25; ++gesture) {
        bench.hand.setTool(handTools()[std::size_t(below(int(handTools().size())))].tool);
        chooseOptions(bench, random);
        const int before = bench.document.undoStack()->index();
        const Index branch = Index(below(int(bench.skeleton().size())));
        const QPointF at = bench.on(branch, 0.1 * below(10));
        bench.press(at);
        for (int i = below(6); i > 0; --i)
            bench.move(at + QPointF(below(300) - 150, below(300) - 150),
                       below(3) == 0 ? Qt::ControlModifier : Qt::NoModifier);
        if (below(4) == 0)
            bench.tools.wheel(bench.at(at), 120.0);
        const bool givesUp = below(6) == 0;
        if (givesUp)
            bench.key(Qt::Key_Escape);
        bench.release(at + QPointF(below(100), below(100)));
        if (bench.tools.current())
            bench.key(Qt::Key_Return);
        QVERIFY(!bench.tools.current());
        const int steps = bench.document.undoStack()->index() - before;
        QVERIFY2(steps >= 0 && steps <= 1, qPrintable(QString::number(steps)));
        if (steps == 0)
            QCOMPARE(bytesOf(bench), states.back());
        else
            states.push_back(bytesOf(bench));
        bench.grow();
    }
    QVERIFY(states.size() > 3);
    for (auto state = states.rbegin(); state != states.rend(); ++state) {
        QCOMPARE(bytesOf(bench), *state);
        bench.document.undo();
    }
    for (const QByteArray& state : states) {
        QCOMPARE(bytesOf(bench), state);
        bench.document.redo();
    }
}

RAMURE_SUITE(TestRandomGestures)

} // namespace tst_random_gestures

#include "tst_random_gestures.moc"
