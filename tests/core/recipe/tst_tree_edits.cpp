#include "tests/support/shaped_tree.h"

#include <cmath>
#include <set>

namespace tst_tree_edits {

using namespace ramure;
using namespace ramure::test;

/// What each operation does to a tree, and what it refuses.
class TestTreeEdits : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void tableIsWhole();
    void badValues_data();
    void badValues();
    void unknownLimbs();
    void whatCannotBeDone();
    void noEditsChangeNothing();
    void editsSwitchedOff();
    void cuts();
    void removesAndKeeps();
    void bendsAndCurls();
    void twists();
    void lengths();
    void radii();
    void brushes();
    void organsGoWithTheirWood();
    void placesOrgans();
    void cutEndsAreFlat();
    void whatIsCutFalls();
    void saysWhatWouldGo();
    void bowsAreSmooth();
};

void TestTreeEdits::tableIsWhole()
{
    std::set<std::string> keys;
    for (std::size_t i = 0; i < editOperationCount; ++i) {
        const EditOperationInfo& info = editOperations()[i];
        QCOMPARE(static_cast<std::size_t>(info.operation), i);
        QVERIFY(keys.insert(info.key).second);
        QCOMPARE(editOperationOf(info.key), info.group == StepGroup::Unknown ? nullptr : &info);
        QVERIFY(*info.label != '\0');
    }
    QVERIFY(!editOperationOf("grow"));
}

void TestTreeEdits::badValues_data()
{
    QTest::addColumn<int>("operation");
    QTest::addColumn<int>("what");
    QTest::addColumn<QByteArray>("path");
    const auto row = [](EditOperation operation, int what, const char* path) {
        QTest::addRow("%s %d", infoOf(operation).key, what)
            << static_cast<int>(operation) << what << QByteArray(path);
    };
    row(EditOperation::Cut, 0, "target");
    row(EditOperation::Draw, 1, "at");
    row(EditOperation::Cut, 1, "at");
    row(EditOperation::Length, 2, "factor");
    row(EditOperation::Bend, 3, "rotation");
    row(EditOperation::Draw, 4, "points");
    row(EditOperation::Redraw, 5, "points");
    row(EditOperation::Prune, 6, "shape");
    row(EditOperation::Comb, 7, "direction");
    row(EditOperation::Graft, 8, "source");
    row(EditOperation::Graft, 9, "limb");
    row(EditOperation::Attract, 10, "radius");
    row(EditOperation::Place, 0, "target");
    row(EditOperation::Place, 11, "organ");
    row(EditOperation::Cut, 12, "seconds");
}

void TestTreeEdits::badValues()
{
    QFETCH(int, operation);
    QFETCH(int, what);
    QFETCH(QByteArray, path);
    TreeEdit edit = editOf(static_cast<EditOperation>(operation), 7);
    edit.id = 1;
    edit.points = {{glm::dvec3(1.0), 0.0}};
    switch (what) {
    case 0:
        edit.target = {};
        break;
    case 1:
        edit.at = std::nan("");
        break;
    case 2:
        edit.factor = 0.0;
        break;
    case 3:
        edit.rotation.y = std::numeric_limits<double>::infinity();
        break;
    case 4:
        edit.points.clear();
        break;
    case 5:
        edit.points = {{glm::dvec3(0.0), -1.0}};
        break;
    case 6:
        edit.shape.numbers[3] = 0.0;
        break;
    case 7:
        edit.direction = glm::dvec3(0.0);
        break;
    case 9:
        edit.limb = {{-1, {}, glm::dvec3(1.0), 0.1, 0.1, 0}, {1, {}, glm::dvec3(1.0), 0.1, 0.1, 1}};
        break;
    case 10:
        edit.radius = -1.0;
        break;
    case 11:
        edit.organ = static_cast<EditOrgan>(7);
        break;
    case 12:
        edit.seconds = -1.0;
        break;
    default:
        break;
    }
    const auto checked = checkTreeEdit(edit);
    QVERIFY(!checked);
    QCOMPARE(QByteArray::fromStdString(checked.error().path), path);
    NodeParams params = plainTree();
    params.edits = {edit};
    TreePipeline pipeline;
    const auto tree = pipeline.evaluate(params);
    QVERIFY(!tree);
    QCOMPARE(QByteArray::fromStdString(tree.error().path), "edits[0]." + path);
}

