#include "widgets/view/render/meadow.h"

#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/surface/foliage/place_foliage.h"
#include "tests/support/suite.h"
#include <cmath>

namespace tst_meadow {

using namespace ramure;

namespace {

constexpr auto level = [](const glm::dvec2&) { return 0.25; };

/// A little crown of so many leaves, of which the season took some.
Foliage crownOf(LeafShape shape, std::size_t leaves, std::size_t shed)
{
    Foliage made;
    LeafParams params;
    params.shape = shape;
    params.length = 0.1;
    made.form = leafForm(params);
    for (std::size_t i = 0; i < leaves; ++i) {
        FoliageItem item;
        item.branch = 0;
        item.position = {3.0 * std::cos(double(i)), 4.0, 3.0 * std::sin(double(i))};
        made.leaves.push_back(item);
    }
    made.shed = shed;
    return made;
}

} // namespace

class TestMeadow : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void withoutFeetThereIsNone()
    {
        QVERIFY(grassAround({}, level).copies.empty());
        QVERIFY(grassAround({{glm::dvec3(0.0), 0.0}}, level).copies.empty());
        QVERIFY(grassAround({{glm::dvec3(0.0), 1e-9}}, level).copies.empty());
    }

    /// It stands on the ground around the feet, leaves the litter between roots bare, and is the same at
    /// every call.
    void grassStandsAroundFeet()
    {
        for (const double reach : {0.02, 0.6, 5.0, 60.0}) {
            const Foot foot{{7.0, 0.0, -3.0}, reach};
            const MeshCopies grass = grassAround({foot}, level);
            QVERIFY(grass.copies.size() > 500);
            const MeshCopies again = grassAround({foot}, level);
            QCOMPARE(again.copies.size(), grass.copies.size());
            for (std::size_t i = 0; i < grass.copies.size(); ++i) {
                const MeshCopy& tuft = grass.copies[i];
                QCOMPARE(tuft.position, again.copies[i].position);
                QCOMPARE(tuft.position.y, 0.25f);
                const double away = std::hypot(tuft.position.x - 7.0, tuft.position.z + 3.0);
                QVERIFY(away > 0.9 * reach && away < 4.6 * reach + 6.0);
                QVERIFY(tuft.size > 0.2f && tuft.size < 1.3f);
            }
        }
    }

    /// Coarser details have fewer faces, and all of them belong to the shape.
    void detailsAreOfTheShape()
    {
        const MeshCopies grass = grassAround({{glm::dvec3(0.0), 1.0}}, level);
        QCOMPARE(grass.shape.normals.size(), grass.shape.positions.size());
        QCOMPARE(grass.colours.size(), grass.shape.positions.size());
        Index before = 0;
        for (const LeafDetail how : {LeafDetail::Least, LeafDetail::Few, LeafDetail::All}) {
            const auto faces = grass.faces(how);
            QVERIFY(faces.count > before && faces.from + faces.count <= grass.shape.faceCount());
            before = faces.count;
        }
        QVERIFY(grass.reach > 0.0f);
    }

    /// However many trees there are, the grass costs a picture as much.
    void manyFeetShareTheGrass()
    {
        std::vector<Foot> feet;
        for (int i = 0; i < 200; ++i)
            feet.push_back({{8.0 * (i % 20), 0.0, 0.4 * (i - i % 20)}, 0.5 + 0.001 * i});
        QVERIFY(grassAround(feet, level).copies.size() <= 16'000);
    }

    void leavesFallInAutumn()
    {
        const Foot foot{glm::dvec3(0.0), 0.4};
        const auto fallen = [&](LeafShape shape, std::size_t hanging, std::size_t shed) {
            const Foliage crown = crownOf(shape, hanging, shed);
            return fallenLeaves(crown, crown, 0.3, foot, level).copies.size();
        };
        QCOMPARE(fallen(LeafShape::Faithful, 1000, 0), std::size_t(0));
        QCOMPARE(fallen(LeafShape::Spruce, 1000, 500), std::size_t(0));
        QCOMPARE(fallen(LeafShape::Oak, 0, 0), std::size_t(0));
        QVERIFY(fallen(LeafShape::Oak, 1000, 0) < fallen(LeafShape::Oak, 500, 500));
        QVERIFY(fallen(LeafShape::Oak, 0, 500) > 100); // a bare tree has lost them all
        QVERIFY(fallen(LeafShape::Oak, 3'000'000, 3'000'000) <= 6'250);
        const Foliage half = crownOf(LeafShape::Oak, 500, 500);
        const MeshCopies lying = fallenLeaves(half, half, 0.3, foot, level);
        for (const MeshCopy& leaf : lying.copies) {
            QVERIFY(leaf.position.y > 0.25f && leaf.position.y < 0.3f);
            const glm::quat turn(leaf.turn.w, leaf.turn.x, leaf.turn.y, leaf.turn.z);
            QVERIFY(std::abs(glm::length(turn) - 1.0f) < 1e-5f);
            QVERIFY(std::abs((turn * glm::vec3(0.0f, 0.0f, 1.0f)).y) > 0.7f); // it lies
        }
    }

    /// Before new leaves come, fewer of the last year lie there, as wide as the crown and all of them brown.
    void lastYearsLeavesAreBrown()
    {
        const Foot foot{glm::dvec3(0.0), 0.4};
        const Foliage summer = crownOf(LeafShape::Maple, 1000, 0),
                      autumn = crownOf(LeafShape::Maple, 0, 1000);
        Foliage march = autumn;
        march.toCome = march.shed;
        const MeshCopies fresh = fallenLeaves(autumn, summer, 0.3, foot, level),
                         old = fallenLeaves(march, summer, 0.3, foot, level);
        QVERIFY(old.copies.size() > 100 && old.copies.size() < fresh.copies.size());
        const auto redness = [](const MeshCopy& leaf) {
            return double(leaf.tint.r) / double(leaf.tint.b + 1);
        };
        const auto reddest = [&](const MeshCopies& of) {
            return redness(*std::ranges::max_element(of.copies, {}, redness));
        };
        QVERIFY(reddest(old) < 0.8 * reddest(fresh));
        QVERIFY(std::ranges::any_of(old.copies, [](const MeshCopy& leaf) {
            return std::hypot(double(leaf.position.x), double(leaf.position.z)) > 2.5;
        }));
    }
};

RAMURE_SUITE(TestMeadow)

} // namespace tst_meadow

#include "tst_meadow.moc"
