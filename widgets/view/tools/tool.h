/// \file
/// One gesture of the hand in the view: its input, its action and its hints. A new one is a class of its own
/// and a row of tool_table.h.
#pragma once

#include "widgets/view/tools/tool_context.h"
#include <QCursor>
#include <QObject>
#include <QSize>
#include <QStringList>
#include <map>

class QKeyEvent;
class QPainter;

namespace ramure {

/// Size of a picture, logical pixels.
inline QSize sizeOf(const PickView& view)
{
    return {int(view.size.x), int(view.size.y)};
}

/// The place of the mouse, with its buttons and keys.
struct ToolPoint
{
    PickView view;
    QPointF at;                            ///< logical pixels from the upper left corner
    Qt::MouseButton button = Qt::NoButton; ///< the button that went down or up
    Qt::KeyboardModifiers held;
    QPointF pressed;                ///< place where the gesture's button went down
    std::optional<double> pressure; ///< 0..1, of a pen; nothing: a mouse
    bool isEraser = false;          ///< the other end of the pen
    std::uint64_t milliseconds = 0; ///< when, from any start; of a mouse that moves

    [[nodiscard]] glm::dvec2 pixel() const { return {at.x(), at.y()}; }
    /// Far enough from there to be a drag.
    [[nodiscard]] bool isDrag() const;
};

/// The actions that mouse and keys offer while no gesture goes on. The status bar shows them as one line.
/// Parts of the same place stand in the order of the tools.
class ToolOffers
{
public:
    enum Place : quint8 { Click, Drag, Keys, Menu, More, View };
    /// \param held Alt, Ctrl or Shift, the first of them that is; or none
    explicit ToolOffers(Qt::KeyboardModifier held)
        : m_held(held)
    {
    }
    [[nodiscard]] Qt::KeyboardModifier held() const { return m_held; }
    void add(Place place, const QString& part) { m_parts.emplace(place, part); }
    [[nodiscard]] QString line() const;

private:
    Qt::KeyboardModifier m_held;
    std::multimap<Place, QString> m_parts;
};

class Tool : public QObject
{
public:
    /// \p context is not owned.
    explicit Tool(ToolContext& context)
        : m_context(context)
    {
    }

    /// From the press to the release, or as long as it goes on by keys: everything goes to this tool.
    [[nodiscard]] bool isBusy() const { return m_busy; }
    /// True while the gesture has a visible effect; a press that may become a click has none.
    [[nodiscard]] virtual bool goesOn() const { return m_busy; }
    /// The button that holds it; none where keys began it.
    [[nodiscard]] Qt::MouseButton button() const { return m_button; }
    void begin(Qt::MouseButton button);
    void end();

    /// The mouse moves while no gesture goes on. Returns true if the tool owns the place under the cursor,
    /// for example a handle.
    virtual bool hover(const ToolPoint&) { return false; }
    virtual void leave() {}                                                  ///< the cursor is elsewhere
    [[nodiscard]] virtual QCursor cursor() const { return Qt::ArrowCursor; } ///< while it hovers
    /// True for the chosen tool of the tool bar: it gets presses first, and sets the cursor.
    [[nodiscard]] virtual bool isChosen() const { return false; }
    virtual void sceneReady() {} ///< the scene to pick in is up to date again
    /// \return whether the tool takes it: then it begins
    virtual bool press(const ToolPoint& point) = 0;
    virtual void pressAgain(const ToolPoint&) {} ///< any button, while it goes on
    virtual void drag(const ToolPoint&) {}
    virtual void release(const ToolPoint&) {} ///< the gesture has ended; its effect stays
    virtual void cancel() {}                  ///< the gesture was ended by Esc; its effect is taken back
    /// A press that follows a click. \return whether the tool takes it; else it is a press
    virtual bool doubleClick(const ToolPoint&) { return false; }
    /// \param turn eighths of a degree. \return whether the tool takes it
    virtual bool wheel(const ToolPoint&, double turn);
    /// While it goes on all keys are its own, not only Esc.
    [[nodiscard]] virtual bool takesKeys() const { return false; }
    virtual void key(const QKeyEvent&, bool pressed);

    virtual void documentChanged(const Change&) {}
    virtual void playingStopped() {}
    virtual void focusLost() {} ///< the user works elsewhere in the window

    /// Explains the tool's action and how it ends, while it goes on.
    [[nodiscard]] virtual QString hint(Qt::KeyboardModifiers) const { return {}; }
    /// Explains a press at this place, if the place is the tool's own; empty elsewhere.
    [[nodiscard]] virtual QString hintAt(const ToolPoint&) const { return {}; }
    virtual void offer(ToolOffers&) const {}
    virtual void paint(QPainter&, const PickView&) {} ///< over the picture

protected:
    ToolContext& m_context;

private:
    bool m_busy = false;
    Qt::MouseButton m_button = Qt::NoButton;
};

} // namespace ramure
