#include "widgets/view/tools/hand/edit_tool.h"

#include "core/evaluate/evaluator.h"
#include "core/math/frame.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/view/tools/hand/hand_cursor.h"
#include "widgets/view/tools/motion_tools.h"
#include <QCoreApplication>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ramure {
namespace {

struct EditWords
{
    Q_DECLARE_TR_FUNCTIONS(ramure::EditTool)
};

} // namespace

EditTool::EditTool(ToolContext& context, HandTool kind)
    : Tool(context)
    , m_kind(kind)
    , m_cursor(handCursor(kind))
{
    connect(&context.hand, &HandSettings::toolChanged, this, [this] {
        if (!isChosen())
            setAim({});
    });
}

bool EditTool::hover(const ToolPoint& point)
{
    if (isBusy())
        return false; // what the gesture shows is enough
    m_eye = point.view.camera.eye();
    setAim(isChosen() && !m_context.isPlaying() ? limbAt(point, {}) : std::nullopt);
    return false;
}

void EditTool::leave()
{
    setAim({});
}

void EditTool::setAim(const std::optional<LimbHit>& aim)
{
    if (!m_aim && !aim)
        return;
    m_aim = aim;
    std::vector<Index> branches = m_aim ? affected(*m_aim) : std::vector<Index>();
    if (takesAway()) {
        m_loss = {branches, 0.0};
        for (const Index branch : branches)
            m_loss.metres += m_aim->simplified->skeleton.length(branch);
    }
    m_context.host.markBranches(m_aim ? m_aim->node : noNode, std::move(branches), takesAway());
    m_context.host.updateHint();
    m_context.host.repaint();
}

QString EditTool::lossWords(const HandLoss& loss)
{
    return EditWords::tr("%n branch(es), %1 m", nullptr, static_cast<int>(loss.branches.size()))
        .arg(QLocale().toString(loss.metres, 'f', 1));
}

std::optional<LimbHit> EditTool::limbAt(const ToolPoint& point, std::chrono::milliseconds patience)
{
    const auto twig = twigAt(point, patience);
    return twig && takesLimbs(m_kind)
               ? m_context.limbs.onLimb(m_context.document, *twig, m_context.hand.options().limbOrder)
               : twig;
}

std::optional<LimbHit> EditTool::twigAt(const ToolPoint& point, std::chrono::milliseconds patience)
{
    const auto scene = m_context.host.pickScene(patience);
    return scene ? twigNear(*scene, point)
                 : m_context.limbs.under(m_context.document, point.view, point.pixel());
}

/// Under the mouse, or, as thin as twigs are, the nearest one a few pixels beside it that is seen.
std::optional<LimbHit> EditTool::twigNear(const PickScene& scene, const ToolPoint& point)
{
    const Document& document = m_context.document;
    const PickView& view = point.view;
    const auto at = [&](const glm::dvec2& pixel, const std::optional<PickHit>& hit) {
        auto limb = hit ? m_context.limbs.at(document, *hit) : std::nullopt;
        if (limb && pixel != point.pixel())
            limb->side = m_context.limbs.sideTowards(document, *limb, view, point.pixel());
        return limb;
    };
    if (auto limb = at(point.pixel(), scene.pick(view, point.pixel())))
        return limb;
    constexpr double reach = 6.0; // logical pixels
    constexpr glm::dvec2 ways[] = {{1, 0},     {0, 1},      {-1, 0},     {0, -1},
                                   {0.7, 0.7}, {-0.7, 0.7}, {0.7, -0.7}, {-0.7, -0.7}};
    for (const double far : {0.5 * reach, reach})
        for (const glm::dvec2& way : ways)
            if (auto limb = at(point.pixel() + far * way, scene.pick(view, point.pixel() + far * way)))
                return limb;
    // What is thinner than a pixel, rays go past.
    const auto around = scene.inRectangle(view, point.pixel() - reach, point.pixel() + reach);
    std::vector<StandingTree> trees;
    for (const PickedBranches& of : around)
        if (const TreeResult* tree = m_context.limbs.tree(document, of.node))
            trees.push_back({of.node, worldOf(of.node), &tree->simplified->skeleton, nullptr, &of.branches});
    const auto near = branchUnder(view, point.pixel(), trees, reach);
    const auto middle = near ? view.pixel(near->point) : std::nullopt;
    if (!middle)
        return std::nullopt;
    const auto first = scene.pick(view, *middle);
    if (auto limb = at(*middle, first))
        return limb;
    auto limb = m_context.limbs.onBranch(document, near->node, near->branch, near->along);
    const bool isHidden =
        limb && first && glm::dot(first->point - near->point, view.camera.backward()) > 2.0 * limb->radius;
    if (!limb || isHidden)
        return std::nullopt;
    limb->aside = limb->side = m_context.limbs.sideTowards(document, *limb, view, point.pixel());
    return limb;
}

