#include "widgets/view/tools/gizmo/gizmo_drag.h"

#include "core/math/angle.h"
#include "core/math/drag_maths.h"
#include "core/scene/world_transforms.h"
#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

constexpr double leastScale = 1e-3;
constexpr double fineShare = 0.1;
constexpr double leastArm = 24.0;              ///< pixels: nearer to the pivot the screen says no ratio
constexpr double leastRingSlope = 0.25;        ///< cosine: flatter rings are turned by pulling along them
constexpr double scalePixelsPerDouble = 120.0; ///< of the scale's middle

struct GizmoWords
{
    Q_DECLARE_TR_FUNCTIONS(GizmoDrag)
};

Ray rayAt(const PickView& view, const glm::dvec2& pixel)
{
    const ViewRay ray = view.camera.ray(view.ndc(pixel), view.aspect());
    return {ray.origin, ray.direction};
}

glm::dvec2 pixelOf(const PickView& view, const glm::dvec3& world)
{
    const auto at = gizmoPixel(view, world);
    return at ? glm::dvec2(at->x(), at->y()) : 0.5 * view.size;
}

double angleOf(const glm::dvec2& v)
{
    return std::atan2(-v.y, v.x); // pixels go down
}

} // namespace

glm::dvec3 shownPivot(const Scene& scene, const std::vector<TransformStart>& starts)
{
    glm::dvec3 sum(0.0);
    for (const TransformStart& start : starts) {
        const Node* node = scene.find(start.node);
        sum += node ? glm::dvec3(geometryUnder(start.world, *node, start.seconds)[3]) : start.origin();
    }
    return sum / double(std::max<std::size_t>(starts.size(), 1));
}

std::unique_ptr<GizmoDrag> GizmoDrag::begin(Document& document, const GizmoSettings& settings,
                                            TransformTool tool, std::optional<GizmoHandle> handle,
                                            double seconds, bool keys, const PickView& view,
                                            const glm::dvec2& pixel)
{
    if (!transforms(tool))
        return nullptr;
    auto starts = transformStarts(document.scene(), document.selection().nodes, seconds, keys);
    if (starts.empty())
        return nullptr;
    return std::unique_ptr<GizmoDrag>(
        new GizmoDrag(document, settings, tool, handle, std::move(starts), view, pixel));
}

GizmoDrag::GizmoDrag(Document& document, const GizmoSettings& settings, TransformTool tool,
                     std::optional<GizmoHandle> handle, std::vector<TransformStart> starts,
                     const PickView& view, const glm::dvec2& pixel)
    : m_document(document)
    , m_settings(settings)
    , m_tool(tool)
    , m_handle(handle)
    , m_space(settings.space())
    , m_starts(std::move(starts))
    , m_byHandle(handle.has_value())
    , m_view(view)
    , m_pressed(pixel)
    , m_hand(pixel)
    , m_last(pixel)
{
    m_document.holdGesture(m_gesture);
    m_place.pivot = shownPivot(document.scene(), m_starts);
    m_keys = std::any_of(m_starts.begin(), m_starts.end(), [](const auto& start) { return start.keys; });
    m_snap = settings.snaps();
    setAxes();
    beginAgain();
}

void GizmoDrag::setAxes()
{
    m_place.axes = transformAxes(m_starts, m_space);
}

/// From here on the hand counts from where it was pressed, with the axes of now.
void GizmoDrag::beginAgain()
{
    m_transform = {};
    m_transform.pivot = m_place.pivot;
    m_amount = glm::dvec3(0.0);
    m_turned = 0.0;
    const bool own = m_handle && m_handle->part == GizmoPart::Axis;
    m_transform.axis = own ? m_place.axes[m_handle->axis] : gizmoSight(m_view, m_place.pivot);
    m_transform.frame = m_place.axes;
    m_turnLast = turnAt(m_pressed);
}

GizmoPlace GizmoDrag::place() const
{
    GizmoPlace now = m_place;
    now.pivot = m_transform.at(m_place.pivot);
    if (m_tool == TransformTool::Rotate && m_space == TransformSpace::Local)
        now.axes = turnAbout(m_transform.axis, m_transform.angleRad) * m_place.axes;
    return now;
}

bool GizmoDrag::moves(int axis) const
{
    if (!m_handle || m_handle->part == GizmoPart::Centre || m_handle->part == GizmoPart::View)
        return true;
    return (m_handle->part == GizmoPart::Axis) == (m_handle->axis == axis);
}

