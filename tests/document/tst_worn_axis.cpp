#include "core/qt/document/project/project_file.h"
#include "core/qt/session/arm/arm_dresser.h"
#include "core/scene/arm_demo.h"
#include "core/surface/proof/validate.h"
#include "tests/support/solids.h"
#include "tests/support/suite.h"
#include <glm/common.hpp>

Q_DECLARE_METATYPE(glm::dvec3)

namespace tst_worn_axis {

using namespace ramure;

namespace {

/// The arm is node 1; node 3 is a crown that is wider than it is high, as trees are, in two colours.
struct Desk
{
    Document document;
    ArmDresser dresser{&document};

    explicit Desk(const PlacementParams& place = {})
    {
        Scene scene = armDemo();
        Node tree;
        tree.id = 3;
        tree.kind = NodeKind::Mesh;
        tree.name = "Tree";
        tree.params.tree = place;
        tree.params.surface.color = {1.0, 1.0, 1.0};
        TriangleMesh mesh = test::box({-2.0F, 0.0F, -0.5F}, {2.0F, 1.0F, 0.5F});
        mesh.colours.assign(mesh.triangles.size(), {58, 95, 11});
        mesh.colours[0] = {139, 90, 43};
        tree.mesh = SharedValue<TriangleMesh>(std::move(mesh));
        if (!scene.insert({tree}, noNode, 2))
            qWarning("no tree");
        document.reset(scene, {});
    }
    [[nodiscard]] const Node& arm() const { return *document.scene().find(1); }
    [[nodiscard]] QByteArray bytes() const { return writeProject(document.project()); }
    /// Of what the arm wears, in the arm's own space: Z along it.
    [[nodiscard]] std::pair<glm::vec3, glm::vec3> box() const
    {
        glm::vec3 low(1e9F), high(-1e9F);
        for (const glm::vec3& p : arm().mesh->positions) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
        return {low, high};
    }
};

bool isNear(const glm::vec3& a, const glm::vec3& b)
{
    return glm::length(a - b) < 1e-4F;
}

} // namespace

/// Which way meshes are turned that arms wear, and what they keep.
class TestWornAxis : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void theChosenAxisLiesAlongTheArm_data()
    {
        QTest::addColumn<int>("axis");
        QTest::addColumn<glm::dvec3>("rotation");
        for (const glm::dvec3& turn : {glm::dvec3(0.0), glm::dvec3(0.0, 0.0, 1.5707963267948966),
                                       glm::dvec3(3.141592653589793, 0.0, 0.0), glm::dvec3(0.3, -0.7, 1.1)})
            for (const MeshAxis axis : {MeshAxis::X, MeshAxis::Y, MeshAxis::Z})
                QTest::addRow("%d, turned %g %g %g", int(axis), turn.x, turn.y, turn.z) << int(axis) << turn;
    }
    void theChosenAxisLiesAlongTheArm()
    {
        QFETCH(const int, axis);
        QFETCH(const glm::dvec3, rotation);
        PlacementParams place;
        place.rotation = rotation;
        place.translation = {3.0, 1.0, -2.0};
        Desk desk(place);
        QVERIFY(desk.dresser.wear(1, 3, true, static_cast<MeshAxis>(axis)));
        const glm::vec3 size{4.0F, 1.0F, 1.0F};
        const float scale = 4.4F / size[axis - int(MeshAxis::X)];
        const TriangleMesh& worn = *desk.arm().mesh;
        const auto [low, high] = desk.box();
        QVERIFY(std::abs(low.z) < 1e-4F && std::abs(high.z - 4.4F) < 1e-4F);
        // As large all around, and outward still.
        const auto before = validateMesh(*desk.document.scene().find(3)->mesh), after = validateMesh(worn);
        QVERIFY(before && after && after->valid);
        QVERIFY(std::abs(after->volume / (before->volume * std::pow(double(scale), 3.0)) - 1.0) < 1e-4);
        QVERIFY(desk.arm().params.armSkin.axis == static_cast<MeshAxis>(axis));
    }

    void treesStandUpright()
    {
        Desk desk;
        QVERIFY(desk.dresser.wear(1, 3, true)); // its longest axis is across
        QVERIFY(desk.box().second.x - desk.box().first.x < 2.0F);
        QVERIFY(desk.dresser.wear(1, 3, true, MeshAxis::Y));
        QVERIFY(isNear(desk.box().first, {-8.8F, -2.2F, 0.0F}));
        QVERIFY(isNear(desk.box().second, {8.8F, 2.2F, 4.4F}));
        // Fitting again keeps it upright.
        QVERIFY(edit::addJoint(desk.document, 1, 0));
        QVERIFY(desk.dresser.fitAgain(1));
        const auto [low, high] = desk.box();
        QVERIFY(std::abs((high.x - low.x) / (high.z - low.z) - 4.0F) < 1e-4F);
    }

    void theParameterIsTakenByDefault()
    {
        Desk desk;
        QVERIFY(edit::setParam(desk.document, {1}, *findParam("armSkin.axis"), EnumValue{"y"}));
        QVERIFY(edit::wearMesh(desk.document, 1, 3, true));
        QVERIFY(isNear(desk.box().second, {8.8F, 2.2F, 4.4F}));
        QVERIFY(edit::wearMesh(desk.document, 1, 3, false)); // where it stands
        QVERIFY(desk.arm().params.armSkin.axis == MeshAxis::Y);
    }

    void coloursAreWornAndUndoneExactly()
    {
        Desk desk;
        const QByteArray before = desk.bytes();
        QVERIFY(desk.dresser.wear(1, 3, true, MeshAxis::Y));
        QCOMPARE(desk.document.undoStack()->count(), 1);
        QVERIFY(desk.arm().mesh->colours == desk.document.scene().find(3)->mesh->colours);
        QVERIFY(desk.arm().params.surface.color == glm::dvec3(1.0));
        const QByteArray after = desk.bytes();
        desk.document.undo();
        QCOMPARE(desk.bytes(), before);
        desk.document.redo();
        QCOMPARE(desk.bytes(), after);
        const auto again = readProject(after);
        QVERIFY2(again, test::why(again));
        QVERIFY(again->scene.find(1)->mesh->colours == desk.arm().mesh->colours);
    }
};

RAMURE_SUITE(TestWornAxis)

} // namespace tst_worn_axis

#include "tst_worn_axis.moc"
