#include "widgets/view/render/passes/renderer_programs.h"

namespace ramure {

std::vector<std::pair<RendererPrograms::Program, ShaderSources>> RendererPrograms::table()
{
    const std::vector<const char*> mesh{"states.glsl", "skin.glsl",      "copy.glsl",
                                        "wind.glsl",   "skin_mesh.glsl", "mesh.vert"};
    const std::vector<const char*> depth{"skin.glsl", "copy.glsl", "wind.glsl", "skin_mesh.glsl",
                                         "shadow.vert"};
    const std::vector<const char*> surface{"colour.glsl",  "pixel.glsl",  "lighting.glsl",
                                           "texture.glsl", "shaded.glsl", "mesh.frag"};
    const std::vector<const char*> far{"states.glsl",    "skin.glsl",   "copy.glsl",   "wind.glsl",
                                       "skin_mesh.glsl", "colour.glsl", "corner.glsl", "lighting.glsl",
                                       "shaded.glsl",    "mesh.vert"};
    return {
        {&RendererPrograms::mesh, {mesh, nullptr, surface}},
        {&RendererPrograms::plain, {mesh, nullptr, surface, "#define BARK false\n#define VEINS false\n"}},
        {&RendererPrograms::bark, {mesh, nullptr, surface, "#define BARK true\n#define VEINS false\n"}},
        {&RendererPrograms::leaf, {mesh, nullptr, surface, "#define BARK false\n#define VEINS true\n"}},
        {&RendererPrograms::far, {far, nullptr, {"pixel.glsl", "far.frag"}, "#define FAR\n"}},
        {&RendererPrograms::crowd,
         {far, nullptr, {"pixel.glsl", "crowd.frag"}, "#define FAR\n#define CROWD\n"}},
        {&RendererPrograms::meshColours, {mesh, nullptr, surface, "#define COLOURS\n"}},
        {&RendererPrograms::meshWire, {mesh, "mesh.geom", surface, "#define COLOURS\n#define WIRE\n"}},
        {&RendererPrograms::shadow, {depth, nullptr, {"shadow.frag"}}},
        {&RendererPrograms::shadowCut, {depth, nullptr, {"shadow.frag"}, "#define CUT\n"}},
        {&RendererPrograms::world,
         {{"world.vert"}, nullptr, {"colour.glsl", "pixel.glsl", "lighting.glsl", "world.frag"}}},
        {&RendererPrograms::line, {{"states.glsl", "skin.glsl", "line.vert"}, nullptr, {"line.frag"}}},
        {&RendererPrograms::point, {{"states.glsl", "skin.glsl", "point.vert"}, nullptr, {"point.frag"}}},
        {&RendererPrograms::smooth, {{"world.vert"}, nullptr, {"smooth.frag"}}},
        {&RendererPrograms::shrink, {{"world.vert"}, nullptr, {"colour.glsl", "shrink.frag"}}},
        {&RendererPrograms::lensAdd, {{"world.vert"}, nullptr, {"colour.glsl", "lens_add.frag"}}},
        {&RendererPrograms::lensShow, {{"world.vert"}, nullptr, {"colour.glsl", "lens_show.frag"}}},
        {&RendererPrograms::ghost, {{"ghost.vert"}, nullptr, {"ghost.frag"}}},
        {&RendererPrograms::occlude, {{"world.vert"}, nullptr, {"occlusion.glsl", "occlusion.frag"}}},
        {&RendererPrograms::occludeBlur,
         {{"world.vert"}, nullptr, {"occlusion.glsl", "occlusion_blur.frag"}}},
        {&RendererPrograms::outlineRows,
         {{"world.vert"}, nullptr, {"outline_spread.frag"}, "#define ROWS\n"}},
        {&RendererPrograms::outlineColumns, {{"world.vert"}, nullptr, {"outline_spread.frag"}}},
        {&RendererPrograms::outlineClosing,
         {{"world.vert"}, nullptr, {"outline_spread.frag"}, "#define ROWS\n#define CLOSED\n"}},
        {&RendererPrograms::outlineInk, {{"world.vert"}, nullptr, {"outline_ink.frag"}}},
    };
}

Expected<void> RendererPrograms::compile(Gl& gl)
{
    for (const auto& [program, sources] : table()) {
        auto made = ShaderProgram::make(gl, sources);
        RAMURE_TRY(made);
        this->*program = std::move(*made);
    }
    return {};
}

} // namespace ramure
