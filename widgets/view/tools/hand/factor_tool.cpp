// Longer and shorter, thicker and thinner, curled and twisted: by a drag on a branch, the wheel, or a number.
#include "core/math/angle.h"
#include "core/math/frame.h"
#include "widgets/view/tools/hand/limb_handles.h"
#include "widgets/view/tools/hand/number_tool.h"
#include "widgets/view/tools/readout.h"
#include "widgets/view/tools/tool_table.h"
#include <QCoreApplication>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

constexpr double leastFactor = 0.05, mostFactor = 20.0;
constexpr double coarse = 0.1; ///< steps with Ctrl
constexpr double mostAngle = 720.0 * oneDegree;
constexpr double angleStep = 5.0 * oneDegree; ///< of the wheel, and with Ctrl

/// What the hand does to the number.
enum class Way : quint8 {
    Along,    ///< a factor follows it along the limb
    Sideways, ///< a factor doubles to the right
    Around,   ///< an angle grows to the right
    Rolled,   ///< an angle in the plane of the picture, to that side of the limb
};

struct FactorKind
{
    HandTool tool;
    EditOperation operation;
    Way way;
    const char* readout;
    const char* offer;
};
constexpr FactorKind factorKinds[] = {
    {HandTool::Length, EditOperation::Length, Way::Along,
     QT_TRANSLATE_NOOP("ramure::FactorTool", "Length × %1"),
     QT_TRANSLATE_NOOP("ramure::FactorTool", "Drag a branch along itself: its length")},
    {HandTool::Thickness, EditOperation::Thickness, Way::Sideways,
     QT_TRANSLATE_NOOP("ramure::FactorTool", "Thickness × %1"),
     QT_TRANSLATE_NOOP("ramure::FactorTool", "Drag a branch to the right or left: its thickness")},
    {HandTool::Taper, EditOperation::Taper, Way::Sideways,
     QT_TRANSLATE_NOOP("ramure::FactorTool", "Thickness of the tip × %1"),
     QT_TRANSLATE_NOOP("ramure::FactorTool", "Drag a branch to the right or left: how thick its tip is")},
    {HandTool::Curl, EditOperation::Curl, Way::Rolled, QT_TRANSLATE_NOOP("ramure::FactorTool", "Curl %1°"),
     QT_TRANSLATE_NOOP("ramure::FactorTool", "Drag a branch to one side: it rolls up that way")},
    {HandTool::Twist, EditOperation::Twist, Way::Around, QT_TRANSLATE_NOOP("ramure::FactorTool", "Twist %1°"),
     QT_TRANSLATE_NOOP("ramure::FactorTool", "Drag a branch to the right or left: its twigs turn")},
};

class FactorTool : public NumberTool
{
    Q_DECLARE_TR_FUNCTIONS(ramure::FactorTool)
public:
    FactorTool(ToolContext& context, const FactorKind& kind)
        : NumberTool(context, kind.tool)
        , m_kind(kind)
    {
    }

    bool hover(const ToolPoint& point) override;
    void leave() override;
    void documentChanged(const Change& change) override;
    void drag(const ToolPoint& point) override;
    [[nodiscard]] QString hint(Qt::KeyboardModifiers) const override;
    void offer(ToolOffers& offers) const override;
    void paint(QPainter& painter, const PickView& view) override;

protected:
    bool take(const ToolPoint& point, const std::optional<LimbHit>& limb) override;
    [[nodiscard]] bool isChanged() const override { return m_dragged != neutral() || m_wheeled != neutral(); }
    void turnWheel(double notches) override;
    [[nodiscard]] bool takesMinus() const override { return isAngle(); }
    void show() override;
    std::vector<Index> affected(const LimbHit& limb) override;

private:
    [[nodiscard]] bool isAngle() const { return m_kind.way == Way::Around || m_kind.way == Way::Rolled; }
    [[nodiscard]] double neutral() const { return isAngle() ? 0.0 : 1.0; }
    [[nodiscard]] bool takesBelow() const;
    [[nodiscard]] double byHand(const ToolPoint& point) const;
    [[nodiscard]] double alongLimb(const ToolPoint& point) const;
    [[nodiscard]] double acrossLimb(const ToolPoint& point) const;
    Expected<void> addAll(HandEdit& gesture);
    Expected<void> addLimb(HandEdit& gesture, std::uint64_t address, const SymmetryMap& map);
    void rememberBefore(HandEdit& gesture);
    [[nodiscard]] double value() const;

