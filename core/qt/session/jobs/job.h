/// \file
/// Long work on a thread of its own: stop token, progress, the latest request wins, and an end for every
/// case.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include <QObject>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <thread>
#include <type_traits>
#include <vector>

namespace ramure {

/// One thread that serves one request at a time. A request is work(progress), which runs on that thread and
/// returns an Expected, and take(result), which is called on the thread of this object with
/// - the result of the work, a value or an error;
/// - Cancelled in place of a value after cancel(); a work without a value (one that writes files, for
/// example) tells its own end;
/// - Limit if the memory did not suffice, Invalid if the work threw anything else.
/// take() is not called for a request that a newer one has replaced, after forget(), and once this object is
/// gone.
///
/// Requests have a lane: a newer one replaces the one that waits in its lane, and the lowest lane is served
/// first. A work owns all data that it uses: one that does not look at its stop token outlives this object.
class Job : public QObject
{
    Q_OBJECT
public:
    enum class Manner : std::uint8_t {
        Prompt,
        Polite, ///< leaves the processor to whoever else wants it, as a rule
    };
    /// What a newer request of the same lane does to the one that runs.
    enum class Running : std::uint8_t {
        Stops,  ///< and its take is not called
        GoesOn, ///< to its end
    };
    /// Has something called on the job's thread, in order with the results; never once the job is gone. From
    /// any thread.
    using Mailbox = std::function<void(std::function<void()>)>;

    /// How long the destructor waits for a work that does not look at its stop token.
    static constexpr std::chrono::milliseconds patience{500};
    static constexpr std::chrono::hours noLimit{10'000};

    explicit Job(QObject* parent = nullptr, Manner manner = Manner::Prompt);
    /// Stops what runs and waits for its end, at most for the patience: then the thread is left to itself.
    ~Job() override;

    /// Returns at once.
    template <class Work, class Take>
    void start(Work work, Take take, Running running = Running::Stops, int lane = 0);
    /// The same with finished() in place of take.
    template <class Work> void start(Work work)
    {
        start(std::move(work), [this](const Expected<void>& done) {
            emit finished(done ? std::nullopt : std::optional(done.error()));
        });
    }
    /// Takes back what waits and asks what runs to stop, unless that is younger than \p grace; both end with
    /// Cancelled. True where something that runs was asked for the first time.
    bool cancel(int lane = 0, std::chrono::milliseconds grace = {});
    /// The same, but nothing is told any more.
    void forget(int lane = 0);
    /// Takes back what waits, untold; what runs goes on. True where something waited.
    bool withdraw(int lane = 0);
    /// A request of the lane has neither ended nor been replaced or forgotten.
    [[nodiscard]] bool isRunning(int lane = 0) const;
    /// Blocks until nothing of the lane runs or waits any more, and hands over what came of it. False on
    /// time-out.
    bool wait(std::chrono::milliseconds most = noLimit, int lane = 0);
    [[nodiscard]] Mailbox mailbox() const;

    /// Asks the works of all jobs there are to stop: for a program that is about to end. Their destructors
    /// wait no longer than the patience from now on, all together.
    static void stopAll();
    /// Number of works that still run although their job is gone. A program that ends now must not destroy
    /// the data that they use.
    static int abandonedCount();

signals:
    void runningChanged(bool running); ///< with any lane
    void progress(double fraction);    ///< not more often than the eye sees
    void finished(const std::optional<ramure::Error>& error);

protected:
    bool event(QEvent* event) override;

private:
    struct Shared;
    struct Request
    {
        int lane = 0;
        std::function<std::optional<Error>(const Progress&)> work;
        std::function<void(std::optional<Error>&&)> take;
        std::stop_source stop;
        bool hasValue = true;
        bool cancelled = false; ///< only this object's thread looks
    };

    void begin(std::shared_ptr<Request> request, Running running);
    void finish(const std::shared_ptr<Request>& request, std::optional<Error>&& error);
    void stopUntold(int lane);
    bool takeBack(int lane);
    bool takeMessage();
    void updateRunning();

    std::shared_ptr<Shared> m_shared;
    std::vector<std::shared_ptr<Request>> m_pending; ///< requests whose end is still to be reported
    bool m_running = false;
    Manner m_manner;
    std::thread m_thread;
};

/// The exception that is being handled, as an error: Limit where memory did not suffice, else Invalid.
Error caughtError();

template <class Work, class Take> void Job::start(Work work, Take take, Running running, int lane)
{
    using Result = std::invoke_result_t<Work&, const Progress&>;
    auto result = std::make_shared<Result>(fail(Error()));
    auto request = std::make_shared<Request>();
    request->lane = lane;
    request->hasValue = !std::is_void_v<typename Result::value_type>;
    request->work = [result, run = std::move(work)](const Progress& progress) mutable {
        *result = run(progress);
        return *result ? std::nullopt : std::optional<Error>(result->error());
    };
    request->take = [result, call = std::move(take)](std::optional<Error>&& error) mutable {
        if (error)
            *result = fail(std::move(*error));
        call(std::move(*result));
    };
    begin(std::move(request), running);
}

} // namespace ramure
