#include "core/lod/billboard_view.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

namespace tst_billboard {

using namespace ramure;

namespace {

/// A round thing in the middle: nearest in its own middle. \param radius share of the picture's half
BillboardPicture disc(int side, double radius)
{
    BillboardPicture out(side, side);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const double u = (x + 0.5) / side * 2.0 - 1.0, v = 1.0 - (y + 0.5) / side * 2.0;
            const double left = radius * radius - u * u - v * v;
            if (left < 0.0)
                continue;
            const std::size_t i = out.at(x, y);
            out.colour[i] = {x % 256, y % 256, 90, 255};
            out.normal[i] = {128, 128, 255, std::uint8_t(1.0 + 127.0 * (1.0 + std::sqrt(left)))};
        }
    return out;
}

bool isFrame(const ViewFrame& f)
{
    return std::abs(glm::dot(f.right, f.up)) < 1e-12 && std::abs(glm::dot(f.right, f.backward)) < 1e-12 &&
           glm::distance(glm::cross(f.right, f.up), f.backward) < 1e-12;
}

BillboardCard cardOf(const ViewFrame& frame, const PlaneRect& seen)
{
    return {frame, seen, {}};
}

} // namespace

/// The mathematics of billboards.
class TestBillboard : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void cardsThatCannotBePackedAreRefused()
    {
        const ViewFrame frame;
        const double nan = std::numeric_limits<double>::quiet_NaN();
        for (const PlaneRect& bad : {PlaneRect{{0, 0}, {0, 1}}, PlaneRect{{0, 0}, {1, -1}},
                                     PlaneRect{{0, 0}, {nan, 1}}, PlaneRect{{0, 0}, {1.0 / 0.0, 1}}}) {
            std::vector<BillboardCard> cards{cardOf(frame, bad)};
            const auto packed = packCards(cards, 256, 2);
            QVERIFY(!packed && packed.error().code == ErrorCode::Invalid);
        }
        std::vector<BillboardCard> cards(4, cardOf(frame, {{0, 0}, {1, 1}}));
        QVERIFY(packCards(cards, 15, 2).error().code == ErrorCode::Invalid);
        const auto full = packCards(cards, 16, 4);
        QVERIFY(!full && full.error().code == ErrorCode::Limit);
        QVERIFY(packCards(cards, 16, 1).has_value());
    }
    void picturesWithoutAnythingStayEmpty()
    {
        BillboardPicture nothing(9, 7);
        bleed(nothing, {0, 0, 9, 7});
        bleed(nothing, {3, 3, 0, 0});
        QVERIFY(nothing.colour == BillboardPicture(9, 7).colour);
        QCOMPARE(coveredRect(nothing).width, 0);
        QCOMPARE(likenessOf(coverageOf(nothing), coverageOf(nothing)).soft, 1.0);
        QVERIFY(shrunk(BillboardPicture(8, 8), 4).colour == BillboardPicture(2, 2).colour);
    }

    void directionsComeBack()
    {
        std::mt19937_64 random(7); // NOLINT(cert-msc51-cpp): the same each time
        std::uniform_real_distribution<double> side(-1.0, 1.0);
        for (int i = 0; i < 2000; ++i) {
            const glm::dvec3 d = glm::normalize(
                glm::dvec3(side(random), i % 10 == 0 ? 0.0 : std::abs(side(random)), side(random)));
            const glm::dvec2 point = hemiOctEncoded(d);
            QVERIFY(std::abs(point.x) <= 1.0 + 1e-12 && std::abs(point.y) <= 1.0 + 1e-12);
            QVERIFY(glm::distance(hemiOctDecoded(point), d) < 1e-9);
            QVERIFY(isFrame(viewFrame(d)));
            for (const int views : {2, 3, 8}) {
                const std::vector<AtlasCell> cells = viewsAround(d, views);
                QVERIFY(cells.size() >= (views == 2 ? 1U : 3U) && cells.size() <= 9U);
                double nearest = -1.0;
                for (const AtlasCell cell : cells) {
                    QVERIFY(cell.column >= 0 && cell.row >= 0 && cell.column < views && cell.row < views);
                    nearest = std::max(nearest, glm::dot(atlasDirection(cell, views), d));
                }
                QVERIFY(views < 8 || nearest > 0.93);
            }
        }
        QCOMPARE(hemiOctEncoded({0.0, 1.0, 0.0}), glm::dvec2(0.0));
        QCOMPARE(hemiOctEncoded({0.0, -1.0, 0.0}), glm::dvec2(0.0));
        QVERIFY(isFrame(viewFrame({0.0, 1.0, 0.0})) && isFrame(viewFrame({0.0, -1.0, 0.0})));
    }
    void viewsOfAnAtlasAreThemselves()
    {
        for (int row = 0; row < 8; ++row)
            for (int column = 0; column < 8; ++column) {
                const glm::dvec3 d = atlasDirection({column, row}, 8);
                QVERIFY(d.y > -1e-12);
                const bool isEdge = row % 7 == 0 || column % 7 == 0;
                QCOMPARE(std::abs(d.y) < 1e-9, isEdge);
                const std::vector<AtlasCell> around = viewsAround(d, 8);
                QVERIFY(std::ranges::find(around, AtlasCell{column, row}) != around.end());
            }
    }
    void directionsOfTheHemisphereAreEven()
    {
        const std::vector<glm::dvec3> all = hemisphereDirections(100);
        glm::dvec3 sum(0.0);
        for (const glm::dvec3& d : all) {
            QVERIFY(d.y > 0.0 && std::abs(glm::length(d) - 1.0) < 1e-12);
            sum += d / 100.0;
        }
        QVERIFY(glm::distance(sum, glm::dvec3(0.0, 0.5, 0.0)) < 0.02);
    }

    void bleedingLeavesWhatIsCovered()
    {
        for (const int side : {1, 2, 5, 16, 33}) {
            const BillboardPicture before = disc(side, 0.8);
            BillboardPicture after = before;
            const PixelRect within{0, 0, side, side};
            bleed(after, within);
            for (std::size_t i = 0; i < after.colour.size(); ++i) {
                QCOMPARE(after.colour[i].a, before.colour[i].a);
                if (before.colour[i].a > 0)
                    QVERIFY(after.colour[i] == before.colour[i] && after.normal[i] == before.normal[i]);
                else // a colour between those there are
                    QVERIFY(after.colour[i].b == 90 && after.normal[i].a > 0);
            }
            BillboardPicture again = after;
            bleed(again, within);
            QVERIFY(again.colour == after.colour && again.normal == after.normal);
        }
    }
    void bleedingStaysInItsRectangle()
    {
        BillboardPicture picture(40, 20);
        paste(picture, disc(20, 0.5), 0, 0);
        const BillboardPicture before = picture;
        bleed(picture, {0, 0, 20, 20});
        for (int y = 0; y < 20; ++y)
            for (int x = 0; x < 40; ++x)
                QCOMPARE(picture.colour[picture.at(x, y)] == before.colour[before.at(x, y)],
                         x >= 20 || before.colour[before.at(x, y)].a > 0);
    }
    void smallerPicturesCoverAsMuch()
    {
        const BillboardPicture large = disc(96, 0.8);
        const auto sum = [](const BillboardPicture& picture) {
            double out = 0.0;
            for (const float share : coverageOf(picture))
                out += share / double(picture.colour.size());
            return out;
        };
        for (const int each : {1, 2, 3, 4})
            QVERIFY(std::abs(sum(shrunk(large, each)) - sum(large)) < 1e-3);
        QVERIFY(shrunk(large, 1).colour == large.colour);
    }

    void cardsHoldWhatTheyShow()
    {
        for (int standing = leastCards; standing <= mostCards; ++standing)
            for (const bool lying : {false, true}) {
                std::vector<BillboardCard> cards;
                for (const ViewFrame& frame : cardFrames(standing, lying)) {
                    QVERIFY(isFrame(frame));
                    const double n = double(cards.size());
                    cards.push_back(cardOf(frame, {{-1.0 - 0.1 * n, -2.0}, {1.0, 3.0 + 0.2 * n}}));
                }
                const std::vector<BillboardCard> asked = cards;
                constexpr int size = 512, gap = 3;
                QVERIFY(packCards(cards, size, gap).has_value());
                checkPlaces(cards, asked, size, gap);
                const glm::dvec3 middle(4.0, 2.0, -1.0);
                const TriangleMesh mesh = cardMesh(cards, middle, size);
                QCOMPARE(std::size_t(mesh.faceCount()), 2 * cards.size());
                QCOMPARE(mesh.uv.size(), mesh.positions.size());
                for (const glm::uvec3& t : mesh.triangles) { // it is seen from where its normal points to
                    const glm::vec3 &a = mesh.positions[t.x], &b = mesh.positions[t.y],
                                    &c = mesh.positions[t.z];
                    QVERIFY(glm::dot(glm::cross(b - a, c - a), mesh.normals[t.x]) > 0.0F);
                }
                for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
                    const BillboardCard& card = cards[i / 4];
                    const glm::dvec3 at = glm::dvec3(mesh.positions[i]) - middle;
                    QVERIFY(std::abs(glm::dot(at, card.frame.backward)) < 1e-5);
                }
            }
    }

    void anAtlasShowsWhatItWasMadeOf()
    {
        constexpr int views = 8, side = 48;
        BillboardPicture atlas(views * side, views * side);
        const BillboardPicture ball = disc(side, 0.8); // from all sides the same
        for (int i = 0; i < views * views; ++i)
            paste(atlas, ball, i % views * side, i / views * side);
        for (const glm::dvec3& direction : hemisphereDirections(40)) {
            const Likeness likeness = likenessOf(coverageOf(ball), atlasCoverage(atlas, views, direction));
            QVERIFY2(likeness.soft > 0.92 && likeness.hard > 0.92,
                     qPrintable(QStringLiteral("%1 %2").arg(likeness.soft).arg(likeness.hard)));
        }
        // From where a view was drawn, all that it shows is seen.
        const Coverage own = coverageOf(ball),
                       seen = atlasCoverage(atlas, views, atlasDirection({3, 5}, views));
        for (std::size_t i = 0; i < own.size(); ++i)
            QVERIFY(seen[i] >= own[i] - 1e-4F);
    }

