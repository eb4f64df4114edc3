#include "core/qt/document/project/project_migrations.h"

#include "core/qt/document/project/project_file.h"
#include "core/qt/document/project/project_json.h"
#include "core/scene/kinds/node_kinds.h"
#include "tests/support/suite.h"

#include <QJsonDocument>

namespace tst_project_migrations {

using namespace ramure;

static Expected<void> renameName(QJsonObject& root)
{
    root.insert("title", root.take("name"));
    return {};
}
static Expected<void> refuseEmptyTitle(QJsonObject& root)
{
    if (root.value("title").toString().isEmpty())
        return fail(ErrorCode::Invalid, "no title");
    return {};
}

/// What files of older versions open as.
class TestProjectMigrations : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void migrationsRunInOrder();
    void terrainsOfVersion1KeepTheirShape();
    void treesOfVersion1LookAsTheyDid();
    void treesOfVersion1StartUnloaded();
    void treesOfVersion3KeepTheirShape();
};

void TestProjectMigrations::terrainsOfVersion1KeepTheirShape()
{
    const QByteArray old =
        R"({"format":"ramure","version":1,"nodes":[{"id":1,"kind":"relief","name":"Hills",)"
        R"("params":{"relief.height":3.5}}]})";
    const auto project = readProject(old);
    QVERIFY(project.has_value());
    QCOMPARE(project->scene.nodes().front().kind, NodeKind::Terrain);
    QCOMPARE(project->scene.nodes().front().params.terrain.height, 3.5);
}

void TestProjectMigrations::migrationsRunInOrder()
{
    const std::array<ProjectMigration, 2> steps{renameName, refuseEmptyTitle};
    QJsonObject old{{"format", "ramure"}, {"version", 1}, {"name", "Oak"}};
    QVERIFY(migrateProject(old, steps));
    QCOMPARE(old.value("title").toString(), "Oak");
    QCOMPARE(old.value("version").toInteger(), 3);
    QJsonObject second{{"format", "ramure"}, {"version", 2}, {"name", "Oak"}};
    QVERIFY(!migrateProject(second, steps)); // the first step is not for it
    QJsonObject newer{{"format", "ramure"}, {"version", 4}};
    QCOMPARE(migrateProject(newer, steps).error().code, ErrorCode::Version);
    QCOMPARE(projectMigrations().size(), std::size_t{projectVersion - 1});
}

void TestProjectMigrations::treesOfVersion1LookAsTheyDid()
{
    const auto variation = [](const char* version, const char* params) {
        const auto project = readProject(QByteArray(R"({"format":"ramure","version":)") + version +
                                         R"(,"nodes":[{"id":1,"kind":"tree","params":{)" + params + "}}]}");
        return project ? project->scene.nodes().front().params.variation : VariationParams{-1, -1, -1};
    };
    const VariationParams none{0.0, 0.0, 0.0};
    const char* byChance = R"("grammar.stochastic":true)";
    QCOMPARE(variation("1", byChance), none);
    QCOMPARE(variation("2", byChance), VariationParams());
    QCOMPARE(variation("1", R"("grammar.seed":7)"), VariationParams()); // nothing varies: the next one may
    for (const char* broken : {"7", "{}", "[7]", R"([{"kind":"tree","params":7}])"}) // left to the reader
        QVERIFY(!readProject(QByteArray(R"({"format":"ramure","version":1,"nodes":)") + broken + "}"));
}

void TestProjectMigrations::treesOfVersion1StartUnloaded()
{
    const QByteArray nodes = R"("nodes":[{"id":1,"kind":"tree"},{"id":2,"kind":"group"},)"
                             R"({"id":3,"kind":"tree","params":{"physics.settled":true}}]})";
    const auto old = readProject(R"({"format":"ramure","version":1,)" + nodes);
    const auto now = readProject(R"({"format":"ramure","version":2,)" + nodes);
    QVERIFY(old && now);
    QVERIFY(!old->scene.find(1)->params.physics.settled);
    QVERIFY(old->scene.find(2)->params.physics.settled); // a group has none
    QVERIFY(old->scene.find(3)->params.physics.settled);
    QVERIFY(now->scene.find(1)->params.physics.settled);
    // Saved and opened again it stays what it was.
    QVERIFY(!readProject(writeProject(*old))->scene.find(1)->params.physics.settled);
}

void TestProjectMigrations::treesOfVersion3KeepTheirShape()
{
    const auto mesh = [](const char* version, const char* params) {
        const auto project = readProject(QByteArray(R"({"format":"ramure","version":)") + version +
                                         R"(,"nodes":[{"id":1,"kind":"tree")" + params + "}]}");
        return project ? project->scene.nodes().front().params.mesh : MeshParams{.leastRadius = -1.0};
    };
    QCOMPARE(mesh("3", "").leastRadius, 0.0);
    QCOMPARE(mesh("3", "").forkLength, 0.0);
    QCOMPARE(mesh("1", R"(,"params":{"grammar.seed":7})").leastRadius, 0.0);
    QCOMPARE(mesh("3", R"(,"params":{"mesh.leastRadius":0.001})").leastRadius, 0.001);
    QCOMPARE(mesh("3", R"(,"params":{"mesh.forkLength":2})").forkLength, 2.0);
    QCOMPARE(mesh("4", ""), MeshParams());
}

RAMURE_SUITE(TestProjectMigrations)

} // namespace tst_project_migrations

#include "tst_project_migrations.moc"
