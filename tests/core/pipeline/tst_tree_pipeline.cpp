#include "core/math/random.h"
#include "core/math/stage_hash.h"
#include "core/params/param_def.h"
#include "core/pipeline/draft_tubes.h"
#include "core/pipeline/stage_cache.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "tests/support/kind_with.h"
#include "tests/support/suite.h"
#include "tests/support/turned_branches.h"

#include <cmath>
#include <limits>
#include <set>

namespace tst_tree_pipeline {

using namespace ramure;

namespace {

/// A small tree, fast to build again and again.
NodeParams smallParams()
{
    NodeParams params;
    params.grammar.iterations = 3;
    return params;
}

NodeParams grown(const char* axiom, const char* rules, std::int64_t iterations)
{
    NodeParams params;
    params.grammar = GrammarParams{axiom, rules, iterations};
    return params;
}

/// A valid value that gives another tree.
ParamValue otherValue(const ParamDef& def, const NodeParams& params)
{
    const std::string_view key = def.key;
    if (key == "grammar.axiom")
        return std::string("BBA");
    if (key == "grammar.rules")
        return params.grammar.rules + "D -> E\n";
    if (key == "grammar.constants")
        return std::string("r = 0.5");
    if ((def.flags & paramPicture) != 0)
        return std::string("/other.png");
    if ((def.flags & paramProfile) != 0)
        return std::string("0 1, 1 0.5");
    const ParamValue now = def.get(params);
    if (const auto* flag = std::get_if<bool>(&now))
        return !*flag;
    if (const auto* whole = std::get_if<std::int64_t>(&now))
        return *whole + 1;
    if (const auto* real = std::get_if<double>(&now))
        return *real == 0.0 ? 0.01 : *real * 0.9;
    if (const auto* choice = std::get_if<EnumValue>(&now))
        return EnumValue{def.items[choice->name == def.items[0].name].name};
    return std::get<glm::dvec3>(now) + glm::dvec3(0.5);
}

/// Anywhere in the range of the row, often at its ends.
ParamValue randomValue(const ParamDef& def, Random& random)
{
    const auto number = [&] {
        const double kind = random.unit();
        if (kind < 0.1)
            return random.unit() < 0.5 ? def.hardMin : def.hardMax;
        return kind < 0.3 ? random.range(def.hardMin, def.hardMax) : random.range(def.softMin, def.softMax);
    };
    switch (def.type) {
    case ParamType::Bool:
        return random.unit() < 0.5;
    case ParamType::Int:
        return static_cast<std::int64_t>(number());
    case ParamType::Real:
        return number();
    case ParamType::Vec3:
        return glm::dvec3(number(), number(), number());
    case ParamType::Enum:
        return EnumValue{def.items[random.below(static_cast<std::uint32_t>(def.items.size()))].name};
    case ParamType::Text:
        break;
    }
    return defaultValue(def);
}

/// A grammar of turns, brackets and branches that grows by chance.
GrammarParams randomGrammar(Random& random)
{
    static constexpr std::string_view alphabet = "ABCFF+-/\\^_[]";
    const auto text = [&](std::uint32_t longest) {
        std::string out;
        int open = 0;
        for (std::uint32_t i = random.below(longest) + 1; i > 0; --i) {
            const char symbol = alphabet[random.below(std::uint32_t(alphabet.size()))];
            if (symbol == ']' && open == 0)
                continue;
            open += (symbol == '[') - (symbol == ']');
            out += symbol;
        }
        return out + std::string(std::size_t(open), ']');
    };
    GrammarParams grammar{{}, {}, random.below(5)};
    grammar.axiom = text(6).append("F");
    for (const char* const head : {"A -> 0.3:", "| 0.7:", "\nB ->"})
        grammar.rules.append(head).append(text(8));
    return grammar;
}

/// What each stage gave, by address: equal addresses = from the cache.
std::array<const void*, 6> resultsOf(const TreeResult& tree)
{
    return {tree.symbols.get(),  tree.skeleton.get(), tree.simplified.get(),
            tree.sections.get(), tree.branches.get(), tree.placed.get()};
}

QByteArray messageOf(const NodeParams& params)
{
    const auto tree = TreePipeline().evaluate(params);
    return test::why(tree);
}

} // namespace

class TestTreePipeline : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void errorsNameTheParameter_data();
    void errorsNameTheParameter();
    void explodingRulesAreNamed();
    void hugeMeshesAreRefused();
    void cancelStopsAtOnce();
    void cancelOnTheWay();
    void failureLeavesTheCacheIntact();
    void laterStagesAreNull();
    void everyParameterMakesItsStageStale_data();
    void everyParameterMakesItsStageStale();
    void undoFindsItsResult();
    void cacheForgetsTheOldest();
    void seedCountsOnlyWithChance();
    void withoutSimplificationTheSkeletonStays();
    void presetsGiveValidMeshes();
    void rollsMoveTheFrames();
    void draftsOfWrongParameters();
    void draftsHaveTubesForAMesh();
    void draftTubesLieOnTheSections();
    void draftsOfLargeTreesHaveFewPoints();
    void progressRises();
    void sameResultEveryTime();
    void randomParametersGiveValidMeshes();
    void cacheHasABudget();
    void hashesTellInputsApart();
};

