#include "core/surface/check/verdict.h"

namespace ramure {
namespace {

/// OpenMesh's opinion is part of `valid` where the number of pieces is free.
bool hasPieces(const MeshReport& report, Index pieces)
{
    return report.components == pieces && report.eulerCharacteristic == 2 * std::int64_t(pieces) &&
           (!report.openMeshChecked || report.openMeshAgrees);
}

} // namespace

MeshVerdict verdictOn(const MeshReport& report, const SelfIntersections* crossings, Index pieces)
{
    if (!report.valid || (pieces > 0 && !hasPieces(report, pieces)))
        return MeshVerdict::Broken;
    if (!crossings)
        return MeshVerdict::Closed;
    return crossings->total() > 0 ? MeshVerdict::Crossing : MeshVerdict::Clean;
}

const char* verdictName(MeshVerdict verdict)
{
    switch (verdict) {
    case MeshVerdict::Clean:
        return "clean";
    case MeshVerdict::Closed:
        return "closed";
    case MeshVerdict::Crossing:
        return "crossing";
    case MeshVerdict::Broken:
        break;
    }
    return "broken";
}

} // namespace ramure
