/// \file
/// How the viewport shows the scene: what menus and toolbars switch. Exists also where OpenGL does not.
#pragma once

#include "core/game_wind/wind_profile.h"
#include "widgets/base/theme/navigation_style.h"
#include "widgets/view/render/renderer_options.h"
#include <QObject>

namespace ramure {

class GizmoSettings;
class HandSettings;

class ViewSettings : public QObject
{
    Q_OBJECT
public:
    explicit ViewSettings(QObject* parent = nullptr);

    /// Tools that move nodes, paths and ghosts: its own changed() tells, changed() here does not.
    [[nodiscard]] GizmoSettings* gizmo() const { return m_gizmo; }
    /// Tools that shape trees: likewise. Only one tool of both is chosen.
    [[nodiscard]] HandSettings* hand() const { return m_hand; }

    [[nodiscard]] DisplayMode displayMode() const { return m_displayMode; }
    [[nodiscard]] ShadingMode shadingMode() const { return m_shadingMode; }
    [[nodiscard]] Quality quality() const { return m_quality; }
    [[nodiscard]] FrameDisplay frameDisplay() const { return m_frameDisplay; }
    [[nodiscard]] NavigationStyle navigationStyle() const { return m_navigationStyle; }
    [[nodiscard]] bool leavesVisible() const { return m_leavesVisible; }
    [[nodiscard]] bool applesVisible() const { return m_applesVisible; }
    [[nodiscard]] bool gridVisible() const { return m_gridVisible; }
    [[nodiscard]] bool groundVisible() const { return m_groundVisible; }
    [[nodiscard]] bool orthographic() const { return m_orthographic; }
    [[nodiscard]] bool windVisible() const { return m_windVisible; }
    [[nodiscard]] bool outlineVisible() const { return m_outlineVisible; }
    [[nodiscard]] bool crownsVisible() const { return m_crownsVisible; }
    [[nodiscard]] SceneLight light() const { return m_light; }
    /// In which trees at rest move; None: none blows.
    [[nodiscard]] WindProfile gameWind() const { return m_gameWind; }
    [[nodiscard]] double gameWindStrength() const { return m_gameWindStrength; } ///< 1: a strong wind

public slots:
    /// Gives light, wind of a game, tools and their options their defaults: the next document must not
    /// inherit what was set for the last one. How the view is drawn (modes, quality, what is visible) stays.
    void beginDocument();
    void setDisplayMode(ramure::DisplayMode mode);
    void setShadingMode(ramure::ShadingMode mode);
    void setQuality(ramure::Quality quality);
    void setFrameDisplay(ramure::FrameDisplay frames);
    void setNavigationStyle(ramure::NavigationStyle style);
    void setLeavesVisible(bool on);
    void setApplesVisible(bool on);
    void setGridVisible(bool on);
    void setGroundVisible(bool on);
    void setOrthographic(bool on);
    void setWindVisible(bool on);
    void setOutlineVisible(bool on);
    void setCrownsVisible(bool on);
    void setLight(ramure::SceneLight light);
    void setGameWind(ramure::WindProfile game);
    void setGameWindStrength(double strength);

signals:
    void displayModeChanged(ramure::DisplayMode mode);
    void shadingModeChanged(ramure::ShadingMode mode);
    void qualityChanged(ramure::Quality quality);
    void frameDisplayChanged(ramure::FrameDisplay frames);
    void navigationStyleChanged(ramure::NavigationStyle style);
    void leavesVisibleChanged(bool on);
    void applesVisibleChanged(bool on);
    void gridVisibleChanged(bool on);
    void groundVisibleChanged(bool on);
    void orthographicChanged(bool on);
    void windVisibleChanged(bool on);
    void outlineVisibleChanged(bool on);
    void crownsVisibleChanged(bool on);
    void lightChanged(ramure::SceneLight light);
    void gameWindChanged(ramure::WindProfile game);
    void gameWindStrengthChanged(double strength);
    /// After any of the above.
    void changed();

private:
    template <class T> void set(T& member, T value, void (ViewSettings::*signal)(T));

    GizmoSettings* m_gizmo;
    HandSettings* m_hand;
    DisplayMode m_displayMode = DisplayMode::Mesh;
    ShadingMode m_shadingMode = ShadingMode::Solid;
    Quality m_quality = Quality::Good; ///< while nothing moves
    FrameDisplay m_frameDisplay = FrameDisplay::None;
    NavigationStyle m_navigationStyle = NavigationStyle::Blender;
    bool m_leavesVisible = true;
    bool m_applesVisible = true;
    bool m_gridVisible = true;
    bool m_groundVisible = true;
    bool m_orthographic = false;
    bool m_windVisible = false;
    bool m_outlineVisible = true; ///< around what is selected
    bool m_crownsVisible = true;  ///< of selected trees that grow to fill one
    SceneLight m_light;
    WindProfile m_gameWind = WindProfile::None;
    double m_gameWindStrength = 0.6;
};

} // namespace ramure
