#include "widgets/view/render/crowd/crowd.h"

#include "core/math/random.h"
#include "tests/support/suite.h"
#include <cmath>
#include <limits>

namespace tst_crowd {

using namespace ramure;

namespace {

/// A prototype of one form with nothing in it: its box alone counts here.
CrowdPrototype pillar()
{
    CrowdPrototype made;
    made.box = {glm::dvec3(-1.0, 0.0, -1.0), glm::dvec3(1.0, 10.0, 1.0)};
    made.forms.emplace_back();
    return made;
}

Expected<std::shared_ptr<const Crowd>> crowdOf(std::vector<ScatterPlace> places,
                                               std::vector<CrowdPrototype> prototypes = {pillar()})
{
    return Crowd::make(std::make_shared<const std::vector<ScatterPlace>>(std::move(places)),
                       std::move(prototypes));
}

} // namespace

class TestCrowd : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void placesThatAreNoneAreRefused()
    {
        constexpr double none = std::numeric_limits<double>::quiet_NaN(),
                         endless = std::numeric_limits<double>::infinity();
        std::vector<ScatterPlace> bad(8);
        bad[0].position.y = none;
        bad[1].position.x = endless;
        bad[2].size = 0.0;
        bad[3].size = -1.0;
        bad[4].size = none;
        bad[5].turn.w = none;
        bad[6].turn = glm::dquat(0.0, 0.0, 0.0, 0.0);
        bad[7].prototype = 1;
        for (const ScatterPlace& place : bad) {
            const auto made = crowdOf({ScatterPlace(), place});
            QVERIFY(!made);
            QCOMPARE(made.error().code, ErrorCode::Invalid);
            QCOMPARE(made.error().args, std::vector<std::string>{"1"});
        }
        QVERIFY(!crowdOf({ScatterPlace()}, {}));
    }
    void aCrowdOfNobodyIsEmpty()
    {
        const auto nobody = *Crowd::make(nullptr, {pillar()});
        QVERIFY(nobody->box().empty());
        QVERIFY(nobody->places().empty());
        QVERIFY(!nobody->meet({{0.0, 5.0, 20.0}, {0.0, 0.0, -1.0}}, 1e9));
        // A prototype that has no form, such as a tree that cannot grow, is not shown.
        const auto bare = *crowdOf({ScatterPlace()}, {CrowdPrototype()});
        QVERIFY(bare->box().empty());
        QVERIFY(bare->copies(0)->empty());
        QCOMPARE(bare->places().size(), std::size_t(1));
    }
    void aPlaceHasItsPrototypesBox()
    {
        ScatterPlace place;
        place.position = {5.0, 1.0, 0.0};
        place.size = 2.0;
        place.turn = glm::angleAxis(std::acos(0.0), glm::dvec3(0.0, 0.0, 1.0)); // lies along -X
        const auto crowd = *crowdOf({place});
        const Box& box = crowd->box();
        QVERIFY(glm::distance(box.min, glm::dvec3(-15.0, -1.0, -2.0)) < 1e-9);
        QVERIFY(glm::distance(box.max, glm::dvec3(5.0, 3.0, 2.0)) < 1e-9);
        const glm::dvec3 tip(placeMatrix(place) * glm::dvec4(0.0, 10.0, 0.0, 1.0));
        QVERIFY(glm::distance(tip, glm::dvec3(-15.0, 1.0, 0.0)) < 1e-9);
    }
    void copiesCountTheirPrototypesOwnPlacement()
    {
        CrowdPrototype prototype = pillar();
        prototype.local = {{1.0, 0.0, 0.0}, 3.0, glm::angleAxis(0.4, glm::dvec3(0.0, 1.0, 0.0)), 0};
        const ScatterPlace place{
            {2.0, 3.0, 4.0}, 0.5, glm::angleAxis(1.1, glm::normalize(glm::dvec3(1.0, 2.0, 0.5))), 0};
        const MeshCopy copy = copyOf(place, prototype);
        const glm::quat turn(copy.turn.w, copy.turn.x, copy.turn.y, copy.turn.z);
        const glm::dvec3 point(0.3, 0.7, -0.2);
        const glm::dvec3 wanted(placeMatrix(place) * placeMatrix(prototype.local) * glm::dvec4(point, 1.0));
        const glm::vec3 found = copy.position + turn * (copy.size * glm::vec3(point));
        QVERIFY(glm::distance(glm::dvec3(found), wanted) < 1e-5);
        QCOMPARE(copy.tint.a, std::uint8_t(255));
    }
    void aRayMeetsTheNearest()
    {
        std::vector<ScatterPlace> row(20);
        for (std::size_t i = 0; i < row.size(); ++i)
            row[i].position = {0.0, 0.0, -4.0 * double(i)};
        const auto crowd = *crowdOf(row);
        const auto hit = crowd->meet({{0.0, 5.0, 20.0}, {0.0, 0.0, -1.0}}, 1e9);
        QVERIFY(hit);
        QCOMPARE(hit->place, Index(0));
        QVERIFY(std::abs(hit->t - 19.0) < 1e-9);
        QVERIFY(!crowd->meet({{0.0, 5.0, 20.0}, {0.0, 0.0, -1.0}}, 18.0));
        QVERIFY(!crowd->meet({{0.99, 9.9, 20.0}, {0.0, 0.0, -1.0}}, 1e9)); // past the corners
        const auto within = crowd->meet({{0.0, 5.0, -40.0}, {0.0, 0.0, 1.0}}, 1e9);
        QVERIFY(within);
        QCOMPARE(within->place, Index(10));
    }
    void rayAgreesWithAllPlacesAskedOneByOne()
    {
        Random random(5, RandomStream::Test);
        std::vector<ScatterPlace> places(300);
        for (ScatterPlace& place : places) {
            place.position = {random.range(-40.0, 40.0), random.range(-5.0, 5.0), random.range(-40.0, 40.0)};
            place.size = random.range(0.2, 2.0);
            place.turn = glm::angleAxis(random.range(0.0, 6.0), glm::dvec3(0.0, 1.0, 0.0));
        }
        places[7] = places[6]; // coincident
        const auto crowd = *crowdOf(places);
        int hits = 0;
        for (int i = 0; i < 200; ++i) {
            const Ray ray{{random.range(-60.0, 60.0), random.range(0.0, 15.0), 70.0},
                          glm::normalize(glm::dvec3(random.range(-0.5, 0.5), random.range(-0.1, 0.1), -1.0))};
            const auto hit = crowd->meet(ray, 1e9);
            double nearest = std::numeric_limits<double>::infinity();
            for (const ScatterPlace& place : places)
                if (const auto alone = (*crowdOf({place}))->meet(ray, 1e9))
                    nearest = std::min(nearest, alone->t);
            QCOMPARE(hit.has_value(), std::isfinite(nearest));
            QVERIFY(!hit || std::abs(hit->t - nearest) < 1e-9);
            hits += hit ? 1 : 0;
        }
        QVERIFY(hits > 20);
    }
};

RAMURE_SUITE(TestCrowd)

} // namespace tst_crowd

#include "tst_crowd.moc"
