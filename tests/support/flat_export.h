/// \file
/// An export as formats without nodes write it.
#pragma once

#include "core/qt/session/export/exporter.h"

namespace ramure::test {

inline Expected<FlatScene> flatExport(EvaluatedScene scene, const ExportOptions& options)
{
    return collectExport(std::move(scene), options).map([](const ExportScene& all) {
        return flattened(all);
    });
}

} // namespace ramure::test
