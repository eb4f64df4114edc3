/// \file
/// The button beside a number that may have keys.
#pragma once

#include "core/qt/document/key_state.h"
#include <QString>

class QToolButton;
class QWidget;

namespace ramure {

inline constexpr int keyButtonSide = 22; ///< large enough to be hit at once

/// Hidden.
QToolButton* newKeyButton(QWidget* parent);
/// Its picture, and in its tooltip what a click does. \param name of the parameter
void showKeyState(QToolButton* button, const QString& name, KeyState state);
/// What a click has done, for the status bar. \param before the state until then
QString keyToggledText(const QString& name, KeyState before, qint64 frame);

} // namespace ramure
