#include "core/io/copy_list.h"
#include "core/io/formats/text/blender_scene.h"
#include "core/io/mesh_file.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/qt/document/commands.h"
#include "core/qt/session/jobs/autosave.h"
#include "core/qt/session/motion/sequence.h"
#include "core/rig/physics/physics_bake.h"
#include "core/scene/demo_scenes.h"
#include "tests/support/failing_disk.h"
#include "tests/support/solids.h"
#include "tests/support/suite.h"
#include <map>

namespace tst_nothing_lost {

using namespace ramure;

namespace {

/// Everything that the document and the export write; the bytes differ between the versions.
struct Writer
{
    const char* name;
    test::WriteFiles write;
    bool single = true;
};

std::string in(const QString& folder, const char* name)
{
    return folder.toStdString() + "/" + name;
}

TriangleMesh boxOf(int version)
{
    return test::box({0, 0, 0}, {1, 2, 3 + version});
}

Scene boxScene(int version)
{
    Node node;
    node.id = 1;
    node.kind = NodeKind::Mesh;
    node.name = "Box";
    node.mesh = SharedValue<TriangleMesh>(boxOf(version));
    node.params.surface.color = {0.5, 0.1 * version, 0.5};
    return *Scene::fromNodes({node});
}

Expected<void> saveProject(const QString& folder, int version)
{
    return saveProjectFile({boxScene(version), {}}, folder + QStringLiteral("/a.ramure"));
}

/// For each folder one program that runs.
test::WriteFiles recoveryWriter()
{
    struct Program
    {
        Document document;
        std::unique_ptr<Autosave> autosave;
    };
    const auto programs = std::make_shared<std::map<QString, Program>>();
    return [programs](const QString& folder, int version) {
        Program& program = (*programs)[folder];
        if (!program.autosave) {
            Node tree;
            tree.id = 1;
            tree.kind = NodeKind::Tree;
            program.document.reset(*Scene::fromNodes({tree}), {});
            program.autosave = std::make_unique<Autosave>(&program.document, folder);
        }
        edit::setParam(program.document, {1}, *findParam("grammar.seed"), std::int64_t(version + 5));
        return program.autosave->saveNow();
    };
}

test::WriteFiles bakeWriter()
{
    const NodeParams params = presetParams("TinyTree").value();
    const auto tree = TreePipeline().evaluate(params, Stage::Simplified);
    const auto cache = std::make_shared<PhysicsCache>(
        makeTreeBody(tree.value().simplified->skeleton, nullptr, params.turtle.alpha), params.physics);
    return [cache](const QString& folder, int version) {
        return saveBake(*cache, 5 + version, in(folder, "a.bake"));
    };
}

Expected<void> writeObjects(const QString& folder, int version)
{
    const TriangleMesh mesh = boxOf(version);
    Material material = barkMaterial();
    material.colour.r = static_cast<std::uint8_t>(version);
    const MeshPart part{"box", &mesh, material};
    return writeObj(in(folder, "a.obj"), {&part, 1});
}

Expected<void> writePolygons(const QString& folder, int version)
{
    const TriangleMesh mesh = boxOf(version);
    const MeshPart part{"box", &mesh, barkMaterial()};
    return writePly(in(folder, "a.ply"), {&part, 1}, {});
}

/// A table and the shape that its rows name.
Expected<void> writeInstances(const QString& folder, int version)
{
    ExportScene scene = sceneOfMeshes({}, leavesMaterial());
    scene.nodes.push_back({"Oak"});
    scene.frames.front().transforms.resize(1);
    ExportCopies leaves{"leaves", "birch", 0, std::make_shared<const TriangleMesh>(boxOf(version)), 0, {}};
    leaves.copies.resize(3 + std::size_t(version));
    scene.copies.push_back(std::move(leaves));
    scene.materials[0].colour.r = static_cast<std::uint8_t>(version);
    return writeCopyList(in(folder, "a.obj"), scene, {});
}

LinePart linesOf(int version)
{
    return {"lines", {{0, 0, 0}, {1, 2, 3 + version}}, {{0, 1}}};
}

Expected<TreeResult> noTrees(const Node& node, Stage, const Progress&)
{
    return fail(ErrorCode::Invalid, "%1 is no tree", {node.name});
}

Expected<void> writeSequence(const QString& folder, int version)
{
    return exportSequence(boxScene(version), {}, {0, 2, 1}, noTrees, in(folder, "a.obj"));
}

/// Objects that move, and their keys.
Expected<void> writeAnimation(const QString& folder, int version)
{
    std::vector<Node> nodes = demoScene("MovingCylinder")->nodes();
    for (Node& node : nodes)
        node.params.primitive.radius += version;
    const auto written = exportBlender(*Scene::fromNodes(nodes), folder.toStdString());
    return written ? Expected<void>() : fail(written.error());
}

std::vector<Writer> writers()
{
    return {
        {"project", saveProject},
        {"recovery file", recoveryWriter()},
        {"baked motion", bakeWriter()},
        {"OBJ with MTL", writeObjects},
        {"OBJ of lines", [](const QString& folder,
                            int version) { return writeObjLines(in(folder, "a.obj"), linesOf(version)); }},
        {"PLY", writePolygons},
        {"PLY of lines",
         [](const QString& folder, int version) {
             return writePlyLines(in(folder, "a.ply"), linesOf(version), {});
         }},
        {"list of instances", writeInstances, false},
        {"sequence", writeSequence, false},
        {"animation", writeAnimation, false},
    };
}

} // namespace

/// Disks that are full, broken or read-only: whatever is written, at whichever call of the system it fails.
class TestNothingLost : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void oldFilesStay_data()
    {
        QTest::addColumn<std::size_t>("row");
        for (std::size_t row = 0; row < m_writers.size(); ++row)
            QTest::newRow(m_writers[row].name) << row;
    }
    void oldFilesStay()
    {
        QFETCH(std::size_t, row);
        test::checkNothingLost(m_writers[row].write, m_writers[row].single);
    }

private:
    std::vector<Writer> m_writers = writers();
};

RAMURE_SUITE(TestNothingLost)

} // namespace tst_nothing_lost

#include "tst_nothing_lost.moc"