/// The axes that numbers are typed for, in order.
std::array<int, 3> GizmoDrag::fields() const
{
    std::array<int, 3> axes{0, 0, 0};
    std::size_t count = 0;
    for (int axis = 0; axis < 3; ++axis)
        if (moves(axis))
            axes[count++] = axis;
    return axes;
}

int GizmoDrag::fieldCount() const
{
    if (m_tool != TransformTool::Move)
        return 1; // an angle, a factor
    return int(moves(0)) + int(moves(1)) + int(moves(2));
}

void GizmoDrag::moveTo(const PickView& view, const glm::dvec2& pixel, GizmoModifiers modifiers)
{
    m_view = view;
    m_hand += (pixel - m_last) * (modifiers.fine ? fineShare : 1.0);
    m_last = pixel;
    m_snap = modifiers.snap != m_settings.snaps();
    measure(m_snap);
    apply();
}

void GizmoDrag::measure(bool snap)
{
    switch (m_tool) {
    case TransformTool::Move:
        return measureMove(snap);
    case TransformTool::Rotate:
        return measureTurn(snap);
    case TransformTool::Scale:
        return measureScale(snap);
    case TransformTool::Select:
    case TransformTool::Measure:
        break;
    }
}

void GizmoDrag::measureMove(bool snap)
{
    const bool alongOne = m_handle && m_handle->part == GizmoPart::Axis;
    const bool inPlane = m_handle && m_handle->part == GizmoPart::Plane;
    if (alongOne) {
        const glm::dvec3& axis = m_place.axes[m_handle->axis];
        // By the keyboard the hand is anywhere: what counts is its way, as if it held the pivot.
        const glm::dvec2 offset = m_byHandle ? glm::dvec2(0.0) : pixelOf(m_view, m_place.pivot) - m_pressed;
        const auto from = alongAxis(rayAt(m_view, m_pressed + offset), m_place.pivot, axis);
        const auto to = alongAxis(rayAt(m_view, m_hand + offset), m_place.pivot, axis);
        if (from && to) {
            m_amount = glm::dvec3(0.0);
            m_amount[m_handle->axis] = *to - *from;
        }
    } else {
        const glm::dvec3 normal = inPlane ? m_place.axes[m_handle->axis] : m_view.camera.backward();
        const glm::dvec2 offset = m_byHandle ? glm::dvec2(0.0) : pixelOf(m_view, m_place.pivot) - m_pressed;
        const auto from = onPlane(rayAt(m_view, m_pressed + offset), m_place.pivot, normal);
        const auto to = onPlane(rayAt(m_view, m_hand + offset), m_place.pivot, normal);
        if (from && to)
            m_amount = glm::transpose(m_place.axes) * (*to - *from);
        if (inPlane)
            m_amount[m_handle->axis] = 0.0;
    }
    if (snap)
        for (int axis = 0; axis < 3; ++axis)
            m_amount[axis] = snapped(m_amount[axis], m_settings.steps().move);
}

/// The angle of a place on the screen, about the axis. Flat rings have none: see measureTurn.
std::optional<double> GizmoDrag::turnAt(const glm::dvec2& pixel) const
{
    const glm::dvec3 sight = gizmoSight(m_view, m_place.pivot);
    const double facing = glm::dot(sight, m_transform.axis);
    if (!m_byHandle || (m_handle && m_handle->part == GizmoPart::View)) {
        const double angle = angleOf(pixel - pixelOf(m_view, m_place.pivot));
        return facing < 0.0 ? -angle : angle;
    }
    if (std::abs(facing) < leastRingSlope)
        return std::nullopt;
    return aroundRing(rayAt(m_view, pixel), m_place.pivot, m_transform.axis,
                      anyPerpendicular(m_transform.axis));
}

void GizmoDrag::measureTurn(bool snap)
{
    const auto now = turnAt(m_hand);
    if (now && m_turnLast) {
        m_turned += std::remainder(*now - *m_turnLast, 2.0 * pi);
        m_turnLast = now;
    } else if (!m_turnLast) {
        // The ring is seen from its edge: its near side goes with the hand, a radius of way a radian.
        const glm::dvec3 sight = gizmoSight(m_view, m_place.pivot);
        const glm::dvec3 near = m_place.pivot + gizmoMetres(m_view, m_place, gizmoRingReach) * sight;
        const glm::dvec3 way = glm::cross(m_transform.axis, sight);
        const glm::dvec2 along =
            pixelOf(m_view, near + gizmoMetres(m_view, m_place, 20.0) * glm::normalize(way)) -
            pixelOf(m_view, near);
        if (glm::length(along) > 1e-6)
            m_turned = glm::dot(m_hand - m_pressed, glm::normalize(along)) / gizmoRingReach;
    }
    m_transform.angleRad =
        snap ? snapped(m_turned * 180.0 / pi, m_settings.steps().turnDeg) * pi / 180.0 : m_turned;
}