void TestTreeEdits::unknownLimbs()
{
    Shaped shaped;
    const auto made = shaped.make(editOf(EditOperation::Remove, 12345));
    QVERIFY(!made);
    QCOMPARE(made.error().code, ErrorCode::Unknown);
    TreeEdit edit = editOf(EditOperation::Remove, 12345);
    edit.id = 1;
    shaped.params.edits = {edit};
    const TreeResult tree = shaped.tree();
    QCOMPARE(tree.edits->size(), std::size_t{1});
    QCOMPARE(tree.edits->front().state, EditState::Unplaced);
    QCOMPARE(tree.skeleton->size(), tree.grown->size());
    // Twice the same name.
    shaped.params.edits.push_back(edit);
    TreePipeline pipeline;
    QCOMPARE(pipeline.evaluate(shaped.params).error().path, std::string("edits[1].id"));
}

void TestTreeEdits::whatCannotBeDone()
{
    Shaped shaped;
    const auto refused = [&shaped](TreeEdit edit) {
        const auto made = shaped.make(edit);
        return !made && made.error().code == ErrorCode::Invalid && *made.error().text != '\0' &&
               shaped.params.edits.empty();
    };
    TreeEdit cut = editOf(EditOperation::Cut, shaped.address[1]);
    cut.at = 1.0;
    QVERIFY(refused(cut));
    QVERIFY(refused(editOf(EditOperation::Remove, shaped.address[0])));
    TreeEdit graft = editOf(EditOperation::Graft, shaped.address[2]);
    graft.other.address = shaped.address[1];
    QVERIFY(refused(graft));
    TreeEdit move = editOf(EditOperation::Move, shaped.address[1]);
    move.other.address = shaped.address[2];
    QVERIFY(refused(move));
    QVERIFY(refused(editOf(EditOperation::Move, shaped.address[0])));
    QVERIFY(refused(editOf(EditOperation::Root, shaped.address[1])));
    QVERIFY(refused(editOf(EditOperation::Twist, shaped.address[3])));
    TreeEdit draw = editOf(EditOperation::Draw, shaped.address[0]);
    draw.at = 1.0;
    draw.points = {{shaped.tip(shaped.address[0]), 0.1}};
    QVERIFY(refused(draw));
    TreeEdit prune = editOf(EditOperation::Prune, 0);
    prune.shape.numbers = {0.0, 0.0, 0.0, 100.0, 0.0, 0.0};
    QVERIFY(refused(prune));
    TreeEdit attract = editOf(EditOperation::Attract, 0);
    attract.centre = {50.0, 0.0, 0.0};
    QVERIFY(refused(attract));
}

void TestTreeEdits::noEditsChangeNothing()
{
    Shaped shaped;
    const TreeResult tree = shaped.tree();
    QVERIFY(tree.grown == tree.skeleton);
    QVERIFY(!tree.edits);
    QVERIFY(tree.skeleton->axisStarts.empty());
    QCOMPARE(shaped.address.size(), std::size_t{4});
}

void TestTreeEdits::editsSwitchedOff()
{
    Shaped shaped;
    QVERIFY(shaped.make(editOf(EditOperation::Remove, shaped.address[1])));
    shaped.params.edits.front().enabled = false;
    const TreeResult tree = shaped.tree();
    QCOMPARE(tree.edits->front().state, EditState::Off);
    Skeleton same = *tree.skeleton;
    QCOMPARE(same.axisStarts.size(), std::size_t{4});
    same.axisStarts.clear();
    QVERIFY(same == *tree.grown);
}

