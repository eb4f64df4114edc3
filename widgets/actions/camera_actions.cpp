#include "widgets/actions/camera_actions.h"

#include "core/qt/document/commands.h"
#include "widgets/base/action_set.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/view/render/camera_items.h"
#include "widgets/view/viewport.h"
#include "widgets/view/viewport_host.h"
#include <QMenu>
#include <algorithm>
#include <glm/gtc/quaternion.hpp>

namespace ramure {

CameraActions::CameraActions(Document* document, ViewportHost* host, ActionSet* set, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_host(host)
    , m_set(set)
{
    Viewport* view = host->viewport();
    const auto exists = [view] { return view != nullptr; };
    set->add(
        this,
        {{"view.throughCamera", Actions::tr("&Look through the camera"), "camera", Qt::Key_0,
          Actions::tr("The view becomes that of the selected camera, or of the first one, until "
                      "the view is moved"),
          [this] { lookThrough(); }, exists, [view] { return view && view->seenThrough() != noNode; }},
         {"view.cameraHere", Actions::tr("&Move the camera here"), nullptr, Qt::CTRL | Qt::ALT | Qt::Key_0,
          Actions::tr("The selected camera, or the first one, comes to where the view is seen "
                      "from"),
          [this] { moveHere(); }, exists}});
    set->update(this);
    if (view)
        connect(view, &Viewport::seenThroughChanged, this, [this] { m_set->update(this); });
}

/// The active node, where it is a camera; else the one that is seen through; else the first.
NodeId CameraActions::meant() const
{
    const Scene& scene = m_document->scene();
    const auto isCamera = [](const Node& node) { return node.kind == NodeKind::Camera; };
    if (const Node* active = scene.find(m_document->selection().activeNode()); active && isCamera(*active))
        return active->id;
    if (const NodeId through = m_host->viewport()->seenThrough(); through != noNode)
        return through;
    const auto first = std::ranges::find_if(scene.nodes(), isCamera);
    return first != scene.nodes().end() ? first->id : noNode;
}

void CameraActions::lookThrough()
{
    Viewport* view = m_host->viewport();
    const bool on = view->seenThrough() == noNode;
    const NodeId camera = on ? meant() : noNode;
    view->lookThrough(camera);
    if (on && camera == noNode)
        emit messageRaised(
            tr("There is no camera: Edit > Add to the scene > Camera makes one from this view."));
}

void CameraActions::moveHere()
{
    const NodeId camera = meant();
    if (camera == noNode)
        return emit messageRaised(
            tr("There is no camera: Edit > Add to the scene > Camera makes one from this view."));
    const auto starts =
        transformStarts(m_document->scene(), {camera}, m_host->viewport()->shownSeconds(), true);
    if (starts.empty())
        return emit messageRaised(tr("This camera is locked or hidden."));
    const TransformStart& start = starts.front();
    const Camera now = cameraAt(start.world, {});
    const glm::dmat3 turn =
        glm::dmat3(standingOf(m_host->viewport()->camera())) * glm::transpose(glm::dmat3(standingOf(now)));
    const glm::dquat way = glm::normalize(glm::quat_cast(turn));
    WorldTransform transform;
    transform.pivot = start.origin();
    transform.move = m_host->viewport()->camera().eye() - start.origin();
    transform.angleRad = glm::angle(way);
    if (transform.angleRad > 1e-12)
        transform.axis = glm::axis(way);
    auto values = transformed(start, transform);
    const auto placed = values ? edit::placeNodes(*m_document, {{camera, std::move(*values), start.keys}},
                                                  tr("Move the camera here"))
                               : fail(std::move(values.error()));
    if (!placed)
        emit messageRaised(errorText(placed.error()));
}

void CameraActions::fillMenu(QMenu* menu)
{
    menu->addMenu(tr("&Camera"))->addActions(m_set->find({"view.throughCamera", "view.cameraHere"}));
}

} // namespace ramure
