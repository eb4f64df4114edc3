#include "core/pipeline/freeze.h"
#include "tests/support/mesh_checker.h"
#include "tests/support/shaped_tree.h"

#include <QElapsedTimer>
#include <cmath>

namespace tst_random_recipes {

using namespace ramure;
using namespace ramure::test;

namespace {

/// Small trees of every source.
std::vector<NodeParams> plainTrees()
{
    std::vector<NodeParams> trees;
    for (const char* preset : {"TinyTree", "FanTree", "HondaTree", "EnglishOak1995", "ParkTree"}) {
        NodeParams params = *presetParams(preset);
        params.mesh.targetTriangles = 0;
        params.sections.lengthDivisions = 2;
        params.sections.radialDivisions = 5;
        params.grammar.iterations = std::min<std::int64_t>(params.grammar.iterations, 4);
        params.weberPenn.levels = 2;
        params.weberPenn.level[1].branches = 12;
        params.colonisation.points = 120;
        trees.push_back(params);
    }
    trees.push_back(plainTree());
    return trees;
}

/// A number of a row within its slider's range, now and then at an end of what it may be.
double anyNumber(const ParamDef& def, Random& random)
{
    if (random.below(12) == 0)
        return random.below(2) == 0 ? def.hardMin : def.softMax;
    return random.range(def.softMin, def.softMax);
}

void draw(NodeParams& values, const ParamDef& def, Random& random)
{
    if (def.type == ParamType::Real)
        QVERIFY(setParam(values, def, anyNumber(def, random)));
    else if (def.type == ParamType::Int && !(def.flags & paramSeed))
        QVERIFY(setParam(values, def, std::int64_t(random.range(def.softMin, std::min(def.softMax, 6.0)))));
    else if (def.type == ParamType::Bool)
        QVERIFY(setParam(values, def, random.below(2) == 0));
    else if (def.type == ParamType::Enum)
        QVERIFY(
            setParam(values, def, EnumValue{def.items[random.below(std::uint32_t(def.items.size()))].name}));
}

/// Any modifier, or a source with few branches.
TreeEdit randomStep(Random& random)
{
    std::vector<EditOperation> kinds;
    for (const EditOperationInfo& info : editOperations())
        if (!stepParams(info.operation).empty())
            kinds.push_back(info.operation);
    TreeEdit step = newStep(kinds[random.below(std::uint32_t(kinds.size()))]);
    NodeParams values = *step.values;
    for (const ParamDef* def : stepParams(step.operation)) {
        const std::string_view key = def->key;
        const bool isOwn = key.starts_with("step.") || key.starts_with("stand.") ||
                           infoOf(step.operation).group == StepGroup::Modifier;
        if (isOwn && random.below(2) == 0)
            draw(values, *def, random);
    }
    constexpr const char* conditions[] = {
        "", "order = 0", "order = 1", "order > 0 and share > 0.4", "forks = 0", "order = 1 and length > 0.5"};
    values.step.where = conditions[random.below(std::uint32_t(std::size(conditions)))];
    values.step.stand.count = std::min<std::int64_t>(values.step.stand.count, 2);
    values.step.stand.size = std::clamp(values.step.stand.size, 0.05, 1.0);
    values.grammar.axiom = "F[+F]F[^F]F";
    values.grammar.rules.clear();
    values.grammar.iterations = 0;
    values.weberPenn.levels = 2;
    values.weberPenn.level[1].branches = 5;
    values.colonisation.points = 30;
    values.step.growOn.years = std::min(values.step.growOn.years, 5.0);
    values.growth.height = std::min(values.growth.height, 6.0);
    values.growth.internode = std::max(values.growth.internode, 0.2);
    step.values = StepValues(std::move(values));
    return step;
}

bool isFinite(const TriangleMesh& mesh)
{
    return std::ranges::all_of(mesh.positions, [](const glm::vec3& p) {
        return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    });
}

} // namespace

/// Whatever the recipe, the mesh is whole.
class TestRandomRecipes : public QObject
{
    Q_OBJECT
    /// \param meshes counts those that were made
    static void grow(int recipe, int& meshes)
    {
        static const std::vector<NodeParams> plain = plainTrees();
        constexpr Index most = 6000; // branches of which a mesh is made
        Random random(20431, RandomStream::Test, std::uint64_t(recipe));
        NodeParams params = plain[random.below(std::uint32_t(plain.size()))];
        const auto count = 1 + random.below(9);
        while (params.edits.size() < count) {
            const Skeleton now = *grownTree(params, Stage::Skeleton).skeleton;
            if (now.size() > most)
                break;
            if (random.below(4) == 0) {
                static_cast<void>(make(params, randomEdit(axesOf(now), now, random)));
                if (random.below(3) > 0)
                    continue;
            }
            TreeEdit step = randomStep(random);
            QVERIFY(checkTreeEdit(step));
            step.id = newEditId(params.edits, step);
            params.edits.push_back(std::move(step));
        }
        if (!params.edits.empty() && random.below(3) == 0)
            params.edits[random.below(std::uint32_t(params.edits.size()))].enabled = false;
        const TreeResult skeleton = grownTree(params, Stage::Skeleton);
        if (skeleton.skeleton->size() > most)
            return;
        NodeParams frozen = params;
        const auto at = random.below(std::uint32_t(params.edits.size() + 1));
        QByteArray label = "recipe " + QByteArray::number(recipe) + ", frozen at " + QByteArray::number(at);
        for (const TreeEdit& step : params.edits)
            label += QByteArray(step.enabled ? ", " : ", no ") + infoOf(step.operation).key;
        const auto steps = frozenBehind(params, at);
        QVERIFY2(steps, why(steps).constData());
        frozen.edits = *steps;
        const Skeleton held = *grownTree(frozen, Stage::Skeleton).skeleton;
        QVERIFY2(held.p1 == skeleton.skeleton->p1 && held.a0 == skeleton.skeleton->a0 &&
                     held.loose == skeleton.skeleton->loose && held.rolls == skeleton.skeleton->rolls,
                 label.constData());
        TreePipeline pipeline;
        const auto tree = pipeline.evaluate(params, Stage::Mesh);
        QVERIFY2(tree, why(tree).constData());
        ++meshes;
        QVERIFY2(isFinite(tree->branches->mesh), label.constData());
        QVERIFY2(tree->report->valid, label.constData());
        QVERIFY2(tree->report->components == tree->branches->roots, label.constData());
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void everyMeshIsWhole()
    {
        // RAMURE_RECIPES asks for so many, RAMURE_FIRST_RECIPE for those from one on.
        const int asked = qEnvironmentVariableIntValue("RAMURE_RECIPES");
        const int first = qEnvironmentVariableIntValue("RAMURE_FIRST_RECIPE");
        const int recipes = asked > 0 ? asked : 150;
        int meshes = 0;
        for (int recipe = first; recipe < first + recipes && !QTest::currentTestFailed(); ++recipe)
            grow(recipe, meshes);
        QVERIFY(meshes > recipes / 2);
    }

    /// Draw, where steps had made more axes than pieces.
    void recipesThatOnceFailed()
    {
        int meshes = 0;
        grow(3547, meshes);
    }
};

RAMURE_SUITE(TestRandomRecipes)

} // namespace tst_random_recipes

#include "tst_random_recipes.moc"
