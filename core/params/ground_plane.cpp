#include "core/params/ground_plane.h"

#include "core/math/reproducible.h"
#include "core/params/node_params.h"
#include "core/params/steep_ground.h"

namespace ramure {

std::optional<GroundPlane> groundOf(const NodeParams& params)
{
    if (auto ground = params.ground.nearby())
        return ground;
    const GrowthParams& growth = params.growth;
    if (params.generator.kind != EditOperation::Growth || !(growth.slope > 0.0))
        return std::nullopt;
    const auto [sine, cosine] = maths::sincos(growth.slopeDirection);
    const double falls = maths::tan(growth.slope);
    return eased({0.0, {-falls * cosine, falls * sine}});
}

} // namespace ramure
