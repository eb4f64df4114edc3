/// \file
/// How the viewport shows the scene: what menus and toolbars switch. Exists also where OpenGL does not.
#pragma once

#include "core/game_wind/wind_profile.h"
#include "widgets/base/option.h"
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
    template <class T> using Option = ramure::Option<ViewSettings, T>;

    explicit ViewSettings(QObject* parent = nullptr);

    /// Tools that move nodes, paths and ghosts: its own changed() tells, changed() here does not.
    [[nodiscard]] GizmoSettings* gizmo() const { return m_gizmo; }
    /// Tools that shape trees: likewise. Only one tool of both is chosen.
    [[nodiscard]] HandSettings* hand() const { return m_hand; }
    /// Resets light, wind of a game, tools and their options to their defaults, so that the next document
    /// does not inherit them. The settings of the drawing itself (modes, quality, visible parts) stay.
    void beginDocument();

    Option<DisplayMode> displayMode{this, DisplayMode::Mesh};
    Option<ShadingMode> shadingMode{this, ShadingMode::Solid};
    Option<Quality> quality{this, Quality::Good}; ///< while nothing moves
    Option<FrameDisplay> frameDisplay{this, FrameDisplay::None};
    Option<NavigationStyle> navigationStyle{this, NavigationStyle::Blender};
    Option<bool> leavesVisible{this, true};
    Option<bool> applesVisible{this, true};
    Option<bool> gridVisible{this, true};
    Option<bool> groundVisible{this, true};
    Option<bool> figureVisible{this, false}; ///< a person of 1.8 m
    Option<bool> meadowVisible{this, true};  ///< grass and fallen leaves around trees
    Option<bool> orthographic{this, false};
    Option<bool> windVisible{this, false};
    Option<bool> outlineVisible{this, true}; ///< around the selection
    Option<bool> crownsVisible{this, true};  ///< envelopes that selected trees grow to fill
    Option<SceneLight> light{this, {}};
    Option<WindProfile> gameWind{this, WindProfile::None}; ///< in which trees at rest move; None: none blows
    Option<double> gameWindStrength{this, 0.6};            ///< 1: a strong wind

signals:
    /// After any of the above.
    void changed();

private:
    GizmoSettings* m_gizmo;
    HandSettings* m_hand;
};

} // namespace ramure
