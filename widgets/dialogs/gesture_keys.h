/// \file
/// Keys that belong to no action and cannot be changed: those of gestures, and of a view while it has the
/// focus. For the list of shortcuts.
#pragma once

#include <QList>
#include <QString>

namespace ramure {

struct GestureKey
{
    QString text; ///< what it does
    QString keys; ///< as the user reads them: "Ctrl", "X, Y, Z"
};
struct GestureKeys
{
    QString title; ///< when they hold
    QList<GestureKey> keys;
};

/// In the interface's present language.
QList<GestureKeys> gestureKeys();

} // namespace ramure
