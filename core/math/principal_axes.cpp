#include "core/math/principal_axes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace ramure {
namespace {

/// One turn about the axis that is neither p nor q, after which a[p][q] is 0.
void turn(glm::dmat3& a, glm::dmat3& axes, int p, int q)
{
    if (a[p][q] == 0.0)
        return;
    const double half = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
    const double t = (half < 0.0 ? -1.0 : 1.0) / (std::abs(half) + std::sqrt(half * half + 1.0));
    const double c = 1.0 / std::sqrt(t * t + 1.0), s = t * c;
    glm::dmat3 by(1.0);
    by[p][p] = by[q][q] = c;
    by[q][p] = s;
    by[p][q] = -s;
    a = glm::transpose(by) * a * by;
    a[p][q] = a[q][p] = 0.0;
    axes = axes * by;
}

} // namespace

glm::dmat3 principalAxes(const glm::dmat3& spread)
{
    constexpr int sweeps = 6; // C. G. J. Jacobi: each squares what is left beside the diagonal
    glm::dmat3 a = spread, axes(1.0);
    for (int i = 0; i < sweeps; ++i) {
        turn(a, axes, 0, 1);
        turn(a, axes, 0, 2);
        turn(a, axes, 1, 2);
    }
    int order[] = {0, 1, 2};
    std::ranges::stable_sort(order, [&](int p, int q) { return a[p][p] > a[q][q]; });
    const glm::dvec3 longest = axes[order[0]], second = axes[order[1]];
    return {longest, second, glm::cross(longest, second)};
}

} // namespace ramure