void TestTreePipeline::errorsNameTheParameter_data()
{
    QTest::addColumn<QByteArray>("key");
    QTest::addColumn<QByteArray>("value");
    QTest::addColumn<QByteArray>("begin");
    const auto row = [](const char* key, const char* value, const char* begin) {
        QTest::addRow("%s %s", key, value) << QByteArray(key) << QByteArray(value) << QByteArray(begin);
    };
    row("grammar.axiom", "BB]A", "1:3: grammar.axiom: ");
    row("grammar.axiom", "", "grammar.axiom: ");
    row("grammar.axiom", "C", "grammar.axiom: ");
    row("grammar.axiom", "[+]", "grammar.axiom: ");
    row("grammar.rules", "A -> B\nB -> [[C]", "2:6: grammar.rules: ");
    row("grammar.rules", "A - B", "1:3: grammar.rules: ");
    row("grammar.rules", "A -> 0.5: B | -1: C", "1:15: grammar.rules: ");
    row("grammar.rules", "A -> [B]\n[ ->", "grammar.rules: \"]\" without \"[\"");
}

void TestTreePipeline::errorsNameTheParameter()
{
    QFETCH(QByteArray, key);
    QFETCH(QByteArray, value);
    QFETCH(QByteArray, begin);
    NodeParams params = smallParams();
    QVERIFY(setParam(params, *findParam(key.constData()), value.toStdString()));
    const QByteArray message = messageOf(params);
    QVERIFY2(message.startsWith(begin), message);
}

void TestTreePipeline::explodingRulesAreNamed()
{
    const auto tree = TreePipeline().evaluate(grown("A", "A -> AAAAAAAA", 30));
    QVERIFY(!tree);
    QCOMPARE(tree.error().code, ErrorCode::Limit);
    QCOMPARE(tree.error().path, std::string("grammar.iterations"));
    QVERIFY(tree.error().plain().find("iteration 9 of 30") != std::string::npos);
    // 33 million symbols are allowed, 33 million branches are not.
    const auto branches = TreePipeline().evaluate(grown("A", "A -> AA", 25));
    QVERIFY(!branches);
    QCOMPARE(branches.error().code, ErrorCode::Limit);
    QCOMPARE(branches.error().path, std::string("grammar.iterations"));
    NodeParams params = smallParams();
    params.turtle.alpha = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(messageOf(params).startsWith("turtle.alpha: "));
    params = smallParams();
    params.sections.radialDivisions = 1'000'000;
    QVERIFY(messageOf(params).startsWith("sections.radialDivisions: "));
}

void TestTreePipeline::hugeMeshesAreRefused()
{
    NodeParams params = grown("A", "A -> A[+A][-A]", 13);
    const auto many = TreePipeline().evaluate(params);
    QVERIFY(!many);
    QCOMPARE(many.error().code, ErrorCode::Limit);
    QCOMPARE(many.error().path, std::string("grammar.iterations"));
    QVERIFY(TreePipeline().evaluate(params, Stage::Simplified)); // no mesh was asked for
    QCOMPARE(TreePipeline().evaluateDraft(params).error().code, ErrorCode::Limit);
    params.grammar.iterations = 8;
    params.sections.radialDivisions = 64;
    params.sections.lengthDivisions = 64;
    const auto fine = TreePipeline().evaluate(params);
    QVERIFY(!fine);
    QCOMPARE(fine.error().path, std::string("sections.radialDivisions"));
    // The skeleton alone may still be looked at.
    QVERIFY(TreePipeline().evaluate(params, Stage::Simplified));
}

