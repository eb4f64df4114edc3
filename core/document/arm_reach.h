/// \file
/// An arm on its way to its target while nothing plays: the approach is seen, can be paused and gone through
/// step by step, and ends as one undo step that turns the joints. Playing has the driver of core/arm instead.
#pragma once

#include "core/arm/arm_motion.h"
#include "core/document/commands.h"
#include "core/document/motion.h"
#include <QObject>
#include <memory>

namespace ramure {

class ArmReach : public QObject
{
    Q_OBJECT
public:
    /// \p document is not owned and must outlive this object.
    explicit ArmReach(Document* document, QObject* parent = nullptr);
    ~ArmReach() override;

    /// Sets the target of an arm (its own space, Z up) and sends it there. Errors: those of edit::setParam.
    Expected<void> reachFor(NodeId arm, const glm::dvec3& target, GestureId gesture);
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
    std::unique_ptr<Way> m_way;
    bool m_paused = false;
    bool m_editing = false; ///< the document changes through this object
};

} // namespace ramure
