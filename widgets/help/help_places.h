/// \file
/// The places of the handbook that describe parts of the window: F1 opens them.
#pragma once

#include <QList>
#include <QString>

class QWidget;

namespace ramure {

/// Property of a widget that names its own place in the handbook.
inline constexpr const char* helpPlaceProperty = "helpPlace";

/// The place ("page#anchor") of the widget or of the nearest one around it that has one; empty: none has.
QString helpPlace(const QWidget* widget);
/// Returns the place for the parameter under the mouse, else for the widget with the focus, else for the
/// widget under the mouse.
QString helpPlaceHere();
/// Every place that a widget leads to which does not say it itself.
QList<QString> helpPlaces();

} // namespace ramure
