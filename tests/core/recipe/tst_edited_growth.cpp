#include "core/skeleton/edit_places.h"
#include "tests/support/shaped_tree.h"

#include <cmath>
#include <set>

namespace tst_edited_growth {

using namespace ramure;
using namespace ramure::test;

/// Edits that make axes, put limbs elsewhere or take what stands out away, and edits of what they made.
class TestEditedGrowth : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void draws();
    void growsOnWhatIsDrawn();
    void growsAsDenseAsBesideIt();
    void drawsFromTheGround();
    void extends();
    void redraws();
    void grafts();
    void graftsFromAnotherTree();
    void moves();
    void prunes();
    void prunesToOutlinesAndMeshes();
    void leaves();
    void roots();
    void laterEditsOfWhatWasDrawn();
    void untouchedLimbsKeepTheirNames();
    void whatWasTakenAwayIsSaid();
    void placesHoldWhereAnAxisIsSplit();
};

void TestEditedGrowth::draws()
{
    Shaped shaped;
    TreeEdit edit = editOf(EditOperation::Draw, shaped.address[0]);
    edit.at = 0.4;
    edit.points = {{{1.0, 2.5, 0.0}, 0.05}, {{1.5, 3.5, 0.0}, 0.03}};
    const double trunk = shaped.axis(shaped.address[0])->length;
    const auto id = shaped.make(edit);
    QVERIFY(id);
    const std::optional<Axis> drawn = shaped.axis(*id);
    QVERIFY(drawn);
    QCOMPARE(drawn->nodes, Index{2});
    QCOMPARE(drawn->order, Index{1});
    QVERIFY(isNear(drawn->share, 0.4));
    QVERIFY(isNear(shaped.tip(*id), {1.5, 3.5, 0.0}));
    QVERIFY(isNear(shaped.axis(shaped.address[0])->length, trunk));
    QVERIFY(shaped.tree(Stage::Mesh).report->valid);
    // It keeps its place on its parent when that is turned, and its values are the parent's.
    TreeEdit turn = editOf(EditOperation::Bend, shaped.address[0]);
    turn.from = 0.0;
    turn.rotation = {0.0, 1.0, 0.0};
    QVERIFY(shaped.make(turn));
    QVERIFY(isNear(shaped.axis(*id)->share, 0.4));
    QVERIFY(isNear(shaped.axis(*id)->downAngle, drawn->downAngle));
}

void TestEditedGrowth::growsOnWhatIsDrawn()
{
    Shaped shaped;
    TreeEdit edit = editOf(EditOperation::Draw, shaped.address[0]);
    edit.at = 0.4;
    edit.below = true;
    const Axis limb = *shaped.axis(shaped.address[1]), twig = *shaped.axis(shaped.address[2]);
    edit.points = {{{1.0, 2.5, 0.0}, limb.radius}}; // thick enough for the twig as it is
    const auto id = shaped.make(edit);
    QVERIFY(id);
    const Axis drawn = *shaped.axis(*id);
    const TreeAxes axes = axesOf(shaped.skeleton());
    QCOMPARE(axes.axes.size(), std::size_t{6}); // a twig as that of the limb
    const Axis& grown = axes.axes.back();
    QCOMPARE(axes.axes[grown.parent].address, *id);
    QVERIFY(isNear(drawn.length - grown.s, limb.length - twig.s)); // m from the tip
    QVERIFY(isNear(grown.downAngle, twig.downAngle));
    QVERIFY(isNear(grown.length, twig.length));
    // It can be edited too, and has a name of its own.
    QVERIFY(shaped.make(editOf(EditOperation::Remove, grown.address)));
    QCOMPARE(axesOf(shaped.skeleton()).axes.size(), std::size_t{5});
}

