#include "core/math/stage_hash.h"
#include "core/surface/bark/bark_maps.h"
#include "core/surface/bark/bark_pattern.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <set>

namespace tst_bark_maps {

using namespace ramure;

namespace {

BarkParams of(BarkFamily family)
{
    BarkParams params;
    params.family = family;
    return params;
}

BarkMaps made(const BarkParams& params, int size)
{
    auto maps = barkMaps(params, size);
    return maps ? std::move(*maps) : BarkMaps();
}

int difference(const glm::u8vec3& a, const glm::u8vec3& b)
{
    return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

/// The largest step from one row, or column, to the next, over rows first .. last - 1.
int largestStep(const BarkMaps& maps, int line, int pixel, int first, int last)
{
    int largest = 0;
    for (int i = first; i < last; ++i)
        for (int j = 0; j < maps.size; ++j) {
            const auto here = std::size_t(i * line + j * pixel);
            const auto next = std::size_t(((i + 1) % maps.size) * line + j * pixel);
            largest = std::max(largest, difference(maps.colour[here], maps.colour[next]));
        }
    return largest;
}

} // namespace

class TestBarkMaps : public QObject
{
    Q_OBJECT

private:
    static void everyFamily()
    {
        QTest::addColumn<int>("family");
        for (int i = 1; i <= int(BarkFamily::PalmBoots); ++i)
            QTest::addRow("%d", i) << i;
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void whatCannotBeMadeIsAnError()
    {
        QCOMPARE(barkMaps(of(BarkFamily::Plain), 64).error().code, ErrorCode::Invalid);
        for (const int size : {-1, 0, leastBarkSize - 1, mostBarkSize + 1})
            QCOMPARE(barkMaps(of(BarkFamily::Smooth), size).error().code, ErrorCode::Limit);
        std::stop_source stop;
        stop.request_stop();
        QCOMPARE(barkMaps(of(BarkFamily::Smooth), 64, {stop.get_token(), {}}).error().code,
                 ErrorCode::Cancelled);
    }

    void aTileMeetsItself_data() { everyFamily(); }
    void aTileMeetsItself()
    {
        QFETCH(int, family);
        const BarkLook& look = barkLook(BarkFamily(family));
        for (int i = 0; i < 200; ++i) {
            const glm::vec2 at(float(i) / 200.0f, float((i * 37) % 200) / 200.0f);
            for (const glm::vec2 tile : {glm::vec2(1, 0), glm::vec2(0, 1), glm::vec2(-1, 2)}) {
                const BarkSample here = look.at(at, 5u), there = look.at(at + tile, 5u);
                QVERIFY(std::abs(here.height - there.height) <= 1.0f / 255.0f);
            }
        }
        // Nor does a picture show where its edge is.
        const BarkMaps maps = made(of(BarkFamily(family)), 64);
        QCOMPARE(maps.size, 64);
        for (const auto& [line, pixel] : {std::pair(64, 1), std::pair(1, 64)})
            QVERIFY(largestStep(maps, line, pixel, 63, 64) <=
                    std::max(30, 2 * largestStep(maps, line, pixel, 0, 63)));
    }

    void mapsAreWholeAndTheSameEachTime_data() { everyFamily(); }
    void mapsAreWholeAndTheSameEachTime()
    {
        QFETCH(int, family);
        const BarkParams params = of(BarkFamily(family));
        const BarkMaps one = made(params, 48), two = made(params, 48);
        constexpr std::size_t count = 48 * 48;
        QCOMPARE(one.colour.size(), count);
        QCOMPARE(one.height.size(), count);
        QCOMPARE(one.occlusion.size(), count);
        QCOMPARE(one.roughness.size(), count);
        QCOMPARE(one.normal.size(), count);
        QVERIFY(one.colour == two.colour && one.normal == two.normal && one.height == two.height);
        // There is something to see, and normals look out of the surface.
        const auto [low, high] = std::ranges::minmax(one.height);
        QVERIFY(high - low > 20);
        QVERIFY(std::ranges::all_of(one.normal, [](const glm::u8vec3& n) { return n.z > 128; }));
        BarkParams other = params;
        other.seed = 2;
        QVERIFY(made(other, 48).height != one.height);
    }

    void barkAgesAsWoodThickens_data() { everyFamily(); }
    void barkAgesAsWoodThickens()
    {
        QFETCH(int, family);
        const BarkMaps maps = made(of(BarkFamily(family)), 16);
        QCOMPARE(maps.young, youngColour(of(BarkFamily(family))));
        float last = 0.0F;
        for (double radius = 0.0; radius < 0.3; radius += 0.001) {
            const float age = barkAge(BarkFamily(family), radius);
            QVERIFY(age >= last && age <= 1.0F);
            last = age;
        }
        QCOMPARE(barkAge(BarkFamily(family), double(maps.youngRadius)), 0.0F);
        QCOMPARE(barkAge(BarkFamily(family), 1.01 * double(maps.oldRadius)), 1.0F);
    }

    void limbsHaveTheirOwnBark_data() { everyFamily(); }
    void limbsHaveTheirOwnBark()
    {
        QFETCH(int, family);
        const BarkParams params = of(BarkFamily(family));
        const BarkMaps maps = made(params, 32);
        float last = 0.0F;
        for (double radius = 0.0; radius < 2.5; radius += 0.005) {
            const float ripe = barkRipeness(BarkFamily(family), radius);
            QVERIFY(ripe >= last && ripe <= 1.0F);
            last = ripe;
        }
        QCOMPARE(last, 1.0F);
        const bool own = barkRipeness(BarkFamily(family), 0.0) == 0.0F;
        QCOMPARE(own, limbColour(params) != meanColour(params));
        // The picture's mean times the limbs' tone is the limbs' colour.
        const glm::vec3 toned = glm::vec3(meanColour(params)) * maps.limb;
        QVERIFY(glm::length(toned - glm::vec3(limbColour(params))) < 1.0F);
        QVERIFY(maps.youngRadius < maps.limbRadius && maps.limbRadius < maps.ripeRadius);
        QVERIFY(maps.grey > 0.1F && maps.grey < 1.0F);
    }

    /// Wide patches of the tree: no step from one millimetre to the next, and as much clean bark as
    /// weathered.
    void weatherIsOfThePlace()
    {
        double sum = 0.0;
        int clean = 0, count = 0;
        for (float y = -20.0F; y < 20.0F; y += 0.093F)
            for (float x = -0.5F; x < 0.5F; x += 0.11F) {
                const glm::vec3 place(x, y, 0.3F * x);
                const float here = barkWeather(place);
                QVERIFY(here >= 0.0F && here <= 1.0F && here == barkWeather(place));
                QVERIFY(std::abs(barkWeather(place + glm::vec3(0.001F)) - here) < 0.03F);
                sum += double(here);
                clean += here < 0.1F ? 1 : 0;
                ++count;
            }
        QVERIFY(sum > 0.15 * count && sum < 0.6 * count);
        QVERIFY(clean > count / 8 && clean < count / 2);
        for (const float far : {1e5F, -1e30F, std::numeric_limits<float>::infinity()})
            QVERIFY(std::isfinite(barkWeather({far, -far, 0.0F})));
    }

    void familiesDiffer()
    {
        std::set<QByteArray> seen;
        for (int i = 1; i <= int(BarkFamily::PalmBoots); ++i) {
            const BarkMaps maps = made(of(BarkFamily(i)), 32);
            seen.emplace(reinterpret_cast<const char*>(maps.height.data()), maps.height.size());
        }
        QCOMPARE(seen.size(), std::size_t(BarkFamily::PalmBoots));
    }

    void numbersDoWhatTheySay()
    {
        BarkParams params = of(BarkFamily::Furrowed);
        const auto usual = meanColour(params);
        params.light = 0.3;
        QVERIFY(meanColour(params).x > usual.x);
        params.light = -1.0;
        QCOMPARE(meanColour(params), glm::u8vec3(0));
        params.light = 0.0;
        params.moss = 1.0;
        const auto mossy = meanColour(params);
        QVERIFY(mossy.y > mossy.x && mossy.y > mossy.z);
        params.depth = 0.0;
        const BarkMaps flat = made(params, 32);
        for (const glm::u8vec3& normal : flat.normal)
            QCOMPARE(normal, glm::u8vec3(128, 128, 255));
    }

    void theMeanIsThatOfTheMap()
    {
        const BarkParams params = of(BarkFamily::Plated);
        glm::vec3 sum(0.0f);
        const BarkMaps maps = made(params, 128);
        for (const glm::u8vec3& colour : maps.colour)
            sum += glm::vec3(colour);
        QVERIFY(difference(meanColour(params), glm::u8vec3(sum / float(maps.colour.size()))) <= 12);
    }
    /// Files on disk are named by it: what gives other pictures raises barkVersion, and then this sum
    /// changes.
    void picturesAreThoseOfTheirVersion()
    {
        StageHash hash(0);
        for (int family = 1; family <= int(BarkFamily::PalmBoots); ++family) {
            BarkParams params = of(BarkFamily(family));
            params.moss = 0.3;
            const BarkMaps maps = made(params, 48);
            for (std::size_t i = 0; i < maps.height.size(); ++i)
                hash.add((maps.colour[i].x << 16) + (maps.colour[i].y << 8) + maps.colour[i].z)
                    .add((maps.normal[i].x << 16) + (maps.normal[i].y << 8) + maps.normal[i].z)
                    .add((maps.height[i] << 16) + (maps.occlusion[i] << 8) + maps.roughness[i]);
        }
        QCOMPARE(barkVersion, 8);
        QCOMPARE(hash.value(), std::uint64_t(0x396AD1610623DA45));
    }
};

RAMURE_SUITE(TestBarkMaps)

} // namespace tst_bark_maps

#include "tst_bark_maps.moc"
