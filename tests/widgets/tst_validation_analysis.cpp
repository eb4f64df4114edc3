#include "core/qt/session/jobs/analysis.h"
#include "core/qt/session/jobs/recompute.h"
#include "tests/support/suite.h"
#include "tests/support/waits.h"
#include "tests/widgets/tree_document.h"
#include "widgets/dialogs/export/mesh_faults.h"
#include "widgets/panels/validation/histogram_view.h"
#include "widgets/panels/validation/kind_texts.h"
#include "widgets/panels/validation/report_text.h"
#include "widgets/panels/validation/report_view.h"
#include "widgets/panels/validation/status_badge.h"
#include "widgets/panels/validation/validation_panel.h"
#include "widgets/window/status_panel.h"
#include <QClipboard>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QThread>
#include <QToolButton>
#include <atomic>

namespace tst_validation_analysis {

using namespace ramure;

/// What the panel shows of the long analysis.
class TestValidationAnalysis : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void theAnalysisTellsHowFarItIs();
    void findingsAreListedAndShown();
    void theVerdictIsOneEverywhere();
    void whatIsSelectedIsShown();
    void defectsOfObjectsAreListed();
    void largeNumbersAreGrouped();
};

void TestValidationAnalysis::theAnalysisTellsHowFarItIs()
{
    test::TreeDocument trees;
    const NodeId tree = trees.add(test::smallForks(), "Oak");
    std::atomic<bool> slow{true};
    Analysis analysis(
        &trees.document(),
        [&](const BranchMesh&, const Skeleton&, const Progress& progress) -> Expected<MeshAnalysis> {
            for (int i = 0; slow && !progress.cancelled(); ++i) {
                progress.report(0.5);
                test::work(1);
            }
            if (progress.cancelled())
                return fail(ErrorCode::Cancelled, "cancelled");
            return MeshAnalysis{};
        });
    analysis.setRest(0);
    ValidationPanel panel(&trees.document(), &analysis);
    panel.resize(340, 500);
    panel.show();
    const auto visible = [&](const char* name) {
        return panel.findChild<QWidget*>(QLatin1String(name))->isVisible();
    };
    analysis.start(tree);
    QVERIFY(visible("analysisProgress") && visible("cancelAnalysis") && !visible("startAnalysis"));
    QTRY_COMPARE(panel.findChild<QProgressBar*>(QStringLiteral("analysisProgress"))->value(), 500);
    panel.findChild<QToolButton*>(QStringLiteral("cancelAnalysis"))->click();
    QCOMPARE(analysis.state(tree), Analysis::State::Cancelled);
    QVERIFY(!visible("analysisProgress") && visible("startAnalysis") && !visible("hashText"));
    slow = false;
    panel.findChild<QPushButton*>(QStringLiteral("startAnalysis"))->click();
    QVERIFY(analysis.waitForAll(10'000));
    QVERIFY(!visible("analysisProgress") && !visible("startAnalysis") && visible("hashText"));
    QVERIFY(!visible("separateCollisions"));
    QVERIFY(edit::removeNodes(trees.document(), {tree}));
    QVERIFY(!visible("analysisText"));
}

void TestValidationAnalysis::findingsAreListedAndShown()
{
    test::TreeDocument trees;
    const NodeId tree = trees.add(test::smallForks(), "Oak");
    Analysis analysis(&trees.document(), [](const BranchMesh& branches, const Skeleton&, const Progress&) {
        MeshAnalysis found;
        found.hash = meshHash(branches.mesh);
        found.quality = *measureQuality(branches.mesh);
        found.crossings.kindsKnown = true;
        found.crossings.counts = {0, 1, 0, 7};
        found.crossings.pairs = {{PairKind::Siblings, 4, 9}, {PairKind::Far, 5, 90}};
        found.collisions = {{1, 3, 7, {0.5, 1.0, 0.25}, 0.0125}};
        return Expected<MeshAnalysis>(found);
    });
    analysis.setRest(0);
    ValidationPanel panel(&trees.document(), &analysis);
    panel.resize(340, 700);
    panel.show();
    QVERIFY(analysis.waitForAll(10'000));
    auto* model = panel.findChild<ReportModel*>();
    auto* view = panel.findChild<ReportView*>();
    // A crossing at a fork is a fault, yet no hole: the sign is not red.
    QCOMPARE(panel.findChild<StatusBadge*>()->status(), StatusBadge::Status::Warning);
    QSignalSpy activated(&panel, &ValidationPanel::defectActivated);
    QSignalSpy separate(&panel, &ValidationPanel::separateRequested);
    const auto choose = [&](const ReportModel::Kind& kind) {
        const QModelIndex top = model->kindIndex(kind);
        view->expand(top);
        view->setCurrentIndex(model->index(0, 0, top));
        emit view->chosen(model->index(0, 0, top));
        return top;
    };
    const QModelIndex siblings = choose(PairKind::Siblings);
    QVERIFY(siblings.isValid() && model->rowCount(siblings) == 1);
    QCOMPARE(activated.takeFirst()[1].value<DefectPlace>().faces.size(), std::size_t(2));
    QVERIFY(!model->kindIndex(PairKind::Far).isValid()); // listed by branches
    const QModelIndex collisions = choose(FindingKind::Collision);
    QVERIFY(model->index(0, 0, collisions).data().toString().contains(QStringLiteral("12.5")));
    const auto place = activated.takeFirst()[1].value<DefectPlace>();
    QCOMPARE(place.points.size(), std::size_t(1));
    QVERIFY(place.box.radius() > 0.0);
    QCOMPARE(trees.document().selection().branches, (std::vector<Index>{1, 3}));
    QVERIFY(panel.findChild<QLabel*>(QStringLiteral("explanation"))
                ->text()
                .contains(KindTexts::of(FindingKind::Collision).print.toHtmlEscaped()));
    choose(FindingKind::ThinTriangle);
    QCOMPARE(activated.takeFirst()[1].value<DefectPlace>().faces.size(), std::size_t(1));
    panel.findChild<QPushButton*>(QStringLiteral("separateCollisions"))->click();
    QCOMPARE(separate.takeFirst()[0].value<NodeId>(), tree);
    quint64 counted = 0;
    for (const quint64 count : panel.findChild<HistogramView*>()->counts())
        counted += count;
    QCOMPARE(counted, quint64(trees.document().result(tree)->tree.branches->mesh.faceCount()));
    panel.copyReport();
    const QString text = QGuiApplication::clipboard()->text();
    QVERIFY(text.contains(QString::fromStdString(analysis.findings(tree)->hash.text())));
    QVERIFY(text.contains(KindTexts::of(FindingKind::Collision).name));
}

/// Green, amber and red are the same in the panel, in the status bar and for an export.
void TestValidationAnalysis::theVerdictIsOneEverywhere()
{
    test::TreeDocument trees;
    const NodeId tree = trees.add(test::smallForks(), "Oak");
    SelfIntersections crossings;
    crossings.kindsKnown = true;
    Analysis analysis(&trees.document(), [&crossings](const BranchMesh&, const Skeleton&, const Progress&) {
        MeshAnalysis found;
        found.crossings = crossings;
        return Expected<MeshAnalysis>(found);
    });
    analysis.setRest(0);
    Recompute recompute(&trees.document());
    ValidationPanel panel(&trees.document(), &analysis);
    StatusPanel status(&trees.document(), &recompute, &analysis);
    panel.resize(340, 500);
    panel.show();
    const auto* badge = panel.findChild<StatusBadge*>();
    const auto text = [&](const char* name) { return panel.findChild<QLabel*>(QLatin1String(name))->text(); };
    const auto faults = [&] { return meshFaults(trees.document(), &analysis, {}); };
    // Not looked for yet: nobody claims that there are none.
    QCOMPARE(badge->status(), StatusBadge::Status::Unknown);
    QCOMPARE(status.badgeState(), QStringLiteral("closed"));
    QVERIFY(analysis.waitForAll(10'000));
    QCOMPARE(badge->status(), StatusBadge::Status::Good);
    QTRY_COMPARE(status.badgeState(), QStringLiteral("good"));
    QVERIFY(text("explanation").contains(KindTexts::clean().print.toHtmlEscaped()));
    QVERIFY(faults().isEmpty());
    crossings.counts = {0, 0, 0, 26}; // branches that collide
    QVERIFY(edit::setParam(trees.document(), {tree}, *findParam("turtle.alpha"), 0.9));
    QVERIFY(recompute.waitForFull(test::patience(20'000)));
    QVERIFY(analysis.waitForAll(10'000));
    QCOMPARE(badge->status(), StatusBadge::Status::Warning);
    QTRY_COMPARE(status.badgeState(), QStringLiteral("closed"));
    const auto* label = status.findChild<QLabel*>(QStringLiteral("badge"));
    QVERIFY(!label->text().contains(QStringLiteral("26"))); // no word for who draws
    for (const QString& words : {text("panelTitle"), label->text() + label->toolTip(), faults().text})
        QVERIFY2(words.contains(QStringLiteral("closed"), Qt::CaseInsensitive) &&
                     words.contains(QStringLiteral("26")),
                 qPrintable(words));
    QVERIFY(text("explanation").contains(KindTexts::crossed().meaning.toHtmlEscaped()));
    QVERIFY(!text("explanation").contains(KindTexts::clean().print.toHtmlEscaped()));
    QVERIFY(faults().verdict == MeshVerdict::Crossing && !faults().mustAsk());
    NodeResult result = *trees.document().result(tree);
    auto report = std::make_shared<MeshReport>(*result.tree.report);
    report->valid = false;
    report->boundaryEdges = 3;
    result.tree.report = report;
    trees.document().setResult(tree, result);
    QCOMPARE(badge->status(), StatusBadge::Status::Bad);
    QCOMPARE(status.badgeState(), QStringLiteral("bad"));
    QVERIFY(faults().verdict == MeshVerdict::Broken && faults().mustAsk());
}

/// Trees, arms, terrains and objects, each under its name.
void TestValidationAnalysis::whatIsSelectedIsShown()
{
    test::TreeDocument trees;
    Document& document = trees.document();
    const NodeId tree = trees.add(test::smallForks(), "Oak");
    Analysis analysis(&document);
    ValidationPanel panel(&document, &analysis);
    panel.resize(340, 500);
    panel.show();
    const auto* badge = panel.findChild<StatusBadge*>();
    const auto text = [&](const char* name) { return panel.findChild<QLabel*>(QLatin1String(name))->text(); };
    const auto insert = [&](NodeKind kind, const char* name) {
        Node node;
        node.id = 1;
        node.kind = kind;
        node.name = name;
        return edit::insertNodes(document, {node}, noNode, 9).value_or(noNode);
    };
    const NodeId arm = insert(NodeKind::Arm, "Crane"), terrain = insert(NodeKind::Terrain, "Hills"),
                 object = insert(NodeKind::Primitive, "Rod"), group = insert(NodeKind::Group, "Group");
    const QString ofTree = text("explanation");
    for (const auto& [node, name, open] :
         {std::tuple(arm, "Crane", false), std::tuple(terrain, "Hills", true),
          std::tuple(object, "Rod", false)}) {
        document.setSelection({{node}, node, {}, noIndex});
        QCOMPARE(text("checkedNode"), QString::fromLatin1(name));
        QVERIFY(badge->status() == StatusBadge::Status::Unknown);
        QTRY_VERIFY_WITH_TIMEOUT(badge->status() == StatusBadge::Status::Good, test::patience(20'000));
        QCOMPARE(text("panelTitle").contains(QStringLiteral("open surface")), open);
        QCOMPARE(text("reportDetails").contains(QStringLiteral("volume")), !open);
        QVERIFY(!text("hashText").isEmpty() && text("explanation") != ofTree);
        QVERIFY(!panel.findChild<QPushButton*>(QStringLiteral("separateCollisions"))->isVisible());
        panel.copyReport();
        QVERIFY(QGuiApplication::clipboard()->text().contains(QLatin1String(name)));
        QVERIFY(!QGuiApplication::clipboard()->text().contains(QStringLiteral("Repairs")));
    }
    document.setSelection({{group}, group, {}, noIndex}); // has no mesh: what was shown stays
    QCOMPARE(text("checkedNode"), QStringLiteral("Rod"));
    document.setSelection({{tree}, tree, {}, noIndex});
    QCOMPARE(text("checkedNode"), QStringLiteral("Oak"));
    QVERIFY(badge->status() != StatusBadge::Status::Unknown);
    QVERIFY(edit::removeNodes(document, {tree}));
    QVERIFY(!text("checkedNode").isEmpty() && text("checkedNode") != QStringLiteral("Oak"));
    QVERIFY(edit::removeNodes(document, {arm, terrain, object}));
    QVERIFY(!panel.findChild<QLabel*>(QStringLiteral("checkedNode"))->isVisible());
}

void TestValidationAnalysis::defectsOfObjectsAreListed()
{
    Document document;
    TriangleMesh open;
    open.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    open.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}}; // a tetrahedron without one side
    Node node;
    node.id = 1;
    node.kind = NodeKind::Mesh;
    node.name = "Scan";
    node.mesh = SharedValue<TriangleMesh>(open);
    node.params.tree.translation = {5.0, 0.0, 0.0};
    const auto scan = edit::insertNodes(document, {node}, noNode, 0);
    QVERIFY(scan);
    Analysis analysis(&document);
    ValidationPanel panel(&document, &analysis);
    panel.resize(340, 500);
    panel.show();
    QTRY_VERIFY_WITH_TIMEOUT(panel.findChild<StatusBadge*>()->status() == StatusBadge::Status::Bad,
                             test::patience(20'000));
    auto* view = panel.findChild<ReportView*>();
    auto* model = dynamic_cast<ReportModel*>(view->model());
    const QModelIndex kind = model->kindIndex(DefectKind::BoundaryEdge);
    QVERIFY(kind.isValid());
    model->fetchMore(kind);
    QCOMPARE(model->rowCount(kind), 3);
    QSignalSpy shown(&panel, &ValidationPanel::defectActivated);
    emit view->chosen(model->index(0, 0, kind));
    QCOMPARE(shown.count(), 1);
    QCOMPARE(shown.at(0).at(0).value<NodeId>(), *scan);
    QVERIFY(shown.at(0).at(1).value<DefectPlace>().box.centre().x > 4.0); // where the node stands
    panel.hide();
    QVERIFY(edit::removeNodes(document, {*scan}));
    panel.show();
    QVERIFY(panel.findChild<QLabel*>(QStringLiteral("hashText")));
}

void TestValidationAnalysis::largeNumbersAreGrouped()
{
    MeshAnalysis analysis;
    analysis.crossings.kindsKnown = true;
    analysis.crossings.counts = {12'345, 0, 0, 67'890};
    analysis.collisions.resize(23'456);
    const QString text = ReportTexts::crossings(analysis);
    for (const int number : {12'345, 67'890, 23'456})
        QVERIFY2(text.contains(QLocale().toString(number)), qPrintable(text));
}

RAMURE_SUITE(TestValidationAnalysis)

} // namespace tst_validation_analysis

#include "tst_validation_analysis.moc"
