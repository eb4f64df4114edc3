#include "core/params/param_relevance.h"
#include "core/surface/primitives/primitive_mesh.h"
#include "tests/support/suite.h"

namespace tst_param_relevance {

using namespace ramure;

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
