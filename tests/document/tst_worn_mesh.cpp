#include "core/qt/document/commands.h"
#include "core/qt/document/project/project_file.h"
#include "core/rig/arm/arm_chain.h"
#include "core/scene/arm_demo.h"
#include "core/scene/world_transforms.h"
#include "tests/support/flat_export.h"
#include "tests/support/solids.h"
#include "tests/support/suite.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <cmath>

namespace tst_worn_mesh {

using namespace ramure;

namespace {

/// The demo with a box beside it: node 3, as high as the arm, with texture coordinates of its own.
Scene demoWithBox()
{
    Scene scene = armDemo();
    Node box;
    box.id = 3;
    box.kind = NodeKind::Mesh;
    box.name = "Glove";
    TriangleMesh mesh = test::box({-0.2F, 0.0F, -0.2F}, {0.2F, 4.4F, 0.2F}); // Y up
    mesh.uv = {{0, 0}, {1, 0}, {0, 1}};
    mesh.uvTriangles.assign(mesh.triangles.size(), {0, 1, 2});
    box.mesh = SharedValue<TriangleMesh>(std::move(mesh));
    return scene.insert({box}, noNode, 2) ? scene : Scene();
}

const Node& arm(const Document& document)
{
    return *document.scene().find(1);
}

QJsonObject withMesh(const Scene& scene, const QJsonObject& mesh)
{
    Project project;
    project.scene = scene;
    QJsonObject root = QJsonDocument::fromJson(writeProject(project)).object();
    QJsonArray nodes = root.value(QLatin1String("nodes")).toArray();
    QJsonObject node = nodes[0].toObject();
    node.insert(QStringLiteral("mesh"), mesh);
    nodes[0] = node;
    root.insert(QStringLiteral("nodes"), nodes);
    return root;
}

} // namespace

/// Arms that wear an imported mesh.
class TestWornMesh : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void whatCannotBeWornIsRefused()
    {
        Document document;
        document.reset(demoWithBox(), {});
        QVERIFY(!edit::wearMesh(document, 77, 3, true));
        QVERIFY(!edit::wearMesh(document, 1, 77, true));
        QVERIFY(!edit::wearMesh(document, 2, 3, true)); // a terrain is no arm
        QVERIFY(!edit::wearMesh(document, 1, 2, true)); // and no mesh
        QVERIFY(!edit::setArmMesh(document, 2, {}, QStringLiteral("x")));
        TriangleMesh empty;
        QCOMPARE(
            edit::setArmMesh(document, 1, SharedValue<TriangleMesh>(empty), QStringLiteral("x")).error().path,
            std::string("mesh"));
        QCOMPARE(document.undoStack()->count(), 0);
        Key flat;
        flat.value = 0.0;
        Scene scene = demoWithBox();
        scene.find(3)->animation.set({ChannelPart::GlobalScale, 1, 0},
                                     std::make_shared<const AnyTrack>(*Track::fromKeys({flat})));
        document.reset(scene, {});
        QVERIFY(!edit::wearMesh(document, 1, 3, true));
        QVERIFY(edit::setNodeLocked(document, {1}, true));
        QVERIFY(!edit::setArmMesh(document, 1, {}, QStringLiteral("x")));
    }

    void aMeshIsWornWhereItStands()
    {
        Document document;
        document.reset(demoWithBox(), {});
        const Scene before = document.scene();
        QVERIFY(edit::setParam(document, {1}, *findParam("tree.translation"), glm::dvec3(5.0, 0.0, 0.0)));
        QVERIFY(edit::setParam(document, {3}, *findParam("tree.translation"), glm::dvec3(5.0, 0.0, 0.0)));
        QVERIFY(edit::wearMesh(document, 1, 3, false));
        QVERIFY(arm(document).mesh);
        QVERIFY(!document.scene().find(3)->visible);
        // (x, y, z) of the world is (x, -z, y) of the arm: Z up.
        const TriangleMesh& worn = *arm(document).mesh;
        const TriangleMesh& box = *before.find(3)->mesh;
        for (Index v = 0; v < box.vertexCount(); ++v) {
            const glm::vec3& p = box.positions[v];
            QVERIFY(glm::distance(worn.positions[v], glm::vec3(p.x, -p.z, p.y)) < 1e-5F);
        }
        QCOMPARE(worn.uv, box.uv);
        // One step back, one forth.
        document.undo();
        QVERIFY(!arm(document).mesh && document.scene().find(3)->visible);
        document.redo();
        QVERIFY(arm(document).mesh && !document.scene().find(3)->visible);
        QVERIFY(edit::setArmMesh(document, 1, {}, QStringLiteral("cylinder")));
        QVERIFY(!arm(document).mesh);
        while (document.undoStack()->canUndo())
            document.undo();
        QCOMPARE(document.scene(), before);
    }