/// Also on strokes that are much longer or shorter than what grows beside them, from the trunk, a twig and
/// the ground: as many per metre, none thicker than what it stands on.
void TestEditedGrowth::growsAsDenseAsBesideIt()
{
    Shaped shaped;
    const auto perMetre = [&shaped](std::uint64_t address) {
        const TreeAxes axes = axesOf(shaped.skeleton());
        const auto own = std::ranges::find(axes.axes, address, &Axis::address);
        const auto onIt = std::ranges::count(axes.axes, Index(own - axes.axes.begin()), &Axis::parent);
        return double(onIt) / own->length;
    };
    const double beside = perMetre(shaped.address[1]);
    const Axis twig = *shaped.axis(shaped.address[2]), limb = *shaped.axis(shaped.address[1]);
    const auto tipOf = [](Shaped& tree, std::uint64_t address) {
        return EditContext(*tree.tree().grown, tree.params.edits).pointOn(address, 1.0)->radius;
    };
    const double slender = twig.length / twig.radius; // thinner ones are shorter, too
    for (const double length : {0.7, 4.0, 20.0}) {
        Shaped tree;
        TreeEdit edit = editOf(EditOperation::Draw, tree.address[0]);
        edit.at = 0.4;
        edit.below = true;
        edit.points = {{{length, 0.0, 0.0}, 0.0}};
        const auto id = tree.make(edit);
        QVERIFY(id);
        const TreeAxes axes = axesOf(tree.skeleton());
        const auto own = std::ranges::find(axes.axes, *id, &Axis::address);
        const auto number = Index(own - axes.axes.begin());
        const auto count = std::ranges::count(axes.axes, number, &Axis::parent);
        QVERIFY2(std::abs(double(count) - beside * own->length) <= 1.0, qPrintable(QString::number(count)));
        // No stouter than the limb beside it for its length, and ending as thin.
        QVERIFY(own->radius <= limb.radius * std::max(1.0, own->length / limb.length) + 1e-9);
        QVERIFY(tipOf(tree, *id) <= tipOf(shaped, shaped.address[1]) + 1e-9);
        for (const Axis& axis : axes.axes)
            if (axis.parent == number)
                QVERIFY(axis.radius < own->radius && isNear(axis.length / axis.radius, slender));
        std::set<std::uint64_t> addresses;
        for (const Axis& axis : axes.axes)
            addresses.insert(axis.address);
        QCOMPARE(addresses.size(), axes.axes.size());
        QVERIFY(tree.tree(Stage::Mesh).report->valid);
    }
    TreeEdit stem = editOf(EditOperation::Draw, 0);
    stem.below = true;
    stem.points = {{{6.0, 0.0, 0.0}, 0.2}, {{6.0, 3.0, 0.0}, 0.1}};
    const auto id = shaped.make(stem);
    QVERIFY(id);
    QVERIFY(perMetre(*id) > 0.0);
}

void TestEditedGrowth::drawsFromTheGround()
{
    Shaped shaped;
    TreeEdit edit = editOf(EditOperation::Draw, 0);
    edit.points = {{{3.0, 0.0, 0.0}, 0.0}, {{3.0, 1.0, 0.5}, 0.0}};
    const auto id = shaped.make(edit);
    QVERIFY(id);
    QCOMPARE(shaped.axis(*id)->order, Index{0});
    QVERIFY(isNear(shaped.tip(*id), {3.0, 1.0, 0.5}));
    const TreeResult tree = shaped.tree(Stage::Mesh);
    QVERIFY(tree.report->valid);
    QCOMPARE(tree.branches->roots, Index{2});
}

void TestEditedGrowth::extends()
{
    Shaped shaped;
    TreeEdit edit = editOf(EditOperation::Extend, shaped.address[2]);
    const glm::dvec3 tip = shaped.tip(shaped.address[2]);
    edit.points = {{tip, 0.0}, {tip + glm::dvec3(0.0, 0.5, 0.0), 0.0}};
    const Axis before = *shaped.axis(shaped.address[2]);
    QVERIFY(shaped.make(edit));
    const Axis after = *shaped.axis(shaped.address[2]);
    QVERIFY(isNear(after.length, before.length + 0.5));
    QCOMPARE(after.nodes, before.nodes + 1);
    QVERIFY(isNear(shaped.tip(shaped.address[2]), tip + glm::dvec3(0.0, 0.5, 0.0)));
}

