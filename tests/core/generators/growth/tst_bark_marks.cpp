#include "core/generators/growth/grown_skeleton.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace tst_bark_marks {

using namespace ramure;

namespace {

NodeParams treeOf(const char* name, double age)
{
    NodeParams params = presetParams(name).value();
    params.growth.age = age;
    params.growth.scars = params.growth.hollows = params.growth.burrs = 0.0;
    return params;
}

Skeleton grown(const GrowthParams& params, std::uint64_t seed = 1)
{
    const auto history = growHistory(params, seed);
    return history ? skeletonAtAge(*history, params.age) : Skeleton();
}

Index count(const Skeleton& tree, OrganKind kind)
{
    return Index(std::ranges::count(tree.organs, kind, &Organ::kind));
}

} // namespace

/// What shed limbs leave in the bark.
class TestBarkMarks : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void wrongNumbersAreErrors()
    {
        for (double GrowthParams::*member :
             {&GrowthParams::scars, &GrowthParams::hollows, &GrowthParams::burrs})
            for (const double wrong : {-1.0, 1e9, std::numeric_limits<double>::quiet_NaN()}) {
                GrowthParams params = treeOf("EnglishOak", 20.0).growth;
                params.scars = 1.0; // without, hollows do not matter
                params.*member = wrong;
                QVERIFY(!growHistory(params, 1));
            }
    }

    void withoutThemTheTreeIsTheSame()
    {
        GrowthParams params = treeOf("EnglishOak", 50.0).growth;
        const Skeleton plain = grown(params);
        QVERIFY(plain.organs.empty());
        params.scars = params.hollows = 1.0;
        params.burrs = 2.0;
        Skeleton marked = grown(params);
        QVERIFY(grown(params) == marked);
        QVERIFY(count(marked, OrganKind::Scar) > 0 && count(marked, OrganKind::Burr) > 0);
        for (const Organ& mark : marked.organs) {
            QVERIFY(isMark(mark.kind) && mark.share >= 0.0 && mark.share <= 1.0 && mark.size > 0.0);
            QVERIFY(mark.size <= 0.55 * std::max(marked.a0[mark.branch], marked.a1[mark.branch]));
            QVERIFY(std::abs(glm::length(mark.heading) - 1.0) < 1e-9);
            QVERIFY(std::abs(glm::dot(mark.heading, mark.axis)) < 1e-9);
        }
        marked.organs.clear();
        QVERIFY(marked == plain);
    }

    /// The same limb's scar is at the next age where it was, and has healed further.
    void scarsHeal()
    {
        GrowthParams params = treeOf("ScotsPine", 60.0).growth;
        params.scars = 1.0;
        const auto history = growHistory(params, 1);
        QVERIFY(history);
        const auto scarsAt = [&](double age) {
            const Skeleton tree = skeletonAtAge(*history, age);
            std::map<std::array<double, 3>, Organ> out; // by where they look and the limb's radius
            for (const Organ& organ : tree.organs)
                out.emplace(std::array{organ.size, 0.0, 0.0}, organ);
            return out;
        };
        const auto before = scarsAt(50.0), after = scarsAt(56.0);
        int same = 0;
        for (const auto& [key, scar] : before)
            if (const auto found = after.find(key); found != after.end()) {
                ++same;
                QVERIFY(found->second.healed >= scar.healed);
            }
        QVERIFY2(same > 5, qPrintable(QString::number(same)));
    }

    void meshesStayClosed_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"EnglishOak", "ScotsPine", "EuropeanBeech", "SilverBirch", "LondonPlane"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    void meshesStayClosed()
    {
        QFETCH(const QString, name);
        NodeParams params = treeOf(name.toLatin1().constData(), 50.0);
        TreePipeline pipeline;
        const auto plain = pipeline.evaluate(params, Stage::Mesh);
        QVERIFY(plain);
        params.growth.scars = 1.0;
        params.growth.hollows = 0.5;
        params.growth.burrs = 1.0;
        const auto marked = pipeline.evaluate(params, Stage::Mesh);
        QVERIFY2(marked, test::why(marked).constData());
        QVERIFY(marked->report->valid);
        QCOMPARE(marked->report->components, plain->report->components);
        qInfo("%s: %u scars, %u hollows, %u burrs", qPrintable(name),
              count(*marked->skeleton, OrganKind::Scar), count(*marked->skeleton, OrganKind::Hollow),
              count(*marked->skeleton, OrganKind::Burr));
        QVERIFY(marked->branches->mesh.positions != plain->branches->mesh.positions);
        // They are paid out of the budget, and texture coordinates find their way around them.
        const auto budget = double(params.mesh.targetTriangles);
        const auto faces = double(marked->branches->mesh.triangles.size());
        QVERIFY2(std::abs(faces - budget) < 0.06 * budget, qPrintable(QString::number(faces)));
        const auto uv = marked->texture->coordinates(params.texture);
        QVERIFY2(uv, test::why(uv).constData());
    }
};

RAMURE_SUITE(TestBarkMarks)

} // namespace tst_bark_marks

#include "tst_bark_marks.moc"
