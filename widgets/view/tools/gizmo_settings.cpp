#include "widgets/view/tools/gizmo_settings.h"

#include <algorithm>
#include <cmath>

namespace ramure {

GizmoSettings::GizmoSettings(QObject* parent)
    : QObject(parent)
{
}

void GizmoSettings::beginDocument()
{
    tool.set(TransformTool::Select);
    space.set(TransformSpace::World);
    for (Option<bool>* each : {&snaps, &showsPath, &showsGhosts})
        each->set(false);
}

void GizmoSettings::setSteps(const SnapSteps& steps)
{
    const auto good = [](double next, double now) { return std::isfinite(next) && next > 0.0 ? next : now; };
    const SnapSteps& now = m_steps();
    m_steps.set({good(steps.move, now.move), good(steps.turnDeg, now.turnDeg), good(steps.scale, now.scale)});
}

void GizmoSettings::setGhostFrames(const GhostFrames& frames)
{
    m_ghostFrames.set({std::clamp(frames.before, 0, mostGhosts), std::clamp(frames.after, 0, mostGhosts),
                       std::clamp(frames.step, 1, mostGhostStep)});
}

QVariantMap GizmoSettings::saved() const
{
    return {{QStringLiteral("moveStep"), steps().move},
            {QStringLiteral("turnStep"), steps().turnDeg},
            {QStringLiteral("scaleStep"), steps().scale},
            {QStringLiteral("ghostsBefore"), ghostFrames().before},
            {QStringLiteral("ghostsAfter"), ghostFrames().after},
            {QStringLiteral("ghostStep"), ghostFrames().step}};
}

void GizmoSettings::restore(const QVariantMap& saved)
{
    const auto number = [&saved](const char* key, double now) {
        bool good = false;
        const double value = saved.value(QLatin1String(key)).toDouble(&good);
        return good && std::isfinite(value) && std::abs(value) < 1e9 ? value : now;
    };
    const auto whole = [&number](const char* key, int now) { return int(number(key, now)); };
    setSteps({number("moveStep", steps().move), number("turnStep", steps().turnDeg),
              number("scaleStep", steps().scale)});
    setGhostFrames({whole("ghostsBefore", ghostFrames().before), whole("ghostsAfter", ghostFrames().after),
                    whole("ghostStep", ghostFrames().step)});
}

} // namespace ramure
