/// \file
/// What the colours and squares of the texture modes mean, drawn over the view.
#pragma once

#include "widgets/view/render/display_mode.h"
#include "widgets/view/render/render_scene.h"
#include <QSize>

class QPainter;

namespace ramure {

/// Nothing in the other modes.
void paintTextureLegend(QPainter& painter, QSize area, DisplayMode mode, const TextureSummary& texture);

} // namespace ramure
