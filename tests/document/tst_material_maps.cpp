#include "core/io/material_maps.h"
#include "core/io/mesh_file.h"
#include "core/surface/bark/bark_maps.h"
#include "tests/core/io/io_support.h"
#include <QDir>
#include <QImage>
#include <QTemporaryDir>
#include <set>

namespace tst_material_maps {

using namespace ramure;

/// Read back by Qt.
class TestMaterialMaps : public QObject
{
    Q_OBJECT

    static BarkParams furrowed()
    {
        BarkParams bark;
        bark.family = BarkFamily::Furrowed;
        return bark;
    }
    static QString nameOf(const BarkParams& bark, int size, MaterialMap map)
    {
        return QString::fromStdString(mapFileName(bark, size, map));
    }
    static QStringList filesIn(const QString& folder) { return QDir(folder).entryList(QDir::Files); }
    /// A square with texture coordinates.
    static TriangleMesh square()
    {
        TriangleMesh mesh;
        mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
        mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
        mesh.uv = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        return mesh;
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void whatCannotBeWrittenIsAnError()
    {
        const QTemporaryDir folder;
        const std::string path = folder.path().toStdString();
        QCOMPARE(writeMaps(path, {}, 64).error().code, ErrorCode::Invalid); // plain
        QCOMPARE(writeMaps(path, furrowed(), 1).error().code, ErrorCode::Limit);
        std::stop_source stop;
        stop.request_stop();
        QCOMPARE(writeMaps(path, furrowed(), 64, {stop.get_token(), {}}).error().code, ErrorCode::Cancelled);
        QCOMPARE(filesIn(folder.path()), QStringList());
        const auto nowhere = writeMaps(path + "/none", furrowed(), 64);
        QCOMPARE(nowhere.error().code, ErrorCode::Io);
        QVERIFY(nowhere.error().file.starts_with(path + "/none/bark_furrowed_"));
    }
    void everythingThatAPictureHangsOnIsInItsName()
    {
        BarkParams other[6];
        for (BarkParams& bark : other)
            bark = furrowed();
        other[1].family = BarkFamily::Smooth;
        other[2].depth = 1.5;
        other[3].light = 0.1;
        other[4].moss = 0.2;
        other[5].seed = 2;
        std::set<QString> names;
        for (const BarkParams& bark : other)
            for (const int size : {64, 128})
                for (std::size_t map = 0; map < mapNames.size(); ++map)
                    names.insert(nameOf(bark, size, static_cast<MaterialMap>(map)));
        QCOMPARE(names.size(), std::size_t(6 * 2 * 5));
    }
    void picturesAreThoseOfTheBark()
    {
        const QTemporaryDir folder;
        const auto written = writeMaps(folder.path().toStdString(), furrowed(), 64);
        QVERIFY2(written, test::why(written));
        QCOMPARE(written->size(), mapNames.size());
        const BarkMaps maps = *barkMaps(furrowed(), 64);
        const auto picture = [&](MaterialMap map) {
            return QImage(folder.filePath(nameOf(furrowed(), 64, map)));
        };
        const QImage colour = picture(MaterialMap::Colour), normal = picture(MaterialMap::Normal);
        const QImage grey[] = {picture(MaterialMap::Height), picture(MaterialMap::Occlusion),
                               picture(MaterialMap::Roughness)};
        const std::vector<std::uint8_t>* values[] = {&maps.height, &maps.occlusion, &maps.roughness};
        QCOMPARE(colour.size(), QSize(64, 64));
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) {
                const auto i = std::size_t(64 * y + x);
                const int row = 63 - y; // the lowest row of a bark is the last one of a file
                QCOMPARE(colour.pixel(x, row), qRgb(maps.colour[i].x, maps.colour[i].y, maps.colour[i].z));
                QCOMPARE(normal.pixel(x, row), qRgb(maps.normal[i].x, maps.normal[i].y, maps.normal[i].z));
                for (int g = 0; g < 3; ++g)
                    QCOMPARE(qRed(grey[g].pixel(x, row)), int((*values[g])[i]));
            }
    }
    void whatIsThereStays()
    {
        const QTemporaryDir folder;
        const std::string path = folder.path().toStdString();
        QVERIFY(writeMaps(path, furrowed(), 32));
        const QString painted = folder.filePath(nameOf(furrowed(), 32, MaterialMap::Colour));
        test::writeBytes(painted, "painted over");
        QCOMPARE(writeMaps(path, furrowed(), 32)->size(), std::size_t(0));
        QVERIFY(QFile::remove(folder.filePath(nameOf(furrowed(), 32, MaterialMap::Height))));
        QCOMPARE(*writeMaps(path, furrowed(), 32),
                 std::vector<std::string>{mapFileName(furrowed(), 32, MaterialMap::Height)});
        QCOMPARE(test::fileBytes(painted), QByteArray("painted over"));
    }
    /// The second time they come from those that are kept: the same bytes, and of nothing that is like them.
    void keptPicturesAreThoseOfTheSameValues()
    {
        constexpr std::array kinds{MaterialMap::Colour, MaterialMap::Occlusion};
        constexpr std::array others{MaterialMap::Occlusion, MaterialMap::Colour};
        const auto bytes = [](const BarkParams& bark, int size, std::span<const MaterialMap> which) {
            std::vector<std::string> out;
            const auto maps = makeMaps(bark, size, which);
            for (const MadeMap& made : *maps)
                out.push_back(made.png);
            return out;
        };
        const auto first = bytes(furrowed(), 64, kinds);
        std::vector<std::vector<std::string>> all{first};
        for (const auto& [member, value] :
             {std::pair(&BarkParams::depth, 1.5), {&BarkParams::light, 0.25}, {&BarkParams::moss, 0.5}}) {
            BarkParams other = furrowed();
            other.*member = value;
            all.push_back(bytes(other, 64, kinds));
        }
        BarkParams other = furrowed();
        other.seed = 2;
        all.push_back(bytes(other, 64, kinds));
        all.push_back(bytes(furrowed(), 128, kinds));
        all.push_back(bytes(furrowed(), 64, others));
        QCOMPARE(std::set(all.begin(), all.end()).size(), all.size());
        QVERIFY(bytes(furrowed(), 64, kinds) == first);
        QVERIFY(!makeMaps(furrowed(), 1, kinds)); // what failed is not kept
        QVERIFY(!makeMaps(furrowed(), 1, kinds));
        // A leaf's colours in summer are not those of autumn.
        const QTemporaryDir summer, autumn;
        QVERIFY(writeMaps(summer.path().toStdString(), LeafShape::Oak, 64));
        QVERIFY(writeMaps(autumn.path().toStdString(), LeafShape::Oak, 64, 0.8));
        const auto colour = [](const QTemporaryDir& folder, double season) {
            return test::fileBytes(folder.filePath(
                QString::fromStdString(mapFileName(LeafShape::Oak, 64, MaterialMap::Colour, season))));
        };
        QVERIFY(!colour(summer, 0.0).isEmpty() && !colour(autumn, 0.8).isEmpty());
        QVERIFY(colour(summer, 0.0) != colour(autumn, 0.8));
    }
    void anObjNamesThePicturesBesideIt()
    {
        const QTemporaryDir folder;
        const TriangleMesh mesh = square();
        const MeshPart part{"branches", &mesh, barkMaterial(furrowed())};
        WriteOptions options;
        options.mapSize = 32;
        const auto written = writeObj(folder.filePath("oak.obj").toStdString(), {&part, 1}, {}, options);
        QVERIFY2(written, test::why(written));
        QCOMPARE(filesIn(folder.path()).size(), 2 + int(mapNames.size()));
        const QByteArray materials = test::fileBytes(folder.filePath("oak.mtl"));
        QVERIFY2(materials.contains("newmtl bark_furrowed\nKd 1 1 1\n"), materials.constData());
        int named = 0;
        for (const QByteArray& line : materials.split('\n'))
            if (line.endsWith(".png")) {
                ++named;
                QVERIFY2(QFile::exists(folder.filePath(QString::fromUtf8(line.mid(line.indexOf(' ') + 1)))),
                         line.constData());
            }
        QCOMPARE(named, 6);
        // Reading it again says that the picture is left out.
        const auto back = readMeshFile(folder.filePath("oak.obj").toStdString());
        QVERIFY2(back, test::why(back));
        QCOMPARE(back->notes.size(), std::size_t(1));
        QVERIFY2(back->notes[0].find("map_Kd") == std::string::npos &&
                     back->notes[0].find("_colour.png\" is not read") != std::string::npos,
                 back->notes[0].c_str());
    }
    void makingPicturesIsPartOfTheProgress()
    {
        const QTemporaryDir folder;
        const TriangleMesh mesh = square();
        const MeshPart part{"branches", &mesh, barkMaterial(furrowed())};
        std::vector<double> told;
        WriteOptions options;
        options.mapSize = 128;
        QVERIFY(writeObj(folder.filePath("oak.obj").toStdString(), {&part, 1},
                         {{}, [&told](double fraction) { told.push_back(fraction); }}, options));
        QVERIFY(std::ranges::is_sorted(told));
        QVERIFY(std::ranges::count_if(told, [](double f) { return f > 0.5 && f < 1.0; }) >= 3);
        QCOMPARE(told.back(), 1.0);
    }
    void withoutCoordinatesOrWishThereAreNone_data()
    {
        QTest::addColumn<bool>("hasCoordinates");
        QTest::addColumn<int>("size");
        QTest::addRow("no coordinates") << false << 32;
        QTest::addRow("not wanted") << true << 0;
    }
    void withoutCoordinatesOrWishThereAreNone()
    {
        QFETCH(const bool, hasCoordinates);
        QFETCH(const int, size);
        const QTemporaryDir folder;
        TriangleMesh mesh = square();
        if (!hasCoordinates)
            mesh.uv.clear();
        const MeshPart part{"branches", &mesh, barkMaterial(furrowed())};
        WriteOptions options;
        options.mapSize = size;
        QVERIFY(writeObj(folder.filePath("oak.obj").toStdString(), {&part, 1}, {}, options));
        QCOMPARE(filesIn(folder.path()), (QStringList{"oak.mtl", "oak.obj"}));
        const QByteArray materials = test::fileBytes(folder.filePath("oak.mtl"));
        QVERIFY(!materials.contains("map_"));
        QVERIFY(!materials.contains("Kd 1 1 1"));
    }
    void aFailingPictureLeavesTheOldFiles()
    {
        const QTemporaryDir folder;
        test::writeBytes(folder.filePath("oak.obj"), "old");
        const TriangleMesh mesh = square();
        const MeshPart part{"branches", &mesh, barkMaterial(furrowed())};
        WriteOptions options;
        options.mapSize = 1; // too small
        QCOMPARE(writeObj(folder.filePath("oak.obj").toStdString(), {&part, 1}, {}, options).error().code,
                 ErrorCode::Limit);
        QCOMPARE(test::fileBytes(folder.filePath("oak.obj")), QByteArray("old"));
        QCOMPARE(filesIn(folder.path()), QStringList{"oak.obj"});
    }
};

RAMURE_SUITE(TestMaterialMaps)

} // namespace tst_material_maps

#include "tst_material_maps.moc"
