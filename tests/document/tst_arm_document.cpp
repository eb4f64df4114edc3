#include "core/qt/document/commands.h"
#include "core/qt/document/project/project_arm.h"
#include "core/qt/document/project/project_file.h"
#include "core/scene/arm_demo.h"
#include "tests/support/suite.h"
#include <QJsonDocument>
#include <QJsonObject>

namespace tst_arm_document {

using namespace ramure;

/// Arms in projects and their commands.
class TestArmDocument : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnAnyWarning(); }
    void wrongJointsAreErrors_data();
    void wrongJointsAreErrors();
    void jointsGoThereAndBack();
    void theDemoIsAProject();
    void jointsAreSetByCommand();
    void aDragIsOneStep();
};

namespace {

QJsonValue parsed(const QByteArray& json)
{
    return QJsonDocument::fromJson("{\"v\":" + json + "}").object().value(QLatin1String("v"));
}

std::vector<ArmJoint> unusualJoints()
{
    std::vector<ArmJoint> joints(4);
    joints[0].length = 0.1;
    joints[1].phi = {0.25, true, -0.5, 1.0 / 3.0, 2.0};
    joints[2].theta.angleRad = -1e-3;
    joints[3].theta.mostSpeed = 0.7;
    return joints;
}

} // namespace

void TestArmDocument::wrongJointsAreErrors_data()
{
    QTest::addColumn<QByteArray>("json");
    QTest::addColumn<QByteArray>("path");
    const auto row = [](const char* json, const char* path) {
        QTest::newRow(json) << QByteArray(json) << QByteArray(path);
    };
    row("3", "joints");
    row("[]", "joints");
    row("[4]", "joints[0]");
    row("[{},{\"length\":\"long\"}]", "joints[1].length");
    row("[{},{\"length\":0}]", "joints[1].length");
    row("[{\"phi\":[]}]", "joints[0].phi");
    row("[{\"phi\":{\"angle\":true}}]", "joints[0].phi.angle");
    row("[{\"theta\":{\"limited\":1}}]", "joints[0].theta.limited");
    row("[{\"theta\":{\"min\":4}}]", "joints[0].theta.minRad");
    row("[{\"theta\":{\"mostSpeed\":-1}}]", "joints[0].theta.mostSpeed");
    row("[{\"phi\":{\"colour\":1}}]", "joints[0].phi.colour");
    row("[{\"kind\":\"elbow\"}]", "joints[0].kind");
    QByteArray many("[");
    for (int i = 0; i < 65; ++i)
        many += i == 0 ? "{}" : ",{}";
    QTest::newRow("65") << many + "]" << QByteArray("joints");
}

void TestArmDocument::wrongJointsAreErrors()
{
    QFETCH(QByteArray, json);
    QFETCH(QByteArray, path);
    const auto joints = json::readJoints(parsed(json));
    QVERIFY(!joints);
    QCOMPARE(QByteArray::fromStdString(joints.error().path), path);
}

void TestArmDocument::jointsGoThereAndBack()
{
    const auto back = json::readJoints(json::writeJoints(unusualJoints()));
    QVERIFY(back);
    QVERIFY(*back == unusualJoints());
    QCOMPARE(json::writeJoints({ArmJoint()}), QJsonArray{QJsonObject()});
}

void TestArmDocument::theDemoIsAProject()
{
    Project project{armDemo(), {}};
    QCOMPARE(project.scene.nodes().size(), std::size_t(2));
    QVERIFY(checkParams(project.scene.nodes()[0].params));
    project.scene.find(1)->params.joints = unusualJoints();
    const QByteArray file = writeProject(project);
    QVERIFY(file.contains("\"joints\""));
    const auto back = readProject(file);
    QVERIFY2(back, test::why(back).constData());
    QVERIFY(back->scene == project.scene);
    QCOMPARE(writeProject(*back), file);
    project.scene.find(1)->params.joints = defaultArmJoints();
    QVERIFY(!writeProject(project).contains("\"joints\""));
}

void TestArmDocument::jointsAreSetByCommand()
{
    Document document;
    document.reset(armDemo(), {});
    const std::vector<ArmJoint> before = document.scene().find(1)->params.joints;
    QVERIFY(!edit::setJoints(document, 99, unusualJoints(), QStringLiteral("x")));
    QVERIFY(!edit::setJoints(document, 2, unusualJoints(), QStringLiteral("x"))); // a terrain
    QVERIFY(!edit::setJoints(document, 1, {}, QStringLiteral("x")));
    QVERIFY(edit::setJoints(document, 1, before, QStringLiteral("x")));
    QCOMPARE(document.undoStack()->count(), 0);
    Change news;
    connect(&document, &Document::changed, this, [&news](const Change& change) {
        if (change.has(changeJoints))
            news = change;
    });
    QVERIFY(edit::setJoints(document, 1, unusualJoints(), QStringLiteral("x")));
    QCOMPARE(news.nodes, std::vector<NodeId>{1});
    QVERIFY(document.scene().find(1)->params.joints == unusualJoints());
    document.undo();
    QVERIFY(document.scene().find(1)->params.joints == before);
    QVERIFY(edit::setNodeLocked(document, {1}, true));
    QVERIFY(!edit::setJoints(document, 1, unusualJoints(), QStringLiteral("x")));
}

void TestArmDocument::aDragIsOneStep()
{
    Document document;
    document.reset(armDemo(), {});
    const std::vector<ArmJoint> before = document.scene().find(1)->params.joints;
    const GestureId drag = newGesture();
    std::vector<ArmJoint> joints = before;
    for (int i = 1; i <= 5; ++i) {
        joints[0].phi.angleRad = 0.1 * i;
        QVERIFY(edit::setJoints(document, 1, joints, QStringLiteral("x"), drag));
    }
    QCOMPARE(document.undoStack()->count(), 1);
    QVERIFY(edit::setJoints(document, 1, before, QStringLiteral("x"), drag));
    QCOMPARE(document.undoStack()->count(), 0);
}

RAMURE_SUITE(TestArmDocument)

} // namespace tst_arm_document

#include "tst_arm_document.moc"
