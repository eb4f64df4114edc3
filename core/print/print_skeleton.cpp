#include "core/print/print_skeleton.h"

#include "core/base/number_text.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace ramure {
namespace {

/// What stands at the origin: the thickest root.
glm::dvec3 footOf(const Skeleton& tree)
{
    glm::dvec3 foot(0.0);
    double thickest = -1.0, ground = std::numeric_limits<double>::infinity();
    for (Index i = 0; i < tree.size(); ++i) {
        if (tree.parent[i] != noIndex)
            continue;
        ground = std::min(ground, tree.p0[i].y);
        if (tree.a0[i] > thickest) {
            thickest = tree.a0[i];
            foot = tree.p0[i];
        }
    }
    return {foot.x, ground, foot.z};
}

double topOf(const Skeleton& skeleton)
{
    double top = 0.0;
    for (Index i = 0; i < skeleton.size(); ++i)
        top = std::max({top, skeleton.p0[i].y, skeleton.p1[i].y});
    return top;
}

double thickestRoot(const Skeleton& tree)
{
    double thickest = 0.0;
    for (Index i = 0; i < tree.size(); ++i)
        if (tree.parent[i] == noIndex)
            thickest = std::max(thickest, tree.a0[i]);
    return thickest;
}

} // namespace

PrintSkeleton printSkeletonAt(const Skeleton& tree, double scale, double thinnest)
{
    PrintSkeleton out;
    out.scale = scale;
    const glm::dvec3 foot = out.foot = footOf(tree);
    out.numberOf.assign(tree.size(), noIndex);
    const double least = 0.5 * thinnest, end = least / mostThickening;
    std::vector<Index> numberOf(tree.size(), noIndex); // of those whose children may stay
    for (Index i = 0; i < tree.size(); ++i) {
        const Index parent = tree.parent[i];
        const double a0 = scale * tree.a0[i], a1 = scale * tree.a1[i];
        if ((parent != noIndex && numberOf[parent] == noIndex) || a0 < end) {
            ++out.cut;
            continue;
        }
        const glm::dvec3 from = scale * (tree.p0[i] - foot);
        glm::dvec3 to = scale * (tree.p1[i] - foot);
        const bool endsEarly = a1 < end;
        if (endsEarly) {
            to = from + (to - from) * ((a0 - end) / (a0 - a1));
            ++out.cut;
        } else if (std::min(a0, a1) < least) {
            ++out.thickened;
        }
        const Index added = out.skeleton.add(parent == noIndex ? noIndex : numberOf[parent], from, to,
                                             std::max(a0, least), std::max(a1, least), tree.level[i]);
        out.numberOf[i] = added;
        if (!endsEarly)
            numberOf[i] = added;
    }
    return out;
}

Expected<PrintSkeleton> printSkeleton(const Skeleton& tree, double height, double thinnest)
{
    const double foot = footOf(tree).y;
    const double rise = topOf(tree) - foot;
    if (!(rise > 0.0) || !std::isfinite(rise))
        return fail(ErrorCode::Invalid,
                    RAMURE_NOOP("a tree that does not rise above its foot has no height"));
    const double root = thickestRoot(tree);
    // Below it nothing is left, above it the print grows with the scale, in steps where twigs come in.
    const double least = root > 0.0 ? 0.5 * thinnest / mostThickening / root : 0.0;
    double low = std::max(height / rise, least * (1.0 + 1e-9)), high = low;
    const auto heightAt = [&](double scale) {
        return topOf(printSkeletonAt(tree, scale, thinnest).skeleton);
    };
    if (root <= 0.0 || heightAt(low) > height * (1.0 + 1e-9)) {
        const double needed = root > 0.0 ? heightAt(low) : 0.0;
        return fail(ErrorCode::Invalid,
                    RAMURE_NOOP("nothing of the tree would be thick enough: its trunk is %1 mm thick at this "
                                "height. Print it higher (%2 mm), or allow thinner twigs"),
                    {numberText(std::round(2e4 * root * height / rise) / 10.0),
                     numberText(std::ceil(1e3 * std::max(needed, least * rise)))});
    }
    constexpr int rounds = 40;
    for (int i = 0; i < rounds && heightAt(high) <= height; ++i) {
        low = high;
        high *= 1.25;
    }
    for (int i = 0; i < rounds && high - low > 1e-9 * high; ++i) {
        const double middle = 0.5 * (low + high);
        (heightAt(middle) <= height ? low : high) = middle;
    }
    return printSkeletonAt(tree, low, thinnest);
}

} // namespace ramure