void TestTreePipeline::cancelStopsAtOnce()
{
    std::stop_source source;
    source.request_stop();
    const auto tree = TreePipeline().evaluate(smallParams(), Stage::Foliage, {source.get_token(), {}});
    QVERIFY(!tree);
    QCOMPARE(tree.error().code, ErrorCode::Cancelled);
    QVERIFY(tree.error().path.empty());
}

void TestTreePipeline::cancelOnTheWay()
{
    for (const double stopAt : {0.01, 0.1, 0.12, 0.3, 0.5}) {
        std::stop_source source;
        TreePipeline pipeline;
        const Progress progress{source.get_token(), [&](double fraction) {
                                    if (fraction >= stopAt)
                                        source.request_stop();
                                }};
        const auto tree = pipeline.evaluate(smallParams(), Stage::Foliage, progress);
        QVERIFY(!tree);
        QCOMPARE(tree.error().code, ErrorCode::Cancelled);
        QVERIFY(pipeline.evaluate(smallParams()));
    }
}

void TestTreePipeline::failureLeavesTheCacheIntact()
{
    TreePipeline pipeline;
    const auto before = pipeline.evaluate(smallParams());
    NodeParams bad = smallParams();
    bad.grammar.axiom.insert(0, 1, ']');
    QVERIFY(!pipeline.evaluate(bad));
    QVERIFY(!pipeline.evaluate(bad));
    QVERIFY(resultsOf(*pipeline.evaluate(smallParams())) == resultsOf(*before));
}

void TestTreePipeline::laterStagesAreNull()
{
    for (int last = 0; last <= int(Stage::Placement); ++last) {
        const auto tree = TreePipeline().evaluate(smallParams(), Stage(last));
        QVERIFY2(tree, test::why(tree));
        const auto results = resultsOf(*tree);
        for (int stage = 0; stage < int(results.size()); ++stage)
            QCOMPARE(results[std::size_t(stage)] != nullptr, stage <= last);
        QCOMPARE(tree->report != nullptr, tree->branches != nullptr);
        QCOMPARE(tree->leaves != nullptr && tree->apples != nullptr, tree->foliage != nullptr);
        QVERIFY(tree->seconds >= 0.0);
        QCOMPARE(tree->sourceSeconds > 0.0, last >= int(Stage::Skeleton));
    }
    TreePipeline pipeline;
    NodeParams params = smallParams();
    const double grewIn = pipeline.evaluate(params)->sourceSeconds;
    params.foliage.leavesDensity = 3;
    QCOMPARE(pipeline.evaluate(params)->sourceSeconds, grewIn); // the tree has not grown again
}

void TestTreePipeline::everyParameterMakesItsStageStale_data()
{
    QTest::addColumn<int>("row");
    int number = 0;
    for (const ParamDef& def : paramTable())
        if (hasParam(NodeKind::Tree, def) && number++ % (test::isSanitized ? 8 : 1) == 0)
            QTest::newRow(def.key) << int(paramId(def));
}

void TestTreePipeline::everyParameterMakesItsStageStale()
{
    QFETCH(int, row);
    const ParamDef& def = paramTable()[std::size_t(row)];
    NodeParams params = smallParams();
    params.grammar.stochastic = true; // so that the seed counts
    const Relevance* relevance = relevanceOf(def);
    const std::string_view dialect = "grammar.dialect";
    if (def.key == dialect || (relevance && relevance->chooser == dialect)) { // these rules read in both
        params.grammar.axiom = "FA";
        params.grammar.rules = "A -> F[+FA][-FA]F";
    }
    test::makeRelevant(params, def);
    NodeParams changed = params;
    QVERIFY(setParam(changed, def, otherValue(def, params)));
    TreePipeline pipeline;
    const auto before = pipeline.evaluate(params), after = pipeline.evaluate(changed);
    QVERIFY2(before && after, test::why(after));
    const auto old = resultsOf(*before), now = resultsOf(*after);
    for (std::size_t stage = 0; stage < old.size(); ++stage) {
        if (stage < std::size_t(def.stage))
            QVERIFY2(old[stage] == now[stage], "a stage before the stated one was computed again");
        if (stage == std::size_t(def.stage))
            QVERIFY2(old[stage] != now[stage], "the stated stage was not computed again");
    }
}

