/// \file
/// The mouse cursors of the tools that shape trees: a cross with the tool's icon beside it.
#pragma once

#include "widgets/view/tools/hand_settings.h"
#include <QCursor>

namespace ramure {

/// \pre not None. A plain cross where there is no icon. To be kept: it is drawn each time.
QCursor handCursor(HandTool tool);

} // namespace ramure
