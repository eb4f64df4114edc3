/// \file
/// Names and pictures of what keys have, in the interface's language and colours.
#pragma once

#include "core/rig/tracks/channel.h"
#include "widgets/base/texts/number_format.h"
#include <QIcon>
#include <QString>

class QPainter;
class QPointF;
class QPalette;

namespace ramure {

QString keyModeText(KeyMode mode);
QString keyModeTip(KeyMode mode);
QString easingText(Easing easing);
QString handleTypeText(HandleType type);
QString extrapolationText(Extrapolation extrapolation);
/// "Location X", "Colour: red", "Wind strength".
QString channelText(const Channel& channel);

/// How its values are shown: metres, degrees, the parameter's unit. Values of orientations are their angles,
/// rad.
NumberFormat channelFormat(const Channel& channel);

/// A small picture of the way from a key to the next.
QIcon keyModeIcon(KeyMode mode, Easing easing, const QPalette& palette);
/// Red, green, blue by component; orientations and single numbers have their own.
QColor channelColour(const Channel& channel, const QPalette& palette);

/// What a key looks like: square = stays, diamond = straight, circle = Bezier or spline, hourglass = easing.
/// \param side of the square around it, logical pixels.
void paintKey(QPainter& painter, const QPointF& centre, double side, KeyMode mode);

} // namespace ramure
