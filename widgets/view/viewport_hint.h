/// \file
/// What the mouse and Shift, Ctrl, Alt do in the viewport right now, as a line of text: by the gesture that
/// goes on, by what is under the cursor, by the keys that are held. Knows no widget.
#pragma once

#include "widgets/base/navigation_style.h"
#include <QString>

namespace ramure {

enum class Gesture : quint8 {
    None,
    Select,
    Pull, ///< a branch that moves
    Wind, ///< the arrow of the wind
    Limb, ///< a branch at rest, the limb follows
    Aim,  ///< the target of an arm
    Ring, ///< an angle of one of its joints
};

struct ViewportSituation
{
    enum class Under : quint8 { Nothing, Branch, Node, Surface, Ring };

    Gesture gesture = Gesture::None;
    bool dragging = false;
    Under under = Under::Nothing; ///< Surface: an arm could be sent there
    bool playing = false;
    bool wholeLimb = false; ///< of Gesture::Limb: thick branches follow, too
    NavigationStyle style = NavigationStyle::Blender;
    Qt::KeyboardModifiers held = Qt::NoModifier;
    QString target; ///< what G, R and S move: "tree", "3 nodes"; empty: nothing
    QString keys;   ///< of these gestures: "G R S"
};

/// In the present language.
QString viewportHint(const ViewportSituation& now);

} // namespace ramure
