// Turning, moving and zooming the view with the mouse.
#include "widgets/view/tools/navigation.h"
#include "widgets/view/tools/tool_table.h"
#include <QCoreApplication>
#include <utility>

namespace ramure {
namespace {

class NavigationTool : public Tool
{
    Q_DECLARE_TR_FUNCTIONS(ramure::NavigationTool)
public:
    using Tool::Tool;

    bool press(const ToolPoint& point) override
    {
        m_drag = cameraDragFor(m_context.host.navigationStyle(), point.button, point.held);
        m_last = point.at;
        m_before = point.view.camera;
        return m_drag != CameraDrag::None;
    }
    void drag(const ToolPoint& point) override
    {
        Camera camera = point.view.camera;
        applyDrag(camera, m_drag, point.at - std::exchange(m_last, point.at), sizeOf(point.view));
        m_context.host.setCamera(camera);
    }
    void cancel() override { m_context.host.setCamera(m_before); }
    bool wheel(const ToolPoint& point, double turn) override
    {
        if (turn == 0.0)
            return true;
        m_context.host.stopFlight();
        const PickView view = m_context.host.view(); // where the flight has ended
        Camera camera = view.camera;
        glm::dvec3 fixed = camera.pointAtTargetDepth(view.ndc(point.pixel()), view.aspect());
        // Over a branch: towards that very point, so that zooming on and on arrives at it.
        if (const auto scene = m_context.host.pickScene({}))
            if (const auto hit = scene->pick(view, point.pixel()))
                fixed = hit->point;
        camera.zoom(wheelFactor(turn), fixed);
        m_context.host.setCamera(camera);
        return true;
    }

    [[nodiscard]] QString hint(Qt::KeyboardModifiers) const override
    {
        switch (m_drag) {
        case CameraDrag::Pan:
            return tr("The view moves · release: done");
        case CameraDrag::Zoom:
            return tr("Down or left: farther · up or right: nearer · release: done");
        case CameraDrag::Orbit:
        case CameraDrag::None:
            break;
        }
        return tr("The view turns · release: done");
    }
    void offer(ToolOffers& offers) const override
    {
        const bool maya = m_context.host.navigationStyle() == NavigationStyle::Maya;
        switch (offers.held()) {
        case Qt::AltModifier: // every button moves the camera
            offers.add(ToolOffers::View,
                       maya ? tr("Alt: drag turns (with Shift: moves, with Ctrl: zooms) · middle: moves · "
                                 "right: zooms")
                            : tr("Alt: drag turns (with Shift: moves, with Ctrl: zooms) · right: zooms"));
            break;
        case Qt::ControlModifier:
            if (!maya)
                offers.add(ToolOffers::View, tr("Ctrl + middle: zoom"));
            break;
        case Qt::ShiftModifier:
            if (!maya)
                offers.add(ToolOffers::View, tr("Shift + middle: move the view"));
            break;
        default:
            offers.add(ToolOffers::View,
                       maya ? tr("Alt + drag: turn the view") : tr("middle or Alt: turn the view"));
        }
    }

private:
    CameraDrag m_drag = CameraDrag::None;
    QPointF m_last;
    Camera m_before;
};

} // namespace

std::unique_ptr<Tool> makeNavigationTool(ToolContext& context)
{
    return std::make_unique<NavigationTool>(context);
}

} // namespace ramure