void TestTreePipeline::undoFindsItsResult()
{
    TreePipeline pipeline;
    NodeParams params = smallParams();
    const auto before = pipeline.evaluate(params);
    params.turtle.theta = 0.5;
    QVERIFY(resultsOf(*pipeline.evaluate(params)) != resultsOf(*before));
    QVERIFY(resultsOf(*pipeline.evaluate(smallParams())) == resultsOf(*before));
}

void TestTreePipeline::cacheForgetsTheOldest()
{
    TreePipeline pipeline;
    pipeline.setCacheSize(2);
    const auto withTheta = [&](double theta) {
        NodeParams params = smallParams();
        params.turtle.theta = theta;
        return *pipeline.evaluate(params);
    };
    const TreeResult a = withTheta(0.1), b = withTheta(0.2);
    QVERIFY(withTheta(0.1).skeleton == a.skeleton); // now b is the oldest
    const TreeResult c = withTheta(0.3);
    QVERIFY(withTheta(0.1).skeleton == a.skeleton);
    QVERIFY(withTheta(0.3).skeleton == c.skeleton);
    QVERIFY(withTheta(0.2).skeleton != b.skeleton);
    // The smallest cache still keeps the newest result.
    pipeline.setCacheSize(0);
    const TreeResult d = withTheta(0.4);
    QVERIFY(withTheta(0.4).branches == d.branches);
}

void TestTreePipeline::seedCountsOnlyWithChance()
{
    TreePipeline pipeline;
    NodeParams params = smallParams();
    const auto one = pipeline.evaluate(params);
    params.grammar.seed = 2;
    QVERIFY(pipeline.evaluate(params)->symbols == one->symbols);
    params.grammar.stochastic = true;
    const auto two = pipeline.evaluate(params);
    params.grammar.seed = 3;
    QVERIFY(*pipeline.evaluate(params)->symbols != *two->symbols);
}

void TestTreePipeline::withoutSimplificationTheSkeletonStays()
{
    TreePipeline pipeline;
    NodeParams params = smallParams();
    params.simplify.enabled = false;
    const auto plain = pipeline.evaluate(params);
    QVERIFY(plain->simplified->skeleton == *plain->skeleton);
    QCOMPARE(plain->simplified->mergedInto.size(), std::size_t(plain->skeleton->size()));
    for (Index i = 0; i < plain->skeleton->size(); ++i)
        QCOMPARE(plain->simplified->mergedInto[i], i);
    params.simplify.rotationThreshold = 0.3;
    QVERIFY(pipeline.evaluate(params)->simplified == plain->simplified);
}

void TestTreePipeline::presetsGiveValidMeshes()
{
    for (const Preset& preset : courseworkPresets()) {
        const auto tree = TreePipeline().evaluate(preset.params);
        QVERIFY2(tree, test::why(tree));
        QVERIFY2(tree->report->valid, preset.name);
        QCOMPARE(tree->report->components, tree->branches->roots);
        const SkeletonStats stats = skeletonStats(tree->simplified->skeleton);
        QCOMPARE(tree->branches->roots, stats.roots);
        QCOMPARE(tree->sections->sections.size(), std::size_t(stats.branches) * 4);
        for (const Index branch : tree->branches->mesh.branch)
            QVERIFY(branch < stats.branches);
        const std::size_t each = leafMesh(tree->foliage->form).triangles.size();
        QVERIFY(!tree->foliage->leaves.empty());
        QCOMPARE(tree->leaves->faceCount(), Index(each * tree->foliage->leaves.size()));
    }
}

void TestTreePipeline::rollsMoveTheFrames()
{
    TreePipeline pipeline;
    NodeParams params = smallParams();
    const auto plain = pipeline.evaluate(params);
    const Index branch = 5;
    TreeEdit gone = test::roll(*plain, params, branch, 1.0);
    gone.target = {.address = 0xDEADull}; // an axis that this tree does not have
    const auto rolled =
        pipeline.evaluate(withSteps(params, std::vector{gone, test::roll(*plain, params, branch, 0.5)}));
    QVERIFY(rolled->simplified->skeleton.p1 == plain->simplified->skeleton.p1);
    QVERIFY(rolled->leaves->positions == plain->leaves->positions);
    const auto normal = [&](const TreeResult& tree) { return tree.sections->of(branch)[0].frame.normal; };
    QVERIFY(std::abs(glm::dot(normal(*plain), normal(*rolled)) - std::cos(0.5)) < 1e-12);
    QVERIFY(rolled->branches->mesh.positions != plain->branches->mesh.positions);
    QVERIFY(rolled->report->valid);
}