void TestEditedGrowth::redraws()
{
    Shaped shaped;
    TreeEdit edit = editOf(EditOperation::Redraw, shaped.address[1]);
    const EditContext context(*shaped.tree().grown, {});
    const glm::dvec3 foot = context.pointOn(shaped.address[1], 0.0)->position;
    edit.points = {
        {foot, 0.0}, {foot + glm::dvec3(1.0, 0.0, 0.0), 0.0}, {foot + glm::dvec3(1.0, 2.0, 0.0), 0.0}};
    const Axis twig = *shaped.axis(shaped.address[2]);
    QVERIFY(shaped.make(edit));
    QVERIFY(isNear(shaped.axis(shaped.address[1])->length, 3.0));
    QVERIFY(isNear(shaped.tip(shaped.address[1]), foot + glm::dvec3(1.0, 2.0, 0.0)));
    // The twig stands on the tip still, and leaves it by the same angle.
    QVERIFY(isNear(shaped.axis(shaped.address[2])->share, twig.share));
    QVERIFY(isNear(shaped.axis(shaped.address[2])->downAngle, twig.downAngle));
    QVERIFY(isNear(shaped.axis(shaped.address[2])->length, twig.length));
}

void TestEditedGrowth::grafts()
{
    Shaped shaped;
    TreeEdit edit = editOf(EditOperation::Graft, shaped.address[0]);
    edit.other.address = shaped.address[1];
    edit.at = 0.8;
    edit.azimuthRad = 1.25;
    edit.factor = 0.5;
    const Axis original = *shaped.axis(shaped.address[1]);
    QVERIFY(shaped.make(edit));
    const TreeAxes axes = axesOf(shaped.skeleton());
    QCOMPARE(axes.axes.size(), std::size_t{6});
    const auto copy = std::ranges::find_if(axes.axes, [](const Axis& a) { return isNear(a.share, 0.8); });
    QVERIFY(copy != axes.axes.end());
    QVERIFY(isNear(copy->azimuth, 1.25));
    QVERIFY(isNear(copy->downAngle, original.downAngle));
    QVERIFY(isNear(copy->length, 0.5 * original.length));
    QVERIFY(isNear(copy->radius, 0.5 * original.radius));
    // An edit of the copy finds it again in a tree that has grown longer.
    QVERIFY(shaped.make(editOf(EditOperation::Remove, axes.axes.back().address)));
    QCOMPARE(axesOf(shaped.skeleton()).axes.size(), std::size_t{5});
    shaped.params.grammar.axiom = "F[+FF[+F]]F[^F]FFFF";
    const TreeResult tree = shaped.tree(Stage::Mesh);
    QCOMPARE(axesOf(*tree.skeleton).axes.size(), std::size_t{5});
    QVERIFY(tree.report->valid);
}

void TestEditedGrowth::graftsFromAnotherTree()
{
    Shaped source, shaped;
    const EditContext context(*source.tree().grown, {});
    TreeEdit edit = editOf(EditOperation::Graft, shaped.address[3]);
    edit.limb = context.limb(source.address[1]);
    QCOMPARE(edit.limb.size(), std::size_t{3});
    edit.azimuthRad = source.axis(source.address[1])->azimuth;
    QVERIFY(shaped.make(edit));
    const TreeAxes axes = axesOf(shaped.skeleton());
    QCOMPARE(axes.axes.size(), std::size_t{6});
    QCOMPARE(axes.axes[4].order, Index{2});
    QVERIFY(isNear(axes.axes[4].length, source.axis(source.address[1])->length));
    QVERIFY(isNear(axes.axes[4].downAngle, source.axis(source.address[1])->downAngle));
    QVERIFY(isNear(axes.axes[4].azimuth, edit.azimuthRad));
}

void TestEditedGrowth::moves()
{
    Shaped shaped;
    TreeEdit edit = editOf(EditOperation::Move, shaped.address[1]);
    edit.at = 0.9;
    edit.azimuthRad = -2.0;
    const Axis before = *shaped.axis(shaped.address[1]), twig = *shaped.axis(shaped.address[2]);
    QVERIFY(shaped.make(edit));
    const Axis after = *shaped.axis(shaped.address[1]);
    QVERIFY(isNear(after.share, 0.9));
    QVERIFY(isNear(after.azimuth, -2.0));
    QVERIFY(isNear(after.downAngle, before.downAngle));
    QVERIFY(isNear(after.length, before.length));
    QVERIFY(isNear(shaped.axis(shaped.address[2])->downAngle, twig.downAngle));
    // Onto another limb.
    edit.other.address = shaped.address[3];
    edit.at = 0.5;
    QVERIFY(shaped.make(edit));
    QCOMPARE(shaped.axis(shaped.address[1])->order, Index{2});
    QCOMPARE(shaped.axis(shaped.address[2])->order, Index{3});
    const TreeResult tree = shaped.tree(Stage::Mesh);
    QVERIFY(tree.report->valid);
    QCOMPARE(tree.branches->roots, Index{1});
}

