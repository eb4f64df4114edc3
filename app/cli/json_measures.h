/// \file
/// A tree's measures as info and list print them.
#pragma once

#include "core/presets/tree_measures.h"
#include "core/surface/foliage/leaf_measures.h"
#include <QJsonArray>
#include <QJsonObject>

namespace ramure::cli {

/// m
inline QJsonObject jsonMeasures(const TreeMeasures& measures)
{
    return {{QStringLiteral("height"), measures.height},
            {QStringLiteral("stemDiameter"), measures.stemDiameter},
            {QStringLiteral("crownWidth"), measures.crownWidth}};
}

/// Adds the sizes of leaves (m, m²) to those of their tree.
inline void insertLeaves(QJsonObject& tree, const LeafMeasures& leaves)
{
    tree.insert(QStringLiteral("leafLength"), leaves.length);
    tree.insert(QStringLiteral("leafReach"), leaves.reach);
    tree.insert(QStringLiteral("leafArea"), leaves.area);
    tree.insert(QStringLiteral("leafAreaIndex"), leaves.areaIndex);
}

/// [from, to]; null where nothing is published.
inline QJsonValue jsonRange(const PublishedRange& range)
{
    return range.to > 0.0 ? QJsonValue(QJsonArray{range.from, range.to}) : QJsonValue();
}

} // namespace ramure::cli
