// What panels point at in the viewport: one section, one defect. And what the line around a selection means.
#include "core/evaluate/evaluator.h"
#include "widgets/view/viewport_private.h"
#include <QPainter>

namespace ramure {

static constexpr int outlineStaysMs = 1000;
static constexpr double outlineFadesMs = 300.0;

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

void Viewport::setOutlineKey(std::function<QString()> key)
{
    d->outline.key = std::move(key);
}

void Viewport::Private::showOutline()
{
    outline.since.start();
    outline.fades.start(outlineStaysMs);
    widget->update();
}

/// From 1, for a second, to 0: by then it was seen, and is in the way of what it goes around.
double Viewport::Private::outlineOpacity() const
{
    const double past =
        outline.since.isValid() ? double(outline.since.elapsed() - outlineStaysMs) : outlineFadesMs;
    return std::clamp(1.0 - past / outlineFadesMs, 0.0, 1.0);
}

/// As long as the line is there; what it fades by is drawn next.
void Viewport::Private::paintOutlineKey(QPainter& painter) const
{
    const double opacity = outlineOpacity();
    if (!settings->outlineVisible() || opacity <= 0.0 || document->selection().nodes.empty())
        return;
    constexpr double margin = 12.0, swatch = 22.0, gap = 8.0;
    const QString key = outline.key ? outline.key() : QString();
    const QString text =
        key.isEmpty() ? Viewport::tr("selected") : Viewport::tr("selected · %1: on or off").arg(key);
    const QSizeF size =
        painter.fontMetrics().size(Qt::TextSingleLine, text) + QSizeF(swatch + 3.0 * gap, 10.0);
    const QRectF box(QPointF(margin, margin), size);
    painter.save();
    painter.setOpacity(opacity);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(20, 26, 32, 190));
    painter.drawRoundedRect(box, 6.0, 6.0);
    painter.setPen(QPen(QColor::fromRgbF(1.0f, 0.50f, 0.06f), 3.0)); // as in outline_ink.frag
    const QPointF from(box.left() + gap, box.center().y());
    painter.drawLine(from, from + QPointF(swatch, 0.0));
    painter.setPen(Qt::white);
    painter.drawText(box.adjusted(swatch + 2.0 * gap, 0.0, 0.0, 0.0), Qt::AlignVCenter | Qt::AlignLeft, text);
    painter.restore();
}

void Viewport::clearDefect()
{
    if (d->defect.clear())
        update();
}

} // namespace ramure
