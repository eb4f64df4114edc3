/// \file
/// Every shader program that a renderer uses; no other program is ever given to a driver.
#pragma once

#include "widgets/view/render/shader_program.h"
#include <memory>
#include <utility>
#include <vector>

namespace ramure {

struct RendererPrograms
{
    using Program = std::unique_ptr<ShaderProgram> RendererPrograms::*;
    static std::vector<std::pair<Program, ShaderSources>> table();
    /// Compiles all programs in the current context. Error: Unknown (shader), with the driver's words.
    Expected<void> compile(Gl& gl);

    std::unique_ptr<ShaderProgram> mesh, meshColours, meshWire;
    std::unique_ptr<ShaderProgram> plain, bark, leaf; ///< specialised versions of mesh
    std::unique_ptr<ShaderProgram> far;   ///< light at the corners only, for copies of a few pixels
    std::unique_ptr<ShaderProgram> crowd; ///< the same with a picture, for one of many trees
    std::unique_ptr<ShaderProgram> shadow, shadowCut, world, line, point, ghost;
    std::unique_ptr<ShaderProgram> smooth, shrink, lensAdd, lensShow;
    std::unique_ptr<ShaderProgram> occlude, occludeBlur;
    std::unique_ptr<ShaderProgram> outlineRows, outlineColumns, outlineClosing, outlineInk;
};

} // namespace ramure
