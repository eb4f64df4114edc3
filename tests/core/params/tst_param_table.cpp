#include "core/params/param_def.h"
#include "tests/support/suite.h"

#include <cmath>
#include <limits>
#include <set>

namespace tst_param_table {

using namespace ramure;

namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

const ParamDef& row(const char* key)
{
    const ParamDef* def = findParam(key);
    if (!def)
        qFatal("no parameter %s", key);
    return *def;
}

/// A value of the row's type that is not the default.
ParamValue otherValue(const ParamDef& def)
{
    switch (def.type) {
    case ParamType::Bool:
        return !std::get<bool>(defaultValue(def));
    case ParamType::Int:
        return std::get<std::int64_t>(defaultValue(def)) + 1;
    case ParamType::Real:
        return (def.hardMin + def.hardMax) / 3.0 + 0.01;
    case ParamType::Text:
        return std::string("AB[+C]\\\n/D, é");
    case ParamType::Vec3:
        return glm::dvec3(0.1, 2.0 / 3.0, 1.0 / 7.0);
    case ParamType::Enum:
        return EnumValue{
            def.items[defaultValue(def) == ParamValue(EnumValue{def.items[0].name}) ? 1 : 0].name};
    }
    return false;
}

ParamValue ofOtherType(const ParamDef& def)
{
    return def.type == ParamType::Bool ? ParamValue(1.0) : ParamValue(true);
}

} // namespace

class TestParamTable : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void unknownKeysAreNull();
    void keysAreThePublicInterface();
    void rowsAreComplete();
    void wrongTypeIsRefused();
    void numbersOutsideAreRefused();
    void nonFiniteIsRefused();
    void badTextsAreRefused();
    void namesThatAreNoItemAreRefused();
    void refusedValuesChangeNothing();
    void defaultsAreValid();
    void clampGivesValidValues();
    void clampIsIdentityInside();
    void assignedValueIsReadBack();
    void textRoundTrip();
    void badTextOfNumbers_data();
    void badTextOfNumbers();
    void boolWords();
    void escapesInTexts();
    void checkParamsNamesTheKey();
    void checkParamsSeesSteps();
    void seedsSayOfWhat();
    void kindsOfNodes();
};

void TestParamTable::unknownKeysAreNull()
{
    for (const char* key : {"", "grammar", "grammar.", "Grammar.axiom", "grammar.axiom ", "turtle.gamma"})
        QVERIFY2(!findParam(key), key);
}

