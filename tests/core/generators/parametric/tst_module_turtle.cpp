#include "core/generators/parametric/module_turtle.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/skeleton/axes.h"
#include "core/surface/foliage/place_foliage.h"
#include "core/surface/proof/validate.h"
#include "tests/support/book_trees.h"
#include "tests/support/suite.h"

#include <QFile>
#include <cmath>
#include <numbers>
#include <set>

namespace tst_module_turtle {

using namespace ramure;

namespace {

const VariationParams nothing{0.0, 0.0, 0.0};

Expected<Skeleton> drawn(const std::string& axiom, TurtleParams turtle = {}, const std::string& rules = {},
                         const TurtleChance& chance = {nothing, 1})
{
    const auto grammar = parseParametric({axiom, rules, 1, true, 1, GrammarDialect::Parametric, ""});
    if (!grammar)
        return fail(grammar.error());
    const auto word = derive(*grammar, {1, true, chance.seed});
    if (!word)
        return fail(word.error());
    return runModuleTurtle(*word, turtle, chance);
}

bool near(const glm::dvec3& a, const glm::dvec3& b, double within = 1e-12)
{
    return glm::length(a - b) < within;
}

/// Where the last branch points.
glm::dvec3 direction(const Expected<Skeleton>& skeleton)
{
    const Index i = skeleton->size() - 1;
    return glm::normalize(skeleton->p1[i] - skeleton->p0[i]);
}

} // namespace

class TestModuleTurtle : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void badNumbersNameTheirPlace();
    void noBranchIsAnError();
    void cancelStops();
    void turns_data();
    void turns();
    void numbersThatAreLeftOut();
    void rollsLevel();
    void widthsAreDiameters();
    void movesWithoutDrawing();
    void cutsTheRestOfTheBranch();
    void tropismBends();
    void levelsAndAxes();
    void organsPointAhead();
    void organsStandOnTheirBranches();
    void chanceVariesTurnsAndLengths();
    void booksTrees_data();
    void booksTrees();
    void handbooksTreeGrows_data();
    void handbooksTreeGrows();
    void pipelineSaysWhatIsWrong();
    void meshesAreSound();
};

void TestModuleTurtle::badNumbersNameTheirPlace()
{
    for (const char* const bad :
         {"F\n F(0-1)", "F\n !(0-1)", "F\n f(1e10)", "F\n f(0-2)F", "F\n ~(leaf, 0-1)", "\n ~(leaf, 1)F"}) {
        const auto s = drawn(bad);
        QVERIFY2(!s, bad);
        QCOMPARE(s.error().path, std::string("grammar.axiom"));
        QCOMPARE(s.error().line, 2);
        QCOMPARE(s.error().column, 2);
    }
}

void TestModuleTurtle::noBranchIsAnError()
{
    for (const char* const empty : {"", "f(1)", "F(0)", "A[+]"}) {
        const auto s = drawn(empty);
        QVERIFY(!s);
        QCOMPARE(s.error().path, std::string("grammar.axiom"));
    }
}

void TestModuleTurtle::cancelStops()
{
    const auto grammar = parseParametric({"FF", "", 1, false, 1, GrammarDialect::Parametric, ""});
    std::stop_source stop;
    stop.request_stop();
    const auto s = runModuleTurtle(*derive(*grammar, {}), {}, {nothing, 1}, {stop.get_token(), {}});
    QVERIFY(!s);
    QCOMPARE(s.error().code, ErrorCode::Cancelled);
}

void TestModuleTurtle::turns_data()
{
    QTest::addColumn<QString>("axiom");
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("z");
    QTest::newRow("up") << "F" << 0.0 << 1.0 << 0.0;
    QTest::newRow("left") << "+(90)F" << -1.0 << 0.0 << 0.0;
    QTest::newRow("right") << "-(90)F" << 1.0 << 0.0 << 0.0;
    QTest::newRow("pitch down") << "&(90)F" << 0.0 << 0.0 << -1.0;
    QTest::newRow("pitch up") << "^(90)F" << 0.0 << 0.0 << 1.0;
    // L = -X rolls right-handed about H = +Y to +Z.
    QTest::newRow("roll, then left") << "\\(90)+(90)F" << 0.0 << 0.0 << 1.0;
    QTest::newRow("roll back, then left") << "/(90)+(90)F" << 0.0 << 0.0 << -1.0;
    QTest::newRow("half a turn") << "|F" << 0.0 << -1.0 << 0.0;
    QTest::newRow("half a turn keeps up") << "|+(90)F" << 1.0 << 0.0 << 0.0;
    QTest::newRow("whole turns") << "+(450)F" << -1.0 << 0.0 << 0.0;
    QTest::newRow("brackets") << "[+(90)F]F" << 0.0 << 1.0 << 0.0;
}

