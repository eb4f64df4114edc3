#include "core/evaluate/evaluator.h"
#include "core/io/formats/glb/glb_reader.h"
#include "core/io/formats/text/blender_scene.h"
#include "core/presets/presets.h"
#include "core/qt/session/export/exporter.h"
#include "core/scene/demo_scenes.h"
#include "tests/core/io/io_support.h"
#include <QDir>
#include <QImage>
#include <QTemporaryDir>

namespace tst_glb_import {

using namespace ramure;

/// Files of the program's own clips, imported and written once more: the same surfaces in the same places.
class TestGlbImport : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    [[nodiscard]] std::string path(const char* name) const
    {
        return m_folder.filePath(QLatin1String(name)).toStdString();
    }
    /// \param seconds the moments of the clip; of one moment a still scene
    void write(const Scene& scene, const std::vector<double>& seconds, const char* name) const
    {
        ExportOptions options;
        options.write.mapSize = 0;
        options.write.joints = 0;
        options.parts = exportBranches | exportApples; // in a clip leaves do not flutter
        options.clip.assign(seconds.begin() + 1, seconds.end());
        TreePipeline pipeline;
        Evaluator evaluator(pipelineSource(pipeline), scene.timeline());
        if (auto done = exportScene(evaluator.at(scene, seconds.front()), options, path(name)); !done)
            qFatal("%s", done.error().message().c_str());
    }
    [[nodiscard]] Scene imported(const char* name) const
    {
        auto made = importObjects(path(name));
        if (!made)
            qFatal("%s", made.error().message().c_str());
        Scene scene = *Scene::fromNodes(std::move(made->nodes));
        scene.setTimeline(made->timeline);
        return scene;
    }
    /// The greatest distance of a corner in one file from the same corner in the other.
    [[nodiscard]] double worst(const char* a, const char* b) const
    {
        const auto one = readMeshFile(path(a)), other = readMeshFile(path(b));
        if (!one || !other)
            qFatal("%s", (one ? other : one).error().message().c_str());
        double most = 0.0;
        const TriangleMesh first = one->joined(), second = other->joined();
        if (first.triangles.size() != second.triangles.size())
            qFatal("other triangles: %zu and %zu", first.triangles.size(), second.triangles.size());
        for (std::size_t t = 0; t < first.triangles.size(); ++t)
            for (int k = 0; k < 3; ++k)
                most = std::max(most, double(glm::distance(first.positions[first.triangles[t][k]],
                                                           second.positions[second.triangles[t][k]])));
        return most;
    }
    static const Node& nodeOf(const Scene& scene, NodeKind kind)
    {
        for (const Node& node : scene.nodes())
            if (node.kind == kind)
                return node;
        qFatal("no such node");
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void aTreeInMotionStandsAsInItsFirstFrame()
    {
        Node tree;
        tree.id = 1;
        tree.kind = NodeKind::Tree;
        tree.name = "Tree";
        tree.params = *presetParams("TinyTree");
        tree.params.skin.method = SkinMethod::Linear;
        tree.params.tree.translation = {2, 0, 1};
        const Scene scene = *Scene::fromNodes({tree});
        write(scene, {0.5}, "still.glb");
        write(scene, {0.5, 1.0}, "clip.glb");
        QVERIFY(worst("still.glb", "clip.glb") < 3e-5);
        const auto made = importObjects(path("clip.glb"));
        QVERIFY2(made, test::why(made));
        QVERIFY(std::ranges::count(made->nodes, NodeKind::Mesh, &Node::kind) == 2);
        QVERIFY(made->notes.front().message().find("make no arm") != std::string::npos);
        write(*Scene::fromNodes(made->nodes), {0.0}, "again.glb");
        QVERIFY(worst("still.glb", "again.glb") < 3e-5);
    }

    void anArmComesBackWithItsJoints()
    {
        Scene scene = *demoScene("Arm");
        const NodeId id = nodeOf(scene, NodeKind::Arm).id;
        scene.find(id)->params.skin.method = SkinMethod::Linear;
        scene.find(id)->params.arm.follows = false;
        write(scene, {0.0}, "still.glb");
        write(scene, {0.0, 1.0}, "clip.glb");
        QVERIFY(worst("still.glb", "clip.glb") < 1e-5);
        const Scene back = imported("clip.glb");
        const Node& arm = nodeOf(back, NodeKind::Arm);
        const std::vector<ArmJoint>& own = scene.find(id)->params.joints;
        QCOMPARE(arm.params.joints.size(), own.size());
        for (std::size_t j = 0; j < own.size(); ++j)
            QVERIFY(std::abs(arm.params.joints[j].length - own[j].length) < 1e-4);
    }

    void anArmMovesAsItDid()
    {
        Scene scene = *demoScene("Arm");
        const NodeId id = nodeOf(scene, NodeKind::Arm).id;
        scene.find(id)->params.skin.method = SkinMethod::Linear;
        scene.find(id)->params.armSkin.window = 0.0; // of what is bound anew by height
        std::vector<double> frames;
        for (int i = 0; i <= 48; ++i)
            frames.push_back(double(i) / 24.0);
        write(scene, frames, "clip.glb");
        const Scene back = imported("clip.glb");
        QVERIFY(nodeOf(back, NodeKind::Arm).animation.movesParams());
        for (const double seconds : {0.0, 0.5, 1.0, 2.0}) {
            write(scene, {seconds}, "own.glb");
            write(back, {seconds}, "back.glb");
            QVERIFY2(worst("own.glb", "back.glb") < 1e-3,
                     qPrintable(QString::number(worst("own.glb", "back.glb"))));
        }
    }

    void nodesMoveAsTheirTracks()
    {
        const Scene scene = *demoScene("MovingTree");
        std::vector<double> frames;
        for (int i = 0; i <= 120; ++i)
            frames.push_back(double(i) / 24.0);
        write(scene, frames, "clip.glb");
        const Scene back = imported("clip.glb");
        for (const double seconds : {0.0, 1.25, 3.0, 5.0}) {
            write(scene, {seconds}, "own.glb");
            write(back, {seconds}, "back.glb");
            QVERIFY2(worst("own.glb", "back.glb") < 1e-3,
                     qPrintable(QString::number(worst("own.glb", "back.glb"))));
        }
    }

    void picturesBecomeFilesBesideIt()
    {
        QImage colour(8, 8, QImage::Format_RGB32), opacity(8, 8, QImage::Format_Grayscale8);
        colour.fill(Qt::darkGreen);
        opacity.fill(0);
        opacity.setPixelColor(3, 3, Qt::white);
        QVERIFY(colour.save(QString::fromStdString(path("c.png"))) &&
                opacity.save(QString::fromStdString(path("o.png"))));
        TriangleMesh leaf;
        leaf.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        leaf.uv = {{0, 0}, {1, 0}, {0, 1}};
        leaf.triangles = {{0, 1, 2}};
        Material material;
        material.name = "leaf";
        material.pictures.colour = path("c.png");
        material.pictures.opacity = path("o.png");
        ExportScene scene = sceneOfMeshes({{"Leaf", leaf, {}}}, material);
        ExportOptions options;
        QVERIFY(writeExport(scene, options, path("leaf.glb")));
        for (int round = 0; round < 2; ++round) { // the second time they are there
            const auto made = importObjects(path("leaf.glb"));
            QVERIFY2(made, test::why(made));
            const PictureParams& pictures = made->nodes.back().params.surfacePictures;
            QVERIFY(!QImage(QString::fromStdString(pictures.colour)).isNull());
            const QImage cut(QString::fromStdString(pictures.opacity));
            QCOMPARE(qGray(cut.pixel(3, 3)), 255);
            QCOMPARE(qGray(cut.pixel(0, 0)), 0);
            QCOMPARE(made->nodes.back().mesh->uv, leaf.uv);
            QCOMPARE(QDir(m_folder.filePath("leaf_pictures")).entryList(QDir::Files).size(), 2);
        }
        // Another picture of that name is not touched.
        test::writeBytes(m_folder.filePath("leaf_pictures/leaf_colour.png"), "mine");
        const auto made = importObjects(path("leaf.glb"));
        QVERIFY2(made, test::why(made));
        QVERIFY(QString::fromStdString(made->nodes.back().params.surfacePictures.colour)
                    .endsWith("leaf_colour_2.png"));
        QCOMPARE(test::fileBytes(m_folder.filePath("leaf_pictures/leaf_colour.png")), QByteArray("mine"));
    }
};

RAMURE_SUITE(TestGlbImport)

} // namespace tst_glb_import

#include "tst_glb_import.moc"
