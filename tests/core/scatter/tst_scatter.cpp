#include "core/scatter/scatter.h"

#include "core/io/picture_file.h"
#include "core/math/angle.h"
#include "core/math/random.h"
#include "core/math/reproducible.h"
#include "core/scatter/scatter_ground.h"
#include "core/surface/primitives/terrain.h"
#include "tests/support/suite.h"
#include <QFile>
#include <QTemporaryDir>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>

namespace tst_scatter {

using namespace ramure;

namespace {

constexpr NodeId scatterId = 1, firstPrototype = 2, groundId = 20, rockId = 21;

Node node(NodeId id, NodeKind kind, const char* name, NodeId parent = noNode)
{
    Node out;
    out.id = id;
    out.parent = parent;
    out.kind = kind;
    out.name = name;
    return out;
}

Node box(NodeId id, const char* name, const glm::dvec3& size, const glm::dvec3& at, GrowthRole role)
{
    Node out = node(id, NodeKind::Primitive, name);
    out.params.primitive.shape = PrimitiveShape::Box;
    out.params.primitive.size = size;
    out.params.tree.translation = at;
    out.params.growthRole = role;
    return out;
}

/// A scatter with as many trees, and other nodes beside it.
Scene sceneOf(const ScatterParams& params, int prototypes = 1, std::vector<Node> others = {})
{
    std::vector<Node> nodes{node(scatterId, NodeKind::Scatter, "Scatter")};
    nodes.front().params.scatter = params;
    for (int i = 0; i < prototypes; ++i)
        nodes.push_back(node(firstPrototype + NodeId(i), NodeKind::Tree, "Tree", scatterId));
    nodes.insert(nodes.end(), others.begin(), others.end());
    return *Scene::fromNodes(std::move(nodes));
}

Expected<SharedPlaces> placesIn(const Scene& scene)
{
    return scatterPlaces(scene, *scene.find(scatterId));
}

ScatterPlaces placesOf(const ScatterParams& params, int prototypes = 1, std::vector<Node> others = {})
{
    const auto places = placesIn(sceneOf(params, prototypes, std::move(others)));
    if (!places)
        qFatal("%s", places.error().message().c_str());
    return **places;
}

double leastDistance(const ScatterPlaces& places)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            least = std::min(least, maths::hypot(places[i].position.x - places[j].position.x,
                                                 places[i].position.z - places[j].position.z));
    return least;
}

ErrorCode codeOf(const Expected<SharedPlaces>& places)
{
    return places ? ErrorCode() : places.error().code;
}

} // namespace