void TestModuleTurtle::turns()
{
    QFETCH(QString, axiom);
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, z);
    const auto s = drawn(axiom.toStdString());
    QVERIFY2(s, test::why(s));
    QVERIFY(near(direction(s), {x, y, z}));
}

void TestModuleTurtle::numbersThatAreLeftOut()
{
    TurtleParams turtle;
    turtle.theta = std::numbers::pi / 2;
    turtle.alpha = 3.0;
    turtle.decay = 0.5;
    const auto s = drawn("!(2)F!+F", turtle);
    QVERIFY(near(s->p1[0], {0.0, 3.0, 0.0}));
    QVERIFY(near(s->p1[1], {-3.0, 3.0, 0.0}));
    QCOMPARE(s->a1[0], 1.0);
    QCOMPARE(s->a1[1], 0.5);
    QCOMPARE(drawn("F", turtle)->a0[0], 3.0); // the trunk's radius, as in the other dialect
}

void TestModuleTurtle::rollsLevel()
{
    const auto s = drawn("/(37)&(50)\\(20)$+(90)F");
    QVERIFY(std::abs(direction(s).y) < 1e-12);
    QVERIFY(near(direction(drawn("$+(90)F")), {-1.0, 0.0, 0.0})); // upright every roll is level
}

void TestModuleTurtle::widthsAreDiameters()
{
    const auto s = drawn("!(4)F[!(1)F]!(2)F");
    QVERIFY(s->a0[0] == 2.0 && s->a1[0] == 2.0);
    QVERIFY(s->a0[1] == 0.5 && s->a1[1] == 0.5); // a branch of its own starts as thin as it is
    QVERIFY(s->a0[2] == 2.0 && s->a1[2] == 1.0); // the axis goes on without a step
    QVERIFY(drawn("!(0)F")->a1[0] > 0.0);
}

void TestModuleTurtle::movesWithoutDrawing()
{
    const auto s = drawn("F(1)f(1)F(1)[f(0)F(1)]F(1)");
    QCOMPARE(s->size(), Index(4));
    QCOMPARE(s->parent[1], noIndex);
    QVERIFY(near(s->p0[1], {0.0, 2.0, 0.0}));
    QCOMPARE(s->parent[2], Index(1));
    QCOMPARE(s->parent[3], Index(1));
    QCOMPARE(std::set<std::uint64_t>(s->key.begin(), s->key.end()).size(), std::size_t(4));
}

void TestModuleTurtle::cutsTheRestOfTheBranch()
{
    QCOMPARE(drawn("F[F%F[F]F]F", {}, "A -> F")->size(), Index(3));
    QCOMPARE(drawn("FA", {}, "A -> [F%F[F]F]F%FF")->size(), Index(3));
}

void TestModuleTurtle::tropismBends()
{
    TurtleParams turtle;
    turtle.elasticity = 0.1;
    const auto s = drawn("+(90)FF", turtle);
    // Across: |H x T| = 1, so by 0.1 rad, downwards.
    QVERIFY(near(direction(s), {-std::cos(0.1), -std::sin(0.1), 0.0}));
    QVERIFY(near(direction(drawn("FF", turtle)), {0.0, 1.0, 0.0})); // along it nothing turns
    turtle.tropism = {0.0, 2.0, 0.0};
    QVERIFY(near(direction(drawn("+(90)FF", turtle)), {-std::cos(0.2), std::sin(0.2), 0.0}));
}

void TestModuleTurtle::levelsAndAxes()
{
    const auto s = drawn("F[+F]F[&F[+F]]");
    QCOMPARE(s->level, (std::vector<Index>{0, 1, 0, 1, 2}));
    QCOMPARE(s->parent, (std::vector<Index>{noIndex, 0, 0, 2, 3}));
    QCOMPARE(axesOf(*s).axes.size(), std::size_t(4));
    // The other dialect gives the same branches the same keys.
    QCOMPARE(s->key, runTurtle("F[+F]F[^F[+F]]", {})->key);
}

