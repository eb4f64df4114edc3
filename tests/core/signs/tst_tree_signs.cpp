#include "core/signs/tree_signs.h"

#include "core/pipeline/tree_pipeline.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace tst_tree_signs {

using namespace ramure;

namespace {

const Preset& presetNamed(std::string_view name)
{
    return *std::ranges::find(presets(), name, &Preset::name);
}

std::vector<TreeSign> signsOf(const NodeParams& params, const Preset* species = nullptr)
{
    const auto signs = treeSigns(params, species);
    return signs ? *signs : std::vector<TreeSign>();
}

TreeSign signNamed(const std::vector<TreeSign>& signs, std::string_view key)
{
    const auto found = std::ranges::find(signs, key, &TreeSign::key);
    return found == signs.end() ? TreeSign() : *found;
}

} // namespace

/// Signs are what they are by their definitions, and on two species as unlike as can be in what is published.
class TestTreeSigns : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void wrongTreesAreErrors()
    {
        NodeParams params = presetNamed("EnglishOak").params;
        params.growth.age = -1.0;
        const auto signs = treeSigns(params, nullptr);
        QVERIFY(!signs && signs.error().path == "growth.age");
        std::stop_source stop;
        stop.request_stop();
        const auto stopped = treeSigns(presetNamed("EnglishOak").params, nullptr, {stop.get_token(), {}});
        QVERIFY(!stopped && stopped.error().code == ErrorCode::Cancelled);
    }

    void everySignHasANameOfItsOwn()
    {
        const auto signs = signsOf(presetNamed("SmallTree").params);
        QVERIFY(signs.size() >= 12);
        std::set<std::string> keys, labels;
        for (const TreeSign& sign : signs) {
            keys.insert(sign.key);
            labels.insert(sign.label);
            QVERIFY(sign.low <= sign.high && std::isfinite(sign.value));
            const bool isIn = sign.value >= sign.low && sign.value <= sign.high;
            QVERIFY(sign.state != SignState::Inside || isIn);
            QVERIFY(sign.state != SignState::Outside || !isIn);
        }
        QCOMPARE(keys.size(), signs.size());
        QCOMPARE(labels.size(), signs.size());
        std::set<std::string> names;
        for (int state = 0; state <= int(SignState::Outside); ++state)
            names.insert(nameOf(SignState(state)));
        QCOMPARE(names.size(), std::size_t(5));
    }

    /// The foliage of a species has its signs; what wears no leaves of a plant has none.
    void leavesHaveSigns()
    {
        NodeParams oak = presetNamed("EnglishOak").params;
        oak.growth.age = 25.0;
        const auto signs = signsOf(oak);
        for (const char* key : {"leafNormals", "leafLightness", "leafHue", "crownGaps"})
            QVERIFY2(signNamed(signs, key).state == SignState::Inside,
                     qPrintable(QString("%1 %2").arg(key).arg(signNamed(signs, key).value)));
        oak.foliage.leavesCutoff = 0.0;
        for (const char* key : {"leafNormals", "leafLightness", "leafHue", "crownGaps"})
            QCOMPARE(signNamed(signsOf(oak), key).state, SignState::Absent);
    }

    /// What the program does not make is not measured.
    void nothingIsFaked()
    {
        const auto drawn = signsOf(presetNamed("SmallTree").params);
        for (const char* key :
             {"lightResponse", "leanRecovery", "epicormic", "deadTwigs", "scars", "buttresses"})
            QCOMPARE(signNamed(drawn, key).state, SignState::NotModelled);
        QCOMPARE(signNamed(drawn, "slenderness").state, SignState::Absent);
        QCOMPARE(signNamed(drawn, "rootFlare").state, SignState::Absent);
        NodeParams seedling = presetNamed("EnglishOak").params;
        seedling.growth.age = 1.0;
        const auto young = signsOf(seedling, &presetNamed("EnglishOak"));
        QCOMPARE(signNamed(young, "branchCollar").state, SignState::Absent);
        QCOMPARE(signNamed(young, "hortonRatio").state, SignState::Absent);
        QCOMPARE(signNamed(young, "epicormic").state, SignState::Absent);
    }

    void speciesAreInTheirBands_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("oak") << QStringLiteral("EnglishOak");
        QTest::newRow("spruce") << QStringLiteral("NorwaySpruce");
    }
    void speciesAreInTheirBands()
    {
        QFETCH(const QString, name);
        const Preset& species = presetNamed(name.toStdString());
        const auto signs = signsOf(species.params, &species);
        for (const char* key : {"branchCollar", "twins", "rootFlare", "rootLobes", "hortonRatio",
                                "slenderness", "sag", "balance", "lightResponse", "leanRecovery"}) {
            const TreeSign sign = signNamed(signs, key);
            QVERIFY2(sign.state == SignState::Inside,
                     qPrintable(QStringLiteral("%1: %2 %3").arg(key, nameOf(sign.state)).arg(sign.value)));
        }
    }

    /// They follow what they measure.
    void signsSeeWhatChanges()
    {
        const Preset& species = presetNamed("EnglishOak");
        NodeParams params = species.params;
        params.growth.age = 30.0;
        const auto usual = signsOf(params, &species);
        NodeParams changed = params;
        changed.mesh.collar = 0.0;
        changed.mesh.rootLength = 2.0;
        changed.growth.light = changed.growth.reaction = 0.0;
        changed.growth.upright = 0.0;
        const auto other = signsOf(changed, &species);
        QVERIFY(signNamed(other, "branchCollar").value < signNamed(usual, "branchCollar").value);
        QVERIFY(signNamed(other, "rootFlare").value > signNamed(usual, "rootFlare").value);
        QVERIFY(signNamed(other, "leanRecovery").value >= signNamed(usual, "leanRecovery").value);
        // The site that it stands on changes nothing in how it answers to another.
        NodeParams windy = params;
        windy.growth.wind = 9.0;
        windy.growth.slope = 0.4;
        const auto blown = signsOf(windy, &species);
        QCOMPARE(signNamed(blown, "lightResponse").value, signNamed(usual, "lightResponse").value);
        QVERIFY(signNamed(blown, "rootFlare").state != SignState::Absent);
    }
};

RAMURE_SUITE(TestTreeSigns)

} // namespace tst_tree_signs

#include "tst_tree_signs.moc"
