// A stroke from a branch, or from the ground, becomes a branch.
#include "core/math/frame.h"
#include "widgets/view/tools/edit_tool.h"
#include "widgets/view/tools/motion_tools.h"
#include "widgets/view/tools/readout.h"
#include "widgets/view/tools/stroke.h"
#include "widgets/view/tools/tool_table.h"
#include "widgets/view/tools/turned_limb.h"
#include <QCoreApplication>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ramure {
namespace {

constexpr double ofParent = 0.55;               ///< radius of the foot, of what it grows on there
constexpr double softest = 0.35, hardest = 1.4; ///< radius by pressure, of the usual one
constexpr double leastWay = 3.0;                ///< logical pixels from one place to the next

class DrawTool : public EditTool
{
    Q_DECLARE_TR_FUNCTIONS(ramure::DrawTool)
public:
    explicit DrawTool(ToolContext& context)
        : EditTool(context, HandTool::Draw)
    {
    }

    [[nodiscard]] bool goesOn() const override { return isBusy(); }
    void drag(const ToolPoint& point) override;
    void release(const ToolPoint& point) override;
    void cancel() override;
    [[nodiscard]] QString hint(Qt::KeyboardModifiers) const override
    {
        return tr("A branch grows along the line · release: done · Esc: none");
    }
    void offer(ToolOffers& offers) const override
    {
        if (isChosen() && offers.held() == Qt::NoModifier)
            offers.add(ToolOffers::Drag, tr("Drag from a branch or the ground: a new branch along the line"));
    }
    void paint(QPainter& painter, const PickView& view) override;

protected:
    bool take(const ToolPoint& point, const std::optional<LimbHit>& limb) override;
    void forget() override
    {
        m_edit.reset();
        m_drawn.clear();
    }

private:
    std::optional<LimbHit> groundUnder(const ToolPoint& point);
    void addPoint(const ToolPoint& point);
    [[nodiscard]] double pressureOf(const ToolPoint& point) const;
    [[nodiscard]] std::vector<TreeEdit> branches(const glm::dvec3& sight) const;
    Expected<void> grow(const PickView& view);
    [[nodiscard]] double footRadius() const;

