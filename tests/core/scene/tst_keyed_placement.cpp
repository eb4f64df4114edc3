#include "core/math/random.h"
#include "core/scene/keyed_placement.h"
#include "core/scene/world_transforms.h"
#include "tests/support/suite.h"
#include <limits>

namespace tst_keyed_placement {

using namespace ramure;

namespace {

glm::dvec3 some(Random& random, double most)
{
    return {random.range(-most, most), random.range(-most, most), random.range(-most, most)};
}

/// Translation times rotation times scale, as the scene does it.
glm::dmat4 worldOf(const NodeTransform& values, double seconds)
{
    Node node;
    node.params.tree = values.placement;
    for (std::size_t i = 0; i < values.tracks.size(); ++i)
        node.animation.set(globalChannel(i), values.tracks[i]);
    return worldUnder(glm::dmat4(1.0), node, seconds);
}

double difference(const glm::dmat4& a, const glm::dmat4& b)
{
    double most = 0.0;
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            most = std::max(most, std::abs(a[c][r] - b[c][r]));
    return most;
}

NodeTransform placed(Random& random)
{
    NodeTransform values;
    values.placement.translation = some(random, 3.0);
    values.placement.rotation = some(random, 1.4);
    const double size = random.range(0.5, 2.0);
    values.placement.scale = glm::dvec3(size);
    return values;
}

constexpr PlacementPart parts[] = {PlacementPart::Translation, PlacementPart::Rotation, PlacementPart::Scale};

} // namespace

class TestKeyedPlacement : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void whatIsNoNumberIsRefused()
    {
        for (const double bad : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL})
            for (const PlacementPart part : parts)
                QVERIFY(!withPlacementSet({}, 0, part, {0.0, bad, 0.0}, {}));
        NodeTransform flat;
        flat.placement.scale.y = 0.0;
        flat.placement.rotation.x = 1.0;
        Key key;
        flat.tracks[4] = std::make_shared<const AnyTrack>(*Track::fromKeys({key}));
        QVERIFY(!withPlacementSet(flat, 0, PlacementPart::Scale, glm::dvec3(1.0), {}));
    }
    void firstKeysHaveTheValuesOfTheFieldsAndMoveNothing()
    {
        Random random(3, RandomStream::Test);
        for (int run = 0; run < 200; ++run)
            for (const PlacementPart part : parts) {
                const NodeTransform before = placed(random);
                const auto keyed = withPlacementKeys(before, ticksPerSecond, part);
                QVERIFY(keyed);
                for (const double t : {0.0, 1.0, 5.0})
                    QVERIFY(difference(worldOf(before, t), worldOf(*keyed, t)) < 1e-12);
                const auto& x = std::get<Track>(*keyed->tracks[0]);
                QCOMPARE(x.keys()[0].value, before.placement.translation.x);
                QCOMPARE(keyed->placement.translation, glm::dvec3(0.0));
                QCOMPARE(keyed->tracks[3] != nullptr, part != PlacementPart::Translation);
                const PlacementParams shown = placementAt(*keyed, 1.0);
                QVERIFY(glm::length(shown.rotation - before.placement.rotation) < 1e-9);
                QVERIFY(glm::length(shown.scale - before.placement.scale) < 1e-12);
                // Once more at the same time changes nothing.
                const auto again = withPlacementKeys(*keyed, ticksPerSecond, part);
                QVERIFY(again && again->tracks == keyed->tracks);
            }
    }
    void aKeyThatIsSetGivesTheFieldItsValueAndLeavesTheOriginAlone()
    {
        Random random(4, RandomStream::Test);
        for (int run = 0; run < 300; ++run) {
            NodeTransform values = placed(random);
            if (run % 3 == 1) { // a turn is there already: nothing can be taken over
                OrientationKey key;
                key.value = glm::normalize(glm::dquat(1.0, some(random, 1.0)));
                values.tracks[3] = std::make_shared<const AnyTrack>(*OrientationTrack::fromKeys({key}));
            }
            if (run % 3 == 2)
                values = *withPlacementKeys(values, 0, PlacementPart::Translation);
            for (const PlacementPart part : parts) {
                const PlacementParams before = placementAt(values, 2.0);
                const glm::dvec3 wanted =
                    part == PlacementPart::Scale ? glm::dvec3(random.range(0.3, 3.0)) : some(random, 1.4);
                const auto made = withPlacementSet(values, 2 * ticksPerSecond, part, wanted, {});
                QVERIFY(made);
                const PlacementParams after = placementAt(*made, 2.0);
                const bool moves = part == PlacementPart::Translation;
                QVERIFY(glm::length(after.translation - (moves ? wanted : before.translation)) < 1e-9);
                QVERIFY(glm::length(glm::dvec3(worldOf(*made, 2.0)[3]) - after.translation) < 1e-9);
                if (part == PlacementPart::Rotation) {
                    const glm::dmat3 difference = rotationMatrix(after.rotation) - rotationMatrix(wanted);
                    QVERIFY(glm::length(difference[0]) + glm::length(difference[1]) < 1e-9);
                }
                if (part == PlacementPart::Scale)
                    QVERIFY(glm::length(after.scale - wanted) < 1e-9);
                values = *made;
            }
        }
    }
    void oneComponentIsKeyedAlone()
    {
        const auto made =
            withPlacementSet({}, ticksPerSecond, PlacementPart::Translation, {1.0, 2.0, 3.0}, 1);
        QVERIFY(made && !made->tracks[0] && made->tracks[1] && !made->tracks[2]);
        QCOMPARE(placementAt(*made, 0.0).translation, glm::dvec3(0.0, 2.0, 0.0));
    }
};

RAMURE_SUITE(TestKeyedPlacement)

} // namespace tst_keyed_placement

#include "tst_keyed_placement.moc"
