/// \file
/// A tree's measures as info and list print them.
#pragma once

#include "core/presets/tree_measures.h"
#include <QJsonObject>

namespace ramure::cli {

/// m
inline QJsonObject jsonMeasures(const TreeMeasures& measures)
{
    return {{QStringLiteral("height"), measures.height},
            {QStringLiteral("stemDiameter"), measures.stemDiameter},
            {QStringLiteral("crownWidth"), measures.crownWidth}};
}

} // namespace ramure::cli
