// The target of an arm is dragged by its mark, or set and dragged on a surface; where targets are, and how
// the arm does.
#include "core/evaluate/evaluator.h"
#include "core/rig/arm/arm_chain.h"
#include "core/scene/object_mesh.h"
#include "core/surface/mesh/mesh_rays.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/view/tools/arm/arm_overlay.h"
#include "widgets/view/tools/motion_tools.h"
#include "widgets/view/tools/tool_table.h"
#include <QCoreApplication>
#include <algorithm>
#include <limits>
#include <utility>

namespace ramure {
namespace {

/// Triangles that are sorted for rays within a few milliseconds.
constexpr Index fewTriangles = 40'000;
constexpr double markReach = 12.0; ///< logical pixels around a target that are its mark

/// From the arm's own space into the world.
glm::dmat4 placeOfArm(EvaluatedScene& now, NodeId arm)
{
    return now.transforms(arm).geometry * armUpright();
}

class TargetTool : public Tool
{
    Q_DECLARE_TR_FUNCTIONS(ramure::TargetTool)
public:
    using Tool::Tool;

    bool hover(const ToolPoint& point) override;
    void leave() override { markUnder(std::nullopt); }
    [[nodiscard]] QCursor cursor() const override { return Qt::SizeAllCursor; }
    bool press(const ToolPoint& point) override;
    void drag(const ToolPoint& point) override
    {
        if (!m_mark || point.isDrag())
            aim(point);
    }
    void release(const ToolPoint&) override;
    void cancel() override;

    [[nodiscard]] QString hint(Qt::KeyboardModifiers) const override
    {
        return tr("The arm reaches for the point under the cursor · release: done");
    }
    [[nodiscard]] QString hintAt(const ToolPoint& point) const override
    {
        return point.held == Qt::NoModifier && markAt(point)
                   ? tr("Drag: the target of the arm moves across the view · Ctrl + click: onto a surface")
                   : QString();
    }
    void offer(ToolOffers& offers) const override;
    void paint(QPainter& painter, const PickView& view) override;

private:
    /// Of an arm that follows it.
    struct Mark
    {
        NodeId arm = noNode;
        glm::dvec3 at{0.0}; ///< world
        bool operator==(const Mark&) const = default;
    };
    [[nodiscard]] std::vector<Mark> marks() const;
    [[nodiscard]] std::optional<Mark> markAt(const ToolPoint& point) const;
    void markUnder(const std::optional<Mark>& mark);
    void hold();
    [[nodiscard]] bool isOnMovingBranch(const ToolPoint& point) const;
    [[nodiscard]] bool isFree(const Node& arm) const;
    [[nodiscard]] NodeId armForTarget() const;
    bool beginOn(const ToolPoint& point, NodeId surface, std::shared_ptr<const PickScene> scene);
    bool beginAnyway(const ToolPoint& point);
    const MeshItem* lookAt(NodeId surface, std::shared_ptr<const PickScene> scene);
    [[nodiscard]] const MeshItem* itemOf(NodeId surface) const;
    [[nodiscard]] std::optional<glm::dvec3> met(const ToolPoint& point) const;
    void aim(const ToolPoint& point);
    void letGo();

