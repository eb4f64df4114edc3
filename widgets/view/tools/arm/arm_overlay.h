/// \file
/// The viewport's readout of an arm: the distance from its tip to the target, and its history.
#pragma once

#include "core/qt/session/arm/arm_reach.h"
#include "core/qt/session/motion/motion.h"
#include "widgets/view/render/pick/pick_scene.h"

class QPainter;
class QSize;

namespace ramure {

/// Metres with three digits, in the unit that suits: "1.058 m", "1.30 µm".
QString shortLengthText(double metres);
/// "unreachable: 0.42 m short" and so on, in the interface's language.
QString armStatusText(const ArmProgress& progress);
/// A mark over everything where a target is: its sphere may be inside the skin, or behind a hill.
/// \param bright it would move with the hand, or does
void paintTarget(QPainter& painter, const PickView& view, const glm::dvec3& world, bool bright);
/// The text, and a plot of the residual over the ticks (logarithmic), in the lower left corner.
void paintArmStatus(QPainter& painter, QSize size, const ArmProgress& progress);

} // namespace ramure
