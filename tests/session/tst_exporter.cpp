#include "core/presets/presets.h"
#include "core/qt/document/commands.h"
#include "core/qt/session/export/document_source.h"
#include "core/qt/session/export/exporter.h"
#include "core/surface/foliage/place_foliage.h"
#include "core/surface/mesh/transformed.h"
#include "core/surface/mesher/rough_model.h"
#include "tests/support/flat_export.h"
#include "tests/support/suite.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <glm/gtc/matrix_transform.hpp>

namespace tst_exporter {

using namespace ramure;

static Node makeTree(NodeId id, NodeId parent = noNode)
{
    Node node;
    node.id = id;
    node.parent = parent;
    node.kind = NodeKind::Tree;
    node.name = QStringLiteral("n%1").arg(id).toStdString();
    node.params = *presetParams("SmallTree");
    node.params.grammar.iterations = 4;
    node.params.foliage.leavesCutoff = 0.6;
    node.params.foliage.applesProbability = 0.3;
    return node;
}
static Scene oneTree(const PlacementParams& place = {})
{
    Node node = makeTree(1);
    node.params.tree = place;
    return *Scene::fromNodes({node});
}
static std::vector<std::string> namesOf(const FlatScene& set)
{
    std::vector<std::string> names;
    for (const MeshPart& part : set.parts())
        names.push_back(part.name);
    return names;
}
using Names = std::vector<std::string>;

static double volumeOf(const TriangleMesh& mesh)
{
    const auto report = validateMesh(mesh);
    return report ? report->volume : 0.0;
}

class TestExporter : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void wrongRequestsAreRefused();
    void unknownEndingsComputeNothing_data();
    void unknownEndingsComputeNothing();
    void errorsNameTheirTree();
    void cancelled();
    void flatTreesAreRefused();
    void documentsOnlyGiveWhatIsReady();

    void oneTreeIsShared();
    void severalTreesGetNumbers();
    void partsAreChosen();
    void textureCoordinatesOnDemand();
    void hiddenTreesStayAtHome();
    void placementIsApplied();
    void mirroredTreesStayOutward();
    void normalsFollowUnevenScales();
    void roughModel();
    void skeletonLines();
    void writesFiles_data();
    void writesFiles();

private:
    Expected<FlatScene> collect(const Scene& scene, const ExportOptions& options = {})
    {
        return test::flatExport(Evaluator(pipelineSource(m_pipeline)).at(scene), options);
    }
    TreePipeline m_pipeline;
};

void TestExporter::wrongRequestsAreRefused()
{
    QCOMPARE(collect({}).error().code, ErrorCode::Invalid);
    ExportOptions options;
    options.nodes = {9};
    QCOMPARE(collect(oneTree(), options).error().code, ErrorCode::Unknown);
    options = {};
    options.parts = 0;
    QCOMPARE(collect(oneTree(), options).error().code, ErrorCode::Invalid);
    Node bare = makeTree(1);
    bare.params.leaf.shape = LeafShape::Faithful;
    bare.params.foliage.leavesDensity = 0;
    options.parts = exportLeaves;
    QCOMPARE(collect(*Scene::fromNodes({bare}), options).error().code, ErrorCode::Invalid);
    Node group;
    group.id = 1;
    QVERIFY(!collect(*Scene::fromNodes({group})));
}

void TestExporter::unknownEndingsComputeNothing_data()
{
    QTest::addColumn<QString>("path");
    for (const char* path : {"", "tree", "tree.", "tree.dae", "folder.obj/tree", ".", "/", "obj"})
        QTest::newRow(path) << QString(path);
}

void TestExporter::unknownEndingsComputeNothing()
{
    QFETCH(QString, path);
    bool asked = false;
    const TreeSource source = [&](const Node&, Stage, const Progress&) -> Expected<TreeResult> {
        asked = true;
        return TreeResult{};
    };
    const auto done = exportScene(Evaluator(source).at(oneTree()), {}, path.toStdString());
    QVERIFY(!done);
    QCOMPARE(done.error().code, ErrorCode::Unknown);
    QVERIFY(!asked);
}

