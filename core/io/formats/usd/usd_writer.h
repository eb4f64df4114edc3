/// \file
/// A scene as the text of a USD layer. Internal to the formats.
#pragma once

#include "core/io/formats/usd/usd_plan.h"

namespace ramure::usd {

/// Writes a whole layer. It is cut off where text.isStopped().
void writeLayer(Text& text, const ExportScene& scene, const Plan& plan, const Progress& progress);

} // namespace ramure::usd
