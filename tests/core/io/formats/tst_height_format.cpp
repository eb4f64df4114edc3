#include "core/io/exr_file.h"
#include "core/io/formats/file_format.h"
#include "core/io/formats/text/blender_scene.h"
#include "core/io/picture_file.h"
#include "tests/support/suite.h"
#include <QFile>
#include <QTemporaryDir>

namespace tst_height_format {

using namespace ramure;

/// Pictures of heights as a ground.
class TestHeightFormat : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    std::string png(int width, int height, const std::vector<std::uint8_t>& fromBelow)
    {
        QFile file(m_folder.filePath("hill.png"));
        if (!file.open(QIODevice::WriteOnly))
            qFatal("no file");
        const std::string bytes = *pngOf({width, height, 1, false, fromBelow});
        file.write(bytes.data(), qint64(bytes.size()));
        return file.fileName().toStdString();
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void whatIsNoPictureIsRefused()
    {
        const std::string path = m_folder.filePath("text.png").toStdString();
        QFile file(QString::fromStdString(path));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("no picture") > 0);
        file.close();
        const auto refused = importObjects(path);
        QVERIFY(!refused && refused.error().file == path);
        QVERIFY(!findFormat("hill.png", FormatUse::Write)); // they are read alone
    }

    void aPixelIsAMetre()
    {
        const auto mesh = readMeshFile(png(4, 2, {0, 0, 0, 0, 255, 0, 0, 51}));
        QVERIFY2(mesh, test::why(mesh));
        const TriangleMesh& grid = mesh->objects.front().mesh;
        QCOMPARE(mesh->objects.front().name, std::string("hill"));
        QCOMPARE(grid.positions.size(), std::size_t(8));
        QCOMPARE(grid.faceCount(), 6u);
        QCOMPARE(grid.positions.front(), glm::vec3(-2.0F, 0.4F, -1.0F)); // the upper left is white: .1 of 4 m
        QCOMPARE(grid.positions[3], glm::vec3(2.0F, 0.08F, -1.0F));
        QCOMPARE(grid.positions.back(), glm::vec3(2.0F, 0.0F, 1.0F));
        for (const glm::uvec3& t : grid.triangles) {
            const glm::vec3 a = grid.positions[t.x], b = grid.positions[t.y], c = grid.positions[t.z];
            QVERIFY((b.z - a.z) * (c.x - a.x) - (b.x - a.x) * (c.z - a.z) > 0.0F); // seen from above
        }
    }

    void anExrIsInMetres()
    {
        const std::vector<glm::vec4> pixels{
            {-3.5F, 0, 0, 1}, {7.0F, 0, 0, 1}, {1.0F, 0, 0, 1}, {2.0F, 0, 0, 1}};
        const std::string path = m_folder.filePath("valley.exr").toStdString();
        QVERIFY(writeExr(path, 2, 2, pixels));
        const auto imported = importObjects(path);
        QVERIFY2(imported, test::why(imported));
        const Node& node = imported->nodes.front();
        QCOMPARE(node.kind, NodeKind::Mesh);
        QCOMPARE(node.mesh->positions[0].y, -3.5F);
        QCOMPARE(node.mesh->positions[1].y, 7.0F);
    }

    void largeOnesAreThinnedOut()
    {
        const auto mesh = readMeshFile(png(3000, 1, std::vector<std::uint8_t>(3000, 255)));
        QVERIFY2(mesh, test::why(mesh));
        QCOMPARE(mesh->objects.front().mesh.positions.size(), std::size_t(2048));
        QCOMPARE(mesh->notes.size(), std::size_t(1));
        QCOMPARE(mesh->objects.front().mesh.positions.back(), glm::vec3(1500.0F, 300.0F, 0.5F));
    }
};

RAMURE_SUITE(TestHeightFormat)

} // namespace tst_height_format

#include "tst_height_format.moc"
