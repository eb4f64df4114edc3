#include "core/io/formats/glb/glb_levels.h"

#include "core/lod/level_switches.h"

namespace ramure::glb {

void tellFade(Json& node, const ExportMesh& mesh)
{
    if (!(mesh.share > 0.0))
        return;
    const double share = mesh.share, metres = mesh.distance;
    node["extras"]["fade"] = {
        {"screenHeight", Json::array({share * (1.0 + levelFade), share * (1.0 - levelFade)})},
        {"metres", Json::array({metres * (1.0 - levelFade), metres * (1.0 + levelFade)})}};
}

} // namespace ramure::glb
