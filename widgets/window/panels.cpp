#include "widgets/window/panels.h"

#include "widgets/panels/animation/key_panel.h"
#include "widgets/panels/arm/arm_panel.h"
#include "widgets/panels/history/history_dock.h"
#include "widgets/panels/inspector/branch_inspector.h"
#include "widgets/panels/levels/levels_panel.h"
#include "widgets/panels/presets/gallery_panel.h"
#include "widgets/panels/properties/properties_panel.h"
#include "widgets/panels/recipe/recipe_panel.h"
#include "widgets/panels/scene/scene_panel.h"
#include "widgets/panels/timeline/timeline_panel.h"
#include "widgets/panels/validation/validation_panel.h"

namespace ramure {

/// A panel that needs the document alone, or these services of the window.
template <class Panel, auto... services> static QWidget* make(const PanelServices& of, QWidget* parent)
{
    return new Panel(of.document, of.*services..., parent);
}

static QWidget* makeKeys(const PanelServices& of, QWidget* parent)
{
    return new KeyPanel(of.keyModel, of.keyCommands, of.keyActions, of.player, parent);
}

std::span<const PanelRow> panels()
{
    using enum PanelPlace;
    static constexpr PanelRow rows[] = {
        {"sceneDock", QT_TRANSLATE_NOOP("ramure::MainWindow", "Scene"), UpperRight, "window#scene",
         &make<ScenePanel, &PanelServices::preferences>},
        {"propertiesDock", QT_TRANSLATE_NOOP("ramure::MainWindow", "Properties"), LowerRight,
         "window#properties", &make<PropertiesPanel, &PanelServices::preferences>},
        {"recipeDock", QT_TRANSLATE_NOOP("ramure::MainWindow", "Recipe"), UpperRight, "hand#the-recipe",
         &make<RecipePanel>},
        {"inspectorDock", QT_TRANSLATE_NOOP("ramure::MainWindow", "Inspector"), LowerRight,
         "window#inspector", &make<BranchInspector>},
        {"validationDock", QT_TRANSLATE_NOOP("ramure::MainWindow", "Validation"), LowerRight,
         "window#validation", &make<ValidationPanel, &PanelServices::analysis>},
        {"levelsDock", QT_TRANSLATE_NOOP("ramure::MainWindow", "Levels"), LowerRight, "window#levels",
         &make<LevelsPanel, &PanelServices::preferences>},
        {"historyDock", QT_TRANSLATE_NOOP("ramure::MainWindow", "History"), UpperRight, "window#history",
         &make<HistoryDock>},
        {"galleryDock", QT_TRANSLATE_NOOP("ramure::MainWindow", "Gallery"), UpperRight, "window#gallery",
         &make<GalleryPanel, &PanelServices::preferences>},
        {"timelineDock", QT_TRANSLATE_NOOP("ramure::MainWindow", "Timeline"), Bottom, "motion#the-timeline",
         &make<TimelinePanel, &PanelServices::player, &PanelServices::plays>},
        {"keysDock", QT_TRANSLATE_NOOP("ramure::MainWindow", "Keys"), Bottom, "keys#the-dope-sheet",
         &makeKeys},
        {"armDock", QT_TRANSLATE_NOOP("ramure::MainWindow", "Arm"), LowerRight, "arm#joints",
         &make<ArmPanel>},
    };
    return rows;
}

} // namespace ramure
