#include "core/params/param_def.h"
#include "core/pipeline/stage_hashes.h"
#include "tests/support/kind_with.h"
#include "tests/support/suite.h"

#include <functional>

namespace tst_stage_hashes {

using namespace ramure;

namespace {

/// Another one, inside the range of the row.
ParamValue otherValue(const ParamDef& def, const NodeParams& params)
{
    const ParamValue now = def.get(params);
    if (std::string_view(def.key) == "growth.age") // within ten years, whose ages are cut out of one life
        return params.growth.age - 0.5;
    if (const auto* flag = std::get_if<bool>(&now))
        return !*flag;
    if (const auto* whole = std::get_if<std::int64_t>(&now))
        return *whole + (double(*whole) < def.hardMax ? 1 : -1);
    if (const auto* real = std::get_if<double>(&now))
        return *real == def.hardMin ? def.hardMax : def.hardMin;
    if (const auto* text = std::get_if<std::string>(&now))
        return *text + " ";
    if (const auto* choice = std::get_if<EnumValue>(&now))
        return EnumValue{def.items[choice->name == def.items[0].name].name};
    return std::get<glm::dvec3>(now) * 0.5 + glm::dvec3(0.5);
}

NodeParams withOther(const ParamDef& def, NodeParams params)
{
    def.assign(params, otherValue(def, params));
    return params;
}

/// The parameters beside which the row does, or does not, matter: the defaults, or those but for a few
/// values.
std::optional<NodeParams> paramsWhere(const ParamDef& def, bool matters)
{
    const auto fits = [&](const NodeParams& params) {
        return matters == (!def.matters || def.matters(params));
    };
    NodeParams params;
    if (matters)
        test::makeRelevant(params, def);
    if (fits(params))
        return params;
    for (const ParamDef& other : paramTable())
        if (const NodeParams turned = withOther(other, params); &other != &def && fits(turned))
            return turned;
    return std::nullopt;
}

bool isMade(Stage stage)
{
    return stage != Stage::Placement && stage != Stage::Motion;
}

} // namespace

class TestStageHashes : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void everyRowChangesItsStage_data();
    void everyRowChangesItsStage();
    void whatDoesNotMatterChangesNothing_data() { everyRowChangesItsStage_data(); }
    void whatDoesNotMatterChangesNothing();
    void budgetsNeedNoSections();
    void editsChangeTheSkeleton();
    void everyValueOfBarkChangesItsHash();
};

void TestStageHashes::everyRowChangesItsStage_data()
{
    QTest::addColumn<int>("row");
    for (const ParamDef& def : paramTable())
        QTest::newRow(def.key) << int(paramId(def));
}

void TestStageHashes::everyRowChangesItsStage()
{
    QFETCH(int, row);
    const ParamDef& def = paramTable()[std::size_t(row)];
    const auto params = paramsWhere(def, true);
    QVERIFY(params);
    const StageHashes before(*params), after(withOther(def, *params));
    const bool isOfTrees = hasParam(NodeKind::Tree, def) && isMade(def.stage);
    QCOMPARE(before[def.stage] != after[def.stage], isOfTrees);
    for (std::size_t stage = 0; stage < stageCount; ++stage)
        if (Stage(stage) < def.stage || !isOfTrees)
            QCOMPARE(after[Stage(stage)], before[Stage(stage)]);
}

void TestStageHashes::whatDoesNotMatterChangesNothing()
{
    QFETCH(int, row);
    const ParamDef& def = paramTable()[std::size_t(row)];
    const auto params = paramsWhere(def, false);
    QCOMPARE(params.has_value(), def.matters != nullptr);
    if (!params)
        return;
    const StageHashes before(*params), after(withOther(def, *params));
    for (std::size_t stage = 0; stage < stageCount; ++stage)
        QCOMPARE(after[Stage(stage)], before[Stage(stage)]);
}

void TestStageHashes::budgetsNeedNoSections()
{
    NodeParams params;
    params.mesh.targetTriangles = 5000;
    const StageHashes before(params);
    params.sections.lengthDivisions += 1;
    const StageHashes after(params);
    QVERIFY(after[Stage::Sections] != before[Stage::Sections]);
    QCOMPARE(after[Stage::Mesh], before[Stage::Mesh]);
}

void TestStageHashes::editsChangeTheSkeleton()
{
    NodeParams params;
    const StageHashes plain(params);
    QCOMPARE(plain.grown(), plain[Stage::Skeleton]);
    TreeEdit edit;
    edit.id = 1;
    edit.target.address = 7;
    params.edits = {edit};
    const StageHashes edited(params);
    QCOMPARE(edited.grown(), plain.grown());
    QCOMPARE(edited[Stage::Symbols], plain[Stage::Symbols]);
    for (const Stage stage :
         {Stage::Skeleton, Stage::Simplified, Stage::Sections, Stage::Mesh, Stage::Foliage, Stage::Texture})
        QVERIFY(edited[stage] != plain[stage]);
    params.edits.front().name = "Its name changes nothing";
    QCOMPARE(StageHashes(params)[Stage::Skeleton], edited[Stage::Skeleton]);
    for (const auto& change : std::initializer_list<std::function<void(TreeEdit&)>>{
             [](TreeEdit& e) { e.enabled = false; }, [](TreeEdit& e) { e.at = 0.7; },
             [](TreeEdit& e) { e.target.address = 8; }, [](TreeEdit& e) { e.points.resize(1); },
             [](TreeEdit& e) { e.operation = EditOperation::Cut; }}) {
        NodeParams other = params;
        change(other.edits.front());
        QVERIFY(StageHashes(other)[Stage::Skeleton] != edited[Stage::Skeleton]);
    }
}

void TestStageHashes::everyValueOfBarkChangesItsHash()
{
    const NodeParams plain;
    int values = 0;
    for (const ParamDef& def : paramTable()) {
        const BarkParams other = withOther(def, plain).bark;
        QCOMPARE(barkHash(other) == barkHash(plain.bark), other == plain.bark);
        values += other == plain.bark ? 0 : 1;
    }
    QCOMPARE(values, 5);
    QVERIFY(barkHash(plain.bark, 1) != barkHash(plain.bark, 2));
}

RAMURE_SUITE(TestStageHashes)

} // namespace tst_stage_hashes

#include "tst_stage_hashes.moc"