void TestParamTable::keysAreThePublicInterface()
{
    const std::vector<std::string> expected{"grammar.dialect",
                                            "grammar.axiom",
                                            "grammar.rules",
                                            "grammar.constants",
                                            "grammar.iterations",
                                            "grammar.stochastic",
                                            "grammar.seed",
                                            "turtle.theta",
                                            "turtle.alpha",
                                            "turtle.decay",
                                            "turtle.tropism",
                                            "turtle.elasticity",
                                            "variation.angle",
                                            "variation.length",
                                            "variation.radius",
                                            "simplify.enabled",
                                            "simplify.rotationThreshold",
                                            "sections.lengthDivisions",
                                            "sections.radialDivisions",
                                            "mesh.targetTriangles",
                                            "mesh.leastRadius",
                                            "mesh.forkSoftness",
                                            "mesh.forkReach",
                                            "mesh.forkLength",
                                            "mesh.collar",
                                            "mesh.fairing",
                                            "mesh.ridge",
                                            "mesh.clampOvershoot",
                                            "mesh.nearTwinRatio",
                                            "mesh.roots",
                                            "mesh.rootLength",
                                            "mesh.rootHeight",
                                            "foliage.leaf",
                                            "foliage.leavesCutoff",
                                            "foliage.leavesDensity",
                                            "foliage.internode",
                                            "foliage.arrangement",
                                            "foliage.whorl",
                                            "foliage.leafAngle",
                                            "foliage.leafDroop",
                                            "foliage.leafLight",
                                            "season.day",
                                            "foliage.season",
                                            "foliage.leafStiffness",
                                            "foliage.leafFlutter",
                                            "foliage.leafSize",
                                            "foliage.leafVariation",
                                            "foliage.leafWidth",
                                            "foliage.petiole",
                                            "foliage.leafFold",
                                            "foliage.leafCurl",
                                            "foliage.leafCup",
                                            "foliage.leafDetail",
                                            "foliage.applesProbability",
                                            "foliage.fruit",
                                            "foliage.fruitSize",
                                            "foliage.fruitStalk",
                                            "foliage.seed",
                                            "texture.tileSize",
                                            "tree.translation",
                                            "tree.rotation",
                                            "tree.scale",
                                            "physics.mode",
                                            "physics.stepSeconds",
                                            "physics.substeps",
                                            "physics.gravity",
                                            "physics.damping",
                                            "physics.restitution",
                                            "physics.restFrame",
                                            "physics.appleMass",
                                            "physics.windStrength",
                                            "physics.windDirection",
                                            "physics.windGust",
                                            "physics.windTurbulence",
                                            "physics.seed",
                                            "physics.appleBounce",
                                            "physics.appleFriction"};
    std::vector<std::string> keys;
    for (const ParamDef& def : paramTable())
        keys.emplace_back(def.key);
    for (const std::string& key : expected)
        QVERIFY2(std::ranges::find(keys, key) != keys.end(), key.c_str());
    const std::set<std::string> unique(keys.begin(), keys.end());
    QCOMPARE(unique.size(), keys.size());
}

void TestParamTable::rowsAreComplete()
{
    for (const ParamDef& def : paramTable()) {
        QVERIFY(*def.key && *def.group && *def.label && *def.tooltip);
        QVERIFY2(def.kinds != 0, def.key);
        QCOMPARE(&paramTable()[paramId(def)], &def);
        QCOMPARE(findParam(def.key), &def);
        QCOMPARE(std::size_t(def.type), defaultValue(def).index());
        QCOMPARE(def.items.size() >= 2, def.type == ParamType::Enum);
        for (const EnumItem& item : def.items)
            QVERIFY2(*item.name && *item.label, def.key);
        if (def.type == ParamType::Bool || def.type == ParamType::Text || def.type == ParamType::Enum)
            continue;
        QVERIFY2(def.hardMin < def.hardMax && def.softMin < def.softMax, def.key);
        QVERIFY2(def.hardMin <= def.softMin && def.softMax <= def.hardMax, def.key);
        QVERIFY2(def.step > 0.0 && def.decimals >= 0, def.key);
        if (def.type == ParamType::Int)
            QVERIFY2(def.decimals == 0 && def.step == std::floor(def.step), def.key);
    }
}

void TestParamTable::wrongTypeIsRefused()
{
    for (const ParamDef& def : paramTable()) {
        const auto checked = checkValue(def, ofOtherType(def));
        QVERIFY2(!checked, def.key);
        QCOMPARE(checked.error().code, ErrorCode::Invalid);
        QCOMPARE(checked.error().path, std::string(def.key));
        QVERIFY(clampValue(def, ofOtherType(def)) == defaultValue(def));
    }
}

