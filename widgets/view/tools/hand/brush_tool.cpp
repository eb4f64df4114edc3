// A sphere under the hand: branches within it turn towards it, away from it or the way of the stroke; or
// leaves come and go.
#include "widgets/view/tools/hand/number_tool.h"
#include "widgets/view/tools/motion_tools.h"
#include "widgets/view/tools/readout.h"
#include "widgets/view/tools/tool_table.h"
#include <QCoreApplication>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

namespace ramure {
namespace {

constexpr double usualRadius = 0.12;   ///< of the tree's height or width
constexpr double radiusPerNotch = 1.1; ///< of the wheel
constexpr double spacing = 0.4;        ///< radii from one touch to the next
constexpr std::size_t mostTouches = 300;

class BrushTool : public NumberTool
{
    Q_DECLARE_TR_FUNCTIONS(ramure::BrushTool)
public:
    explicit BrushTool(ToolContext& context)
        : NumberTool(context, HandTool::Brush)
    {
        connect(&context.hand, &HandSettings::optionsChanged, this, [this] { m_context.host.repaint(); });
    }

    bool hover(const ToolPoint& point) override;
    void leave() override;
    void drag(const ToolPoint& point) override;
    void release(const ToolPoint& point) override;
    bool wheel(const ToolPoint& point, double turn) override;
    [[nodiscard]] QString hint(Qt::KeyboardModifiers) const override;
    void offer(ToolOffers& offers) const override;
    void paint(QPainter& painter, const PickView& view) override;

protected:
    bool take(const ToolPoint& point, const std::optional<LimbHit>& limb) override;
    std::vector<Index> affected(const LimbHit& limb) override;
    [[nodiscard]] bool isChanged() const override { return true; } // a click touches once
    void turnWheel(double notches) override;
    void show() override;

private:
    [[nodiscard]] BrushKind kind() const { return m_context.hand.options().brush; }
    [[nodiscard]] bool isMagnet() const { return kind() == BrushKind::Attract || kind() == BrushKind::Repel; }
    [[nodiscard]] bool isLeaves() const { return kind() == BrushKind::Bare || kind() == BrushKind::Leafy; }
    [[nodiscard]] double radius(NodeId tree) const;
    [[nodiscard]] double strength() const;
    void touch(const glm::dvec3& way);
    void joinTouches();
    [[nodiscard]] std::optional<glm::dvec3> besideTree(const ToolPoint& point, NodeId tree) const;

