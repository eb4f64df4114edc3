/// \file
/// A real window with a viewport of a document, for suites of label gl.
#pragma once

#include "core/qt/document/document.h"
#include "widgets/view/viewport.h"
#include "widgets/view/viewport_host.h"
#include <QApplication>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>

namespace ramure::test {

struct ViewWindow
{
    Document document;
    ViewportHost host{&document};
    Viewport* view = host.viewport();

    /// Waits for the first picture. Fill the document before.
    void show(QSize size)
    {
        host.resize(size);
        host.show();
        if (!QTest::qWaitForWindowExposed(&host))
            qWarning("the window does not appear");
        waitForPicture();
    }
    /// Of the document as it is now.
    void waitForPicture() const
    {
        QSignalSpy drawn(view, &Viewport::frameDrawn);
        view->update();
        if (!QTest::qWaitFor([&] { return !drawn.isEmpty() && !view->work().picture; }, 120'000))
            qWarning("no picture of now comes");
    }
    /// Of the document as it is now, as good as was chosen.
    [[nodiscard]] QImage pictureAtRest() const
    {
        waitForPicture();
        if (!QTest::qWaitFor([&] { return !view->work().settling && !view->work().parts; }, 120'000))
            qWarning("the picture does not come to rest");
        return view->grabFramebuffer();
    }
    /// Where a point of the world is on the widget.
    [[nodiscard]] QPoint pixelOf(const glm::dvec3& world) const
    {
        const double aspect = double(view->width()) / view->height();
        const glm::dvec2 ndc = *view->camera().project(world, aspect);
        return {qRound(0.5 * (ndc.x + 1.0) * view->width()), qRound(0.5 * (1.0 - ndc.y) * view->height())};
    }
    /// The mouse with a button held.
    void move(QPointF to, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) const
    {
        QMouseEvent event(QEvent::MouseMove, to, view->mapToGlobal(to), Qt::NoButton, button, modifiers);
        QApplication::sendEvent(view, &event);
    }
    /// The picture of now, where RAMURE_PICTURES names a folder for such.
    void keep(const char* name) const
    {
        const QString folder = qEnvironmentVariable("RAMURE_PICTURES");
        if (!folder.isEmpty())
            view->grabFramebuffer().save(folder + u'/' + QLatin1String(name) + QLatin1String(".png"));
    }
};

/// How many points of two pictures differ.
inline int differing(const QImage& a, const QImage& b)
{
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            count += a.pixel(x, y) != b.pixel(x, y);
    return count;
}

} // namespace ramure::test
