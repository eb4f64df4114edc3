#include "widgets/view/render/display_mode.h"

#include <QtGlobal>

namespace ramure {

std::span<const DisplayModeRow> displayModes()
{
    static constexpr DisplayModeRow rows[] = {
        {{DisplayMode::Skeleton, "view.skeleton", "mode-skeleton", QT_TRANSLATE_NOOP("Actions", "&Skeleton"),
          QT_TRANSLATE_NOOP("Actions", "The branches as lines, as the grammar grew them")},
         Shown::Lines,
         Stage::Simplified},
        {{DisplayMode::Simplified, "view.simplified", "mode-simplified",
          QT_TRANSLATE_NOOP("Actions", "S&implified skeleton"),
          QT_TRANSLATE_NOOP("Actions",
                            "The skeleton of the mesh: branches as lines, with straight runs joined")},
         Shown::Lines,
         Stage::Simplified},
        {{DisplayMode::Rough, "view.rough", "mode-rough", QT_TRANSLATE_NOOP("Actions", "&Rough model"),
          QT_TRANSLATE_NOOP("Actions", "A plain tube for each branch")},
         Shown::Tubes,
         Stage::Foliage},
        {{DisplayMode::Sections, "view.sections", "mode-sections",
          QT_TRANSLATE_NOOP("Actions", "&Cross-sections"),
          QT_TRANSLATE_NOOP("Actions", "The cross-sections between which the mesh is stretched")},
         Shown::Lines,
         Stage::Sections},
        {{DisplayMode::Mesh, "view.mesh", "mode-mesh", QT_TRANSLATE_NOOP("Actions", "&Mesh"),
          QT_TRANSLATE_NOOP("Actions", "The surface as it is exported")},
         Shown::Surface,
         Stage::Foliage},
        {{DisplayMode::Checker, "view.checker", "mode-checker",
          QT_TRANSLATE_NOOP("Actions", "Chec&ker of the texture"),
          QT_TRANSLATE_NOOP("Actions", "A checker on the surface shows how the texture lies")},
         Shown::Texture,
         Stage::Foliage},
        {{DisplayMode::Stretch, "view.stretch", "mode-stretch",
          QT_TRANSLATE_NOOP("Actions", "S&tretch of the texture"),
          QT_TRANSLATE_NOOP("Actions", "Colours show where the texture is stretched")},
         Shown::Texture,
         Stage::Foliage},
    };
    return rows;
}

std::span<const ModeRow<ShadingMode>> shadingModes()
{
    static constexpr ModeRow<ShadingMode> rows[] = {
        {ShadingMode::Solid, "view.solid", "solid", QT_TRANSLATE_NOOP("Actions", "S&olid"), nullptr},
        {ShadingMode::SolidWire, "view.solidWire", "solid-wire",
         QT_TRANSLATE_NOOP("Actions", "Solid with &edges"), nullptr},
        {ShadingMode::Wire, "view.wire", "wire", QT_TRANSLATE_NOOP("Actions", "&Wireframe"), nullptr},
    };
    return rows;
}

std::span<const ModeRow<Quality>> qualities()
{
    static constexpr ModeRow<Quality> rows[] = {
        {Quality::Draft, "view.draft", nullptr, QT_TRANSLATE_NOOP("Actions", "&Draft quality"),
         QT_TRANSLATE_NOOP("Actions", "Sun and sky light alone")},
        {Quality::Good, "view.good", nullptr, QT_TRANSLATE_NOOP("Actions", "Goo&d quality"),
         QT_TRANSLATE_NOOP("Actions", "Crowns are darker inside, while nothing moves")},
        {Quality::Best, "view.best", nullptr, QT_TRANSLATE_NOOP("Actions", "&Best quality"),
         QT_TRANSLATE_NOOP("Actions", "Smooth edges and soft shadows, while nothing moves")},
    };
    return rows;
}

} // namespace ramure