    const FactorKind& m_kind;
    LimbHandles m_handles;
    std::optional<double> m_handle; ///< share of the limb where the handle stands that the hand has
    LimbHit m_limb;
    glm::dvec3 m_sight{0.0};         ///< unit, tree space, towards the eye
    std::vector<TreeEdit> m_before;  ///< the edits before the hand changes them
    std::vector<SymmetryMap> m_maps; ///< of each: from the limb that was meant
    std::vector<glm::dvec3> m_rolls; ///< of each: about what it rolls, in its parent's frame
    double m_dragged = 1.0, m_wheeled = 1.0;
};

bool FactorTool::hover(const ToolPoint& point)
{
    EditTool::hover(point);
    if (isBusy() || !isChosen() || m_context.isPlaying())
        return false;
    if (const auto handle = m_handles.at(m_context, point.view, point.pixel())) {
        setAim(*handle);
        return true;
    }
    const auto selected = m_context.limbs.selected(m_context.document);
    m_handles.show(m_context, aim()                  ? aim()
                              : selected.size() == 1 ? std::optional(selected.front())
                                                     : std::nullopt);
    return false;
}

void FactorTool::leave()
{
    m_handles.hide();
    NumberTool::leave();
}

void FactorTool::documentChanged(const Change& change)
{
    if (change.has(changeResults | changeReset | changeStructure))
        m_handles.hide();
    NumberTool::documentChanged(change);
}

bool FactorTool::take(const ToolPoint& point, const std::optional<LimbHit>& hit)
{
    const auto handle = m_handles.at(m_context, point.view, point.pixel());
    const std::optional<LimbHit> limb = handle ? handle : hit;
    m_handle.reset();
    if (!limb)
        return false;
    if (handle && m_kind.way == Way::Rolled) // a limb rolls up from the handle on
        m_handle = std::min(handle->share, 0.75);
    auto gesture = HandEdit::begin(m_context.document, limb->node);
    if (!gesture)
        return refuse(gesture.error());
    m_limb = *limb;
    const glm::dvec3 eye(glm::inverse(worldOf(limb->node)) * glm::dvec4(point.view.camera.eye(), 1.0));
    m_sight = glm::normalize(eye - limb->seen);
    m_dragged = m_wheeled = neutral();
    if (report(addAll(**gesture)))
        start(std::move(*gesture), point);
    return true; // pressed on a branch, also where nothing comes of it
}

/// An edit for each limb that is meant, or the one of a moment ago again. Of several those that nothing can
/// be done to are left out.
Expected<void> FactorTool::addAll(HandEdit& gesture)
{
    const std::vector<LimbHit> limbs = meantBy(m_limb);
    Symmetry symmetry = symmetryOf(m_limb.node);
    Expected<void> done;
    m_maps.clear();
    if (limbs.size() == 1 && !symmetry.isOn() && gesture.resume(m_kind.operation, m_limb.address)) {
        m_maps.emplace_back();
    } else {
        std::vector<std::uint64_t> seen;
        const auto add = [&](std::uint64_t address, const SymmetryMap& map) {
            if (std::ranges::count(seen, address) > 0)
                return;
            seen.push_back(address);
            if (auto added = addLimb(gesture, address, map); !added)
                done = added;
        };
        for (const LimbHit& limb : limbs)
            add(limb.address, {});
        for (const LimbHit& limb : limbs)
            for (const LimbTwin& twin : symmetry.twins(limb.axis))
                add(twin.address, twin.map);
        reportMissing(symmetry);
    }
    rememberBefore(gesture);
    return m_before.empty() ? done : Expected<void>();
}

