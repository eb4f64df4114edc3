// A shape that is dragged around a tree, an outline that is drawn beside it, or a solid of the scene: what
// stands out of it is cut.
#include "core/math/frame.h"
#include "core/scene/edit_shapes.h"
#include "core/scene/kinds/node_kinds.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/view/tools/hand/edit_tool.h"
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

constexpr double leastRadius = 0.01; ///< m, of a radius
/// Pixels: a shape that is smaller was hardly meant, and would take the whole crown.
constexpr double leastDrag = 24.0;
constexpr double aslant =
    0.27; ///< of the other way in the picture: a drag that goes less far is straight (15°)
constexpr int ringSides = 64;

class PruneTool : public EditTool
{
    Q_DECLARE_TR_FUNCTIONS(ramure::PruneTool)
public:
    using EditTool::EditTool;

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
        m_context.host.unmarkBranches();
    }

private:
    [[nodiscard]] EditShapeKind kind() const { return m_context.hand.options().shape; }
    bool takeSolid(const ToolPoint& point);
    void addToOutline(const ToolPoint& point);
    [[nodiscard]] EditShape outline() const;
    [[nodiscard]] EditShape shapeTo(const PickView& view, QPointF at) const;
    [[nodiscard]] TreeEdit editTo(const ToolPoint& point);
    void look(const ToolPoint& point);
    void finish(bool keep);

    std::unique_ptr<HandEdit> m_edit;
    glm::dmat4 m_world{1.0}, m_inverse{1.0};
    glm::dvec3 m_middle{0.0}; ///< m, tree space: where the drag began
    glm::dvec2 m_reach{0.0};  ///< m, from there to the ends of the tree: level, upright
    EditShape m_shape;
    glm::dvec3 m_foot{0.0}; ///< m, tree space, of the trunk: an outline turns about the vertical there
    std::vector<glm::dvec2> m_outline{}; ///< m from that, and above the foot
    bool m_moves = false;
    QPointF m_at;
    Expected<HandLoss> m_loss; ///< of the shape of now; or why it cannot be
};

QString PruneTool::hint(Qt::KeyboardModifiers) const
{
    if (!m_moves)
        return kind() == EditShapeKind::Profile ? tr("Draw half of the outline beside the trunk.")
                                                : tr("Drag from the middle of the tree outwards.");
    return m_loss ? tr("Red: %1 would go · release: cut · Esc: nothing is cut").arg(lossWords(*m_loss))
                  : tr("Nothing is cut: %1 · Esc: back").arg(errorText(m_loss.error()));
}

void PruneTool::offer(ToolOffers& offers) const
{
    if (!isChosen() || offers.held() != Qt::NoModifier)
        return;
    if (kind() == EditShapeKind::Mesh)
        offers.add(ToolOffers::Click, tr("Click a solid around the tree: the wood outside it is cut"));
    else if (kind() == EditShapeKind::Profile)
        offers.add(ToolOffers::Drag, tr("Draw half of the outline beside the trunk: the tree is cut to it"));
    else
        offers.add(ToolOffers::Drag, tr("Drag from the middle of the tree outwards: it is cut to the shape"));
}

bool PruneTool::take(const ToolPoint& point, const std::optional<LimbHit>& limb)
{
    if (kind() == EditShapeKind::Mesh)
        return takeSolid(point);
    const NodeId tree = limb ? limb->node : treeMeant(m_context.document);
    if (tree == noNode) {
        m_context.host.raiseMessage(tr("Press on the tree that is to be pruned, or select it first."));
        return true; // the drag that follows selects nothing
    }
    auto edit = HandEdit::begin(m_context.document, tree);
    if (!edit)
        return refuse(edit.error());
    m_edit = std::move(*edit);
    m_world = worldOf(tree);
    m_inverse = glm::inverse(m_world);
    const SkeletonStats stats = skeletonStats(m_context.document.result(tree)->tree.simplified->skeleton);
    const glm::dvec3 centre(m_world * glm::dvec4(0.5 * (stats.min + stats.max), 1.0));
    m_middle = glm::dvec3(m_inverse * glm::dvec4(pulledTo(point.view, point.pixel(), centre), 1.0));
    const glm::dvec3 reach = glm::max(m_middle - stats.min, stats.max - m_middle) + leastRadius;
    m_reach = {std::hypot(reach.x, reach.z), reach.y};
    m_foot = m_context.document.result(tree)->tree.simplified->skeleton.p0[0];
    m_outline.clear();
    addToOutline(point);
    m_moves = false;
    m_at = point.at;
    setAim({});
    return true;
}

