#include "core/base/lazy.h"
#include "tests/support/suite.h"
#include <atomic>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

namespace tst_lazy {

using namespace ramure;

class TestLazy : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void whatCannotBeMadeIsTriedAgain()
    {
        int tries = 0;
        const Lazy<int> value([&tries]() -> int {
            if (++tries == 1)
                throw std::runtime_error("not yet");
            return 7;
        });
        QVERIFY_EXCEPTION_THROWN(*value, std::runtime_error);
        QCOMPARE(*value, 7);
        QCOMPARE(tries, 2);
    }
    void nobodyAsksNothingIsMade()
    {
        bool made = false;
        const Lazy<int> value([&made] { return made = true, 1; });
        QVERIFY(!made);
        QCOMPARE(*value, 1);
        QVERIFY(made);
    }
    void itIsMadeOnceForAllThreads()
    {
        std::atomic<int> count{0};
        const auto held = std::make_shared<int>(3);
        const Lazy<std::vector<int>> value([&count, held] { return std::vector<int>(1000, ++count); });
        QCOMPARE(held.use_count(), 2L);
        std::vector<std::thread> threads;
        std::atomic<int> sum{0};
        for (int i = 0; i < 8; ++i)
            threads.emplace_back([&] { sum += value->back(); });
        for (std::thread& thread : threads)
            thread.join();
        QCOMPARE(count.load(), 1);
        QCOMPARE(sum.load(), 8);
        QCOMPARE(held.use_count(), 1L); // what it was made from is let go
    }
};

RAMURE_SUITE(TestLazy)

} // namespace tst_lazy

#include "tst_lazy.moc"
