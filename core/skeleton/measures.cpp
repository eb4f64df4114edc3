#include "core/skeleton/measures.h"

#include "core/math/reproducible.h"
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
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

double hortonRatio(const Skeleton& skeleton)
{
    std::vector<int> order(skeleton.size()), most(skeleton.size(), 0), times(skeleton.size(), 0);
    for (Index i = skeleton.size(); i-- > 0;) {
        order[i] = most[i] == 0 ? 1 : most[i] + (times[i] > 1 ? 1 : 0);
        if (const Index parent = skeleton.parent[i]; parent != noIndex) {
            times[parent] = order[i] > most[parent] ? 1 : times[parent] + (order[i] == most[parent] ? 1 : 0);
            most[parent] = std::max(most[parent], order[i]);
        }
    }
    std::map<int, int> branches;
    for (Index i = 0; i < skeleton.size(); ++i)
        if (skeleton.parent[i] == noIndex || order[skeleton.parent[i]] != order[i])
            ++branches[order[i]];
    constexpr int handful = 5;
    while (branches.size() > 3 && branches.rbegin()->second < handful)
        branches.erase(std::prev(branches.end()));
    if (branches.size() < 3)
        return 0.0;
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (const auto& [k, count] : branches) {
        const double logarithm = maths::log(double(count));
        x += k;
        y += logarithm;
        xx += double(k) * k;
        xy += k * logarithm;
    }
    const auto n = double(branches.size());
    return maths::exp(-(n * xy - x * y) / (n * xx - x * x));
}

} // namespace ramure
