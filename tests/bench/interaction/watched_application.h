/// \file
/// An application that knows how long each event holds the interface up, and how much of that was the
/// software rasteriser, which a graphics card would spare.
#pragma once

#include "core/base/stopwatch.h"
#include <QApplication>

namespace ramure {
class Viewport;
}

namespace ramure::bench {

class WatchedApplication : public QApplication
{
public:
    using QApplication::QApplication;

    bool notify(QObject* receiver, QEvent* event) override;
    /// Whose drawing does not count.
    void watch(Viewport* view);
    /// Time since the start that went into drawing and composing, on this thread.
    [[nodiscard]] Elapsed rasterised() const { return m_rasterised; }
    /// The longest event since the last call, without drawing.
    Elapsed takeLongestBlock();
    /// What that event was.
    [[nodiscard]] QString longestName() const { return m_longestName; }

private:
    bool paintView(QEvent* event);

    QWidget* m_view = nullptr;
    Elapsed m_rasterised;
    Elapsed m_longest;
    QString m_longestName;
    Stopwatch m_composing;
    int m_depth = 0;
};

} // namespace ramure::bench
