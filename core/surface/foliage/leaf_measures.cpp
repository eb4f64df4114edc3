#include "core/surface/foliage/leaf_measures.h"

#include "core/math/angle.h"
#include "core/surface/foliage/leaf_shoot.h"
#include "core/surface/foliage/leaf_table.h"
#include <algorithm>

namespace ramure {

LeafMeasures leafMeasures(const Foliage& foliage, double alpha, double crownWidth)
{
    LeafMeasures out{.leaves = leafCount(foliage)};
    if (foliage.leaves.empty())
        return out;
    std::vector<float> sizes;
    double squares = 0.0;
    for (const FoliageItem& item : foliage.leaves) {
        sizes.push_back(item.size);
        squares += double(item.size) * double(item.size);
    }
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::ranges::nth_element(sizes, middle);
    const double unit = leafLength(foliage.form, alpha);
    out.length = *middle * unit;
    out.reach = out.length * (1.0 + leafRow(foliage.form.shape).petiole * foliage.form.petiole);
    out.area = squares * unit * unit * bladeArea(foliage.form);
    if (crownWidth > 0.0)
        out.areaIndex = out.area / (0.25 * pi * crownWidth * crownWidth);
    return out;
}

} // namespace ramure
