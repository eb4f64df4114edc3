#include "core/qt/session/jobs/job.h"
#include "tests/support/suite.h"
#include "tests/support/waits.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QSignalSpy>
#include <QThread>
#include <atomic>
#include <new>
#include <stdexcept>
#include <thread>

namespace tst_job {

using namespace ramure;
using namespace std::chrono_literals;

namespace {

/// A door that works wait at; they own it, as it may be opened when the test is over.
struct Gate
{
    void pass() const
    {
        while (!isOpen)
            test::work(0.1);
    }
    std::atomic<bool> isOpen = false;
    std::atomic<int> reached = 0;
};

/// Counts the events for one object, also when there is no object any more.
class EventsFor : public QObject
{
public:
    explicit EventsFor(const void* object)
        : m_object(object)
    {
        QCoreApplication::instance()->installEventFilter(this);
    }
    int count = 0;

protected:
    bool eventFilter(QObject* object, QEvent* event) override
    {
        count += object == m_object ? 1 : 0;
        return QObject::eventFilter(object, event);
    }

private:
    const void* m_object;
};

Expected<int> seven(const Progress& /*progress*/)
{
    return 7;
}

} // namespace

class TestJob : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void nothingWasStarted();
    void errorsAreTold();
    void outOfMemoryIsAnError();
    void anyOtherExceptionIsAnError();
    void cancelledBeforeItBegan();
    void aResultAfterCancelIsDropped();
    void anOwnerThatGoesIsToldNothing();
    void anOwnerDoesNotWaitForAWorkThatNeverLooks();
    void manyOwnersWaitNoLongerThanOne();
    void anOwnerMayGoWhileItIsTold();
    void resultsArriveOnTheOwnersThread();
    void forgottenWorkIsNotTold();
    void theLatestOfAStormWins();
    void whatWasBegunEndsWhereItGoesOn();
    void lowerLanesComeFirst();
    void progressComesFromTheThread();
    void messagesKeepTheirOrder();
    void waitingHandsOverTheResult();
};

void TestJob::nothingWasStarted()
{
    Job job;
    QVERIFY(!job.cancel());
    job.forget();
    QVERIFY(!job.withdraw());
    QVERIFY(!job.isRunning());
    QVERIFY(job.wait());
    Job::stopAll();
    QCOMPARE(Job::abandonedCount(), 0);
}

void TestJob::errorsAreTold()
{
    Job job;
    QSignalSpy finished(&job, &Job::finished);
    job.start([](const Progress& /*progress*/) -> Expected<void> { return fail(ErrorCode::Io, "no room"); });
    QVERIFY(finished.wait());
    const auto error = finished.at(0).at(0).value<std::optional<Error>>();
    QVERIFY(error && error->code == ErrorCode::Io && error->plain() == "no room");
    QVERIFY(!job.isRunning());
}

void TestJob::outOfMemoryIsAnError()
{
    Job job;
    std::optional<Expected<int>> result;
    const auto take = [&](const Expected<int>& made) { result = made; };
    job.start([](const Progress& /*progress*/) -> Expected<int> { throw std::bad_alloc(); }, take);
    QTRY_VERIFY(result);
    QVERIFY(!*result && result->error().code == ErrorCode::Limit);
    job.start(&seven, take); // the thread goes on
    QTRY_VERIFY(*result);
}

void TestJob::anyOtherExceptionIsAnError()
{
    Job job;
    std::vector<Error> errors;
    const auto take = [&](const Expected<int>& made) { errors.push_back(made.error()); };
    job.start([](const Progress& /*progress*/) -> Expected<int> { throw std::length_error("too long"); },
              take);
    QTRY_COMPARE(errors.size(), std::size_t(1));
    QCOMPARE(errors[0].code, ErrorCode::Invalid);
    QVERIFY(QString::fromStdString(errors[0].message()).contains(QStringLiteral("too long")));
    job.start([](const Progress& /*progress*/) -> Expected<int> { throw 3; }, take);
    QTRY_COMPARE(errors.size(), std::size_t(2));
    QCOMPARE(errors[1].code, ErrorCode::Invalid);
}

