/// \file
/// All tools, one row each. If several would take a press, the first one gets it; it also paints above those
/// after it.
#pragma once

#include "widgets/view/tools/tool.h"

namespace ramure {

using ToolMaker = std::unique_ptr<Tool> (*)(ToolContext& context);

std::unique_ptr<Tool> makeCubeTool(ToolContext& context);
std::unique_ptr<Tool> makeNavigationTool(ToolContext& context);
std::unique_ptr<Tool> makeMeasureTool(ToolContext& context);
std::unique_ptr<Tool> makeRestTool(ToolContext& context);
std::unique_ptr<Tool> makeCutTool(ToolContext& context);
std::unique_ptr<Tool> makeSawTool(ToolContext& context);
std::unique_ptr<Tool> makeRemoveTool(ToolContext& context);
std::unique_ptr<Tool> makeKeepTool(ToolContext& context);
/// Length, Thickness, Taper, Curl and Twist.
template <HandTool tool> std::unique_ptr<Tool> makeFactorTool(ToolContext& context);
/// Draw, Extend and Redraw.
template <HandTool tool> std::unique_ptr<Tool> makeDrawTool(ToolContext& context);
std::unique_ptr<Tool> makeGraftTool(ToolContext& context);
std::unique_ptr<Tool> makeMoveTool(ToolContext& context);
std::unique_ptr<Tool> makeRootTool(ToolContext& context);
std::unique_ptr<Tool> makeBrushTool(ToolContext& context);
std::unique_ptr<Tool> makePruneTool(ToolContext& context);
std::unique_ptr<Tool> makeLeavesTool(ToolContext& context);
std::unique_ptr<Tool> makePlaceTool(ToolContext& context);
std::unique_ptr<Tool> makeEditMarks(ToolContext& context);
std::unique_ptr<Tool> makeGizmoTool(ToolContext& context);
std::unique_ptr<Tool> makeTargetTool(ToolContext& context);
std::unique_ptr<Tool> makeJointTool(ToolContext& context);
std::unique_ptr<Tool> makeWindTool(ToolContext& context);
std::unique_ptr<Tool> makePullTool(ToolContext& context);
std::unique_ptr<Tool> makeBendTool(ToolContext& context);
std::unique_ptr<Tool> makeLimbTool(ToolContext& context);
std::unique_ptr<Tool> makeSelectTool(ToolContext& context);
std::unique_ptr<Tool> makeMenuTool(ToolContext& context);

// clang-format off
inline constexpr ToolMaker toolTable[] = {
    makeCubeTool,
    makeNavigationTool,
    makeMeasureTool,
    makeRestTool,
    makeCutTool,
    makeSawTool,
    makeRemoveTool,
    makeKeepTool,
    makeFactorTool<HandTool::Length>,
    makeFactorTool<HandTool::Thickness>,
    makeFactorTool<HandTool::Taper>,
    makeFactorTool<HandTool::Curl>,
    makeFactorTool<HandTool::Twist>,
    makeDrawTool<HandTool::Draw>,
    makeDrawTool<HandTool::Extend>,
    makeDrawTool<HandTool::Redraw>,
    makeGraftTool,
    makeMoveTool,
    makeRootTool,
    makeBrushTool,
    makePruneTool,
    makeLeavesTool,
    makePlaceTool,
    makeEditMarks,
    makeGizmoTool,
    makeTargetTool,
    makeJointTool,
    makeWindTool,
    makePullTool,
    makeBendTool,
    makeLimbTool,
    makeSelectTool,
    makeMenuTool,
};
// clang-format on

} // namespace ramure
