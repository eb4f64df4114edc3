// What the hand reaches for with Ctrl: a branch of a tree at rest, whose limb follows; a place on a surface,
// which becomes the target of an arm.
#include "core/evaluate/evaluator.h"
#include "core/rig/arm/arm_chain.h"
#include "core/scene/object_mesh.h"
#include "core/session/auto_key.h"
#include "core/session/player.h"
#include "widgets/base/core_text.h"
#include "widgets/view/tools/arm_overlay.h"
#include "widgets/view/viewport_private.h"
#include <QLocale>
#include <QPainter>
#include <limits>

namespace ramure {
namespace {

constexpr std::chrono::milliseconds patience(8); ///< how long a press may hold the interface up

/// Triangles that are sorted for rays within a few milliseconds.
constexpr Index fewTriangles = 40'000;

/// From the world into the arm's own space.
glm::dvec3 inArmSpace(const Scene& scene, NodeId arm, double timeSeconds, const glm::dvec3& world)
{
    const glm::dmat4 place = worldTransformAt(scene, arm, timeSeconds).geometry * armUpright();
    return glm::dvec3(glm::inverse(place) * glm::dvec4(world, 1.0));
}

} // namespace

/// \return whether the press is taken; else it selects
bool Viewport::beginReach(const PickView& view, const glm::dvec2& pixel)
{
    if (beginPull(view, pixel)) // while it plays there is no structure to pick in
        return true;
    const auto scene = d->isStale() ? nullptr : d->picker.readyWithin(patience);
    if (!scene)
        return beginAimAnyway(view, pixel);
    const auto hit = scene->pick(view, pixel);
    const Node* node = hit ? d->document->scene().find(hit->node) : nullptr;
    if (!node)
        return false;
    if (node->kind != NodeKind::Tree)
        return beginAim(view, pixel, hit->node, scene);
    const auto motion = d->player ? d->player->motion() : nullptr;
    const NodeMotion* moved = motion ? motion->of(hit->node) : nullptr;
    if (moved && moved->moves()) { // a bend is of the tree at rest: what is seen is not
        emit messageRaised(tr("A limb is bent at the first frame; while it plays it is pulled."));
        return false;
    }
    return beginLimb(*hit);
}

ArmReach* Viewport::armReach() const
{
    return &d->reach;
}

void Viewport::beginReaching()
{
    connect(&d->reach, &ArmReach::moved, this, [this] {
        d->reachFrame.reset();
        update();
    });
}

void Viewport::setKeys(AutoKey* keys)
{
    d->context.keys = keys;
}

double Viewport::Private::timeNow() const
{
    return player ? player->timeSeconds() : 0.0;
}

/// The player's frame, and in it the arm that is on its way.
std::shared_ptr<const MotionFrame> Viewport::Private::motionOfNow()
{
    auto frame = player ? player->motion() : nullptr;
    const ArmProgress* progress = reach.progress();
    if (!progress || (player && player->frame() > 0))
        return frame;
    if (reachFrame && reachOf == frame)
        return reachFrame;
    const Node* node = document->scene().find(progress->node);
    if (!node || node->kind != NodeKind::Arm || 2 * node->params.joints.size() != progress->angles.size())
        return frame;
    auto made = frame ? std::make_shared<MotionFrame>(*frame) : std::make_shared<MotionFrame>();
    std::vector<ArmJoint> joints = node->params.joints;
    setArmAngles(joints, progress->angles);
    made->nodes[progress->node] = armMotion(node->params, joints);
    reachOf = frame;
    reachFrame = std::move(made);
    return reachFrame;
}

NodeId Viewport::Private::armForTarget() const
{
    const Scene& all = document->scene();
    const auto isFree = [&](const Node* node) {
        return node && node->kind == NodeKind::Arm && all.isShown(node->id) && !all.isLocked(node->id);
    };
    if (const Node* active = all.find(document->selection().activeNode()); isFree(active))
        return active->id;
    for (const Node& node : all.nodes())
        if (isFree(&node))
            return node.id;
    return noNode;
}

/// The pick scene of now is still being made (while everything moves it never is): surfaces are met in the
/// one before, in their place of now. The nearest of them counts.
bool Viewport::beginAimAnyway(const PickView& view, const glm::dvec2& pixel)
{
    NodeId nearest = noNode;
    double least = std::numeric_limits<double>::infinity();
    const auto scene = d->picker.latest();
    for (const Node& node : d->document->scene().nodes()) {
        if (!isObject(node.kind) || d->document->scene().isLocked(node.id) || !d->aimAt(node.id, scene))
            continue;
        const auto point = d->aimedPoint(view, pixel);
        const double away = point ? glm::distance(*point, view.camera.eye()) : least;
        if (away < least) {
            least = away;
            nearest = node.id;
        }
    }
    return nearest != noNode && beginAim(view, pixel, nearest, scene);
}

const MeshItem* Viewport::Private::surfaceOf(NodeId node) const
{
    const RenderScene& now = shown ? *shown : *scene;
    for (const MeshItem& item : now.meshes)
        if (item.node == node && !item.isMark)
            return &item;
    return nullptr;
}

const MeshItem* Viewport::Private::aimAt(NodeId surface, std::shared_ptr<const PickScene> in)
{
    const MeshItem* item = surfaceOf(surface);
    aimedAt = noNode;
    aimedScene = nullptr;
    // What is bent is another mesh there.
    if (item && in && in->hasSurface(surface, item->motion.moves() ? nullptr : item->mesh.get()))
        aimedScene = std::move(in);
    if (!item || (!aimedScene && (item->motion.moves() || item->mesh->faceCount() > fewTriangles)))
        return nullptr;
    if (!aimedScene && aimedRays.mesh() != item->mesh)
        aimedRays = MeshRays(item->mesh);
    aimedAt = surface;
    return item;
}

/// The surface is met without what stands before it, the arm above all.
bool Viewport::beginAim(const PickView& view, const glm::dvec2& pixel, NodeId surface,
                        std::shared_ptr<const PickScene> scene)
{
    const NodeId arm = d->armForTarget();
    if (arm == noNode || arm == surface)
        return false;
    if (!d->aimAt(surface, std::move(scene)) || !d->aimedPoint(view, pixel))
        return false;
    d->aimingArm = arm;
    d->aimGesture = newGesture();
    d->gesture = Gesture::Aim;
    aimAt(view, pixel);
    return true;
}

/// Where the ray under the cursor meets the surface that is aimed at, world: in its place of now, wherever
/// tracks have moved it to.
std::optional<glm::dvec3> Viewport::Private::aimedPoint(const PickView& view, const glm::dvec2& pixel) const
{
    const MeshItem* item = surfaceOf(aimedAt);
    if (!item)
        return std::nullopt;
    if (aimedScene)
        return aimedScene->meet(view, pixel, aimedAt, item->world);
    const ViewRay ray = view.camera.ray(view.ndc(pixel), view.aspect());
    const glm::dmat4 inverse = glm::inverse(item->world);
    const auto hit = aimedRays.nearest(
        {glm::dvec3(inverse * glm::dvec4(ray.origin, 1.0)), glm::dmat3(inverse) * ray.direction});
    if (!hit)
        return std::nullopt;
    return glm::dvec3(item->world * glm::dvec4(hit->point, 1.0));
}

void Viewport::aimAt(const PickView& view, const glm::dvec2& pixel)
{
    const auto world = d->aimedPoint(view, pixel);
    if (!world)
        return;
    const glm::dvec3 target = inArmSpace(d->document->scene(), d->aimingArm, d->timeNow(), *world);
    const ParamDef& def = *findParam("arm.target");
    const auto done = d->context.keys && d->context.keys->takes({d->aimingArm}, def)
                          ? d->context.keys->set({d->aimingArm}, def, target, std::nullopt, d->aimGesture)
                          : d->reach.aim(d->aimingArm, target, d->aimGesture);
    if (!done)
        emit messageRaised(errorText(done.error()));
    update();
}

std::vector<ArmRing> Viewport::Private::rings() const
{
    const NodeId active = document->selection().activeNode();
    const Scene& all = document->scene();
    const ArmProgress* progress = reach.progress();
    const Node* node = all.find(active);
    const bool follows = node && node->params.arm.follows && player && player->frame() > 0;
    const bool moves = follows || (player && player->isPlaying()) ||
                       (progress && progress->node == active && progress->moves);
    return moves || !all.isShown(active) || all.isLocked(active) ? std::vector<ArmRing>()
                                                                 : armRings(all, active, timeNow());
}

/// Of all arms in sight that follow one, world.
std::vector<glm::dvec3> Viewport::Private::targets() const
{
    std::vector<glm::dvec3> found;
    const Scene& all = document->scene();
    EvaluatedScene now(all, timeNow());
    for (const Node& node : all.nodes()) {
        if (node.kind != NodeKind::Arm || !node.params.arm.follows || !all.isShown(node.id))
            continue;
        found.emplace_back(now.transforms(node).geometry * armUpright() *
                           glm::dvec4(now.params(node).arm.target, 1.0));
    }
    return found;
}

bool Viewport::beginRing(const PickView& view, const glm::dvec2& pixel)
{
    const auto rings = d->rings();
    const auto found = ringUnder(view, pixel, rings);
    const auto angle = found ? ringAngle(view, pixel, rings[*found]) : std::nullopt;
    if (!angle)
        return false;
    d->ring = found;
    d->ringAtPress = rings[*found];
    d->ringFrom = *angle;
    d->ringGesture = newGesture();
    d->gesture = Gesture::Ring;
    update();
    return true;
}

void Viewport::turnRing(const PickView& view, const glm::dvec2& pixel)
{
    const NodeId arm = d->document->selection().activeNode();
    const Node* node = d->document->scene().find(arm);
    const auto angle = ringAngle(view, pixel, d->ringAtPress);
    if (!node || !angle || d->ringAtPress.joint >= node->params.joints.size())
        return;
    std::vector<ArmJoint> joints = node->params.joints;
    ArmJoint& joint = joints[d->ringAtPress.joint];
    ArmAngle& turned = d->ringAtPress.phi ? joint.phi : joint.theta;
    turned.angleRad = turnedBy(d->ringAtPress.angle, d->ringFrom, *angle);
    const Channel channel{ChannelPart::Joint, static_cast<std::uint8_t>(d->ringAtPress.joint),
                          static_cast<ParamId>(jointAngleNumber(d->ringAtPress.phi))};
    if (d->context.keys && d->context.keys->takes(arm, channel)) {
        if (const auto done = d->context.keys->set(arm, channel, turned.angleRad, d->ringGesture); !done)
            emit messageRaised(errorText(done.error()));
        return;
    }
    edit::setJoints(*d->document, arm, std::move(joints), tr("Turn joint %1").arg(d->ringAtPress.joint + 1),
                    d->ringGesture);
}

/// How the arm does: of the one on its way, or of the active one in the player's frame.
void Viewport::paintArm(QPainter& painter)
{
    const PickView view{d->camera, glm::dvec2(width(), height())};
    for (const glm::dvec3& target : d->targets())
        paintTarget(painter, view, target);
    paintRings(painter, view, d->rings(), d->ring);
    const auto motion = d->player && d->player->frame() > 0 ? d->player->motion() : nullptr;
    const NodeMotion* played = motion ? motion->of(d->armForTarget()) : nullptr;
    if (played && played->arm)
        return paintArmStatus(painter, size(), *played->arm);
    if (const ArmProgress* progress = d->reach.progress(); progress && !motion)
        paintArmStatus(painter, size(), *progress);
}

} // namespace ramure
