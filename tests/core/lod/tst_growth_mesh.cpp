#include "core/lod/growth_mesh.h"

#include "core/generators/growth/grown_skeleton.h"
#include "core/generators/growth/whole_life.h"
#include "core/generators/sources.h"
#include "core/lod/growth_leaves.h"
#include "core/params/tree_edit_table.h"
#include "core/presets/presets.h"
#include "core/surface/check/verdict.h"
#include "core/surface/proof/validate.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <cmath>

namespace tst_growth_mesh {

using namespace ramure;

namespace {

NodeParams treeOf(const char* name, double age)
{
    NodeParams params = *presetParams(name);
    params.growth.age = age;
    return params;
}

GrowthMesh made(const NodeParams& params, const GrowthMeshOptions& options)
{
    auto mesh = growthMesh(params, options);
    if (!mesh)
        qFatal("%s", test::why(mesh).constData());
    return std::move(*mesh);
}

TriangleMesh meshAt(const GrowthMesh& growth, const GrowthKey& key)
{
    TriangleMesh mesh = *growth.bark;
    mesh.positions = key.positions;
    mesh.normals = key.normals;
    return mesh;
}

double heightOf(std::span<const glm::vec3> points)
{
    return double(std::ranges::max(points, {}, &glm::vec3::y).y);
}

QString pathOf(const NodeParams& params, const GrowthMeshOptions& options)
{
    const auto refused = growthMesh(params, options);
    return refused ? QStringLiteral("accepted") : QString::fromStdString(refused.error().path);
}

} // namespace

/// A tree that grows as one mesh.
class TestGrowthMesh : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void badInputIsRefused()
    {
        const NodeParams oak = treeOf("EnglishOak", 12.0);
        QCOMPARE(pathOf(*presetParams("SmallTree"), {}), QStringLiteral("generator.kind"));
        QCOMPARE(pathOf(*presetParams("CoconutPalm"), {}), QStringLiteral("generator.kind"));
        GrowthMeshOptions options;
        for (const double from : {12.0, 80.0, 0.0, -3.0, std::nan("")}) {
            options.from = from;
            QCOMPARE(pathOf(oak, options), QStringLiteral("growth.age"));
        }
        options = {};
        for (const int keys : {-1, 0, 1, mostGrowthKeys + 1}) {
            options.keys = keys;
            QCOMPARE(pathOf(oak, options), QStringLiteral("keys"));
        }
        options = {};
        options.triangles = 10;
        QVERIFY(!growthMesh(oak, options));
        NodeParams sagging = oak;
        sagging.edits.push_back(newStep(EditOperation::Sag));
        QCOMPARE(pathOf(sagging, {}), QStringLiteral("edits"));
        sagging.edits.back().enabled = false;
        QCOMPARE(pathOf(sagging, {}), QStringLiteral("accepted"));
    }

    void canBeCancelled()
    {
        std::stop_source stop;
        stop.request_stop();
        const auto cancelled = growthMesh(treeOf("EnglishOak", 30.0), {}, {stop.get_token(), {}});
        QVERIFY(!cancelled);
        QCOMPARE(cancelled.error().code, ErrorCode::Cancelled);
    }

