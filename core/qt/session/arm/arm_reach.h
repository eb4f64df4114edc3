/// \file
/// An arm on its way to its target while the timeline stands at rest: the approach is seen, can be paused and
/// gone through step by step, and ends in the joints. Target and joints are one undo step. Elsewhere on the
/// timeline the arm is where its driver (core/rig/arm) has it.
#pragma once

#include "core/evaluate/arm_run.h"
#include "core/qt/document/commands.h"
#include "core/rig/arm/arm_motion.h"
#include <QObject>
#include <memory>
#include <optional>

namespace ramure {

class AutoKey;
class Player;

class ArmReach : public QObject
{
    Q_OBJECT
public:
    /// \p document is not owned and must outlive this object.
    explicit ArmReach(Document* document, QObject* parent = nullptr);
    ~ArmReach() override;

    /// Sets the target of an arm (its own space, Z up), as a key where AutoKey takes it, and sends the arm
    /// there. Angles with keys stay where those have them. Away from rest only the target is set, as the arm
    /// follows it along the timeline by itself. One undo step per gesture, the joints at its end included;
    /// 0 = one of its own. Errors: those of edit::setArm.
    Expected<void> reachFor(NodeId arm, const glm::dvec3& target, GestureId gesture);
    /// Sends the arm to the target that it has now. Errors: those of edit::setArm.
    Expected<void> reach(NodeId arm);
    /// An edit of "arm.target": as reachFor, where the arm follows its target; nothing where it does not.
    std::optional<Expected<void>> editTarget(NodeId arm, const ParamValue& target, GestureId gesture);
    /// Sets the player whose timeline the scene follows; null: the scene stands at rest. Not owned.
    void setPlayer(const Player* player);
    /// Sets the object that turns edits into keys; null: none. Not owned.
    void setKeys(AutoKey* keys) { m_keys = keys; }
    /// Null where no arm has been sent anywhere yet.
    [[nodiscard]] const ArmProgress* progress() const;
    /// The timeline stands where the way begins and ends: the arm is shown where progress() has it.
    [[nodiscard]] bool isAtRest() const;
    /// How the arm that is shown does: on its way, or in the player's frame. Null where it was not sent
    /// anywhere, or does not move. Valid until the next event.
    [[nodiscard]] const ArmProgress* shown(NodeId arm) const;
    [[nodiscard]] bool isPaused() const { return m_paused; }

public slots:
    /// While it is paused, step() goes on by one tick.
    void setPaused(bool paused);
    void step();
    /// Jumps to the end of the way.
    void finish();

signals:
    void moved(); ///< progress() or shown() may have changed

private:
    Expected<void> send(NodeId arm, ArmState state, GestureId gesture);
    void start(const Node& node);
    void advance(int ticks);
    void report();
    void land();
    void documentChanged(const Change& change);

    struct Way;
    Document* m_document;
    const Player* m_player = nullptr;
    AutoKey* m_keys = nullptr;
    std::unique_ptr<Way> m_way;
    bool m_paused = false;
    bool m_editing = false; ///< the document changes through this object
};

} // namespace ramure
