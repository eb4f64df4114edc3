/// \file
/// What is not clean about the meshes that an export would write.
#pragma once

#include "core/document/analysis.h"
#include "core/document/exporter.h"
#include <QStringList>

namespace ramure {

/// The first tree with something to tell.
struct MeshFaults
{
    NodeId tree = noNode;
    QString name;       ///< of the tree
    QStringList faults; ///< of the mesh: defects, crossings at forks
    QStringList notes;  ///< no fault of the mesh: branches that collide

    [[nodiscard]] bool isEmpty() const { return faults.isEmpty() && notes.isEmpty(); }
    /// "The mesh of “Oak” is not clean: 3 defects, 2 pairs of branches collide."
    [[nodiscard]] QString text() const;
};

/// Of the trees that \p options choose; nothing where no continuous branch mesh is written. Trees with faults
/// come before those with notes only. \param analysis may be null.
MeshFaults meshFaults(const Document& document, const Analysis* analysis, const ExportOptions& options);

} // namespace ramure
