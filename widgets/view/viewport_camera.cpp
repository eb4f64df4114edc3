// The view of a camera node.
#include "core/evaluate/evaluator.h"
#include "widgets/base/empty_page.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/view/render/camera_items.h"
#include "widgets/view/viewport_private.h"
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

namespace ramure {

NodeId Viewport::seenThrough() const
{
    return d->through;
}

double Viewport::shownSeconds() const
{
    return d->context.seconds();
}

void Viewport::lookThrough(NodeId camera)
{
    if (camera == d->through)
        return;
    EvaluatedScene now(d->document->scene(), d->context.seconds());
    if (!viewThrough(now, camera))
        return d->leaveCamera();
    d->settings->orthographic.set(false);
    d->frame.next = false;
    d->frame.isAll = false;
    d->frame.wanted = Private::Frame::Wish::None;
    d->flight.stop();
    d->through = camera;
    d->followCamera();
    emit seenThroughChanged();
    wishScene();
    update();
}

/// Where it stands at the moment that is shown.
void Viewport::Private::followCamera()
{
    if (through == noNode)
        return;
    EvaluatedScene now(document->scene(), context.seconds());
    const auto seen = viewThrough(now, through);
    lens = seen ? seen->lens : Lens();
    if (seen && seen->camera != camera())
        flight.setCamera(seen->camera);
}

/// Where a tree was wholly in the picture and has outgrown it, the camera moves back; it returns with the
/// tree, to the last bit, as long as nobody moves it.
Camera Viewport::Private::Frame::follow(const Camera& now, double aspect, bool isDraft,
                                        const std::vector<glm::dvec3>& before,
                                        const std::vector<glm::dvec3>& points)
{
    const auto isSeen = [aspect](const Camera& from, const std::vector<glm::dvec3>& all) {
        return std::ranges::all_of(all, [&](const glm::dvec3& point) {
            const auto at = from.project(point, aspect);
            return at && std::max(std::abs(at->x), std::abs(at->y)) <= 1.0;
        });
    };
    if (followed != now) {
        if (!isSeen(now, before))
            return now;
        own = now;
    }
    Camera to = isDraft ? now : own; // drafts come and go too fast to return for
    if (!isSeen(to, points))
        to.frame(points, aspect);
    followed = to;
    return to;
}

void Viewport::Private::leaveCamera()
{
    if (std::exchange(through, noNode) == noNode)
        return;
    lens = {};
    emit widget->seenThroughChanged();
    widget->wishScene();
}

namespace {

/// White on a dark box, whose middle is given.
QRectF paintLabel(QPainter& painter, const QString& text, double width, QPointF middle)
{
    constexpr int flags = Qt::AlignCenter | Qt::TextWordWrap;
    const double lineHeight = painter.fontMetrics().height();
    QRectF words = painter.boundingRect(QRectF(0.0, 0.0, width, 100.0 * lineHeight), flags, text);
    words.moveCenter(middle);
    const QRectF box = words.adjusted(-10.0, -4.0, 10.0, 4.0);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 150));
    painter.drawRoundedRect(box, 4.0, 4.0);
    painter.setPen(Qt::white);
    painter.drawText(words, flags, text);
    return box;
}

} // namespace

/// Above the picture: the camera whose view it is, which moving the view leaves, the game whose wind blows,
/// and that it is out of date. In the middle: what to do while there is nothing to see.
void Viewport::paintLabels(QPainter& painter) const
{
    constexpr double margin = 10.0, broadest = 420.0;
    QStringList texts;
    if (const Node* node = d->document->scene().find(d->through))
        texts += tr("Through “%1”").arg(QString::fromStdString(node->name));
    if (d->isWindy())
        texts += tr("Wind: %1").arg(coreText(factsOf(d->settings->gameWind()).choice));
    if (const CrowdCounts crowd = d->renderer ? d->renderer->stats().crowd : CrowdCounts(); crowd.all > 0)
        texts +=
            tr("%1 copies, %2 in sight, %3 triangles")
                .arg(QLocale().toString(qulonglong(crowd.all)), QLocale().toString(qulonglong(crowd.seen)),
                     QLocale().toString(qlonglong(crowd.triangles)));
    if (!accessibleDescription().isEmpty())
        texts += accessibleDescription();
    const double room = width() - 4.0 * margin, lineHeight = painter.fontMetrics().height();
    double top = margin;
    for (const QString& text : texts)
        top = paintLabel(painter, text, room, {0.5 * width(), top + 0.5 * lineHeight + 4.0}).bottom() + 4.0;
    if (d->document->scene().nodes().empty())
        paintLabel(painter, emptySceneText(), std::min(room, broadest), QRectF(rect()).center());
}

} // namespace ramure
