#include "core/io/formats/file_format.h"
#include "core/io/zip_file.h"
#include "core/surface/proof/validate.h"
#include "tests/core/io/io_support.h"
#include <QTemporaryDir>
#include <glm/geometric.hpp>

namespace tst_three_mf_format {

using namespace ramure;

namespace {

const std::string modelHead =
    "<model unit=\"millimeter\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/"
    "core/2015/02\"><resources>";
const std::string solid =
    "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"10\" y=\"0\" z=\"0\"/>"
    "<vertex x=\"0\" y=\"1e1\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\" +10\"/></vertices><triangles>"
    "<triangle v1=\"0\" v2=\"2\" v3=\"1\"/><triangle v1=\"0\" v2=\"1\" v3=\"3\"/>"
    "<triangle v1=\"0\" v2=\"3\" v3=\"2\"/><triangle v1=\"1\" v2=\"2\" v3=\"3\"/></triangles></mesh>";
const std::string object = "<object id=\"1\">" + solid + "</object>";

std::string model(const std::string& objects, const std::string& items)
{
    return modelHead + objects + "</resources><build>" + items + "</build></model>";
}

} // namespace

class TestThreeMfFormat : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;

    std::string path(const char* name = "t.3mf") const { return m_folder.filePath(name).toStdString(); }
    Expected<ReadMesh> read(const std::string& text, const char* part = "3D/3dmodel.model",
                            const std::string& relations = {}) const
    {
        std::vector<ZipEntry> entries{{part, text, true}};
        if (!relations.empty())
            entries.push_back({"_rels/.rels", relations, true});
        if (!writeZip(path(), entries))
            qFatal("no archive");
        return readMeshFile(path());
    }
    Expected<void> write(const ExportScene& scene, const std::string& file, const WriteOptions& options = {},
                         const Progress& progress = {}) const
    {
        return (*findFormat(file, FormatUse::Write))->write(file, scene, options, progress);
    }
    static ExportScene sceneOf(const TriangleMesh& mesh, const std::string& name = "thing")
    {
        return sceneOfMeshes({{name, mesh, {}}}, barkMaterial());
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void brokenModels_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("message");
        const auto row = [](const char* name, const std::string& text, const char* message) {
            QTest::newRow(name) << QString::fromStdString(text) << message;
        };
        row("empty", "", "the XML is broken or cut off (no element found)");
        row("prose", "once upon", "the XML is broken or cut off (syntax error)");
        row("cut off", modelHead + object, "the XML is broken or cut off (no element found)");
        row("laughs", "<!DOCTYPE m [<!ENTITY a \"b\">]>" + model(object, "<item objectid=\"1\"/>"),
            "a document type has no place in a 3MF file");
        row("no mesh", model("", ""), "the file holds no mesh to print");
        row("nothing built", model(object, ""), "the file holds no mesh to print");
        row("no object", model(object, "<item objectid=\"2\"/>"), "there is no object 2");
        row("no number", model(object, "<item/>"), "an object without a number, or a broken matrix");
        row("matrix", model(object, "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 0 0\"/>"),
            "an object without a number, or a broken matrix");
        row("elsewhere", model(object, "<item objectid=\"1\" p:path=\"/3D/b.model\"/>"),
            "objects that stand in another part of the archive are not read");
        row("index",
            model("<object id=\"1\"><mesh><vertices/><triangles><triangle v1=\"0\" v2=\"1\" "
                  "v3=\"2\"/></triangles></mesh></object>",
                  ""),
            "a triangle with a vertex that does not exist");
        row("vertex", model("<object id=\"1\"><mesh><vertices><vertex x=\"a\" y=\"0\" z=\"0\"/>", ""),
            "a vertex without three finite numbers");
        row("infinite", model("<object id=\"1\"><mesh><vertices><vertex x=\"inf\" y=\"0\" z=\"0\"/>", ""),
            "a vertex without three finite numbers");
        row("circle",
            model("<object id=\"1\"><components><component objectid=\"1\"/></components></object>",
                  "<item objectid=\"1\"/>"),
            "components of components without an end");
    }
    void brokenModels()
    {
        QFETCH(const QString, text);
        QFETCH(const QString, message);
        const auto mesh = read(text.toStdString());
        QVERIFY(!mesh);
        QCOMPARE(QString::fromStdString(mesh.error().plain()), message);
        QCOMPARE(mesh.error().file, path());
    }
    /// Each doubles the one before: a million copies out of twenty lines.
    void componentsThatExplode()
    {
        std::string objects = object;
        for (int i = 2; i < 34; ++i) {
            const std::string before = "<component objectid=\"" + std::to_string(i - 1) + "\"/>";
            std::string row = "<object id=\"" + std::to_string(i) + "\"><components>";
            for (int k = 0; k < 40; ++k)
                row += before;
            objects += row + "</components></object>";
        }
        const auto mesh = read(model(objects, "<item objectid=\"33\"/>"));
        QVERIFY(!mesh);
        QCOMPARE(mesh.error().code, ErrorCode::Limit);
    }
    void archiveThatUnpacksToTooMuch()
    {
        const auto mesh = read(std::string(std::size_t(64) << 20, ' '));
        QVERIFY(!mesh);
        QCOMPARE(mesh.error().code, ErrorCode::Limit);
    }
    void noArchive()
    {
        test::writeBytes(QString::fromStdString(path()), "PK but no more");
        QCOMPARE(readMeshFile(path()).error().code, ErrorCode::Syntax);
        QCOMPARE(readMeshFile(path("missing.3mf")).error().code, ErrorCode::Io);
        QVERIFY(!read("", "3D/other.model"));
    }
    void nothingIsWrittenInPart()
    {
        QVERIFY(write(sceneOf(test::tetrahedron()), path()));
        const QByteArray before = test::fileBytes(QString::fromStdString(path()));
        TriangleMesh mesh = test::tetrahedron();
        mesh.positions[2].y = std::numeric_limits<float>::infinity();
        QCOMPARE(write(sceneOf(mesh), path()).error().code, ErrorCode::Invalid);
        std::stop_source stop;
        stop.request_stop();
        QCOMPARE(write(sceneOf(test::tetrahedron()), path(), {}, {stop.get_token(), {}}).error().code,
                 ErrorCode::Cancelled);
        QCOMPARE(test::fileBytes(QString::fromStdString(path())), before);
        QCOMPARE(write(sceneOf(test::tetrahedron()), path("missing/t.3mf")).error().code, ErrorCode::Io);
    }
    void unitAndPlace()
    {
        const auto mesh =
            read(model(object, "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 0 0 20\"/>"));
        QVERIFY2(mesh, test::why(mesh));
        QCOMPARE(mesh->objects.size(), std::size_t(1));
        // 10 mm along z, moved up by 20: in the program y is up, in metres.
        QVERIFY(glm::distance(mesh->objects[0].mesh.positions[3], glm::vec3(0.0F, 0.03F, 0.0F)) < 1e-7F);
        const auto report = validateMesh(mesh->objects[0].mesh);
        QVERIFY(report && report->valid);
    }
    void componentsAndRelations()
    {
        const std::string relations =
            "<Relationships><Relationship Target=\"/3D/other.model\" "
            "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>";
        const auto mesh =
            read(model(object + "<object id=\"2\" name=\"two\"><components><component objectid=\"1\"/>"
                                "<component objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 50 0 0\"/>"
                                "</components></object>",
                       "<item objectid=\"2\"/>"),
                 "3D/other.model", relations);
        QVERIFY2(mesh, test::why(mesh));
        QCOMPARE(mesh->objects.size(), std::size_t(2));
        QVERIFY(glm::distance(mesh->objects[1].mesh.positions[1], glm::vec3(0.06F, 0.0F, 0.0F)) < 1e-7F);
    }
    void thereAndBack_data()
    {
        QTest::addColumn<int>("unit");
        for (int unit = 0; unit < int(std::size(lengthUnits)); ++unit)
            QTest::newRow(lengthUnits[unit].name) << unit;
    }
    void thereAndBack()
    {
        QFETCH(const int, unit);
        ExportScene scene = sceneOf(test::tetrahedron(), "a <\"&> b");
        scene.space.up = UpAxis::Z;
        scene.space.unit = std::size_t(unit);
        WriteOptions options;
        options.comment = scene.space.comment();
        const auto written = write(scene, path(), options);
        if (lengthUnits[unit].name == std::string("km")) {
            QVERIFY(!written);
            QCOMPARE(written.error().code, ErrorCode::Invalid);
            return;
        }
        QVERIFY2(written, test::why(written));
        const QByteArray bytes = test::fileBytes(QString::fromStdString(path()));
        QVERIFY(write(scene, path("again.3mf"), options));
        QCOMPARE(test::fileBytes(QString::fromStdString(path("again.3mf"))), bytes);
        auto back = readMeshFile(path());
        QVERIFY2(back, test::why(back));
        QCOMPARE(back->objects[0].name, std::string("a <\"&> b"));
        QVERIFY(glm::distance(back->objects[0].mesh.positions[3], glm::vec3(0, 0, 1)) < 1e-6F);
        // Without our comment the unit of the model says the same.
        QVERIFY(write(scene, path()));
        back = readMeshFile(path());
        QVERIFY2(back, test::why(back));
        QVERIFY(glm::distance(back->objects[0].mesh.positions[3], glm::vec3(0, 0, 1)) < 1e-6F);
    }
    void foldedTrianglesStayOut()
    {
        TriangleMesh mesh = test::tetrahedron();
        mesh.triangles.emplace_back(1, 1, 2);
        QVERIFY(write(sceneOf(mesh), path()));
        const auto back = readMeshFile(path());
        QVERIFY2(back, test::why(back));
        QCOMPARE(back->objects[0].mesh.triangles.size(), std::size_t(4));
    }
};

RAMURE_SUITE(TestThreeMfFormat)

} // namespace tst_three_mf_format

#include "tst_three_mf_format.moc"