Expected<void> FactorTool::addLimb(HandEdit& gesture, std::uint64_t address, const SymmetryMap& map)
{
    TreeEdit edit;
    edit.operation = m_kind.operation;
    edit.target.address = address;
    edit.from = std::max(m_context.hand.options().curlFrom, m_handle.value_or(0.0));
    edit.below = m_context.hand.options().withBelow;
    auto added = gesture.add(edit);
    if (added)
        m_maps.push_back(map);
    return added;
}

void FactorTool::rememberBefore(HandEdit& gesture)
{
    m_before = gesture.edits();
    m_rolls.clear();
    for (std::size_t i = 0; i < m_before.size(); ++i) {
        const auto frame = gesture.context().frameBelow(m_before[i].target.address);
        const glm::dvec3 about = m_maps[i].rotation(m_sight);
        m_rolls.push_back(frame ? glm::dvec3(glm::dot(about, frame->normal), glm::dot(about, frame->binormal),
                                             glm::dot(about, frame->tangent))
                                : glm::dvec3(0.0));
    }
}

bool FactorTool::takesBelow() const
{
    return isAngle() || (m_kind.tool != HandTool::Taper && m_context.hand.options().withBelow);
}

std::vector<Index> FactorTool::affected(const LimbHit& limb)
{
    std::vector<Index> all;
    Symmetry symmetry = symmetryOf(limb.node);
    for (const LimbHit& each : withTwins(meantBy(limb), symmetry)) {
        const auto own = takesBelow() ? m_context.limbs.above(m_context.document, each, true)
                                      : m_context.limbs.limb(m_context.document, each.node, each.address);
        all.insert(all.end(), own.begin(), own.end());
    }
    return all;
}

double FactorTool::byHand(const ToolPoint& point) const
{
    switch (m_kind.way) {
    case Way::Along:
        return alongLimb(point);
    case Way::Sideways:
        return std::exp2((point.at.x() - point.pressed.x()) / pixelsPerDouble);
    case Way::Around:
        return anglePerPixel * (point.at.x() - point.pressed.x());
    case Way::Rolled:
        return anglePerPixel * acrossLimb(point);
    }
    return neutral();
}

/// A length follows the hand along the limb; where that points at the eye, it doubles to the right.
double FactorTool::alongLimb(const ToolPoint& point) const
{
    const QPointF way = point.at - point.pressed;
    constexpr double leastShare = 0.25, step = 1e-3, leastPixels = 4.0;
    const glm::dmat4 world = worldOf(m_limb.node);
    const auto here = point.view.pixel(glm::dvec3(world * glm::dvec4(m_limb.seen, 1.0)));
    const auto on = point.view.pixel(glm::dvec3(world * glm::dvec4(m_limb.seen + step * m_limb.along, 1.0)));
    const double length = std::max(edit()->context().lengthOf(m_limb.address), 1e-6);
    const double fromFoot = std::max(m_limb.share, leastShare) * length;
    if (!here || !on || glm::length(*on - *here) / step * length < leastPixels)
        return std::exp2(way.x() / pixelsPerDouble);
    const glm::dvec2 perMetre = (*on - *here) / step;
    const double metres = glm::dot(glm::dvec2(way.x(), way.y()), perMetre) / glm::dot(perMetre, perMetre);
    return (fromFoot + metres) / fromFoot;
}

/// Pixels to the left of the limb, as one looks along it in the picture.
double FactorTool::acrossLimb(const ToolPoint& point) const
{
    constexpr double step = 1e-3;
    const QPointF way = point.at - point.pressed;
    const glm::dmat4 world = worldOf(m_limb.node);
    const auto here = point.view.pixel(glm::dvec3(world * glm::dvec4(m_limb.seen, 1.0)));
    const auto on = point.view.pixel(glm::dvec3(world * glm::dvec4(m_limb.seen + step * m_limb.along, 1.0)));
    const glm::dvec2 along = here && on ? *on - *here : glm::dvec2(0.0);
    const double size = glm::length(along);
    return size > 0.0 ? (way.x() * along.y - way.y() * along.x) / size : -way.x();
}

