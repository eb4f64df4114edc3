#include "core/params/param_relevance.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/surface/primitives/primitive_mesh.h"
#include "tests/support/suite.h"

namespace tst_param_relevance {

using namespace ramure;

namespace {

/// A valid number, switch or choice that is not the one of \p params; texts stay.
ParamValue otherValue(const ParamDef& def, const NodeParams& params)
{
    const ParamValue now = def.get(params);
    if (const auto* flag = std::get_if<bool>(&now))
        return !*flag;
    if (const auto* whole = std::get_if<std::int64_t>(&now))
        return *whole + (double(*whole) < def.softMax ? 1 : -1);
    if (const auto* real = std::get_if<double>(&now))
        return *real == def.softMax ? def.softMin : def.softMax;
    if (const auto* choice = std::get_if<EnumValue>(&now))
        return EnumValue{def.items[choice->name == def.items[0].name].name};
    if (const auto* vector = std::get_if<glm::dvec3>(&now))
        return *vector * 0.5 + glm::dvec3(0.25);
    return now;
}

NodeParams grammarTree()
{
    NodeParams params;
    params.grammar.iterations = 3;
    return params;
}

NodeParams parametricTree()
{
    NodeParams params = grammarTree();
    params.grammar.dialect = GrammarDialect::Parametric;
    params.grammar.stochastic = true;
    params.grammar.axiom = "FA";
    params.grammar.rules = "A -> F[+FA][-FA]F";
    params.mesh.targetTriangles = 2000;
    return params;
}

/// A trunk with limbs, in a crown like the envelope, with leaves of a birch.
NodeParams weberPennTree()
{
    NodeParams params;
    params.generator.kind = EditOperation::WeberPenn;
    params.weberPenn.levels = 2;
    params.weberPenn.shape = CrownShape::Envelope;
    params.weberPenn.level[1].branches = 8;
    params.leaf.shape = LeafShape::Birch;
    params.mesh.forkSoftness = 0.0;
    return params;
}

NodeParams colonisedTree()
{
    NodeParams params;
    params.generator.kind = EditOperation::Colonisation;
    params.colonisation.points = 200;
    params.simplify.enabled = false;
    return params;
}

NodeParams grownByYears()
{
    NodeParams params;
    params.generator.kind = EditOperation::Growth;
    params.growth.age = 6.0;
    params.mesh.targetTriangles = 3000;
    return params;
}

} // namespace

class TestParamRelevance : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void everyRowNamesAParameterAndItems()
    {
        int found = 0;
        for (const ParamDef& def : paramTable()) {
            const Relevance* relevance = relevanceOf(def);
            if (!relevance)
                continue;
            ++found;
            const ParamDef* chooser = findParam(relevance->chooser);
            QVERIFY2(chooser && chooser->type == ParamType::Enum, def.key);
            QVERIFY2(chooser->kinds == def.kinds, def.key);
            QVERIFY2(!relevance->items.empty() && relevance->items.size() < chooser->items.size(), def.key);
            for (const char* item : relevance->items)
                QVERIFY2(checkValue(*chooser, EnumValue{item}), item);
        }
        QVERIFY(found > 0);
    }

    void whatNothingDecidesAboutIsRelevant()
    {
        for (const ParamDef& def : paramTable())
            QVERIFY2(relevanceOf(def) || isRelevant(NodeParams(), def), def.key);
    }

    /// Tracks give a parameter many values: none of them may decide whether another one acts.
    void whatIsAnimatedTurnsNothingOff()
    {
        for (const NodeParams& params : {grammarTree(), weberPennTree(), colonisedTree(), grownByYears()})
            for (const ParamDef& def : paramTable()) {
                if ((def.flags & paramAnimatable) == 0)
                    continue;
                NodeParams changed = params;
                def.assign(changed, clampValue(def, otherValue(def, params)));
                for (const ParamDef& other : paramTable())
                    QVERIFY2(&other == &def || acts(params, other) == acts(changed, other), other.key);
            }
    }

    void whatDoesNotActChangesNoTree_data()
    {
        QTest::addColumn<NodeParams>("params");
        QTest::newRow("grammar") << grammarTree();
        QTest::newRow("parametric") << parametricTree();
        QTest::newRow("Weber and Penn") << weberPennTree();
        QTest::newRow("colonisation") << colonisedTree();
        QTest::newRow("growth") << grownByYears();
    }
    void whatDoesNotActChangesNoTree()
    {
        QFETCH(NodeParams, params);
        NodeParams changed = params;
        int idle = 0;
        for (const ParamDef& def : paramTable())
            if (hasParam(NodeKind::Tree, def) && !acts(params, def) && def.stage < Stage::Placement) {
                def.assign(changed, otherValue(def, params));
                ++idle;
            }
        QVERIFY(idle > 20);
        TreePipeline pipeline, other; // no result of the one is kept for the other
        const auto before = pipeline.evaluate(params), after = other.evaluate(changed);
        QVERIFY2(before && after, test::why(after));
        QVERIFY(*before->skeleton == *after->skeleton);
        const auto same = [](const TriangleMesh& a, const TriangleMesh& b) {
            return a.positions == b.positions && a.triangles == b.triangles;
        };
        QVERIFY(same(before->branches->mesh, after->branches->mesh));
        QVERIFY(same(*before->leaves, *after->leaves) && same(*before->apples, *after->apples));
    }

    /// The table against the geometry itself: a value changes a primitive exactly where it is said to.
    void primitivesChangeWithWhatIsRelevant()
    {
        const auto other = [](const ParamDef& def) -> ParamValue {
            switch (def.type) {
            case ParamType::Int:
                return std::int64_t{7};
            case ParamType::Vec3:
                return glm::dvec3(0.3, 0.7, 0.4);
            case ParamType::Enum:
                return EnumValue{"x"};
            default:
                return 0.37;
            }
        };
        const ParamDef& shape = *findParam("primitive.shape");
        for (const EnumItem& item : shape.items)
            for (const char* key : {"primitive.radius", "primitive.height", "primitive.size",
                                    "primitive.sides", "primitive.axis"}) {
                NodeParams params;
                params.primitive.radius = 0.1;
                shape.assign(params, EnumValue{item.name});
                const auto before = primitiveMesh(params.primitive);
                findParam(key)->assign(params, other(*findParam(key)));
                const auto after = primitiveMesh(params.primitive);
                const bool changes =
                    before.positions != after.positions || before.triangles != after.triangles;
                QVERIFY2(changes == isRelevant(params, *findParam(key)), item.name);
            }
    }
};

RAMURE_SUITE(TestParamRelevance)

} // namespace tst_param_relevance

#include "tst_param_relevance.moc"
