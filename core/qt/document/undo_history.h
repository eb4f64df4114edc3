/// \file
/// What can be undone in a document: how commands and gestures become steps, and how the oldest steps go.
/// Lives on the interface's thread.
///
/// A gesture that is held has changed the scene, but is no step of undo yet. The history ends it before it
/// does anything else: it keeps the gesture before the command of somebody else and before a step of several
/// commands; it gives the gesture up before undo, redo and goToStep.
#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace ramure {

class DocumentCommand;
class Scene;
class UndoStep;

/// A gesture: commands with the same id merge. 0 = never merge.
using GestureId = quint64;
/// Another one than ever before; from any thread.
GestureId newGesture();

class UndoHistory : public QObject
{
    Q_OBJECT
public:
    /// \param scene that commands change; not owned
    explicit UndoHistory(const Scene& scene);
    ~UndoHistory() override;

    /// The steps, to look at.
    [[nodiscard]] const QUndoStack* stack() const { return &m_stack; }
    [[nodiscard]] bool isClean() const { return m_held.empty() && m_stack.isClean(); }
    void setClean() { m_stack.setClean(); }
    void resetClean() { m_stack.resetClean(); }
    /// Forgets all steps. \pre no gesture is held
    void clear();
    /// The oldest steps are forgotten where all of them together hold more memory than this.
    void setMemory(std::size_t bytes) { m_memory = bytes; }
    static constexpr std::size_t usualMemory = std::size_t(1) << 30;

    /// For commands: does it, and puts it on the stack, or to the gesture that is held. A command in the
    /// middle of another one (in an answer to Document::changed(), say) is refused with a warning: it would
    /// get onto the stack before that one.
    void push(std::unique_ptr<DocumentCommand> command);
    /// See OneStep (commands.h).
    void beginStep(const QString& text);
    void endStep();

    /// There is a step to take back, or a gesture to give up.
    [[nodiscard]] bool canUndo() const { return m_heldGesture != 0 || m_stack.canUndo(); }
    /// Gives up the gesture that is held. Where that changes nothing, takes the last step back.
    void undo();
    /// Gives up the gesture that is held and makes the next step again.
    void redo();
    /// Gives up the gesture that is held and goes to the state after so many steps.
    void goToStep(int count);

    /// Edits of this gesture are made at once, but become a step of undo, all of them one, only when they are
    /// kept: until then what could be redone can be redone. One gesture at a time: one that is held already
    /// is kept. A gesture that has been ended (gestureEnded) is not held any more: edits that name it are
    /// steps of their own.
    void hold(GestureId gesture);
    [[nodiscard]] bool isHeld(GestureId gesture) const { return gesture != 0 && gesture == m_heldGesture; }
    [[nodiscard]] bool isHolding() const { return m_heldGesture != 0; } ///< any gesture
    /// Makes the gesture a step of undo. Does nothing where it is not held.
    void keep(GestureId gesture);
    /// Brings everything back to the last bit. \returns false where the gesture is not held
    bool giveUp(GestureId gesture);
    /// Keeps whatever gesture is held: before saving, or asking whether to save.
    void settle();
    /// Forgets whatever gesture is held with what it changed: the scene is replaced.
    void drop();
    /// When \p gesture, which is held, is kept, it does not become a step of its own: the step that is the
    /// last one now takes it in. Where the file was saved meanwhile, it is a step of its own.
    void joinToLast(GestureId gesture);

signals:
    /// Whatever a hand was doing has been ended, see above. A tool or panel that is in the middle of
    /// something stops: the rest of its drag does nothing.
    void gestureEnded();
    /// The oldest steps are gone, see setMemory. Once until the next clear().
    void stepsForgotten();

private:
    using Commands = std::vector<std::unique_ptr<DocumentCommand>>;

    bool endGesture(bool keeps);
    void run(const std::function<void()>& change);
    void pushStep(Commands commands, GestureId gesture, const QString& text);
    [[nodiscard]] int stepsTooMany(const UndoStep& next) const;
    void forgetSteps(int count);
    [[nodiscard]] UndoStep* lastStep();

    const Scene& m_scene;
    QUndoStack m_stack;
    std::size_t m_memory = usualMemory;
    bool m_hasForgotten = false; ///< since the last clear()
    GestureId m_heldGesture = 0;
    Commands m_held;     ///< what it has done so far
    int m_openSteps = 0; ///< beginStep() without endStep()
    QString m_openText;
    Commands m_open;           ///< what was done since beginStep()
    bool m_isChanging = false; ///< a command is being done, undone or redone
};

} // namespace ramure