void TestJob::cancelledBeforeItBegan()
{
    const auto gate = std::make_shared<Gate>();
    Job job;
    std::vector<ErrorCode> codes;
    const auto take = [&](const Expected<int>& made) {
        codes.push_back(made ? ErrorCode::Unknown : made.error().code);
    };
    job.start(
        [gate](const Progress& /*progress*/) -> Expected<int> {
            gate->pass();
            return 1;
        },
        take, Job::Running::GoesOn, 1);
    job.start(&seven, take);
    job.cancel();
    gate->isOpen = true;
    QTRY_COMPARE(codes.size(), std::size_t(2));
    QVERIFY(codes == (std::vector{ErrorCode::Cancelled, ErrorCode::Unknown}));
}

void TestJob::aResultAfterCancelIsDropped()
{
    const auto gate = std::make_shared<Gate>();
    Job job;
    std::optional<Expected<int>> result;
    job.start(
        [gate](const Progress& /*progress*/) -> Expected<int> {
            ++gate->reached;
            gate->pass();
            return 5;
        },
        [&](const Expected<int>& made) { result = made; });
    QTRY_COMPARE(gate->reached.load(), 1);
    QVERIFY(!job.cancel(0, 1h)); // young enough to go on
    QVERIFY(job.cancel());
    QVERIFY(!job.cancel()); // asked already
    QVERIFY(job.isRunning());
    gate->isOpen = true;
    QTRY_VERIFY(result);
    QVERIFY(!*result && result->error().code == ErrorCode::Cancelled);
    // The work may have ended already, its news on the way.
    result.reset();
    job.start(&seven, [&](const Expected<int>& made) { result = made; });
    test::work(20);
    job.cancel();
    QTRY_VERIFY(result);
    QCOMPARE(result->error().code, ErrorCode::Cancelled);
    // What a work has written is written.
    QSignalSpy finished(&job, &Job::finished);
    job.start([](const Progress& /*progress*/) { return Expected<void>(); });
    test::work(20);
    job.cancel();
    QVERIFY(finished.wait());
    QVERIFY(!finished.at(0).at(0).value<std::optional<Error>>());
}

void TestJob::anOwnerThatGoesIsToldNothing()
{
    for (int i = 0; i < 50; ++i) {
        const auto gate = std::make_shared<Gate>();
        int told = 0;
        auto job = std::make_unique<Job>();
        const EventsFor events(job.get());
        {
            const auto post = job->mailbox();
            job->start(
                [gate, post, &told](const Progress& progress) -> Expected<int> {
                    while (!progress.cancelled()) {
                        progress.report(0.5);
                        post([&told] { ++told; });
                        ++gate->reached;
                        test::work(0.05);
                    }
                    post([&told] { ++told; });
                    return 1;
                },
                [&](const Expected<int>& /*made*/) { ++told; });
            QTRY_VERIFY(gate->reached > i);
            if (i == 0)
                QTRY_VERIFY(told > 0 && events.count >= told);
            job.reset();
            told = 0;
        }
        const int before = events.count;
        QCoreApplication::processEvents();
        QCoreApplication::sendPostedEvents();
        QCOMPARE(told, 0);
        QCOMPARE(events.count, before);
    }
    QCOMPARE(Job::abandonedCount(), 0);
}

void TestJob::anOwnerDoesNotWaitForAWorkThatNeverLooks()
{
    const auto gate = std::make_shared<Gate>();
    int told = 0;
    QElapsedTimer watch;
    auto job = std::make_unique<Job>();
    const EventsFor events(job.get());
    {
        job->start(
            [gate, post = job->mailbox()](const Progress& progress) -> Expected<int> {
                ++gate->reached;
                gate->pass();
                progress.report(1.0);
                post([] { QFAIL("nobody is there"); });
                ++gate->reached;
                return 1;
            },
            [&](const Expected<int>& /*made*/) { ++told; });
        QTRY_COMPARE(gate->reached.load(), 1);
        watch.start();
        job.reset();
    }
    const auto waited = std::chrono::milliseconds(watch.elapsed());
    QVERIFY2(waited >= Job::patience - 50ms && waited < Job::patience + 400ms,
             qPrintable(QString::number(waited.count())));
    QCOMPARE(Job::abandonedCount(), 1);
    gate->isOpen = true;
    QTRY_COMPARE(Job::abandonedCount(), 0);
    QCOMPARE(gate->reached.load(), 2);
    QCoreApplication::processEvents();
    QCOMPARE(told, 0);
    QCOMPARE(events.count, 0);
}

