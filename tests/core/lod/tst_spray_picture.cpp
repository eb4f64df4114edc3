#include "core/lod/spray_picture.h"

#include "core/lod/mip_coverage.h"
#include "core/math/box.h"
#include "core/surface/foliage/leaf_shapes.h"
#include "core/surface/foliage/leaf_table.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <cmath>
#include <stop_token>

namespace tst_spray_picture {

using namespace ramure;

namespace {

/// A card of one shoot, as it lies, in each quarter of the picture.
CardAtlas atlasOf(LeafShape shape, int perShoot)
{
    LeafParams params;
    params.shape = shape;
    params.perShoot = perShoot;
    CardAtlas atlas;
    const LeafForm form = leafForm(params);
    const auto mesh = std::make_shared<const TriangleMesh>(leafMesh(form));
    Box box;
    for (const glm::vec3& at : mesh->positions)
        box.add(glm::dvec3(at));
    for (std::size_t k = 0; k < 4; ++k) {
        atlas.surfaces.push_back({mesh, {}, form, {}, leafColour(shape, false)});
        ShownCard card{k, k + 1, {}, box.centre(), 0.52 * glm::dvec2(box.size())};
        card.low = glm::vec2(0.5F * float(k % 2), 0.5F * float(k / 2)) + 1.0F / 64.0F;
        card.high = card.low + 0.5F - 2.0F / 64.0F;
        atlas.cards.push_back(card);
    }
    return atlas;
}

std::vector<float> alphaOf(const SprayMaps& maps)
{
    std::vector<float> alpha;
    for (const glm::u8vec4& pixel : maps.colour)
        alpha.push_back(float(pixel.a) / 255.0F);
    return alpha;
}

double opaqueShare(const SprayMaps& maps)
{
    return opaqueShares(alphaOf(maps), maps.size, 1).front();
}

} // namespace

class TestSprayPicture : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void sizesOutsideAreRefused()
    {
        const CardAtlas atlas = atlasOf(LeafShape::Oak, 3);
        for (const int size : {-1, 0, 63, 65, 96, 8192}) {
            const auto maps = sprayMaps(atlas, size);
            QVERIFY(!maps);
            QCOMPARE(maps.error().code, ErrorCode::Invalid);
        }
    }
    void itCanBeCancelled()
    {
        std::stop_source source;
        source.request_stop();
        const auto maps = sprayMaps(atlasOf(LeafShape::Oak, 3), 128, {source.get_token(), {}});
        QVERIFY(!maps);
        QCOMPARE(maps.error().code, ErrorCode::Cancelled);
    }

    /// Leaves are there, with normals towards the eye; nothing reaches from one card into another, and the
    /// colour goes on beside the leaves.
    void twigsAreSeen()
    {
        for (const LeafShape shape : {LeafShape::Oak, LeafShape::Maple, LeafShape::Ash, LeafShape::Spruce}) {
            const auto maps = sprayMaps(atlasOf(shape, shape == LeafShape::Spruce ? 1 : 5), 256);
            QVERIFY(maps);
            QCOMPARE(maps->colour.size(), std::size_t(256 * 256));
            const double covered = opaqueShare(*maps);
            QVERIFY2(covered > 0.08 && covered < 0.8, qPrintable(QString::number(covered)));
            for (std::size_t i = 0; i < maps->colour.size(); ++i) {
                QVERIFY(maps->normal[i].z >= 127);
                const glm::u8vec4 pixel = maps->colour[i];
                QVERIFY(pixel.g > 0); // green or brown even where nothing is
                const std::size_t x = i % 128;
                if (x < 3 || x > 124)
                    QVERIFY(pixel.a < 128);
            }
        }
    }

    /// From afar as much of the card is opaque as from near by, within two hundredths.
    void coverageIsKeptFromAfar()
    {
        for (const LeafShape shape :
             {LeafShape::Oak, LeafShape::Birch, LeafShape::Maple, LeafShape::Willow}) {
            const auto maps = sprayMaps(atlasOf(shape, 6), 512);
            QVERIFY(maps);
            const std::vector<double> mips = opaqueShares(alphaOf(*maps), 512, keptMips + 1);
            for (const double share : mips)
                QVERIFY2(std::abs(share - mips[0]) < 0.02 * mips[0],
                         qPrintable(QString("%1 for %2").arg(share).arg(mips[0])));
        }
    }

    void theSameAtlasGivesTheSameBytes()
    {
        const CardAtlas atlas = atlasOf(LeafShape::Linden, 4);
        const auto once = sprayMaps(atlas, 128), again = sprayMaps(atlas, 128);
        QVERIFY(once->colour == again->colour && once->normal == again->normal);
    }
};

RAMURE_SUITE(TestSprayPicture)

} // namespace tst_spray_picture

#include "tst_spray_picture.moc"
