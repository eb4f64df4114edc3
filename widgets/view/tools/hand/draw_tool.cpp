// A stroke becomes a branch: a new one, from another or from the ground; what a tip goes on by; or the way of
// one that is there.
#include "core/math/frame.h"
#include "widgets/view/tools/hand/edit_tool.h"
#include "widgets/view/tools/hand/stroke.h"
#include "widgets/view/tools/motion_tools.h"
#include "widgets/view/tools/readout.h"
#include "widgets/view/tools/tool_table.h"
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
constexpr double ofLength = 1.0 / 40.0;         ///< radius of the foot at most, of the stroke's length
constexpr double softest = 0.35, hardest = 1.4; ///< radius by pressure or speed, of the usual one
constexpr double quick = 1.6;                   ///< logical pixels per ms, where a stroke is thinnest
constexpr double oldPace = 0.7;                 ///< share of the speed before: hands go by jerks
constexpr double leastWay = 3.0;                ///< logical pixels from one place to the next

class DrawTool : public EditTool
{
    Q_DECLARE_TR_FUNCTIONS(ramure::DrawTool)
public:
    DrawTool(ToolContext& context, HandTool kind)
        : EditTool(context, kind)
        , m_kind(kind)
    {
    }

    [[nodiscard]] bool goesOn() const override { return isBusy(); }
    void drag(const ToolPoint& point) override;
    void release(const ToolPoint& point) override;
    void cancel() override;
    [[nodiscard]] QString hint(Qt::KeyboardModifiers) const override;
    void offer(ToolOffers& offers) const override;
    void paint(QPainter& painter, const PickView& view) override;

protected:
    bool take(const ToolPoint& point, const std::optional<LimbHit>& limb) override;
    void forget() override
    {
        m_edit.reset();
        m_drawn.clear();
    }
    std::vector<Index> affected(const LimbHit& limb) override;

private:
    std::optional<LimbHit> groundUnder(const ToolPoint& point);
    std::optional<LimbHit> tipOf(const LimbHit& limb);
    void addPoint(const ToolPoint& point);
    double thicknessAt(const ToolPoint& point);
    [[nodiscard]] std::vector<StrokePoint> stroke() const;
    [[nodiscard]] std::vector<TreeEdit> branches(const glm::dvec3& sight) const;
    [[nodiscard]] std::vector<TreeEdit> newWays() const;
    [[nodiscard]] TreeEdit newWay(std::uint64_t address, const SymmetryMap& map) const;
    Expected<void> grow(const PickView& view);
    [[nodiscard]] double footRadius(const LimbHit& limb) const;
    [[nodiscard]] double drawnLength() const;
    [[nodiscard]] QString radiusText(const LimbHit& limb) const;

    HandTool m_kind;
    std::unique_ptr<HandEdit> m_edit;
    LimbHit m_limb;          ///< without an address: the ground
    glm::dvec2 m_aside{0.0}; ///< logical pixels from where the hand is to where it draws
    glm::dmat4 m_world{1.0}, m_inverse{1.0};
    std::vector<LimbTwin> m_twins;    ///< Extend and Redraw: limbs that change with it
    std::vector<StrokePoint> m_drawn; ///< tree space, as it is seen; the hand's share of the radius as radius
    QPointF m_at;
    std::uint64_t m_when = 0; ///< ms, of m_at
    double m_pace = 0.0;      ///< logical pixels per ms
};

