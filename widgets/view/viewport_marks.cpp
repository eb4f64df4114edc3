// What panels point at in the viewport: one section, one defect.
#include "core/evaluate/evaluator.h"
#include "widgets/view/viewport_private.h"

namespace ramure {

void Viewport::setInspectedSection(NodeId node, Index branch, Index section)
{
    const InspectedSection next{node, branch, section};
    if (d->inspected == next)
        return;
    d->inspected = next;
    wishScene();
}

void Viewport::setIsolated(NodeId node, const std::vector<Index>& branches)
{
    if (d->isolated == Private::Branches{node, branches})
        return;
    d->isolated = {node, branches};
    wishScene();
}

void Viewport::pointAt(NodeId node, const std::vector<Index>& branches)
{
    if (d->pointed == Private::Branches{node, branches})
        return;
    d->pointed = {node, branches};
    d->highlightsStale = true;
    update();
}

void Viewport::showDefect(NodeId node, const DefectPlace& place)
{
    d->defect.show(place);
    Box box; // of the node, world
    for (const MeshItem& item : d->scene->meshes)
        if (item.node == node)
            box.add(item.box.transformed(item.world));
    const TreeResult* tree = d->resultOf(node);
    const double reach = defectReach(place, tree ? tree->simplified.get() : nullptr,
                                     EvaluatedScene(d->document->scene()).transforms(node).geometry, box);
    moveCamera(defectView(*d->scene, place, reach, d->camera(), double(width()) / std::max(1, height()),
                          d->settings->groundVisible()));
    update();
}

void Viewport::clearDefect()
{
    if (d->defect.clear())
        update();
}

} // namespace ramure
