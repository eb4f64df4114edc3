/// \file
/// Work on a thread of its own for a widget or an overlay: only what was wished for last is handed over.
#pragma once

#include "core/session/background_thread.h"
#include <QObject>
#include <utility>

namespace ramure {

class LatestWork
{
public:
    /// \p receiver owns this object: results are taken on its thread.
    explicit LatestWork(QObject* receiver)
        : m_receiver(receiver)
    {
    }
    /// \p make(stop) runs on the thread of the work, then \p take(result) on the receiver's, unless another
    /// start() or a stop() came between. Both own what they use. Returns at once.
    template <class Make, class Take> void start(Make make, Take take)
    {
        m_busy = true;
        m_thread.start([this, wish = ++m_wish, make = std::move(make),
                        take = std::move(take)](const std::stop_token& stop) {
            auto done = make(stop);
            if (stop.stop_requested())
                return;
            QMetaObject::invokeMethod(
                m_receiver,
                [this, wish, take, done = std::move(done)] {
                    if (wish != m_wish)
                        return;
                    m_busy = false;
                    take(done);
                },
                Qt::QueuedConnection);
        });
    }
    void stop()
    {
        m_thread.stop();
        m_busy = false;
        ++m_wish;
    }
    [[nodiscard]] bool isBusy() const { return m_busy; }

private:
    QObject* m_receiver;
    quint64 m_wish = 0;
    bool m_busy = false;
    BackgroundThread m_thread; ///< last: it uses the above
};

} // namespace ramure
