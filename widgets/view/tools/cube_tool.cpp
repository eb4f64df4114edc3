// The navigation cube: a click on a side looks from there, a drag turns the view.
#include "widgets/view/tools/navigation.h"
#include "widgets/view/tools/navigation_cube.h"
#include "widgets/view/tools/tool_table.h"

namespace ramure {
namespace {

std::optional<AxisView> sideAt(const ToolPoint& point)
{
    return NavigationCube::sideAt(point.view.camera, sizeOf(point.view), point.at);
}

class CubeTool : public Tool
{
    Q_DECLARE_TR_FUNCTIONS(ramure::CubeTool)
public:
    using Tool::Tool;

    bool hover(const ToolPoint& point) override
    {
        show(sideAt(point));
        return m_side.has_value();
    }
    void leave() override { show(std::nullopt); }
    bool press(const ToolPoint& point) override
    {
        m_last = point.at;
        m_before = point.view.camera;
        m_dragging = false;
        return point.button == Qt::LeftButton && sideAt(point);
    }
    void drag(const ToolPoint& point) override
    {
        if (!m_dragging && !point.isDrag())
            return;
        m_dragging = true;
        Camera camera = point.view.camera;
        applyDrag(camera, CameraDrag::Orbit, point.at - std::exchange(m_last, point.at), sizeOf(point.view));
        m_context.host.setCamera(camera);
    }
    void release(const ToolPoint& point) override
    {
        const auto side = m_dragging ? std::nullopt : sideAt(point);
        if (side)
            m_context.host.flyToSide(*side);
    }
    void cancel() override { m_context.host.setCamera(m_before); }
    [[nodiscard]] QString hint(Qt::KeyboardModifiers) const override
    {
        return tr("The view turns · release: done");
    }
    [[nodiscard]] QString hintAt(const ToolPoint&) const override
    {
        return m_side ? tr("Click: look from this side · drag: turn the view") : QString();
    }
    void paint(QPainter& painter, const PickView& view) override
    {
        NavigationCube::paint(painter, view.camera, sizeOf(view), m_side);
    }

private:
    void show(std::optional<AxisView> side)
    {
        if (std::exchange(m_side, side) != side)
            m_context.host.repaint();
    }

    std::optional<AxisView> m_side; ///< under the cursor
    QPointF m_last;
    Camera m_before;
    bool m_dragging = false;
};

} // namespace

std::unique_ptr<Tool> makeCubeTool(ToolContext& context)
{
    return std::make_unique<CubeTool>(context);
}

} // namespace ramure