void TestModuleTurtle::chanceVariesTurnsAndLengths()
{
    const char* const axiom = "F(1)[+(40)F(1)][+(40)F(1)]";
    const auto same = drawn(axiom), first = drawn(axiom, {}, "", {VariationParams(), 1}),
               second = drawn(axiom, {}, "", {VariationParams(), 2});
    QVERIFY(*first == *drawn(axiom, {}, "", {VariationParams(), 1}));
    QVERIFY(*first != *second && *first != *same);
    QVERIFY(std::abs(first->length(0) - 1.0) <= 0.05);
    QVERIFY(first->p1[1] != first->p1[2]);
}

void TestModuleTurtle::booksTrees_data()
{
    QTest::addColumn<QStringList>("row");
    QFile file(QStringLiteral(RAMURE_TEST_DATA "/abop.csv"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    file.readLine();
    while (!file.atEnd()) {
        const QStringList row = QString::fromLatin1(file.readLine().trimmed()).split(u',');
        QTest::newRow(qPrintable(row[0])) << row;
    }
}

void TestModuleTurtle::booksTrees()
{
    QFETCH(QStringList, row);
    const auto* const tree = std::ranges::find_if(
        test::bookTrees, [&](const test::BookTree& each) { return row[0] == QLatin1String(each.figure); });
    QVERIFY(tree != std::end(test::bookTrees));
    const auto result = TreePipeline().evaluate(tree->params(row[1].toInt()), Stage::Skeleton);
    QVERIFY2(result, test::why(result));
    const SkeletonStats stats = skeletonStats(*result->skeleton);
    QCOMPARE(stats.branches, Index(row[2].toUInt()));
    QCOMPARE(stats.terminals, Index(row[3].toUInt()));
    const double box = glm::length(stats.max - stats.min);
    const std::pair<double, int> measures[] = {
        {stats.totalLength, 4}, {stats.sumA1, 5},     {stats.min.x, 6},    {stats.min.y, 7},
        {stats.min.z, 8},       {stats.max.x, 9},     {stats.max.y, 10},   {stats.max.z, 11},
        {stats.sumTip.x, 12},   {stats.sumTip.y, 13}, {stats.sumTip.z, 14}};
    for (const auto& [measure, column] : measures) {
        const double wanted = row[column].toDouble(), rounding = 5e-10 * std::abs(wanted); // ten digits
        QVERIFY2(std::abs(measure - wanted) <= 1e-6 * box + rounding,
                 qPrintable(QStringLiteral("%1 is not %2").arg(measure, 0, 'g', 15).arg(wanted, 0, 'g', 15)));
    }
}

void TestModuleTurtle::handbooksTreeGrows_data()
{
    QTest::addColumn<QString>("file");
    QTest::newRow("English") << "grammar.md";
    QTest::newRow("French") << "fr/grammar.md";
}

/// The example of the page: an axiom, constants, rules.
void TestModuleTurtle::handbooksTreeGrows()
{
    QFETCH(QString, file);
    QFile page(QStringLiteral(RAMURE_SOURCE_DIR "/resources/handbook/") + file);
    QVERIFY(page.open(QIODevice::ReadOnly));
    NodeParams params;
    params.grammar = {"", "", 7, false, 1, GrammarDialect::Parametric, ""};
    bool isHere = false;
    while (!page.atEnd()) {
        const QByteArray line = page.readLine();
        if (line.startsWith("## "))
            isHere = line.contains("odules"); // "Modules with numbers", "Des modules avec nombres"
        if (!isHere || !line.startsWith("    "))
            continue;
        GrammarParams& grammar = params.grammar;
        std::string& text = line.contains("->") || line.contains('#') ? grammar.rules
                            : line.contains('=')                      ? grammar.constants
                                                                      : grammar.axiom;
        text += line.toStdString();
    }
    const auto tree = TreePipeline().evaluate(params, Stage::Skeleton);
    QVERIFY2(tree, test::why(tree));
    QVERIFY(tree->skeleton->size() > 50);
}

void TestModuleTurtle::pipelineSaysWhatIsWrong()
{
    NodeParams params = test::bookTrees[0].params(4);
    TreePipeline pipeline;
    const auto before = pipeline.evaluate(params);
    QVERIFY2(before, test::why(before));
    QCOMPARE(before->symbols->substr(0, 4), std::string("!F[&"));
    params.grammar.axiom = "A(1, 10";
    const auto broken = pipeline.evaluate(params);
    QVERIFY(!broken);
    QCOMPARE(broken.error().message(),
             std::string("1:8: grammar.axiom: an operator, \",\" or \")\" is expected here"));
    params.grammar = {"A", "A -> AAAAAAAAAA", 30, false, 1, GrammarDialect::Parametric, ""};
    const auto large = pipeline.evaluate(params);
    QVERIFY(!large);
    QCOMPARE(large.error().path, std::string("grammar.iterations"));
}

void TestModuleTurtle::meshesAreSound()
{
    for (const test::BookTree& tree : test::bookTrees) {
        NodeParams params = tree.params(tree.elasticity == 0.0 ? 7 : 4);
        const auto result = TreePipeline().evaluate(params, Stage::Mesh);
        QVERIFY2(result, test::why(result));
        QVERIFY2(result->report->valid, tree.figure);
    }
}

void TestModuleTurtle::organsPointAhead()
{
    const auto s = drawn("~F(2)[+(90)~(leaf, 0.5)]~(fruit)[&(90)~(flower, 0.1)]");
    QVERIFY2(s, test::why(s));
    QCOMPARE(s->organs.size(), std::size_t(3));
    QVERIFY(s->organs[0].kind == OrganKind::Leaf && s->organs[0].size == 0.5);
    QVERIFY(near(s->organs[0].heading, {-1, 0, 0}) && near(s->organs[0].up, {0, 0, 1}));
    QVERIFY(s->organs[1].kind == OrganKind::Fruit && s->organs[1].size < 0.0);
    QVERIFY(near(s->organs[1].heading, {0, 1, 0}) && near(s->organs[1].offset, {0, 0, 0}));
    QVERIFY(s->organs[2].kind == OrganKind::Fruit && near(s->organs[2].axis, {0, 1, 0}));
}

/// Merged into a longer branch, bent with it, and in the foliage as any other leaf.
void TestModuleTurtle::organsStandOnTheirBranches()
{
    NodeParams params;
    params.grammar = {
        "!(0.1)F(1)[+(90)~(leaf, 0.3)]F(1)~(fruit, 0.2)", "", 0, false, 1, GrammarDialect::Parametric, ""};
    params.foliage.leavesCutoff = 0.0; // nothing grows by itself
    params.leaf.shape = LeafShape::Beech;
    params.fruit.kind = FruitKind::Apple;
    for (const bool merged : {false, true}) {
        params.simplify.enabled = merged;
        TreePipeline pipeline;
        const auto tree = pipeline.evaluate(params, Stage::Foliage);
        QVERIFY2(tree, test::why(tree));
        QCOMPARE(tree->simplified->skeleton.size(), Index(merged ? 1 : 2));
        QCOMPARE(tree->foliage->leaves.size(), std::size_t(1));
        QCOMPARE(tree->foliage->apples.size(), std::size_t(1));
        const FoliageItem& leaf = tree->foliage->leaves.front();
        QVERIFY(glm::length(leaf.position - glm::dvec3(-0.05, 1.0, 0.0)) < 0.01); // on the bark
        QVERIFY(near(leaf.orientation * glm::dvec3(0, 1, 0), {-1, 0, 0}, 1e-6));
        glm::vec3 low(1e9F), high(-1e9F);
        for (const glm::vec3& p : tree->leaves->positions) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
        QVERIFY(high.x - low.x > 0.25F && high.x - low.x < 0.45F); // a blade of 0.3 m and its petiole
        QVERIFY(tree->foliage->apples.front().position.y > 2.0);
    }
    Skeleton bent = *drawn("F(1)~(leaf, 0.3)");
    bent.p1[0] = {1, 0, 0};
    const auto foliage = placeFoliage(bent, params.foliage, params.leaf, params.fruit, 0.1);
    QVERIFY2(foliage, test::why(foliage));
    QVERIFY(near(foliage->leaves.front().position, {1, 0, 0}));
    QVERIFY(near(foliage->leaves.front().orientation * glm::dvec3(0, 1, 0), {1, 0, 0}, 1e-6));
}

RAMURE_SUITE(TestModuleTurtle)

} // namespace tst_module_turtle

#include "tst_module_turtle.moc"
