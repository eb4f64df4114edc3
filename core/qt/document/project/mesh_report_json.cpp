#include "core/qt/document/project/mesh_report_json.h"

#include <QJsonArray>

namespace ramure {
namespace {

template <class List> QJsonArray arrayOf(const List& list)
{
    QJsonArray array;
    for (const auto& value : list)
        array.append(static_cast<double>(value));
    return array;
}

qint64 faceNumber(Index face)
{
    return face == noIndex ? -1 : qint64(face);
}

} // namespace

QJsonObject toJson(const MeshReport& r)
{
    return {{QStringLiteral("valid"), r.valid},
            {QStringLiteral("vertices"), qint64(r.vertices)},
            {QStringLiteral("faces"), qint64(r.faces)},
            {QStringLiteral("boundaryEdges"), qint64(r.boundaryEdges)},
            {QStringLiteral("nonManifoldEdges"), qint64(r.nonManifoldEdges)},
            {QStringLiteral("nonManifoldVertices"), qint64(r.nonManifoldVertices)},
            {QStringLiteral("inconsistentEdges"), qint64(r.inconsistentEdges)},
            {QStringLiteral("duplicateVertices"), qint64(r.duplicateVertices)},
            {QStringLiteral("duplicateFaces"), qint64(r.duplicateFaces)},
            {QStringLiteral("degenerateFaces"), qint64(r.degenerateFaces)},
            {QStringLiteral("isolatedVertices"), qint64(r.isolatedVertices)},
            {QStringLiteral("components"), qint64(r.components)},
            {QStringLiteral("eulerCharacteristic"), qint64(r.eulerCharacteristic)},
            {QStringLiteral("volume"), r.volume}};
}

QJsonObject toJson(const MeshQuality& q)
{
    return {{QStringLiteral("smallestAngle"), q.smallestAngleRad},
            {QStringLiteral("smallestAngleFace"), faceNumber(q.smallestAngleFace)},
            {QStringLiteral("largestAspect"), q.largestAspect},
            {QStringLiteral("largestAspectFace"), faceNumber(q.largestAspectFace)},
            {QStringLiteral("angleHistogram"), arrayOf(q.angles)},
            {QStringLiteral("aspectBins"), arrayOf(MeshQuality::aspectBins)},
            {QStringLiteral("aspectHistogram"), arrayOf(q.aspects)},
            {QStringLiteral("withoutArea"), qint64(q.withoutArea)}};
}

QJsonObject toJson(const SelfIntersections& crossings, const std::vector<Collision>& collisions)
{
    QJsonObject object{{QStringLiteral("total"), qint64(crossings.total())}};
    if (!crossings.kindsKnown)
        return object;
    const auto count = [&](PairKind kind) { return qint64(crossings.count(kind)); };
    object.insert(QStringLiteral("same"), count(PairKind::Same));
    object.insert(QStringLiteral("siblings"), count(PairKind::Siblings));
    object.insert(QStringLiteral("parentChild"), count(PairKind::ParentChild));
    object.insert(QStringLiteral("far"), count(PairKind::Far));
    QJsonArray list;
    for (const Collision& c : collisions)
        list.append(QJsonObject{{QStringLiteral("branches"), QJsonArray{qint64(c.first), qint64(c.second)}},
                                {QStringLiteral("depth"), c.depth},
                                {QStringLiteral("place"), QJsonArray{c.place.x, c.place.y, c.place.z}},
                                {QStringLiteral("triangles"), qint64(c.facePairs)}});
    object.insert(QStringLiteral("collisions"), list);
    return object;
}

QJsonObject toJson(const MeshReport& report, const MeshAnalysis& analysis, bool withCrossings)
{
    QJsonObject object = toJson(report);
    object.insert(QStringLiteral("hash"), QString::fromStdString(analysis.hash.text()));
    object.insert(QStringLiteral("nearVertices"), qint64(analysis.quality.nearPairs));
    object.insert(QStringLiteral("quality"), toJson(analysis.quality));
    if (withCrossings)
        object.insert(QStringLiteral("selfIntersections"), toJson(analysis.crossings, analysis.collisions));
    return object;
}

} // namespace ramure
