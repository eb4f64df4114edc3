#include "core/io/formats/file_format.h"
#include "core/io/formats/glb/glb_packed.h"
#include "core/math/random.h"
#include "core/surface/proof/validate.h"
#include "tests/core/io/io_support.h"
#include "tests/support/solids.h"
#include <QFileInfo>
#include <QTemporaryDir>
#include <QtEndian>
#include <algorithm>
#include <array>
#include <meshoptimizer.h>
#include <set>

namespace tst_glb_packed {

using namespace ramure;
using glb::Json;
using glb::Packed;

namespace {

const unsigned char* bytesOf(const std::string& text)
{
    return reinterpret_cast<const unsigned char*>(text.data());
}

/// As a reader of the extension has them.
template <class T> std::vector<T> unpacked(const Packed& from)
{
    if (sizeof(T) != from.stride)
        qFatal("another stride");
    std::vector<T> out(from.count);
    const int failed = std::string_view(from.mode) == "TRIANGLES"
                           ? meshopt_decodeIndexBuffer(out.data(), from.count, from.stride,
                                                       bytesOf(from.bytes), from.bytes.size())
                           : meshopt_decodeVertexBuffer(out.data(), from.count, from.stride,
                                                        bytesOf(from.bytes), from.bytes.size());
    if (failed != 0)
        qFatal("not of the extension");
    const std::string_view filter = from.filter;
    if (filter == "OCTAHEDRAL")
        meshopt_decodeFilterOct(out.data(), from.count, from.stride);
    else if (filter == "QUATERNION")
        meshopt_decodeFilterQuat(out.data(), from.count, from.stride);
    else if (filter == "EXPONENTIAL")
        meshopt_decodeFilterExp(out.data(), from.count, from.stride);
    return out;
}

/// Each from its lowest corner on, with what tells the corners apart.
std::multiset<std::array<float, 15>> trianglesOf(const glb::Vertices& vertices)
{
    std::multiset<std::array<float, 15>> all;
    for (std::size_t t = 0; t < vertices.indices.size(); t += 3) {
        std::array<std::array<float, 5>, 3> corners{};
        for (std::size_t k = 0; k < 3; ++k) {
            const Index i = vertices.indices[t + k];
            const glm::vec3& p = vertices.positions[i];
            corners[k] = {p.x, p.y, p.z, vertices.uv[i].x, vertices.uv[i].y};
        }
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        std::array<float, 15> flat{};
        for (std::size_t i = 0; i < 15; ++i)
            flat[i] = corners[i / 5][i % 5];
        all.insert(flat);
    }
    return all;
}

/// With the vertices that are one again.
MeshReport proofOf(const glb::Vertices& vertices)
{
    std::vector<Index> indices = vertices.indices;
    for (std::size_t i = 0; i < vertices.mergeIndices.size(); ++i)
        indices[vertices.mergeIndices[i]] = vertices.mergeValues[i];
    std::vector<Index> places(vertices.positions.size(), noIndex);
    TriangleMesh mesh;
    for (Index& index : indices) {
        if (places[index] == noIndex) {
            places[index] = Index(mesh.positions.size());
            mesh.positions.push_back(vertices.positions[index]);
        }
        index = places[index];
    }
    for (std::size_t i = 0; i < indices.size(); i += 3)
        mesh.triangles.emplace_back(indices[i], indices[i + 1], indices[i + 2]);
    return *validateMesh(mesh);
}

} // namespace

class TestGlbPacked : public QObject
{
    Q_OBJECT
private:
    Random m_random{5, RandomStream::Test};

