#include "core/io/formats/text/blender_scene.h"
#include "tests/core/io/io_support.h"
#include "tests/support/suite.h"
#include <filesystem>
#include <fstream>

namespace tst_imported_texture {

using namespace ramure;

namespace {

/// Two triangles with a texture of their own corners and normals.
const char* const square = "o Square\n"
                           "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                           "vt 0 0\nvt 0.5 0\nvt 0.5 1\nvt 0 1\nvt 0.75 0.25\n"
                           "vn 0 0 1\n"
                           "f 1/1/1 2/2/1 3/3/1\nf 1/5/1 3/3/1 4/4/1\n";

/// The texture coordinate of each corner.
std::vector<glm::vec2> cornersOf(const TriangleMesh& mesh)
{
    std::vector<glm::vec2> corners;
    for (const glm::uvec3& t : mesh.uvTriangles.empty() ? mesh.triangles : mesh.uvTriangles)
        for (int c = 0; c < 3; ++c)
            corners.push_back(mesh.uv[t[c]]);
    return corners;
}

const std::vector<glm::vec2> meant{{0, 0}, {0.5, 0}, {0.5, 1}, {0.75, 0.25}, {0.5, 1}, {0, 1}};

} // namespace

/// Texture coordinates and normals of imported meshes.
class TestImportedTexture : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void cornersWithoutCoordinatesHaveNone()
    {
        const auto object = parseBlenderObject("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3\n", "a.obj");
        QVERIFY(object && object->mesh.uv.empty() && object->mesh.uvTriangles.empty());
        QVERIFY(object->mesh.normals.empty());
    }

    void coordinatesAndNormalsAreKept()
    {
        const auto object = parseBlenderObject(square, "a.obj");
        QVERIFY(object);
        QCOMPARE(cornersOf(object->mesh), meant);
        QCOMPARE(object->mesh.normals, std::vector<glm::vec3>(4, glm::vec3(0, 0, 1)));
    }

    void objectsOfOneFileAreJoinedWithTheirs()
    {
        const std::string both = std::string(square).append("o More\nf 1/1/1 3/3/1 4/5/1\n");
        const auto object = parseBlenderObject(both, "a.obj");
        QVERIFY(object);
        QCOMPARE(object->mesh.vertexCount(), Index(4)); // they share their vertices
        std::vector<glm::vec2> more = meant;
        more.insert(more.end(), {{0, 0}, {0.5, 1}, {0.75, 0.25}});
        QCOMPARE(cornersOf(object->mesh), more);
    }

    void theyGoRoundThroughAFolder()
    {
        const std::filesystem::path folder =
            std::filesystem::temp_directory_path() / "ramure_tst_imported_texture";
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder / "out");
        std::ofstream(folder / "Square.obj") << square << "TRANSFORM 1 0 0 2 0 1 0 3 0 0 1 4 0 0 0 1\n";
        const auto first = importBlender((folder / "Square.obj").string());
        QVERIFY(first);
        Scene scene = *Scene::fromNodes(first->nodes);
        QVERIFY(exportBlender(scene, (folder / "out").string()));
        const auto again = importBlender((folder / "out" / "Square.obj").string());
        QVERIFY(again);
        QCOMPARE(cornersOf(*again->nodes.front().mesh), meant);
        QCOMPARE(again->nodes.front().mesh->normals, first->nodes.front().mesh->normals);
        // A mirrored object turns its triangles round, and their coordinates with them.
        std::ofstream(folder / "Square.obj") << square << "TRANSFORM -1 0 0 0 0 1 0 0 0 0 1 0.5 0 0 0 1\n";
        const auto mirrored = importBlender((folder / "Square.obj").string());
        QVERIFY(mirrored);
        const TriangleMesh& mesh = *mirrored->nodes.front().mesh;
        const bool baked = mesh.positions[1].x < 0.0F;
        std::vector<glm::vec2> turned = meant;
        if (baked)
            for (std::size_t t = 0; t < 2; ++t)
                std::swap(turned[3 * t + 1], turned[3 * t + 2]);
        QCOMPARE(cornersOf(mesh), turned);
        std::filesystem::remove_all(folder);
    }
};

RAMURE_SUITE(TestImportedTexture)

} // namespace tst_imported_texture

#include "tst_imported_texture.moc"
