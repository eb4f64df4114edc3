/// \file
/// What the status bar says over the timeline, the dope sheet, the curves and the pictures of levels.
#pragma once

namespace ramure {

class HintLine;
class KeyPanel;
class LevelsPanel;
class TimelinePanel;

/// Nothing is owned.
void addPanelHints(HintLine* line, TimelinePanel* timeline, KeyPanel* keys, LevelsPanel* levels);

} // namespace ramure
