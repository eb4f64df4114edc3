#include "core/document/analysis.h"
#include "tests/support/suite.h"
#include "tests/widgets/tree_document.h"
#include "widgets/validation/histogram_view.h"
#include "widgets/validation/kind_texts.h"
#include "widgets/validation/report_view.h"
#include "widgets/validation/status_badge.h"
#include "widgets/validation/validation_panel.h"
#include <QClipboard>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QThread>
#include <QToolButton>
#include <atomic>

using namespace ramure;

/// What the panel shows of the long analysis.
class TestValidationAnalysis : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void theAnalysisTellsHowFarItIs();
    void findingsAreListedAndShown();
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
                QThread::msleep(1);
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
                .contains(kindText(FindingKind::Collision).print.toHtmlEscaped()));
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
    QVERIFY(text.contains(kindText(FindingKind::Collision).name));
}

QTEST_MAIN(TestValidationAnalysis)
#include "tst_validation_analysis.moc"
