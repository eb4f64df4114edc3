#include "core/qt/session/arm/arm_reach.h"

#include "core/qt/session/motion/auto_key.h"
#include "core/qt/session/motion/player.h"
#include "core/rig/arm/arm_driver.h"

#include <QElapsedTimer>
#include <QScopedValueRollback>
#include <QTimer>
#include <algorithm>
#include <glm/geometric.hpp>

namespace ramure {

namespace {

constexpr int mostTicksAtOnce = 6; ///< after a stall the arm does not leap
constexpr int longestWay = 20'000;

} // namespace

struct ArmReach::Way
{
    Way(const Node& arm, ArmGiven from)
        : given(std::move(from))
        , motion(given.joints, arm.params.ik)
        , ik(arm.params.ik)
    {
        progress.node = arm.id;
        motion.setJoints(given.joints, given.pinned);
        aim(*given.target);
    }
    void aim(const glm::dvec3& target)
    {
        given.target = target;
        motion.setTarget(target);
    }

    ArmGiven given; ///< the arm and its target at rest, with the angles at the start
    ArmMotion motion;
    ArmSolverParams ik;
    GestureId gesture = 0; ///< of the last wish: landing belongs to it
    ArmProgress progress;
    QTimer timer;
    QElapsedTimer clock;
    double waiting = 0.0; ///< s that have gone by since the last tick
};

ArmReach::ArmReach(Document* document, QObject* parent)
    : QObject(parent)
    , m_document(document)
{
    connect(document, &Document::changed, this, [this](const Change& change) { documentChanged(change); });
}

ArmReach::~ArmReach() = default;

const ArmProgress* ArmReach::progress() const
{
    return m_way ? &m_way->progress : nullptr;
}

void ArmReach::setPlayer(const Player* player)
{
    m_player = player;
    connect(player, &Player::motionChanged, this, &ArmReach::moved);
}

bool ArmReach::isAtRest() const
{
    return !m_player || (m_player->frame() <= 0 && !m_player->isPlaying());
}

const ArmProgress* ArmReach::shown(NodeId arm) const
{
    if (!m_player || m_player->frame() <= 0)
        return m_way && m_way->progress.node == arm ? &m_way->progress : nullptr;
    const NodeMotion* moving = m_player->motion()->of(arm);
    return moving ? moving->arm.get() : nullptr;
}

Expected<void> ArmReach::reachFor(NodeId arm, const glm::dvec3& target, GestureId gesture)
{
    const Node* node = m_document->scene().find(arm);
    const ParamDef& def = *findParam("arm.target");
    ArmState state = node && node->kind == NodeKind::Arm ? armState(*node) : ArmState();
    if (node && m_keys && m_keys->takes({arm}, def)) {
        auto keyed = m_keys->withKeys(*node, def, target);
        RAMURE_TRY(keyed);
        state.animation = std::move(*keyed);
    } else {
        state.target = target;
    }
    return send(arm, std::move(state), gesture);
}

Expected<void> ArmReach::reach(NodeId arm)
{
    const Node* node = m_document->scene().find(arm);
    return send(arm, node && node->kind == NodeKind::Arm ? armState(*node) : ArmState(), 0);
}

Expected<void> ArmReach::send(NodeId arm, ArmState state, GestureId gesture)
{
    const GestureId own = gesture == 0 ? newGesture() : gesture;
    state.follows = true;
    {
        const QScopedValueRollback editing(m_editing, true);
        if (auto done = edit::setArm(*m_document, arm, std::move(state), tr("Reach for the target"), own);
            !done)
            return done;
    }
    if (isAtRest()) {
        start(*m_document->scene().find(arm));
        m_way->gesture = own;
    } else {
        m_way.reset(); // its target is another one now
        emit moved();
    }
    return {};
}

std::optional<Expected<void>> ArmReach::editTarget(NodeId arm, const ParamValue& target, GestureId gesture)
{
    const Node* node = m_document->scene().find(arm);
    if (!node || !node->params.arm.follows)
        return std::nullopt;
    return reachFor(arm, std::get<glm::dvec3>(target), gesture);
}

/// An arm that is on its way already goes on from where it is.
void ArmReach::start(const Node& node)
{
    ArmGiven given = armSource(node.params, node.animation)(0.0);
    const bool goesOn = m_way && m_way->progress.node == node.id && m_way->progress.moves;
    if (goesOn && m_way->ik == node.params.ik) {
        m_way->aim(*given.target);
    } else {
        if (goesOn)
            setArmAngles(given.joints, m_way->motion.angles());
        auto way = std::make_unique<Way>(node, std::move(given));
        way->timer.setInterval(16);
        connect(&way->timer, &QTimer::timeout, this, [this] {
            const double seconds = double(m_way->clock.nsecsElapsed()) * 1e-9;
            m_way->clock.restart();
            m_way->waiting += seconds;
            const int ticks = static_cast<int>(m_way->waiting / armTickSeconds);
            m_way->waiting -= ticks * armTickSeconds;
            advance(std::min(ticks, mostTicksAtOnce));
        });
        m_way = std::move(way);
    }
    m_way->progress.moves = true;
    if (!m_paused && !m_way->timer.isActive()) {
        m_way->clock.start();
        m_way->timer.start();
    }
    report();
    emit moved(); // also while it is held: then the first step is still to be made
}

void ArmReach::advance(int ticks)
{
    if (ticks <= 0 || !m_way || !m_way->progress.moves)
        return;
    for (int i = 0; i < ticks && !m_way->motion.isStill(); ++i) {
        m_way->motion.tick();
        report();
    }
    // An arm that arrives while a hand drags something else waits: it does not end that drag.
    if (m_way->motion.isStill() &&
        (!m_document->history().isHolding() || m_document->history().isHeld(m_way->gesture)))
        land();
    emit moved();
}

void ArmReach::report()
{
    ArmProgress& progress = m_way->progress;
    const ArmGiven& given = m_way->given;
    ArmChain chain(given.joints);
    const std::span<const double> angles = m_way->motion.angles();
    chain.setAngles(angles);
    progress.angles.assign(angles.begin(), angles.end());
    progress.limits = armLimits(given.joints, angles);
    progress.figures = m_way->motion.solver().figures();
    progress.residual = glm::distance(chain.tip(), *given.target);
    if (progress.residuals.size() < mostResiduals)
        progress.residuals.push_back(static_cast<float>(progress.residual));
}

/// The joints of the document are where the arm is; one step together with the target, unless something else
/// was done meanwhile.
void ArmReach::land()
{
    m_way->timer.stop();
    m_way->progress.moves = false;
    const QScopedValueRollback own(m_editing, true);
    const Node* node = m_document->scene().find(m_way->progress.node);
    ArmState state = node ? armState(*node) : ArmState();
    std::vector<double> angles = armAngles(state.joints);
    for (std::size_t i = 0; i < angles.size(); ++i)
        if (!m_way->given.pinned[i])
            angles[i] = m_way->motion.angles()[i];
    setArmAngles(state.joints, angles);
    // Errors (locked meanwhile) leave the joints as they are: the arm is shown there then.
    if (!edit::setArm(*m_document, m_way->progress.node, std::move(state), tr("Reach for the target"),
                      m_way->gesture))
        m_way.reset();
}

void ArmReach::setPaused(bool paused)
{
    m_paused = paused;
    if (!m_way || !m_way->progress.moves)
        return;
    if (paused)
        m_way->timer.stop();
    else {
        m_way->clock.start();
        m_way->timer.start();
    }
    emit moved();
}

void ArmReach::step()
{
    advance(1);
}

void ArmReach::finish()
{
    advance(longestWay);
}

/// Whatever else happens to the arm ends its way, where it is not one that it can follow.
void ArmReach::documentChanged(const Change& change)
{
    if (!m_way || m_editing)
        return;
    const Node* node = m_document->scene().find(m_way->progress.node);
    const bool concerns =
        std::find(change.nodes.begin(), change.nodes.end(), m_way->progress.node) != change.nodes.end();
    const bool other = change.has(changeReset) || !node ||
                       (concerns && change.has(changeJoints | changeParams | changeTracks | changeStructure));
    if (!other)
        return;
    m_way.reset();
    emit moved();
}

} // namespace ramure

#include "moc_arm_reach.cpp"
