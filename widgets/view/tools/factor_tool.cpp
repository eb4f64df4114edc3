// Longer and shorter, thicker and thinner: by a drag on a branch, the wheel, or a number.
#include "widgets/view/tools/edit_tool.h"
#include "widgets/view/tools/readout.h"
#include "widgets/view/tools/tool_table.h"
#include "widgets/view/tools/typed_number.h"
#include <QCoreApplication>
#include <QKeyEvent>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

constexpr double leastFactor = 0.05, mostFactor = 20.0;
constexpr double pixelsPerDouble = 140.0;
constexpr double notch = 120.0, perNotch = 1.05; ///< of the wheel
constexpr double coarse = 0.1;                   ///< steps with Ctrl

class FactorTool : public EditTool
{
    Q_DECLARE_TR_FUNCTIONS(ramure::FactorTool)
public:
    FactorTool(ToolContext& context, HandTool kind, EditOperation operation)
        : EditTool(context, kind)
        , m_operation(operation)
    {
    }

    [[nodiscard]] bool goesOn() const override { return isBusy(); }
    void drag(const ToolPoint& point) override;
    void release(const ToolPoint& point) override;
    void pressAgain(const ToolPoint& point) override;
    void cancel() override { finish(false); }
    bool wheel(const ToolPoint& point, double turn) override;
    [[nodiscard]] bool takesKeys() const override { return true; }
    void key(const QKeyEvent& event, bool pressed) override;
    void focusLost() override;
    [[nodiscard]] QString hint(Qt::KeyboardModifiers) const override;
    void offer(ToolOffers& offers) const override;
    void paint(QPainter& painter, const PickView& view) override;

protected:
    bool take(const ToolPoint& point, const std::optional<LimbHit>& limb) override;
    void forget() override { m_edit.reset(); }
    std::vector<Index> affected(const LimbHit& limb) override;

private:
    [[nodiscard]] bool isLength() const { return m_operation == EditOperation::Length; }
    [[nodiscard]] double byHand(const ToolPoint& point) const;
    Expected<void> addAll();
    void show();
    void finish(bool keep);
    [[nodiscard]] double factor() const;

    EditOperation m_operation;
    std::unique_ptr<HandEdit> m_edit;
    LimbHit m_limb;
    std::vector<double> m_before; ///< factors of the edits that are gone on with
    double m_dragged = 1.0, m_wheeled = 1.0;
    TypedNumber m_typed;
    bool m_byKeys = false; ///< clicked: goes on without the button
    QPointF m_at;
};

bool FactorTool::take(const ToolPoint& point, const std::optional<LimbHit>& limb)
{
    if (!limb)
        return false;
    auto edit = HandEdit::begin(m_context.document, limb->node);
    if (!edit)
        return report(tl::unexpected(edit.error()));
    setAim({});
    m_edit = std::move(*edit);
    m_limb = *limb;
    if (!report(addAll())) {
        m_edit.reset();
        return true; // pressed on a branch, and nothing comes of it
    }
    m_dragged = m_wheeled = 1.0;
    m_typed.clear();
    m_byKeys = false;
    m_at = point.at;
    return true;
}

/// An edit for each limb that is meant, or the one of a moment ago again.
Expected<void> FactorTool::addAll()
{
    const std::vector<LimbHit> limbs = meantBy(m_limb);
    if (limbs.size() != 1 || !m_edit->resume(m_operation, m_limb.address)) {
        std::vector<std::uint64_t> done;
        for (const LimbHit& limb : limbs) {
            if (std::ranges::count(done, limb.address) > 0)
                continue;
            done.push_back(limb.address);
            TreeEdit edit;
            edit.operation = m_operation;
            edit.target.address = limb.address;
            edit.factor = 1.0;
            edit.below = m_context.hand.options().withBelow;
            if (auto added = m_edit->add(edit); !added)
                return added;
        }
    }
    m_before.clear();
    for (TreeEdit& edit : m_edit->edits())
        m_before.push_back(edit.factor);
    return {};
}

std::vector<Index> FactorTool::affected(const LimbHit& limb)
{
    std::vector<Index> all;
    for (const LimbHit& each : meantBy(limb)) {
        const bool below = m_context.hand.options().withBelow;
        const auto own = below ? m_context.limbs.above(m_context.document, each, true)
                               : m_context.limbs.limb(m_context.document, each.node, each.address);
        all.insert(all.end(), own.begin(), own.end());
    }
    return all;
}