void TestTreePipeline::draftsOfWrongParameters()
{
    TreePipeline pipeline;
    NodeParams params = smallParams();
    params.grammar.axiom.assign(1, '[');
    QVERIFY(!pipeline.evaluateDraft(params));
    params = smallParams();
    params.turtle.alpha = -1.0;
    QVERIFY(!pipeline.evaluateDraft(params));
    params = smallParams();
    params.sections = {64, 64};
    params.grammar.iterations = 11;
    const auto large = pipeline.evaluateDraft(params);
    QVERIFY(!large);
    QCOMPARE(large.error().code, ErrorCode::Limit); // of the full mesh: there would never be one
    std::stop_source stop;
    stop.request_stop();
    QCOMPARE(pipeline.evaluateDraft(smallParams(), {stop.get_token(), {}}).error().code,
             ErrorCode::Cancelled);
}

void TestTreePipeline::draftsHaveTubesForAMesh()
{
    TreePipeline pipeline;
    const auto draft = pipeline.evaluateDraft(smallParams());
    QVERIFY2(draft, test::why(draft));
    QVERIFY(draft->draftTubes && !draft->branches && !draft->report);
    const auto full = pipeline.evaluate(smallParams());
    QVERIFY(!full->draftTubes);
    QVERIFY(draft->symbols == full->symbols && draft->simplified == full->simplified);
    QVERIFY(draft->foliage == full->foliage && draft->leaves == full->leaves);
    QVERIFY(draft->sections == full->sections); // a small tree has all of them
    const auto again = pipeline.evaluateDraft(smallParams());
    QVERIFY(again->branches == full->branches && again->report == full->report && !again->draftTubes);
}

void TestTreePipeline::draftTubesLieOnTheSections()
{
    const auto tree = TreePipeline().evaluate(smallParams(), Stage::Sections);
    const Skeleton& skeleton = tree->simplified->skeleton;
    const SectionSet& sections = *tree->sections;
    constexpr int points = 7;
    const TriangleMesh tubes = buildDraftTubes(skeleton, sections, points);
    QCOMPARE(tubes.positions.size(), sections.sections.size() * points);
    QCOMPARE(tubes.triangles.size(), std::size_t(skeleton.size()) * (sections.perBranch - 1) * points * 2);
    for (std::size_t i = 0; i < tubes.positions.size(); ++i) {
        const CrossSection& section = sections.sections[i / points];
        const glm::vec3 wanted(sectionPoint(section, static_cast<int>(i % points), points));
        QVERIFY(glm::distance(tubes.positions[i], wanted) < 1e-5f);
        QCOMPARE(tubes.branch[i], Index(i / (points * sections.perBranch)));
    }
    for (const glm::uvec3& t : tubes.triangles) {
        const glm::vec3& a = tubes.positions[t.x];
        const glm::vec3 normal = glm::cross(tubes.positions[t.y] - a, tubes.positions[t.z] - a);
        const glm::vec3 out = tubes.normals[t.x] + tubes.normals[t.y] + tubes.normals[t.z];
        QVERIFY(glm::dot(normal, out) > 0.0f || glm::length(normal) < 1e-12f);
    }
}

