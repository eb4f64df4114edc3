// The tape measure: how far two places of the view are from each other, and how thick a branch is.
#include "core/evaluate/evaluator.h"
#include "widgets/view/tools/readout.h"
#include "widgets/view/tools/tool_table.h"
#include <QCoreApplication>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

/// A place under the cursor, m in the world.
struct Place
{
    glm::dvec3 point{0.0};
    double diameter = 0.0; ///< m, of the branch there; 0: there is none
};

QString metres(double length)
{
    return QCoreApplication::translate("ramure::MeasureTool", "%1 m").arg(QLocale().toString(length, 'f', 2));
}

class MeasureTool : public Tool
{
    Q_DECLARE_TR_FUNCTIONS(ramure::MeasureTool)
public:
    explicit MeasureTool(ToolContext& context)
        : Tool(context)
    {
        connect(&context.gizmo, &GizmoSettings::changed, this, [this] {
            if (!isChosen())
                clear();
        });
    }
    [[nodiscard]] bool isChosen() const override { return m_context.gizmo.tool() == TransformTool::Measure; }
    [[nodiscard]] QCursor cursor() const override { return Qt::CrossCursor; }
    bool hover(const ToolPoint& point) override;
    void leave() override { show(std::nullopt); }
    bool press(const ToolPoint& point) override;
    void drag(const ToolPoint& point) override
    {
        m_mouse = point.at;
        show(placeAt(point, {}));
    }
    void release(const ToolPoint& point) override;
    void cancel() override { clear(); }
    [[nodiscard]] bool goesOn() const override { return isBusy(); }
    [[nodiscard]] QString hint(Qt::KeyboardModifiers) const override
    {
        return tr("%1 · release: the tape stays · Esc: no tape").arg(tapeText());
    }
    [[nodiscard]] QString hintAt(const ToolPoint& point) const override
    {
        if (!isChosen() || point.held != Qt::NoModifier)
            return {};
        const QString next =
            m_from && !m_to ? tr("Click: the tape ends here")
                            : tr("Click: the tape begins here · drag: from here to there · Esc: lay it down");
        QStringList words{tapeText(), branchText(), next};
        words.removeAll(QString());
        return words.join(QStringLiteral(" · "));
    }
    void paint(QPainter& painter, const PickView& view) override;

private:
    [[nodiscard]] Place placeAt(const ToolPoint& point, std::chrono::milliseconds patience) const;
    [[nodiscard]] double diameterAt(const PickHit& hit) const;
    void show(const std::optional<Place>& place);
    [[nodiscard]] std::optional<glm::dvec3> end() const;
    [[nodiscard]] QString tapeText() const;
    [[nodiscard]] QString branchText() const;
    void clear();

    std::optional<Place> m_at; ///< under the cursor
    std::optional<glm::dvec3> m_from, m_to;
    QPointF m_mouse;
    bool m_begins = false; ///< the press that goes on began the tape
};

/// Of the wood under its bark's picture: as the skeleton has it.
double MeasureTool::diameterAt(const PickHit& hit) const
{
    const TreeResult* tree = m_context.host.shownTree(hit.node);
    if (!tree || !tree->simplified || hit.branch >= tree->simplified->skeleton.size())
        return 0.0;
    const Skeleton& skeleton = tree->simplified->skeleton;
    EvaluatedScene now(m_context.document.scene(), m_context.seconds());
    const glm::dmat4 world = now.transforms(hit.node).geometry;
    const glm::dvec3 at(glm::inverse(world) * glm::dvec4(hit.point, 1.0));
    const glm::dvec3 foot = skeleton.p0[hit.branch], way = skeleton.p1[hit.branch] - foot;
    const double share = std::clamp(glm::dot(at - foot, way) / std::max(glm::dot(way, way), 1e-18), 0.0, 1.0);
    const double size = std::cbrt(std::abs(glm::determinant(glm::dmat3(world))));
    return 2.0 * size * glm::mix(skeleton.a0[hit.branch], skeleton.a1[hit.branch], share);
}