void TestParamTable::numbersOutsideAreRefused()
{
    for (const ParamDef& def : paramTable()) {
        for (const double outside : {def.hardMin - 1.0, def.hardMax + 1.0, def.hardMax * 1e10 + 1e9}) {
            if (def.type == ParamType::Int) {
                const auto whole =
                    outside > 9e18 ? std::numeric_limits<std::int64_t>::max() : std::int64_t(outside);
                // The largest seeds lie where a double cannot tell neighbours apart.
                if (whole == std::int64_t(def.hardMax))
                    continue;
                QVERIFY2(!checkValue(def, whole), def.key);
            } else if (def.type == ParamType::Real) {
                QVERIFY2(!checkValue(def, outside), def.key);
            } else if (def.type == ParamType::Vec3) {
                for (int i = 0; i < 3; ++i) {
                    glm::dvec3 vector(1.0);
                    vector[i] = outside;
                    const auto checked = checkValue(def, vector);
                    QVERIFY2(!checked, def.key);
                    QCOMPARE(checked.error().path, std::string(def.key));
                }
            }
        }
    }
    QCOMPARE(checkValue(row("sections.radialDivisions"), std::int64_t(2)).error().message(),
             std::string("sections.radialDivisions: must be between 3 and 64, not 2"));
    QCOMPARE(checkValue(row("mesh.targetTriangles"), std::int64_t(-1)).error().message(),
             std::string("mesh.targetTriangles: must be between 0 and 20000000, not -1"));
    QVERIFY(!checkValue(row("turtle.alpha"), 0.0));
    QVERIFY(!checkValue(row("turtle.decay"), 0.0));
    QVERIFY(!checkValue(row("tree.scale"), glm::dvec3(1.0, 0.0, 1.0)));
    QVERIFY(!checkValue(row("grammar.iterations"), std::int64_t(31)));
}

void TestParamTable::nonFiniteIsRefused()
{
    for (const ParamDef& def : paramTable()) {
        for (const double bad : {notANumber, infinity, -infinity}) {
            if (def.type == ParamType::Real) {
                QVERIFY2(!checkValue(def, bad), def.key);
                QVERIFY2(clampValue(def, bad) == defaultValue(def), def.key);
            } else if (def.type == ParamType::Vec3) {
                QVERIFY2(!checkValue(def, glm::dvec3(1.0, bad, 1.0)), def.key);
                QVERIFY2(checkValue(def, clampValue(def, glm::dvec3(1.0, bad, 1.0))), def.key);
            }
        }
    }
}

void TestParamTable::badTextsAreRefused()
{
    const ParamDef& def = row("grammar.rules");
    QVERIFY(!checkValue(def, std::string("A\0B", 3)));
    QVERIFY(checkValue(def, std::string(1 << 20, 'A')));
    QVERIFY(!checkValue(def, std::string((1 << 20) + 1, 'A')));
    QVERIFY(clampValue(def, std::string("A\0B", 3)) == defaultValue(def));
}

void TestParamTable::namesThatAreNoItemAreRefused()
{
    const ParamDef& def = row("physics.mode");
    for (const char* name : {"", "Robust", "robus", "robust2", "0", "1"}) {
        const auto value = parseValue(def, name);
        QVERIFY2(value, test::why(value));
        const auto checked = checkValue(def, *value);
        QVERIFY2(!checked, name);
        QCOMPARE(checked.error().path, std::string(def.key));
        QVERIFY(clampValue(def, *value) == defaultValue(def));
    }
    QCOMPARE(checkValue(def, EnumValue{"quick"}).error().message(),
             std::string("physics.mode: must be one of faithful, robust, not \"quick\""));
    NodeParams params;
    QVERIFY(setParam(params, def, *parseValue(def, " faithful ")));
    QCOMPARE(params.physics.mode, PhysicsMode::Faithful);
}

void TestParamTable::refusedValuesChangeNothing()
{
    for (const ParamDef& def : paramTable()) {
        NodeParams params;
        QVERIFY(!setParam(params, def, ofOtherType(def)));
        QVERIFY(params == NodeParams());
    }
}

void TestParamTable::defaultsAreValid()
{
    QVERIFY(checkParams(NodeParams()));
    for (const ParamDef& def : paramTable()) {
        const auto checked = checkValue(def, defaultValue(def));
        QVERIFY2(checked, test::why(checked));
    }
}

void TestParamTable::clampGivesValidValues()
{
    for (const ParamDef& def : paramTable()) {
        for (const double wild : {-1e300, -1e9, -1.0, 0.0, 0.5, 1e9, 1e300, notANumber, infinity}) {
            ParamValue value = otherValue(def);
            if (def.type == ParamType::Int)
                value = std::isfinite(wild) ? std::int64_t(std::clamp(wild, -9e18, 9e18)) : std::int64_t(0);
            else if (def.type == ParamType::Real)
                value = wild;
            else if (def.type == ParamType::Vec3)
                value = glm::dvec3(wild, -wild, 1.0);
            const auto checked = checkValue(def, clampValue(def, value));
            QVERIFY2(checked, test::why(checked));
        }
    }
}