void TestEditedGrowth::prunes()
{
    Shaped shaped;
    TreeEdit edit = editOf(EditOperation::Prune, 0);
    edit.shape.numbers = {0.0, 2.0, 0.0, 1.0, 0.0, 0.0}; // the foot is outside, and stays
    QVERIFY(shaped.make(edit));
    QVERIFY(isNear(shaped.tip(shaped.address[0]), {0.0, 3.0, 0.0}));
    for (Index i = 0; i < shaped.skeleton().size(); ++i) {
        const glm::dvec3 tip = shaped.skeleton().p1[i];
        QVERIFY(glm::length(tip - glm::dvec3(0.0, 2.0, 0.0)) <= 1.0 + 1e-9 || tip.y < 1.0 + 1e-9);
    }
    Shaped box;
    edit.shape = {EditShapeKind::Box, {-9.0, 0.0, -9.0, 9.0, 1.5, 9.0}};
    QVERIFY(box.make(edit));
    QVERIFY(skeletonStats(box.skeleton()).max.y <= 1.5 + 1e-9);
    QVERIFY(!box.axis(box.address[3]));
    Shaped cone;
    edit.shape = {EditShapeKind::Cone, {0.0, 0.0, 0.0, 1.0, 3.0, 0.0}};
    edit.target.address = cone.address[1]; // of that limb only
    QVERIFY(cone.make(edit));
    QVERIFY(cone.axis(cone.address[1])->length < box.axis(box.address[1])->length + 1.0);
    QVERIFY(isNear(cone.axis(cone.address[0])->length, Shaped().axis(cone.address[0])->length));
    const glm::dvec3 tip = cone.tip(cone.address[1]);
    QVERIFY(std::hypot(tip.x, tip.z) <= 1.0 - tip.y / 3.0 + 1e-9);
}

void TestEditedGrowth::prunesToOutlinesAndMeshes()
{
    // A cylinder, as a profile and as a mesh of a prism with twelve sides: nearly the same is left.
    TreeEdit edit = editOf(EditOperation::Prune, 0);
    edit.shape = {EditShapeKind::Profile, {0.0, -0.5, 0.0}, {{0.8, 0.0, 0.0}, {0.8, 3.0, 0.0}}, {}};
    Shaped round;
    QVERIFY(round.make(edit));
    QVERIFY(isNear(round.tip(round.address[0]), {0.0, 2.5, 0.0}));
    const glm::dvec3 limb = round.tip(round.address[1]);
    QVERIFY(std::abs(std::hypot(limb.x, limb.z) - 0.8) < 1e-9);
    edit.shape = {EditShapeKind::Mesh, {}, {}, {}};
    constexpr std::uint32_t sides = 12;
    for (std::uint32_t i = 0; i < sides; ++i)
        for (const double y : {-0.5, 2.5})
            edit.shape.points.emplace_back(0.8 * std::cos(i * std::numbers::pi / 6), y,
                                           0.8 * std::sin(i * std::numbers::pi / 6));
    edit.shape.points.emplace_back(0.0, -0.5, 0.0);
    edit.shape.points.emplace_back(0.0, 2.5, 0.0);
    for (std::uint32_t i = 0; i < 2 * sides; i += 2) {
        const std::uint32_t next = (i + 2) % (2 * sides);
        edit.shape.triangles.push_back({i, i + 1, next});
        edit.shape.triangles.push_back({next, i + 1, next + 1});
        edit.shape.triangles.push_back({2 * sides, i, next});
        edit.shape.triangles.push_back({2 * sides + 1, next + 1, i + 1});
    }
    for (const bool inverted : {false, true}) {
        if (inverted)
            for (auto& triangle : edit.shape.triangles)
                std::swap(triangle[0], triangle[1]);
        Shaped prism;
        const auto made = prism.make(edit);
        QVERIFY2(made, why(made).constData());
        QVERIFY(isNear(prism.tip(prism.address[0]), {0.0, 2.5, 0.0}));
        QVERIFY(glm::length(prism.tip(prism.address[1]) - limb) < 0.05);
        QVERIFY(prism.tree(Stage::Mesh).report->valid);
    }
    edit.shape.triangles.pop_back();
    Shaped open;
    const auto refused = open.make(edit);
    QVERIFY(!refused && refused.error().code == ErrorCode::Invalid);
    edit.shape.triangles.front()[0] = 99;
    QCOMPARE(open.make(edit).error().path, std::string("shape"));
}