void TestTreeEdits::cuts()
{
    Shaped shaped;
    TreeEdit edit = editOf(EditOperation::Cut, shaped.address[0]);
    edit.at = 0.75;
    const double before = shaped.axis(shaped.address[0])->length;
    QVERIFY(shaped.make(edit));
    QVERIFY(isNear(shaped.axis(shaped.address[0])->length, 0.75 * before));
    QVERIFY(shaped.axis(shaped.address[3]));
    edit.at = 0.5; // of what is left: the upper limb goes, it stands higher
    QVERIFY(shaped.make(edit));
    QVERIFY(isNear(shaped.axis(shaped.address[0])->length, 0.375 * before));
    QVERIFY(!shaped.axis(shaped.address[3]));
    QVERIFY(shaped.axis(shaped.address[1]));
    edit = editOf(EditOperation::Cut, shaped.address[1]);
    edit.at = 0.0;
    QVERIFY(shaped.make(edit));
    QCOMPARE(axesOf(shaped.skeleton()).axes.size(), std::size_t{1});
    const TreeResult tree = shaped.tree(Stage::Mesh);
    QVERIFY(tree.report->valid);
}

void TestTreeEdits::removesAndKeeps()
{
    Shaped shaped;
    QVERIFY(shaped.make(editOf(EditOperation::Remove, shaped.address[1])));
    QVERIFY(!shaped.axis(shaped.address[1]) && !shaped.axis(shaped.address[2]));
    QCOMPARE(shaped.skeleton().size(), Index{5});
    Shaped kept;
    QVERIFY(kept.make(editOf(EditOperation::Keep, kept.address[2])));
    QCOMPARE(axesOf(kept.skeleton()).axes.size(), std::size_t{3});
    QVERIFY(!kept.axis(kept.address[3]));
    QCOMPARE(kept.axis(kept.address[0])->nodes, Index{1});
    QCOMPARE(kept.axis(kept.address[1])->nodes, Index{2});
    QVERIFY(!kept.make(editOf(EditOperation::Keep, kept.address[2])));
}

void TestTreeEdits::bendsAndCurls()
{
    Shaped shaped;
    TreeEdit edit = editOf(EditOperation::Bend, shaped.address[0]);
    edit.from = 0.0;
    edit.rotation = {0.0, 0.0, -std::numbers::pi / 2}; // the trunk lies down along +X
    const glm::dvec3 before = shaped.tip(shaped.address[2]);
    QVERIFY(shaped.make(edit));
    QVERIFY(isNear(shaped.tip(shaped.address[0]), {4.0 * 1.0, 0.0, 0.0}) ||
            std::abs(shaped.tip(shaped.address[0]).y) < 1e-9);
    QVERIFY(isNear(shaped.tip(shaped.address[2]), {before.y, -before.x, before.z}));
    Shaped curled;
    edit = editOf(EditOperation::Curl, curled.address[0]);
    edit.rotation = {0.0, 0.0, -1.0};
    const double length = curled.axis(curled.address[0])->length;
    QVERIFY(curled.make(edit));
    QVERIFY(isNear(curled.axis(curled.address[0])->length, length));
    const TreeAxes axes = axesOf(curled.skeleton());
    const std::span<const Index> nodes = axes.nodesOf(0);
    const Skeleton skeleton = curled.skeleton();
    const glm::dvec3 last = glm::normalize(skeleton.p1[nodes.back()] - skeleton.p0[nodes.back()]);
    QVERIFY(nodes.size() >= 7 && last.x > std::sin(0.85) && last.x < std::sin(1.0));
}

void TestTreeEdits::twists()
{
    Shaped shaped;
    TreeEdit edit = editOf(EditOperation::Twist, shaped.address[0]);
    edit.angleRad = 1.0;
    const Axis before = *shaped.axis(shaped.address[1]);
    const glm::dvec3 tip = shaped.tip(shaped.address[0]);
    QVERIFY(shaped.make(edit));
    const Axis after = *shaped.axis(shaped.address[1]);
    QVERIFY(
        isNear(std::remainder(after.azimuth - before.azimuth - before.share, 2.0 * std::numbers::pi), 0.0));
    QVERIFY(isNear(after.downAngle, before.downAngle));
    QVERIFY(isNear(tip, shaped.tip(shaped.address[0])));
}

