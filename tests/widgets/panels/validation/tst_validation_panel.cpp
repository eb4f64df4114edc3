#include "core/presets/presets.h"
#include "core/qt/session/jobs/analysis.h"
#include "tests/support/suite.h"
#include "tests/widgets/tree_document.h"
#include "widgets/panels/validation/kind_texts.h"
#include "widgets/panels/validation/report_text.h"
#include "widgets/panels/validation/report_view.h"
#include "widgets/panels/validation/status_badge.h"
#include "widgets/panels/validation/validation_panel.h"
#include <QClipboard>
#include <QLabel>
#include <QSignalSpy>
#include <QToolButton>
#include <set>

namespace tst_validation_panel {

using namespace ramure;

namespace {

/// A panel beside a document with one tree, whose mesh a test may replace.
struct Bench
{
    explicit Bench(const NodeParams& params = test::smallForks())
    {
        tree = trees.add(params, "Oak");
        panel.resize(340, 500);
        panel.show();
    }

    Document& document() { return trees.document(); }
    /// Puts another mesh and its report in the place of the tree's.
    void setMesh(TriangleMesh mesh, bool askOpenMesh = true)
    {
        NodeResult result = *document().result(tree);
        auto branches = std::make_shared<BranchMesh>(*result.tree.branches);
        branches->mesh = std::move(mesh);
        branches->mesh.branch.assign(branches->mesh.positions.size(), 3);
        auto report = std::make_shared<MeshReport>(*validateMesh(branches->mesh));
        if (askOpenMesh)
            QVERIFY(confirmWithOpenMesh(branches->mesh, *report));
        branches->roots = std::max<Index>(1, report->components);
        result.tree.branches = branches;
        result.tree.report = report;
        document().setResult(tree, std::move(result));
    }
    const MeshReport& report() { return *document().result(tree)->tree.report; }
    ReportView* view() { return panel.findChild<ReportView*>(); }
    ReportModel* model() { return panel.findChild<ReportModel*>(); }
    /// Without an analysis nothing is known of crossings: closed is not yet green.
    static constexpr auto closed = StatusBadge::Status::Unknown;
    StatusBadge::Status status() { return panel.findChild<StatusBadge*>()->status(); }
    QString text(const char* name) { return panel.findChild<QLabel*>(QLatin1String(name))->text(); }
    QModelIndex openKind(ReportModel::Kind kind)
    {
        const QModelIndex top = model()->kindIndex(kind);
        view()->expand(top);
        return top;
    }
    void click(const QModelIndex& index)
    {
        view()->scrollTo(index);
        QTest::mouseClick(view()->viewport(), Qt::LeftButton, {}, view()->visualRect(index).center());
    }

    test::TreeDocument trees;
    NodeId tree = noNode;
    ValidationPanel panel{&trees.document()};
};

/// A regular tetrahedron, outward.
TriangleMesh tetrahedron(float shift = 0.0f)
{
    TriangleMesh mesh;
    mesh.positions = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    for (glm::vec3& p : mesh.positions)
        p.x += shift;
    mesh.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
    return mesh;
}

void append(TriangleMesh& mesh, const TriangleMesh& other)
{
    const Index base = mesh.vertexCount();
    mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
    for (const glm::uvec3& t : other.triangles)
        mesh.triangles.push_back(t + glm::uvec3(base));
}

/// A mesh with at least one defect of the kind.
TriangleMesh broken(DefectKind kind)
{
    TriangleMesh mesh = tetrahedron();
    switch (kind) {
    case DefectKind::BoundaryEdge:
        mesh.triangles.pop_back();
        break;
    case DefectKind::NonManifoldEdge:
        mesh.positions.push_back({3, 3, 3});
        mesh.triangles.push_back({0, 1, 4});
        break;
    case DefectKind::NonManifoldVertex: { // two that share vertex 0
        mesh.positions.insert(mesh.positions.end(), {{3, 1, 3}, {3, 3, 1}, {1, 3, 3}});
        mesh.triangles.insert(mesh.triangles.end(), {{0, 4, 5}, {0, 6, 4}, {0, 5, 6}, {4, 6, 5}});
        break;
    }
    case DefectKind::InconsistentEdge:
        std::swap(mesh.triangles[3].x, mesh.triangles[3].y);
        break;
    case DefectKind::DuplicateVertex:
        append(mesh, tetrahedron(5.0f));
        mesh.positions[4] = mesh.positions[0];
        break;
    case DefectKind::DuplicateFace:
        mesh.triangles.push_back(mesh.triangles[2]);
        break;
    case DefectKind::DegenerateFace:
        mesh.triangles.push_back({1, 1, 2});
        break;
    case DefectKind::IsolatedVertex:
        mesh.positions.push_back({4, 5, 6});
        break;
    }
    return mesh;
}

/// \p count separate triangles: three boundary edges each.
TriangleMesh loose(Index count)
{
    TriangleMesh mesh;
    for (Index i = 0; i < count; ++i) {
        const auto x = static_cast<float>(i);
        mesh.positions.insert(mesh.positions.end(), {{x, 0, 0}, {x + 0.5f, 0, 0}, {x, 0.5f, 0}});
        mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return mesh;
}

const std::vector<DefectKind> allDefects = [] {
    std::vector<DefectKind> kinds;
    for (int k = 0; k < defectKindCount; ++k)
        kinds.push_back(static_cast<DefectKind>(k));
    return kinds;
}();

} // namespace

class TestValidationPanel : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void noTreeNoReport();
    void aTreeWithoutAMeshSaysWhy();
    void emptyAndInsideOutMeshesAreNotGreen();
    void disagreementIsNotGreen();

