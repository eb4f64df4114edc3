/// \file
/// What the kinds of defects and repairs are called and what they mean, in plain words.
#pragma once

#include "core/surface/check/mesh_analysis.h"
#include "core/surface/check/self_intersections.h"
#include "core/surface/mesher/branch_mesh.h"
#include "core/surface/proof/validate.h"
#include "widgets/panels/validation/report_model.h"
#include <QCoreApplication>
#include <QString>

namespace ramure {

inline constexpr int repairKindCount = 6;

struct KindText
{
    QString name;    ///< plural: "Boundary edges"
    QString meaning; ///< what it is
    QString print;   ///< what it does to a print; empty for repairs
    QString game;    ///< what it does in a game or a renderer; empty for repairs
};

class KindTexts
{
    Q_DECLARE_TR_FUNCTIONS(KindTexts)
public:
    static KindText of(DefectKind kind);
    static KindText of(SkeletonRepair kind);
    static KindText of(PairKind kind);
    static KindText of(FindingKind kind);
    /// Meshes without branches have one kind of crossing only.
    static KindText ofCrossing(PairKind kind, const MeshAnalysis& analysis);
    /// What a mesh without defects is good for: free of crossings, and with some.
    static KindText clean();
    static KindText crossed();
    /// The same of an arm or an object, and of an open surface without any other defect.
    static KindText cleanSolid();
    static KindText cleanSurface();
    /// As rich text for a label.
    static QString rich(const KindText& text);

private:
    static KindText edges(DefectKind kind);
    static KindText vertices(DefectKind kind);
    static KindText faces(DefectKind kind);
};

} // namespace ramure
