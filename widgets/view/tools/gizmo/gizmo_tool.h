/// \file
/// The selected nodes are moved, turned and scaled: by the handles of the gizmo, or by keys.
#pragma once

#include "widgets/view/tools/gizmo/gizmo_drag.h"
#include "widgets/view/tools/tool.h"
#include <QCoreApplication>

namespace ramure {

class GizmoTool : public Tool
{
    Q_DECLARE_TR_FUNCTIONS(ramure::GizmoTool)
public:
    explicit GizmoTool(ToolContext& context);
    ~GizmoTool() override;

    /// By keys, with the mouse at \p point helping: until Enter or a click. False, and it is said why, where
    /// nothing can be moved.
    bool beginByKeys(TransformTool tool, const ToolPoint& point);
    /// Gesture of the edits made; 0: no gesture is going on.
    [[nodiscard]] GestureId gesture() const { return m_drag ? m_drag->gesture() : 0; }

    bool hover(const ToolPoint& point) override;
    void leave() override { show(std::nullopt); }
    [[nodiscard]] QCursor cursor() const override { return Qt::SizeAllCursor; }
    bool press(const ToolPoint& point) override;
    void pressAgain(const ToolPoint& point) override;
    void drag(const ToolPoint& point) override;
    void release(const ToolPoint& point) override;
    void cancel() override;
    bool wheel(const ToolPoint&, double) override { return isBusy(); }
    [[nodiscard]] bool takesKeys() const override { return true; }
    void key(const QKeyEvent& event, bool pressed) override;
    void documentChanged(const Change& change) override;
    void focusLost() override;

    [[nodiscard]] QString hint(Qt::KeyboardModifiers held) const override;
    [[nodiscard]] QString hintAt(const ToolPoint& point) const override;
    void offer(ToolOffers& offers) const override;
    void paint(QPainter& painter, const PickView& view) override;

private:
    [[nodiscard]] std::optional<GizmoPlace> place();
    [[nodiscard]] std::optional<GizmoHandle> handleAt(const ToolPoint& point);
    [[nodiscard]] QString whatMoves() const;
    void take(TransformTool tool, std::optional<GizmoHandle> handle, const ToolPoint& point);
    void show(std::optional<GizmoHandle> handle);
    void follow(const PickView& view, Qt::KeyboardModifiers held);
    void finish(bool keep);

    std::unique_ptr<GizmoDrag> m_drag; ///< while it goes on
    bool m_byKeys = false;             ///< else by a handle
    bool m_moves = false;              ///< the pointer has left the place of the press
    QPointF m_last;
    std::optional<GizmoHandle> m_hover;
    std::optional<GizmoPlace> m_rest; ///< its place between gestures
    bool m_stale = true;              ///< m_rest is of before a change
    double m_restSeconds = 0.0;       ///< time of the playhead for m_rest
};

} // namespace ramure
