/// \file
/// What the viewport says of an arm: how far its tip is from the target and how that went.
#pragma once

#include "core/document/arm_reach.h"
#include "core/document/motion.h"

class QPainter;
class QSize;

namespace ramure {

/// "unreachable: 0.42 m short" and so on, in the interface's language.
QString armStatusText(const ArmProgress& progress);
/// The text, and a plot of the residual over the ticks (logarithmic), in the lower left corner.
void paintArmStatus(QPainter& painter, QSize size, const ArmProgress& progress);

} // namespace ramure
