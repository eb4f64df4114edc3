/// \file
/// A whole scene at one time, computed where needed and made into what a picture shows.
#pragma once

#include "widgets/view/render/scene_builder.h"

namespace ramure {

/// Trees that are not shown are not computed. Errors: those of EvaluatedScene::poseArms and of the trees,
/// Cancelled among them.
Expected<RenderScene> renderSceneAt(EvaluatedScene& now, const SceneView& view,
                                    const Progress& progress = {});

} // namespace ramure
