/// \file
/// The button beside a number that may have keys.
#pragma once

#include "core/qt/document/key_state.h"
#include <QIcon>

class QToolButton;

namespace ramure {

inline constexpr int keyButtonSide = 22; ///< no smaller than what a hand hits at once

/// Hidden.
QToolButton* newKeyButton(QWidget* parent);
QIcon keyIcon(KeyState state);

} // namespace ramure
