#include "widgets/view/render/crowd/crowd_choice.h"

#include "core/math/random.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <cmath>
#include <set>

namespace tst_crowd_choice {

using namespace ramure;

namespace {

CrowdPrototype tree()
{
    CrowdPrototype made;
    made.box = {glm::dvec3(-3.0, 0.0, -3.0), glm::dvec3(3.0, 10.0, 3.0)};
    for (const auto& [triangles, pixels] : {std::pair(1000, 200.0), {100, 50.0}, {6, 0.0}}) {
        made.forms.emplace_back();
        made.forms.back().triangles = triangles;
        made.forms.back().leastPixels = pixels;
    }
    made.wholeTriangles = 50'000;
    return made;
}

std::shared_ptr<const Crowd> crowdOf(std::vector<ScatterPlace> places,
                                     std::vector<CrowdPrototype> prototypes = {tree()})
{
    return *Crowd::make(std::make_shared<const std::vector<ScatterPlace>>(std::move(places)),
                        std::move(prototypes));
}

std::vector<ScatterPlace> scattered(std::size_t count, double reach)
{
    Random random(2, RandomStream::Test);
    std::vector<ScatterPlace> places(count);
    for (ScatterPlace& place : places)
        place.position = {random.range(-reach, reach), 0.0, random.range(-reach, reach)};
    return places;
}

/// Looks along -Z from the eye, ten metres high at a thousand pixels from 10 m.
CrowdSight sightFrom(const glm::dvec3& eye)
{
    CrowdSight sight;
    sight.eye = eye;
    sight.pixels = 1000.0;
    for (const glm::dvec3& inwards :
         {glm::dvec3(1.0, 0.0, -1.0), {-1.0, 0.0, -1.0}, {0.0, 1.0, -1.0}, {0.0, -1.0, -1.0}})
        sight.planes.emplace_back(inwards, -glm::dot(inwards, eye));
    return sight;
}

constexpr CrowdBudget plenty{1'000'000'000, 1'000'000'000, 300.0, 1.0};

std::size_t placed(const CrowdChoice& choice)
{
    std::size_t count = choice.whole.size();
    for (const CrowdChoice::OfForm& of : choice.forms)
        count += std::size_t(std::ranges::count_if(
            *of.places, [](const MeshCopy& copy) { return copy.tint.a < 128 || copy.tint.a == 255; }));
    return count;
}

} // namespace

class TestCrowdChoice : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void nobodyIsSeen()
    {
        const CrowdChoice none = chooseForms(*crowdOf({}), sightFrom({}), plenty);
        QVERIFY(none.forms.empty() && none.whole.empty() && none.instances == 0 && none.triangles == 0);
        ScatterPlace behind;
        behind.position.z = 30.0;
        QCOMPARE(chooseForms(*crowdOf({behind}), sightFrom({}), plenty).instances, std::size_t(0));
        QCOMPARE(
            chooseForms(*crowdOf({ScatterPlace()}, {CrowdPrototype()}), sightFrom({0.0, 0.0, 9.0}), plenty)
                .instances,
            std::size_t(0));
    }
    void fromWithinATree()
    {
        const CrowdChoice inside =
            chooseForms(*crowdOf({ScatterPlace()}), sightFrom({0.0, 5.0, 0.0}), plenty);
        QCOMPARE(inside.whole, std::vector<Index>{0});
    }
    void nearIsFinerThanFar()
    {
        std::size_t last = 0;
        for (const double away : {12.0, 40.0, 120.0, 1000.0}) {
            ScatterPlace place;
            place.position.z = -away;
            const CrowdChoice choice = chooseForms(*crowdOf({place}), sightFrom({0.0, 5.0, 0.0}), plenty);
            QCOMPARE(choice.instances, std::size_t(1));
            if (away == 12.0) {
                QCOMPARE(choice.whole.size(), std::size_t(1));
                continue;
            }
            QCOMPARE(choice.forms.size(), std::size_t(1));
            QCOMPARE(choice.forms[0].form, last++);
            QCOMPARE(choice.triangles, tree().forms[choice.forms[0].form].triangles);
        }
    }
    void whereFormsPassTheyShareAllPixels()
    {
        // 10 m are 200 pixels at 50 m.
        for (const double away : {46.0, 48.0, 50.0, 52.0, 54.0}) {
            ScatterPlace place;
            place.position = {0.0, -5.0, -away};
            const CrowdChoice choice = chooseForms(*crowdOf({place}), sightFrom({}), plenty);
            QCOMPARE(choice.forms.size(), std::size_t(2));
            const int first = choice.forms[0].places->front().tint.a,
                      second = choice.forms[1].places->front().tint.a;
            QVERIFY(first < 128 && second == first + 128);
        }
    }
    void coincidentTreesAreAllThere()
    {
        const CrowdChoice choice =
            chooseForms(*crowdOf(std::vector<ScatterPlace>(500)), sightFrom({0.0, 5.0, 30.0}), plenty);
        QCOMPARE(choice.instances, std::size_t(500));
        QCOMPARE(placed(choice), std::size_t(500));
    }
    void everyoneInSightIsDrawnOnce()
    {
        const auto crowd = crowdOf(scattered(4000, 300.0));
        const CrowdSight sight = sightFrom({0.0, 5.0, 0.0});
        const CrowdChoice choice = chooseForms(*crowd, sight, plenty);
        std::size_t seen = 0;
        for (const ScatterPlace& place : crowd->places()) {
            const Box box = crowd->boxOf(place);
            seen += std::ranges::all_of(
                        sight.planes,
                        [&](const CutPlane& plane) {
                            double most = -1e300;
                            for (int i = 0; i < 8; ++i)
                                most = std::max(most, glm::dot(glm::dvec3(plane), box.corner(i)) + plane.w);
                            return most >= 0.0;
                        })
                        ? 1
                        : 0;
        }
        QVERIFY(seen > 500 && seen < 2500);
        QCOMPARE(choice.instances, seen);
        QCOMPARE(placed(choice), seen);
        // The nearest come first: they hide the others.
        for (const CrowdChoice::OfForm& of : choice.forms)
            for (std::size_t i = 1; i < of.places->size(); ++i)
                QVERIFY(glm::length((*of.places)[i - 1].position) <
                        glm::length((*of.places)[i].position) + 10.0f);
    }
    void theBudgetIsKept()
    {
        const auto crowd = crowdOf(scattered(4000, 100.0));
        const CrowdSight sight = sightFrom({0.0, 5.0, 0.0});
        CrowdBudget budget = plenty;
        budget.whole = 120'000;
        QCOMPARE(chooseForms(*crowd, sight, budget).whole.size(), std::size_t(2));
        budget.whole = 0;
        std::int64_t last = chooseForms(*crowd, sight, budget).triangles;
        for (const std::int64_t triangles : {200'000, 100'000, 50'000, 20'000}) {
            budget.triangles = triangles;
            const CrowdChoice choice = chooseForms(*crowd, sight, budget);
            QVERIFY(choice.whole.empty());
            QVERIFY2(choice.triangles < last && double(choice.triangles) < 1.3 * double(triangles),
                     qPrintable(QString::number(choice.triangles)));
            QCOMPARE(placed(choice), choice.instances);
            last = choice.triangles;
        }
        budget.triangles = 0; // everyone still has its last form
        const CrowdChoice least = chooseForms(*crowd, sight, budget);
        QCOMPARE(least.triangles, std::int64_t(6 * least.instances));
    }
    void aCoarserPictureHasLessTriangles()
    {
        const auto crowd = crowdOf(scattered(2000, 200.0));
        CrowdBudget coarser = plenty;
        coarser.whole = 0;
        const CrowdSight sight = sightFrom({0.0, 5.0, 0.0});
        const std::int64_t all = chooseForms(*crowd, sight, coarser).triangles;
        coarser.coarser = 2.0;
        QVERIFY(chooseForms(*crowd, sight, coarser).triangles < all);
    }
    void parallelRaysSeeAllAlike()
    {
        const auto crowd = crowdOf(scattered(100, 50.0));
        CrowdSight sight;
        sight.isParallel = true;
        sight.pixels = 10.0;
        const CrowdChoice choice = chooseForms(*crowd, sight, plenty);
        QCOMPARE(choice.instances, std::size_t(100));
        QCOMPARE(choice.forms.size(), std::size_t(1));
    }
};

RAMURE_SUITE(TestCrowdChoice)

} // namespace tst_crowd_choice

#include "tst_crowd_choice.moc"