bool EditTool::press(const ToolPoint& point)
{
    Qt::KeyboardModifiers others = Qt::ControlModifier | Qt::AltModifier;
    others.setFlag(Qt::ShiftModifier, !takesShift());
    if (!isChosen() || point.button != Qt::LeftButton || (point.held & others))
        return false;
    m_eye = point.view.camera.eye();
    const auto limb = limbAt(point, shapePatience);
    const bool takes = take(point, limb);
    if (!takes && !limb) // what else a press does there is not what was meant
        missed();
    return takes;
}

void EditTool::missed()
{
    m_context.host.raiseMessage(EditWords::tr("No limb is there: click on one, or a few pixels beside it."));
}

/// With Shift: of the twig under the cursor the limb that it grows on, and that one's; or back.
bool EditTool::wheel(const ToolPoint& point, double turn)
{
    if (isBusy() || !isChosen() || !takesLimbs(m_kind) || !point.held.testFlag(Qt::ShiftModifier))
        return false;
    const auto twig = turn != 0.0 ? twigAt(point, {}) : std::nullopt;
    if (!twig)
        return true;
    HandOptions options = m_context.hand.options();
    const auto orderOf = [&](const LimbHit& limb) {
        return int(m_context.limbs.axes(m_context.document, limb.node)->axes[limb.axis].order);
    };
    const int deepest = orderOf(*twig);
    const int shown = options.limbOrder > 0 ? std::min(options.limbOrder, deepest) : deepest;
    const int next = turn > 0.0 ? std::max(shown - 1, 1) : shown + 1;
    options.limbOrder = next < deepest ? next : 0;
    m_context.hand.setOptions(options);
    setAim(limbAt(point, {}));
    return true;
}

void EditTool::offerLimbs(ToolOffers& offers) const
{
    if (!isChosen() || !m_aim || m_context.isPlaying())
        return;
    if (offers.held() == Qt::NoModifier)
        offers.add(ToolOffers::Drag, EditWords::tr("Shift + wheel: the limb that it grows on"));
    else if (offers.held() == Qt::ShiftModifier)
        offers.add(ToolOffers::More, EditWords::tr("Shift: wheel takes the limb that it grows on, or back"));
}

void EditTool::documentChanged(const Change& change)
{
    if (change.has(changeResults | changeReset | changeStructure))
        setAim({}); // of a tree that is another one now
    if (!change.has(changeReset | changeStructure))
        return;
    forget();
    if (isBusy())
        end();
}

Symmetry EditTool::symmetryOf(NodeId node)
{
    const TreeAxes* axes = m_context.limbs.axes(m_context.document, node);
    if (!axes || axes->axes.empty())
        return {};
    const Skeleton& drawn = *m_context.limbs.tree(m_context.document, node)->skeleton;
    const glm::dvec3 eye(glm::inverse(worldOf(node)) * glm::dvec4(m_eye, 1.0));
    return {*axes, drawn, m_context.hand.options(), drawn.p0[0] - eye};
}

std::vector<LimbHit> EditTool::withTwins(const std::vector<LimbHit>& limbs, Symmetry& symmetry)
{
    std::vector<LimbHit> all;
    const auto add = [&all](const LimbHit& limb) {
        if (std::ranges::count(all, limb.address, &LimbHit::address) == 0)
            all.push_back(limb);
    };
    for (const LimbHit& limb : limbs)
        add(limb);
    for (const LimbHit& limb : limbs)
        for (const LimbTwin& twin : symmetry.twins(limb.axis)) {
            LimbHit there = limb;
            there.axis = twin.axis;
            there.address = twin.address;
            there.branch = noIndex;
            add(there);
        }
    return all;
}