void TestExporter::errorsNameTheirTree()
{
    Node wrong = makeTree(2);
    wrong.params.grammar.axiom = std::string("A[[");
    const auto alone = collect(*Scene::fromNodes({wrong}));
    QCOMPARE(alone.error().path, std::string("grammar.axiom"));
    const auto beside = collect(*Scene::fromNodes({makeTree(1), wrong}));
    QCOMPARE(beside.error().path, std::string("n2: grammar.axiom"));
}

void TestExporter::cancelled()
{
    std::stop_source stop;
    stop.request_stop();
    const auto set =
        collectExport(Evaluator(pipelineSource(m_pipeline)).at(oneTree()), {}, {stop.get_token(), {}});
    QCOMPARE(set.error().code, ErrorCode::Cancelled);
}

void TestExporter::flatTreesAreRefused()
{
    PlacementParams flat;
    flat.scale = {1.0, 0.0, 1.0};
    const auto set = collect(oneTree(flat));
    QVERIFY(!set);
    QCOMPARE(set.error().path, std::string("tree.scale"));
}

void TestExporter::documentsOnlyGiveWhatIsReady()
{
    Document document;
    document.reset(oneTree(), {});
    const auto get = [&] {
        return test::flatExport(Evaluator(documentSource(document)).at(document.scene()), {});
    };
    QCOMPARE(get().error().code, ErrorCode::Invalid);
    NodeResult result;
    result.tree = *m_pipeline.evaluate(document.scene().find(1)->params);
    result.revision = document.revision();
    result.draft = true;
    document.setResult(1, result);
    QVERIFY(!get());
    result.draft = false;
    document.setResult(1, result);
    QVERIFY2(get(), test::why(get()));
    const TreeSource before = documentSource(document);
    const Scene scene = document.scene();
    QVERIFY(edit::setParam(document, {1}, *findParam("turtle.alpha"), 0.3));
    QVERIFY(!get());
    QVERIFY(test::flatExport(Evaluator(before).at(scene), {})); // what was taken stays good
    result.revision = document.revision();
    result.error = Error{};
    result.error->code = ErrorCode::Limit;
    document.setResult(1, result);
    QCOMPARE(get().error().code, ErrorCode::Limit);
    QCOMPARE(before(makeTree(7), Stage::Mesh, {}).error().code, ErrorCode::Unknown);
}

void TestExporter::oneTreeIsShared()
{
    const Scene scene = oneTree();
    const auto set = collect(scene);
    QVERIFY2(set, test::why(set));
    QCOMPARE(namesOf(*set), (Names{"branches", "leaves", "fruit"}));
    const auto tree = m_pipeline.evaluate(scene.find(1)->params);
    QCOMPARE(set->meshes[0].mesh.get(), &tree->branches->mesh); // out of the cache, and not copied
    QCOMPARE(set->meshes[1].mesh, tree->leaves.pointer());
    QCOMPARE(set->meshes[2].mesh, tree->apples.pointer());
}

void TestExporter::severalTreesGetNumbers()
{
    Node group;
    group.id = 9;
    Node bare = makeTree(2, 9);
    bare.params.foliage.leavesCutoff = 0.0;
    const Scene scene = *Scene::fromNodes({makeTree(1), group, bare, makeTree(3, 2)});
    const auto set = collect(scene);
    QVERIFY2(set, test::why(set));
    QCOMPARE(namesOf(*set),
             (Names{"branches_1", "leaves_1", "fruit_1", "branches_2", "branches_3", "leaves_3", "fruit_3"}));
    ExportOptions options;
    options.nodes = {9};
    QCOMPARE(namesOf(*collect(scene, options)), (Names{"branches_1", "branches_2", "leaves_2", "fruit_2"}));
    options.nodes = {3};
    QCOMPARE(namesOf(*collect(scene, options)), (Names{"branches", "leaves", "fruit"}));
}

void TestExporter::partsAreChosen()
{
    ExportOptions options;
    options.parts = exportApples;
    QCOMPARE(namesOf(*collect(oneTree(), options)), (Names{"fruit"}));
    options.parts = exportBranches;
    QCOMPARE(namesOf(*collect(oneTree(), options)), (Names{"branches"}));
    Stage asked = Stage::Placement;
    const TreeSource spy = [&](const Node& node, Stage last, const Progress& progress) {
        asked = last;
        return m_pipeline.evaluate(node.params, last, progress);
    };
    QVERIFY(test::flatExport(Evaluator(spy).at(oneTree()), options));
    QCOMPARE(asked, Stage::Mesh); // no leaves are grown for nothing
}