void TestParamTable::clampIsIdentityInside()
{
    for (const ParamDef& def : paramTable()) {
        QVERIFY2(clampValue(def, otherValue(def)) == otherValue(def), def.key);
        QVERIFY2(clampValue(def, defaultValue(def)) == defaultValue(def), def.key);
    }
    QVERIFY(clampValue(row("sections.radialDivisions"), std::int64_t(1000)) == ParamValue(std::int64_t(64)));
    QVERIFY(clampValue(row("turtle.decay"), 7.0) == ParamValue(1.0));
}

void TestParamTable::assignedValueIsReadBack()
{
    for (const ParamDef& def : paramTable()) {
        NodeParams params;
        const auto set = setParam(params, def, otherValue(def));
        QVERIFY2(set, test::why(set));
        QVERIFY2(def.get(params) == otherValue(def), def.key);
        // One row changes one value: setting it back leaves nothing behind.
        for (const ParamDef& other : paramTable())
            QVERIFY2(&other == &def || other.get(params) == defaultValue(other), other.key);
        QVERIFY(setParam(params, def, defaultValue(def)));
        QVERIFY2(params == NodeParams(), def.key);
    }
}

void TestParamTable::textRoundTrip()
{
    for (const ParamDef& def : paramTable()) {
        for (const ParamValue& value : {defaultValue(def), otherValue(def)}) {
            const auto parsed = parseValue(def, formatValue(value));
            QVERIFY2(parsed, test::why(parsed));
            QVERIFY2(*parsed == value, def.key);
        }
    }
    QCOMPARE(formatValue(0.1), std::string("0.1"));
    QCOMPARE(formatValue(glm::dvec3(1.0, -0.5, 1e100)), std::string("1,-0.5,1e+100"));
    QCOMPARE(formatValue(true), std::string("true"));
    for (const char* text : {"3", "3.0", "3.00", " +3.0 "}) // as pandas writes a column with gaps
        QVERIFY2(*parseValue(row("grammar.iterations"), text) == ParamValue(std::int64_t(3)), text);
    QVERIFY(*parseValue(row("tree.translation"), " 1, 2 ,+3") == ParamValue(glm::dvec3(1, 2, 3)));
}

void TestParamTable::badTextOfNumbers_data()
{
    QTest::addColumn<QByteArray>("key");
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("code");
    const auto bad = [](const char* key, const char* text, ErrorCode code = ErrorCode::Syntax) {
        QTest::addRow("%s=%s", key, text) << QByteArray(key) << QByteArray(text) << int(code);
    };
    for (const char* text : {"", " ", "x", "1.5", "1e3", "0x10", "1 2", "+-1", "--1", "1,000", "+", "10.000",
                             "1.01", ".0", "1e3.0", "1..0", "1.0.0"})
        bad("grammar.iterations", text);
    bad("grammar.iterations", "99999999999999999999", ErrorCode::Invalid);
    for (const char* text : {"", "x", "1,5", "0.1.2", "1 m", "+-1", "0x10", "."})
        bad("turtle.alpha", text);
    bad("turtle.alpha", "1e999", ErrorCode::Invalid);
    for (const char* text : {"", "1", "1,2", "1,2,3,4", "1,2,", ",,", "1,2,x", "1;2;3"})
        bad("tree.scale", text);
    for (const char* text : {"", "2", "maybe", "TRUE!", "tru"})
        bad("grammar.stochastic", text);
}

void TestParamTable::badTextOfNumbers()
{
    QFETCH(QByteArray, key);
    QFETCH(QByteArray, text);
    QFETCH(int, code);
    const auto parsed = parseValue(row(key.constData()), text.toStdString());
    QVERIFY(!parsed);
    QCOMPARE(int(parsed.error().code), code);
    QCOMPARE(parsed.error().path, key.toStdString());
}

