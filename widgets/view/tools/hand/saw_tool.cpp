// A stroke through twigs: what it crosses is cut there. Or one around them: what comes into it is cut where
// it does.
#include "widgets/view/tools/hand/edit_tool.h"
#include "widgets/view/tools/readout.h"
#include "widgets/view/tools/tool_table.h"
#include <QCoreApplication>
#include <QPainter>
#include <algorithm>
#include <utility>

namespace ramure {
namespace {

using Pixel = std::optional<glm::dvec2>;

double cross(const glm::dvec2& a, const glm::dvec2& b)
{
    return a.x * b.y - a.y * b.x;
}

/// Share of the way from \p c to \p d where it crosses that from \p a to \p b.
std::optional<double> crossing(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c,
                               const glm::dvec2& d)
{
    const glm::dvec2 stroke = b - a, twig = d - c;
    const double area = cross(stroke, twig);
    if (area == 0.0)
        return std::nullopt;
    const double onStroke = cross(c - a, twig) / area, onTwig = cross(c - a, stroke) / area;
    const bool meet = onStroke >= 0.0 && onStroke <= 1.0 && onTwig >= 0.0 && onTwig <= 1.0;
    return meet ? std::optional(onTwig) : std::nullopt;
}

bool isInside(const QPolygonF& area, const glm::dvec2& at)
{
    return area.containsPoint({at.x, at.y}, Qt::OddEvenFill);
}

/// Share of the way from \p c to \p d where it first comes into the area.
std::optional<double> entry(const QPolygonF& area, const glm::dvec2& c, const glm::dvec2& d)
{
    if (isInside(area, c))
        return 0.0;
    std::optional<double> first;
    for (qsizetype i = 0; i < area.size(); ++i) {
        const QPointF a = area[i], b = area[(i + 1) % area.size()];
        const auto share = crossing({a.x(), a.y()}, {b.x(), b.y()}, c, d);
        if (share && (!first || *share < *first))
            first = share;
    }
    return first;
}

class SawTool : public EditTool
{
    Q_DECLARE_TR_FUNCTIONS(ramure::SawTool)
public:
    using EditTool::EditTool;

    /// Also the other end of the pen that draws.
    bool press(const ToolPoint& point) override
    {
        const bool erases = point.isEraser && m_context.hand.tool() == HandTool::Draw &&
                            point.button == Qt::LeftButton && !m_context.isPlaying();
        m_way = erases ? SawWay::Line : m_context.hand.options().sawWay;
        return erases ? take(point, limbAt(point, shapePatience)) : EditTool::press(point);
    }
    [[nodiscard]] bool goesOn() const override { return isBusy(); }
    void drag(const ToolPoint& point) override;
    void release(const ToolPoint& point) override;
    void cancel() override;
    [[nodiscard]] QString hint(Qt::KeyboardModifiers) const override
    {
        return m_way == SawWay::Line
                   ? tr("The line cuts all branches it crosses · release: done · Esc: nothing is cut")
                   : tr("Branches inside are cut · release: done · Esc: nothing is cut");
    }
    void offer(ToolOffers& offers) const override
    {
        if (!isChosen() || offers.held() != Qt::NoModifier)
            return;
        const bool isLine = m_context.hand.options().sawWay == SawWay::Line;
        offers.add(ToolOffers::Drag, isLine ? tr("Drag a line through twigs: they are cut there")
                                            : tr("Drag around twigs: the twigs inside are cut"));
    }
    void paint(QPainter& painter, const PickView& view) override;

protected:
    bool take(const ToolPoint& point, const std::optional<LimbHit>& limb) override;
    void forget() override
    {
        m_edit.reset();
        m_line.clear();
    }

private:
    /// Where a tree's branches are seen, as long as the gesture goes on.
    struct Seen
    {
        NodeId node = noNode;
        std::shared_ptr<const SimplifiedSkeleton> tree;
        std::vector<LimbSpan> spans;
        std::vector<Pixel> start, end;
    };
    void look(NodeId node, const PickView& view);
    void cutAlong(const glm::dvec2& from, const glm::dvec2& to);
    /// \return whether anything of this tree was cut
    bool cutTree(const Seen& tree, const glm::dvec2& from, const glm::dvec2& to);
    bool cut(std::uint64_t address, double metres);
    /// What of a tree comes into the area.
    struct Within
    {
        std::vector<std::pair<Index, double>> cuts; ///< branches, and where: share of each
        std::vector<Index> goes;                    ///< branches
    };
    [[nodiscard]] Within within(const Seen& tree) const;
    void markArea();
    Expected<void> cutArea();