void TestTreeEdits::lengths()
{
    Shaped shaped;
    TreeEdit edit = editOf(EditOperation::Length, shaped.address[1]);
    edit.factor = 1.5;
    const double limb = shaped.axis(shaped.address[1])->length, twig = shaped.axis(shaped.address[2])->length;
    QVERIFY(shaped.make(edit));
    QVERIFY(isNear(shaped.axis(shaped.address[1])->length, 1.5 * limb));
    QVERIFY(isNear(shaped.axis(shaped.address[2])->length, twig));
    edit.below = true;
    QVERIFY(shaped.make(edit));
    QVERIFY(isNear(shaped.axis(shaped.address[1])->length, 2.25 * limb));
    QVERIFY(isNear(shaped.axis(shaped.address[2])->length, 1.5 * twig));
}

void TestTreeEdits::radii()
{
    Shaped shaped;
    TreeEdit edit = editOf(EditOperation::Thickness, shaped.address[1]);
    edit.factor = 0.5;
    const double limb = shaped.axis(shaped.address[1])->radius, twig = shaped.axis(shaped.address[2])->radius;
    QVERIFY(shaped.make(edit));
    QVERIFY(isNear(shaped.axis(shaped.address[1])->radius, 0.5 * limb));
    QVERIFY(isNear(shaped.axis(shaped.address[2])->radius, twig));
    edit.below = true;
    QVERIFY(shaped.make(edit));
    QVERIFY(isNear(shaped.axis(shaped.address[2])->radius, 0.5 * twig));
    edit = editOf(EditOperation::Taper, shaped.address[0]);
    edit.factor = 0.25;
    const auto tipRadius = [&shaped] {
        return EditContext(*shaped.tree().grown, shaped.params.edits).pointOn(shaped.address[0], 1.0)->radius;
    };
    const double foot = shaped.axis(shaped.address[0])->radius, tip = tipRadius();
    QVERIFY(shaped.make(edit));
    QVERIFY(isNear(shaped.axis(shaped.address[0])->radius, foot));
    QVERIFY(isNear(tipRadius(), 0.25 * tip));
}

void TestTreeEdits::brushes()
{
    Shaped shaped;
    const glm::dvec3 before = shaped.tip(shaped.address[2]);
    TreeEdit edit = editOf(EditOperation::Attract, shaped.address[2]);
    edit.centre = before + glm::dvec3(0.0, 1.0, 0.0);
    edit.radius = 3.0;
    edit.strength = 1.0;
    const double length = shaped.axis(shaped.address[2])->length;
    QVERIFY(shaped.make(edit));
    const glm::dvec3 near = shaped.tip(shaped.address[2]);
    QVERIFY(glm::length(near - edit.centre) < 1.0);
    QVERIFY(isNear(shaped.axis(shaped.address[2])->length, length));
    edit.strength = -1.0;
    QVERIFY(shaped.make(edit));
    QVERIFY(glm::length(shaped.tip(shaped.address[2]) - edit.centre) > glm::length(near - edit.centre));
    edit = editOf(EditOperation::Comb, 0);
    edit.centre = {0.0, 4.0, 0.0};
    edit.radius = 3.0;
    edit.strength = 1.0;
    edit.direction = {1.0, 0.0, 0.0};
    const double x = shaped.tip(shaped.address[0]).x;
    QVERIFY(shaped.make(edit));
    QVERIFY(shaped.tip(shaped.address[0]).x > x + 0.2);
}

