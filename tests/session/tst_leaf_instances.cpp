#include "core/io/copy_list.h"
#include "core/presets/presets.h"
#include "core/qt/session/export/exporter.h"
#include "core/qt/session/motion/sequence.h"
#include "core/surface/mesh/transformed.h"
#include "tests/support/flat_export.h"
#include "tests/support/suite.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <cmath>
#include <limits>
#include <map>

namespace tst_leaf_instances {

using namespace ramure;

namespace {

Node treeOf(const char* preset, NodeId id, std::string name)
{
    Node node;
    node.id = id;
    node.kind = NodeKind::Tree;
    node.name = std::move(name);
    node.params = presetParams(preset).value_or(NodeParams{});
    node.params.physics.windStrength = 3.0;
    return node;
}

QByteArray bytesOf(const std::string& path)
{
    QFile file(QString::fromStdString(path));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// The fields of a line of a table; none of them holds a line break.
QStringList fieldsOf(const QString& line)
{
    QStringList fields{QString()};
    bool isQuoted = false;
    for (qsizetype i = 0; i < line.size(); ++i) {
        const bool isQuote = line[i] == u'"';
        if (isQuote && isQuoted && line.mid(i + 1, 1) == QLatin1String("\""))
            fields.last() += line[++i];
        else if (isQuote)
            isQuoted = !isQuoted;
        else if (line[i] == u',' && !isQuoted)
            fields += QString();
        else
            fields.last() += line[i];
    }
    return fields;
}

using Row = std::map<QString, QString>;

std::vector<Row> rowsOf(const std::string& path)
{
    const QStringList lines = QString::fromUtf8(bytesOf(path)).split(u'\n', Qt::SkipEmptyParts);
    const QStringList names = lines.isEmpty() ? QStringList() : fieldsOf(lines[0]);
    std::vector<Row> rows;
    for (qsizetype i = 1; i < lines.size(); ++i) {
        const QStringList fields = fieldsOf(lines[i]);
        if (fields.size() != names.size())
            qFatal("%s", qPrintable(lines[i]));
        Row& row = rows.emplace_back();
        for (qsizetype k = 0; k < names.size(); ++k)
            row[names[k]] = fields[k];
    }
    return rows;
}

glm::dmat4 matrixOf(const Row& row)
{
    glm::dmat4 matrix(1.0);
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 4; ++c)
            matrix[c][r] = row.at(QStringLiteral("m%1%2").arg(r + 1).arg(c + 1)).toDouble();
    return matrix;
}

/// As it stands in the file, whatever axes that has.
TriangleMesh shapeIn(const std::string& path)
{
    const QByteArray text = bytesOf(path);
    const auto mesh = parseObj({text.constData(), std::size_t(text.size())}, path);
    return mesh ? mesh->joined() : TriangleMesh();
}

double sizeOf(const TriangleMesh& mesh)
{
    float most = 0.0F;
    for (const glm::vec3& at : mesh.positions)
        most = std::max({most, std::abs(at.x), std::abs(at.y), std::abs(at.z)});
    return double(most);
}

/// The largest distance between the vertices of the copies and those of the merged meshes, as a share of
/// their coordinates; infinity where they are not as many.
double distanceFromMerged(const std::string& path, const FlatScene& merged)
{
    const std::string folder = QFileInfo(QString::fromStdString(path)).path().toStdString() + "/";
    std::map<QString, TriangleMesh> shapes;
    std::map<std::string, std::size_t> next;
    std::map<std::string, double> sizes;
    for (const FlatScene::Entry& entry : merged.meshes)
        sizes[entry.name] = sizeOf(*entry.mesh);
    double worst = 0.0;
    for (const Row& row : rowsOf(copyListPath(path))) {
        const QString file = row.at(QStringLiteral("mesh"));
        if (!shapes.contains(file))
            shapes[file] = shapeIn(folder + file.toStdString());
        const std::string object = row.at(QStringLiteral("object")).toStdString();
        const auto found = std::ranges::find(merged.meshes, object, &FlatScene::Entry::name);
        if (found == merged.meshes.end() ||
            found->material.name != row.at(QStringLiteral("material")).toStdString())
            return std::numeric_limits<double>::infinity();
        const glm::dmat4 place = matrixOf(row);
        const double size = sizes[object];
        for (const glm::vec3& at : shapes[file].positions) {
            const std::size_t vertex = next[object]++;
            if (vertex >= found->mesh->positions.size())
                return std::numeric_limits<double>::infinity();
            const glm::dvec3 there(place * glm::dvec4(at, 1.0));
            worst = std::max(worst, glm::distance(there, glm::dvec3(found->mesh->positions[vertex])) / size);
        }
    }
    for (const FlatScene::Entry& entry : merged.meshes)
        if (!entry.name.starts_with("branches") && next[entry.name] != entry.mesh->positions.size())
            return std::numeric_limits<double>::infinity();
    return worst;
}

} // namespace

/// Leaves, fruit and flowers as a table of instances beside the mesh.
class TestLeafInstances : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;
    TreePipeline m_pipeline;

