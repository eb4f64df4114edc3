#include "core/qt/document/project/project_mesh.h"

#include "core/math/finite.h"
#include "core/qt/document/project/project_json.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace ramure::json {

static_assert(std::endian::native == std::endian::little, "the numbers in files are little-endian");

template <class T> static QString toText(const std::vector<T>& rows)
{
    const QByteArray bytes = QByteArray::fromRawData(reinterpret_cast<const char*>(rows.data()),
                                                     static_cast<qsizetype>(rows.size() * sizeof(T)));
    return QString::fromLatin1(bytes.toBase64());
}

template <class T> static Expected<std::vector<T>> fromText(QJsonObject& object, const char* key)
{
    static_assert(sizeof(T) == 12 || sizeof(T) == 8 || sizeof(T) == 3,
                  "two or three numbers of 32 bits, or three bytes");
    const QJsonValue value = object.take(QLatin1String(key));
    std::vector<T> rows;
    if (value.isUndefined())
        return rows;
    const auto decoded =
        QByteArray::fromBase64Encoding(value.toString().toLatin1(), QByteArray::AbortOnBase64DecodingErrors);
    const QByteArray bytes = decoded ? *decoded : QByteArray();
    if (!value.isString() || !decoded || bytes.size() % qsizetype(sizeof(T)) != 0)
        return failAt(
            key, ErrorCode::Invalid,
            sizeof(T) == 12  ? RAMURE_NOOP("base64 of rows of three numbers of 32 bits is expected here")
            : sizeof(T) == 3 ? RAMURE_NOOP("base64 of rows of three bytes is expected here")
                             : RAMURE_NOOP("base64 of rows of two numbers of 32 bits is expected here"));
    rows.resize(static_cast<std::size_t>(bytes.size()) / sizeof(T));
    if (!rows.empty())
        std::memcpy(rows.data(), bytes.constData(), static_cast<std::size_t>(bytes.size()));
    return rows;
}

static Expected<void> checkTexture(const TriangleMesh& mesh)
{
    if (!std::all_of(mesh.uv.begin(), mesh.uv.end(), &isFinite<2, float>))
        return failAt("uv", ErrorCode::Invalid, RAMURE_NOOP("must be finite numbers"));
    if (mesh.uvTriangles.empty()) {
        if (!mesh.uv.empty() && mesh.uv.size() != mesh.positions.size())
            return failAt("uv", ErrorCode::Invalid, RAMURE_NOOP("there must be one for each position"));
        return {};
    }
    if (mesh.uvTriangles.size() != mesh.triangles.size())
        return failAt("uvIndices", ErrorCode::Invalid, RAMURE_NOOP("there must be three for each triangle"));
    const auto count = static_cast<Index>(mesh.uv.size());
    for (const glm::uvec3& t : mesh.uvTriangles)
        if (t.x >= count || t.y >= count || t.z >= count)
            return failAt("uvIndices", ErrorCode::Invalid, RAMURE_NOOP("there is no texture coordinate %1"),
                          {std::to_string(std::max({t.x, t.y, t.z}))});
    return {};
}

static Expected<void> checkMesh(const TriangleMesh& mesh)
{
    if (!std::all_of(mesh.positions.begin(), mesh.positions.end(), &isFinite<3, float>))
        return failAt("positions", ErrorCode::Invalid, RAMURE_NOOP("must be finite numbers"));
    if (!std::all_of(mesh.normals.begin(), mesh.normals.end(), &isFinite<3, float>))
        return failAt("normals", ErrorCode::Invalid, RAMURE_NOOP("must be finite numbers"));
    if (!mesh.normals.empty() && mesh.normals.size() != mesh.positions.size())
        return failAt("normals", ErrorCode::Invalid, RAMURE_NOOP("there must be one for each position"));
    const Index count = mesh.vertexCount();
    for (const glm::uvec3& t : mesh.triangles)
        if (t.x >= count || t.y >= count || t.z >= count)
            return failAt("indices", ErrorCode::Invalid, RAMURE_NOOP("there is no vertex %1"),
                          {std::to_string(std::max({t.x, t.y, t.z}))});
    if (!mesh.colours.empty() && mesh.colours.size() != mesh.triangles.size())
        return failAt("colours", ErrorCode::Invalid, RAMURE_NOOP("there must be three for each triangle"));
    return checkTexture(mesh);
}

QJsonObject writeMesh(const TriangleMesh& mesh)
{
    QJsonObject object{{QStringLiteral("positions"), toText(mesh.positions)},
                       {QStringLiteral("indices"), toText(mesh.triangles)}};
    if (!mesh.normals.empty())
        object.insert(QStringLiteral("normals"), toText(mesh.normals));
    if (!mesh.uv.empty())
        object.insert(QStringLiteral("uv"), toText(mesh.uv));
    if (!mesh.uvTriangles.empty())
        object.insert(QStringLiteral("uvIndices"), toText(mesh.uvTriangles));
    if (!mesh.colours.empty())
        object.insert(QStringLiteral("colours"), toText(mesh.colours));
    return object;
}

Expected<TriangleMesh> readMesh(QJsonObject& object)
{
    TriangleMesh mesh;
    auto positions = fromText<glm::vec3>(object, "positions");
    auto normals = fromText<glm::vec3>(object, "normals");
    auto triangles = fromText<glm::uvec3>(object, "indices");
    auto uv = fromText<glm::vec2>(object, "uv");
    auto uvTriangles = fromText<glm::uvec3>(object, "uvIndices");
    auto colours = fromText<glm::u8vec3>(object, "colours");
    RAMURE_TRY(positions);
    RAMURE_TRY(normals);
    RAMURE_TRY(triangles);
    RAMURE_TRY(uv);
    RAMURE_TRY(uvTriangles);
    RAMURE_TRY(colours);
    mesh.positions = std::move(*positions);
    mesh.normals = std::move(*normals);
    mesh.triangles = std::move(*triangles);
    mesh.uv = std::move(*uv);
    mesh.uvTriangles = std::move(*uvTriangles);
    mesh.colours = std::move(*colours);
    RAMURE_TRY(checkMesh(mesh));
    return mesh;
}

} // namespace ramure::json
