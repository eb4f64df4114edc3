// The viewport as the host of its tools.
#include "widgets/view/viewport_private.h"
#include <QMouseEvent>

namespace ramure {

PickView Viewport::Private::view() const
{
    return {camera, glm::dvec2(std::max(1, widget->width()), std::max(1, widget->height()))};
}

ToolPoint Viewport::Private::pointAt(QPointF position) const
{
    return {view(), position, Qt::NoButton, held, position};
}

ToolPoint Viewport::Private::pointOf(const QMouseEvent& event) const
{
    return {view(), event.position(), event.button(), event.modifiers(), event.position()};
}

void Viewport::Private::setCamera(const Camera& moved)
{
    framed = false;
    camera = moved;
    emit widget->cameraChanged();
    widget->update();
}

std::shared_ptr<const PickScene> Viewport::Private::pickScene(std::chrono::milliseconds patience)
{
    if (isStale())
        return nullptr;
    return patience.count() > 0 ? picker.readyWithin(patience) : picker.ready();
}

bool Viewport::Private::pickBox(QPointF cornerA, QPointF cornerB,
                                std::function<void(const std::vector<PickedBranches>&)> done)
{
    return picker.pickBox(view(), {cornerA.x(), cornerA.y()}, {cornerB.x(), cornerB.y()}, std::move(done));
}

} // namespace ramure
