#include "widgets/view/viewport_hint.h"

#include <QCoreApplication>
#include <QStringList>

namespace ramure {
namespace {

using Under = ViewportSituation::Under;

struct Words
{
    Q_DECLARE_TR_FUNCTIONS(ViewportHint)
};

QString joined(const QStringList& parts)
{
    return parts.join(QStringLiteral(" · "));
}

QString gestureHint(const ViewportSituation& now)
{
    switch (now.gesture) {
    case Gesture::Select:
        return Words::tr("Everything in the box is selected · Shift: added");
    case Gesture::Pull:
        return Words::tr("The branch is pulled · release: it swings back");
    case Gesture::Wind:
        return Words::tr("Length: strength of the wind · release: done");
    case Gesture::Limb:
        return now.wholeLimb
                   ? Words::tr("The limb and what is thick follow · wheel: how many branches · Esc: back")
                   : Words::tr("The limb follows · wheel: how many branches · Shift: trunk and root, too · "
                               "Esc: back");
    case Gesture::Aim:
        return Words::tr("The arm reaches for the point under the cursor · release: done");
    case Gesture::Ring:
        return Words::tr("The joint turns · release: done");
    case Gesture::None:
        break;
    }
    return {};
}

/// While Alt is held every button moves the camera.
QString altHint(const ViewportSituation& now)
{
    return now.style == NavigationStyle::Maya
               ? Words::tr(
                     "Alt: drag turns (with Shift: moves, with Ctrl: zooms) · middle: moves · right: zooms")
               : Words::tr("Alt: drag turns (with Shift: moves, with Ctrl: zooms) · right: zooms");
}

QString controlHint(const ViewportSituation& now)
{
    QStringList parts;
    if (now.under == Under::Branch)
        parts << (now.playing ? Words::tr("Ctrl: drag pulls the branch")
                              : Words::tr("Ctrl: drag bends the limb (with Shift: trunk and root, too)"));
    if (now.under == Under::Surface)
        parts << Words::tr("Ctrl: click or drag sets the target of the arm");
    if (now.style == NavigationStyle::Blender)
        parts << Words::tr("Ctrl + middle: zoom");
    return joined(parts);
}

QString shiftHint(const ViewportSituation& now)
{
    QStringList parts{now.under == Under::Nothing
                          ? Words::tr("Shift: drag adds a box")
                          : Words::tr("Shift: click adds or takes away, drag adds a box")};
    if (now.style == NavigationStyle::Blender)
        parts << Words::tr("Shift + middle: move the view");
    return joined(parts);
}

QString selectHint(const ViewportSituation& now)
{
    switch (now.under) {
    case Under::Branch:
        return now.playing ? Words::tr("Drag: pull the branch · double click an apple: it falls")
                           : Words::tr("Click: branch and tree · Ctrl + drag: bend the limb");
    case Under::Surface:
        return Words::tr("Click: select · Ctrl + click: target of the arm");
    case Under::Node:
        return Words::tr("Click: select");
    case Under::Nothing:
    case Under::Ring:
        break;
    }
    return Words::tr("Click: select nothing");
}

/// Nothing is held, no gesture goes on.
QString restHint(const ViewportSituation& now)
{
    if (now.under == Under::Ring)
        return Words::tr("Drag: turn the joint");
    QStringList parts{selectHint(now)};
    if (!now.target.isEmpty() && !now.keys.isEmpty())
        parts << Words::tr("%1: move, rotate, scale %2").arg(now.keys, now.target);
    parts << Words::tr("right: menu") << Words::tr("Shift: add") << Words::tr("drag: box")
          << (now.style == NavigationStyle::Maya ? Words::tr("Alt + drag: turn the view")
                                                 : Words::tr("middle or Alt: turn the view"));
    return joined(parts);
}

} // namespace

QString viewportHint(const ViewportSituation& now)
{
    const bool goesOn = now.gesture != Gesture::None && (now.gesture != Gesture::Select || now.dragging);
    if (goesOn)
        return gestureHint(now);
    if (now.under == Under::Ring)
        return restHint(now);
    if (now.held.testFlag(Qt::AltModifier))
        return altHint(now);
    if (now.held.testFlag(Qt::ControlModifier))
        return controlHint(now);
    if (now.held.testFlag(Qt::ShiftModifier))
        return shiftHint(now);
    return restHint(now);
}

} // namespace ramure
