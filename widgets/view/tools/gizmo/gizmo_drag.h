/// \file
/// One gesture that moves, turns or scales the selected nodes: by a handle, or by the keyboard with the mouse
/// helping. Numbers may be typed at any time. One undo step, whatever is changed: placements, or keys at the
/// playhead. Knows cameras and the document, no window.
#pragma once

#include "core/qt/document/commands.h"
#include "widgets/view/tools/gizmo/gizmo_handles.h"
#include "widgets/view/tools/typed_number.h"
#include <memory>

namespace ramure {

/// What the user holds while the mouse moves.
struct GizmoModifiers
{
    bool snap = false; ///< Ctrl: the other way round than the settings say
    bool fine = false; ///< Shift: a tenth of the way
};

/// The middle of what the nodes show: of the origins of their own geometry, which a local transform may carry
/// far away from the nodes' own. World. \pre \p starts is not empty
glm::dvec3 shownPivot(const Scene& scene, const std::vector<TransformStart>& starts);

class GizmoDrag
{
public:
    GizmoDrag(const GizmoDrag&) = delete;
    GizmoDrag& operator=(const GizmoDrag&) = delete;
    ~GizmoDrag();
    enum class KeyResult : quint8 { Ignored, Taken, Confirm, Cancel };

    /// Null where nothing that is selected can be moved. \p document and \p settings are not owned.
    /// \param tool not Select; may be another one than that of the settings
    /// \param handle none: free, as the keyboard begins it
    /// \param keys nodes whose transform is keyed get keys at \p seconds
    static std::unique_ptr<GizmoDrag> begin(Document& document, const GizmoSettings& settings,
                                            TransformTool tool, std::optional<GizmoHandle> handle,
                                            double seconds, bool keys, const PickView& view,
                                            const glm::dvec2& pixel);

    void moveTo(const PickView& view, const glm::dvec2& pixel, GizmoModifiers modifiers);
    /// Digits, point, minus, Backspace, Tab (the next number), X Y Z (with Shift the plane across; once more
    /// the other space, a third time free again), Enter, Escape.
    KeyResult key(int key, const QString& text, Qt::KeyboardModifiers modifiers);
    /// What was done becomes one step of undo; nothing where it ended where it began. A drag that is
    /// destroyed is kept, too.
    void keep();
    /// Brings everything back to the last bit; the undo stack is as it was before the drag, redo included.
    /// Does nothing where the document has ended the gesture (UndoHistory::gestureEnded).
    void cancel();

    [[nodiscard]] TransformTool tool() const { return m_tool; }
    [[nodiscard]] GestureId gesture() const { return m_gesture; }                       ///< of its edits
    [[nodiscard]] const std::optional<GizmoHandle>& handle() const { return m_handle; } ///< or locked axes
    [[nodiscard]] TransformSpace space() const { return m_space; }
    /// Where the gizmo is now: it goes along.
    [[nodiscard]] GizmoPlace place() const;
    /// Returns where the turn or scale stood at the beginning.
    [[nodiscard]] const GizmoPlace& start() const { return m_place; }
    [[nodiscard]] bool keys() const { return m_keys; } ///< any of the nodes gets keys
    /// "X +1.250 m", "45.0°", "× 1.5"; while a number is typed it, with a cursor.
    [[nodiscard]] QString readout() const;
    [[nodiscard]] double angleRad() const { return m_transform.angleRad; }
    [[nodiscard]] glm::dvec3 turnAxis() const { return m_transform.axis; }

private:
    GizmoDrag(Document& document, const GizmoSettings& settings, TransformTool tool,
              std::optional<GizmoHandle> handle, std::vector<TransformStart> starts, const PickView& view,
              const glm::dvec2& pixel);
    void lock(int axis, bool plane);
    void setAxes();
    void beginAgain();
    [[nodiscard]] bool moves(int axis) const;
    [[nodiscard]] std::array<int, 3> fields() const;
    [[nodiscard]] int fieldCount() const;
    void measure(bool snap);
    void measureMove(bool snap);
    void measureTurn(bool snap);
    void measureScale(bool snap);
    [[nodiscard]] double scaleFactor() const;
    [[nodiscard]] std::optional<double> turnAt(const glm::dvec2& pixel) const;
    void apply();
    [[nodiscard]] QString number(int field, double value, int decimals) const;

    Document& m_document;
    const GizmoSettings& m_settings;
    TransformTool m_tool;
    std::optional<GizmoHandle> m_handle;
    TransformSpace m_space;
    std::vector<TransformStart> m_starts;
    GestureId m_gesture = newGesture();
    GizmoPlace m_place;
    bool m_byHandle; ///< else by the keyboard, with the mouse anywhere
    bool m_keys = false;

    PickView m_view;
    glm::dvec2 m_pressed, m_hand, m_last; ///< pixels; the hand goes slower than the cursor while it is fine
    double m_turned = 0.0;                ///< rad, all rounds
    std::optional<double> m_turnLast;
    glm::dvec3 m_amount{0.0}; ///< of a move, along the axes
    WorldTransform m_transform;
    std::array<TypedNumber, 3> m_typed;
    int m_field = 0;
    bool m_snap = false;
};

} // namespace ramure
