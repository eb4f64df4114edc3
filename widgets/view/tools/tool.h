/// \file
/// One gesture of the hand in the view: what it takes, does and says. A new one is a class of its own and a
/// row of tool_table.h.
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

/// Of a picture, logical pixels.
inline QSize sizeOf(const PickView& view)
{
    return {int(view.size.x), int(view.size.y)};
}

/// Where the mouse is, and what is held.
struct ToolPoint
{
    PickView view;
    QPointF at;                            ///< logical pixels from the upper left corner
    Qt::MouseButton button = Qt::NoButton; ///< that went down or up
    Qt::KeyboardModifiers held;
    QPointF pressed;                ///< where the button of the gesture went down
    std::optional<double> pressure; ///< 0..1, of a pen; nothing: a mouse
    bool isEraser = false;          ///< the other end of the pen
    std::uint64_t milliseconds = 0; ///< when, from any start; of a mouse that moves

    [[nodiscard]] glm::dvec2 pixel() const { return {at.x(), at.y()}; }
    /// Far enough from there to be a drag.
    [[nodiscard]] bool isDrag() const;
};

/// What mouse and keys would do, while nothing goes on: the line of the status bar, put together from what
/// the tools offer. Parts of the same place stand in the order of the tools.
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
    /// Something is done to see: the press of what may become a click is not.
    [[nodiscard]] virtual bool goesOn() const { return m_busy; }
    /// The button that holds it; none where keys began it.
    [[nodiscard]] Qt::MouseButton button() const { return m_button; }
    void begin(Qt::MouseButton button);
    void end();

    /// Nothing goes on. \return whether what is under the cursor is the tool's own: a handle, say
    virtual bool hover(const ToolPoint&) { return false; }
    virtual void leave() {}                                                  ///< the cursor is elsewhere
    [[nodiscard]] virtual QCursor cursor() const { return Qt::ArrowCursor; } ///< while it hovers
    /// The one of the tool bar: presses are its own before those of others, and so is the cursor.
    [[nodiscard]] virtual bool isChosen() const { return false; }
    virtual void sceneReady() {} ///< what is picked in is that of the document of now
    /// \return whether the tool takes it: then it begins
    virtual bool press(const ToolPoint& point) = 0;
    virtual void pressAgain(const ToolPoint&) {} ///< any button, while it goes on
    virtual void drag(const ToolPoint&) {}
    virtual void release(const ToolPoint&) {} ///< it has ended; what was done stays
    virtual void cancel() {}                  ///< it has ended, by Esc; what was done is taken back
    /// A press that follows a click. \return whether the tool takes it; else it is a press
    virtual bool doubleClick(const ToolPoint&) { return false; }
    /// \param turn eighths of a degree. \return whether the tool takes it
    virtual bool wheel(const ToolPoint&, double turn);
    /// While it goes on all keys are its own, not only Esc.
    [[nodiscard]] virtual bool takesKeys() const { return false; }
    virtual void key(const QKeyEvent&, bool pressed);

    virtual void documentChanged(const Change&) {}
    virtual void playingStopped() {}
    virtual void focusLost() {} ///< somebody goes on elsewhere in the window

    /// What it does and how it ends, while it goes on.
    [[nodiscard]] virtual QString hint(Qt::KeyboardModifiers) const { return {}; }
    /// What a press would do, where the place is the tool's own; empty elsewhere.
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
