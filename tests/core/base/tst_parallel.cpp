#include "core/base/parallel.h"
#include "tests/support/suite.h"
#include <atomic>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace tst_parallel {

using namespace ramure;

class TestParallel : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void anExceptionReachesTheCallerAndTheRestIsDone()
    {
        for (const unsigned threads : {1u, 4u}) {
            const ThreadLimit limit(threads);
            std::vector<int> done(1000, 0);
            const auto loop = [&] {
                parallelFor(done.size(), 10, [&](std::size_t begin, std::size_t end) {
                    if (begin == 500)
                        throw std::runtime_error("here");
                    for (std::size_t i = begin; i < end; ++i)
                        ++done[i];
                });
            };
            QVERIFY_EXCEPTION_THROWN(loop(), std::runtime_error);
            for (std::size_t i = 0; i < done.size(); ++i)
                QCOMPARE(done[i], i >= 500 && i < 510 ? 0 : 1);
        }
    }
    void everyNumberOnce()
    {
        for (const unsigned threads : {0u, 1u, 2u, 4u, 64u})
            for (const std::size_t count : {0u, 1u, 6u, 7u, 8u, 10007u})
                for (const std::size_t grain : {0u, 1u, 7u, 100000u}) {
                    const ThreadLimit limit(threads);
                    std::vector<int> visits(count, 0);
                    parallelFor(count, grain, [&](std::size_t begin, std::size_t end) {
                        for (std::size_t i = begin; i < end; ++i)
                            ++visits[i];
                    });
                    QCOMPARE(visits, std::vector<int>(count, 1));
                }
    }
    void chunksDependOnTheLengthAlone()
    {
        const auto borders = [](unsigned threads) {
            const ThreadLimit limit(threads);
            std::mutex mutex;
            std::set<std::pair<std::size_t, std::size_t>> out;
            parallelFor(1003, 10, [&](std::size_t begin, std::size_t end) {
                const std::scoped_lock lock(mutex);
                out.emplace(begin, end);
            });
            return out;
        };
        QVERIFY(borders(1) == borders(2));
        QVERIFY(borders(1) == borders(4));
        QVERIFY(borders(1).contains({1000, 1003}));
    }
    void aLoopInsideOfALoop()
    {
        const ThreadLimit limit(3);
        std::atomic<int> sum = 0;
        parallelFor(20, 1, [&](std::size_t, std::size_t) {
            QCOMPARE(parallelThreads(), 1u);
            parallelFor(20, 1, [&](std::size_t, std::size_t) { ++sum; });
        });
        QCOMPARE(sum.load(), 400);
        QCOMPARE(parallelThreads(), 3u);
    }
    void loopsFromSeveralThreadsAtOnce()
    {
        std::atomic<int> sum = 0;
        {
            std::vector<std::jthread> callers;
            for (int t = 0; t < 4; ++t)
                callers.emplace_back([&] {
                    for (int i = 0; i < 200; ++i)
                        parallelFor(50, 3, [&](std::size_t begin, std::size_t end) {
                            sum += static_cast<int>(end - begin);
                        });
                });
        }
        QCOMPARE(sum.load(), 4 * 200 * 50);
    }
    void limitsNest()
    {
        const unsigned before = parallelThreads();
        QVERIFY(before >= 1);
        {
            const ThreadLimit one(1);
            QCOMPARE(parallelThreads(), 1u);
            const ThreadLimit machine(0);
            QCOMPARE(parallelThreads(), before);
        }
        QCOMPARE(parallelThreads(), before);
    }
};

RAMURE_SUITE(TestParallel)

} // namespace tst_parallel

#include "tst_parallel.moc"
