/// \file
/// What the status bar says over the timeline, the dope sheet and the curves.
#pragma once

namespace ramure {

class HintLine;
class KeyPanel;
class TimelinePanel;

/// Nothing is owned.
void addPanelHints(HintLine* line, TimelinePanel* timeline, KeyPanel* keys);

} // namespace ramure
