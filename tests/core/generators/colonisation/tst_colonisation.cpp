#include "core/generators/colonisation/colonisation.h"
#include "core/generators/colonisation/colonised_nodes.h"
#include "core/generators/colonisation/crown_shape.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "tests/support/suite.h"
#include <cmath>

namespace tst_colonisation {

using namespace ramure;

namespace {

ColonisationParams small()
{
    ColonisationParams params;
    params.points = 250;
    return params;
}

/// The paper's algorithm once more, every node against every point.
ColonisedNodes slowly(const ColonisationParams& params, const std::vector<glm::dvec3>& points)
{
    ColonisedNodes nodes{{glm::dvec3(0.0)}, {noIndex}};
    std::vector<bool> gone(points.size(), false);
    const auto nearest = [&](const glm::dvec3& point, double& distance) {
        Index best = noIndex;
        distance = params.influence;
        for (Index i = 0; i < nodes.at.size(); ++i)
            if (const double d = glm::length(point - nodes.at[i]);
                d < distance || (best == noIndex && d <= distance)) {
                best = i;
                distance = d;
            }
        return best;
    };
    double distance = 0.0;
    while (std::ranges::none_of(
        points, [&](const glm::dvec3& point) { return nearest(point, distance) != noIndex; })) {
        nodes.at.push_back(nodes.at.back() + glm::dvec3(0.0, params.step, 0.0));
        nodes.parent.push_back(Index(nodes.parent.size() - 1));
    }
    std::vector<bool> stuck;
    while (true) {
        stuck.resize(nodes.at.size(), false);
        std::vector<glm::dvec3> pull(nodes.at.size(), glm::dvec3(0.0));
        bool any = false;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (gone[i])
                continue;
            const Index node = nearest(points[i], distance);
            if (node == noIndex)
                continue;
            if (distance < params.kill || stuck[node]) {
                gone[i] = true;
                continue;
            }
            pull[node] += (points[i] - nodes.at[node]) / distance;
            any = true;
        }
        if (!any)
            return nodes;
        for (Index i = 0; i < pull.size(); ++i) {
            if (pull[i] == glm::dvec3(0.0))
                continue;
            const glm::dvec3 to =
                nodes.at[i] + params.step * glm::normalize(glm::normalize(pull[i]) + params.tropism);
            bool taken = to.y <= 0.0;
            for (Index k = 0; k < nodes.at.size(); ++k)
                taken = taken || (nodes.parent[k] == i && glm::length(nodes.at[k] - to) < 0.25 * params.step);
            if (taken) {
                stuck[i] = true;
                continue;
            }
            nodes.at.push_back(to);
            nodes.parent.push_back(i);
        }
    }
}

struct Less
{
    bool operator()(const glm::dvec3& a, const glm::dvec3& b) const
    {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    }
};

} // namespace

