#include "widgets/view/view_settings.h"

#include "widgets/view/tools/gizmo_settings.h"
#include "widgets/view/tools/hand_settings.h"

namespace ramure {

ViewSettings::ViewSettings(QObject* parent)
    : QObject(parent)
    , m_gizmo(new GizmoSettings(this))
    , m_hand(new HandSettings(this))
{
    connect(m_hand, &HandSettings::toolChanged, m_gizmo, [this](HandTool tool) {
        if (tool != HandTool::None)
            m_gizmo->setTool(TransformTool::Select);
    });
    connect(m_gizmo, &GizmoSettings::changed, m_hand, [this] {
        if (m_gizmo->tool() != TransformTool::Select)
            m_hand->setTool(HandTool::None);
    });
}

template <class T> void ViewSettings::set(T& member, T value, void (ViewSettings::*signal)(T))
{
    if (member == value)
        return;
    member = value;
    emit(this->*signal)(value);
    emit changed();
}

void ViewSettings::setDisplayMode(DisplayMode mode)
{
    set(m_displayMode, mode, &ViewSettings::displayModeChanged);
}

void ViewSettings::setShadingMode(ShadingMode mode)
{
    set(m_shadingMode, mode, &ViewSettings::shadingModeChanged);
}

void ViewSettings::setQuality(Quality quality)
{
    set(m_quality, quality, &ViewSettings::qualityChanged);
}

void ViewSettings::setFrameDisplay(FrameDisplay frames)
{
    set(m_frameDisplay, frames, &ViewSettings::frameDisplayChanged);
}

void ViewSettings::setNavigationStyle(NavigationStyle style)
{
    set(m_navigationStyle, style, &ViewSettings::navigationStyleChanged);
}

void ViewSettings::setLeavesVisible(bool on)
{
    set(m_leavesVisible, on, &ViewSettings::leavesVisibleChanged);
}

void ViewSettings::setApplesVisible(bool on)
{
    set(m_applesVisible, on, &ViewSettings::applesVisibleChanged);
}

void ViewSettings::setGridVisible(bool on)
{
    set(m_gridVisible, on, &ViewSettings::gridVisibleChanged);
}

void ViewSettings::setGroundVisible(bool on)
{
    set(m_groundVisible, on, &ViewSettings::groundVisibleChanged);
}

void ViewSettings::setOrthographic(bool on)
{
    set(m_orthographic, on, &ViewSettings::orthographicChanged);
}

void ViewSettings::setCrownsVisible(bool on)
{
    set(m_crownsVisible, on, &ViewSettings::crownsVisibleChanged);
}

void ViewSettings::setOutlineVisible(bool on)
{
    set(m_outlineVisible, on, &ViewSettings::outlineVisibleChanged);
}

void ViewSettings::setLight(SceneLight light)
{
    set(m_light, light, &ViewSettings::lightChanged);
}

void ViewSettings::setGameWind(WindProfile game)
{
    set(m_gameWind, game, &ViewSettings::gameWindChanged);
}

void ViewSettings::setGameWindStrength(double strength)
{
    set(m_gameWindStrength, strength, &ViewSettings::gameWindStrengthChanged);
}

void ViewSettings::beginDocument()
{
    setLight({});
    setGameWind(WindProfile::None);
    m_hand->setTool(HandTool::None);
    m_hand->setOptions({});
    m_gizmo->beginDocument();
}

void ViewSettings::setWindVisible(bool on)
{
    set(m_windVisible, on, &ViewSettings::windVisibleChanged);
}

} // namespace ramure