void TestExporter::textureCoordinatesOnDemand()
{
    ExportOptions options;
    const auto plain = collect(oneTree(), options);
    options.texture = true;
    const auto set = collect(oneTree(), options);
    QVERIFY2(set, test::why(set));
    QCOMPARE(namesOf(*set), (Names{"branches", "leaves", "fruit"}));
    for (std::size_t i = 0; i < set->meshes.size(); ++i) {
        const TriangleMesh& mesh = *set->meshes[i].mesh;
        QCOMPARE(mesh.positions, plain->meshes[i].mesh->positions); // never split
        QCOMPARE(mesh.triangles, plain->meshes[i].mesh->triangles);
        QVERIFY(plain->meshes[i].mesh->uv.empty());
        QVERIFY(!mesh.uv.empty());
        QVERIFY(mesh.uvTriangles.empty() ? mesh.uv.size() == mesh.positions.size()
                                         : mesh.uvTriangles.size() == mesh.triangles.size());
    }
    Node bad = makeTree(1);
    bad.params.texture.tileSize = 1e-12;
    const auto refused = collect(*Scene::fromNodes({bad}), options);
    QVERIFY(!refused);
    QCOMPARE(refused.error().path, std::string("texture.tileSize"));
}

void TestExporter::hiddenTreesStayAtHome()
{
    Node hidden = makeTree(1);
    hidden.visible = false;
    const Scene scene = *Scene::fromNodes({hidden, makeTree(2, 1)});
    QVERIFY(!collect(scene));
    ExportOptions options;
    options.hidden = true;
    QCOMPARE(collect(scene, options)->meshes.size(), std::size_t{6});
}

void TestExporter::placementIsApplied()
{
    PlacementParams place;
    place.translation = {1.0, 2.0, 3.0};
    place.rotation = {0.3, 0.2, 0.1};
    place.scale = glm::dvec3(2.0);
    const auto moved = collect(oneTree(place));
    const auto still = collect(oneTree());
    const TriangleMesh &a = *still->meshes[0].mesh, &b = *moved->meshes[0].mesh;
    QCOMPARE(a.vertexCount(), b.vertexCount());
    const glm::dmat4 matrix = placementMatrix(place);
    for (Index i = 0; i < a.vertexCount(); ++i) {
        const glm::dvec3 expected(matrix * glm::dvec4(a.positions[i], 1.0));
        QVERIFY(glm::length(expected - glm::dvec3(b.positions[i])) < 1e-5);
        QVERIFY(std::abs(glm::length(glm::dvec3(b.normals[i])) - 1.0) < 1e-6);
    }
    QVERIFY(a.branch == b.branch && a.level == b.level && a.triangles == b.triangles);
    QVERIFY(std::abs(volumeOf(b) / volumeOf(a) - 8.0) < 1e-3);
}

void TestExporter::mirroredTreesStayOutward()
{
    const auto set = collect(oneTree());
    const glm::dmat4 mirror = glm::scale(glm::dmat4(1.0), {-1.0, 1.5, 1.0});
    for (const FlatScene::Entry& entry : set->meshes)
        if (entry.name != "leaves") { // leaves are flat and have no inside
            const auto report = validateMesh(transformed(*entry.mesh, mirror));
            QVERIFY2(report && report->valid, entry.name.c_str());
        }
}

void TestExporter::normalsFollowUnevenScales()
{
    TriangleMesh slope;
    slope.positions = {{0, 0, 0}, {1, 1, 0}, {0, 0, -1}};
    slope.triangles = {{0, 1, 2}};
    slope.normals.assign(3, glm::normalize(glm::vec3(-1, 1, 0)));
    for (const glm::dvec3 scale : {glm::dvec3(1, 3, 2), glm::dvec3(-1, 3, 2), glm::dvec3(1, -3, 2)}) {
        const TriangleMesh moved = transformed(slope, glm::scale(glm::dmat4(1.0), scale));
        const glm::uvec3 t = moved.triangles.front();
        const glm::vec3 face = glm::normalize(glm::cross(moved.positions[t.y] - moved.positions[t.x],
                                                         moved.positions[t.z] - moved.positions[t.x]));
        QVERIFY(glm::length(face - moved.normals[0]) < 1e-6f);
    }
}

