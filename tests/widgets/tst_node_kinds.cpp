#include "core/evaluate/evaluator.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/qt/document/project/project_file.h"
#include "core/qt/document/project/project_json.h"
#include "core/qt/session/export/scene_counts.h"
#include "core/qt/session/jobs/recompute.h"
#include "core/scene/object_mesh.h"
#include "tests/support/flat_export.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/actions/edit_actions.h"
#include "widgets/base/action_set.h"
#include "widgets/base/texts/node_words.h"
#include "widgets/panels/scene/scene_model.h"
#include "widgets/view/render/scene_builder.h"
#include <QFile>
#include <QMenu>
#include <set>

namespace ramure {

extern const NodeKindRow treeKind, primitiveKind, meshKind, armKind, terrainKind, cameraKind, scatterKind,
    groupKind;

static constexpr auto fakeNodeKind = NodeKind(nodeKindCount);

static SharedMesh lookOfFake(const NodeParams& /*params*/, const SharedMesh& /*own*/)
{
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normals.assign(3, {0, 0, 1});
    mesh.triangles = {{0, 1, 2}};
    return std::make_shared<const TriangleMesh>(std::move(mesh));
}

static Expected<SharedMesh> solidOfFake(const NodeParams& params, const SharedMesh& own)
{
    return lookOfFake(params, own);
}

static const NodeKindRow fakeKind = {.kind = fakeNodeKind,
                                     .name = "fake",
                                     .icon = "cube",
                                     .word = "fake",
                                     .tip = "Fake: %1",
                                     .label = "Fake",
                                     .many = "Fakes",
                                     .addId = "edit.addFake",
                                     .addText = "&Fake",
                                     .look = &lookOfFake,
                                     .solid = &solidOfFake};

/// In the place of the program's own table: a row more.
std::span<const NodeKindRow* const> nodeKinds()
{
    static constexpr const NodeKindRow* table[] = {&treeKind,    &primitiveKind, &meshKind,
                                                   &armKind,     &terrainKind,   &cameraKind,
                                                   &scatterKind, &groupKind,     &fakeKind};
    return table;
}

} // namespace ramure

using namespace ramure;

/// A row of the table of kinds is saved, shown, drawn, counted, exported and added: nothing else is told of
/// it.
class TestNodeKinds : public QObject
{
    Q_OBJECT
private:
    static Node fakeNode()
    {
        Node node;
        node.id = 1;
        node.kind = fakeNodeKind;
        node.name = std::string("F"); // GCC 12 sees an overlap in the plain text
        return node;
    }

private slots:
    void init() { test::failOnWidgetWarning(); }

    void unknownNames() { QVERIFY(!findKind("") && !findKind("Tree") && !findKind("trees")); }
    void everyRowIsWhole()
    {
        std::set<std::string> names;
        std::set<NodeKind> kinds;
        for (const NodeKindRow* row : nodeKinds()) {
            QVERIFY2(names.insert(row->name).second && kinds.insert(row->kind).second, row->name);
            for (const char* text : {row->icon, row->word, row->tip})
                QVERIFY2(*text != '\0', row->name);
            QVERIFY2(QFile::exists(QStringLiteral(RAMURE_SOURCE_DIR "/resources/icons/%1.svg")
                                       .arg(QLatin1String(row->icon))),
                     row->name);
            QCOMPARE(*row->label != '\0', *row->addId != '\0');
            QCOMPARE(*row->many != '\0', row->solid != nullptr); // what has a shape is counted
            QVERIFY2(!row->look || row->solid, row->name);
            QCOMPARE(&kindRow(row->kind), row);
        }
        QCOMPARE(kinds.size(), std::size_t(nodeKindCount + 1));
    }
    void itIsSavedAndRead()
    {
        const Project project{*Scene::fromNodes({fakeNode()}), {}};
        const QByteArray text = writeProject(project);
        QVERIFY(text.contains("\"kind\": \"fake\""));
        const auto back = readProject(text, QStringLiteral("f.ramure"));
        QVERIFY(back && back->scene == project.scene);
    }
    void itHasItsShape()
    {
        const Scene scene = *Scene::fromNodes({fakeNode()});
        QVERIFY(isShape(fakeNodeKind) && isObject(fakeNodeKind));
        QCOMPARE((*objectSolid(scene.nodes()[0], {}))->faceCount(), 1u);
        SceneView view;
        const RenderScene drawn = SceneBuilder().build(
            scene, [](NodeId) { return nullptr; }, view);
        QCOMPARE(drawn.meshes.size(), std::size_t(1));
        QCOMPARE(drawn.meshes[0].mesh->faceCount(), 1u);
        TreePipeline pipeline;
        QCOMPARE(SceneCounter().count(scene, {}, pipelineSource(pipeline)).of(fakeNodeKind).faces,
                 std::uint64_t(1));
        QCOMPARE(test::flatExport(Evaluator(pipelineSource(pipeline)).at(scene), {})->meshes[0].name,
                 std::string("F"));
    }
    void itIsAddedAndSaidByItsWords()
    {
        Document document;
        document.reset(Scene(), {});
        test::FakeChooser chooser;
        ActionSet set;
        EditActions edits(&document, &chooser, &set, nullptr);
        QMenu menu;
        edits.fillMenu(&menu);
        QAction* add = set.find(QStringLiteral("edit.addFake"));
        QVERIFY(add && edits.addMenu()->actions().contains(add));
        add->trigger();
        QCOMPARE(document.scene().nodes().size(), std::size_t(1));
        const Node& node = document.scene().nodes()[0];
        QCOMPARE(node.kind, fakeNodeKind);
        QCOMPARE(node.name, std::string("Fake"));
        QCOMPARE(nodeWords(document.scene(), {node.id}), QStringLiteral("fake"));
        SceneModel model(&document);
        const QModelIndex row = model.index(0, SceneModel::NameColumn);
        QCOMPARE(row.data(Qt::ToolTipRole).toString(), QStringLiteral("Fake: Fake"));
    }
};

QTEST_MAIN(TestNodeKinds)
#include "tst_node_kinds.moc"
