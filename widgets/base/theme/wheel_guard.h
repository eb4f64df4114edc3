/// \file
/// A wheel that only passes by scrolls the page and changes nothing on it.
#pragma once

class QWidget;

namespace ramure {

/// From now on the wheel neither changes the value of \p widget (a spin box, a box of choices, a slider) nor
/// gives it the focus, unless it has the focus already.
void guardFromWheel(QWidget* widget);

} // namespace ramure