    std::unique_ptr<HandEdit> m_edit;
    LimbHit m_limb; ///< without an address: the ground
    glm::dmat4 m_world{1.0}, m_inverse{1.0};
    TurnedLimb m_turned;
    std::vector<StrokePoint> m_drawn; ///< tree space, as it is seen; the pen's share of the radius as radius
    QPointF m_at;
};

bool DrawTool::take(const ToolPoint& point, const std::optional<LimbHit>& limb)
{
    const auto from = limb ? limb : groundUnder(point);
    if (!from) {
        m_context.host.raiseMessage(
            tr("A new branch begins on a branch, or on the ground near the tree: press there, and drag."));
        return true; // the drag that follows selects nothing
    }
    auto edit = HandEdit::begin(m_context.document, from->node);
    if (!edit)
        return report(tl::unexpected(edit.error()));
    m_edit = std::move(*edit);
    m_limb = *from;
    m_world = worldOf(from->node);
    m_inverse = glm::inverse(m_world);
    m_turned = limb ? TurnedLimb(m_context.document, *limb) : TurnedLimb();
    m_drawn = {{m_limb.seen, pressureOf(point)}};
    m_at = point.at;
    setAim({});
    return true;
}

/// On the ground that the tree that is meant stands on; nothing far away from it.
std::optional<LimbHit> DrawTool::groundUnder(const ToolPoint& point)
{
    constexpr double farthest = 2.0; // times the height of the tree, or its width
    const NodeId tree = treeMeant(m_context.document);
    const TreeAxes* axes = m_context.limbs.axes(m_context.document, tree);
    if (!axes || axes->axes.empty() || m_context.document.scene().isLocked(tree))
        return std::nullopt;
    const Skeleton& skeleton = m_context.document.result(tree)->tree.simplified->skeleton;
    const SkeletonStats stats = skeletonStats(skeleton);
    const glm::dmat4 inverse = glm::inverse(worldOf(tree));
    const ViewRay ray = point.view.camera.ray(point.view.ndc(point.pixel()), point.view.aspect());
    const glm::dvec3 eye(inverse * glm::dvec4(ray.origin, 1.0)),
        way(inverse * glm::dvec4(ray.direction, 0.0));
    const glm::dvec3 foot = skeleton.p0[0];
    const double share = (foot.y - eye.y) / way.y;
    const glm::dvec3 at = eye + share * way;
    if (!(share > 0.0) || glm::length(at - foot) > farthest * glm::length(stats.max - stats.min))
        return std::nullopt;
    LimbHit ground;
    ground.node = tree;
    ground.seen = at;
    ground.along = {0.0, 1.0, 0.0};
    ground.radius = skeleton.a0[0];
    return ground;
}

/// In the plane across the sight through the foot.
void DrawTool::addPoint(const ToolPoint& point)
{
    const glm::dvec3 foot(m_world * glm::dvec4(m_limb.seen, 1.0));
    const glm::dvec3 there = pulledTo(point.view, point.pixel(), foot);
    m_drawn.push_back({glm::dvec3(m_inverse * glm::dvec4(there, 1.0)), pressureOf(point)});
}

/// Of the radius.
double DrawTool::pressureOf(const ToolPoint& point) const
{
    const bool pen = point.pressure && m_context.hand.options().drawPressure;
    return pen ? glm::mix(softest, hardest, std::clamp(*point.pressure, 0.0, 1.0)) : 1.0;
}

double DrawTool::footRadius() const
{
    const double chosen = m_context.hand.options().drawRadius;
    return chosen > 0.0 ? chosen : std::max(ofParent * m_limb.radius, 1e-4);
}

/// The stroke, and where that is wanted its copies around the parent and mirrored.
/// \param sight tree space
std::vector<TreeEdit> DrawTool::branches(const glm::dvec3& sight) const
{
    const HandOptions& options = m_context.hand.options();
    StrokeShape shape;
    shape.smoothing = options.drawSmooth;
    shape.footRadius = footRadius();
    shape.tipRadius = options.drawTip * shape.footRadius;
    const std::vector<StrokePoint> stroke = strokeBranch(m_drawn, shape);
    const bool isGround = m_limb.address == 0;
    const glm::dvec3 middle = isGround ? glm::dvec3(0.0) : m_limb.seen; // of the copies
    std::vector<TreeEdit> edits;
    for (int copy = 0; copy < options.copies && !stroke.empty(); ++copy)
        for (int side = 0; side < (options.mirrored ? 2 : 1); ++side) {
            const double angle = 2.0 * std::numbers::pi * copy / options.copies;
            TreeEdit edit;
            edit.operation = EditOperation::Draw;
            edit.target.address = m_limb.address;
            edit.at = m_limb.share;
            edit.below = options.drawTwigs && !isGround;
            for (std::size_t i = isGround ? 0 : 1; i < stroke.size(); ++i) {
                glm::dvec3 way = stroke[i].position - middle;
                const glm::dvec3 across = glm::cross(m_limb.along, sight);
                if (side == 1 && glm::dot(across, across) > 1e-12)
                    way -= 2.0 * glm::dot(way, across) / glm::dot(across, across) * across;
                way = glm::angleAxis(angle, m_limb.along) * way;
                edit.points.push_back({m_turned.grown(middle + way), stroke[i].radius});
            }
            edits.push_back(std::move(edit));
        }
    return edits;
}

Expected<void> DrawTool::grow(const PickView& view)
{
    const glm::dvec3 foot(m_world * glm::dvec4(m_limb.seen, 1.0));
    const glm::dvec3 sight(m_inverse * glm::dvec4(foot - view.camera.eye(), 0.0));
    const std::vector<TreeEdit> edits = branches(glm::normalize(sight));
    if (edits.empty())
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the stroke goes nowhere"));
    return m_edit->replace(edits).and_then([this] { return m_edit->show(); });
}

void DrawTool::drag(const ToolPoint& point)
{
    const QPointF way = point.at - m_at;
    if (!m_edit || std::hypot(way.x(), way.y()) < leastWay)
        return;
    m_at = point.at;
    addPoint(point);
    (void)grow(point.view); // as far as it goes: what cannot be is said at the end
    m_context.host.repaint();
}

void DrawTool::release(const ToolPoint& point)
{
    const auto edit = m_edit.get();
    if (edit && report(grow(point.view)))
        edit->keep();
    else if (edit)
        edit->cancel();
    forget();
    m_context.host.repaint();
}

void DrawTool::cancel()
{
    if (m_edit)
        m_edit->cancel();
    forget();
    m_context.host.repaint();
}

void DrawTool::paint(QPainter& painter, const PickView& view)
{
    if (!m_edit) {
        if (aim())
            paintRing(painter, view, worldOf(aim()->node), *aim(), handGreen);
        return;
    }
    QPolygonF line;
    double length = 0.0;
    for (std::size_t i = 0; i < m_drawn.size(); ++i) {
        if (const auto at = view.pixel(glm::dvec3(m_world * glm::dvec4(m_drawn[i].position, 1.0))))
            line << QPointF(at->x, at->y);
        length += i > 0 ? glm::length(m_drawn[i].position - m_drawn[i - 1].position) : 0.0;
    }
    painter.setPen(QPen(QColor(16, 22, 28, 150), 4.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);
    painter.setPen(QPen(handGreen, 2.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);
    paintReadout(painter, m_at, sizeOf(view), tr("%1 m").arg(QLocale().toString(length, 'f', 2)));
}

} // namespace

std::unique_ptr<Tool> makeDrawTool(ToolContext& context)
{
    return std::make_unique<DrawTool>(context);
}

} // namespace ramure