/// The tree that is selected, or the only one, is pruned to what is under the cursor.
bool PruneTool::takeSolid(const ToolPoint& point)
{
    const auto scene = m_context.host.pickScene(pickPatience);
    const auto hit = scene ? scene->pick(point.view, point.pixel()) : std::nullopt;
    const Node* solid = hit ? m_context.document.scene().find(hit->node) : nullptr;
    const NodeId tree = treeMeant(m_context.document);
    if (!solid || !isObject(solid->kind) || tree == noNode) {
        m_context.host.raiseMessage(tr("Select the tree, then click the solid that it is to be pruned to."));
        return true;
    }
    const auto gesture = HandEdit::begin(m_context.document, tree);
    if (!gesture)
        return refuse(gesture.error());
    const auto done = meshShape(m_context.document.scene(), tree, solid->id).and_then([&](EditShape&& shape) {
        TreeEdit edit;
        edit.operation = EditOperation::Prune;
        edit.shape = std::move(shape);
        return (*gesture)->replace({edit}).and_then([&] { return (*gesture)->show(); });
    });
    report(done) ? (*gesture)->keep() : (*gesture)->cancel();
    return true;
}

/// In the upright plane through the trunk that faces the eye.
void PruneTool::addToOutline(const ToolPoint& point)
{
    const ViewRay ray = point.view.camera.ray(point.view.ndc(point.pixel()), point.view.aspect());
    const glm::dvec3 eye(m_inverse * glm::dvec4(ray.origin, 1.0)),
        sight(m_inverse * glm::dvec4(ray.direction, 0.0));
    const glm::dvec3 level(m_foot.x - eye.x, 0.0, m_foot.z - eye.z);
    const double share = glm::dot(m_foot - eye, level) / glm::dot(sight, level);
    const glm::dvec3 at = eye + share * sight - m_foot;
    if (share > 0.0 && std::isfinite(share))
        m_outline.emplace_back(std::hypot(at.x, at.z), at.y);
}

/// Of every height the widest place.
EditShape PruneTool::outline() const
{
    constexpr int heights = 32;
    EditShape shape;
    shape.kind = EditShapeKind::Profile;
    const auto [low, high] = std::ranges::minmax(m_outline, {}, [](const glm::dvec2& p) { return p.y; });
    shape.numbers = {m_foot.x, m_foot.y + low.y, m_foot.z, 0.0, 0.0, 0.0};
    if (high.y - low.y < leastRadius)
        return shape; // of no height: no profile, and the edit says so
    for (int i = 0; i <= heights; ++i) {
        const double height = low.y + (high.y - low.y) * i / heights;
        double widest = 0.0;
        for (std::size_t k = 1; k < m_outline.size(); ++k) {
            const glm::dvec2 a = m_outline[k - 1], b = m_outline[k];
            if (height < std::min(a.y, b.y) || height > std::max(a.y, b.y))
                continue;
            const double t = a.y == b.y ? 0.0 : (height - a.y) / (b.y - a.y);
            widest = std::max({widest, glm::mix(a.x, b.x, t), a.y == b.y ? b.x : 0.0});
        }
        shape.points.emplace_back(widest, height - low.y, 0.0);
    }
    return shape;
}

/// A sphere or a box about the place of the press, or a cone that stands there. Box and cone have two
/// measures: a drag straight to the side or straight up sets one, and the other leaves the tree whole.
EditShape PruneTool::shapeTo(const PickView& view, QPointF at) const
{
    const glm::dvec3 middle(m_world * glm::dvec4(m_middle, 1.0));
    const glm::dvec3 hand(m_inverse * glm::dvec4(pulledTo(view, {at.x(), at.y()}, middle), 1.0));
    const glm::dvec3 way = hand - m_middle;
    const glm::dvec2 drag = glm::abs(glm::dvec2(at.x(), at.y()) - view.pixel(middle).value_or(glm::dvec2()));
    const bool isUp = drag.x < aslant * drag.y, isAside = drag.y < aslant * drag.x;
    const double flat = isUp ? m_reach.x : std::max(std::hypot(way.x, way.z), leastRadius);
    const double high = isAside ? m_reach.y : std::max(std::abs(way.y), leastRadius);
    EditShape shape;
    shape.kind = m_context.hand.options().shape;
    const glm::dvec3& m = m_middle;
    if (shape.kind == EditShapeKind::Sphere)
        shape.numbers = {m.x, m.y, m.z, std::max(glm::length(way), leastRadius), 0.0, 0.0};
    else if (shape.kind == EditShapeKind::Box)
        shape.numbers = {m.x - flat, m.y - high, m.z - flat, m.x + flat, m.y + high, m.z + flat};
    else
        shape.numbers = {m.x, m.y, m.z, flat, high, 0.0};
    return shape;
}

TreeEdit PruneTool::editTo(const ToolPoint& point)
{
    m_shape = kind() == EditShapeKind::Profile ? outline() : shapeTo(point.view, point.at);
    TreeEdit edit;
    edit.operation = EditOperation::Prune;
    edit.shape = m_shape;
    return edit;
}

/// What would go is marked; the tree stays until the hand lets go.
void PruneTool::look(const ToolPoint& point)
{
    m_loss = m_edit->loss(editTo(point));
    m_context.host.markBranches(m_edit->node(), m_loss ? m_loss->branches : std::vector<Index>(), true);
    m_context.host.updateHint();
}

void PruneTool::drag(const ToolPoint& point)
{
    m_at = point.at;
    const QPointF way = point.at - point.pressed;
    m_moves = m_moves || std::hypot(way.x(), way.y()) >= leastDrag;
    if (m_edit && kind() == EditShapeKind::Profile)
        addToOutline(point);
    if (m_edit && m_moves)
        look(point);
    m_context.host.repaint();
}