void TestExporter::roughModel()
{
    const Scene scene = oneTree();
    ExportOptions options;
    options.model = ExportModel::Rough;
    const auto set = collect(scene, options);
    QVERIFY2(set, test::why(set));
    QCOMPARE(namesOf(*set), (Names{"branches", "leaves", "fruit"}));
    const NodeParams& params = scene.find(1)->params;
    const auto tree = m_pipeline.evaluate(params, Stage::Foliage);
    const Skeleton& skeleton = tree->simplified->skeleton;
    const double alpha = params.turtle.alpha; // rough branches have no bark to stand on
    const auto foliage = placeFoliage(skeleton, params.foliage, params.leaf, params.fruit, alpha);
    QVERIFY(*set->meshes[0].mesh == buildRoughBranches(skeleton, 8));
    QVERIFY(*set->meshes[1].mesh == buildLeaves(skeleton, *foliage, alpha, FoliageModel::Rough));
    QVERIFY(*set->meshes[2].mesh == buildApples(skeleton, *foliage, alpha, FoliageModel::Rough));
}

void TestExporter::skeletonLines()
{
    ExportOptions options;
    options.model = ExportModel::Skeleton;
    const Scene scene = *Scene::fromNodes({makeTree(1), makeTree(2)});
    const auto set = collectExport(Evaluator(pipelineSource(m_pipeline)).at(scene), options);
    QVERIFY2(set, test::why(set));
    QVERIFY(set->lines && set->meshes.empty());
    const auto tree = m_pipeline.evaluate(scene.find(1)->params);
    const SkeletonStats stats = skeletonStats(tree->simplified->skeleton);
    QCOMPARE(set->lines->lines.size(), std::size_t{2 * stats.branches});
    QCOMPARE(set->lines->positions.size(), std::size_t{2 * (stats.branches + stats.roots)});
    double length = 0.0;
    for (const glm::uvec2& line : set->lines->lines)
        length += glm::length(glm::dvec3(set->lines->positions[line.x]) -
                              glm::dvec3(set->lines->positions[line.y]));
    QVERIFY(std::abs(length - 2 * stats.totalLength) < 1e-4);
}

void TestExporter::writesFiles_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("model");
    for (const QString& name : {QStringLiteral("tree.obj"), QStringLiteral("tree.PLY")})
        for (const ExportModel model : {ExportModel::Mesh, ExportModel::Rough, ExportModel::Skeleton})
            QTest::newRow(qPrintable(name + QString::number(int(model)))) << name << int(model);
}

void TestExporter::writesFiles()
{
    QFETCH(QString, name);
    QFETCH(int, model);
    QTemporaryDir folder;
    ExportOptions options;
    options.model = static_cast<ExportModel>(model);
    options.write.ascii = true;
    double last = 0.0;
    bool forward = true;
    const Progress progress{{}, [&](double fraction) {
                                forward = forward && fraction >= last;
                                last = fraction;
                            }};
    const auto done = exportScene(Evaluator(pipelineSource(m_pipeline)).at(oneTree()), options,
                                  folder.filePath(name).toStdString(), progress);
    QVERIFY2(done, test::why(done));
    QVERIFY(forward && last <= 1.0);
    QVERIFY(QFile(folder.filePath(name)).size() > 1000);
    if (options.model != ExportModel::Skeleton) {
        const auto back = readMeshFile(folder.filePath(name).toStdString());
        QVERIFY2(back, test::why(back));
        const auto set = collect(oneTree(), options);
        Index faces = 0;
        for (const MeshPart& part : set->parts())
            faces += part.mesh->faceCount();
        QCOMPARE(back->joined().faceCount(), faces);
    }
}

RAMURE_SUITE(TestExporter)

} // namespace tst_exporter

#include "tst_exporter.moc"