/// Two on the limb, one at the tip of the trunk.
void TestTreeEdits::placesOrgans()
{
    Shaped shaped;
    shaped.params.foliage.leavesDensity = 0;
    shaped.params.foliage.applesProbability = 0.0;
    TreeEdit edit = editOf(EditOperation::Place, shaped.address[1]);
    edit.at = 0.6;
    edit.azimuthRad = 1.0;
    QVERIFY(shaped.make(edit));
    edit.organ = EditOrgan::Flower;
    edit.factor = 2.0;
    edit.azimuthRad = -1.0;
    QVERIFY(shaped.make(edit));
    const TreeResult tree = shaped.tree(Stage::Foliage);
    QCOMPARE(tree.skeleton->organs.size(), std::size_t{2});
    QCOMPARE(tree.foliage->leaves.size(), std::size_t{1});
    QCOMPARE(tree.foliage->apples.size(), std::size_t{1});
    QCOMPARE(tree.foliage->apples.front().size, 2.0F);
    // On the bark of the place that was meant.
    const EditContext context(*tree.grown, {});
    const StrokePoint place = *context.pointOn(shaped.address[1], 0.6);
    const double away = glm::length(tree.foliage->leaves.front().position - place.position);
    QVERIFY(away > 0.5 * place.radius && away < 3.0 * place.radius);
    // Where the leaves of the limb go it goes, too, and what is placed after that is seen.
    TreeEdit bare = editOf(EditOperation::Leaves, shaped.address[1]);
    bare.shown = false;
    QVERIFY(shaped.make(bare));
    QVERIFY(shaped.skeleton().organs.empty());
    QVERIFY(shaped.make(edit));
    QCOMPARE(shaped.skeleton().organs.size(), std::size_t{1});
    bare.shown = true;
    QVERIFY(shaped.make(bare));
    QCOMPARE(shaped.skeleton().organs.size(), std::size_t{3});
    // It goes with its wood.
    TreeEdit cut = editOf(EditOperation::Cut, shaped.address[1]);
    cut.at = 0.3;
    QVERIFY(shaped.make(cut));
    QVERIFY(shaped.skeleton().organs.empty());
}

void TestTreeEdits::cutEndsAreFlat()
{
    Shaped shaped;
    QVERIFY(shaped.skeleton().sawn.empty());
    TreeEdit thin = editOf(EditOperation::Thickness, shaped.address[0]); // limbs reach out of their forks
    thin.factor = 0.1;
    thin.below = true;
    QVERIFY(shaped.make(thin));
    TreeEdit cut = editOf(EditOperation::Cut, shaped.address[3]);
    cut.at = 0.5;
    QVERIFY(shaped.make(cut));
    const TreeResult tree = shaped.tree(Stage::Mesh);
    const Skeleton& seen = tree.simplified->skeleton;
    QCOMPARE(seen.sawn.size(), std::size_t{1});
    QVERIFY(tree.report->valid);
    // Nothing stands out of the plane of the cut, and its middle lies in it.
    const Index end = seen.sawn.front();
    const glm::dvec3 way = glm::normalize(seen.p1[end] - seen.p0[end]);
    double highest = -1.0, nearest = 1.0;
    int inside = 0; // the ring of the cut
    const TriangleMesh& mesh = tree.branches->mesh;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        if (mesh.branch[v] == end) {
            highest = std::max(highest, glm::dot(glm::dvec3(mesh.positions[v]) - seen.p1[end], way));
            const double away = glm::length(glm::dvec3(mesh.positions[v]) - seen.p1[end]) / seen.a1[end];
            nearest = std::min(nearest, away);
            inside += away > 0.8 && away < 0.95 ? 1 : 0;
        }
    QVERIFY(highest < 0.05 * seen.a1[end]);
    QVERIFY2(nearest < 1e-3, qPrintable(QString::number(nearest)));
    QVERIFY2(inside >= 3, qPrintable(QString::number(inside)));
    // Its texture is a piece of the bark's, spread flat: no triangle of it is folded.
    const auto texture = tree.texture->coordinates(TextureParams());
    QVERIFY2(texture, why(texture).constData());
    QCOMPARE((*texture)->apart, Index{0});
    // What goes on from it has a tip again.
    TreeEdit extend = editOf(EditOperation::Extend, shaped.address[3]);
    extend.points = {{seen.p1[end] + way, 0.0}};
    QVERIFY(shaped.make(extend));
    QVERIFY(shaped.skeleton().sawn.empty());
}