    [[nodiscard]] std::string path(const char* name) const { return m_folder.filePath(name).toStdString(); }
    static ExportOptions listed()
    {
        ExportOptions options;
        options.instances = true;
        options.texture = true;
        options.write.mapSize = 0;
        return options;
    }
    /// Written at a time, and what the merged export has then.
    double deviation(const Scene& scene, double seconds, const ExportOptions& options, const char* name)
    {
        ExportOptions merged = options;
        merged.instances = false;
        Evaluator evaluator(pipelineSource(m_pipeline));
        const auto whole = test::flatExport(evaluator.at(scene, seconds), merged);
        const auto written = exportScene(evaluator.at(scene, seconds), options, path(name));
        if (!whole || !written)
            qFatal("%s", test::why(written).constData());
        return distanceFromMerged(path(name), *whole);
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void whatCannotBeWrittenLeavesNoMesh()
    {
        const auto scene = Scene::fromNodes({treeOf("TinyTree", 1, "Oak")});
        Evaluator evaluator(pipelineSource(m_pipeline));
        const auto missing = exportScene(evaluator.at(*scene), listed(), path("none/a.obj"));
        QVERIFY(!missing && missing.error().code == ErrorCode::Io);
        QVERIFY(QDir(m_folder.path()).mkdir("taken_leaves.csv"));
        const auto taken = exportScene(evaluator.at(*scene), listed(), path("taken.obj"));
        QVERIFY(!taken && taken.error().file == path("taken_leaves.csv"));
        QVERIFY(!QFile::exists(m_folder.filePath("taken.obj")));
        QVERIFY(QFile::link("/dev/full", m_folder.filePath("full_leaves.csv")));
        QVERIFY(!exportScene(evaluator.at(*scene), listed(), path("full.obj")));
        QVERIFY(!QFile::exists(m_folder.filePath("full.obj")));
        std::stop_source stop;
        stop.request_stop();
        const auto cancelled =
            exportScene(evaluator.at(*scene), listed(), path("c.obj"), {stop.get_token(), {}});
        QVERIFY(!cancelled && cancelled.error().code == ErrorCode::Cancelled);
        QVERIFY(!QFile::exists(m_folder.filePath("c_leaves.csv")) &&
                !QFile::exists(m_folder.filePath("c_leaves.json")));
    }

    void placesThatAreNoNumbersAreTold()
    {
        ExportScene scene = sceneOfMeshes({}, leavesMaterial());
        scene.nodes.push_back({"Oak"});
        scene.frames.front().transforms.resize(1);
        ExportCopies leaves{"leaves", "birch", 0, std::make_shared<const TriangleMesh>(), 0, {}};
        leaves.copies.resize(2);
        leaves.copies[1].place[3].x = std::numeric_limits<double>::quiet_NaN();
        scene.copies.push_back(leaves);
        const auto written = writeCopyList(path("nan.obj"), scene, {});
        QVERIFY(!written && written.error().code == ErrorCode::Invalid);
        QVERIFY(!QFile::exists(m_folder.filePath("nan_leaves.csv")));
    }

    void shapesTimesMatricesAreTheMergedMesh_data()
    {
        QTest::addColumn<QByteArray>("preset");
        for (const char* name : {"SmallTree", "FanTree", "TinyTree", "Fern2D"})
            QTest::newRow(name) << QByteArray(name);
    }
    void shapesTimesMatricesAreTheMergedMesh()
    {
        QFETCH(QByteArray, preset);
        Node tree = treeOf(preset.constData(), 1, "Tree");
        tree.params.tree.translation = {3.0, 0.5, -1.0};
        tree.params.tree.scale = {1.0, 1.5, 0.7};
        const auto scene = Scene::fromNodes({tree});
        ExportOptions options = listed();
        for (const double seconds : {0.0, 0.3}) {
            const double worst = deviation(*scene, seconds, options, "tree.obj");
            QVERIFY2(worst < 2e-6, qPrintable(QString::number(worst)));
        }
        options.space = {UpAxis::Z, 1, 1.0};
        options.model = ExportModel::Rough;
        const double rough = deviation(*scene, 0.0, options, "rough.ply");
        QVERIFY2(rough < 2e-6, qPrintable(QString::number(rough)));
    }

    void theMeshHoldsWhatIsNoLeaf()
    {
        const auto scene = Scene::fromNodes({treeOf("TinyTree", 1, "Oak")});
        Evaluator evaluator(pipelineSource(m_pipeline));
        for (const char* name : {"alone.obj", "alone.ply"}) {
            QVERIFY(exportScene(evaluator.at(*scene), listed(), path(name)));
            const auto mesh = readMeshFile(path(name));
            const auto tree = m_pipeline.evaluate(scene->nodes()[0].params);
            QVERIFY(mesh && tree);
            QCOMPARE(mesh->joined().vertexCount(), tree->branches->mesh.vertexCount());
            QCOMPARE(rowsOf(copyListPath(path(name))).size(),
                     tree->foliage->leaves.size() + tree->foliage->apples.size());
        }
    }

    void coloursAreThoseOfTheMergedMesh()
    {
        const auto scene = Scene::fromNodes({treeOf("TinyTree", 1, "Oak")});
        Evaluator evaluator(pipelineSource(m_pipeline));
        const auto listedScene = collectExport(evaluator.at(*scene), listed());
        const auto merged = test::flatExport(evaluator.at(*scene), {});
        QVERIFY(listedScene && merged && !listedScene->copies.empty());
        const ExportCopies& leaves = listedScene->copies[0];
        const auto all = std::ranges::find(merged->meshes, leaves.name, &FlatScene::Entry::name);
        const std::size_t faces = leaves.shape->triangles.size();
        for (std::size_t i = 0; i < leaves.copies.size(); ++i)
            for (std::size_t f = 0; f < faces; ++f)
                QCOMPARE(all->mesh->colours[i * faces + f],
                         glm::u8vec3(leaves.copies[i].tint * glm::vec3(leaves.shape->colours[f]) + 0.5F));
    }

    /// Trees of one kind share its file where the shape is the same; names of any kind stay readable.
    void severalTreesShareTheirShapes()
    {
        Node other = treeOf("TinyTree", 3, "Wide, \"odd\"");
        other.params.leaf.width = 1.4;
        other.params.tree.translation.x = 4.0;
        const auto scene =
            Scene::fromNodes({treeOf("TinyTree", 1, "Oak"), treeOf("TinyTree", 2, "Oak"), other});
        QVERIFY(deviation(*scene, 0.0, listed(), "several.obj") < 2e-6);
        std::map<QString, QString> meshes;
        for (const Row& row : rowsOf(copyListPath(path("several.obj"))))
            meshes[row.at(QStringLiteral("object")) + row.at(QStringLiteral("node"))] =
                row.at(QStringLiteral("mesh"));
        QCOMPARE(meshes.at("leaves_1Oak"), meshes.at("leaves_2Oak"));
        QCOMPARE(meshes.at("leaves_3Wide, \"odd\""), QStringLiteral("several_leaves_oak_2.obj"));
        QCOMPARE(meshes.at("fruit_1Oak"), meshes.at("fruit_3Wide, \"odd\""));
    }

    void jsonSaysTheSameAsTheTable()
    {
        Node tree = treeOf("TinyTree", 1, "Wide, \"odd\"\t\\");
        tree.params.tree.translation.x = 4.0;
        const auto scene = Scene::fromNodes({tree});
        Evaluator evaluator(pipelineSource(m_pipeline));
        QVERIFY(exportScene(evaluator.at(*scene), listed(), path("j.obj")));
        QJsonParseError problem;
        const QJsonDocument json =
            QJsonDocument::fromJson(bytesOf(copyListPath(path("j.obj"), ".json")), &problem);
        QCOMPARE(problem.error, QJsonParseError::NoError);
        const std::vector<Row> rows = rowsOf(copyListPath(path("j.obj")));
        std::size_t at = 0;
        for (const QJsonValue object : json["objects"].toArray())
            for (const QJsonValue each : object["instances"].toArray()) {
                QVERIFY(at < rows.size());
                const Row& row = rows[at++];
                for (const char* key : {"node", "object", "kind", "mesh", "material"})
                    QCOMPARE(object[key].toString(), row.at(key));
                QCOMPARE(each["address"].toString(), row.at("address"));
                for (const char* key : {"branch", "number"})
                    QCOMPARE(each[key].toInteger(), row.at(key).toLongLong());
                const glm::dmat4 matrix = matrixOf(row);
                for (int i = 0; i < 12; ++i)
                    QCOMPARE(each["matrix"][i].toDouble(), matrix[i % 4][i / 4]);
                QCOMPARE(each["colour"][1].toDouble(), row.at("green").toDouble());
            }
        QVERIFY(at > 0 && at == rows.size());
    }

    void everyFrameOfASequenceHasItsList()
    {
        const auto scene = Scene::fromNodes({treeOf("TinyTree", 1, "Oak")});
        QVERIFY(exportSequence(*scene, listed(), {0, 24, 24}, pipelineSource(m_pipeline), path("s.ply")));
        const QByteArray first = bytesOf(path("s_0000_leaves.csv")),
                         last = bytesOf(path("s_0024_leaves.csv"));
        QVERIFY(!first.isEmpty() && first.count('\n') == last.count('\n') && first != last);
        QVERIFY(last.contains(",s_0024_leaves_oak.obj,"));
        QVERIFY(estimatedFileBytes(*scene, listed(), pipelineSource(m_pipeline), path("s.ply")) <
                estimatedFileBytes(*scene, {}, pipelineSource(m_pipeline), path("s.ply")) / 2);
    }
};

RAMURE_SUITE(TestLeafInstances)

} // namespace tst_leaf_instances

#include "tst_leaf_instances.moc"