    std::optional<Mark> m_mark; ///< under the cursor; while it goes on the one that the hand has
    NodeId m_arm = noNode;
    NodeId m_surface = noNode;                ///< on which the target moves; noNode: across the view
    std::shared_ptr<const PickScene> m_scene; ///< in which it is met; null: m_rays
    MeshRays m_rays;                          ///< of a small surface that no pick scene has yet
    GestureId m_gesture = 0;
};

bool TargetTool::isFree(const Node& arm) const
{
    const Scene& all = m_context.document.scene();
    return arm.kind == NodeKind::Arm && all.isShown(arm.id) && !all.isLocked(arm.id);
}

/// The active one, else the first that is shown.
NodeId TargetTool::armForTarget() const
{
    const Scene& all = m_context.document.scene();
    const Node* active = all.find(m_context.document.selection().activeNode());
    if (active && isFree(*active))
        return active->id;
    const auto found = std::ranges::find_if(all.nodes(), [this](const Node& node) { return isFree(node); });
    return found == all.nodes().end() ? noNode : found->id;
}

/// Of all arms in sight that follow one.
std::vector<TargetTool::Mark> TargetTool::marks() const
{
    const Scene& all = m_context.document.scene();
    EvaluatedScene now(all, m_context.seconds());
    std::vector<Mark> found;
    for (const Node& node : all.nodes())
        if (node.kind == NodeKind::Arm && node.params.arm.follows && all.isShown(node.id))
            found.push_back({node.id, glm::dvec3(placeOfArm(now, node.id) *
                                                 glm::dvec4(now.params(node).arm.target, 1.0))});
    return found;
}

/// The nearest to the cursor that may be moved.
std::optional<TargetTool::Mark> TargetTool::markAt(const ToolPoint& point) const
{
    std::optional<Mark> nearest;
    double least = markReach;
    for (const Mark& mark : marks()) {
        const auto pixel = point.view.pixel(mark.at);
        const double away = pixel ? glm::distance(*pixel, point.pixel()) : least;
        if (away < least && isFree(*m_context.document.scene().find(mark.arm))) {
            least = away;
            nearest = mark;
        }
    }
    return nearest;
}

void TargetTool::markUnder(const std::optional<Mark>& mark)
{
    if (m_mark == mark)
        return;
    m_mark = mark;
    m_context.host.repaint();
}

bool TargetTool::hover(const ToolPoint& point)
{
    if (!isBusy())
        markUnder(point.held == Qt::NoModifier ? markAt(point) : std::nullopt);
    return m_mark.has_value();
}

void TargetTool::hold()
{
    m_gesture = newGesture();
    m_context.document.holdGesture(m_gesture);
}

/// While everything moves, presses there pull the branch.
bool TargetTool::isOnMovingBranch(const ToolPoint& point) const
{
    return m_context.isPlaying() &&
           branchUnder(point.view, point.pixel(), m_context.document, *m_context.player->motion());
}

bool TargetTool::press(const ToolPoint& point)
{
    if (point.button != Qt::LeftButton)
        return false;
    if (point.held == Qt::NoModifier) {
        markUnder(markAt(point));
        if (!m_mark)
            return false;
        m_arm = m_mark->arm;
        m_surface = noNode;
        hold();
        return true;
    }
    if (!point.held.testFlag(Qt::ControlModifier) || isOnMovingBranch(point))
        return false;
    const auto scene = m_context.host.pickScene(pickPatience);
    if (!scene)
        return beginAnyway(point);
    const auto hit = scene->pick(point.view, point.pixel());
    const Node* node = hit ? m_context.document.scene().find(hit->node) : nullptr;
    return node && node->kind != NodeKind::Tree && beginOn(point, hit->node, scene);
}

/// The surface is met without what stands before it, the arm above all.
bool TargetTool::beginOn(const ToolPoint& point, NodeId surface, std::shared_ptr<const PickScene> scene)
{
    m_arm = armForTarget();
    if (m_arm == noNode || m_arm == surface || !lookAt(surface, std::move(scene)) || !met(point))
        return false;
    markUnder(std::nullopt);
    hold();
    aim(point);
    return true;
}

/// What is picked in is still being made (while everything moves it never is): surfaces are met in that of a
/// moment ago, in their place of now. The nearest of them counts.
bool TargetTool::beginAnyway(const ToolPoint& point)
{
    NodeId nearest = noNode;
    double least = std::numeric_limits<double>::infinity();
    const auto scene = m_context.host.latestPickScene();
    const Scene& all = m_context.document.scene();
    for (const Node& node : all.nodes()) {
        if (!isObject(node.kind) || all.isLocked(node.id) || !lookAt(node.id, scene))
            continue;
        const auto at = met(point);
        const double away = at ? glm::distance(*at, point.view.camera.eye()) : least;
        if (away < least) {
            least = away;
            nearest = node.id;
        }
    }
    return nearest != noNode && beginOn(point, nearest, scene);
}

/// What shows the surface, where it is now.
const MeshItem* TargetTool::itemOf(NodeId surface) const
{
    for (const MeshItem& item : m_context.host.shownScene().meshes)
        if (item.node == surface && !item.isMark)
            return &item;
    return nullptr;
}

/// Looks for the surface of a node that can be met at once. \p scene may be null. \return its item
const MeshItem* TargetTool::lookAt(NodeId surface, std::shared_ptr<const PickScene> scene)
{
    const MeshItem* item = itemOf(surface);
    m_surface = noNode;
    m_scene = nullptr;
    // What is bent is another mesh there.
    if (item && scene && scene->hasSurface(surface, item->motion.moves() ? nullptr : item->mesh.get()))
        m_scene = std::move(scene);
    if (!item || (!m_scene && (item->motion.moves() || item->mesh->faceCount() > fewTriangles)))
        return nullptr;
    if (!m_scene && m_rays.mesh() != item->mesh)
        m_rays = MeshRays(item->mesh);
    m_surface = surface;
    return item;
}

/// Where the ray under the cursor meets the surface, world: in its place of now, wherever tracks have moved
/// it to.
std::optional<glm::dvec3> TargetTool::met(const ToolPoint& point) const
{
    const MeshItem* item = itemOf(m_surface);
    if (!item)
        return std::nullopt;
    const PickView& view = point.view;
    if (m_scene)
        return m_scene->meet(view, point.pixel(), m_surface, item->world);
    const ViewRay ray = view.camera.ray(view.ndc(point.pixel()), view.aspect());
    const glm::dmat4 inverse = glm::inverse(item->world);
    const auto hit = m_rays.nearest(
        {glm::dvec3(inverse * glm::dvec4(ray.origin, 1.0)), glm::dmat3(inverse) * ray.direction});
    if (!hit)
        return std::nullopt;
    return glm::dvec3(item->world * glm::dvec4(hit->point, 1.0));
}

void TargetTool::aim(const ToolPoint& point)
{
    const auto world = m_mark ? std::optional(pulledTo(point.view, point.pixel(), m_mark->at)) : met(point);
    if (!world)
        return;
    EvaluatedScene now(m_context.document.scene(), m_context.seconds());
    const glm::dvec3 target(glm::inverse(placeOfArm(now, m_arm)) * glm::dvec4(*world, 1.0));
    if (const auto done = m_context.reach.reachFor(m_arm, target, m_gesture); !done)
        m_context.host.raiseMessage(errorText(done.error()));
    m_context.host.repaint();
}

void TargetTool::release(const ToolPoint&)
{
    m_context.document.keepGesture(m_gesture);
    letGo();
}

void TargetTool::cancel()
{
    m_context.document.giveUpGesture(m_gesture);
    letGo();
}

void TargetTool::letGo()
{
    markUnder(std::nullopt);
    m_context.host.dispose(std::exchange(m_scene, nullptr));
}

void TargetTool::offer(ToolOffers& offers) const
{
    const Node* node = m_context.document.scene().find(m_context.hoverNode);
    if (m_context.isOverBranch() || !node || node->kind == NodeKind::Tree || node->kind == NodeKind::Arm ||
        armForTarget() == noNode)
        return;
    if (offers.held() == Qt::NoModifier)
        offers.add(ToolOffers::Drag, tr("Ctrl + click: target of the arm"));
    else if (offers.held() == Qt::ControlModifier)
        offers.add(ToolOffers::Drag, tr("Ctrl: click or drag sets the target of the arm"));
}

/// The targets, and how the arm that is shown does.
void TargetTool::paint(QPainter& painter, const PickView& view)
{
    for (const Mark& mark : marks())
        paintTarget(painter, view, mark.at, m_mark && m_mark->arm == mark.arm);
    if (const ArmProgress* shown = m_context.reach.shown(armForTarget()))
        paintArmStatus(painter, sizeOf(view), *shown);
}

} // namespace

std::unique_ptr<Tool> makeTargetTool(ToolContext& context)
{
    return std::make_unique<TargetTool>(context);
}

} // namespace ramure