void TestTreeEdits::organsGoWithTheirWood()
{
    NodeParams params = plainTree();
    params.grammar.dialect = GrammarDialect::Parametric;
    params.grammar.axiom = "F(1)[+F(1)~(leaf,0.1)F(1)~(fruit,0.1)]F(1)~(leaf,0.1)";
    const TreeResult grown = grownTree(params);
    QCOMPARE(grown.skeleton->organs.size(), std::size_t{3});
    const std::vector<Axis> axes = axesOf(*grown.skeleton).axes;
    const auto after = [&](TreeEdit edit) {
        NodeParams edited = params;
        const auto made = make(edited, std::move(edit));
        if (!made)
            qFatal("%s", why(made).constData());
        const Skeleton skeleton = *grownTree(edited).skeleton;
        for (const Organ& organ : skeleton.organs)
            if (organ.branch >= skeleton.size() || organ.share < 0.0 || organ.share > 1.0)
                qFatal("an organ beside its branch");
        return skeleton.organs;
    };
    TreeEdit cut = editOf(EditOperation::Cut, axes[1].address);
    cut.at = 0.25;
    QCOMPARE(after(cut).size(), std::size_t{1});
    cut.at = 0.75; // in the upper step: the leaf stays
    const std::vector<Organ> left = after(cut);
    QCOMPARE(left.size(), std::size_t{2});
    QCOMPARE(left.front(), grown.skeleton->organs.front());
    TreeEdit bare = editOf(EditOperation::Leaves, axes[1].address);
    bare.shown = false;
    QCOMPARE(after(bare).size(), std::size_t{1});
    TreeEdit graft = editOf(EditOperation::Graft, axes[0].address);
    graft.other.address = axes[1].address;
    graft.at = 0.9;
    graft.factor = 0.5;
    const std::vector<Organ> more = after(graft);
    QCOMPARE(more.size(), std::size_t{5});
    QVERIFY(isNear(more.back().size, 0.05));
    // As a copy for another tree it brings the same.
    TreeEdit brought = graft;
    brought.other = {};
    brought.limb = EditContext(*grown.grown, {}).limb(axes[1].address);
    const std::vector<Organ> same = after(brought);
    QCOMPARE(same.size(), more.size());
    for (std::size_t i = 0; i < more.size(); ++i) {
        QCOMPARE(same[i].branch, more[i].branch);
        QCOMPARE(same[i].kind, more[i].kind);
        QVERIFY(isNear(same[i].size, more[i].size) && isNear(same[i].share, more[i].share));
    }
}

void TestTreeEdits::whatIsCutFalls()
{
    Shaped shaped;
    TreeEdit cut = editOf(EditOperation::Cut, shaped.address[1]);
    cut.at = 0.25;
    cut.falls = true;
    cut.seconds = 2.0;
    QVERIFY(shaped.make(cut));
    const Skeleton tree = shaped.skeleton();
    QCOMPARE(tree.loose.size(), std::size_t{1});
    const LooseLimb limb = tree.loose.front();
    QCOMPARE(tree.parent[limb.first], noIndex);
    QCOMPARE(limb.seconds, 2.0);
    QCOMPARE(tree.sawn, std::vector<Index>{limb.stump});
    const double gap = glm::distance(tree.p0[limb.first], tree.p1[limb.stump]);
    QVERIFY(gap > 0.0 && gap < 0.2 * tree.a0[limb.first]);
    // Twigs go with it, and edits still find them, and it.
    QVERIFY(shaped.axis(shaped.address[2]));
    const TreeAxes axes = axesOf(tree);
    QCOMPARE(axes.axes.size(), std::size_t{5});
    const std::uint64_t upper = axes.axes[axes.axisOf[limb.first]].address;
    QVERIFY(upper != shaped.address[1]);
    for (const std::uint64_t address : {upper, shaped.address[2]})
        QVERIFY(shaped.make(editOf(EditOperation::Thickness, address)));
    const TreeResult meshed = shaped.tree(Stage::Mesh);
    QVERIFY(meshed.report->valid);
    QCOMPARE(meshed.report->components, Index{2});
    // At its foot: once, and neither as a root nor as part of another tree.
    TreeEdit foot = editOf(EditOperation::Cut, shaped.address[3]);
    foot.at = 0.0;
    foot.falls = true;
    QVERIFY(shaped.make(foot));
    QVERIFY(!shaped.make(foot));
    QVERIFY(!shaped.make(editOf(EditOperation::Root, shaped.address[3])));
    QCOMPARE(shaped.skeleton().loose.size(), std::size_t{2});
    // A shape leaves it alone; what is removed is gone.
    TreeEdit prune = editOf(EditOperation::Prune, 0);
    prune.shape.numbers = {0.0, 0.0, 0.0, 1.5, 0.0, 0.0};
    QVERIFY(shaped.make(prune));
    QCOMPARE(shaped.skeleton().loose.size(), std::size_t{2});
    QVERIFY(shaped.make(editOf(EditOperation::Remove, shaped.address[3])));
    QCOMPARE(shaped.skeleton().loose.size(), std::size_t{1});
    // The whole tree can be felled.
    Shaped felled;
    foot.target.address = felled.address[0];
    QVERIFY(felled.make(foot));
    QCOMPARE(felled.skeleton().loose, (std::vector<LooseLimb>{{0, noIndex, 0.0}}));
}