    void species_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("age");
        QTest::newRow("oak") << QStringLiteral("EnglishOak") << 60.0;
        QTest::newRow("pine") << QStringLiteral("ScotsPine") << 35.0;
        QTest::newRow("part of a year") << QStringLiteral("SilverBirch") << 14.6;
        QTest::newRow("willow") << QStringLiteral("WeepingWillow") << 12.0;
        QTest::newRow("seedling") << QStringLiteral("EuropeanBeech") << 2.0;
    }
    /// Closed and manifold at every key, without triangles that are nothing, as high as the tree of that age.
    void species()
    {
        QFETCH(const QString, name);
        QFETCH(const double, age);
        const NodeParams params = treeOf(name.toLatin1().constData(), age);
        GrowthMeshOptions options;
        options.triangles = 30'000; // with the twigs that are the highest
        const GrowthMesh growth = made(params, options);
        QVERIFY(growth.keys.size() >= 2 && growth.keys.size() <= 12);
        QCOMPARE(growth.keys.front().age, 1.0);
        QCOMPARE(growth.keys.back().age, age);
        const auto history = growSymbols(params)->history;
        double before = 0.0;
        for (const GrowthKey& key : growth.keys) {
            QVERIFY(key.age > before);
            before = key.age;
            const TriangleMesh mesh = meshAt(growth, key);
            QCOMPARE(mesh.positions.size(), growth.bark->positions.size());
            const auto report = validateMesh(mesh);
            QVERIFY(report);
            QVERIFY(verdictOn(*report, nullptr, 1) != MeshVerdict::Broken);
            QVERIFY(std::ranges::all_of(key.positions, [](const glm::vec3& p) {
                return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
            }));
            const Skeleton tree = skeletonAtAge(*history, key.age);
            double height = 0.0;
            for (const glm::dvec3& end : tree.p1)
                height = std::max(height, end.y);
            QVERIFY2(std::abs(heightOf(key.positions) - height) <= 0.03 * height + 0.02,
                     qPrintable(QStringLiteral("%1 years: %2 m of %3 m")
                                    .arg(key.age)
                                    .arg(heightOf(key.positions))
                                    .arg(height)));
        }
        QVERIFY(growth.bark->positions == growth.keys.back().positions);
    }

    /// More keys, less error; and the median branch is where it should be within a hundredth of the height.
    void keysFollowTheGrowth()
    {
        const NodeParams oak = treeOf("EnglishOak", 40.0);
        GrowthMeshOptions options;
        options.triangles = 10'000;
        double least = 1e9;
        for (const int keys : {3, 8, 20, mostGrowthKeys}) {
            options.keys = keys;
            const GrowthMesh growth = made(oak, options);
            QVERIFY(growth.keys.size() <= std::size_t(keys));
            QVERIFY2(growth.error < least, qPrintable(QString::number(growth.error)));
            least = growth.error;
        }
        QVERIFY(least < 0.05 * heightOf(made(oak, options).bark->positions));
    }

    void theSameBytes()
    {
        const NodeParams oak = treeOf("EnglishOak", 25.0);
        GrowthMeshOptions options;
        options.triangles = 8'000;
        options.texture = true;
        const GrowthMesh first = made(oak, options), second = made(oak, options);
        QVERIFY(*first.bark == *second.bark);
        QVERIFY(!first.bark->uv.empty());
        for (std::size_t k = 0; k < first.keys.size(); ++k)
            QVERIFY(first.keys[k].positions == second.keys[k].positions &&
                    first.keys[k].normals == second.keys[k].normals);
    }

    /// A limb that was cut is there before, and a scar afterwards.
    void aCutLimbShrinks()
    {
        NodeParams oak = treeOf("EnglishOak", 30.0);
        GrowthMeshOptions options;
        options.triangles = 10'000;
        options.keys = 20;
        const GrowthMesh whole = made(oak, options);
        const auto history = growSymbols(oak)->history;
        // The limb of the trunk with the most metamers, of those that the tree of 30 years shows.
        std::vector<Index> sizes(history->axisAddress.size(), 0);
        for (Index i = 0; i < history->size(); ++i)
            if (int(history->birth[i]) < 15)
                ++sizes[history->axis[i]];
        const Skeleton shown = skeletonAtAge(*history, 30.0);
        Index limb = noIndex;
        for (Index axis = 0; axis < sizes.size(); ++axis)
            if (history->axisOrder[axis] == 1 && (limb == noIndex || sizes[axis] > sizes[limb]) &&
                std::ranges::count(shown.axisStarts, history->axisAddress[axis],
                                   &std::pair<Index, std::uint64_t>::second) > 0)
                limb = axis;
        QVERIFY(limb != noIndex);
        TreeEdit cut = newStep(EditOperation::Remove);
        cut.target.address = history->axisAddress[limb];
        cut.year = 20.0;
        oak.edits = {cut};
        const GrowthMesh answered = made(oak, options);
        // The farthest end that the limb has without the cut, and how far the nearest bark is from there.
        const auto missAt = [&](const GrowthMesh& growth, bool isBefore) {
            const auto key = std::ranges::find_if(growth.keys, [&](const GrowthKey& one) {
                return isBefore ? one.age >= 15.0 && one.age < 20.0 : one.age > 22.0;
            });
            if (key == growth.keys.end())
                qFatal("no key");
            const WoodAtAge wood = woodAtAge(*history, key->age);
            Index end = noIndex;
            for (Index i = 0; i < history->size(); ++i)
                if (history->axis[i] == limb && wood.radius[i] > 0.0)
                    end = i;
            double least = 1e9;
            for (const glm::vec3& place : key->positions)
                least = std::min(least, glm::distance(glm::dvec3(place), wood.at[end]));
            return least;
        };
        QVERIFY2(missAt(whole, false) < 0.15, qPrintable(QString::number(missAt(whole, false))));
        QVERIFY2(missAt(answered, true) < 0.15, qPrintable(QString::number(missAt(answered, true))));
        QVERIFY2(missAt(answered, false) > 0.3, qPrintable(QString::number(missAt(answered, false))));
    }

    void leavesOpenWhereTheyStand()
    {
        NodeParams birch = treeOf("SilverBirch", 20.0);
        const std::vector<double> ages{1.0, 8.0, 20.0};
        const auto leaves = growthLeaves(birch, ages, 6'000, true);
        QVERIFY2(leaves, test::why(leaves).constData());
        QCOMPARE(leaves->size(), ages.size());
        for (const GrowthLeaves& each : *leaves) {
            QVERIFY(each.mesh && each.mesh->faceCount() <= 6'200);
            QCOMPARE(each.closed.size(), each.mesh->positions.size());
            QVERIFY(!each.mesh->uv.empty());
        }
        birch.season.day = 20.0; // winter
        const auto bare = growthLeaves(birch, ages, 6'000, true);
        QVERIFY(bare);
        for (const GrowthLeaves& each : *bare)
            QVERIFY(!each.mesh && each.closed.empty());
    }
};

RAMURE_SUITE(TestGrowthMesh)

} // namespace tst_growth_mesh

#include "tst_growth_mesh.moc"
