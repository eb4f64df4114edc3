#include "core/generators/weber_penn/weber_penn.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/skeleton/axes.h"
#include "tests/support/suite.h"
#include <cmath>

namespace tst_weber_penn {

using namespace ramure;

namespace {

constexpr double pi = std::numbers::pi;

WeberPennParams published(const char* name)
{
    return presetParams(name)->weberPenn;
}

/// Without chance, splits and pruning: what is left is what the formulas say.
WeberPennParams plain(WeberPennParams params)
{
    params.scaleV = params.pruneRatio = params.clearance = 0.0;
    for (WeberPennLevel& level : params.level) {
        level.lengthV = level.splitAngleV = level.rotateV = level.segSplits = 0.0;
        level.curveV = std::min(level.curveV, 0.0);
        level.downAngleV = std::min(level.downAngleV, 0.0);
        level.baseSplits = 0;
    }
    return params;
}

/// The paper's table once more, of the four crowns that are measured here.
double crown(CrownShape shape, double r)
{
    switch (shape) {
    case CrownShape::Hemispherical:
        return 0.2 + 0.8 * std::sin(0.5 * pi * r);
    case CrownShape::TaperedCylindrical:
        return 0.5 + 0.5 * r;
    case CrownShape::TendFlame:
        return 0.5 + 0.5 * (r <= 0.7 ? r / 0.7 : (1.0 - r) / 0.3);
    default:
        return 1.0;
    }
}

/// Between two angles, the shorter way.
double apart(double a, double b)
{
    return std::abs(std::remainder(a - b, 2.0 * pi));
}

struct Errors
{
    double length = 0.0, radius = 0.0, downAngle = 0.0, azimuth = 0.0, spacing = 0.0;
};

} // namespace

class TestWeberPenn : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void errorsNameTheKey()
    {
        const auto refused = [](auto&& change, ErrorCode code, const char* path) {
            WeberPennParams params;
            change(params);
            const auto grown = growWeberPenn(params, 1);
            QVERIFY2(!grown, path);
            QCOMPARE(grown.error().code, code);
            QCOMPARE(grown.error().path, std::string(path));
        };
        refused([](WeberPennParams& p) { p.level[0].branches = 0; }, ErrorCode::Invalid,
                "weberPenn.level0.branches");
        refused([](WeberPennParams& p) { p.level[0].length = 0.0; }, ErrorCode::Invalid,
                "weberPenn.level0.length");
        refused(
            [](WeberPennParams& p) {
                p.levels = 4;
                p.level[1].branches = p.level[3].branches = 5000;
                p.level[2].branches = 10000;
            },
            ErrorCode::Limit, "weberPenn.level2.branches");
        refused(
            [](WeberPennParams& p) {
                p.level[1].segSplits = 4.0;
                p.level[1].curveRes = 64;
            },
            ErrorCode::Limit, "weberPenn.level1.branches");
    }

    void cancels()
    {
        std::stop_source source;
        source.request_stop();
        Progress progress;
        progress.stop = source.get_token();
        QCOMPARE(growWeberPenn({}, 1, progress).error().code, ErrorCode::Cancelled);
    }

    /// Thinner at the ground than above, and no thinner above than without the flare.
    void negativeFlaresNarrowTheFoot()
    {
        WeberPennParams params;
        params.levels = 1;
        params.lobes = 0;
        params.flare = 0.0;
        const auto plain = growWeberPenn(params, 1);
        params.flare = -0.8;
        const auto narrow = growWeberPenn(params, 1);
        QVERIFY(plain && narrow);
        const double wide = plain->a0.front();
        QVERIFY(narrow->a0.front() < 0.25 * wide && narrow->a0.front() > 0.15 * wide);
        double widest = 0.0;
        for (Index i = 0; i < Index(narrow->size()); ++i) {
            widest = std::max(widest, narrow->a1[i]);
            if (narrow->parent[i] != noIndex)
                QCOMPARE(narrow->a0[i], narrow->a1[narrow->parent[i]]); // no step
        }
        QVERIFY(widest > 0.8 * wide);
    }
    void negativeDownAnglesLeanToTheOtherSide()
    {
        WeberPennParams params;
        params.levels = 2;
        params.scaleV = 0.0;
        for (WeberPennLevel& level : params.level)
            level.curve = level.curveV = level.downAngleV = level.rotateV = 0.0;
        const auto there = growWeberPenn(params, 1);
        params.level[1].downAngle = -params.level[1].downAngle;
        const auto back = growWeberPenn(params, 1);
        QVERIFY(there && back);
        QCOMPARE(there->size(), back->size());
        for (Index i = 0; i < Index(there->size()); ++i) {
            const glm::dvec3 a = there->p1[i], b = back->p1[i];
            QVERIFY(std::abs(a.x + b.x) < 1e-9 && std::abs(a.y - b.y) < 1e-9 && std::abs(a.z + b.z) < 1e-9);
        }
    }