void TestEditedGrowth::leaves()
{
    Shaped shaped;
    shaped.params.foliage.leavesCutoff = 1.0;
    const auto count = [&shaped](std::uint64_t axis) {
        const TreeResult tree = shaped.tree(Stage::Foliage);
        const TreeAxes axes = axesOf(*tree.skeleton);
        std::size_t leaves = 0;
        for (const FoliageItem& leaf : tree.foliage->leaves)
            leaves +=
                axes.axes[axes.axisOf[tree.simplified->skeleton.source[leaf.branch]]].address == axis ? 1 : 0;
        return leaves;
    };
    const std::size_t other = count(shaped.address[3]);
    QVERIFY(count(shaped.address[1]) > 0 && count(shaped.address[2]) > 0 && other > 0);
    TreeEdit edit = editOf(EditOperation::Leaves, shaped.address[1]);
    edit.shown = false;
    QVERIFY(shaped.make(edit));
    QVERIFY(count(shaped.address[1]) == 0 && count(shaped.address[2]) == 0);
    QCOMPARE(count(shaped.address[3]), other);
    edit.target.address = shaped.address[2];
    edit.shown = true;
    QVERIFY(shaped.make(edit));
    QVERIFY(count(shaped.address[1]) == 0 && count(shaped.address[2]) > 0);
    // Without a limb: what a sphere touches.
    edit.target = {};
    edit.shown = false;
    edit.centre = shaped.tip(shaped.address[3]);
    edit.radius = 0.01;
    QVERIFY(shaped.make(edit));
    QVERIFY(count(shaped.address[3]) == 0 && count(shaped.address[2]) > 0);
    QVERIFY(!shaped.make(edit)); // they are gone already
    edit.radius = 0.0;
    QVERIFY(!shaped.make(edit));
    edit.radius = 0.01;
    edit.shown = true;
    QVERIFY(shaped.make(edit));
    QCOMPARE(count(shaped.address[3]), other);
}

void TestEditedGrowth::roots()
{
    Shaped shaped;
    TreeEdit edit = editOf(EditOperation::Root, shaped.address[0]);
    edit.offset = {1.0, 0.0, -2.0};
    edit.factor = 2.0;
    const glm::dvec3 tip = shaped.tip(shaped.address[2]);
    const Axis before = *shaped.axis(shaped.address[0]);
    QVERIFY(shaped.make(edit));
    QVERIFY(isNear(shaped.tip(shaped.address[2]), tip + edit.offset));
    QVERIFY(isNear(shaped.axis(shaped.address[0])->radius, 2.0 * before.radius));
    const auto radius =
        EditContext(*shaped.tree().grown, shaped.params.edits).pointOn(shaped.address[0], 0.2);
    const auto was = EditContext(*shaped.tree().grown, {}).pointOn(shaped.address[0], 0.2);
    QVERIFY(isNear(radius->radius, was->radius));
}

