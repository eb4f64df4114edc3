#include "widgets/view/tools/gizmo_settings.h"

#include <algorithm>
#include <cmath>

namespace ramure {

GizmoSettings::GizmoSettings(QObject* parent)
    : QObject(parent)
{
}

template <class T> void GizmoSettings::set(T& member, const T& value)
{
    if (member == value)
        return;
    member = value;
    emit changed();
}

void GizmoSettings::beginDocument()
{
    setTool(TransformTool::Select);
    setSpace(TransformSpace::World);
    setSnaps(false);
    setShowsPath(false);
    setShowsGhosts(false);
}

void GizmoSettings::setTool(TransformTool tool)
{
    set(m_tool, tool);
}

void GizmoSettings::setSpace(TransformSpace space)
{
    set(m_space, space);
}

void GizmoSettings::setSnaps(bool on)
{
    set(m_snaps, on);
}

void GizmoSettings::setSteps(const SnapSteps& steps)
{
    const auto good = [](double next, double now) { return std::isfinite(next) && next > 0.0 ? next : now; };
    set(m_steps, SnapSteps{good(steps.move, m_steps.move), good(steps.turnDeg, m_steps.turnDeg),
                           good(steps.scale, m_steps.scale)});
}

void GizmoSettings::setShowsPath(bool on)
{
    set(m_path, on);
}

void GizmoSettings::setShowsGhosts(bool on)
{
    set(m_ghosts, on);
}

void GizmoSettings::setGhostFrames(const GhostFrames& frames)
{
    set(m_ghostFrames,
        GhostFrames{std::clamp(frames.before, 0, mostGhosts), std::clamp(frames.after, 0, mostGhosts),
                    std::clamp(frames.step, 1, mostGhostStep)});
}

void GizmoSettings::setRadians(bool on)
{
    set(m_radians, on);
}

QVariantMap GizmoSettings::saved() const
{
    return {{QStringLiteral("moveStep"), m_steps.move},
            {QStringLiteral("turnStep"), m_steps.turnDeg},
            {QStringLiteral("scaleStep"), m_steps.scale},
            {QStringLiteral("ghostsBefore"), m_ghostFrames.before},
            {QStringLiteral("ghostsAfter"), m_ghostFrames.after},
            {QStringLiteral("ghostStep"), m_ghostFrames.step}};
}

void GizmoSettings::restore(const QVariantMap& saved)
{
    const auto number = [&saved](const char* key, double now) {
        bool good = false;
        const double value = saved.value(QLatin1String(key)).toDouble(&good);
        return good && std::isfinite(value) && std::abs(value) < 1e9 ? value : now;
    };
    const auto whole = [&number](const char* key, int now) { return int(number(key, now)); };
    setSteps({number("moveStep", m_steps.move), number("turnStep", m_steps.turnDeg),
              number("scaleStep", m_steps.scale)});
    setGhostFrames({whole("ghostsBefore", m_ghostFrames.before), whole("ghostsAfter", m_ghostFrames.after),
                    whole("ghostStep", m_ghostFrames.step)});
}

} // namespace ramure