    void sameSeedSameTree()
    {
        const auto first = growWeberPenn({}, 5);
        QVERIFY2(first, test::why(first));
        QVERIFY(*first == *growWeberPenn({}, 5));
        QVERIFY(!(*first == *growWeberPenn({}, 6)));
    }

    void stemsAreAxes_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"QuakingAspen", "BlackTupelo", "WeepingWillow1995", "CaliforniaBlackOak"})
            QTest::newRow(name) << name;
    }
    /// The published numbers at zero variation, each axis against the formulas.
    void stemsAreAxes()
    {
        QFETCH(const QString, name);
        const WeberPennParams params = plain(published(qPrintable(name)));
        const auto skeleton = growWeberPenn(params, 1);
        QVERIFY2(skeleton, test::why(skeleton));
        const TreeAxes tree = axesOf(*skeleton);
        const Axis& trunk = tree.axes.front();
        QVERIFY(std::abs(trunk.length - params.scale * params.level[0].length) < 1e-9);
        QVERIFY(trunk.downAngle < 1e-9);
        std::vector<std::vector<Index>> children(tree.axes.size());
        for (Index i = 1; i < tree.axes.size(); ++i) {
            QCOMPARE(skeleton->level[tree.nodesOf(i).front()], tree.axes[i].order);
            children[tree.axes[i].parent].push_back(i);
        }
        Errors worst;
        // What a stem is as thick as by the formula, wherever the one that carries it is thinner.
        std::vector<double> radius(tree.axes.size(), trunk.length * params.ratio);
        for (Index i = 0; i < tree.axes.size(); ++i) {
            measure(params, tree, i, children[i], radius, worst);
            if (QTest::currentTestFailed())
                return;
        }
        const bool exact =
            std::max({worst.length, worst.downAngle, worst.azimuth, worst.spacing, worst.radius}) < 1e-7;
        const QString told =
            QStringLiteral("%1 stems; largest errors: length %2 m, spacing %3 m, radius %4 m, "
                           "down angle %5 rad, azimuth %6 rad")
                .arg(tree.axes.size())
                .arg(worst.length)
                .arg(worst.spacing)
                .arg(worst.radius)
                .arg(worst.downAngle)
                .arg(worst.azimuth);
        std::printf("%s: %s\n", qPrintable(name), qPrintable(told));
        QVERIFY2(exact, qPrintable(told));
    }

    /// The stems of a split share what the whole stem would carry.
    void splitsShareTheirStems()
    {
        WeberPennParams params = plain(published("CaliforniaBlackOak"));
        const auto limbs = [](const WeberPennParams& p) {
            const auto skeleton = growWeberPenn(p, 1);
            const TreeAxes tree = axesOf(*skeleton);
            return std::ranges::count_if(tree.axes, [&](const Axis& axis) {
                return axis.nodes > 0 && axis.parent != noIndex &&
                       skeleton->level[tree.nodes[axis.firstNode]] == 1;
            });
        };
        params.levels = 2;
        const auto whole = limbs(params);
        params.level[0].baseSplits = 2;
        params.level[0].segSplits = 0.4;
        QCOMPARE(limbs(params), whole);
        QCOMPARE(whole, params.level[1].branches);
    }

    void everySpeciesIsOneClosedBody_data()
    {
        QTest::addColumn<QString>("name");
        const auto all = presets();
        for (std::size_t i = 0; i < all.size(); i += test::isSanitized ? 8 : 1)
            if (all[i].params.generator.kind == EditOperation::WeberPenn)
                QTest::newRow(all[i].name) << all[i].name;
    }
    void everySpeciesIsOneClosedBody()
    {
        QFETCH(const QString, name);
        NodeParams params = *presetParams(name.toStdString());
        params.sections = {2, 4};
        TreePipeline pipeline;
        pipeline.setCacheSize(1);
        for (params.grammar.seed = 1; params.grammar.seed <= test::runs(20); ++params.grammar.seed) {
            const auto tree = pipeline.evaluate(params, Stage::Mesh);
            QVERIFY2(tree, test::why(tree));
            QVERIFY2(tree->report->valid, qPrintable(QString::number(params.grammar.seed)));
            QCOMPARE(tree->report->components, Index(1));
        }
    }

    void switchingKeepsWhatATreeWears()
    {
        NodeParams params = *presetParams("SmallTree");
        TreePipeline pipeline;
        const auto before = pipeline.evaluate(params, Stage::Skeleton);
        QVERIFY(setParam(params, *findParam("generator.kind"), EnumValue{"weber_penn"}));
        const auto other = pipeline.evaluate(params, Stage::Skeleton);
        QVERIFY(!(*other->skeleton == *before->skeleton));
        QVERIFY(other->symbols->empty());
        QVERIFY(setParam(params, *findParam("generator.kind"), EnumValue{"grammar"}));
        QVERIFY(params == *presetParams("SmallTree"));
        QVERIFY(*pipeline.evaluate(params, Stage::Skeleton)->skeleton == *before->skeleton);
    }