    std::vector<Seen> m_trees;
    std::unique_ptr<HandEdit> m_edit; ///< of the first tree that was met
    QPolygonF m_line;                 ///< of a rectangle its corners
    SawWay m_way = SawWay::Line;
};

bool SawTool::take(const ToolPoint& point, const std::optional<LimbHit>& limb)
{
    m_trees.clear();
    m_edit.reset();
    m_line = QPolygonF({point.at});
    const NodeId meant = limb ? limb->node : noNode;
    for (const Node& node : m_context.document.scene().nodes())
        if (node.kind == NodeKind::Tree && (meant == noNode || node.id == meant))
            look(node.id, point.view);
    setAim({});
    return true;
}

void SawTool::look(NodeId node, const PickView& view)
{
    const Scene& scene = m_context.document.scene();
    std::vector<LimbSpan> spans = m_context.limbs.spans(m_context.document, node);
    if (spans.empty() || !scene.isShown(node) || scene.isLocked(node))
        return;
    const auto simplified = m_context.limbs.tree(m_context.document, node)->simplified;
    const Skeleton& skeleton = simplified->skeleton;
    const glm::dmat4 world = worldOf(node);
    Seen seen{node, simplified, std::move(spans), std::vector<Pixel>(skeleton.size()),
              std::vector<Pixel>(skeleton.size())};
    for (Index b = 0; b < skeleton.size(); ++b) {
        seen.start[b] = view.pixel(glm::dvec3(world * glm::dvec4(skeleton.p0[b], 1.0)));
        seen.end[b] = view.pixel(glm::dvec3(world * glm::dvec4(skeleton.p1[b], 1.0)));
    }
    m_trees.push_back(std::move(seen));
}

void SawTool::drag(const ToolPoint& point)
{
    const QPointF before = m_line.back();
    if (m_way == SawWay::Rectangle)
        m_line = QRectF(point.pressed, point.at).normalized();
    else
        m_line << point.at;
    if (m_way == SawWay::Line)
        cutAlong({before.x(), before.y()}, {point.at.x(), point.at.y()});
    else
        markArea();
    m_context.host.repaint();
}

SawTool::Within SawTool::within(const Seen& tree) const
{
    const Skeleton& skeleton = tree.tree->skeleton;
    Within found;
    std::vector<bool> goes(skeleton.size(), false);
    for (Index b = 0; b < tree.start.size(); ++b) {
        const Index parent = skeleton.parent[b];
        goes[b] = parent != noIndex && goes[parent];
        const auto share = !goes[b] && tree.start[b] && tree.end[b]
                               ? entry(m_line, *tree.start[b], *tree.end[b])
                               : std::nullopt;
        if (share &&
            glm::mix(skeleton.a0[b], skeleton.a1[b], *share) <= m_context.hand.options().sawThickest) {
            goes[b] = true;
            found.cuts.emplace_back(b, *share);
        }
        if (goes[b])
            found.goes.push_back(b);
    }
    return found;
}

/// Of the first tree that has anything there.
void SawTool::markArea()
{
    for (const Seen& tree : m_trees)
        if (Within found = within(tree); !found.goes.empty())
            return m_context.host.markBranches(tree.node, std::move(found.goes), true);
    m_context.host.unmarkBranches();
}

Expected<void> SawTool::cutArea()
{
    for (const Seen& tree : m_trees) {
        const Within found = within(tree);
        if (found.cuts.empty())
            continue;
        auto edit = HandEdit::begin(m_context.document, tree.node);
        if (!edit)
            return tl::unexpected(edit.error());
        m_edit = std::move(*edit);
        for (const auto& [branch, share] : found.cuts) {
            const LimbSpan& span = tree.spans[branch];
            cut(span.address, glm::mix(span.from, span.to, share));
        }
        if (m_edit->edits().empty())
            return fail(ErrorCode::Invalid, RAMURE_NOOP("nothing of the tree would be left"));
        return m_edit->show();
    }
    return fail(ErrorCode::Invalid, RAMURE_NOOP("nothing in there is thin enough to be cut"));
}

void SawTool::cutAlong(const glm::dvec2& from, const glm::dvec2& to)
{
    for (const Seen& tree : m_trees)
        if (cutTree(tree, from, to)) {
            std::erase_if(m_trees, [node = m_edit->node()](const Seen& each) { return each.node != node; });
            return;
        }
}

bool SawTool::cutTree(const Seen& tree, const glm::dvec2& from, const glm::dvec2& to)
{
    const Skeleton& skeleton = tree.tree->skeleton;
    bool any = false;
    for (Index b = 0; b < tree.start.size(); ++b) {
        const auto share =
            tree.start[b] && tree.end[b] ? crossing(from, to, *tree.start[b], *tree.end[b]) : std::nullopt;
        if (!share || glm::mix(skeleton.a0[b], skeleton.a1[b], *share) > m_context.hand.options().sawThickest)
            continue;
        if (!m_edit) {
            auto edit = HandEdit::begin(m_context.document, tree.node);
            if (!edit)
                return false;
            m_edit = std::move(*edit);
        }
        const LimbSpan& span = tree.spans[b];
        any = cut(span.address, glm::mix(span.from, span.to, *share)) || any;
    }
    if (any)
        report(m_edit->show());
    return any;
}

/// \param metres from the foot of the limb. \return false where that is gone already
bool SawTool::cut(std::uint64_t address, double metres)
{
    constexpr double foot = 0.02; // of a length: what is cut below it goes as a whole
    const double length = m_edit->context().lengthOf(address);
    if (!(metres < length))
        return false;
    TreeEdit edit;
    edit.target.address = address;
    edit.at = metres / length;
    edit.falls = fallsAfter().has_value();
    edit.seconds = fallsAfter().value_or(0.0);
    edit.operation = edit.at < foot && !edit.falls ? EditOperation::Remove : EditOperation::Cut;
    return m_edit->add(edit).has_value();
}

void SawTool::release(const ToolPoint& point)
{
    if (m_way != SawWay::Line) {
        m_context.host.unmarkBranches();
        if (m_line.size() > 2 && point.isDrag())
            report(cutArea());
    }
    m_line.clear();
    if (const auto edit = std::exchange(m_edit, nullptr)) {
        edit->keep();
        reportFall();
    }
    m_context.host.repaint();
}

void SawTool::cancel()
{
    m_context.host.unmarkBranches();
    m_line.clear();
    if (const auto edit = std::exchange(m_edit, nullptr))
        edit->cancel();
    m_context.host.repaint();
}

void SawTool::paint(QPainter& painter, const PickView& view)
{
    if (m_line.size() < 2)
        return;
    painter.setPen(QPen(QColor(16, 22, 28, 150), 4.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    QPolygonF line = m_line;
    if (m_way != SawWay::Line) {
        line << line.front();
        painter.save();
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor(handRed.red(), handRed.green(), handRed.blue(), 40));
        painter.drawPolygon(m_line);
        painter.restore();
    }
    painter.drawPolyline(line);
    painter.setPen(QPen(handRed, 2.0, Qt::DashLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);
    if (m_edit)
        paintReadout(painter, m_line.back(), sizeOf(view),
                     tr("%n cut(s)", nullptr, static_cast<int>(m_edit->edits().size())));
}

} // namespace

std::unique_ptr<Tool> makeSawTool(ToolContext& context)
{
    return std::make_unique<SawTool>(context, HandTool::Saw);
}

} // namespace ramure