/// On what is there; else on the ground, where that is not too far; else as deep in the picture as the other
/// end of the tape.
Place MeasureTool::placeAt(const ToolPoint& point, std::chrono::milliseconds patience) const
{
    constexpr double farthest = 20.0; // times the camera's distance
    const auto scene = m_context.host.pickScene(patience);
    const auto& picked = scene ? scene : m_context.host.latestPickScene();
    if (const auto hit = picked ? picked->pick(point.view, point.pixel()) : std::nullopt)
        return {hit->point, diameterAt(*hit)};
    const Camera& camera = point.view.camera;
    const ViewRay ray = camera.ray(point.view.ndc(point.pixel()), point.view.aspect());
    const double down = (m_context.host.shownScene().ground - ray.origin.y) / ray.direction.y;
    if (down > 0.0 && down < farthest * camera.distance)
        return {ray.origin + down * ray.direction};
    const glm::dvec3 deep = m_from.value_or(camera.target), back = camera.backward();
    return {ray.origin + glm::dot(deep - ray.origin, back) / glm::dot(ray.direction, back) * ray.direction};
}

bool MeasureTool::hover(const ToolPoint& point)
{
    if (!isChosen())
        return false;
    m_mouse = point.at;
    show(placeAt(point, {}));
    return true;
}

bool MeasureTool::press(const ToolPoint& point)
{
    if (!isChosen() || point.button != Qt::LeftButton || point.held != Qt::NoModifier)
        return false;
    m_mouse = point.at;
    m_begins = !m_from || m_to;
    if (m_begins) {
        m_from.reset(); // a place in the air is as deep as the camera's target
        m_from = placeAt(point, shapePatience).point;
        m_to.reset();
    }
    show(placeAt(point, shapePatience));
    return true;
}

void MeasureTool::release(const ToolPoint& point)
{
    m_mouse = point.at;
    if (!m_begins || point.isDrag())
        m_to = placeAt(point, shapePatience).point;
    m_context.host.updateHint();
    m_context.host.repaint();
}

void MeasureTool::show(const std::optional<Place>& place)
{
    if (!m_at && !place)
        return;
    m_at = place;
    m_context.host.updateHint();
    m_context.host.repaint();
}

void MeasureTool::clear()
{
    m_from.reset();
    m_to.reset();
    show(std::nullopt);
    m_context.host.repaint();
}

/// The end of the tape, which may still follow the mouse.
std::optional<glm::dvec3> MeasureTool::end() const
{
    return m_to ? m_to : m_from && m_at ? std::optional(m_at->point) : m_from;
}

QString MeasureTool::tapeText() const
{
    if (!m_from)
        return {};
    const glm::dvec3 way = *end() - *m_from;
    return tr("%1 · height %2 · across %3")
        .arg(metres(glm::length(way)), metres(way.y), metres(std::hypot(way.x, way.z)));
}

QString MeasureTool::branchText() const
{
    return m_at && m_at->diameter > 0.0
               ? tr("diameter %1 cm").arg(QLocale().toString(100.0 * m_at->diameter, 'f', 1))
               : QString();
}

/// The tape, with the level and the upright way between its ends.
void MeasureTool::paint(QPainter& painter, const PickView& view)
{
    if (!isChosen())
        return;
    QStringList words{tapeText(), branchText()};
    if (m_from) {
        const QColor ink(16, 22, 28), yellow(255, 205, 60);
        const glm::dvec3 last = *end();
        const auto a = view.pixel(*m_from), b = view.pixel(last), c = view.pixel({last.x, m_from->y, last.z});
        const auto line = [&](const auto& from, const auto& to, const QPen& pen) {
            painter.setPen(pen);
            if (from && to)
                painter.drawLine(QPointF(from->x, from->y), QPointF(to->x, to->y));
        };
        const QPen thin(QColor(255, 255, 255, 190), 1.0, Qt::DashLine);
        line(a, c, thin);
        line(c, b, thin);
        line(a, b, QPen(ink, 4.5, Qt::SolidLine, Qt::RoundCap));
        line(a, b, QPen(yellow, 2.0, Qt::SolidLine, Qt::RoundCap));
        painter.setBrush(yellow);
        painter.setPen(QPen(ink, 1.0));
        for (const auto& tip : {a, b})
            if (tip)
                painter.drawEllipse(QPointF(tip->x, tip->y), 3.5, 3.5);
        // The tape and what it says stay where they are; two boxes would hide each other.
        constexpr double apart = 60.0;
        if (m_to && b && glm::distance(*b, {m_mouse.x(), m_mouse.y()}) > apart)
            paintReadout(painter, {b->x, b->y}, sizeOf(view), words.takeFirst());
    }
    words.removeAll(QString());
    if (!words.isEmpty() && (m_at || m_to))
        paintReadout(painter, m_mouse, sizeOf(view), words.join(QStringLiteral(" · ")));
}

} // namespace

std::unique_ptr<Tool> makeMeasureTool(ToolContext& context)
{
    return std::make_unique<MeasureTool>(context);
}

} // namespace ramure
