#include "core/io/export_scene.h"
#include "core/rig/arm/arm_shape.h"
#include "core/surface/mesh/transformed.h"
#include "tests/support/solids.h"
#include "tests/support/suite.h"
#include <glm/gtc/matrix_transform.hpp>

namespace tst_export_scene {

using namespace ramure;

class TestExportScene : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void nothingStaysNothing()
    {
        QVERIFY(flattened({}).meshes.empty());
        QVERIFY(sceneOfMeshes({}, barkMaterial()).nodes.empty());
    }
    void materialsAreThereOnce()
    {
        ExportScene scene;
        QCOMPARE(materialIn(scene, barkMaterial()), Index(0));
        QCOMPARE(materialIn(scene, leavesMaterial()), Index(1));
        QCOMPARE(materialIn(scene, barkMaterial()), Index(0));
        QCOMPARE(scene.materials.size(), std::size_t(2));
    }
    void differentMaterialsHaveDifferentNames()
    {
        ExportScene scene;
        BarkParams bark;
        bark.family = BarkFamily::Furrowed;
        for (int seed = 1; seed <= 3; ++seed) {
            bark.seed = seed;
            QCOMPARE(materialIn(scene, barkMaterial(bark)), Index(seed - 1));
        }
        QCOMPARE(materialIn(scene, barkMaterial(bark)), Index(2));
        QCOMPARE(scene.materials[0].name, std::string("bark_furrowed"));
        QCOMPARE(scene.materials[1].name, std::string("bark_furrowed_2"));
        QCOMPARE(scene.materials[2].name, std::string("bark_furrowed_3"));
    }
    void meshesInPlaceAreShared()
    {
        const ExportScene scene = box();
        const FlatScene flat = flattened(scene);
        QCOMPARE(flat.meshes[0].mesh, scene.meshes[0].mesh);
        QCOMPARE(flat.parts()[0].name, std::string("box"));
        QCOMPARE(flat.parts()[0].material, barkMaterial());
    }
    void placesAndTheSpaceOfTheFileMoveThem()
    {
        ExportScene scene = box();
        const TriangleMesh& mesh = *scene.meshes[0].mesh;
        const glm::dmat4 place = glm::translate(glm::dmat4(1.0), {1.0, 2.0, 3.0});
        scene.frames.push_back(scene.frames[0]);
        scene.frames[1].transforms[0].geometry = place;
        QCOMPARE(*flattened(scene, 0).meshes[0].mesh, mesh);
        QCOMPARE(*flattened(scene, 1).meshes[0].mesh, transformed(mesh, place));
        scene.space.up = UpAxis::Z;
        scene.space.unit = 1;
        QCOMPARE(*flattened(scene, 1).meshes[0].mesh, transformed(mesh, scene.space.matrix() * place));
    }
    void skinsFollowTheBonesOfTheFrame()
    {
        ExportScene scene = box();
        const TriangleMesh& mesh = *scene.meshes[0].mesh;
        Skin skin{{{0, {{0, 0, 0}, {1.0F, 0.0F, 0.0F}}}}, mesh.vertexCount(), 1};
        scene.meshes[0].skin = std::make_shared<const Skin>(skin);
        QCOMPARE(*flattened(scene).meshes[0].mesh, mesh); // no bones: it rests
        std::vector<RigidTransform> bones(1);
        bones[0].translation = {0.0, 5.0, 0.0};
        scene.frames[0].bones[0] = std::make_shared<const std::vector<RigidTransform>>(bones);
        const TriangleMesh moved = deformed(mesh, skin, bones, scene.nodes[0].method);
        QVERIFY(moved.positions != mesh.positions);
        QCOMPARE(*flattened(scene).meshes[0].mesh, moved);
        scene.nodes[0].isArm = true;
        QCOMPARE(flattened(scene).meshes[0].mesh->positions, upright(moved).positions);
    }

private:
    static ExportScene box()
    {
        return sceneOfMeshes({{"box", test::box({-1, 0, -1}, {1, 2, 1}), {}}}, barkMaterial());
    }
};

RAMURE_SUITE(TestExportScene)

} // namespace tst_export_scene

#include "tst_export_scene.moc"
