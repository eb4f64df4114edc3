/// \file
/// Computes a whole scene at one time as far as needed, and builds its picture's contents.
#pragma once

#include "widgets/view/render/scene_builder.h"

namespace ramure {

/// Hidden trees are not computed. Errors: those of EvaluatedScene::poseArms and of the trees, including
/// Cancelled.
Expected<RenderScene> renderSceneAt(EvaluatedScene& now, const SceneView& view,
                                    const Progress& progress = {});

} // namespace ramure
