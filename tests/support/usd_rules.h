/// \file
/// What a USD layer of ours has to keep: the rules of usdchecker and of validators of assets, and some of our
/// own.
#pragma once

#include "core/io/formats/usd/usd_layer.h"
#include <QStringList>

namespace ramure::test {

struct UsdRules
{
    QStringList broken; ///< "rule: prim: what is wrong", at most 50
    int prims = 0;      ///< that were looked at, in all variants
    int meshes = 0, closed = 0, instancers = 0, skeletons = 0, skins = 0, materials = 0, variants = 0;
    int assemblies = 0; ///< of Unreal's Nanite
};

/// Looks at a layer, and at all of its variants one after the other. \param folder with the pictures beside
/// it; empty: they stand elsewhere
UsdRules usdRules(const usd::Layer& layer, const QString& folder = {});

} // namespace ramure::test