void TestJob::manyOwnersWaitNoLongerThanOne()
{
    const auto gate = std::make_shared<Gate>();
    QElapsedTimer watch;
    {
        std::vector<std::unique_ptr<Job>> jobs;
        for (int i = 0; i < 4; ++i) {
            jobs.push_back(std::make_unique<Job>());
            jobs.back()->start([gate](const Progress& /*progress*/) -> Expected<void> {
                ++gate->reached;
                gate->pass();
                return {};
            });
        }
        QTRY_COMPARE(gate->reached.load(), 4);
        Job::stopAll();
        watch.start();
    }
    QVERIFY2(watch.elapsed() < (Job::patience + 400ms).count(), qPrintable(QString::number(watch.elapsed())));
    QCOMPARE(Job::abandonedCount(), 4);
    gate->isOpen = true;
    QTRY_COMPARE(Job::abandonedCount(), 0);
}

void TestJob::anOwnerMayGoWhileItIsTold()
{
    auto job = std::make_unique<Job>();
    job->start(&seven, [&](const Expected<int>& /*made*/) { job.reset(); });
    QTRY_VERIFY(!job);
    job = std::make_unique<Job>();
    connect(job.get(), &Job::runningChanged, this, [&](bool running) {
        if (!running)
            job.reset();
    });
    job->start(&seven, [](const Expected<int>& /*made*/) { QFAIL("it is gone"); });
    QTRY_VERIFY(!job);
}

void TestJob::resultsArriveOnTheOwnersThread()
{
    Job job(nullptr, Job::Manner::Polite);
    QSignalSpy running(&job, &Job::runningChanged);
    QThread* worked = nullptr;
    QThread* took = nullptr;
    job.start(
        [&](const Progress& /*progress*/) -> Expected<std::string> {
            worked = QThread::currentThread();
            return std::string(1000, 'a');
        },
        [&](const Expected<std::string>& made) {
            took = QThread::currentThread();
            QCOMPARE(made->size(), std::size_t(1000));
        });
    QVERIFY(job.isRunning() && !job.isRunning(1));
    QTRY_VERIFY(took);
    QVERIFY(took == thread() && worked != thread());
    QVERIFY(!job.isRunning());
    QCOMPARE(running.count(), 2);
    QVERIFY(running.at(0).at(0).toBool() && !running.at(1).at(0).toBool());
}

void TestJob::forgottenWorkIsNotTold()
{
    const auto gate = std::make_shared<Gate>();
    Job job;
    int told = 0;
    job.start(
        [gate](const Progress& progress) -> Expected<int> {
            ++gate->reached;
            while (!progress.cancelled())
                test::work(0.1);
            return 1;
        },
        [&](const Expected<int>& /*made*/) { ++told; });
    QTRY_COMPARE(gate->reached.load(), 1);
    job.forget();
    QVERIFY(!job.isRunning());
    QVERIFY(job.wait());
    QCoreApplication::processEvents();
    QCOMPARE(told, 0);
}

void TestJob::theLatestOfAStormWins()
{
    Job job;
    QSignalSpy running(&job, &Job::runningChanged);
    std::vector<int> told;
    for (int i = 0; i <= 5000; ++i)
        job.start([i](const Progress& /*progress*/) -> Expected<int> { return i; },
                  [&](const Expected<int>& made) { told.push_back(made.value()); });
    QTRY_VERIFY(!job.isRunning());
    QVERIFY(told == std::vector<int>{5000});
    QCOMPARE(running.count(), 2);
    QVERIFY(job.wait());
    QCoreApplication::processEvents();
    QCOMPARE(told.size(), std::size_t(1));
}