    [[nodiscard]] glm::vec4 direction(float w)
    {
        const glm::vec3 any(m_random.range(-1, 1), m_random.range(-1, 1), m_random.range(-1, 1));
        return {glm::normalize(any + glm::vec3(1e-3F)), w};
    }

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(".?")); }

    void whatIsNotRoundedComesBack()
    {
        std::vector<glm::vec4> values(3000);
        for (glm::vec4& v : values)
            v = direction(float(m_random.range(-1e9, 1e9)));
        const std::string_view bytes(reinterpret_cast<const char*>(values.data()), values.size() * 16);
        QVERIFY(unpacked<glm::vec4>(glb::packed(bytes, 16)) == values);
    }

    void numbersAreRoundedAsTold()
    {
        for (const int bits : {12, 17}) {
            std::vector<glm::vec3> values(2000);
            for (glm::vec3& v : values)
                v = glm::vec3(direction(0.0F)) * float(m_random.range(0, 30));
            values[7] = glm::vec3(0.0F);
            std::vector<glm::vec3> rounded = values;
            const Packed packed = glb::packedFloats({&rounded[0].x, 3 * rounded.size()}, 3, bits);
            QVERIFY(unpacked<glm::vec3>(packed) == rounded);
            QVERIFY(packed.bytes.size() < values.size() * sizeof(glm::vec3));
            for (std::size_t i = 0; i < values.size(); ++i) {
                const glm::vec3 off = glm::abs(rounded[i] - values[i]), size = glm::abs(values[i]);
                const float largest = std::max({size.x, size.y, size.z});
                QVERIFY(std::max({off.x, off.y, off.z}) <= std::ldexp(largest, 1 - bits));
            }
        }
    }

    void directionsAreWithinADegree()
    {
        std::vector<glm::vec4> wanted(2000);
        for (glm::vec4& v : wanted)
            v = direction(m_random.range(0, 1) < 0.5 ? -1.0F : 1.0F);
        const auto bytes = unpacked<glm::i8vec4>(glb::packedDirections(wanted));
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            const glm::vec4 got = glm::vec4(bytes[i]) / 127.0F;
            QVERIFY(glm::dot(glm::normalize(glm::vec3(got)), glm::vec3(wanted[i])) > 0.9998F);
            QCOMPARE(got.w, wanted[i].w);
        }
    }

    void turnsTurnTheSame()
    {
        std::vector<glm::vec4> wanted(2000);
        for (glm::vec4& v : wanted)
            v = glm::normalize(direction(float(m_random.range(-1, 1))));
        const auto shorts = unpacked<glm::i16vec4>(glb::packedTurns(wanted));
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            const glm::vec4 got = glm::vec4(shorts[i]) / 32767.0F; // q and -q are one turn
            QVERIFY(std::abs(glm::dot(glm::normalize(got), wanted[i])) > 0.999999F);
        }
    }

    void trianglesStayAndStayClosed()
    {
        TriangleMesh mesh = test::torus(60, 24);
        for (const glm::uvec3& t : mesh.triangles) { // a seam round every triangle
            mesh.uvTriangles.emplace_back(Index(mesh.uv.size()), Index(mesh.uv.size() + 1),
                                          Index(mesh.uv.size() + 2));
            for (int k = 0; k < 3; ++k)
                mesh.uv.emplace_back(float(t[k] % 7), float(k));
        }
        glb::Vertices vertices = glb::verticesOf(mesh, true);
        QVERIFY(!vertices.mergeIndices.empty());
        const auto before = trianglesOf(vertices);
        const MeshReport proof = proofOf(vertices);
        QVERIFY(proof.valid);
        const Packed packed = glb::packedTriangles(vertices);
        QVERIFY(unpacked<Index>(packed) == vertices.indices);
        QVERIFY(trianglesOf(vertices) == before);
        const MeshReport after = proofOf(vertices);
        QVERIFY(after.valid);
        QCOMPARE(after.vertices, proof.vertices);
        QVERIFY(std::abs(after.volume - proof.volume) < 1e-9);
    }

    /// All views lie in the buffers that are told, and a reader that does not know the extension is told so.
    void aFileSaysWhatItNeeds()
    {
        const QTemporaryDir folder;
        const std::string path = folder.filePath("t.glb").toStdString();
        TriangleMesh mesh = test::torus(200, 60);
        mesh.normals.assign(mesh.positions.size(), {0, 1, 0});
        const ExportScene scene = sceneOfMeshes({{"thing", mesh, {}}}, barkMaterial());
        const FileFormat& format = **findFormat(path, FormatUse::Write);
        WriteOptions options;
        options.mapSize = 0;
        QVERIFY(format.write(path, scene, options, {}));
        const qint64 plain = QFileInfo(QString::fromStdString(path)).size();
        options.compressed = true;
        QVERIFY(format.write(path, scene, options, {}));
        const QByteArray bytes = test::fileBytes(QString::fromStdString(path));
        QVERIFY(bytes.size() * 3 < plain);
        const auto length = qFromLittleEndian<quint32>(bytes.constData() + 12);
        const Json json = Json::parse(bytes.mid(20, length).toStdString());
        const Json needed{"EXT_meshopt_compression", "KHR_mesh_quantization"};
        QVERIFY(json["extensionsRequired"] == needed);
        QVERIFY(json["buffers"][1]["extensions"]["EXT_meshopt_compression"]["fallback"].get<bool>());
        for (const Json& view : json["bufferViews"]) {
            const Json& inside = view["extensions"]["EXT_meshopt_compression"];
            QVERIFY(view["byteOffset"].get<int>() + view["byteLength"].get<int>() <=
                    json["buffers"][1]["byteLength"].get<int>());
            QVERIFY(inside["byteOffset"].get<int>() + inside["byteLength"].get<int>() <=
                    json["buffers"][0]["byteLength"].get<int>());
            QCOMPARE(view["byteLength"].get<int>(),
                     inside["count"].get<int>() * inside["byteStride"].get<int>());
        }
    }
};

RAMURE_SUITE(TestGlbPacked)

} // namespace tst_glb_packed

#include "tst_glb_packed.moc"
