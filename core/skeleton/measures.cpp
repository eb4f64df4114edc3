#include "core/skeleton/measures.h"

#include "core/math/reproducible.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace ramure {
namespace {

constexpr double breastHeight = 1.3;
constexpr int directions = 12;

/// Of several stems the root of the sum of squares, as such trees are measured.
double stemDiameter(const Skeleton& tree)
{
    double squares = 0.0;
    for (Index i = 0; i < tree.size(); ++i) {
        const double from = tree.p0[i].y, to = tree.p1[i].y;
        if (tree.level[i] > 0 || from > breastHeight || to <= breastHeight)
            continue;
        const double share = (breastHeight - from) / (to - from);
        const double radius = tree.a0[i] + (tree.a1[i] - tree.a0[i]) * share;
        squares += radius * radius;
    }
    return 2.0 * std::sqrt(squares);
}

double crownWidth(const Skeleton& tree)
{
    double sum = 0.0;
    for (int i = 0; i < directions; ++i) {
        const double angle = std::numbers::pi * i / directions;
        const double x = maths::cos(angle), z = maths::sin(angle);
        double least = 0.0, most = 0.0;
        for (const glm::dvec3& p : tree.p1) {
            const double at = p.x * x + p.z * z;
            least = std::min(least, at);
            most = std::max(most, at);
        }
        sum += most - least;
    }
    return sum / directions;
}

} // namespace

TreeMeasures measuresOf(const Skeleton& skeleton)
{
    TreeMeasures measures{0.0, stemDiameter(skeleton), crownWidth(skeleton)};
    for (const glm::dvec3& p : skeleton.p1)
        measures.height = std::max(measures.height, p.y);
    return measures;
}

} // namespace ramure
