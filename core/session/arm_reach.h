/// \file
/// An arm on its way to its target while nothing plays: the approach is seen, can be paused and gone through
/// step by step, and ends in the joints. Target and joints are one undo step. Playing has the driver of
/// core/arm instead.
#pragma once

#include "core/document/commands.h"
#include "core/evaluate/arm_run.h"
#include "core/rig/arm/arm_motion.h"
#include <QObject>
#include <memory>
#include <optional>

namespace ramure {

class Player;

class ArmReach : public QObject
{
    Q_OBJECT
public:
    /// \p document is not owned and must outlive this object.
    explicit ArmReach(Document* document, QObject* parent = nullptr);
    ~ArmReach() override;

    /// Sets the target of an arm (its own space, Z up) and sends it there. One undo step per gesture, the
    /// joints at its end included; 0 = one of its own. Errors: those of edit::setArm.
    Expected<void> reachFor(NodeId arm, const glm::dvec3& target, GestureId gesture);
    /// As reachFor where the timeline stands at rest and no keys hold the arm; elsewhere only the target is
    /// set, as the arm follows it along the timeline by itself. Errors: those of reachFor.
    Expected<void> aim(NodeId arm, const glm::dvec3& target, GestureId gesture);
    /// An edit of "arm.target": as aim, where the arm follows its target; nothing where it does not.
    std::optional<Expected<void>> editTarget(NodeId arm, const ParamValue& target, GestureId gesture);
    /// Whose timeline it is; null: it stands at rest. Not owned.
    void setPlayer(const Player* player) { m_player = player; }
    /// Null where no arm has been sent anywhere yet.
    [[nodiscard]] const ArmProgress* progress() const;
    [[nodiscard]] bool isPaused() const { return m_paused; }

public slots:
    /// While it is paused, step() goes on by one tick.
    void setPaused(bool paused);
    void step();
    /// What remains of the way, at once.
    void finish();

signals:
    void moved(); ///< another progress, or none

private:
    void start(NodeId arm);
    void advance(int ticks);
    void report();
    void land();
    void documentChanged(const Change& change);

    struct Way;
    Document* m_document;
    const Player* m_player = nullptr;
    std::unique_ptr<Way> m_way;
    bool m_paused = false;
    bool m_editing = false; ///< the document changes through this object
};

} // namespace ramure