private:
    static void measure(const WeberPennParams& params, const TreeAxes& tree, Index carrier,
                        const std::vector<Index>& stems, std::vector<double>& radius, Errors& worst)
    {
        const Axis& parent = tree.axes[carrier];
        const std::size_t n = parent.order + 1;
        const double base = n == 1 ? params.baseSize * parent.length : 0.0;
        double wanted = n < std::size_t(params.levels) ? double(params.level[n].branches) : 0.0;
        if (n == 2)
            wanted *= 0.2 + 0.8 * (parent.length / tree.axes[parent.parent].length) / params.level[1].length;
        else if (n > 2)
            wanted *= 1.0 - 0.5 * parent.s / tree.axes[parent.parent].length;
        QCOMPARE(stems.size(), std::size_t(wanted + 0.5));
        for (std::size_t k = 0; k < stems.size(); ++k) {
            const Axis& stem = tree.axes[stems[k]];
            const WeberPennLevel& level = params.level[n];
            const double r = (parent.length - stem.s) / (parent.length - base);
            const double length = n == 1 ? parent.length * level.length * crown(params.shape, r)
                                         : level.length * (parent.length - 0.6 * stem.s);
            const double down =
                level.downAngle + std::min(level.downAngleV, 0.0) * (1.0 - 2.0 * (0.2 + 0.8 * r));
            radius[stems[k]] = radius[carrier] * std::pow(length / parent.length, params.ratioPower);
            worst.length = std::max(worst.length, std::abs(stem.length - length));
            worst.downAngle = std::max(worst.downAngle, std::abs(stem.downAngle - down));
            // Never above the radius of what carries it, there.
            if (stem.radius < radius[stems[k]] - 1e-9)
                radius[stems[k]] = stem.radius;
            worst.radius = std::max(worst.radius, std::abs(stem.radius - radius[stems[k]]));
            if (k + 1 < stems.size() && k > 0) {
                const double before = tree.axes[stems[k - 1]].s, after = tree.axes[stems[k + 1]].s;
                worst.spacing = std::max(worst.spacing, std::abs(before + after - 2.0 * stem.s));
            }
            const double first = tree.axes[stems[0]].azimuth, turned = stem.azimuth - first;
            const double expected = level.rotate >= 0.0 ? double(k) * level.rotate
                                    : k % 2 == 0        ? 0.0
                                                        : -2.0 * (pi + level.rotate);
            worst.azimuth = std::max(worst.azimuth, apart(turned, expected));
        }
    }
};

RAMURE_SUITE(TestWeberPenn)

} // namespace tst_weber_penn

#include "tst_weber_penn.moc"
