/// \file
/// What the kinds of defects and repairs are called and what they mean, in plain words.
#pragma once

#include "core/surface/check/mesh_analysis.h"
#include "core/surface/check/self_intersections.h"
#include "core/surface/mesher/branch_mesh.h"
#include "core/surface/proof/validate.h"
#include "widgets/panels/validation/report_model.h"
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

KindText kindText(DefectKind kind);
KindText kindText(SkeletonRepair kind);
KindText kindText(PairKind kind);
KindText kindText(FindingKind kind);
/// As kindText; meshes without branches have one kind of crossing only.
KindText crossingText(PairKind kind, const MeshAnalysis& analysis);
/// What a mesh without defects is good for: free of crossings, and with some.
KindText cleanText();
KindText crossedText();
/// The same of an arm or an object, and of an open surface without any other defect.
KindText cleanSolidText();
KindText cleanSurfaceText();
/// As rich text for a label.
QString richText(const KindText& text);

} // namespace ramure
