#include "core/io/formats/file_format.h"
#include "core/io/formats/text/blender_scene.h"
#include "tests/support/suite.h"
#include <QTemporaryDir>
#include <set>

namespace ramure {

extern const FileFormat objFormat, plyFormat, plyTextFormat;

static Expected<ReadMesh> readFake(const std::string& path, const Progress&)
{
    ReadMesh mesh;
    mesh.objects.push_back({path, {}, {}});
    mesh.objects[0].mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.objects[0].mesh.triangles = {{0, 1, 2}};
    return mesh;
}

static Expected<void> writeFake(const std::string&, const ExportScene&, const WriteOptions& options,
                                const Progress&)
{
    return options.ascii ? fail(ErrorCode::Invalid, "written") : Expected<void>();
}

static const FileFormat fake = {
    .id = "fake", .ending = "fake", .read = &readFake, .import = &importBlender, .write = &writeFake};

/// In the place of the program's own table: a row more.
std::span<const FileFormat* const> fileFormats()
{
    static constexpr const FileFormat* table[] = {&objFormat, &plyFormat, &plyTextFormat, &fake};
    return table;
}

} // namespace ramure

using namespace ramure;

class TestFileFormat : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void unknownEndings_data()
    {
        QTest::addColumn<QString>("path");
        for (const char* path : {"", "obj", "a.obj/b", "a.stl", ".", "a."})
            QTest::newRow(path) << path;
    }
    void unknownEndings()
    {
        QFETCH(const QString, path);
        const auto found = findFormat(path.toStdString(), FormatUse::Write);
        QVERIFY(!found);
        QCOMPARE(found.error().code, ErrorCode::Unknown);
        QVERIFY(found.error().message().find(".obj, .ply, .fake") != std::string::npos);
        QVERIFY(!importObjects(path.toStdString()));
    }
    void endingsAndTheFormOfText()
    {
        QCOMPARE(endingOf("a.b/Tree.OBJ"), std::string("obj"));
        QCOMPARE(*findFormat("a.PLY", FormatUse::Write), &plyFormat);
        QCOMPARE(*findFormat("a.ply", FormatUse::Write, true), &plyTextFormat);
        QCOMPARE(*findFormat("a.obj", FormatUse::Write, true), &objFormat);
        QCOMPARE(endingList(FormatUse::Import, "*.", " "), std::string("*.obj *.ply *.fake"));
    }
    void idsAreUnlike()
    {
        std::set<std::string> ids;
        for (const FileFormat* format : fileFormats()) {
            QVERIFY2(ids.insert(format->id).second, format->id);
            QCOMPARE(format->write != nullptr && format->rates == nullptr, format == &fake);
        }
    }
    void aRowIsReadImportedAndWritten()
    {
        QTemporaryDir folder;
        const std::string path = folder.filePath(QStringLiteral("a.FAKE")).toStdString();
        const auto mesh = readMeshFile(path);
        QVERIFY(mesh && mesh->objects[0].name == path);
        const auto nodes = importObjects(path);
        QVERIFY(nodes);
        QCOMPARE(nodes->nodes[0].mesh->triangles.size(), std::size_t(1));
        QVERIFY((*findFormat(path, FormatUse::Write))->write(path, {}, {}, {}));
        QVERIFY(!(*findFormat(path, FormatUse::Write))->write(path, {}, {true, {}}, {}));
    }
};

QTEST_GUILESS_MAIN(TestFileFormat)
#include "tst_file_format.moc"