void TestJob::whatWasBegunEndsWhereItGoesOn()
{
    Job job;
    std::vector<int> told;
    const auto begun = std::make_shared<std::atomic<int>>(0);
    for (int i = 0; i <= 2000; ++i) {
        job.start(
            [i, begun](const Progress& progress) -> Expected<int> {
                ++*begun;
                test::work(0.2);
                if (progress.cancelled())
                    return fail(ErrorCode::Cancelled, "cancelled");
                return i;
            },
            [&](const Expected<int>& made) { told.push_back(made.value()); }, Job::Running::GoesOn);
        const std::size_t before = told.size();
        if (i % 100 == 0)
            QTRY_VERIFY(told.size() > before);
    }
    QTRY_VERIFY(!job.isRunning());
    QVERIFY(std::is_sorted(told.begin(), told.end()));
    QCOMPARE(told.back(), 2000);
    QCOMPARE(int(told.size()), begun->load());
    QVERIFY(told.size() > 5);
}

void TestJob::lowerLanesComeFirst()
{
    const auto gate = std::make_shared<Gate>();
    Job job;
    std::vector<int> told;
    const auto take = [&](const Expected<int>& made) { told.push_back(made ? *made : -1); };
    job.start(
        [gate](const Progress& /*progress*/) -> Expected<int> {
            ++gate->reached;
            gate->pass();
            return 0;
        },
        take);
    QTRY_COMPARE(gate->reached.load(), 1);
    for (const int lane : {3, 1, 2})
        job.start([lane](const Progress& /*progress*/) -> Expected<int> { return lane; }, take,
                  Job::Running::Stops, lane);
    QVERIFY(job.isRunning(2));
    QVERIFY(job.withdraw(2));
    QVERIFY(!job.withdraw(2) && !job.isRunning(2));
    gate->isOpen = true;
    QTRY_VERIFY(!job.isRunning(3));
    QVERIFY(told == (std::vector{0, 1, 3}));
}

void TestJob::progressComesFromTheThread()
{
    Job job;
    std::vector<double> fractions;
    connect(&job, &Job::progress, this, [&](double fraction) {
        QVERIFY(QThread::currentThread() == thread());
        QVERIFY(job.isRunning());
        fractions.push_back(fraction);
    });
    QSignalSpy finished(&job, &Job::finished);
    job.start([](const Progress& progress) -> Expected<void> {
        for (int i = 0; i <= 10'000; ++i)
            progress.report(i / 10'000.0);
        return {};
    });
    QVERIFY(finished.wait());
    QVERIFY(fractions.size() >= 2 && fractions.size() < 1000);
    QVERIFY(std::is_sorted(fractions.begin(), fractions.end()));
    QCOMPARE(fractions.back(), 1.0);
}

void TestJob::messagesKeepTheirOrder()
{
    Job job;
    std::vector<int> told;
    const auto post = job.mailbox();
    bool done = false;
    job.start(
        [&, post](const Progress& /*progress*/) -> Expected<int> {
            post([&] {
                told.push_back(0);
                QEventLoop loop; // a question to the user, say
                connect(&job, &Job::runningChanged, &loop, &QEventLoop::quit);
                loop.exec();
                done = true;
            });
            for (int i = 1; i <= 100; ++i)
                post([&told, i] { told.push_back(i); });
            return 101;
        },
        [&](const Expected<int>& made) { told.push_back(made.value()); });
    QTRY_VERIFY(done);
    QTRY_COMPARE(told.size(), std::size_t(102));
    QVERIFY(std::is_sorted(told.begin(), told.end()));
}

void TestJob::waitingHandsOverTheResult()
{
    const auto gate = std::make_shared<Gate>();
    Job job;
    int told = 0;
    job.start(
        [gate](const Progress& /*progress*/) -> Expected<int> {
            gate->pass();
            return 1;
        },
        [&](const Expected<int>& made) { told = made.value(); });
    QVERIFY(!job.wait(5ms));
    gate->isOpen = true;
    QVERIFY(job.wait());
    QCOMPARE(told, 1);
}

RAMURE_SUITE(TestJob)

} // namespace tst_job

#include "tst_job.moc"