void PruneTool::release(const ToolPoint& point)
{
    if (!m_edit)
        return;
    if (m_moves)
        return finish(report(m_edit->replace({editTo(point)}).and_then([this] { return m_edit->show(); })));
    m_context.host.raiseMessage(
        kind() == EditShapeKind::Profile
            ? tr("The stroke was too short: draw half of the outline beside the trunk.")
            : tr("The stroke was too short: drag from the middle of the tree outwards, and the red parts "
                 "go."));
    finish(false);
}

void PruneTool::cancel()
{
    finish(false);
}

void PruneTool::finish(bool keep)
{
    if (m_edit)
        keep ? m_edit->keep() : m_edit->cancel();
    m_edit.reset();
    m_context.host.unmarkBranches();
    m_context.host.repaint();
}

/// The lines of a shape, tree space.
std::vector<std::vector<glm::dvec3>> linesOf(const EditShape& shape, const glm::dvec3& sight)
{
    const auto& n = shape.numbers;
    const glm::dvec3 a(n[0], n[1], n[2]), b(n[3], n[4], n[5]);
    const auto ring = [](const glm::dvec3& middle, double radius, const Frame& frame) {
        std::vector<glm::dvec3> line;
        for (int i = 0; i <= ringSides; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / ringSides;
            line.push_back(middle +
                           radius * (std::cos(angle) * frame.normal + std::sin(angle) * frame.binormal));
        }
        return line;
    };
    if (shape.kind == EditShapeKind::Sphere)
        return {ring(a, n[3], frameFromTangent(sight)), ring(a, n[3], Frame{})};
    if (shape.kind == EditShapeKind::Profile) {
        const glm::dvec3 aside = glm::normalize(glm::cross(sight, glm::dvec3(0.0, 1.0, 0.0)) + 1e-9);
        std::vector<std::vector<glm::dvec3>> lines(2);
        for (std::size_t i = 0; i < shape.points.size(); ++i) {
            const glm::dvec3 middle = a + glm::dvec3(0.0, shape.points[i].y, 0.0);
            lines[0].push_back(middle + shape.points[i].x * aside);
            lines[1].push_back(middle - shape.points[i].x * aside);
            if (i % 8 == 0)
                lines.push_back(ring(middle, shape.points[i].x, Frame{}));
        }
        return lines;
    }
    if (shape.kind == EditShapeKind::Cone) {
        const glm::dvec3 top = a + glm::dvec3(0.0, n[4], 0.0);
        std::vector<std::vector<glm::dvec3>> lines{ring(a, n[3], Frame{})};
        for (int i = 0; i < 4; ++i)
            lines.push_back({lines[0][std::size_t(i * ringSides / 4)], top});
        return lines;
    }
    std::vector<std::vector<glm::dvec3>> lines;
    for (const double y : {a.y, b.y})
        lines.push_back({{a.x, y, a.z}, {b.x, y, a.z}, {b.x, y, b.z}, {a.x, y, b.z}, {a.x, y, a.z}});
    for (std::size_t i = 0; i < 4; ++i)
        lines.push_back({lines[0][i], lines[1][i]});
    return lines;
}

void PruneTool::paint(QPainter& painter, const PickView& view)
{
    if (!m_edit || !m_moves)
        return;
    const glm::dvec3 eye(m_inverse * glm::dvec4(view.camera.eye(), 1.0));
    for (const auto& places : linesOf(m_shape, glm::normalize(eye - m_middle))) {
        QPolygonF line;
        for (const glm::dvec3& place : places)
            if (const auto at = view.pixel(glm::dvec3(m_world * glm::dvec4(place, 1.0))))
                line << QPointF(at->x, at->y);
        painter.setPen(QPen(QColor(16, 22, 28, 140), 3.5));
        painter.drawPolyline(line);
        painter.setPen(QPen(handRed, 1.6));
        painter.drawPolyline(line);
    }
    const auto metres = [](double value) { return QLocale().toString(value, 'f', 2); };
    const auto& n = m_shape.numbers;
    QString text;
    if (m_shape.kind == EditShapeKind::Sphere)
        text = tr("radius %1 m").arg(metres(n[3]));
    else if (m_shape.kind == EditShapeKind::Profile)
        text = tr("%1 m high").arg(metres(m_shape.points.empty() ? 0.0 : m_shape.points.back().y));
    else if (m_shape.kind == EditShapeKind::Cone)
        text = tr("radius %1 m, %2 m high").arg(metres(n[3]), metres(n[4]));
    else
        text = tr("%1 m wide, %2 m high").arg(metres(n[3] - n[0]), metres(n[4] - n[1]));
    if (m_loss)
        text += QStringLiteral(" · ") + tr("%1 would go").arg(lossWords(*m_loss));
    paintReadout(painter, m_at, sizeOf(view), text);
}

} // namespace

std::unique_ptr<Tool> makePruneTool(ToolContext& context)
{
    return std::make_unique<PruneTool>(context, HandTool::Prune);
}

} // namespace ramure
