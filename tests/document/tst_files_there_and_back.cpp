#include "core/io/formats/text/blender_scene.h"
#include "core/qt/document/project/project_file.h"
#include "core/qt/session/export/exporter.h"
#include "core/surface/proof/validate.h"
#include "tests/support/flat_export.h"
#include "tests/support/suite.h"

#include <QFile>
#include <QTemporaryDir>
#include <glm/matrix.hpp>
#include <map>

namespace tst_files_there_and_back {

using namespace ramure;

namespace {

using ColourCounts = std::map<std::array<int, 3>, std::size_t>;

ColourCounts countsOf(const TriangleMesh& mesh)
{
    ColourCounts counts;
    for (const glm::u8vec3& c : mesh.colours)
        ++counts[{c.r, c.g, c.b}];
    return counts;
}

} // namespace

/// A tree that is exported and opened again.
class TestFilesThereAndBack : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;
    TreePipeline m_pipeline;
    Scene m_scene;

    [[nodiscard]] std::string path(const char* name) const
    {
        return m_folder.filePath(QString::fromLatin1(name)).toStdString();
    }
    static QByteArray bytesOf(const std::string& path)
    {
        QFile file(QString::fromStdString(path));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    Expected<void> write(const Scene& scene, const std::string& to, const ExportOptions& options = {})
    {
        return exportScene(Evaluator(pipelineSource(m_pipeline)).at(scene), options, to);
    }
    static Scene sceneOf(const BlenderImport& made) { return *Scene::fromNodes(made.nodes); }

private slots:
    void initTestCase()
    {
        Node node;
        node.id = 1;
        node.kind = NodeKind::Tree;
        node.name = "Oak";
        node.params.foliage.applesProbability = 0.3;
        m_scene = *Scene::fromNodes({node});
    }
    void init() { test::failOnAnyWarning(); }

    void wrongSpacesAreRefused()
    {
        QVERIFY(!upAxisNamed("x"));
        QCOMPARE(lengthUnitNamed("parsec").error().code, ErrorCode::Unknown);
        for (const double scale : {0.0, -1.0, 1e-9, 1e300, std::nan("")})
            QVERIFY(!fileScaleOf(scale));
        // What only looks like our comment is none.
        for (const char* head :
             {"", "# up z", "# up z, unit cm", "# up x, unit cm, scale 1", "up z, unit cm, scale 1",
              "# up z, unit cm, scale 0", "# up z, unit cm, scale 1x", "#\n"})
            QVERIFY2(!fileSpaceIn(head), head);
        QVERIFY(!fileSpaceOf(path("gone.obj")));
        QVERIFY(!fileSpaceOf(m_folder.path().toStdString()));
    }

    void coloursComeBack()
    {
        QVERIFY(write(m_scene, path("Oak.obj")));
        const auto made = importBlender(path("Oak.obj"));
        QVERIFY2(made, test::why(made));
        QVERIFY2(made->notes.empty(), made->notes.empty() ? "" : made->notes[0].message().c_str());
        QCOMPARE(made->nodes.size(), std::size_t(1));
        const auto set = test::flatExport(Evaluator(pipelineSource(m_pipeline)).at(m_scene), {});
        QVERIFY(set);
        ColourCounts meant;
        std::vector<glm::u8vec3> order;
        for (const MeshPart& part : set->parts()) {
            const glm::u8vec3 c = part.material.colour;
            meant[{c.r, c.g, c.b}] = part.mesh->triangles.size();
            order.insert(order.end(), part.mesh->triangles.size(), c);
        }
        QCOMPARE(meant.size(), std::size_t(3)); // bark, leaves, apples
        const TriangleMesh& mesh = *made->nodes[0].mesh;
        QVERIFY(countsOf(mesh) == meant);
        QVERIFY(mesh.colours == order);
        // The project keeps them, and so does the next file.
        const auto kept = readProject(writeProject({sceneOf(*made), {}}));
        QVERIFY2(kept, test::why(kept));
        QVERIFY(kept->scene.nodes()[0].mesh->colours == order);
        QVERIFY(write(kept->scene, path("again.obj")));
        const auto again = importBlender(path("again.obj"));
        QVERIFY2(again, test::why(again));
        QVERIFY(again->nodes[0].mesh->colours == order);
        QVERIFY(again->nodes[0].mesh->positions == mesh.positions);
    }

    void theNodesOwnColourTintsThem()
    {
        QVERIFY(write(m_scene, path("Oak.obj")));
        auto made = importBlender(path("Oak.obj"));
        QVERIFY2(made, test::why(made));
        made->nodes[0].params.surface.color = {1.0, 0.5, 0.0};
        const auto set = test::flatExport(Evaluator(pipelineSource(m_pipeline)).at(sceneOf(*made)), {});
        QVERIFY2(set, test::why(set));
        const glm::u8vec3 before = made->nodes[0].mesh->colours[0], after = set->meshes[0].mesh->colours[0];
        QCOMPARE(int(after.r), int(before.r));
        QVERIFY(std::abs(2 * int(after.g) - int(before.g)) <= 1);
        QCOMPARE(int(after.b), 0);
    }

    void ownSpaceSaysNothing()
    {
        ExportOptions options;
        QVERIFY(write(m_scene, path("plain.obj"), options));
        const QByteArray obj = bytesOf(path("plain.obj"));
        QVERIFY(!obj.left(200).contains("unit"));
        QVERIFY(FileSpace().matrix() == glm::dmat4(1.0));
    }

    void axesAndUnitComeBack_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"Oak.obj", "Oak.ply"})
            QTest::newRow(name) << name;
    }
    void axesAndUnitComeBack()
    {
        QFETCH(const QString, name);
        const std::string plain = path("plain-") + name.toStdString(),
                          turned = path("turned-") + name.toStdString();
        ExportOptions options;
        options.parts = exportBranches;
        options.texture = true;
        QVERIFY(write(m_scene, plain, options));
        options.space = {UpAxis::Z, *lengthUnitNamed("cm"), 2.0};
        QVERIFY(write(m_scene, turned, options));
        QVERIFY(bytesOf(turned).left(300).contains("up z, unit cm, scale 2\n"));
        QVERIFY(*fileSpaceOf(turned) == options.space);
        // As another program reads it: Z up, 200 times as large, still outward and closed.
        const std::string text = bytesOf(turned).replace("scale 2\n", "and so on\n").toStdString();
        const auto raw =
            name.endsWith(QLatin1String("obj")) ? parseObj(text, "x.obj") : parsePly(text, "x.ply");
        const auto own = readMeshFile(plain);
        QVERIFY2(raw && own, test::why(raw));
        const TriangleMesh seen = raw->joined(), meant = own->joined();
        QVERIFY(seen.triangles == meant.triangles);
        QVERIFY(seen.uv == meant.uv);
        for (std::size_t i = 0; i < seen.positions.size(); ++i) {
            const glm::vec3 p = meant.positions[i], n = meant.normals[i];
            QVERIFY(glm::length(seen.positions[i] - 200.0F * glm::vec3(p.x, -p.z, p.y)) < 1e-3F);
            QVERIFY(glm::length(seen.normals[i] - glm::vec3(n.x, -n.z, n.y)) < 1e-5F);
        }
        const auto report = validateMesh(seen);
        QVERIFY2(report, test::why(report));
        QVERIFY(report->valid && report->volume > 0.0);
        // The program turns it back by itself; whoever knows better may say so.
        const auto back = importBlender(turned);
        QVERIFY2(back, test::why(back));
        for (std::size_t i = 0; i < meant.positions.size(); ++i)
            QVERIFY(glm::length(back->nodes[0].mesh->positions[i] - meant.positions[i]) < 1e-5F);
        const auto forced = importBlender(turned, {CubicMeaning::Automatic, FileSpace()});
        QVERIFY2(forced, test::why(forced));
        QVERIFY(glm::length(forced->nodes[0].mesh->positions[7] - seen.positions[7]) < 1e-3F);
    }

    void keysHaveTheirOwnSpace()
    {
        QFile mesh(QString::fromStdString(path("Box.obj"))),
            keys(QString::fromStdString(path("Box.animation")));
        QVERIFY(mesh.open(QIODevice::WriteOnly) && mesh.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n") > 0);
        QVERIFY(keys.open(QIODevice::WriteOnly) && keys.write("0,LINEAR,0,0,0,0,0,0,1,1,1,1\n") > 0);
        mesh.close();
        keys.close();
        QVERIFY(importBlender(path("Box.obj")));
        const auto refused =
            importBlender(path("Box.obj"), {CubicMeaning::Automatic, FileSpace{UpAxis::Z, 0, 1.0}});
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::Invalid);
    }
};

RAMURE_SUITE(TestFilesThereAndBack)

} // namespace tst_files_there_and_back

#include "tst_files_there_and_back.moc"
