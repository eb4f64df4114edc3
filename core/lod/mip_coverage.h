/// \file
/// Opacities whose smaller versions, as every engine makes them (means of 2 × 2 pixels), show as large a
/// share of opaque pixels as the whole picture does: from afar nothing gets thin or solid. An engine needs no
/// other cutoff for it than a half.
#pragma once

#include <vector>

namespace ramure {

/// So many smaller versions keep their share.
inline constexpr int keptMips = 4;

/// The shares of pixels of a half or more: of the picture itself and of its versions at half the size, a
/// quarter and so on, as many as asked for. \param alpha 0..1, size * size, rows one after the other \pre the
/// size is a power of two
std::vector<double> opaqueShares(std::vector<float> alpha, int size, int count);

/// Moves opacities as little as keeps the shares of keptMips smaller versions: what was opaque stays opaque,
/// at least by a half, and what was not stays below. Which pixels of a smaller version are opaque: those with
/// the most opaque ones below them. \pre as above
void keepCoverage(std::vector<float>& alpha, int size);

} // namespace ramure