double GizmoDrag::scaleFactor() const
{
    const glm::dvec2 pivot = pixelOf(m_view, m_place.pivot);
    if (m_byHandle && m_handle->part == GizmoPart::Centre) {
        const glm::dvec2 way = m_hand - m_pressed;
        return std::exp2((way.x - way.y) / scalePixelsPerDouble);
    }
    if (m_byHandle && m_handle->part == GizmoPart::Axis) {
        const glm::dvec3& axis = m_place.axes[m_handle->axis];
        const auto from = alongAxis(rayAt(m_view, m_pressed), m_place.pivot, axis);
        const auto to = alongAxis(rayAt(m_view, m_hand), m_place.pivot, axis);
        return from && to && std::abs(*from) > 1e-12 ? *to / *from : 1.0;
    }
    // Towards the pivot smaller, away from it larger; pressed upon it, as if a little beside.
    const double from = std::max(glm::length(m_pressed - pivot), leastArm);
    const double more = glm::length(m_hand - pivot) - glm::length(m_pressed - pivot);
    return std::max(1.0 + more / from, 0.0);
}

void GizmoDrag::measureScale(bool snap)
{
    double factor = std::max(scaleFactor(), leastScale);
    if (snap)
        factor = std::max(snapped(factor, m_settings.steps().scale), leastScale);
    for (int axis = 0; axis < 3; ++axis)
        m_transform.factors[axis] = moves(axis) ? factor : 1.0;
}

/// Typed numbers go before what the hand says.
void GizmoDrag::apply()
{
    WorldTransform transform = m_transform;
    const auto axes = fields();
    glm::dvec3 amount = m_amount;
    const bool anyTyped =
        std::any_of(m_typed.begin(), m_typed.end(), [](const auto& t) { return t.value(); });
    if (m_tool == TransformTool::Move && anyTyped) {
        amount = glm::dvec3(0.0);
        for (int f = 0; f < fieldCount(); ++f)
            amount[axes[std::size_t(f)]] = m_typed[std::size_t(f)].value().value_or(0.0);
    }
    if (m_tool == TransformTool::Move) {
        transform.move = glm::dvec3(0.0);
        for (int axis = 0; axis < 3; ++axis)
            if (amount[axis] != 0.0)
                transform.move += amount[axis] * m_place.axes[axis];
    } else if (const auto typed = m_typed[0].value(); typed && m_tool == TransformTool::Rotate) {
        transform.angleRad = m_settings.radians() ? *typed : *typed * pi / 180.0;
    } else if (typed) {
        for (int axis = 0; axis < 3; ++axis)
            transform.factors[axis] = moves(axis) ? *typed : 1.0;
    }
    if (m_tool == TransformTool::Move)
        m_amount = amount;
    m_transform = transform;
    std::vector<NodePlacing> places;
    places.reserve(m_starts.size());
    for (const TransformStart& start : m_starts)
        if (auto values = transformed(start, transform))
            places.push_back({start.node, std::move(*values), start.keys});
    const QString text = m_tool == TransformTool::Move     ? GizmoWords::tr("Move")
                         : m_tool == TransformTool::Rotate ? GizmoWords::tr("Rotate")
                                                           : GizmoWords::tr("Scale");
    (void)edit::placeNodes(m_document, places, text, m_gesture); // locked meanwhile: it stays
}

void GizmoDrag::keep()
{
    m_document.keepGesture(m_gesture);
}

GizmoDrag::~GizmoDrag()
{
    keep();
}

void GizmoDrag::cancel()
{
    m_typed = {};
    m_transform = {};
    m_amount = glm::dvec3(0.0);
    m_transform.pivot = m_place.pivot;
    m_document.giveUpGesture(m_gesture);
}