private:
    static void checkPlaces(const std::vector<BillboardCard>& cards, const std::vector<BillboardCard>& asked,
                            int size, int gap)
    {
        const double scale = cards[0].picture.width / cards[0].seen.size().x;
        for (std::size_t i = 0; i < cards.size(); ++i) {
            const PlaneRect &seen = cards[i].seen, &wanted = asked[i].seen;
            QVERIFY(seen.low.x <= wanted.low.x + 1e-6 && seen.low.y <= wanted.low.y + 1e-6);
            QVERIFY(seen.high.x >= wanted.high.x - 1e-6 && seen.high.y >= wanted.high.y - 1e-6);
            const PixelRect& a = cards[i].picture;
            QVERIFY(std::abs(a.width / seen.size().x / scale - 1.0) < 1e-9);
            QVERIFY(std::abs(a.height / seen.size().y / scale - 1.0) < 1e-9);
            QVERIFY(a.x >= gap && a.y >= gap && a.x + a.width + gap <= size && a.y + a.height + gap <= size);
            for (std::size_t k = 0; k < i; ++k) {
                const PixelRect& b = cards[k].picture;
                QVERIFY(a.x >= b.x + b.width + 2 * gap || b.x >= a.x + a.width + 2 * gap ||
                        a.y >= b.y + b.height + 2 * gap || b.y >= a.y + a.height + 2 * gap);
            }
        }
    }
};

RAMURE_SUITE(TestBillboard)

} // namespace tst_billboard

#include "tst_billboard.moc"