void TestTreePipeline::draftsOfLargeTreesHaveFewPoints()
{
    const SectionParams wanted{64, 128};
    for (const Index branches : {0u, 1u, 100u, 1'791u, 7'167u, 30'000u, 1'000'000u}) {
        const SectionParams draft = draftDivisions(wanted, branches);
        QVERIFY(draft.lengthDivisions >= 2 && draft.lengthDivisions <= wanted.lengthDivisions);
        QVERIFY(draft.radialDivisions >= 3 && draft.radialDivisions <= wanted.radialDivisions);
        const auto points =
            static_cast<std::size_t>(draft.lengthDivisions * draft.radialDivisions) * branches;
        QVERIFY(points <= std::max<std::size_t>(draftPoints, std::size_t(branches) * 6));
    }
    QVERIFY(draftDivisions(SectionParams{2, 3}, 1'000'000) == (SectionParams{2, 3}));
    QVERIFY(draftDivisions(SectionParams(), 1'791) == SectionParams()); // SmallTree: as it will be
}

void TestTreePipeline::progressRises()
{
    double last = 0.0;
    bool rises = true;
    const Progress progress{{}, [&](double fraction) {
                                rises = rises && fraction >= last - 1e-12 && fraction <= 1.0;
                                last = fraction;
                            }};
    QVERIFY(TreePipeline().evaluate(smallParams(), Stage::Foliage, progress));
    QVERIFY(rises);
    QCOMPARE(last, 1.0);
}

void TestTreePipeline::sameResultEveryTime()
{
    NodeParams params = smallParams();
    params.grammar.stochastic = true;
    const auto a = TreePipeline().evaluate(params), b = TreePipeline().evaluate(params);
    QVERIFY(*a->symbols == *b->symbols && *a->skeleton == *b->skeleton);
    QVERIFY(a->branches->mesh == b->branches->mesh);
    QVERIFY(*a->leaves == *b->leaves && *a->apples == *b->apples);
}

void TestTreePipeline::randomParametersGiveValidMeshes()
{
    Random random(11, RandomStream::Test);
    TreePipeline pipeline;
    int valid = 0;
    for (int i = 0; i < test::runs(300); ++i) {
        NodeParams params;
        for (const ParamDef& def : paramTable())
            QVERIFY(setParam(params, def, randomValue(def, random)));
        const GrammarParams grammar = randomGrammar(random); // of letters
        params.generator = {}; // trees of Weber and Penn have a suite of their own
        params.grammar.dialect = grammar.dialect;
        params.grammar.axiom = grammar.axiom;
        params.grammar.rules = grammar.rules;
        params.grammar.iterations = grammar.iterations;
        const auto tree = pipeline.evaluate(params);
        if (!tree) {
            QVERIFY2(tree.error().code == ErrorCode::Limit, test::why(tree));
            continue;
        }
        const QByteArray said =
            QByteArray::number(i) + ": " + QByteArray::fromStdString(grammar.axiom + ", " + grammar.rules);
        QVERIFY2(tree->report->valid, said);
        QCOMPARE(tree->report->components, tree->branches->roots);
        QCOMPARE(tree->report->eulerCharacteristic, 2 * std::int64_t(tree->branches->roots));
        ++valid;
    }
    QVERIFY(valid > test::runs(300) * 2 / 3);
}

void TestTreePipeline::cacheHasABudget()
{
    struct Result
    {
        mutable std::size_t bytes; // results may grow while they are kept
    };
    constexpr std::size_t budget = StageCache<Result>::usualBudget;
    StageCache<Result> cache([](const Result& result) { return result.bytes; });
    const auto keep = [&](std::uint64_t hash, std::size_t bytes) {
        cache.keep(hash, std::make_shared<const Result>(Result{bytes}));
    };
    keep(1, budget / 2);
    keep(2, budget / 2);
    QCOMPARE(cache.size(), std::size_t(2));
    QCOMPARE(cache.bytes(), budget);
    keep(3, 1);
    QCOMPARE(cache.size(), std::size_t(2));
    QVERIFY(!cache.find(1) && cache.find(2) && cache.find(3));
    keep(4, 10 * budget);
    QCOMPARE(cache.size(), std::size_t(1));
    QCOMPARE(cache.find(4)->bytes, 10 * budget);
    keep(5, 1);
    keep(6, 1);
    QCOMPARE(cache.size(), std::size_t(2));
    cache.find(5)->bytes = budget;
    QCOMPARE(cache.find(5)->bytes, budget);
    QCOMPARE(cache.size(), std::size_t(1));
}

void TestTreePipeline::hashesTellInputsApart()
{
    std::set<std::uint64_t> seen;
    const auto add = [&](std::initializer_list<std::string_view> texts) {
        StageHash hash(0);
        for (const std::string_view text : texts)
            hash.add(text);
        seen.insert(hash.value());
    };
    add({});
    add({""});
    add({"", ""});
    add({"a"});
    add({"ab", "c"});
    add({"a", "bc"});
    add({"abcdefgh"});
    add({"abcdefgh", ""});
    add({"abcdefghi"});
    QCOMPARE(seen.size(), std::size_t(9));
    QVERIFY(StageHash(1).add(0.0).value() != StageHash(2).add(0.0).value());
}

RAMURE_SUITE(TestTreePipeline)

} // namespace tst_tree_pipeline

#include "tst_tree_pipeline.moc"