/// The same axis again: the other space; a third time: free.
void GizmoDrag::lock(int axis, bool plane)
{
    const GizmoHandle wanted{plane ? GizmoPart::Plane : GizmoPart::Axis, axis};
    const TransformSpace own = m_settings.space();
    const TransformSpace other = own == TransformSpace::World ? TransformSpace::Local : TransformSpace::World;
    if (m_handle != wanted) {
        m_handle = wanted;
        m_space = own;
    } else if (m_space == own) {
        m_space = other;
    } else {
        m_handle.reset();
        m_space = own;
    }
    if (m_tool == TransformTool::Rotate && plane && m_handle)
        m_handle->part = GizmoPart::Axis; // a turn has but an axis
    m_byHandle = false;
    m_field = std::min(m_field, fieldCount() - 1);
    setAxes();
    beginAgain();
    measure(m_snap);
    apply();
}

GizmoDrag::KeyResult GizmoDrag::key(int key, const QString& text, Qt::KeyboardModifiers modifiers)
{
    switch (key) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        return KeyResult::Confirm;
    case Qt::Key_Escape:
        return KeyResult::Cancel;
    case Qt::Key_X:
    case Qt::Key_Y:
    case Qt::Key_Z:
        if (modifiers & (Qt::ControlModifier | Qt::AltModifier))
            return KeyResult::Ignored;
        lock(key - Qt::Key_X, modifiers.testFlag(Qt::ShiftModifier));
        return KeyResult::Taken;
    case Qt::Key_Tab:
        m_field = (m_field + 1) % std::max(1, fieldCount());
        return KeyResult::Taken;
    case Qt::Key_Backspace:
        if (m_typed[std::size_t(m_field)].erase() || m_field == 0) {
            if (std::all_of(m_typed.begin(), m_typed.end(),
                            [](const auto& typed) { return typed.isEmpty(); }))
                measure(m_snap); // the hand counts again
            apply();
        } else {
            --m_field;
        }
        return KeyResult::Taken;
    default:
        break;
    }
    if (m_tool == TransformTool::Scale && (text == QLatin1String("-") || text == QString(QChar(0x2212))))
        return KeyResult::Taken; // there are no mirror images of nodes
    if (text.size() != 1 || !m_typed[std::size_t(m_field)].type(text.front()))
        return KeyResult::Ignored;
    apply();
    return KeyResult::Taken;
}

/// A value, or what is typed in its place.
QString GizmoDrag::number(int field, double value, int decimals) const
{
    const TypedNumber& typed = m_typed[std::size_t(field)];
    const bool anyTyped =
        std::any_of(m_typed.begin(), m_typed.end(), [](const auto& t) { return !t.isEmpty(); });
    if (anyTyped && (field == m_field || !typed.isEmpty()))
        return (typed.isEmpty() ? QStringLiteral("0") : typed.text()) +
               (field == m_field ? QStringLiteral("▏") : QString());
    QString shown =
        QLocale().toString(std::abs(value) < 0.5 * std::pow(10.0, -decimals) ? 0.0 : value, 'f', decimals);
    return shown.replace(u'-', QChar(0x2212));
}

QString GizmoDrag::readout() const
{
    static constexpr std::array names{'X', 'Y', 'Z'};
    QString axis;
    if (m_handle && (m_handle->part == GizmoPart::Axis))
        axis = QString(QLatin1Char(names[std::size_t(m_handle->axis)])) + QLatin1Char(' ');
    QString text;
    if (m_tool == TransformTool::Move) {
        const auto axes = fields();
        for (int f = 0; f < fieldCount(); ++f) {
            const int at = axes[std::size_t(f)];
            text += (f > 0 ? QStringLiteral("   ") : QString()) + QLatin1Char(names[std::size_t(at)]) +
                    QLatin1Char(' ') + number(f, m_amount[at], 3);
        }
        text += QStringLiteral(" m");
    } else if (m_tool == TransformTool::Rotate) {
        const double angle = m_transform.angleRad;
        text = axis + (m_settings.radians() ? number(0, angle, 4) + QStringLiteral(" rad")
                                            : number(0, angle * 180.0 / pi, 1) + QStringLiteral("°"));
    } else {
        const auto axes = fields();
        text = axis + QStringLiteral("× ") + number(0, m_transform.factors[axes[0]], 3);
    }
    const QString spaces[] = {GizmoWords::tr("local"), GizmoWords::tr("parent"), GizmoWords::tr("world")};
    const bool free = !m_handle || m_handle->part == GizmoPart::View ||
                      (m_tool == TransformTool::Scale && m_handle->part == GizmoPart::Centre);
    if (!free || m_tool == TransformTool::Move)
        text += QStringLiteral("  ·  ") + spaces[static_cast<int>(m_space)];
    if (m_keys)
        text += QStringLiteral("  ·  ") + GizmoWords::tr("key");
    return text;
}

} // namespace ramure
