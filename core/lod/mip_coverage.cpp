#include "core/lod/mip_coverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>

namespace ramure {
namespace {

constexpr float cut = 0.5F;
/// Opacities are bytes in the end: a mean is at least so far from the cut.
constexpr float margin = 0.6F / 255.0F;

/// One version of the picture: the means, whether they are to be opaque, and how far they can be moved.
struct Mip
{
    int size = 0;
    std::vector<float> mean, low, high;
    std::vector<std::uint8_t> isOpaque;

    [[nodiscard]] std::array<std::size_t, 4> below(std::size_t at) const
    {
        const std::size_t side = std::size_t(size), x = 2 * (at % side), y = 2 * (at / side);
        const std::size_t first = 2 * side * y + x;
        return {first, first + 1, first + 2 * side, first + 2 * side + 1};
    }
};

Mip base(const std::vector<float>& alpha, int size)
{
    Mip out{size, alpha, {}, {}, {}};
    for (const float a : alpha) {
        const bool isOpaque = a >= cut;
        out.isOpaque.push_back(isOpaque ? 1 : 0);
        out.low.push_back(isOpaque ? cut + margin : 0.0F);
        out.high.push_back(isOpaque ? 1.0F : cut - margin);
    }
    return out;
}

/// As many are opaque as are of the picture, those with the most below them.
Mip halved(const Mip& fine, double share)
{
    Mip out;
    out.size = fine.size / 2;
    const auto count = std::size_t(out.size) * std::size_t(out.size);
    std::vector<float> weight(count);
    for (std::size_t i = 0; i < count; ++i) {
        float mean = 0.0F, low = 0.0F, high = 0.0F, opaque = 0.0F;
        for (const std::size_t at : out.below(i)) {
            mean += 0.25F * fine.mean[at];
            low += 0.25F * fine.low[at];
            high += 0.25F * fine.high[at];
            opaque += float(fine.isOpaque[at]);
        }
        out.mean.push_back(mean);
        out.low.push_back(low);
        out.high.push_back(high);
        weight[i] = opaque + 0.5F * mean; // the mean parts equals alone
    }
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return weight[a] > weight[b]; });
    const auto wanted = static_cast<std::size_t>(std::llround(share * double(count)));
    out.isOpaque.assign(count, 0);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = order[i];
        const bool isOpaque = (i < wanted || out.low[at] >= cut) && out.high[at] > cut + margin;
        out.isOpaque[at] = isOpaque ? 1 : 0;
        (isOpaque ? out.low : out.high)[at] =
            isOpaque ? std::max(out.low[at], cut + margin) : std::min(out.high[at], cut - margin);
    }
    return out;
}

/// The means below become such that theirs is that of the version above, each within its reach.
void handDown(const Mip& coarse, Mip& fine)
{
    for (std::size_t i = 0; i < coarse.mean.size(); ++i) {
        const auto below = coarse.below(i);
        float missing = 4.0F * coarse.mean[i], room = 0.0F;
        for (const std::size_t at : below) {
            fine.mean[at] = std::clamp(fine.mean[at], fine.low[at], std::max(fine.low[at], fine.high[at]));
            missing -= fine.mean[at];
        }
        const auto& bound = missing > 0.0F ? fine.high : fine.low;
        for (const std::size_t at : below)
            room += bound[at] - fine.mean[at];
        if (std::abs(room) < 1e-9F)
            continue;
        const float part = std::clamp(missing / room, 0.0F, 1.0F);
        for (const std::size_t at : below)
            fine.mean[at] += part * (bound[at] - fine.mean[at]);
    }
}

} // namespace

std::vector<double> opaqueShares(std::vector<float> alpha, int size, int count)
{
    std::vector<double> out;
    Mip mip;
    for (int side = size; count > 0 && side > 0; --count, side /= 2) {
        const auto opaque = std::ranges::count_if(alpha, [](float a) { return a >= cut; });
        out.push_back(double(opaque) / double(alpha.size()));
        mip.size = side / 2;
        std::vector<float> next(std::size_t(mip.size) * std::size_t(mip.size));
        for (std::size_t i = 0; i < next.size(); ++i)
            for (const std::size_t at : mip.below(i))
                next[i] += 0.25F * alpha[at];
        alpha = std::move(next);
    }
    return out;
}

void keepCoverage(std::vector<float>& alpha, int size)
{
    std::vector<Mip> mips{base(alpha, size)};
    const double share = opaqueShares(alpha, size, 1).front();
    for (int k = 0; k < keptMips && mips.back().size > 1; ++k)
        mips.push_back(halved(mips.back(), share));
    Mip& last = mips.back();
    for (std::size_t i = 0; i < last.mean.size(); ++i)
        last.mean[i] = std::clamp(last.mean[i], last.low[i], std::max(last.low[i], last.high[i]));
    for (std::size_t k = mips.size() - 1; k-- > 0;)
        handDown(mips[k + 1], mips[k]);
    alpha = std::move(mips.front().mean);
}

} // namespace ramure
