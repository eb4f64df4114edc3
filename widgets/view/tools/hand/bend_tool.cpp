// A limb bows as the hand pulls it: the wood below the hand turns bit by bit, over as much of it as the reach
// says, and what lies beyond follows.
#include "core/math/angle.h"
#include "core/math/frame.h"
#include "core/math/hermite.h"
#include "core/skeleton/sections.h"
#include "widgets/view/tools/hand/edit_tool.h"
#include "widgets/view/tools/motion_tools.h"
#include "widgets/view/tools/pending_pick.h"
#include "widgets/view/tools/readout.h"
#include "widgets/view/tools/tool_table.h"
#include <QCoreApplication>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

constexpr double mostTurn = 170.0 * oneDegree;
constexpr double reachPerNotch = 1.15; ///< of the wheel
constexpr double shortest = 0.25;      ///< of the limb's length: a bow from its foot is never shorter

/// A part of an axis that bows.
struct BowPart
{
    Index axis = noIndex;
    std::uint64_t address = 0;
    double from = 0.0, to = 0.0;  ///< shares of its length
    double low = 0.0, high = 1.0; ///< shares of the whole way, from where it begins to the hand
};

/// How much of the turn is made at a share of the way.
double turnedAt(double share)
{
    return share * share * (3.0 - 2.0 * share);
}

class BendTool : public EditTool
{
    Q_DECLARE_TR_FUNCTIONS(ramure::BendTool)
public:
    using EditTool::EditTool;

    [[nodiscard]] bool goesOn() const override { return isBusy(); }
    void drag(const ToolPoint& point) override;
    void release(const ToolPoint& point) override;
    void cancel() override { finish(false); }
    bool wheel(const ToolPoint& point, double turn) override;
    [[nodiscard]] QString hint(Qt::KeyboardModifiers) const override
    {
        return tr("The limb bows · wheel: over how much of it · release: done · Esc: back");
    }
    void offer(ToolOffers& offers) const override;
    void paint(QPainter& painter, const PickView& view) override;

protected:
    bool take(const ToolPoint& point, const std::optional<LimbHit>& limb) override;
    [[nodiscard]] bool takesShift() const override { return true; }
    void forget() override { m_edit.reset(); }
    std::vector<Index> affected(const LimbHit& limb) override;

private:
    [[nodiscard]] std::vector<BowPart> partsOf(const LimbHit& limb, bool whole);
    [[nodiscard]] std::vector<TreeEdit> bends(const glm::dvec3& turn);
    [[nodiscard]] glm::dvec3 turnTo(const glm::dvec3& hand) const;
    void findTwins();
    void show();
    void finish(bool keep);
    void paintParts(QPainter& painter, const PickView& view, const LimbHit& limb);

    std::unique_ptr<HandEdit> m_edit;           ///< while it goes on
    LimbHit m_limb;                             ///< that the hand has
    std::vector<BowPart> m_parts;               ///< of it; of what is aimed at, while nothing goes on
    std::vector<std::vector<LimbTwin>> m_twins; ///< by part
    glm::dvec3 m_held{0.0}, m_hand{0.0};        ///< world: where it was grabbed, and where it is wanted
    glm::dvec3 m_turn{0.0};                     ///< tree space, axis times angle: of all
    double m_reach = 0.0;                       ///< m, of m_parts
    bool m_whole = false;                       ///< down to the ground
    bool m_moves = false;
    QPointF m_at;
};

/// From the hand down the limb, and where the reach is longer down what it grows on.
std::vector<BowPart> BendTool::partsOf(const LimbHit& limb, bool whole)
{
    const TreeAxes* axes = m_context.limbs.axes(m_context.document, limb.node);
    const auto found =
        axes ? std::ranges::find(axes->axes, limb.address, &Axis::address) : decltype(axes->axes.begin())();
    std::vector<BowPart> parts;
    if (!axes || found == axes->axes.end())
        return parts;
    const double wanted = m_context.hand.options().bendReach;
    double place = std::max(limb.share, shortest) * found->length;
    double rest = whole ? 1e9 : wanted > 0.0 ? wanted : place;
    std::vector<double> below; // m that each part takes
    m_reach = 0.0;
    for (auto axis = Index(found - axes->axes.begin()); axis != noIndex && rest > 0.0;
         axis = axes->axes[axis].parent) {
        const Axis& own = axes->axes[axis];
        const double low = std::max(place - rest, 0.0), takes = place - low;
        if (own.length > 0.0 && takes > 0.0) {
            parts.push_back({axis, own.address, low / own.length, std::min(place / own.length, 1.0)});
            below.push_back(takes);
            m_reach += takes;
        }
        rest -= takes;
        place = own.s;
        if (low > 0.0)
            break;
    }
    double passed = 0.0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        parts[i].high = 1.0 - passed / m_reach;
        passed += below[i];
        parts[i].low = std::max(1.0 - passed / m_reach, 0.0);
    }
    return parts;
}