    NodeId m_tree = noNode;
    glm::dvec3 m_centre{0.0};  ///< m, tree space; of a magnet where it is now
    glm::dvec3 m_touched{0.0}; ///< where the last touch was
    Expected<void> m_done;     ///< what became of the last
};

/// As set, or to suit the tree.
double BrushTool::radius(NodeId tree) const
{
    const double chosen = m_context.hand.options().brushRadius;
    const TreeResult* shown = m_context.limbs.tree(m_context.document, tree);
    if (chosen > 0.0 || !shown)
        return chosen > 0.0 ? chosen : 1.0;
    const SkeletonStats stats = skeletonStats(shown->simplified->skeleton);
    const glm::dvec3 size = stats.max - stats.min;
    return std::max(usualRadius * std::max({size.x, size.y, size.z}), 1e-3);
}

double BrushTool::strength() const
{
    const auto percent = edit() ? typed().value() : std::nullopt;
    const double share = percent ? *percent / 100.0 : m_context.hand.options().brushStrength;
    return std::clamp(share, 0.0, 1.0) * (kind() == BrushKind::Repel ? -1.0 : 1.0);
}

/// Under the cursor, as far away as the middle of the tree.
std::optional<glm::dvec3> BrushTool::besideTree(const ToolPoint& point, NodeId tree) const
{
    const TreeResult* shown = m_context.limbs.tree(m_context.document, tree);
    if (!shown)
        return std::nullopt;
    const SkeletonStats stats = skeletonStats(shown->simplified->skeleton);
    const glm::dmat4 world = worldOf(tree);
    const glm::dvec3 middle(world * glm::dvec4(0.5 * (stats.min + stats.max), 1.0));
    return glm::dvec3(glm::inverse(world) * glm::dvec4(pulledTo(point.view, point.pixel(), middle), 1.0));
}

bool BrushTool::hover(const ToolPoint& point)
{
    EditTool::hover(point);
    if (!isChosen() || isBusy())
        return false;
    m_tree = aim() ? aim()->node : treeMeant(m_context.document);
    const auto place = aim() ? std::optional(aim()->seen + aim()->aside) : besideTree(point, m_tree);
    m_centre = place.value_or(m_centre);
    m_tree = place ? m_tree : noNode;
    setAt(point.at);
    m_context.host.repaint();
    return false;
}

void BrushTool::leave()
{
    EditTool::leave();
    if (!edit())
        m_tree = noNode;
}

/// What the sphere touches.
std::vector<Index> BrushTool::affected(const LimbHit& limb)
{
    const Skeleton& skeleton = limb.simplified->skeleton;
    const glm::dvec3 centre = limb.seen + limb.aside;
    const double reach = radius(limb.node);
    std::vector<Index> branches;
    for (Index b = 0; b < skeleton.size(); ++b) {
        const glm::dvec3 way = skeleton.p1[b] - skeleton.p0[b];
        const double squared = glm::dot(way, way);
        const double t =
            squared > 0.0 ? std::clamp(glm::dot(centre - skeleton.p0[b], way) / squared, 0.0, 1.0) : 0.0;
        if (glm::length(centre - skeleton.p0[b] - t * way) <= reach)
            branches.push_back(b);
    }
    return branches;
}

bool BrushTool::take(const ToolPoint& point, const std::optional<LimbHit>& limb)
{
    m_tree = limb ? limb->node : treeMeant(m_context.document);
    const auto place = limb ? std::optional(limb->seen + limb->aside) : besideTree(point, m_tree);
    if (!place) {
        m_context.host.raiseMessage(tr("Press on the tree that is meant, or select it first."));
        return true; // the drag that follows selects nothing
    }
    auto gesture = HandEdit::begin(m_context.document, m_tree);
    if (!gesture)
        return refuse(gesture.error());
    m_centre = m_touched = *place;
    m_done = {};
    start(std::move(*gesture), point);
    if (kind() != BrushKind::Comb) // that has no way yet
        touch({});
    return true;
}

/// \param way of the hand, tree space
void BrushTool::touch(const glm::dvec3& way)
{
    TreeEdit brush;
    brush.operation = isLeaves()                  ? EditOperation::Leaves
                      : kind() == BrushKind::Comb ? EditOperation::Comb
                                                  : EditOperation::Attract;
    brush.centre = m_centre;
    brush.radius = radius(m_tree);
    brush.strength = strength();
    brush.shown = kind() == BrushKind::Leafy;
    if (kind() == BrushKind::Comb)
        brush.direction = way;
    m_touched = m_centre;
    if (isMagnet())
        m_done = edit()->replace({brush});
    else if (edit()->edits().size() < mostTouches)
        m_done = edit()->add(brush);
    if (m_done)
        m_done = edit()->show();
}

void BrushTool::drag(const ToolPoint& point)
{
    setAt(point.at);
    if (!edit())
        return;
    const glm::dmat4 world = worldOf(m_tree);
    const glm::dvec3 held(world * glm::dvec4(m_centre, 1.0));
    m_centre = glm::dvec3(glm::inverse(world) * glm::dvec4(pulledTo(point.view, point.pixel(), held), 1.0));
    const glm::dvec3 way = m_centre - m_touched;
    if (glm::length(way) > (isMagnet() ? 0.0 : spacing * radius(m_tree)))
        touch(way);
    m_context.host.repaint();
}

/// A stroke is one edit, as long as nothing but its place and radius changes.
void BrushTool::joinTouches()
{
    std::vector<TreeEdit> strokes;
    for (const TreeEdit& touch : edit()->edits())
        if (!strokes.empty() && strokes.back().strength == touch.strength)
            strokes.back().points.push_back({touch.centre, touch.radius});
        else
            strokes.push_back(touch);
    if (strokes.size() == edit()->edits().size())
        return;
    edit()->edits() = std::move(strokes);
    report(edit()->show());
}

/// What touched nothing says so.
void BrushTool::release(const ToolPoint& point)
{
    if (edit() && !isMagnet())
        joinTouches();
    if (edit() && edit()->edits().empty() && !m_done)
        report(m_done);
    else if (edit() && edit()->edits().empty())
        m_context.host.raiseMessage(tr("Drag over branches: they turn the way of the stroke."));
    NumberTool::release(point);
}

bool BrushTool::wheel(const ToolPoint& point, double turn)
{
    if (edit() || !isChosen() || !point.held.testFlag(Qt::ShiftModifier) || m_tree == noNode)
        return NumberTool::wheel(point, turn);
    constexpr double notch = 120.0;
    turnWheel(turn / notch);
    m_context.host.repaint();
    return true;
}

void BrushTool::turnWheel(double notches)
{
    HandOptions options = m_context.hand.options();
    options.brushRadius = radius(m_tree) * std::pow(radiusPerNotch, notches);
    m_context.hand.setOptions(options);
}

/// Another radius or strength: of a magnet at once, of a stroke from here on.
void BrushTool::show()
{
    if (isMagnet())
        touch({});
    m_context.host.repaint();
}

QString BrushTool::hint(Qt::KeyboardModifiers) const
{
    return isLeaves() ? tr("Release: done · wheel: radius · Esc: back")
                      : tr("Release: done · wheel: radius · digits: strength in % · Esc: back");
}

void BrushTool::offer(ToolOffers& offers) const
{
    if (!isChosen() || offers.held() == Qt::ControlModifier || offers.held() == Qt::AltModifier)
        return;
    offers.add(ToolOffers::Keys, tr("Shift + wheel: radius"));
    if (offers.held() != Qt::NoModifier)
        return;
    switch (kind()) {
    case BrushKind::Attract:
        return offers.add(ToolOffers::Drag, tr("Press or drag: branches turn towards the hand"));
    case BrushKind::Repel:
        return offers.add(ToolOffers::Drag, tr("Press or drag: branches turn away from the hand"));
    case BrushKind::Comb:
        return offers.add(ToolOffers::Drag, tr("Drag over branches: they turn the way of the stroke"));
    case BrushKind::Bare:
        return offers.add(ToolOffers::Drag, tr("Drag over twigs: their leaves go"));
    case BrushKind::Leafy:
        return offers.add(ToolOffers::Drag, tr("Drag over twigs: their leaves come back"));
    }
}

void BrushTool::paint(QPainter& painter, const PickView& view)
{
    if (!isChosen() || m_tree == noNode || m_context.isPlaying() || !m_context.document.scene().find(m_tree))
        return;
    const glm::dmat4 world = worldOf(m_tree);
    const glm::dvec3 aside = glm::dmat3(glm::inverse(world)) * view.camera.right();
    const glm::dvec3 rim = m_centre + radius(m_tree) / glm::length(aside) * aside;
    const auto middle = view.pixel(glm::dvec3(world * glm::dvec4(m_centre, 1.0)));
    const auto edge = view.pixel(glm::dvec3(world * glm::dvec4(rim, 1.0)));
    if (!middle || !edge)
        return;
    const double reach = glm::length(*edge - *middle);
    const QColor colour = kind() == BrushKind::Bare || kind() == BrushKind::Repel ? handRed : handGreen;
    painter.setBrush(QColor(colour.red(), colour.green(), colour.blue(), 26));
    painter.setPen(QPen(QColor(16, 22, 28, 150), 3.5));
    painter.drawEllipse(QPointF(middle->x, middle->y), reach, reach);
    painter.setPen(QPen(colour, 1.8));
    painter.drawEllipse(QPointF(middle->x, middle->y), reach, reach);
    if (!edit())
        return;
    const QString metres = QLocale().toString(radius(m_tree), 'f', 2);
    paintReadout(
        painter, at(), sizeOf(view),
        isLeaves()
            ? tr("radius %1 m").arg(metres)
            : tr("%1 % · radius %2 m").arg(QLocale().toString(100.0 * std::abs(strength()), 'f', 0), metres));
}

} // namespace

std::unique_ptr<Tool> makeBrushTool(ToolContext& context)
{
    return std::make_unique<BrushTool>(context);
}

} // namespace ramure
