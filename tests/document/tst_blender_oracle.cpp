// Headless Blender says what it makes of a scene; the exported files must give the same. Skipped where there
// is no Blender.
#include "core/io/formats/text/blender_scene.h"
#include "core/io/mesh_file.h"
#include "core/scene/world_transforms.h"
#include "core/surface/bark/bark_maps.h"
#include "tests/support/cannot_run.h"
#include "tests/support/suite.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>

namespace tst_blender_oracle {

using namespace ramure;

class TestBlenderOracle : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;
    QJsonObject m_oracle;
    QByteArray m_said;

private slots:
    void initTestCase()
    {
        const QString blender = QStandardPaths::findExecutable(QStringLiteral("blender"));
        if (blender.isEmpty())
            RAMURE_CANNOT_RUN(
                "no Blender on this machine (Debian: apt-get install blender): nothing to compare with");
        QProcess process;
        process.setProcessChannelMode(QProcess::MergedChannels);
        process.start(blender,
                      {QStringLiteral("-b"), QStringLiteral("--factory-startup"), QStringLiteral("--python"),
                       QStringLiteral(RAMURE_TEST_DATA "/blender_oracle.py"), QStringLiteral("--python"),
                       QStringLiteral(RAMURE_SOURCE_DIR "/resources/blender/ramure_export.py"),
                       QStringLiteral("--"), m_folder.path()});
        QVERIFY(process.waitForFinished(300'000));
        m_said = process.readAll();
        QFile file(m_folder.filePath(QStringLiteral("oracle.json")));
        QVERIFY2(file.open(QIODevice::ReadOnly), m_said.constData());
        m_oracle = QJsonDocument::fromJson(file.readAll()).object();
    }
    void init() { test::failOnAnyWarning(); }

    void theScriptChecksItself()
    {
        QVERIFY2(m_said.contains("largest deviation from Blender"), m_said.constData());
        QVERIFY2(!m_said.contains("more than"), m_said.constData());
        QVERIFY2(m_said.contains("Angles: a key for every frame"), m_said.constData());
        QVERIFY2(m_said.contains("Spring: a key for every frame"), m_said.constData());
        QVERIFY2(!m_said.contains("Swinging: a key for every frame"), m_said.constData());
    }
    void everyNodeIsWhereBlenderHasIt()
    {
        const auto imported = importBlender(m_folder.path().toStdString());
        QVERIFY2(imported, test::why(imported));
        const auto scene = Scene::fromNodes(imported->nodes);
        QVERIFY2(scene, test::why(scene));
        const QJsonArray places = m_oracle.value(QStringLiteral("places")).toArray();
        QCOMPARE(places.size(), 50);
        double worst = 0.0;
        QString where;
        for (const QJsonValue& entry : places) {
            const double seconds = entry[QStringLiteral("seconds")].toDouble();
            const QJsonObject nodes = entry[QStringLiteral("nodes")].toObject();
            QCOMPARE(nodes.size(), 8);
            for (const Node& node : scene->nodes()) {
                const QString name = QString::fromStdString(node.name);
                if (!nodes.contains(name))
                    continue; // the group of all
                const QJsonArray expected = nodes.value(name).toArray();
                const glm::dmat4 world = worldTransformAt(*scene, node.id, seconds).world;
                for (int i = 0; i < 16; ++i)
                    if (const double off = std::abs(world[i % 4][i / 4] - expected[i].toDouble());
                        off > worst) {
                        worst = off;
                        where = QStringLiteral("%1 at %2 s: %3").arg(name).arg(seconds).arg(off);
                    }
            }
        }
        QVERIFY2(worst < 1e-4, qPrintable(where));
    }
    void clampedHandlesAreBlenders()
    {
        const QJsonArray curves = m_oracle.value(QStringLiteral("curves")).toArray();
        QCOMPARE(curves.size(), 60);
        double worst = 0.0;
        for (const QJsonValue& curve : curves) {
            std::vector<Key> keys;
            double low = 1e9, high = -1e9;
            for (const QJsonValue& point : curve[QStringLiteral("keys")].toArray()) {
                Key key;
                key.time = ticksOf(point[0].toDouble()); // a frame is a second
                key.value = point[1].toDouble();
                low = std::min(low, key.value);
                high = std::max(high, key.value);
                keys.push_back(key);
            }
            const auto track = Track::fromKeys(keys);
            QVERIFY2(track, test::why(track));
            for (const QJsonValue& sample : curve[QStringLiteral("samples")].toArray()) {
                const double off = std::abs(valueAt(*track, sample[0].toDouble()) - sample[1].toDouble());
                worst = std::max(worst, off / std::max(high - low, 1e-3));
            }
        }
        QVERIFY2(worst < 1e-3, qPrintable(QString::number(worst))); // 0.1 % of the range
    }
    /// The pictures of a bark are read, and stand where they belong.
    void anExportedBarkIsMadeOfItsPictures()
    {
        TriangleMesh mesh;
        mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
        mesh.triangles = {{0, 1, 2}};
        mesh.uv = {{0, 0}, {1, 0}, {1, 1}};
        BarkParams bark;
        bark.family = BarkFamily::Furrowed;
        const MeshPart part{"branches", &mesh, barkMaterial(bark)};
        WriteOptions options;
        options.mapSize = 32;
        const QString obj = m_folder.filePath(QStringLiteral("bark.obj")),
                      said = m_folder.filePath(QStringLiteral("bark.json"));
        QVERIFY(writeObj(obj.toStdString(), {&part, 1}, {}, options));
        QProcess process;
        process.setProcessChannelMode(QProcess::MergedChannels);
        process.start(QStringLiteral("blender"),
                      {QStringLiteral("-b"), QStringLiteral("--factory-startup"), QStringLiteral("--python"),
                       QStringLiteral(RAMURE_TEST_DATA "/blender_materials.py"), QStringLiteral("--"), obj,
                       said});
        QVERIFY(process.waitForFinished(120'000));
        QFile file(said);
        QVERIFY2(file.open(QIODevice::ReadOnly), process.readAll().constData());
        const QJsonObject material = QJsonDocument::fromJson(file.readAll()).object();
        QCOMPARE(material.value(QStringLiteral("name")).toString(), QStringLiteral("bark_furrowed"));
        const QJsonObject links = material.value(QStringLiteral("links")).toObject();
        const QJsonObject colour = links.value(QStringLiteral("BSDF_PRINCIPLED Base Color")).toObject(),
                          normal = links.value(QStringLiteral("NORMAL_MAP Color")).toObject();
        QCOMPARE(links.value(QStringLiteral("BSDF_PRINCIPLED Normal"))[QStringLiteral("from")].toString(),
                 QStringLiteral("NORMAL_MAP"));
        for (const QJsonObject& picture : {colour, normal}) {
            QCOMPARE(picture.value(QStringLiteral("size")).toArray(), (QJsonArray{32, 32}));
            QVERIFY(picture.value(QStringLiteral("hasData")).toBool());
        }
        QCOMPARE(colour.value(QStringLiteral("space")).toString(), QStringLiteral("sRGB"));
        // Blender's rows go up as the bark's do.
        const BarkMaps maps = *barkMaps(bark, 32);
        const QJsonArray lowest = colour.value(QStringLiteral("lowest")).toArray();
        for (int c = 0; c < 3; ++c)
            QVERIFY(std::abs(lowest[c].toDouble() - maps.colour[0][c] / 255.0) < 0.003);
    }
};

RAMURE_SUITE(TestBlenderOracle)

} // namespace tst_blender_oracle

#include "tst_blender_oracle.moc"
