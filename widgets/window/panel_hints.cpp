#include "widgets/window/panel_hints.h"

#include "widgets/base/fixed_hint.h"
#include "widgets/base/timeline_ruler.h"
#include "widgets/panels/animation/key_curves.h"
#include "widgets/panels/animation/key_panel.h"
#include "widgets/panels/animation/key_sheet.h"
#include "widgets/panels/levels/level_view.h"
#include "widgets/panels/levels/levels_panel.h"
#include "widgets/panels/timeline/timeline_panel.h"
#include "widgets/window/hint_line.h"
#include <QCoreApplication>

namespace ramure {
namespace {

struct Hints
{
    Q_DECLARE_TR_FUNCTIONS(PanelHints)
};

QString rulerHint()
{
    return Hints::tr("Drag: go to a frame · a handle: range · wheel: zoom · Shift + wheel: scroll · double "
                     "click: whole range");
}

QString sheetHint()
{
    return Hints::tr("Click: select · drag: move · Shift: add, between frames · Ctrl + drag: copies · Alt + "
                     "click: column · Ctrl + wheel: zoom");
}

QString curvesHint()
{
    return Hints::tr("Click: select · drag: move · Shift: add, between frames · Ctrl + drag: value only · "
                     "Ctrl + wheel: zoom");
}

QString levelHint()
{
    return Hints::tr("Drag: turn both · wheel: nearer or farther · arrow keys: turn · Home: from the front");
}

} // namespace

void addPanelHints(HintLine* line, TimelinePanel* timeline, KeyPanel* keys, LevelsPanel* levels)
{
    const auto add = [line](QWidget* widget, QString (*text)()) {
        line->addSource(widget, new FixedHint(widget, text));
    };
    add(timeline->ruler(), rulerHint);
    add(keys->ruler(), rulerHint);
    add(keys->sheet(), sheetHint);
    add(keys->curves(), curvesHint);
    add(levels->levelView(), levelHint);
    add(levels->wholeView(), levelHint);
}

} // namespace ramure
