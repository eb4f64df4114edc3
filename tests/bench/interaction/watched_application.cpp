#include "tests/bench/interaction/watched_application.h"

#include "widgets/view/viewport.h"
#include <QEvent>
#include <QMetaEnum>
#include <algorithm>

namespace ramure::bench {

bool WatchedApplication::notify(QObject* receiver, QEvent* event)
{
    if (receiver == m_view && event->type() == QEvent::Paint)
        return paintView(event);
    if (m_depth > 0)
        return QApplication::notify(receiver, event);
    const int type = event->type();
    QString name = QString::fromLatin1(receiver->metaObject()->className());
    if (receiver->parent() && !receiver->isWidgetType())
        name.prepend(QLatin1String(receiver->parent()->metaObject()->className()) + QLatin1Char('/'));
    const Elapsed before = m_rasterised;
    const Stopwatch watch;
    ++m_depth;
    const bool done = QApplication::notify(receiver, event);
    --m_depth;
    const Elapsed took = watch.elapsed() - (m_rasterised - before);
    m_longest.cpuMs = std::max(m_longest.cpuMs, took.cpuMs);
    if (took.wallMs > m_longest.wallMs) {
        m_longest.wallMs = took.wallMs;
        const char* typeName = QMetaEnum::fromType<QEvent::Type>().valueToKey(type);
        m_longestName = name + QLatin1Char(' ') + QLatin1String(typeName ? typeName : "?");
    }
    return done;
}

/// Around the drawing itself Qt clears and flushes, which llvmpipe does with the same vertices and pixels.
bool WatchedApplication::paintView(QEvent* event)
{
    const Elapsed before = m_rasterised;
    const Stopwatch watch;
    const bool done = QApplication::notify(m_view, event);
    m_rasterised += watch.elapsed() - (m_rasterised - before);
    return done;
}

void WatchedApplication::watch(Viewport* view)
{
    m_view = view;
    connect(view, &Viewport::frameDrawn, this, [this](const FrameTimes& times) {
        m_rasterised += {times.drawMs, times.drawCpuMs};
    });
    connect(view, &QOpenGLWidget::aboutToCompose, this, [this] { m_composing.restart(); });
    connect(view, &QOpenGLWidget::frameSwapped, this, [this] { m_rasterised += m_composing.elapsed(); });
}

Elapsed WatchedApplication::takeLongestBlock()
{
    m_longestName = m_longest.wallMs > 0.0 ? m_longestName : QString();
    return std::exchange(m_longest, Elapsed());
}

} // namespace ramure::bench