    void presetsAreClosed();
    void openMeshsOpinionComesLater();
    void everyKindOfDefectIsListed();
    void aClickShowsTheDefect();
    void placesAreInTheWorld();
    void keysStepThroughDefects();
    void openKindsStayOpen();
    void repairsSelectTheirBranch();
    void explanationsFollowTheRow();
    void theReportIsCopied();
    void theTreeShownIsTheOneMeant();
    void hiddenItCatchesUp();
    void leavesTheHighlight();
    void escapeAndHidingLeaveTheHighlight();
    void someRowsAreAlwaysInSight();
    void everyTextIsTranslated();
    void nothingIsCutOff();
};

void TestValidationPanel::noTreeNoReport()
{
    test::TreeDocument trees;
    ValidationPanel panel(&trees.document());
    panel.show();
    QGuiApplication::clipboard()->setText(QStringLiteral("before"));
    panel.copyReport();
    QCOMPARE(QGuiApplication::clipboard()->text(), QStringLiteral("before"));
    trees.selectNode(trees.addGroup());
    QVERIFY(!panel.findChild<StatusBadge*>()->isVisible());
    const NodeId tree = trees.add(test::smallForks());
    QVERIFY(panel.findChild<StatusBadge*>()->isVisible());
    QVERIFY(edit::removeNodes(trees.document(), {tree}));
    QVERIFY(!panel.findChild<StatusBadge*>()->isVisible());
}

void TestValidationPanel::aTreeWithoutAMeshSaysWhy()
{
    Bench bench;
    QCOMPARE(bench.status(), Bench::closed);
    NodeResult result = *bench.document().result(bench.tree);
    result.error = Error{ErrorCode::Syntax, "no %1 here", {"tree"}, {}, {}, 0, 0};
    bench.document().setResult(bench.tree, result);
    QCOMPARE(bench.status(), StatusBadge::Status::Warning);
    QVERIFY(bench.text("reportDetails").contains(QLatin1String("no tree here")));
    QCOMPARE(bench.model()->rowCount(), 0);
    NodeResult nothing;
    bench.document().setResult(bench.tree, nothing);
    QCOMPARE(bench.status(), StatusBadge::Status::Unknown);
}

void TestValidationPanel::emptyAndInsideOutMeshesAreNotGreen()
{
    Bench bench;
    bench.setMesh({});
    QCOMPARE(bench.status(), StatusBadge::Status::Bad);
    TriangleMesh mesh = tetrahedron();
    for (glm::uvec3& t : mesh.triangles)
        std::swap(t.x, t.y);
    bench.setMesh(mesh);
    QVERIFY(!bench.report().valid);
    QCOMPARE(bench.status(), StatusBadge::Status::Bad);
}

void TestValidationPanel::disagreementIsNotGreen()
{
    Bench bench;
    NodeResult result = *bench.document().result(bench.tree);
    auto report = std::make_shared<MeshReport>(*result.tree.report);
    report->openMeshChecked = true;
    report->openMeshAgrees = false;
    result.tree.report = report;
    bench.document().setResult(bench.tree, result);
    QCOMPARE(bench.status(), StatusBadge::Status::Bad);
    report = std::make_shared<MeshReport>(*result.tree.report);
    report->openMeshAgrees = true;
    report->components = 2; // one root
    result.tree.report = report;
    bench.document().setResult(bench.tree, result);
    QCOMPARE(bench.status(), StatusBadge::Status::Bad);
}

void TestValidationPanel::presetsAreClosed()
{
    for (const Preset& preset : presets()) {
        NodeParams params = preset.params;
        params.grammar.iterations = std::min<std::int64_t>(params.grammar.iterations, 4);
        Bench bench(params);
        QVERIFY2(bench.status() == Bench::closed, preset.name);
        QCOMPARE(bench.text("panelTitle"), QStringLiteral("Closed; crossings not looked for yet"));
        const QString details = bench.text("reportDetails");
        QVERIFY(details.contains(QLocale().toString(bench.report().vertices)));
        QVERIFY(details.contains(QLocale().toString(bench.report().faces)));
        QVERIFY(details.contains(QLatin1String("Euler characteristic 2")));
    }
}

void TestValidationPanel::openMeshsOpinionComesLater()
{
    Bench bench;
    bench.setMesh(tetrahedron(), false);
    QVERIFY(!bench.text("reportDetails").contains(QLatin1String("Confirmed")));
    bench.setMesh(tetrahedron(), true);
    QVERIFY(bench.text("reportDetails").contains(QLatin1String("Confirmed by OpenMesh")));
    // The same mesh with another report: what is open and chosen stays.
    bench.setMesh(broken(DefectKind::BoundaryEdge), false);
    const QModelIndex top = bench.openKind(DefectKind::BoundaryEdge);
    bench.view()->setCurrentIndex(bench.model()->index(1, 0, top));
    NodeResult result = *bench.document().result(bench.tree);
    auto report = std::make_shared<MeshReport>(*result.tree.report);
    QVERIFY(confirmWithOpenMesh(result.tree.branches->mesh, *report));
    result.tree.report = report;
    QSignalSpy reset(bench.model(), &QAbstractItemModel::modelReset);
    bench.document().setResult(bench.tree, result);
    QCOMPARE(reset.count(), 0);
    QCOMPARE(bench.view()->currentIndex().row(), 1);
    QVERIFY(bench.text("reportDetails").contains(QLatin1String("OpenMesh refuses")));
}

void TestValidationPanel::everyKindOfDefectIsListed()
{
    for (const DefectKind kind : allDefects) {
        Bench bench;
        bench.setMesh(broken(kind));
        QVERIFY(bench.report().count(kind) > 0);
        QCOMPARE(bench.status(), StatusBadge::Status::Bad);
        int kinds = 0;
        for (const DefectKind other : allDefects) {
            const QModelIndex top = bench.model()->kindIndex(other);
            QCOMPARE(top.isValid(), bench.report().count(other) > 0);
            if (!top.isValid())
                continue;
            ++kinds;
            QVERIFY(top.data().toString().contains(KindTexts::of(other).name));
            QVERIFY(top.data().toString().contains(QString::number(bench.report().count(other))));
            bench.openKind(other);
            QCOMPARE(bench.model()->rowCount(top), static_cast<int>(bench.report().count(other)));
        }
        QCOMPARE(bench.model()->rowCount(), kinds);
        QVERIFY(bench.view()->isVisible());
    }
}

void TestValidationPanel::aClickShowsTheDefect()
{
    for (const DefectKind kind : allDefects) {
        Bench bench;
        bench.setMesh(broken(kind));
        QSignalSpy activated(&bench.panel, &ValidationPanel::defectActivated);
        const QModelIndex top = bench.openKind(kind);
        bench.click(top); // a kind is no place
        QCOMPARE(activated.count(), 0);
        for (int row = 0; row < bench.model()->rowCount(top); ++row) {
            bench.document().setSelection({});
            const QModelIndex index = bench.model()->index(row, 0, top);
            bench.click(index);
            QCOMPARE(activated.count(), 1);
            const QVariantList sent = activated.takeFirst();
            QCOMPARE(sent[0].value<NodeId>(), bench.tree);
            const auto place = sent[1].value<DefectPlace>();
            QCOMPARE(place.kind, kind);
            QCOMPARE(place.points.size() + place.edges.size() + place.faces.size() > 0, true);
            QVERIFY(!place.box.empty() && place.box.radius() > 0.0);
            QCOMPARE(place.label.section(u'\n', 1),
                     index.data().toString()); // its name, below that of the kind
            QCOMPARE(bench.document().selection().branchNode, bench.tree);
            QCOMPARE(bench.document().selection().branches, std::vector<Index>{3});
        }
    }
}

void TestValidationPanel::placesAreInTheWorld()
{
    Bench bench;
    const ParamDef* translation = findParam("tree.translation");
    QVERIFY(translation);
    QVERIFY(edit::setParam(bench.document(), {bench.tree}, *translation, glm::dvec3(10.0, 20.0, 30.0)));
    const TriangleMesh mesh = broken(DefectKind::IsolatedVertex);
    bench.setMesh(mesh);
    QSignalSpy activated(&bench.panel, &ValidationPanel::defectActivated);
    const QModelIndex top = bench.openKind(DefectKind::IsolatedVertex);
    bench.click(bench.model()->index(0, 0, top));
    const auto place = activated.takeFirst()[1].value<DefectPlace>();
    QCOMPARE(place.points.size(), std::size_t(1));
    QVERIFY(glm::length(place.points[0] - glm::dvec3(14.0, 25.0, 36.0)) < 1e-9);
    QVERIFY(glm::length(place.box.centre() - glm::dvec3(14.0, 25.0, 36.0)) < 1e-9);

    // Faces have their three corners, edges their two ends.
    const Defect face{DefectKind::DuplicateFace, 2, 4}, edge{DefectKind::BoundaryEdge, 0, 3};
    const DefectPlace faces = defectPlace(broken(DefectKind::DuplicateFace), face, glm::dmat4(1.0));
    QCOMPARE(faces.faces.size(), std::size_t(2));
    QVERIFY(faces.faces[0] == faces.faces[1]);
    const DefectPlace edges = defectPlace(tetrahedron(), edge, glm::dmat4(1.0));
    QCOMPARE(edges.edges.size(), std::size_t(1));
    QVERIFY(edges.edges[0][1] == glm::dvec3(-1, -1, 1));
    // What the mesh does not have is left out.
    for (const DefectKind kind : allDefects) {
        const Defect far{kind, 1000, noIndex};
        QVERIFY(defectPlace(tetrahedron(), far, glm::dmat4(1.0)).box.empty());
        QVERIFY(!defectMiddle(tetrahedron(), far));
        QCOMPARE(defectBranch(tetrahedron(), far), noIndex);
    }
}

void TestValidationPanel::keysStepThroughDefects()
{
    Bench bench;
    bench.setMesh(broken(DefectKind::BoundaryEdge));
    QSignalSpy activated(&bench.panel, &ValidationPanel::defectActivated);
    bench.view()->setCurrentIndex(bench.model()->index(0, 0));
    QTest::keyClick(bench.view(), Qt::Key_Right); // opens the kind
    QTest::keyClick(bench.view(), Qt::Key_Down);
    QCOMPARE(activated.count(), 1);
    QTest::keyClick(bench.view(), Qt::Key_Down);
    QCOMPARE(activated.count(), 2);
    QTest::keyClick(bench.view(), Qt::Key_Return); // once more
    QCOMPARE(activated.count(), 3);
    QCOMPARE(activated[1][1].value<DefectPlace>().edges, activated[2][1].value<DefectPlace>().edges);
}

void TestValidationPanel::openKindsStayOpen()
{
    Bench bench;
    bench.setMesh(broken(DefectKind::BoundaryEdge));
    bench.openKind(DefectKind::BoundaryEdge);
    bench.setMesh(tetrahedron());
    QVERIFY(!bench.view()->isVisible());
    TriangleMesh two = broken(DefectKind::BoundaryEdge);
    append(two, broken(DefectKind::NonManifoldEdge));
    bench.setMesh(two);
    QVERIFY(bench.view()->isExpanded(bench.model()->kindIndex(DefectKind::BoundaryEdge)));
    QVERIFY(!bench.view()->isExpanded(bench.model()->kindIndex(DefectKind::NonManifoldEdge)));
}

void TestValidationPanel::repairsSelectTheirBranch()
{
    NodeParams params = test::smallForks();
    params.grammar.axiom = "F[+F][+F][-F]"; // two siblings in one place
    Bench bench(params);
    const auto& repairs = bench.document().result(bench.tree)->tree.branches->repairs;
    QVERIFY(!repairs.empty());
    QCOMPARE(bench.status(), Bench::closed);
    const QModelIndex top = bench.openKind(repairs.front().kind);
    QVERIFY(top.isValid());
    QSignalSpy activated(&bench.panel, &ValidationPanel::defectActivated);
    const QModelIndex note = bench.model()->index(0, 0, top);
    QVERIFY(note.data().toString().contains(QString::number(repairs.front().branch)));
    bench.click(note);
    QCOMPARE(activated.count(), 0);
    QCOMPARE(bench.document().selection().branchNode, bench.tree);
    QCOMPARE(bench.document().selection().activeBranch, repairs.front().branch);
}

void TestValidationPanel::explanationsFollowTheRow()
{
    std::set<QString> seen;
    for (const DefectKind kind : allDefects) {
        Bench bench;
        QVERIFY(bench.text("explanation").isEmpty());
        bench.setMesh(broken(kind));
        const QModelIndex top = bench.openKind(kind);
        bench.view()->setCurrentIndex(top);
        const KindText text = KindTexts::of(kind);
        for (const QString& part : {text.name, text.meaning, text.print, text.game}) {
            QVERIFY(!part.isEmpty());
            QVERIFY(bench.text("explanation").contains(part.toHtmlEscaped()));
            QVERIFY2(seen.insert(part).second, qPrintable(part));
        }
        const QString ofKind = bench.text("explanation");
        bench.view()->setCurrentIndex(bench.model()->index(0, 0, top));
        QCOMPARE(bench.text("explanation"), ofKind);
    }
    for (int k = 0; k < repairKindCount; ++k) {
        const KindText text = KindTexts::of(static_cast<SkeletonRepair>(k));
        QVERIFY(seen.insert(text.name).second);
        QVERIFY(seen.insert(text.meaning).second);
    }
}

void TestValidationPanel::theReportIsCopied()
{
    Bench bench;
    TriangleMesh mesh = broken(DefectKind::BoundaryEdge);
    append(mesh, broken(DefectKind::DuplicateFace));
    bench.setMesh(mesh);
    QSignalSpy messages(&bench.panel, &ValidationPanel::messageRaised);
    QTest::mouseClick(bench.panel.findChild<QToolButton*>(QStringLiteral("copyReport")), Qt::LeftButton);
    const QString text = QGuiApplication::clipboard()->text();
    QCOMPARE(messages.count(), 1);
    QVERIFY(text.contains(QLatin1String("Oak")));
    QVERIFY(text.contains(bench.text("reportDetails")));
    for (const DefectKind kind : allDefects)
        QVERIFY(text.contains(
            QStringLiteral("%1: %2").arg(KindTexts::of(kind).name).arg(bench.report().count(kind))));
    for (const Defect& defect : bench.report().defects)
        QVERIFY(text.contains(defectName(defect)));
    QVERIFY(!text.contains(u'<')); // plain
}

void TestValidationPanel::theTreeShownIsTheOneMeant()
{
    Bench bench;
    bench.setMesh(broken(DefectKind::BoundaryEdge));
    const NodeId other = bench.trees.add(test::smallForks(), "Elm"); // becomes selected
    QCOMPARE(bench.status(), Bench::closed);
    bench.trees.selectNode(bench.tree);
    QCOMPARE(bench.status(), StatusBadge::Status::Bad);
    bench.trees.selectNode(bench.trees.addGroup()); // a group has no mesh: the tree before stays
    QCOMPARE(bench.status(), StatusBadge::Status::Bad);
    bench.trees.select(other, {0}, 0);
    QCOMPARE(bench.status(), Bench::closed);
    bench.document().setSelection({});
    QCOMPARE(bench.status(), Bench::closed);
    QVERIFY(edit::removeNodes(bench.document(), {other}));
    QCOMPARE(bench.status(), StatusBadge::Status::Bad);
}

void TestValidationPanel::hiddenItCatchesUp()
{
    Bench bench;
    bench.panel.hide();
    bench.setMesh(broken(DefectKind::BoundaryEdge));
    QCOMPARE(bench.model()->rowCount(), 0);
    bench.panel.show();
    QCOMPARE(bench.status(), StatusBadge::Status::Bad);
    QCOMPARE(bench.model()->rowCount(), 1);
}

void TestValidationPanel::leavesTheHighlight()
{
    Bench bench;
    QSignalSpy left(&bench.panel, &ValidationPanel::defectLeft);
    bench.setMesh(broken(DefectKind::BoundaryEdge));
    QCOMPARE(left.count(), 0);
    const QModelIndex top = bench.openKind(DefectKind::BoundaryEdge);
    bench.click(bench.model()->index(0, 0, top));
    QCOMPARE(left.count(), 0);
    bench.setMesh(tetrahedron());
    QCOMPARE(left.count(), 1);
    bench.setMesh(broken(DefectKind::BoundaryEdge));
    QCOMPARE(left.count(), 1);
}

void TestValidationPanel::escapeAndHidingLeaveTheHighlight()
{
    Bench bench;
    QSignalSpy left(&bench.panel, &ValidationPanel::defectLeft);
    bench.setMesh(broken(DefectKind::BoundaryEdge));
    const QModelIndex first = bench.model()->index(0, 0, bench.openKind(DefectKind::BoundaryEdge));
    QTest::keyClick(bench.view(), Qt::Key_Escape); // nothing to leave
    QCOMPARE(left.count(), 0);
    bench.click(first);
    QTest::keyClick(bench.view(), Qt::Key_Escape);
    QCOMPARE(left.count(), 1);
    QSignalSpy activated(&bench.panel, &ValidationPanel::defectActivated);
    bench.click(first); // the same row shows it again
    QCOMPARE(activated.count(), 1);
    bench.panel.hide();
    QCOMPARE(left.count(), 2);
}

void TestValidationPanel::someRowsAreAlwaysInSight()
{
    Bench bench;
    bench.setMesh(broken(DefectKind::BoundaryEdge));
    bench.openKind(DefectKind::BoundaryEdge);
    bench.panel.resize(340, bench.panel.minimumSizeHint().height());
    const int rows = 6 * bench.view()->sizeHintForRow(0);
    // Headers and a scroll bar to the side are not rows.
    QTRY_VERIFY2(bench.view()->viewport()->height() >= rows,
                 qPrintable(QStringLiteral("%1 of %2").arg(bench.view()->viewport()->height()).arg(rows)));
}

void TestValidationPanel::everyTextIsTranslated()
{
    const test::InStars stars;
    Bench bench;
    bench.setMesh(broken(DefectKind::BoundaryEdge));
    bench.view()->setCurrentIndex(bench.openKind(DefectKind::BoundaryEdge));
    for (const char* name : {"panelTitle", "reportDetails", "explanation", "hint"})
        QVERIFY2(bench.text(name).contains(u'★'), name);
    QVERIFY(bench.panel.findChild<QToolButton*>(QStringLiteral("copyReport"))->toolTip().startsWith(u'★'));
    const QModelIndex top = bench.model()->index(0, 0);
    QVERIFY(top.data().toString().contains(u'★'));
    QVERIFY(bench.model()->index(0, 0, top).data().toString().contains(u'★'));
    for (int column = 0; column < bench.model()->columnCount(); ++column)
        QVERIFY(bench.model()->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString().contains(u'★'));
}

void TestValidationPanel::nothingIsCutOff()
{
    test::StarLanguage language;
    QVERIFY(QCoreApplication::installTranslator(&language));
    {
        Bench bench;
        for (const bool good : {true, false}) {
            if (!good)
                bench.setMesh(loose(500));
            for (const int width : {280, 340, 600}) {
                bench.panel.resize(width, 600);
                QCoreApplication::processEvents();
                QCOMPARE(bench.panel.width(), width);
                for (const QLabel* label : bench.panel.findChildren<QLabel*>()) {
                    if (!label->isVisible())
                        continue;
                    const bool fits = label->wordWrap()
                                          ? label->heightForWidth(label->width()) <= label->height()
                                          : label->sizeHint().width() <= label->width();
                    QVERIFY2(fits, qPrintable(QStringLiteral("%1 at %2").arg(label->text()).arg(width)));
                }
            }
        }
    }
    QCoreApplication::removeTranslator(&language);
}

RAMURE_SUITE(TestValidationPanel)

} // namespace tst_validation_panel

#include "tst_validation_panel.moc"
