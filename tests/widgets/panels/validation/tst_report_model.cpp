#include "core/math/random.h"
#include "tests/support/suite.h"
#include "widgets/base/texts/branch_names.h"
#include "widgets/panels/validation/kind_texts.h"
#include "widgets/panels/validation/report_model.h"
#include "widgets/panels/validation/report_text.h"
#include <QAbstractItemModelTester>
#include <QSignalSpy>

namespace tst_report_model {

using namespace ramure;

namespace {

void count(MeshReport& report, DefectKind kind, Index n)
{
    Index* const counts[] = {&report.boundaryEdges,       &report.nonManifoldEdges,
                             &report.nonManifoldVertices, &report.inconsistentEdges,
                             &report.duplicateVertices,   &report.duplicateFaces,
                             &report.degenerateFaces,     &report.isolatedVertices};
    *counts[static_cast<int>(kind)] += n;
}

/// Random defects and notes, in mixed order, as a mesh of nothing would never have.
ReportSource randomSource(Random& random, int defects, int notes)
{
    auto report = std::make_shared<MeshReport>();
    for (int i = 0; i < defects; ++i) {
        const auto kind = static_cast<DefectKind>(random.below(defectKindCount));
        report->defects.push_back({kind, random.below(1000), random.below(1000)});
        count(*report, kind, 1);
    }
    auto branches = std::make_shared<BranchMesh>();
    for (int i = 0; i < notes; ++i)
        branches->repairs.push_back({static_cast<SkeletonRepair>(random.below(repairKindCount)),
                                     random.below(50), random.below(2) == 0 ? noIndex : random.below(50)});
    return {.report = report, .branches = branches};
}

/// The rows that there must be, made the simple way.
QStringList expectedRows(const ReportSource& source)
{
    QStringList rows;
    for (int k = 0; k < defectKindCount; ++k)
        for (const Defect& defect : source.report->defects)
            if (defect.kind == static_cast<DefectKind>(k))
                rows += defectName(defect);
    for (int k = 0; k < repairKindCount; ++k)
        for (const RepairNote& note : source.branches->repairs)
            if (note.kind == static_cast<SkeletonRepair>(k))
                rows += repairName(note);
    return rows;
}

QStringList shownRows(ReportModel& model)
{
    QStringList rows;
    for (int kind = 0; kind < model.rowCount(); ++kind) {
        const QModelIndex top = model.index(kind, 0);
        while (model.canFetchMore(top))
            model.fetchMore(top);
        for (int row = 0; row < model.rowCount(top); ++row)
            rows += model.index(row, 0, top).data().toString();
    }
    return rows;
}

} // namespace

class TestReportModel : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void nearVerticesAreALineOfTheirOwn();

    void emptySourcesAreEmptyModels();
    void keepsTheRulesAndTheOrder();
    void rowsComeWhenAskedFor();
    void listsOnlySoMany();
    void aSecondOpinionKeepsTheRows();
    void tooltipsCallBranchesByName();
};

void TestReportModel::emptySourcesAreEmptyModels()
{
    ReportModel model;
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    QCOMPARE(model.rowCount(), 0);
    model.setSource({std::make_shared<MeshReport>(), nullptr});
    QCOMPARE(model.rowCount(), 0);
    model.setSource({nullptr, std::make_shared<BranchMesh>()});
    QCOMPARE(model.rowCount(), 0);
    QVERIFY(!model.kindIndex(DefectKind::BoundaryEdge).isValid());
    QVERIFY(!model.defect({}) && !model.repair({}));
}

void TestReportModel::keepsTheRulesAndTheOrder()
{
    ReportModel model;
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    tester.setUseFetchMore(false); // the tester would fetch in the middle of a reset; the test does it after
    Random random(1, RandomStream::Test);
    for (int i = 0; i < 60; ++i) {
        const ReportSource source =
            randomSource(random, static_cast<int>(random.below(40)), static_cast<int>(random.below(20)));
        model.setSource(source);
        QCOMPARE(shownRows(model), expectedRows(source));
        for (int kind = 0; kind < model.rowCount(); ++kind) {
            const QModelIndex top = model.index(kind, 0);
            QCOMPARE(model.kindIndex(model.kind(top)), top);
            QVERIFY(!model.defect(top) && !model.repair(top));
            for (int row = 0; row < model.rowCount(top); ++row) {
                const QModelIndex index = model.index(row, 1, top);
                QVERIFY((model.defect(index) == nullptr) != (model.repair(index) == nullptr));
                QVERIFY(model.kind(index) == model.kind(top));
            }
        }
    }
}