void EditTool::reportMissing(const Symmetry& symmetry)
{
    if (symmetry.missing() > 0)
        m_context.host.raiseMessage(
            EditWords::tr("At %n place(s) around the trunk no limb is like it: nothing "
                          "happens there.",
                          nullptr, symmetry.missing()));
}

std::optional<double> EditTool::fallsAfter() const
{
    const HandOptions& options = m_context.hand.options();
    return options.falls ? std::optional(options.fallsAfter) : std::nullopt;
}

void EditTool::reportFall()
{
    if (fallsAfter())
        m_context.host.raiseMessage(EditWords::tr("Cut: the part falls when the timeline plays."));
}

bool EditTool::refuse(const Error& why)
{
    m_context.host.raiseMessage(errorText(why));
    return true;
}

bool EditTool::report(const Expected<void>& done)
{
    if (!done)
        m_context.host.raiseMessage(errorText(done.error()));
    return done.has_value();
}

glm::dmat4 EditTool::worldOf(NodeId node) const
{
    return EvaluatedScene(m_context.document.scene()).transforms(node).geometry;
}

bool ClickTool::take(const ToolPoint& point, const std::optional<LimbHit>& limb)
{
    m_waiting.reset();
    if (!limb && m_context.host.pickScene({}))
        return false; // beside all: whatever else a press does there
    setAim(limb);
    if (!limb)
        m_waiting = point;
    return true;
}

void ClickTool::drag(const ToolPoint& point)
{
    if (m_waiting)
        m_waiting->at = point.at;
    else
        setAim(limbAt(point, pickPatience));
}

void ClickTool::release(const ToolPoint& point)
{
    const auto limb = aim();
    setAim({});
    if (!m_waiting && limb)
        report(act(*limb, point.held));
}

void ClickTool::sceneReady()
{
    if (!m_waiting || isBusy())
        return;
    const ToolPoint point = *std::exchange(m_waiting, std::nullopt);
    const auto limb = isChosen() ? limbAt(point, pickPatience) : std::nullopt;
    if (limb)
        report(act(*limb, point.held));
    else if (isChosen())
        missed();
}

NodeId treeMeant(const Document& document)
{
    const auto isTree = [](const Node& node) { return node.kind == NodeKind::Tree; };
    const Node* active = document.scene().find(document.selection().activeNode());
    if (active && isTree(*active))
        return active->id;
    const auto& nodes = document.scene().nodes();
    return std::ranges::count_if(nodes, isTree) == 1 ? std::ranges::find_if(nodes, isTree)->id : noNode;
}

void paintRing(QPainter& painter, const PickView& view, const glm::dmat4& world, const LimbHit& limb,
               const QColor& colour)
{
    constexpr int sides = 32;
    constexpr double reach = 1.25, least = 6.0; // of the radius; pixels
    const auto middle = view.pixel(glm::dvec3(world * glm::dvec4(limb.seen, 1.0)));
    if (!middle)
        return;
    const Frame frame = frameFromTangent(limb.along);
    QPolygonF ring;
    double widest = 0.0;
    for (int i = 0; i <= sides; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / sides;
        const glm::dvec3 way = std::cos(angle) * frame.normal + std::sin(angle) * frame.binormal;
        const auto at =
            view.pixel(glm::dvec3(world * glm::dvec4(limb.seen + reach * limb.radius * way, 1.0)));
        if (!at)
            return;
        ring << QPointF(at->x, at->y);
        widest = std::max(widest, glm::length(*at - *middle));
    }
    const QPointF centre(middle->x, middle->y);
    if (widest < least)
        for (QPointF& at : ring)
            at = centre + (at - centre) * least / std::max(widest, 1e-3);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(16, 22, 28, 170), 4.5));
    painter.drawPolyline(ring);
    painter.setPen(QPen(colour, 2.4));
    painter.drawPolyline(ring);
}

} // namespace ramure
