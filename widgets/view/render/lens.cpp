#include "widgets/view/render/lens.h"

#include <cmath>

namespace ramure {

Camera throughLens(const Camera& camera, const Lens& lens, QSize size, int sample, int count)
{
    const double focus = lens.focus > 0.0 ? lens.focus : camera.distance;
    const double share = (sample + 0.5) / count, turn = 2.399963229728653 * sample;
    const glm::dvec2 off =
        0.5 * lens.diameter * std::sqrt(share) * glm::dvec2(std::cos(turn), std::sin(turn));
    const double half = focus * std::tan(0.5 * camera.fovRad);
    const double aspect = double(size.width()) / size.height();
    const glm::dvec2 beside(share - 0.5, std::fmod(0.618033988749895 * sample, 1.0) - 0.5);
    Camera moved = camera;
    moved.target += off.x * camera.right() + off.y * camera.up();
    moved.shift +=
        off / glm::dvec2(half * aspect, half) + 2.0 * beside / glm::dvec2(size.width(), size.height());
    return moved;
}

} // namespace ramure
