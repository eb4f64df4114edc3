/// \file
/// Gives mouse and keys to the tools: to the one with a gesture going on, else to the first that takes the
/// press. Knows no window.
#pragma once

#include "widgets/view/tools/pending_pick.h"
#include "widgets/view/tools/tool.h"
#include <algorithm>

namespace ramure {

class ToolManager
{
public:
    /// With all tools of the table. \p context is not owned.
    explicit ToolManager(ToolContext& context);
    ~ToolManager();

    /// The one that goes on; null: none does.
    [[nodiscard]] Tool* current() const;
    /// Something is done to see.
    [[nodiscard]] bool goesOn() const { return current() && current()->goesOn(); }
    template <class T> [[nodiscard]] T& tool() const
    {
        const auto found = std::ranges::find_if(
            m_tools, [](const auto& tool) { return dynamic_cast<T*>(tool.get()) != nullptr; });
        return static_cast<T&>(**found);
    }
    [[nodiscard]] bool isHovering() const { return m_hovering != nullptr; }
    /// Clicks that wait for the scene to pick in.
    [[nodiscard]] PendingPick& picks() { return m_picks; }

    /// Returns true if a tool owns the place under the cursor.
    bool hover(ToolPoint point);
    void leave();
    /// \return whether a tool takes it, or one goes on already
    bool press(ToolPoint point);
    bool doubleClick(const ToolPoint& point);
    /// \return whether a tool goes on
    bool move(ToolPoint point);
    void release(ToolPoint point);
    bool wheel(const ToolPoint& point, double turn);
    /// Esc ends the present gesture and takes it back. Returns true if the key was used.
    bool key(const QKeyEvent& event, bool pressed);
    /// It would take this key: then it is no shortcut.
    [[nodiscard]] bool takesKey(const QKeyEvent& event) const;
    void focusLost();

    void playingStopped();
    /// To be called when the scene to pick in, or the picture, has become ready.
    void sceneReady();

    [[nodiscard]] QCursor cursor() const;
    /// For the status bar.
    [[nodiscard]] QString hint(ToolPoint point) const;
    void paint(QPainter& painter, const PickView& view) const;

private:
    void cancel();

    ToolContext& m_context;
    PendingPick m_picks;
    std::vector<std::unique_ptr<Tool>> m_tools;
    Tool* m_hovering = nullptr;
    QPointF m_pressed;
};

} // namespace ramure
