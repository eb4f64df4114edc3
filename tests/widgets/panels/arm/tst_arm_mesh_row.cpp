#include "core/scene/arm_demo.h"
#include "tests/support/solids.h"
#include "tests/support/suite.h"
#include "widgets/panels/arm/arm_mesh_row.h"
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>

namespace tst_arm_mesh_row {

using namespace ramure;

/// The choice of what an arm wears.
class TestArmMeshRow : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void withoutAnArmThereIsNothingToChoose()
    {
        Document document;
        ArmMeshRow row(&document);
        QVERIFY(!row.isEnabled());
        row.setWaiting(true);
        row.takeImported(5);
        QCOMPARE(document.undoStack()->count(), 0);
    }

    void problemsAreTold()
    {
        Desk desk;
        Key flat;
        flat.value = 0.0;
        Scene scene = desk.document.scene();
        scene.find(3)->animation.set({ChannelPart::GlobalScale, 0, 0},
                                     std::make_shared<const AnyTrack>(*Track::fromKeys({flat})));
        desk.document.reset(scene, {});
        emit desk.choice->activated(1);
        QVERIFY(!desk.arm().mesh);
        QVERIFY(desk.problem()->isVisibleTo(&desk.row) && !desk.problem()->text().isEmpty());
        QCOMPARE(desk.choice->currentIndex(), 0);
        // A file that only moves something.
        desk.row.setWaiting(true);
        desk.row.takeImported(2);
        QVERIFY(desk.problem()->isVisibleTo(&desk.row));
    }

    void meshesAreOfferedAndWorn()
    {
        Desk desk;
        QCOMPARE(desk.choice->count(), 2); // the cylinder, the box
        QCOMPARE(desk.choice->itemText(1), QString("Box"));
        emit desk.choice->activated(1);
        QVERIFY(desk.arm().mesh);
        QCOMPARE(desk.document.undoStack()->count(), 1);
        QCOMPARE(desk.choice->currentIndex(), 1); // what it wears, then the box
        QCOMPARE(desk.choice->count(), 3);
        emit desk.choice->activated(1); // again: nothing
        QCOMPARE(desk.document.undoStack()->count(), 1);
        emit desk.choice->activated(0);
        QVERIFY(!desk.arm().mesh);
        QCOMPARE(desk.choice->currentIndex(), 0);
        desk.document.undo();
        QCOMPARE(desk.choice->currentIndex(), 1);
        QVERIFY(!desk.problem()->isVisibleTo(&desk.row));
    }

    void fitDecidesWhereItStands()
    {
        Desk desk;
        auto* fit = desk.row.findChild<QCheckBox*>();
        QVERIFY(fit->isChecked());
        const auto top = [&desk] {
            float most = 0.0F;
            for (const glm::vec3& p : desk.arm().mesh->positions)
                most = std::max(most, p.z);
            return most;
        };
        emit desk.choice->activated(1);
        QVERIFY(std::abs(top() - 4.4F) < 1e-4F);
        desk.document.undo();
        fit->setChecked(false);
        emit desk.choice->activated(1);
        QVERIFY(std::abs(top() - 1.0F) < 1e-4F);
    }

    void importedObjectsArePutOn()
    {
        Desk desk;
        QSignalSpy asked(&desk.row, &ArmMeshRow::importRequested);
        desk.row.findChild<QPushButton*>()->click();
        QCOMPARE(asked.count(), 1);
        desk.row.takeImported(3); // somebody else's import
        QVERIFY(!desk.arm().mesh);
        desk.row.setWaiting(true);
        desk.row.takeImported(3);
        QVERIFY(desk.arm().mesh);
        QVERIFY(!desk.document.scene().find(3)->visible);
    }

    void theAxisTurnsWhatIsWorn()
    {
        Desk desk;
        auto* axis = desk.row.findChild<QComboBox*>(QStringLiteral("wornAxis"));
        QCOMPARE(axis->currentIndex(), 0);
        emit desk.choice->activated(1);
        const auto width = [&desk] {
            float most = 0.0F;
            for (const glm::vec3& p : desk.arm().mesh->positions)
                most = std::max(most, p.x);
            return 2.0F * most;
        };
        QVERIFY(std::abs(width() - 0.88F) < 1e-4F); // 0.2 of 1, 4.4 long
        emit axis->activated(1);
        QVERIFY(width() > 4.0F); // 0.2 long became 4.4
        QCOMPARE(axis->currentIndex(), 1);
        QVERIFY(desk.arm().params.armSkin.axis == MeshAxis::X);
        desk.document.undo();
        QCOMPARE(axis->currentIndex(), 0);
        QVERIFY(std::abs(width() - 0.88F) < 1e-4F);
        // Without the object only the choice is kept, and that is said.
        QVERIFY(edit::removeNodes(desk.document, {3}));
        emit axis->activated(2);
        QVERIFY(desk.arm().params.armSkin.axis == MeshAxis::Y);
        QVERIFY(desk.problem()->isVisibleTo(&desk.row));
        desk.row.findChild<QCheckBox*>()->setChecked(false);
        QVERIFY(!axis->isEnabled());
    }

    void everythingHasATooltip()
    {
        Desk desk;
        for (const QWidget* widget :
             {static_cast<QWidget*>(desk.choice), static_cast<QWidget*>(desk.row.findChild<QCheckBox*>()),
              static_cast<QWidget*>(desk.row.findChild<QPushButton*>())})
            QVERIFY(!widget->toolTip().isEmpty());
    }

private:
    struct Desk
    {
        Document document;
        ArmMeshRow row{&document};
        QComboBox* choice = row.findChild<QComboBox*>();

        Desk()
        {
            Scene scene = armDemo();
            Node box;
            box.id = 3;
            box.kind = NodeKind::Mesh;
            box.name = "Box";
            box.mesh = SharedValue<TriangleMesh>(test::box({-0.1F, 0.0F, -0.1F}, {0.1F, 1.0F, 0.1F}));
            if (!scene.insert({box}, noNode, 2))
                qWarning("no box");
            document.reset(scene, {});
        }
        [[nodiscard]] const Node& arm() const { return *document.scene().find(1); }
        [[nodiscard]] QLabel* problem() const { return row.findChild<QLabel*>(QStringLiteral("problem")); }
    };
};

RAMURE_SUITE(TestArmMeshRow)

} // namespace tst_arm_mesh_row

#include "tst_arm_mesh_row.moc"