void TestParamTable::boolWords()
{
    const ParamDef& def = row("grammar.stochastic");
    for (const char* yes : {"true", "1", "yes", "on", " on ", "TRUE", "True", "1.0"})
        QVERIFY2(*parseValue(def, yes) == ParamValue(true), yes);
    for (const char* no : {"false", "0", "no", "off", "FALSE", "False", "0.0"})
        QVERIFY2(*parseValue(def, no) == ParamValue(false), no);
}

void TestParamTable::escapesInTexts()
{
    const ParamDef& def = row("grammar.rules");
    QVERIFY(*parseValue(def, "A -> \\\\B\\nC -> \\/\\", true) ==
            ParamValue(std::string("A -> \\B\nC -> \\/\\")));
    QVERIFY(*parseValue(def, "A -> \\\\B\\n") == ParamValue(std::string("A -> \\\\B\\n")));
}

void TestParamTable::checkParamsNamesTheKey()
{
    NodeParams params;
    params.turtle.alpha = notANumber;
    const auto checked = checkParams(params);
    QVERIFY(!checked);
    QCOMPARE(checked.error().path, std::string("turtle.alpha"));
}

void TestParamTable::checkParamsSeesSteps()
{
    NodeParams params;
    params.edits.push_back({.id = 7, .operation = EditOperation::Roll, .target = {.address = 5}});
    QVERIFY(checkParams(params));
    params.edits.front().angleRad = infinity;
    const auto checked = checkParams(params);
    QVERIFY(!checked);
    QCOMPARE(checked.error().path, std::string("edits[0].angle"));
}

void TestParamTable::seedsSayOfWhat()
{
    std::set<std::string_view> labels;
    for (const ParamDef& def : paramTable())
        if (def.flags & paramSeed) {
            QVERIFY2(std::string_view(def.label).starts_with("Seed of "), def.key);
            QVERIFY2(labels.insert(def.label).second, def.key);
        }
    QVERIFY(labels.size() >= 4);
}

void TestParamTable::kindsOfNodes()
{
    for (const ParamDef& def : paramTable()) {
        const auto inGroup = [&def](const char* group) {
            return std::string_view(def.key).starts_with(std::string(group) + ".");
        };
        const bool placement = inGroup("tree"), own = inGroup("local");
        const bool primitive = inGroup("primitive"), surface = inGroup("surface");
        const bool solid = inGroup("solid");
        const bool skin = inGroup("skin"), terrain = inGroup("terrain"), camera = inGroup("camera"),
                   scatter = inGroup("scatter");
        const bool picture = (def.flags & paramPicture) != 0;
        const bool arm = inGroup("arm") || inGroup("ik") || inGroup("armSkin");
        QCOMPARE(hasParam(NodeKind::Group, def), placement);
        QCOMPARE(hasParam(NodeKind::Tree, def),
                 !primitive && !surface && !solid && !arm && !terrain && !camera && !scatter);
        QCOMPARE(hasParam(NodeKind::Arm, def), placement || own || (surface && !picture) || skin || arm);
        QCOMPARE(hasParam(NodeKind::Terrain, def), placement || own || (surface && !picture) || terrain);
        QCOMPARE(hasParam(NodeKind::Primitive, def), solid || placement || own || primitive || surface);
        QCOMPARE(hasParam(NodeKind::Mesh, def), solid || placement || own || surface);
        QCOMPARE(hasParam(NodeKind::Camera, def), placement || camera);
        QCOMPARE(hasParam(NodeKind::Scatter, def), placement || scatter);
        QCOMPARE(def.stage == Stage::Placement,
                 placement || own || surface || solid || (picture && !scatter) || camera);
    }
}

RAMURE_SUITE(TestParamTable)

} // namespace tst_param_table

#include "tst_param_table.moc"
