#include "core/io/formats/text/blender_scene.h"
#include "core/scene/demo_scenes.h"
#include "core/scene/world_transforms.h"
#include "tests/support/suite.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

namespace tst_blender_scene {

using namespace ramure;

namespace {

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

bool notes(const std::vector<Note>& list, const char* part)
{
    return std::any_of(list.begin(), list.end(),
                       [part](const Note& note) { return note.message().find(part) != std::string::npos; });
}

void write(const QDir& folder, const char* name, const std::string& text)
{
    QFile file(folder.filePath(QLatin1String(name)));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(text));
}

double difference(const glm::dmat4& a, const glm::dmat4& b)
{
    double worst = 0.0;
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            worst = std::max(worst, std::abs(a[c][r] - b[c][r]));
    return worst;
}

} // namespace

class TestBlenderScene : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void badTransformsAreRefused_data()
    {
        QTest::addColumn<QByteArray>("transform");
        QTest::newRow("short") << QByteArray("TRANSFORM 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0\n");
        QTest::newRow("alone") << QByteArray("TRANSFORM");
        QTest::newRow("a word") << QByteArray("TRANSFORM 1 0 0 0 0 1 0 0 0 x 1 0 0 0 0 1\n");
        QTest::newRow("nan") << QByteArray("TRANSFORM 1 0 0 0 0 1 0 0 0 nan 1 0 0 0 0 1\n");
        QTest::newRow("a projection") << QByteArray("TRANSFORM 1 0 0 0 0 1 0 0 0 0 1 0 0 0 1 1\n");
        QTest::newRow("decimal commas") << QByteArray("TRANSFORM 1,0 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\n");
    }
    void badTransformsAreRefused()
    {
        QFETCH(QByteArray, transform);
        const auto object = parseBlenderObject(triangle + transform.toStdString(), "x.obj");
        QVERIFY(!object);
        QCOMPARE(object.error().line, 5);
        QCOMPARE(object.error().file, std::string("x.obj"));
    }
    void transformOnOneLineOrFour()
    {
        const auto one =
            parseBlenderObject(triangle + "\nTRANSFORM 1 0 0 5 0 0 -1 6 0 1 0 7 0 0 0 1", "x.obj");
        const auto four = parseBlenderObject(
            "TRANSFORM\r\n1 0 0 5\r\n0 0 -1 6\r\n0 1 0 7\r\n0 0 0 1\r\n" + triangle, "x.obj");
        const auto same = parseBlenderObject(
            triangle + "TRANSFORM 1 0 0 5\n0 0 -1 6\n0 1 0 7\n0 0 0 1\n# parent=Big one\n", "x.obj");
        QVERIFY2(one && four && same, test::why(four));
        for (const auto* object : {&*one, &*four, &*same}) {
            QVERIFY(object->transform);
            QVERIFY((*object->transform)[3] == glm::dvec4(5.0, 6.0, 7.0, 1.0));
            QVERIFY((*object->transform)[1] == glm::dvec4(0.0, 0.0, 1.0, 0.0));
            QCOMPARE(object->mesh.faceCount(), Index(1));
            QVERIFY(object->notes.empty());
        }
        QCOMPARE(same->parent, std::string("Big one"));
    }
    void aSecondTransformCounts()
    {
        const auto object = parseBlenderObject(
            triangle +
                "TRANSFORM 1 0 0 5 0 1 0 0 0 0 1 0 0 0 0 1\nTRANSFORM 1 0 0 9 0 1 0 0 0 0 1 0 0 0 0 1\n",
            "x.obj");
        QVERIFY2(object, test::why(object));
        QCOMPARE((*object->transform)[3].x, 9.0);
        QVERIFY(notes(object->notes, "twice"));
    }
    void whatRealFilesHold()
    {
        // Several objects and groups, polygons, negative indices, no normals, CRLF, comments.
        const auto object =
            parseBlenderObject("\xEF\xBB\xBF# made by hand\r\nmtllib a.mtl\r\no One\r\n"
                               "v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0.5 1.5 0\r\nv 0 1 0 # fifth\r\n"
                               "g left\r\nf -5 -4 -3 -2 -1\r\no Two\r\ng right\r\nv 0 0 1\r\n"
                               "vt 0 0\r\nusemtl red\r\ns off\r\nf 1/1 2/1 6/1\r\n\r\n"
                               "TRANSFORM 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\r\n",
                               "x.obj");
        QVERIFY2(object, test::why(object));
        QCOMPARE(object->mesh.faceCount(), Index(4));
        QCOMPARE(object->mesh.vertexCount(), Index(6));
    }
    void aFolderIsOneScene()
    {
        QTemporaryDir temporary;
        const QDir folder(temporary.path());
        write(folder, "My car.obj", triangle + "TRANSFORM 1 0 0 5 0 1 0 6 0 0 1 7 0 0 0 1\n");
        write(folder, "Wheel.001.obj",
              "# parent=My car\n" + triangle + "TRANSFORM 1 0 0 1 0 1 0 1 0 0 1 1 0 0 0 1\n");
        write(folder, "Wheel.001.animation",
              "0.5,LINEAR,1,2,3,0,0,0,1,1,1,1\n1,LINEAR,2,2,3,0,0,0,1,1,1,1\n");
        write(folder, "Camera.animation", "0,LINEAR,0,0,0,0,0,0,1,1,1,1\n");
        write(folder, "camera.001.animation", "0,LINEAR,0,0,0,0,0,0,1,1,1,1\n");
        write(folder, "Cam.animation", "0,LINEAR,0,0,0,0,0,0,1,1,1,1\n");
        write(folder, "notes.txt", "nothing");
        const auto made = importBlender(temporary.path().toStdString());
        QVERIFY2(made, test::why(made));
        const auto scene = Scene::fromNodes(made->nodes);
        QVERIFY2(scene, test::why(scene));
        QCOMPARE(scene->nodes().size(), std::size_t(6));
        QVERIFY(scene->nodes().front().kind == NodeKind::Group);
        QCOMPARE(made->keyCount, std::size_t(5));
        QCOMPARE(made->timeline.lastFrame, std::int64_t(24));
        QVERIFY(notes(made->notes, "Camera.animation"));
        for (const Node& node : scene->nodes()) {
            const glm::dvec3 at(worldTransformAt(*scene, node.id, 0.75).world[3]);
            if (node.name == "My car")
                QVERIFY(at == glm::dvec3(5.0, 6.0, 7.0));
            if (node.name == "Wheel.001") // its keys, not its TRANSFORM, below its parent
                QVERIFY(glm::length(at - glm::dvec3(6.5, 9.0, 5.0)) < 1e-12);
            if (node.name == "Camera" || node.name == "camera.001")
                QVERIFY(node.kind == NodeKind::Camera);
            if (node.name == "Cam")
                QVERIFY(node.kind == NodeKind::Group);
        }
        const auto alone =
            importBlender(folder.filePath(QStringLiteral("Wheel.001.animation")).toStdString());
        QVERIFY2(alone, test::why(alone));
        QCOMPARE(alone->nodes.size(), std::size_t(1));
        QVERIFY(alone->nodes.front().kind == NodeKind::Mesh);
        QVERIFY(notes(alone->notes, "My car")); // its parent is not there
    }
    void oneBadFileSpoilsAll()
    {
        QTemporaryDir temporary;
        const QDir folder(temporary.path());
        write(folder, "A.obj", triangle);
        write(folder, "B.obj", "v 0 0 0\nf 1 2 3\n");
        const auto made = importBlender(temporary.path().toStdString());
        QVERIFY(!made);
        QCOMPARE(made.error().line, 2);
        QVERIFY(QByteArray::fromStdString(made.error().file).endsWith("B.obj"));
        QVERIFY(!importBlender(folder.filePath(QStringLiteral("missing.obj")).toStdString()));
        QVERIFY(!importBlender(folder.filePath(QStringLiteral("notes.txt")).toStdString()));
        QTemporaryDir empty;
        QVERIFY(!importBlender(empty.path().toStdString()));
    }
    void parentsInACircleAreTold()
    {
        QTemporaryDir temporary;
        const QDir folder(temporary.path());
        write(folder, "A.obj", "# parent=B\n" + triangle);
        write(folder, "B.obj", "# parent=A\n" + triangle);
        write(folder, "C.obj", "# parent=C\n" + triangle);
        const auto made = importBlender(temporary.path().toStdString());
        QVERIFY2(made, test::why(made));
        QVERIFY(Scene::fromNodes(made->nodes));
        QVERIFY(notes(made->notes, "cannot be"));
        QVERIFY(notes(made->notes, "no TRANSFORM"));
    }
    void shearAndMirroringGoIntoTheVertices()
    {
        for (const char* matrix : {"1 0.5 0 2 0 1 0 0 0 0 1 0 0 0 0 1", "-1 0 0 2 0 1 0 0 0 0 1 0 0 0 0 1",
                                   "1 0 0 2 0 1 0 0 0 0 0 0 0 0 0 1"}) {
            QTemporaryDir temporary;
            write(QDir(temporary.path()), "A.obj", triangle + "TRANSFORM " + matrix + "\n");
            const auto made = importBlender(temporary.path().toStdString());
            QVERIFY2(made, test::why(made));
            QVERIFY(notes(made->notes, "vertices"));
            const Node& node = made->nodes.front();
            QVERIFY(node.params.tree == PlacementParams{});
            QVERIFY(node.mesh->positions[0] == glm::vec3(2.0f, 0.0f, 0.0f));
            const glm::vec3 across = glm::cross(node.mesh->positions[node.mesh->triangles[0].y] -
                                                    node.mesh->positions[node.mesh->triangles[0].x],
                                                node.mesh->positions[node.mesh->triangles[0].z] -
                                                    node.mesh->positions[node.mesh->triangles[0].x]);
            QVERIFY(across.z > 0.0f); // still seen from the same side
        }
    }
    void demosGoRound_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("cylinder") << QStringLiteral("MovingCylinder");
        QTest::newRow("tree") << QStringLiteral("MovingTree");
    }
    void demosGoRound()
    {
        QFETCH(QString, name);
        std::vector<Node> nodes = demoScene(name.toStdString())->nodes();
        std::erase_if(nodes, [](const Node& node) { // three levels of the tree are enough
            return std::count(node.name.begin(), node.name.end(), '.') > 1;
        });
        const Scene scene = *Scene::fromNodes(nodes);
        QTemporaryDir temporary;
        const auto written = exportBlender(scene, temporary.path().toStdString());
        QVERIFY2(written, test::why(written));
        const auto made = importBlender(temporary.path().toStdString());
        QVERIFY2(made, test::why(made));
        const auto back = Scene::fromNodes(made->nodes);
        QVERIFY2(back, test::why(back));
        std::map<std::string, NodeId> byName;
        for (const Node& node : back->nodes())
            byName[node.name] = node.id;
        for (const double t : {0.0, 1.0, 2.5, 4.25}) {
            const std::vector<NodeTransforms> was = worldTransformsAt(scene, t),
                                              is = worldTransformsAt(*back, t);
            std::map<NodeId, glm::dmat4> now;
            for (std::size_t i = 0; i < is.size(); ++i)
                now[back->nodes()[i].id] = is[i].world;
            double worst = 0.0;
            for (std::size_t i = 0; i < was.size(); ++i)
                worst = std::max(worst, difference(was[i].world, now.at(byName.at(scene.nodes()[i].name))));
            QVERIFY2(worst < 2e-3, qPrintable(QString::number(worst))); // slerp was sampled at frames
        }
    }
};

RAMURE_SUITE(TestBlenderScene)

} // namespace tst_blender_scene

#include "tst_blender_scene.moc"