/// Copies of a few trees on the ground, by rules.
class TestScatter : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void wrongRulesAreToldByTheirKey()
    {
        const auto refuses = [](const char* key, ErrorCode code, auto&& change, int prototypes = 1,
                                std::vector<Node> others = {}) {
            ScatterParams params;
            change(params);
            const auto places = placesIn(sceneOf(params, prototypes, std::move(others)));
            return !places && places.error().code == code && places.error().path == key;
        };
        QVERIFY(refuses("scatter.count", ErrorCode::Invalid,
                        [](ScatterParams& p) { p.count = 0, p.spacing = 0.0; }));
        QVERIFY(refuses("scatter.count", ErrorCode::Limit,
                        [](ScatterParams& p) { p.count = 0, p.spacing = 0.01, p.width = p.depth = 1000.0; }));
        QVERIFY(refuses("scatter.count", ErrorCode::Limit,
                        [](ScatterParams& p) { p.count = 0, p.spacing = 1e-300; }));
        QVERIFY(refuses(
            "scatter.shares", ErrorCode::Syntax, [](ScatterParams& p) { p.shares = "1 two"; }, 2));
        QVERIFY(refuses(
            "scatter.shares", ErrorCode::Syntax, [](ScatterParams& p) { p.shares = "-1"; }, 2));
        QVERIFY(refuses(
            "scatter.shares", ErrorCode::Syntax, [](ScatterParams& p) { p.shares = "nan"; }, 2));
        QVERIFY(refuses(
            "scatter.shares", ErrorCode::Invalid, [](ScatterParams& p) { p.shares = "0,0"; }, 2));
        QVERIFY(
            refuses("scatter.removed", ErrorCode::Syntax, [](ScatterParams& p) { p.removed = "1f xyz"; }));
        QVERIFY(
            refuses("scatter.removed", ErrorCode::Syntax, [](ScatterParams& p) { p.removed = "123456789"; }));
        QVERIFY(
            refuses("scatter.ground", ErrorCode::Unknown, [](ScatterParams& p) { p.ground = "Nowhere"; }));
        QVERIFY(
            refuses("scatter.ground", ErrorCode::Invalid, [](ScatterParams& p) { p.ground = "Scatter"; }));
        QVERIFY(refuses("scatter.ground", ErrorCode::Invalid, [](ScatterParams& p) { p.ground = "Tree"; }));
        Node below = box(groundId, "Below", {1, 1, 1}, {}, GrowthRole::None);
        below.parent = scatterId;
        QVERIFY(refuses("scatter.ground", ErrorCode::Invalid, [](ScatterParams& p) { p.ground = "Below"; }, 1,
                        {below}));
        QVERIFY(
            refuses("scatter.density", ErrorCode::Io, [](ScatterParams& p) { p.density = "/nowhere.png"; }));
    }

    void nothingToCopyGivesNoPlaces()
    {
        QVERIFY(placesOf({}, 0).empty());
        Scene hidden = sceneOf({});
        hidden.find(firstPrototype)->visible = false;
        QVERIFY((*placesIn(hidden))->empty());
    }

    void aCancelledOneSaysSo()
    {
        std::stop_source stop;
        stop.request_stop();
        const Scene scene = sceneOf({});
        QCOMPARE(codeOf(scatterPlaces(scene, *scene.find(scatterId), {stop.get_token(), {}})),
                 ErrorCode::Cancelled);
    }

    /// Numbers, areas and spacings by chance: everyone stands inside, apart, and as often as is asked.
    void allStandInsideAndApart()
    {
        Random random(7, RandomStream::Test);
        for (int i = 0; i < 40; ++i) {
            ScatterParams params;
            params.seed = i;
            params.count = random.below(400);
            params.width = random.range(1.0, 80.0);
            params.depth = random.range(1.0, 80.0);
            params.spacing = random.range(1.0, 12.0);
            params.leastScale = random.range(0.1, 2.0);
            params.mostScale = random.range(0.1, 2.0);
            const ScatterPlaces places = placesOf(params, 3);
            QVERIFY(!places.empty());
            QVERIFY(params.count == 0 || places.size() <= std::size_t(params.count));
            QVERIFY(leastDistance(places) >= params.spacing);
            std::set<std::uint32_t> keys;
            for (const ScatterPlace& place : places) {
                QVERIFY(std::abs(place.position.x) <= 0.5 * params.width);
                QVERIFY(std::abs(place.position.z) <= 0.5 * params.depth);
                QCOMPARE(place.position.y, 0.0);
                QVERIFY(place.prototype < 3);
                QVERIFY(place.size >= std::min(params.leastScale, params.mostScale) * (1.0 - 1e-12));
                QVERIFY(place.size <= std::max(params.leastScale, params.mostScale) * (1.0 + 1e-12));
                QVERIFY(std::abs(glm::length(place.turn) - 1.0) < 1e-12);
                QVERIFY(keys.insert(place.key).second);
            }
        }
    }

    /// As dense as circles thrown one after the other become: .547 of the area is theirs (Rényi's constant of
    /// the plane; Feder 1980).
    void withoutANumberTheAreaIsAsGoodAsFull()
    {
        ScatterParams params;
        params.count = 0;
        params.spacing = 1.0;
        params.width = params.depth = 60.0;
        const double covered = double(placesOf(params).size()) * pi / 4.0 / (61.0 * 61.0);
        QVERIFY2(covered > 0.48 && covered < 0.548, qPrintable(QString::number(covered)));
    }

    void aLargerNumberOnlyAdds()
    {
        ScatterParams few, many;
        few.spacing = many.spacing = 2.0;
        few.count = 50;
        many.count = 300;
        const ScatterPlaces a = placesOf(few, 2), b = placesOf(many, 2);
        QCOMPARE(a.size(), std::size_t(50));
        QCOMPARE(b.size(), std::size_t(300));
        QVERIFY(std::equal(a.begin(), a.end(), b.begin()));
    }

    void whatIsRemovedLeavesItsPlaceEmpty()
    {
        ScatterParams params;
        const ScatterPlaces all = placesOf(params);
        params.removed =
            QStringLiteral("%1, %2").arg(all[3].key, 0, 16).arg(all[10].key, 0, 16).toStdString();
        const ScatterPlaces left = placesOf(params);
        ScatterPlaces expected = all;
        expected.erase(expected.begin() + 10);
        expected.erase(expected.begin() + 3);
        QVERIFY(left == expected);
    }

    void sharesAreKept()
    {
        ScatterParams params;
        params.shares = "3 1 0";
        params.count = 4000;
        params.spacing = 0.5;
        const ScatterPlaces places = placesOf(params, 3);
        QCOMPARE(places.size(), std::size_t(4000));
        const auto first = std::ranges::count(places, 0u, &ScatterPlace::prototype);
        QVERIFY(first > 2880 && first < 3120);
        QCOMPARE(std::ranges::count(places, 2u, &ScatterPlace::prototype), 0);
    }

    void theyStandOnTheHighestSurface()
    {
        ScatterParams params;
        params.width = params.depth = 10.0;
        params.spacing = 0.5;
        params.steepest = pi / 2.0;
        Node terrain = node(groundId, NodeKind::Terrain, "Hill");
        terrain.params.terrain.size = 30.0;
        terrain.params.terrain.height = 4.0;
        terrain.params.terrain.divisions = 1024;
        terrain.params.tree.translation = {1.0, 2.0, 3.0};
        const auto heights = *TerrainHeights::of(terrain.params.terrain);
        const ScatterPlaces places = placesOf(params, 1, {terrain});
        QVERIFY(places.size() > 100);
        for (const ScatterPlace& place : places) {
            const double expected = 2.0 + heights.at(place.position.x - 1.0, place.position.z - 3.0);
            QVERIFY2(std::abs(place.position.y - expected) < 0.02, qPrintable(QString::number(expected)));
        }
        params.ground = "Table";
        const Node table = box(rockId, "Table", {4, 1, 4}, {0, 9.5, 0}, GrowthRole::None);
        const ScatterPlaces onTable = placesOf(params, 1, {terrain, table});
        QVERIFY(!onTable.empty());
        for (const ScatterPlace& place : onTable)
            QVERIFY(place.position.y > 9.4 && std::abs(place.position.x) <= 2.0);
    }

    void steepHighAndLowGroundIsLeftOut()
    {
        Node slope = node(groundId, NodeKind::Terrain, "Slope");
        slope.params.terrain.height = 0.0;
        slope.params.terrain.size = 200.0;
        slope.params.tree.rotation.z = 0.6; // rad
        ScatterParams params;
        params.steepest = 0.59;
        QVERIFY(placesOf(params, 1, {slope}).empty());
        params.steepest = 0.61;
        params.alignment = 1.0;
        params.lowest = -5.0;
        params.highest = 3.0;
        const ScatterPlaces places = placesOf(params, 1, {slope});
        QVERIFY(places.size() > 20);
        const glm::dvec3 normal(-maths::sin(0.6), maths::cos(0.6), 0.0);
        for (const ScatterPlace& place : places) {
            QVERIFY(place.position.y >= -5.0 && place.position.y <= 3.0);
            QVERIFY(glm::distance(place.turn * glm::dvec3(0.0, 1.0, 0.0), normal) < 1e-6);
        }
    }

    void obstaclesAreKeptClearOf()
    {
        ScatterParams params;
        params.spacing = 0.5;
        params.width = params.depth = 20.0;
        params.count = 0;
        params.clearance = 1.5;
        const auto distance = [](const ScatterPlace& place) {
            const double x = std::max(std::abs(place.position.x) - 2.0, 0.0);
            const double z = std::max(std::abs(place.position.z) - 0.1, 0.0);
            return maths::hypot(x, z);
        };
        const Node fence = box(rockId, "Fence", {4, 2, 0.2}, {0, 1, 0}, GrowthRole::Obstacle);
        const ScatterPlaces places = placesOf(params, 1, {fence});
        double nearest = 100.0;
        for (const ScatterPlace& place : places)
            nearest = std::min(nearest, distance(place));
        QVERIFY(nearest >= 1.5 && nearest < 1.7);
        const Node art = box(rockId, "Art", {4, 2, 0.2}, {0, 1, 0}, GrowthRole::None);
        QVERIFY(std::ranges::any_of(placesOf(params, 1, {art}),
                                    [&](const ScatterPlace& place) { return distance(place) < 1.0; }));
    }

    void aMapOfDensityIsFollowed()
    {
        QTemporaryDir folder;
        // Rows from below: the lower half (greater Z) is black, above the right half is white.
        const std::vector<std::uint8_t> pixels{0, 0, 0, 255};
        const auto png = pngOf({2, 2, 1, false, pixels});
        QVERIFY(png);
        QFile file(folder.filePath("map.png"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(png->data(), qint64(png->size()));
        file.close();
        ScatterParams params;
        params.density = file.fileName().toStdString();
        params.count = 500;
        params.spacing = 0.0;
        const ScatterPlaces places = placesOf(params);
        QCOMPARE(places.size(), std::size_t(500));
        const auto inCorner = std::ranges::count_if(places, [](const ScatterPlace& place) {
            return place.position.x > 0.0 && place.position.z < 0.0;
        });
        QVERIFY2(inCorner > 350, qPrintable(QString::number(inCorner))); // the map is soft between its pixels
        QVERIFY(std::ranges::none_of(places, [](const ScatterPlace& place) {
            return place.position.x < -20.0 || place.position.z > 20.0;
        }));
    }

    /// The number of neighbours within a cluster's reach varies more than by chance.
    void clustersLeaveClearings()
    {
        const auto emptyCells = [](double clusters) {
            ScatterParams params;
            params.spacing = 0.0;
            params.count = 2000;
            params.clusters = clusters;
            params.clusterSize = 20.0;
            std::set<std::pair<int, int>> full;
            for (const ScatterPlace& place : placesOf(params))
                full.emplace(int(std::floor(place.position.x / 5.0)),
                             int(std::floor(place.position.z / 5.0)));
            return 256 - int(full.size());
        };
        QVERIFY(emptyCells(0.0) < 5);
        QVERIFY(emptyCells(1.0) > 40);
    }

    void memoryFollowsWhatThePlacesFollowFrom()
    {
        ScatterMemory memory;
        Scene scene = sceneOf({}, 2, {node(groundId, NodeKind::Terrain, "Hill")});
        const auto now = [&] { return *memory.places(scene, *scene.find(scatterId)); };
        const SharedPlaces first = now();
        QCOMPARE(now(), first);
        scene.find(firstPrototype)->params.grammar.seed = 9; // another tree at the same places
        QCOMPARE(now(), first);
        scene.find(groundId)->params.terrain.seed = 9;
        const SharedPlaces second = now();
        QVERIFY(second != first && *second != *first);
        scene.find(scatterId)->params.scatter.seed = 9;
        QVERIFY(*now() != *second);
        scene.find(scatterId)->params.scatter.ground = "Nowhere";
        QVERIFY(!memory.places(scene, *scene.find(scatterId)));
    }

    void aPlaceMovesItsPrototype()
    {
        ScatterPlace place;
        place.position = {1, 2, 3};
        place.size = 2.0;
        place.turn = maths::angleAxis(pi / 2.0, {0, 1, 0});
        const glm::dvec3 moved(placeMatrix(place) * glm::dvec4(1, 0, 0, 1));
        QVERIFY(glm::distance(moved, glm::dvec3(1, 2, 1)) < 1e-12);
        Node tree = node(2, NodeKind::Tree, "Tree");
        tree.params.tree.translation = {7, 7, 7};
        tree.params.tree.scale = glm::dvec3(3.0);
        QVERIFY(glm::distance(glm::dvec3(prototypeMatrix(tree) * glm::dvec4(1, 0, 0, 1)), {3, 0, 0}) < 1e-12);
    }

    void whatIsBelowAScatterIsAPrototype()
    {
        const Scene scene = sceneOf({}, 1, {node(groundId, NodeKind::Terrain, "Hill")});
        QVERIFY(isPrototype(scene, firstPrototype));
        QVERIFY(!isPrototype(scene, scatterId) && !isPrototype(scene, groundId) && !isPrototype(scene, 99));
    }
};

RAMURE_SUITE(TestScatter)

} // namespace tst_scatter

#include "tst_scatter.moc"
