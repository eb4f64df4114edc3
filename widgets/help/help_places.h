/// \file
/// Where the handbook speaks of a part of the window: what F1 opens.
#pragma once

#include <QList>
#include <QString>

class QWidget;

namespace ramure {

/// Of a widget that says itself where help about it is.
inline constexpr const char* helpPlaceProperty = "helpPlace";

/// The place ("page#anchor") of the widget or of the nearest one around it that has one; empty: none has.
QString helpPlace(const QWidget* widget);
/// Of the parameter under the mouse, else of what has the focus, else of what is under the mouse.
QString helpPlaceHere();
/// Every place that a widget leads to which does not say it itself.
QList<QString> helpPlaces();

} // namespace ramure