double FactorTool::value() const
{
    if (!isAngle())
        return std::clamp(typed().value().value_or(m_dragged * m_wheeled), leastFactor, mostFactor);
    const auto number = typed().value();
    return std::clamp(number ? *number * oneDegree : m_dragged + m_wheeled, -mostAngle, mostAngle);
}

void FactorTool::show()
{
    for (std::size_t i = 0; i < m_before.size(); ++i) {
        TreeEdit& changed = edit()->edits()[i];
        if (m_kind.way == Way::Rolled)
            changed.rotation = m_before[i].rotation + value() * m_rolls[i];
        else if (m_kind.way == Way::Around)
            changed.angleRad = m_before[i].angleRad + m_maps[i].angle(value());
        else
            changed.factor = std::clamp(m_before[i].factor * value(), 0.01, 100.0);
    }
    report(edit()->show());
    m_context.host.repaint();
}

void FactorTool::drag(const ToolPoint& point)
{
    setAt(point.at);
    if (!edit() || isByKeys() || (!point.isDrag() && m_dragged == neutral()))
        return m_context.host.repaint();
    const bool stepwise = point.held.testFlag(Qt::ControlModifier);
    const double step = isAngle() ? angleStep : coarse;
    m_dragged = byHand(point);
    if (stepwise)
        m_dragged = std::round(m_dragged / step) * step;
    if (!isAngle())
        m_dragged = std::max(m_dragged, stepwise ? step : leastFactor);
    show();
}

void FactorTool::turnWheel(double notches)
{
    m_wheeled = isAngle() ? m_wheeled + angleStep * notches : m_wheeled * std::pow(factorPerNotch, notches);
}

QString FactorTool::hint(Qt::KeyboardModifiers) const
{
    if (isByKeys())
        return isAngle() ? tr("Digits: degrees · wheel: more or less · Enter or click: done · Esc: back")
                         : tr("Digits: factor · wheel: more or less · Enter or click: done · Esc: back");
    return isAngle() ? tr("Release: done · wheel: more or less · digits: degrees · Ctrl: steps · Esc: back")
                     : tr("Release: done · wheel: more or less · digits: factor · Ctrl: steps · Esc: back");
}

void FactorTool::offer(ToolOffers& offers) const
{
    if (isChosen() && offers.held() == Qt::NoModifier) {
        offers.add(ToolOffers::Drag, tr(m_kind.offer));
        offers.add(ToolOffers::Click, isAngle() ? tr("Click: type an angle") : tr("Click: type a factor"));
    }
    offerLimbs(offers);
}

void FactorTool::paint(QPainter& painter, const PickView& view)
{
    const LimbHit* limb = edit() ? &m_limb : aim() ? &*aim() : nullptr;
    if (limb)
        paintRing(painter, view, worldOf(limb->node), *limb, handGreen);
    if (!edit()) {
        m_handles.paint(painter, m_context, view);
        return;
    }
    const double shown = isAngle() ? value() / oneDegree : value();
    const QString number =
        typed().isEmpty() ? QLocale().toString(shown, 'f', isAngle() ? 0 : 2) : typed().text();
    QString text = tr(m_kind.readout).arg(number);
    if (isByKeys() && typed().isEmpty() && m_wheeled == neutral())
        text += tr(" · type a number");
    paintReadout(painter, at(), sizeOf(view), text);
}

} // namespace

template <HandTool tool> std::unique_ptr<Tool> makeFactorTool(ToolContext& context)
{
    return std::make_unique<FactorTool>(context, *std::ranges::find(factorKinds, tool, &FactorKind::tool));
}
template std::unique_ptr<Tool> makeFactorTool<HandTool::Length>(ToolContext&);
template std::unique_ptr<Tool> makeFactorTool<HandTool::Thickness>(ToolContext&);
template std::unique_ptr<Tool> makeFactorTool<HandTool::Taper>(ToolContext&);
template std::unique_ptr<Tool> makeFactorTool<HandTool::Curl>(ToolContext&);
template std::unique_ptr<Tool> makeFactorTool<HandTool::Twist>(ToolContext&);

} // namespace ramure