void TestReportModel::rowsComeWhenAskedFor()
{
    ReportModel model;
    Random random(2, RandomStream::Test);
    model.setSource(randomSource(random, 500, 100));
    QSignalSpy inserted(&model, &QAbstractItemModel::rowsInserted);
    for (int kind = 0; kind < model.rowCount(); ++kind) {
        const QModelIndex top = model.index(kind, 0);
        QVERIFY(model.hasChildren(top));
        QCOMPARE(model.rowCount(top), 0);
        QVERIFY(model.canFetchMore(top));
        model.fetchMore(top);
        QVERIFY(!model.canFetchMore(top));
        QCOMPARE(inserted.count(), kind + 1);
        QVERIFY(!model.hasChildren(model.index(0, 0, top)));
    }
}

void TestReportModel::listsOnlySoMany()
{
    auto report = std::make_shared<MeshReport>();
    for (Index i = 0; i < ReportModel::mostRows; ++i)
        report->defects.push_back({DefectKind::BoundaryEdge, i, i + 1});
    report->boundaryEdges = 2'500'000;
    auto branches = std::make_shared<BranchMesh>();
    branches->repairs.assign(30'000, {SkeletonRepair::RadiusClamped, 1, noIndex});
    ReportModel model;
    model.setSource({report, branches});
    for (int kind = 0; kind < 2; ++kind) {
        const QModelIndex top = model.index(kind, 0);
        model.fetchMore(top);
        QCOMPARE(model.rowCount(top), static_cast<int>(ReportModel::mostRows));
        QVERIFY(top.data().toString().contains(QLocale().toString(ReportModel::mostRows)));
    }
    QVERIFY(model.index(0, 0).data().toString().contains(QLocale().toString(2'500'000)));
    QVERIFY(model.index(1, 0).data().toString().contains(QLocale().toString(30'000)));
}

void TestReportModel::aSecondOpinionKeepsTheRows()
{
    ReportModel model;
    Random random(3, RandomStream::Test);
    ReportSource source = randomSource(random, 20, 5);
    model.setSource(source);
    QSignalSpy reset(&model, &QAbstractItemModel::modelReset);
    auto confirmed = std::make_shared<MeshReport>(*source.report);
    confirmed->openMeshChecked = true;
    model.setSource({confirmed, source.branches});
    QCOMPARE(reset.count(), 0);
    QCOMPARE(model.source().report.get(), confirmed.get());
    auto other = std::make_shared<MeshReport>(*source.report);
    other->defects.push_back({DefectKind::DegenerateFace, 1, noIndex});
    ++other->degenerateFaces;
    model.setSource({other, source.branches});
    QCOMPARE(reset.count(), 1);
    model.setSource({other, std::make_shared<BranchMesh>()}); // another mesh
    QCOMPARE(reset.count(), 2);
}

void TestReportModel::tooltipsCallBranchesByName()
{
    auto branches = std::make_shared<BranchMesh>();
    branches->repairs = {{SkeletonRepair::RadiusClamped, 1, noIndex},
                         {SkeletonRepair::RadiusClamped, 7, noIndex}};
    auto simplified = std::make_shared<SimplifiedSkeleton>();
    Skeleton& skeleton = simplified->skeleton;
    skeleton.add(noIndex, {0, 0, 0}, {0, 1, 0}, 0.1, 0.1);
    skeleton.add(0, {0, 1, 0}, {1, 2, 0}, 0.1, 0.1, 1);
    ReportModel model;
    TreeResult tree;
    tree.skeleton = std::make_shared<const Skeleton>(skeleton);
    tree.simplified = simplified;
    model.setSource({std::make_shared<MeshReport>(), branches, tree});
    QCOMPARE(shownRows(model).size(), qsizetype{2});
    const QModelIndex top = model.index(0, 0);
    const QString meaning = top.data(Qt::ToolTipRole).toString();
    const BranchRows rows(tree);
    QCOMPARE(model.index(0, 0, top).data(Qt::ToolTipRole).toString(),
             BranchNames().branch(rows, 1) + QStringLiteral("\n\n") + meaning);
    QCOMPARE(model.index(1, 0, top).data(Qt::ToolTipRole).toString(), meaning); // no such branch
}

void TestReportModel::nearVerticesAreALineOfTheirOwn()
{
    MeshQuality quality;
    for (const auto& [pairs, number] : {std::pair(0U, "0"), std::pair(1U, "1"), std::pair(71U, "71")}) {
        quality.nearPairs = pairs;
        const QStringList lines = ReportTexts::quality(quality).split(QLatin1Char('\n'));
        QCOMPARE(lines.size(), 2);
        QVERIFY2(lines[1].startsWith(QLatin1String(number) + QLatin1Char(' ')), qPrintable(lines[1]));
        QVERIFY2(lines[1].contains(QStringLiteral("0.1\u00a0mm")), qPrintable(lines[1]));
    }
}

RAMURE_SUITE(TestReportModel)

} // namespace tst_report_model

#include "tst_report_model.moc"
