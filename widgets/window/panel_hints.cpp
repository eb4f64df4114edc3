#include "widgets/window/panel_hints.h"

#include "widgets/base/hint_source.h"
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

} // namespace

void addPanelHints(HintLine* line, TimelinePanel* timeline, KeyPanel* keys, LevelsPanel* levels)
{
    const auto add = [line](QWidget* widget, const QString& text) {
        auto* hint = new HintSource(widget);
        hint->say(text);
        line->addSource(widget, hint);
    };
    const QString ruler =
        Hints::tr("Drag: go to a frame · a handle: range · wheel: zoom · Shift + wheel: scroll · double "
                  "click: whole range");
    add(timeline->ruler(), ruler);
    add(keys->ruler(), ruler);
    add(keys->sheet(),
        Hints::tr("Click: select · drag: move · Shift: add, between frames · Ctrl + drag: copies · Alt + "
                  "click: column · Ctrl + wheel: zoom"));
    add(keys->curves(),
        Hints::tr("Click: select · drag: move · Shift: add, between frames · Ctrl + drag: value only · "
                  "Ctrl + wheel: zoom"));
    const QString levelHint =
        Hints::tr("Drag: turn both · wheel: nearer or farther · arrow keys: turn · Home: from the front");
    add(levels->levelView(), levelHint);
    add(levels->wholeView(), levelHint);
}

} // namespace ramure