    void anyMeshCanBeFitted()
    {
        Document document;
        document.reset(demoWithBox(), {});
        QVERIFY(edit::setParam(document, {3}, *findParam("tree.scale"), glm::dvec3(0.1)));
        QVERIFY(edit::setParam(document, {3}, *findParam("tree.translation"), glm::dvec3(-7.0, 2.0, 1.0)));
        QVERIFY(edit::wearMesh(document, 1, 3, true));
        float top = 0.0F, foot = 1.0F;
        for (const glm::vec3& p : arm(document).mesh->positions) {
            top = std::max(top, p.z);
            foot = std::min(foot, p.z);
        }
        QVERIFY(std::abs(top - 4.4F) < 1e-5F && std::abs(foot) < 1e-5F);
    }

    void itIsSavedAndWritten()
    {
        Document document;
        document.reset(demoWithBox(), {});
        QVERIFY(edit::wearMesh(document, 1, 3, true));
        Project project;
        project.scene = document.scene();
        const auto read = readProject(writeProject(project), QStringLiteral("a.ramure"));
        QVERIFY(read);
        QCOMPARE(read->scene, document.scene());
        // The file holds it in the pose of the arm, with its texture coordinates.
        const auto noTrees = [](const Node&, Stage, const Progress&) -> Expected<TreeResult> {
            return fail(ErrorCode::Invalid, "no trees");
        };
        const auto set = test::flatExport(Evaluator(noTrees).at(document.scene()), {});
        QVERIFY(set);
        QCOMPARE(set->meshes.size(), std::size_t(2)); // the box itself is hidden
        QCOMPARE(set->meshes[0].name, std::string("Arm"));
        QCOMPARE(set->meshes[0].mesh->vertexCount(), Index(8));
        QCOMPARE(set->meshes[0].mesh->uv, arm(document).mesh->uv);
    }

    void brokenMeshesInFilesAreNamed()
    {
        const auto errorOf = [](const QJsonObject& mesh) {
            const auto read =
                readProject(QJsonDocument(withMesh(armDemo(), mesh)).toJson(), QStringLiteral("a.ramure"));
            return read ? std::string("read") : read.error().path;
        };
        QCOMPARE(errorOf({}), std::string("nodes[0].mesh"));
        QCOMPARE(errorOf({{QStringLiteral("positions"), 3}}), std::string("nodes[0].mesh.positions"));
        const QString row = QString::fromLatin1(QByteArray(36, '\0').toBase64()); // three at the origin
        const QString indices = QString::fromLatin1(QByteArray(12, '\0').toBase64());
        QJsonObject good{{QStringLiteral("positions"), row}, {QStringLiteral("indices"), indices}};
        QCOMPARE(errorOf(good), std::string("read"));
        QJsonObject bad = good;
        bad.insert(QStringLiteral("uv"), QStringLiteral("AAAA"));
        QCOMPARE(errorOf(bad), std::string("nodes[0].mesh.uv"));
        bad.insert(QStringLiteral("uv"), QString::fromLatin1(QByteArray(8, '\0').toBase64()));
        QCOMPARE(errorOf(bad), std::string("nodes[0].mesh.uv")); // one for three positions
        bad.insert(QStringLiteral("uvIndices"), QString::fromLatin1(QByteArray(24, '\0').toBase64()));
        QCOMPARE(errorOf(bad), std::string("nodes[0].mesh.uvIndices")); // two rows for one triangle
        bad.insert(QStringLiteral("uvIndices"), QString::fromLatin1(QByteArray(12, '\1').toBase64()));
        QCOMPARE(errorOf(bad), std::string("nodes[0].mesh.uvIndices")); // there are not that many
        bad.insert(QStringLiteral("uvIndices"), indices);
        QCOMPARE(errorOf(bad), std::string("read"));
        bad.insert(QStringLiteral("uv"), QString::fromLatin1(QByteArray(8, '\xFF').toBase64()));
        QCOMPARE(errorOf(bad), std::string("nodes[0].mesh.uv")); // not a number
    }
};

RAMURE_SUITE(TestWornMesh)

} // namespace tst_worn_mesh

#include "tst_worn_mesh.moc"
