/// \file
/// The dock of keys with a document, a player and the actions.
#pragma once

#include "core/qt/session/motion/player.h"
#include "tests/widgets/base/fixture.h"
#include "tests/widgets/panels/animation/key_scene.h"
#include "widgets/base/action_set.h"
#include "widgets/base/timeline_ruler.h"
#include "widgets/panels/animation/key_actions.h"
#include "widgets/panels/animation/key_commands.h"
#include "widgets/panels/animation/key_panel.h"
#include "widgets/panels/animation/key_sheet.h"

namespace ramure::test {

struct KeyDock
{
    explicit KeyDock(Scene scene)
    {
        document.reset(std::move(scene), {});
        set.setShortcuts({});
        panel.resize(1200, 500);
        panel.show();
        (void)QTest::qWaitForWindowExposed(&panel);
        panel.ruler()->showFrames(-2.0, 100.0);
    }
    KeySheet* sheet() const { return panel.sheet(); }
    QPoint at(std::size_t row, double frame) const
    {
        return {int(std::lround(panel.ruler()->xOf(frame))),
                int(sheet()->rowTop(row)) + sheet()->rowHeight() / 2};
    }
    std::size_t selected() const { return keys::count(model.selection()); }
    QByteArray bytes() const { return writeProject(document.project()); }
    int steps() const { return document.undoStack()->count(); }
    /// Frames of the keys of a channel's row.
    std::vector<double> frames(std::size_t row) const
    {
        std::vector<double> result;
        for (const Ticks time : model.rows()[row].times)
            result.push_back(secondsOf(time) * 24.0);
        return result;
    }
    void dragMouse(QPoint from, QPoint to, Qt::KeyboardModifiers modifiers = {}, bool release = true)
    {
        const auto send = [&](QEvent::Type type, QPointF place, Qt::MouseButton button,
                              Qt::MouseButtons held) {
            QMouseEvent event(type, place, sheet()->mapToGlobal(place), button, held, modifiers);
            QCoreApplication::sendEvent(sheet(), &event);
        };
        send(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
        for (int i = 1; i <= 4; ++i)
            send(QEvent::MouseMove, QPointF(from) + QPointF(to - from) * i / 4.0, Qt::NoButton,
                 Qt::LeftButton);
        if (release)
            send(QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::NoButton);
    }

    Document document;
    Player player{&document};
    ActionSet set;
    KeyModel model{&document};
    KeyCommands commands{&model, &player};
    KeyActions actions{&commands, &set};
    KeyPanel panel{&model, &commands, &actions, &player};
};

} // namespace ramure::test
