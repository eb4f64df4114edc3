#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/scene/preset_scene.h"
#include "tests/support/suite.h"
#include "widgets/view/render/figure.h"
#include "widgets/view/render/scene_builder.h"
#include <glm/gtc/matrix_transform.hpp>

namespace tst_figure {

using namespace ramure;

class TestFigure : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void itIsAsTallAsItSays()
    {
        const TriangleMesh mesh = figureMesh();
        const Box box = meshBox(mesh);
        QCOMPARE(box.min.y, 0.0);
        QVERIFY(std::abs(box.max.y - figureHeight) < 0.005);
        QVERIFY(std::abs(box.min.x + box.max.x) < 1e-5); // both sides alike
        QCOMPARE(mesh.normals.size(), mesh.positions.size());
    }

    void withoutATreeItStandsBesideWhatThereIs()
    {
        RenderScene empty;
        addFigure(empty, {});
        QCOMPARE(empty.meshes.size(), std::size_t(1));
        QVERIFY(empty.meshes[0].world[3].x > 0.3);
        RenderScene box;
        box.box.add({-5.0, -1.0, -5.0});
        box.box.add({5.0, 4.0, 5.0});
        addFigure(box, {});
        QVERIFY(box.meshes[0].world[3].x > 5.0);
        QCOMPARE(box.meshes[0].world[3].y, -1.0);
    }

    /// Beside the trunk, on its ground, out of the way of the camera and the mouse.
    void itStandsBesideTheFirstTree()
    {
        Scene scene = *presetScene("SmallTree");
        TreePipeline pipeline;
        const auto tree = pipeline.evaluate(scene.nodes().front().params, Stage::Mesh);
        QVERIFY(tree);
        const auto resultOf = [&tree](NodeId) { return &*tree; };
        SceneView view;
        SceneBuilder builder;
        const RenderScene without = builder.build(scene, resultOf, view);
        view.figure = true;
        const RenderScene with = builder.build(scene, resultOf, view);
        QCOMPARE(with.meshes.size(), without.meshes.size() + 1);
        const MeshItem& figure = with.meshes.back();
        QVERIFY(!figure.pickable && !figure.framed && figure.node == noNode);
        QVERIFY(figure.world[3].x > tree->skeleton->a0[0] + 0.5);
        QVERIFY(with.framePoints() == without.framePoints());
    }

    /// Beside a tree on a slope neither in the air nor in the ground, however the tree is turned.
    void itStandsOnASlope()
    {
        for (const double turn : {0.0, 1.0, 2.5}) {
            RenderScene scene;
            FigureTree tree{{0.2, 0.1, 0.3}, 0.4, {}, GroundPlane{0.1, {-0.9, 0.4}}};
            tree.world = glm::rotate(glm::scale(glm::dmat4(1.0), glm::dvec3(1.5)), turn, {0.0, 1.0, 0.0});
            addFigure(scene, tree);
            const glm::dmat4& world = scene.meshes.back().world;
            const glm::dvec3 own(glm::inverse(tree.world) * world[3]);
            QVERIFY(std::abs(tree.ground->above(own)) < 1e-9);
            QCOMPARE(glm::dvec3(world[1]), glm::dvec3(0.0, 1.0, 0.0)); // upright
        }
    }
};

RAMURE_SUITE(TestFigure)

} // namespace tst_figure

#include "tst_figure.moc"
