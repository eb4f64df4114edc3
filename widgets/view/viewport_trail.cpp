// Paths and ghosts follow the selection, the document and the playhead.
#include "core/session/player.h"
#include "widgets/view/viewport_private.h"

namespace ramure {

void Viewport::updateTrail()
{
    const GizmoSettings& how = *d->settings->gizmo();
    if (!how.showsPath() && !how.showsGhosts() && d->trail.isEmpty())
        return;
    const std::int64_t frame = d->player ? d->player->frame() : d->document->scene().timeline().firstFrame;
    d->trail.show(d->document->scene(), d->document->selection().nodes, how, frame,
                  !d->player || !d->player->isPlaying());
}

} // namespace ramure