bool DrawTool::take(const ToolPoint& point, const std::optional<LimbHit>& limb)
{
    const bool isNew = m_kind == HandTool::Draw;
    const auto from = limb && m_kind == HandTool::Extend ? tipOf(*limb)
                      : limb || !isNew                   ? limb
                                                         : groundUnder(point);
    if (!from) {
        m_context.host.raiseMessage(isNew ? tr("A new branch begins on a branch, or on the ground near the "
                                               "tree: press there, and drag.")
                                          : tr("Press on the branch that is meant, and drag."));
        return true; // the drag that follows selects nothing
    }
    auto edit = HandEdit::begin(m_context.document, from->node);
    if (!edit)
        return refuse(edit.error());
    m_edit = std::move(*edit);
    m_limb = *from;
    m_world = worldOf(from->node);
    m_inverse = glm::inverse(m_world);
    // A tip is also drawn on from afar: it goes as the hand goes.
    const auto begins = point.view.pixel(glm::dvec3(m_world * glm::dvec4(m_limb.seen, 1.0)));
    m_aside = m_kind == HandTool::Extend && begins ? *begins - point.pixel() : glm::dvec2(0.0);
    m_at = point.at;
    m_when = point.milliseconds;
    m_pace = 0.0;
    m_drawn = {{m_limb.seen, thicknessAt(point)}};
    m_twins.clear();
    if (!isNew) {
        Symmetry symmetry = symmetryOf(from->node);
        m_twins = symmetry.twins(from->axis);
        reportMissing(symmetry);
    }
    setAim({});
    return true;
}

std::optional<LimbHit> DrawTool::tipOf(const LimbHit& limb)
{
    const auto branches = m_context.limbs.limb(m_context.document, limb.node, limb.address);
    auto tip = branches.empty() ? std::nullopt
                                : m_context.limbs.startOf(m_context.document, limb.node, branches.back());
    if (!tip)
        return tip;
    const Skeleton& skeleton = tip->simplified->skeleton;
    tip->share = 1.0;
    tip->seen = skeleton.p1[branches.back()];
    tip->radius = skeleton.a1[branches.back()];
    return tip;
}