void TestTreeEdits::saysWhatWouldGo()
{
    Shaped shaped;
    const EditContext context(*shaped.tree().grown, {});
    const auto lossOf = [&](const TreeEdit& edit) {
        return context.prepared(edit, true).and_then([&](const TreeEdit& ready) {
            return context.lossOf(ready);
        });
    };
    QVERIFY(!lossOf(editOf(EditOperation::Remove, shaped.address[0]))); // nothing would be left
    QVERIFY(lossOf(editOf(EditOperation::Thickness, shaped.address[1]))->pieces.empty());
    TreeEdit cut = editOf(EditOperation::Cut, shaped.address[1]);
    cut.at = 0.25;
    TreeEdit prune = editOf(EditOperation::Prune, 0);
    prune.shape.numbers = {0.0, 0.0, 0.0, 1.5, 0.0, 0.0};
    for (const TreeEdit& edit : {cut, prune}) {
        const auto loss = lossOf(edit);
        QVERIFY(loss && !loss->pieces.empty());
        Shaped after;
        QVERIFY(after.make(edit));
        const double less =
            skeletonStats(shaped.skeleton()).totalLength - skeletonStats(after.skeleton()).totalLength;
        QVERIFY(std::abs(less - loss->metres) < 1e-9 && less > 0.0);
        for (const auto& [key, share] : loss->pieces)
            QVERIFY(share > 0.0 && share <= 1.0);
    }
}

/// An axis of few pieces becomes a curve: no two pieces that follow each other turn by more than a little,
/// and where it begins and ends it turns least.
void TestTreeEdits::bowsAreSmooth()
{
    Shaped shaped;
    const Index before = shaped.axis(shaped.address[1])->nodes;
    const double length = shaped.axis(shaped.address[1])->length;
    TreeEdit edit = editOf(EditOperation::Bend, shaped.address[1]);
    edit.from = 0.1;
    edit.to = 0.9;
    edit.rotation = {0.0, 1.5, 0.0};
    QVERIFY(shaped.make(edit));
    QVERIFY(isNear(shaped.axis(shaped.address[1])->length, length));
    QVERIFY(shaped.axis(shaped.address[1])->nodes > before + 10);
    const Skeleton skeleton = shaped.skeleton();
    const TreeAxes axes = axesOf(skeleton);
    const auto axis = std::ranges::find(axes.axes, shaped.address[1], &Axis::address);
    const std::span<const Index> nodes = axes.nodesOf(Index(axis - axes.axes.begin()));
    const auto way = [&](Index i) { return glm::normalize(skeleton.p1[i] - skeleton.p0[i]); };
    std::vector<double> turns;
    for (std::size_t i = 1; i < nodes.size(); ++i)
        turns.push_back(std::acos(std::min(1.0, glm::dot(way(nodes[i - 1]), way(nodes[i])))));
    const double most = *std::ranges::max_element(turns);
    QVERIFY2(most < 0.14, qPrintable(QString::number(most)));
    QVERIFY(turns.front() < 0.5 * most && turns.back() < 0.5 * most);
    QVERIFY(shaped.tree(Stage::Mesh).report->valid);
}

RAMURE_SUITE(TestTreeEdits)

} // namespace tst_tree_edits

#include "tst_tree_edits.moc"