class TestColonisation : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void wrongProfilesNameTheirPlace_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("column");
        QTest::addColumn<int>("code");
        const auto row = [](const char* text, int column, ErrorCode code) {
            QTest::newRow(text) << text << column << int(code);
        };
        row("", 1, ErrorCode::Syntax);
        row("0 1", 4, ErrorCode::Invalid);
        row("0 1, 0 0.5", 6, ErrorCode::Invalid);
        row("0 1, 0.5", 9, ErrorCode::Syntax);
        row("0 1; 1 0", 4, ErrorCode::Syntax);
        row("0 1, x 0", 6, ErrorCode::Syntax);
        row("0 1, 1 -1", 8, ErrorCode::Syntax);
        row("0 1.5, 1 1", 3, ErrorCode::Invalid);
        row("0 0, 1 0", 9, ErrorCode::Invalid);
    }
    void wrongProfilesNameTheirPlace()
    {
        QFETCH(const QString, text);
        QFETCH(const int, column);
        QFETCH(const int, code);
        ColonisationParams params = small();
        params.envelope = CrownEnvelope::Profile;
        params.profile = text.toStdString();
        const auto grown = growColonisation(params, 1);
        QVERIFY(!grown);
        QCOMPARE(int(grown.error().code), code);
        QCOMPARE(grown.error().path, std::string("colonisation.profile"));
        QCOMPARE(grown.error().column, column);
        // Nobody asks a profile of the other envelopes.
        params.envelope = CrownEnvelope::Cone;
        QVERIFY(growColonisation(params, 1));
    }

    void tooManyPairs()
    {
        std::string text;
        for (int i = 0; i < 65; ++i)
            text.append(i > 0 ? "," : "").append(std::to_string(i / 100.0)).append(" 1");
        QCOMPARE(parseProfile(text).error().code, ErrorCode::Limit);
    }

    void crownsOutOfSightAreRefused()
    {
        ColonisationParams params = small();
        params.envelope = CrownEnvelope::Cylinder;
        params.surface = 1.0;
        params.influence = 0.2;
        const auto grown = growColonisation(params, 1);
        QVERIFY(!grown);
        QCOMPARE(grown.error().code, ErrorCode::Invalid);
        QCOMPARE(grown.error().path, std::string("colonisation.influence"));
    }

    void cancels()
    {
        std::stop_source source;
        source.request_stop();
        Progress progress;
        progress.stop = source.get_token();
        QCOMPARE(growColonisation({}, 1, progress).error().code, ErrorCode::Cancelled);
    }

    void sameSeedSameTree()
    {
        const auto first = growColonisation({}, 5);
        QVERIFY2(first, test::why(first));
        QVERIFY(*first == *growColonisation({}, 5));
        QVERIFY(!(*first == *growColonisation({}, 6)));
    }

    /// A curve goes through its pairs and never beyond them.
    void profilesKeepBetweenTheirPairs()
    {
        ColonisationParams params;
        params.envelope = CrownEnvelope::Profile;
        params.profile = "0.1 0.2, 0.3 1, 0.35 0.1, 0.8 0.1, 1 0";
        const auto outline = CrownOutline::of(params);
        QVERIFY2(outline, test::why(outline));
        const auto pairs = *parseProfile(params.profile);
        for (std::size_t i = 0; i + 1 < pairs.size(); ++i) {
            QCOMPARE(outline->radiusAt(pairs[i].x), pairs[i].y);
            const auto [low, high] = std::minmax(pairs[i].y, pairs[i + 1].y);
            for (int k = 1; k < 50; ++k) {
                const double r = outline->radiusAt(std::lerp(pairs[i].x, pairs[i + 1].x, k / 50.0));
                QVERIFY2(r >= low - 1e-12 && r <= high + 1e-12, qPrintable(QString::number(r)));
            }
        }
        QCOMPARE(outline->radiusAt(0.05), 0.0);
        QCOMPARE(outline->radiusAt(1.05), 0.0);
    }

    void pointsFillTheirEnvelope_data()
    {
        QTest::addColumn<int>("envelope");
        QTest::addColumn<double>("height"); ///< of the centre, as a share, with surface 0
        QTest::newRow("sphere") << int(CrownEnvelope::Sphere) << 0.5;
        QTest::newRow("hemisphere") << int(CrownEnvelope::Hemisphere) << 0.375;
        QTest::newRow("cone") << int(CrownEnvelope::Cone) << 0.25;
        QTest::newRow("cylinder") << int(CrownEnvelope::Cylinder) << 0.5;
    }
    void pointsFillTheirEnvelope()
    {
        QFETCH(const int, envelope);
        QFETCH(const double, height);
        ColonisationParams params;
        params.envelope = static_cast<CrownEnvelope>(envelope);
        params.points = 20000;
        for (const double surface : {0.0, 1.0}) {
            params.surface = surface;
            const auto outline = CrownOutline::of(params);
            double sum = 0.0;
            const auto points = crownPoints(params, 1);
            for (const glm::dvec3& p : *points) {
                const double share = (p.y - params.crownBase) / params.crownHeight;
                const double wall = params.crownRadius * outline->radiusAt(share);
                const double aside = std::hypot(p.x, p.z);
                QVERIFY(aside <= wall + 1e-9);
                QVERIFY(surface == 0.0 || aside >= wall - 1e-9);
                sum += share;
            }
            QVERIFY(std::abs(sum / double(params.points) - height) < 0.01);
        }
    }

    void growsAsThePaperSays_data()
    {
        QTest::addColumn<int>("seed");
        for (int seed = 1; seed <= 6; ++seed)
            QTest::addRow("%d", seed) << seed;
    }
    /// The same nodes as by comparing all with all. Chains of sums differ in their last digits only.
    void growsAsThePaperSays()
    {
        QFETCH(const int, seed);
        ColonisationParams params = small();
        params.influence = seed % 2 == 0 ? 0.9 : 2.0;
        const auto points = crownPoints(params, std::uint64_t(seed));
        const auto fast = colonise(params, *points, {});
        QVERIFY2(fast, test::why(fast));
        ColonisedNodes slow = slowly(params, *points);
        QCOMPARE(fast->at.size(), slow.at.size());
        auto nodes = fast->at;
        std::ranges::sort(nodes, Less());
        std::ranges::sort(slow.at, Less());
        double worst = 0.0;
        for (std::size_t i = 0; i < nodes.size(); ++i)
            worst = std::max(worst, glm::length(nodes[i] - slow.at[i]));
        QVERIFY2(worst < 1e-9, qPrintable(QString::number(worst)));
    }

    void pointsAreReached()
    {
        const ColonisationParams params;
        const auto points = crownPoints(params, 3);
        const auto nodes = colonise(params, *points, {});
        const auto reached = std::ranges::count_if(*points, [&](const glm::dvec3& point) {
            return std::ranges::any_of(
                nodes->at, [&](const glm::dvec3& node) { return glm::length(point - node) <= params.kill; });
        });
        QVERIFY2(reached >= params.points * 97 / 100, qPrintable(QString::number(reached)));
    }

    void branchesStayAboveGroundAndThin()
    {
        ColonisationParams params;
        params.crownBase = 0.0;
        params.tropism = {0.0, -0.8, 0.0};
        const auto tree = growColonisation(params, 2);
        QVERIFY2(tree, test::why(tree));
        for (Index i = 0; i < tree->size(); ++i) {
            QVERIFY(tree->p1[i].y > 0.0);
            QVERIFY(tree->a1[i] <= tree->a0[i] && tree->a1[i] > 0.0);
            if (tree->parent[i] == noIndex)
                continue;
            const Index parent = tree->parent[i];
            QVERIFY(tree->p0[i] == tree->p1[parent]);
            QVERIFY(tree->a0[i] <= tree->a1[parent]);
            QVERIFY(tree->level[i] == tree->level[parent] || tree->level[i] == tree->level[parent] + 1);
        }
        auto keys = tree->key;
        std::ranges::sort(keys);
        QVERIFY(std::ranges::adjacent_find(keys) == keys.end());
    }

    void thinningLeavesShortTwigsOut()
    {
        ColonisationParams params;
        const auto size = [&](double thinning) {
            params.thinning = thinning;
            return growColonisation(params, 1)->size();
        };
        const Index all = size(0.0), some = size(0.5), few = size(2.0);
        QVERIFY(all > some && some > few);
    }

    void everyEnvelopeIsOneClosedBody_data()
    {
        QTest::addColumn<int>("envelope");
        for (const auto envelope : {CrownEnvelope::Sphere, CrownEnvelope::Hemisphere, CrownEnvelope::Cone,
                                    CrownEnvelope::Cylinder, CrownEnvelope::Profile})
            QTest::addRow("%d", int(envelope)) << int(envelope);
    }
    void everyEnvelopeIsOneClosedBody()
    {
        QFETCH(const int, envelope);
        NodeParams params;
        params.generator.kind = EditOperation::Colonisation;
        params.colonisation.envelope = static_cast<CrownEnvelope>(envelope);
        params.sections = {2, 5};
        TreePipeline pipeline;
        for (params.grammar.seed = 1; params.grammar.seed <= 4; ++params.grammar.seed) {
            const auto tree = pipeline.evaluate(params, Stage::Mesh);
            QVERIFY2(tree, test::why(tree));
            QVERIFY2(tree->report->valid, qPrintable(QString::number(params.grammar.seed)));
            QCOMPARE(tree->report->components, Index(1));
        }
    }
};

RAMURE_SUITE(TestColonisation)

} // namespace tst_colonisation

#include "tst_colonisation.moc"