bool BendTool::take(const ToolPoint& point, const std::optional<LimbHit>& limb)
{
    if (!limb || m_context.isPlaying())
        return false;
    auto edit = HandEdit::begin(m_context.document, limb->node);
    if (!edit)
        return refuse(edit.error());
    m_whole = point.held.testFlag(Qt::ShiftModifier);
    m_parts = partsOf(*limb, m_whole);
    if (m_parts.empty())
        return false;
    m_edit = std::move(*edit);
    m_limb = *limb;
    m_held = m_hand = glm::dvec3(worldOf(limb->node) * glm::dvec4(limb->seen, 1.0));
    m_turn = glm::dvec3(0.0);
    m_moves = false;
    m_at = point.at;
    findTwins();
    return true;
}

void BendTool::findTwins()
{
    Symmetry symmetry = symmetryOf(m_limb.node);
    m_twins.clear();
    for (const BowPart& part : m_parts)
        m_twins.push_back(symmetry.twins(part.axis));
    reportMissing(symmetry);
}

/// Of all of the wood below the hand, so that the grabbed place comes under it: a bow's chord turns by half
/// of what its end does.
glm::dvec3 BendTool::turnTo(const glm::dvec3& hand) const
{
    const BowPart& lowest = m_parts.back();
    const auto foot = m_edit->context().pointOn(lowest.address, lowest.from);
    const auto end = m_edit->context().pointOn(m_limb.address, m_parts.front().to);
    if (!foot || !end)
        return glm::dvec3(0.0);
    const glm::dmat4 inverse = glm::inverse(worldOf(m_limb.node));
    const glm::dvec3 by(inverse * glm::dvec4(hand - m_held, 0.0));
    const glm::dvec3 chord = end->position - foot->position;
    const glm::dvec3 about = glm::cross(chord, chord + by);
    const double across = glm::length(about);
    if (across == 0.0)
        return glm::dvec3(0.0);
    const double angle = 2.0 * std::atan2(across, glm::dot(chord, chord + by));
    return about / across * std::min(angle, mostTurn);
}

/// \param turn of all, tree space
std::vector<TreeEdit> BendTool::bends(const glm::dvec3& turn)
{
    std::vector<TreeEdit> edits;
    std::vector<std::uint64_t> seen;
    const auto add = [&](const BowPart& part, std::uint64_t address, const SymmetryMap& map) {
        if (std::ranges::count(seen, address) > 0)
            return;
        seen.push_back(address);
        TreeEdit edit;
        edit.operation = EditOperation::Bend;
        edit.target.address = address;
        edit.from = part.from;
        edit.to = part.to;
        edit.rotation = map.rotation((turnedAt(part.high) - turnedAt(part.low)) * turn);
        edits.push_back(edit);
    };
    for (const BowPart& part : m_parts)
        add(part, part.address, {});
    for (std::size_t i = 0; i < m_parts.size() && i < m_twins.size(); ++i)
        for (const LimbTwin& twin : m_twins[i])
            add(m_parts[i], twin.address, twin.map);
    return edits;
}

void BendTool::show()
{
    m_turn = turnTo(m_hand);
    (void)m_edit->replace(bends(m_turn)).and_then([this] { return m_edit->show(); }); // said at the end
    m_context.host.repaint();
}

void BendTool::drag(const ToolPoint& point)
{
    m_at = point.at;
    m_moves = m_moves || point.isDrag();
    if (!m_edit || !m_moves)
        return;
    m_hand = pulledTo(point.view, point.pixel(), m_held);
    show();
}

bool BendTool::wheel(const ToolPoint& point, double turn)
{
    if (!m_edit)
        return EditTool::wheel(point, turn);
    if (turn == 0.0)
        return false;
    HandOptions options = m_context.hand.options();
    options.bendReach = m_reach * (turn > 0.0 ? reachPerNotch : 1.0 / reachPerNotch);
    m_context.hand.setOptions(options);
    m_whole = false;
    m_parts = partsOf(m_limb, false);
    findTwins();
    if (m_moves)
        show();
    m_context.host.repaint();
    return true;
}

/// A branch that was clicked, not dragged, is selected.
void BendTool::release(const ToolPoint& point)
{
    if (!m_edit)
        return;
    const bool moves = m_moves;
    if (moves)
        report(m_edit->replace(bends(m_turn)).and_then([this] { return m_edit->show(); }));
    finish(moves);
    if (!moves)
        m_context.picks->click(point.at, point.held.testFlag(Qt::ShiftModifier));
}

/// \param keep else everything is as it was
void BendTool::finish(bool keep)
{
    if (m_edit)
        keep ? m_edit->keep() : m_edit->cancel();
    m_edit.reset();
    setAim({});
    m_context.host.repaint();
}