/// A length follows the hand along the limb; a thickness doubles in so many pixels to the right.
double FactorTool::byHand(const ToolPoint& point) const
{
    const QPointF way = point.at - point.pressed;
    const double doubled = std::exp2(way.x() / pixelsPerDouble);
    if (!isLength())
        return doubled;
    constexpr double leastShare = 0.25, step = 1e-3, leastPixels = 4.0;
    const glm::dmat4 world = worldOf(m_limb.node);
    const auto here = point.view.pixel(glm::dvec3(world * glm::dvec4(m_limb.seen, 1.0)));
    const auto on = point.view.pixel(glm::dvec3(world * glm::dvec4(m_limb.seen + step * m_limb.along, 1.0)));
    const double length = std::max(m_edit->context().lengthOf(m_limb.address), 1e-6);
    const double fromFoot = std::max(m_limb.share, leastShare) * length;
    if (!here || !on || glm::length(*on - *here) / step * length < leastPixels)
        return doubled; // it points at the eye
    const glm::dvec2 perMetre = (*on - *here) / step;
    const double metres = glm::dot(glm::dvec2(way.x(), way.y()), perMetre) / glm::dot(perMetre, perMetre);
    return (fromFoot + metres) / fromFoot;
}

double FactorTool::factor() const
{
    const double wanted = m_typed.value().value_or(m_dragged * m_wheeled);
    return std::clamp(wanted, leastFactor, mostFactor);
}

void FactorTool::show()
{
    if (!m_edit)
        return;
    for (std::size_t i = 0; i < m_before.size(); ++i)
        m_edit->edits()[i].factor = std::clamp(m_before[i] * factor(), 0.01, 100.0);
    report(m_edit->show());
    m_context.host.repaint();
}

void FactorTool::drag(const ToolPoint& point)
{
    m_at = point.at;
    if (!m_edit || m_byKeys || (!point.isDrag() && m_dragged == 1.0))
        return m_context.host.repaint();
    m_dragged = std::max(byHand(point), leastFactor);
    if (point.held.testFlag(Qt::ControlModifier))
        m_dragged = std::max(std::round(m_dragged / coarse) * coarse, coarse);
    show();
}

/// A click goes on by wheel and keys.
void FactorTool::release(const ToolPoint& point)
{
    if (!m_edit)
        return;
    if (m_dragged != 1.0 || m_wheeled != 1.0 || !m_typed.isEmpty())
        return finish(true);
    m_at = point.at;
    m_byKeys = true;
    begin(Qt::NoButton);
}

void FactorTool::pressAgain(const ToolPoint& point)
{
    if (m_byKeys || point.button == Qt::RightButton)
        finish(point.button == Qt::LeftButton);
}

bool FactorTool::wheel(const ToolPoint&, double turn)
{
    if (!isBusy() || !m_edit)
        return false;
    m_typed.clear();
    m_wheeled *= std::pow(perNotch, turn / notch);
    show();
    return true;
}

void FactorTool::key(const QKeyEvent& event, bool pressed)
{
    if (!pressed || !m_edit)
        return;
    if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter)
        return finish(true);
    const bool typed = event.key() == Qt::Key_Backspace
                           ? m_typed.erase()
                           : !event.text().isEmpty() && event.text() != QLatin1String("-") &&
                                 m_typed.type(event.text().front());
    if (typed)
        show();
}

void FactorTool::focusLost()
{
    if (m_byKeys)
        finish(true);
}

void FactorTool::finish(bool keep)
{
    if (isBusy())
        end();
    if (const auto edit = std::exchange(m_edit, nullptr))
        keep ? edit->keep() : edit->cancel();
    setAim({});
}

QString FactorTool::hint(Qt::KeyboardModifiers) const
{
    return m_byKeys ? tr("Digits: factor · wheel: more or less · Enter or click: done · Esc: back")
                    : tr("Release: done · wheel: more or less · digits: factor · Ctrl: steps · Esc: back");
}

void FactorTool::offer(ToolOffers& offers) const
{
    if (!isChosen() || offers.held() != Qt::NoModifier)
        return;
    offers.add(ToolOffers::Drag, isLength() ? tr("Drag a branch along itself: its length")
                                            : tr("Drag a branch to the right or left: its thickness"));
    offers.add(ToolOffers::Click, tr("Click: type a factor"));
}

void FactorTool::paint(QPainter& painter, const PickView& view)
{
    const LimbHit* limb = m_edit ? &m_limb : aim() ? &*aim() : nullptr;
    if (limb)
        paintRing(painter, view, worldOf(limb->node), *limb, handGreen);
    if (!m_edit)
        return;
    const QString number = m_typed.isEmpty() ? QLocale().toString(factor(), 'f', 2) : m_typed.text();
    QString text = (isLength() ? tr("Length × %1") : tr("Thickness × %1")).arg(number);
    if (m_byKeys && m_typed.isEmpty() && m_wheeled == 1.0)
        text += tr(" · type a number");
    paintReadout(painter, m_at, sizeOf(view), text);
}

} // namespace

std::unique_ptr<Tool> makeLengthTool(ToolContext& context)
{
    return std::make_unique<FactorTool>(context, HandTool::Length, EditOperation::Length);
}
std::unique_ptr<Tool> makeThicknessTool(ToolContext& context)
{
    return std::make_unique<FactorTool>(context, HandTool::Thickness, EditOperation::Thickness);
}

} // namespace ramure
