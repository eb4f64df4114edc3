#include "core/lod/spray_picture.h"

#include "core/surface/foliage/leaf_shapes.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <cmath>
#include <stop_token>

namespace tst_spray_picture {

using namespace ramure;

namespace {

/// Four twigs of one shoot each.
SprayAtlas atlasOf(LeafShape shape, int perShoot)
{
    LeafParams params;
    params.shape = shape;
    params.perShoot = perShoot;
    SprayAtlas atlas;
    atlas.form = leafForm(params);
    for (TriangleMesh& twig : atlas.twigs) {
        twig = leafMesh(atlas.form);
        if (twig.colours.empty())
            twig.colours.assign(twig.triangles.size(), glm::u8vec3(255));
    }
    return atlas;
}

} // namespace

class TestSprayPicture : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void sizesOutsideAreRefused()
    {
        const SprayAtlas atlas = atlasOf(LeafShape::Oak, 3);
        for (const int size : {-1, 0, 63, 65, 96, 8192}) {
            const auto maps = sprayMaps(atlas, size);
            QVERIFY(!maps);
            QCOMPARE(maps.error().code, ErrorCode::Invalid);
        }
        SprayAtlas faithful = atlas;
        faithful.form.shape = LeafShape::Faithful;
        QVERIFY(!sprayMaps(faithful, 128));
    }
    void itCanBeCancelled()
    {
        std::stop_source source;
        source.request_stop();
        const auto maps = sprayMaps(atlasOf(LeafShape::Oak, 3), 128, {source.get_token(), {}});
        QVERIFY(!maps);
        QCOMPARE(maps.error().code, ErrorCode::Cancelled);
    }

    /// Leaves are there, with normals towards the eye; nothing reaches from one cell into another, and the
    /// colour goes on beside the leaves.
    void twigsAreSeen()
    {
        for (const LeafShape shape : {LeafShape::Oak, LeafShape::Maple, LeafShape::Ash, LeafShape::Spruce}) {
            const auto maps = sprayMaps(atlasOf(shape, shape == LeafShape::Spruce ? 1 : 5), 256);
            QVERIFY(maps);
            QCOMPARE(maps->colour.size(), std::size_t(256 * 256));
            const double covered = coverageOfMips(*maps, 0.5f, 1).front();
            QVERIFY2(covered > 0.08 && covered < 0.8, qPrintable(QString::number(covered)));
            for (std::size_t i = 0; i < maps->colour.size(); ++i) {
                QVERIFY(maps->normal[i].z >= 127);
                const glm::u8vec4 pixel = maps->colour[i];
                QVERIFY(pixel.g > 0); // green or brown even where nothing is
                const std::size_t x = i % 128;
                if (x % 64 == 0 || x % 64 == 63)
                    QCOMPARE(int(pixel.a), 0);
            }
        }
    }

    /// From afar as much of the card is opaque as from near by.
    void coverageIsKeptFromAfar()
    {
        for (const LeafShape shape :
             {LeafShape::Oak, LeafShape::Birch, LeafShape::Maple, LeafShape::Willow}) {
            const auto maps = sprayMaps(atlasOf(shape, 6), 512);
            QVERIFY(maps);
            QVERIFY(maps->cutoff >= 0.1f && maps->cutoff <= 0.5f);
            const std::vector<double> near = coverageOfMips(*maps, 0.5f, 1);
            const std::vector<double> mips = coverageOfMips(*maps, maps->cutoff, 4);
            QCOMPARE(mips.size(), std::size_t(4));
            for (const double share : mips)
                QVERIFY2(std::abs(share - near[0]) < 0.1 * near[0],
                         qPrintable(QString("%1 for %2").arg(share).arg(near[0])));
        }
    }

    void theSameAtlasGivesTheSameBytes()
    {
        const SprayAtlas atlas = atlasOf(LeafShape::Linden, 4);
        const auto once = sprayMaps(atlas, 128), again = sprayMaps(atlas, 128);
        QVERIFY(once->colour == again->colour && once->normal == again->normal);
        QCOMPARE(once->cutoff, again->cutoff);
    }
};

RAMURE_SUITE(TestSprayPicture)

} // namespace tst_spray_picture

#include "tst_spray_picture.moc"