/// All that follows: what bows, and what lies beyond.
std::vector<Index> BendTool::affected(const LimbHit& limb)
{
    m_parts = partsOf(limb, false);
    if (m_parts.empty())
        return {};
    LimbHit lowest = limb;
    lowest.axis = m_parts.back().axis;
    lowest.address = m_parts.back().address;
    lowest.share = m_parts.back().from;
    return m_context.limbs.above(m_context.document, lowest, false);
}

void BendTool::offer(ToolOffers& offers) const
{
    if (isChosen() && !m_context.isPlaying() && offers.held() == Qt::NoModifier)
        offers.add(ToolOffers::Drag, aim() ? tr("Drag: the limb bows along its green part, the bright part "
                                                "follows · Shift: down to the ground")
                                           : tr("Drag a branch: the limb bows as the hand goes"));
    offerLimbs(offers);
}

/// Where the wood bows, the greener the more; as it is seen now.
void BendTool::paintParts(QPainter& painter, const PickView& view, const LimbHit& limb)
{
    constexpr int steps = 6;
    const TreeResult* shown = m_context.limbs.tree(m_context.document, limb.node);
    const TreeAxes* axes = m_context.limbs.axes(m_context.document, limb.node);
    if (!shown || !axes)
        return;
    const Skeleton& seen = shown->simplified->skeleton;
    const std::vector<LimbSpan> spans = m_context.limbs.spans(m_context.document, limb.node);
    const glm::dmat4 world = worldOf(limb.node);
    for (const BowPart& part : m_parts) {
        const auto axis = std::ranges::find(axes->axes, part.address, &Axis::address);
        for (Index b = 0; axis != axes->axes.end() && b < spans.size(); ++b) {
            const LimbSpan& span = spans[b];
            if (span.address != part.address || span.to <= part.from * axis->length ||
                span.from >= part.to * axis->length)
                continue;
            const BranchCurve curve = branchCurve(seen, b);
            std::optional<glm::dvec2> last;
            for (int k = 0; k <= steps; ++k) {
                const double t = double(k) / steps;
                const double share = glm::mix(span.from, span.to, t) / axis->length;
                const double on = glm::mix(part.low, part.high, (share - part.from) / (part.to - part.from));
                const auto at = view.pixel(glm::dvec3(
                    world * glm::dvec4(hermite(curve.h0, curve.h1, curve.v0, curve.v1, t).point, 1.0)));
                if (at && last && on >= 0.0 && on <= 1.0) {
                    QColor colour = handGreen;
                    colour.setAlphaF(float(0.25 + 3.0 * on * (1.0 - on)));
                    painter.setPen(QPen(colour, 4.0, Qt::SolidLine, Qt::RoundCap));
                    painter.drawLine(QPointF(last->x, last->y), QPointF(at->x, at->y));
                }
                last = at;
            }
        }
    }
}

void BendTool::paint(QPainter& painter, const PickView& view)
{
    const LimbHit* limb = m_edit ? &m_limb : aim() ? &*aim() : nullptr;
    if (!limb || m_parts.empty())
        return;
    paintParts(painter, view, *limb);
    const glm::dmat4 world = worldOf(limb->node);
    const glm::dvec3 hand = m_edit ? m_hand : glm::dvec3(world * glm::dvec4(limb->seen, 1.0));
    const glm::dvec3 side = glm::normalize(view.camera.right()) * glm::length(glm::dvec3(world[1]));
    const auto middle = view.pixel(hand), rim = view.pixel(hand + m_reach * side);
    if (!middle)
        return;
    const QPointF at(middle->x, middle->y);
    painter.setBrush(Qt::NoBrush);
    if (rim) {
        const double radius = glm::distance(*middle, *rim);
        painter.setPen(QPen(QColor(16, 22, 28, 130), 3.0));
        painter.drawEllipse(at, radius, radius);
        painter.setPen(QPen(QColor(255, 255, 255, 210), 1.4));
        painter.drawEllipse(at, radius, radius);
    }
    painter.setPen(QPen(QColor(255, 255, 255, 220), 2.0));
    painter.setBrush(handGreen);
    painter.drawEllipse(at, 5.0, 5.0);
    const QString reach = tr("influence %1 m").arg(QLocale().toString(m_reach, 'f', 2));
    if (m_edit)
        paintReadout(painter, m_at, sizeOf(view),
                     m_moves
                         ? tr("Bend %1°").arg(QLocale().toString(glm::length(m_turn) / oneDegree, 'f', 0)) +
                               QStringLiteral(" · ") + reach
                         : reach);
}

} // namespace

std::unique_ptr<Tool> makeBendTool(ToolContext& context)
{
    return std::make_unique<BendTool>(context, HandTool::Bend);
}

} // namespace ramure