/// On the ground that the tree that is meant stands on; nothing far away from it.
std::optional<LimbHit> DrawTool::groundUnder(const ToolPoint& point)
{
    constexpr double farthest = 2.0; // times the height of the tree, or its width
    const NodeId tree = treeMeant(m_context.document);
    const TreeAxes* axes = m_context.limbs.axes(m_context.document, tree);
    if (!axes || axes->axes.empty() || m_context.document.scene().isLocked(tree))
        return std::nullopt;
    const Skeleton& skeleton = m_context.limbs.tree(m_context.document, tree)->simplified->skeleton;
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

/// In the plane across the sight through the place where the stroke begins.
void DrawTool::addPoint(const ToolPoint& point)
{
    const glm::dvec3 foot(m_world * glm::dvec4(m_limb.seen, 1.0));
    const glm::dvec3 there = pulledTo(point.view, point.pixel() + m_aside, foot);
    m_drawn.push_back({glm::dvec3(m_inverse * glm::dvec4(there, 1.0)), thicknessAt(point)});
}

/// Of the usual radius: by the pen, or by how quick the hand has come here.
double DrawTool::thicknessAt(const ToolPoint& point)
{
    const DrawBy by = m_context.hand.options().drawBy;
    if (by == DrawBy::Pressure && point.pressure)
        return glm::mix(softest, hardest, std::clamp(*point.pressure, 0.0, 1.0));
    if (by != DrawBy::Speed)
        return 1.0;
    if (point.milliseconds > m_when && m_when > 0) {
        const QPointF way = point.at - m_at;
        const double pace = std::hypot(way.x(), way.y()) / double(point.milliseconds - m_when);
        m_pace = m_drawn.size() < 2 ? pace : glm::mix(pace, m_pace, oldPace);
    }
    return glm::mix(hardest, softest, std::clamp(m_pace / quick, 0.0, 1.0));
}

/// Unless it was chosen, a new branch is thinner than what it grows on, and slender for its length.
double DrawTool::footRadius(const LimbHit& limb) const
{
    if (m_kind != HandTool::Draw)
        return std::max(limb.radius, 1e-4);
    if (const double chosen = m_context.hand.options().drawRadius; chosen > 0.0)
        return chosen;
    const double length = drawnLength(), usual = ofParent * limb.radius;
    return std::max(length > 0.0 ? std::min(usual, ofLength * length) : usual, 1e-4);
}

/// In metres.
double DrawTool::drawnLength() const
{
    double length = 0.0;
    for (std::size_t i = 1; i < m_drawn.size(); ++i)
        length += glm::length(m_drawn[i].position - m_drawn[i - 1].position);
    return length;
}

QString DrawTool::radiusText(const LimbHit& limb) const
{
    const double cm = 100.0 * footRadius(limb);
    return tr("radius %1 cm").arg(QLocale().toString(cm, 'f', cm < 1.0 ? 2 : 1));
}

std::vector<StrokePoint> DrawTool::stroke() const
{
    const HandOptions& options = m_context.hand.options();
    StrokeShape shape;
    shape.smoothing = options.drawSmooth;
    shape.footRadius = footRadius(m_limb);
    shape.tipRadius = options.drawTip * shape.footRadius;
    return strokeBranch(m_drawn, shape);
}

/// The stroke, and where that is wanted its copies around the parent and mirrored.
/// \param sight tree space
std::vector<TreeEdit> DrawTool::branches(const glm::dvec3& sight) const
{
    const HandOptions& options = m_context.hand.options();
    const std::vector<StrokePoint> line = stroke();
    const bool isGround = m_limb.address == 0;
    const glm::dvec3 middle = isGround ? glm::dvec3(0.0) : m_limb.seen; // of the copies
    std::vector<TreeEdit> edits;
    for (int copy = 0; copy < options.copies && !line.empty(); ++copy)
        for (int side = 0; side < (options.mirrored ? 2 : 1); ++side) {
            const double angle = 2.0 * std::numbers::pi * copy / options.copies;
            TreeEdit edit;
            edit.operation = EditOperation::Draw;
            edit.target.address = m_limb.address;
            edit.at = m_limb.share;
            edit.below = options.drawTwigs;
            for (std::size_t i = isGround ? 0 : 1; i < line.size(); ++i) {
                glm::dvec3 way = line[i].position - middle;
                const glm::dvec3 across = glm::cross(m_limb.along, sight);
                if (side == 1 && glm::dot(across, across) > 1e-12)
                    way -= 2.0 * glm::dot(way, across) / glm::dot(across, across) * across;
                way = glm::angleAxis(angle, m_limb.along) * way;
                edit.points.push_back({middle + way, line[i].radius});
            }
            edits.push_back(std::move(edit));
        }
    return edits;
}

/// Extend goes on from the tip; Redraw keeps the way of the limb up to where the stroke begins.
TreeEdit DrawTool::newWay(std::uint64_t address, const SymmetryMap& map) const
{
    constexpr double atFoot = 0.03, piece = 0.125; // of the limb's length
    TreeEdit edit;
    edit.operation = m_kind == HandTool::Extend ? EditOperation::Extend : EditOperation::Redraw;
    edit.target.address = address;
    if (m_kind == HandTool::Redraw && m_limb.share > atFoot) {
        const int kept = static_cast<int>(std::ceil(m_limb.share / piece));
        for (int i = 1; i <= kept; ++i)
            if (const auto on = m_edit->context().pointOn(address, m_limb.share * i / kept))
                edit.points.push_back({on->position, 0.0});
    }
    const std::vector<StrokePoint> line = stroke();
    // On a limb that is like it the stroke begins at the same share of its length.
    const glm::dvec3 start = m_limb.seen;
    const auto there = m_edit->context().pointOn(address, m_limb.share);
    const glm::dvec3 begin = there && address != m_limb.address ? there->position : start;
    for (std::size_t i = 1; i < line.size(); ++i)
        edit.points.push_back({begin + map.turn * (line[i].position - start), line[i].radius});
    if (line.empty())
        edit.points.clear();
    return edit;
}

/// Of the limb that was drawn on, and of those that are like it around the trunk.
std::vector<TreeEdit> DrawTool::newWays() const
{
    std::vector<TreeEdit> edits{newWay(m_limb.address, {})};
    for (const LimbTwin& twin : m_twins)
        edits.push_back(newWay(twin.address, twin.map));
    return edits;
}

Expected<void> DrawTool::grow(const PickView& view)
{
    const glm::dvec3 foot(m_world * glm::dvec4(m_limb.seen, 1.0));
    const glm::dvec3 sight(m_inverse * glm::dvec4(foot - view.camera.eye(), 0.0));
    const std::vector<TreeEdit> edits =
        m_kind == HandTool::Draw ? branches(glm::normalize(sight)) : newWays();
    if (edits.empty() || edits.front().points.empty())
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the stroke goes nowhere"));
    return m_edit->replace(edits).and_then([this] { return m_edit->show(); });
}

void DrawTool::drag(const ToolPoint& point)
{
    const QPointF way = point.at - m_at;
    if (!m_edit || std::hypot(way.x(), way.y()) < leastWay)
        return;
    addPoint(point);
    m_at = point.at;
    m_when = point.milliseconds;
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

QString DrawTool::hint(Qt::KeyboardModifiers) const
{
    if (!m_edit)
        return m_kind == HandTool::Draw
                   ? tr("Nothing grows from here: release, and press on a branch or the ground")
                   : tr("Nothing happens here: release, and press on the branch that is meant");
    return m_kind == HandTool::Draw ? tr("A branch grows along the line · release: done · Esc: none")
           : m_kind == HandTool::Extend
               ? tr("The tip grows on along the line · release: done · Esc: as it was")
               : tr("The branch goes along the line · release: done · Esc: as it was");
}

void DrawTool::offer(ToolOffers& offers) const
{
    if (!isChosen() || offers.held() != Qt::NoModifier)
        return;
    offers.add(ToolOffers::Drag,
               m_kind == HandTool::Draw ? tr("Drag from a branch or the ground: a new branch along the line")
               : m_kind == HandTool::Extend ? tr("Drag a branch: its tip grows on as the hand goes")
                                            : tr("Drag from a branch: from there on it goes along the line"));
}

std::vector<Index> DrawTool::affected(const LimbHit& limb)
{
    std::vector<Index> all;
    if (m_kind == HandTool::Draw)
        return all;
    Symmetry symmetry = symmetryOf(limb.node);
    for (const LimbHit& each : withTwins({limb}, symmetry)) {
        const auto own = m_context.limbs.limb(m_context.document, each.node, each.address);
        all.insert(all.end(), own.begin(), own.end());
    }
    return all;
}

void DrawTool::paint(QPainter& painter, const PickView& view)
{
    if (!m_edit) {
        if (aim())
            paintRing(painter, view, worldOf(aim()->node), *aim(), handGreen);
        const auto foot = aim() && m_kind == HandTool::Draw
                              ? view.pixel(glm::dvec3(worldOf(aim()->node) * glm::dvec4(aim()->seen, 1.0)))
                              : std::nullopt;
        if (foot)
            paintReadout(painter, {foot->x, foot->y}, sizeOf(view), radiusText(*aim()));
        return;
    }
    QPolygonF line;
    for (const StrokePoint& drawn : m_drawn)
        if (const auto at = view.pixel(glm::dvec3(m_world * glm::dvec4(drawn.position, 1.0))))
            line << QPointF(at->x, at->y);
    painter.setPen(QPen(QColor(16, 22, 28, 150), 4.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);
    painter.setPen(QPen(handGreen, 2.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);
    paintReadout(painter, m_at, sizeOf(view),
                 tr("%1 m").arg(QLocale().toString(drawnLength(), 'f', 2)) + QStringLiteral(" · ") +
                     radiusText(m_limb));
}

} // namespace

template <HandTool tool> std::unique_ptr<Tool> makeDrawTool(ToolContext& context)
{
    return std::make_unique<DrawTool>(context, tool);
}
template std::unique_ptr<Tool> makeDrawTool<HandTool::Draw>(ToolContext&);
template std::unique_ptr<Tool> makeDrawTool<HandTool::Extend>(ToolContext&);
template std::unique_ptr<Tool> makeDrawTool<HandTool::Redraw>(ToolContext&);

} // namespace ramure