void TestEditedGrowth::laterEditsOfWhatWasDrawn()
{
    Shaped shaped;
    TreeEdit edit = editOf(EditOperation::Draw, shaped.address[1]);
    edit.points = {{{-2.0, 3.0, 0.0}, 0.0}};
    const auto first = shaped.make(edit);
    QVERIFY(first);
    edit.target.address = *first;
    edit.points = {{{-2.0, 4.0, 0.0}, 0.0}};
    const auto second = shaped.make(edit);
    QVERIFY(second && *second != *first);
    QCOMPARE(shaped.axis(*second)->order, Index{3});
    TreeEdit length = editOf(EditOperation::Length, *first);
    length.factor = 0.5;
    QVERIFY(shaped.make(length));
    const TreeResult shown = shaped.tree();
    for (const EditOutcome& outcome : *shown.edits)
        QCOMPARE(outcome.state, EditState::ByAddress);
    // Without the first, what was made on it waits.
    shaped.params.edits.front().enabled = false;
    const TreeResult tree = shaped.tree();
    QCOMPARE((*tree.edits)[1].state, EditState::Unplaced);
    QCOMPARE((*tree.edits)[2].state, EditState::Unplaced);
}

void TestEditedGrowth::untouchedLimbsKeepTheirNames()
{
    Shaped shaped;
    TreeEdit draw = editOf(EditOperation::Draw, shaped.address[0]);
    draw.at = 0.1; // below all others: their ranks change
    draw.points = {{{1.0, 1.0, 1.0}, 0.0}};
    QVERIFY(shaped.make(draw));
    QVERIFY(shaped.make(editOf(EditOperation::Remove, shaped.address[1])));
    const TreeResult tree = shaped.tree();
    std::set<std::uint64_t> keys;
    for (const std::uint64_t key : tree.grown->key)
        keys.insert(key);
    const std::optional<Axis> upper = shaped.axis(shaped.address[3]);
    QVERIFY(upper);
    const Index branch = axesOf(*tree.skeleton).nodesOf(static_cast<Index>(1)).front();
    QVERIFY(branch < tree.skeleton->size());
    for (Index i = 0; i < tree.skeleton->size(); ++i)
        if (tree.skeleton->level[i] == 1 && tree.skeleton->p0[i].y > 1.5)
            QVERIFY(keys.contains(tree.skeleton->key[i]));
    std::set<std::uint64_t> own(tree.skeleton->key.begin(), tree.skeleton->key.end());
    QCOMPARE(own.size(), std::size_t{tree.skeleton->size()});
}

void TestEditedGrowth::whatWasTakenAwayIsSaid()
{
    Shaped shaped;
    QVERIFY(shaped.make(editOf(EditOperation::Length, shaped.address[2])));
    QVERIFY(shaped.make(editOf(EditOperation::Remove, shaped.address[1])));
    std::swap(shaped.params.edits[0], shaped.params.edits[1]);
    const TreeResult tree = shaped.tree();
    QCOMPARE((*tree.edits)[0].state, EditState::ByAddress);
    QCOMPARE((*tree.edits)[1].state, EditState::Idle);
    QVERIFY(*(*tree.edits)[1].why.text != '\0');
}

void TestEditedGrowth::placesHoldWhereAnAxisIsSplit()
{
    Shaped shaped;
    const TreeAxes grown = axesOf(shaped.skeleton());
    std::vector<BranchPlace> places;
    for (Index branch = 0; branch < shaped.skeleton().size(); ++branch)
        places.push_back(placeOf(grown, branch, 1));
    TreeEdit edit = editOf(EditOperation::Bend, shaped.address[1]);
    edit.to = 0.5;
    edit.rotation = {0.0, 1.0, 0.0};
    QVERIFY(shaped.make(edit));
    const TreeAxes bent = axesOf(shaped.skeleton());
    std::vector<const BranchPlace*> wanted;
    for (const BranchPlace& place : places)
        wanted.push_back(&place);
    const std::vector<FoundPlace> found = findPlaces(bent, wanted);
    for (std::size_t i = 0; i < found.size(); ++i) {
        QVERIFY(found[i].branch != noIndex);
        const Axis& axis = bent.axes[bent.axisOf[found[i].branch]];
        QCOMPARE(axis.address, places[i].way.back().address);
        const double middle = places[i].share * axis.length, start = bent.start[found[i].branch];
        QVERIFY(start <= middle && middle <= start + shaped.skeleton().length(found[i].branch) + 1e-9);
    }
}

RAMURE_SUITE(TestEditedGrowth)

} // namespace tst_edited_growth

#include "tst_edited_growth.moc"
