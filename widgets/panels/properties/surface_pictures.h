/// \file
/// Small pictures of what a surface is made of, for the eye that chooses it: a leaf from above, a fruit on
/// its stalk, a ball and a tile of bark.
#pragma once

#include "core/base/progress.h"
#include "core/params/fruit_params.h"
#include "core/params/leaf_params.h"
#include "core/scene/material.h"
#include <QImage>

namespace ramure {

/// One leaf, its tip upwards, as large as fits into a square of \p size pixels a side; transparent around it.
/// \param turns in the colour of autumn. \param pictures in the place of what the leaf has.
QImage leafPicture(const LeafParams& leaf, bool turns, int size, const PictureParams& pictures = {});
/// One fruit or flower from the side, its stalk upwards, likewise. Its size on the tree is not seen.
QImage fruitPicture(const FruitParams& fruit, int size, const PictureParams& pictures = {});
/// A ball of one tile of a bark or another surface, lit from the upper left, and beside it the tile: 2 * \p
/// size pixels wide. Null where it was cancelled.
QImage barkPicture(const Material& material, int size, const Progress& progress = {});

} // namespace ramure
