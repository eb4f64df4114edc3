/// \file
/// What is not clean about the meshes that an export would write.
#pragma once

#include "core/qt/session/export/export_options.h"
#include "core/qt/session/jobs/analysis.h"
#include "core/surface/check/verdict.h"
#include <QString>

namespace ramure {

/// The faults of all trees with the worst verdict.
struct MeshFaults
{
    NodeId tree = noNode; ///< the first of them
    MeshVerdict verdict = MeshVerdict::Clean;
    /// Collisions are the tree's doing, and told; only a broken mesh is not written without a question.
    [[nodiscard]] bool mustAsk() const { return verdict == MeshVerdict::Broken; }
    [[nodiscard]] bool isEmpty() const { return text.isEmpty(); }

    QString text; ///< "The mesh of “Oak” is broken: 3 defects.", of several their number and the
                  ///< sum; empty: nothing to tell
};

/// Returns the faults of the trees that \p options choose; nothing if no continuous branch mesh is written.
/// \param analysis may be null: then nothing is known of crossings.
MeshFaults meshFaults(const Document& document, const Analysis* analysis, const ExportOptions& options);

} // namespace ramure
