#include "core/math/random.h"
#include "core/surface/foliage/branch_masses.h"
#include "tests/support/suite.h"
#include "tests/widgets/inspector_bench.h"
#include "widgets/base/fields/number_field.h"
#include "widgets/base/texts/branch_names.h"
#include "widgets/base/texts/fact_text.h"
#include <QAbstractItemModelTester>
#include <QClipboard>
#include <QSignalSpy>
#include <QSlider>
#include <QToolButton>

namespace tst_branch_inspector {

using namespace ramure;

namespace {

using Bench = test::InspectorBench;

} // namespace

class TestBranchInspector : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void emptyUntilABranchIsSelected();
    void saysWhyThereIsNoTree();
    void showsTheFactsOfTheActiveBranch();
    void aSelectedLimbIsCalledAsAWhole();
    void relativesAreLinks();
    void everySectionCanBeReached();
    void arrowKeysStep();
    void tellsTheViewportWhatToShow();
    void hiddenItIsSilentAndCatchesUp();
    void chosenSectionSurvivesADraft();
    void copiesCsv();
    void tableCopiesItsRows();
    void anglesInRadians();
    void everyTextIsTranslated();
    void nothingIsCutOff();
    void sectionModelKeepsTheRules();
    void manyRandomChoices();
};

void TestBranchInspector::emptyUntilABranchIsSelected()
{
    Bench bench;
    QSignalSpy inspected(&bench.inspector, &BranchInspector::sectionInspected);
    QVERIFY(!bench.showsBranch());
    QVERIFY(bench.visibleTexts().join(u'\n').contains(QLatin1String("Select a branch")));
    bench.trees.selectNode(bench.tree);
    QVERIFY(!bench.showsBranch());
    bench.inspector.nextSection();
    bench.inspector.copyCsv();
    QCOMPARE(inspected.count(), 0);
    bench.trees.select(bench.tree, {1}, 1);
    QVERIFY(bench.showsBranch());
    bench.document().setSelection({});
    QVERIFY(!bench.showsBranch());
}

void TestBranchInspector::saysWhyThereIsNoTree()
{
    NodeParams broken = test::smallForks();
    broken.grammar.axiom = "F[";
    test::TreeDocument trees;
    BranchInspector inspector(&trees.document());
    inspector.show();
    QCOMPARE(trees.add(broken), noNode);
    trees.selectNode(trees.document().scene().nodes().front().id);
    QStringList texts;
    for (const QLabel* label : inspector.findChildren<QLabel*>())
        texts += label->text();
    QVERIFY2(texts.join(u'\n').contains(QLatin1String("This tree has no branches")),
             qPrintable(texts.join(u'\n')));
}

void TestBranchInspector::showsTheFactsOfTheActiveBranch()
{
    Bench bench;
    const TreeResult& tree = bench.document().result(bench.tree)->tree;
    const auto masses = branchMasses(bench.skeleton(), *tree.foliage);
    const ChildLists children = childLists(bench.skeleton());
    for (Index branch = 0; branch < bench.skeleton().size(); ++branch) {
        bench.trees.select(bench.tree, {branch}, branch);
        const BranchFacts facts = branchFacts(bench.skeleton(), children, *tree.sections, masses, branch);
        const auto deg = AngleUnit::Degrees;
        QCOMPARE(bench.fact("Order"), QString::number(facts.order));
        QCOMPARE(bench.fact("Start (p0)"), facttext::point(facts.p0, 3));
        QCOMPARE(bench.fact("End (p1)"), facttext::point(facts.p1, 3));
        QCOMPARE(bench.fact("Start radius (a0)"), facttext::length(facts.a0));
        QCOMPARE(bench.fact("End radius (a1)"), facttext::length(facts.a1));
        QCOMPARE(bench.fact("Length"), facttext::length(facts.length));
        QCOMPARE(bench.fact("Angle to the parent"), facttext::angle(facts.angleRad, deg));
        QCOMPARE(bench.fact("Azimuth"), facttext::angle(facts.azimuthRad, deg));
        QCOMPARE(bench.fact("Mass"), facttext::number(facts.mass, 4));
        QVERIFY(bench.visibleTexts().contains(BranchNames().branch(BranchRows(tree), branch)));
        QVERIFY(bench.visibleTexts().contains(QStringLiteral("Tree · branch %1 in reports").arg(branch)));
    }
    bench.trees.select(bench.tree, {1}, 1);
    QCOMPARE(bench.fact("Angle to the parent"), QStringLiteral("34.38°")); // 0.6 rad
    QCOMPARE(bench.fact("Length"), QStringLiteral("0.20 m"));
}

void TestBranchInspector::aSelectedLimbIsCalledAsAWhole()
{
    Bench bench;
    const BranchRows rows(bench.document().result(bench.tree)->tree);
    bool any = false;
    for (Index axis = 0; axis < rows.axisCount(); ++axis) {
        const auto limb = rows.branches(axis);
        bench.trees.select(bench.tree, {limb.begin(), limb.end()}, limb.back());
        QVERIFY(bench.visibleTexts().contains(BranchNames().axis(rows, axis)));
        const bool isSaid =
            bench.visibleTexts().join(u'\n').contains(QLatin1String("the whole limb is selected"));
        QCOMPARE(isSaid, limb.size() > 1);
        any = any || isSaid;
    }
    QVERIFY(any);
}

void TestBranchInspector::relativesAreLinks()
{
    Bench bench;
    const auto follow = [&](const QString& name, Index to) {
        const QString link = QStringLiteral("href=\"%1\"").arg(to);
        QVERIFY2(bench.fact(name).contains(link), qPrintable(bench.fact(name)));
        emit bench.facts()->linkActivated(QString::number(to));
        QCOMPARE(bench.document().selection().activeBranch, to);
        QCOMPARE(bench.document().selection().branches, std::vector<Index>{to});
        QCOMPARE(bench.document().selection().branchNode, bench.tree);
    };
    const ChildLists children = childLists(bench.skeleton());
    QCOMPARE(children.count(0), Index(3));
    for (const Index child : children.of(0)) {
        bench.trees.select(bench.tree, {0}, 0);
        QCOMPARE(bench.fact("Parent"), QStringLiteral("none: a root"));
        follow("Children", child);
        follow("Parent", 0);
    }
    const Index last = bench.skeleton().size() - 1;
    bench.trees.select(bench.tree, {last}, last);
    QCOMPARE(bench.fact("Children"), QStringLiteral("none: a tip"));
    // A real click on the label's text does the same.
    bench.trees.select(bench.tree, {1}, 1);
    for (QLabel* label : bench.facts()->findChildren<QLabel*>())
        if (label->text() == QLatin1String("<a href=\"0\">0</a>"))
            QTest::mouseClick(label, Qt::LeftButton, {}, QPoint(4, label->fontMetrics().height() / 2));
    QCOMPARE(bench.document().selection().activeBranch, Index(0));
}

void TestBranchInspector::everySectionCanBeReached()
{
    NodeParams params = test::smallForks();
    params.sections.lengthDivisions = 7;
    Bench bench(params);
    bench.trees.select(bench.tree, {2}, 2);
    QSignalSpy inspected(&bench.inspector, &BranchInspector::sectionInspected);
    auto* slider = bench.part<QSlider>("sectionSlider");
    auto* field = bench.part<NumberField>("sectionField");
    auto* table = bench.part<QTableView>("sectionTable");
    QCOMPARE(slider->maximum(), 6);
    const auto expect = [&](int section) {
        QCOMPARE(bench.browser()->currentSection(), section);
        QCOMPARE(slider->value(), section);
        QCOMPARE(field->value(), std::optional<double>(section + 1.0));
        QCOMPARE(table->currentIndex().row(), section);
        QCOMPARE(inspected.count(), 1);
        QCOMPARE(inspected.takeFirst(), (QVariantList{bench.tree, Index(2), static_cast<Index>(section)}));
    };
    slider->setValue(3);
    expect(3);
    emit field->valueEdited(7.0);
    expect(6);
    table->setCurrentIndex(table->model()->index(1, 4));
    expect(1);
    bench.inspector.nextSection();
    expect(2);
    bench.inspector.previousSection();
    expect(1);
    // At the ends there is nothing further.
    slider->setValue(0);
    expect(0);
    bench.inspector.previousSection();
    QCOMPARE(bench.browser()->currentSection(), 0);
    QCOMPARE(inspected.count(), 0);
    // The values beside the stepper are those of the section.
    const auto sections = bench.sections(2);
    FactForm* values = bench.browser()->details();
    for (int section = 0; section < 7; ++section) {
        slider->setValue(section);
        for (int row = 0; row < values->rowCount(); ++row)
            QCOMPARE(values->value(row), SectionModel::valueText(sections[static_cast<std::size_t>(section)],
                                                                 row + 1, AngleUnit::Degrees, 3));
    }
}

void TestBranchInspector::arrowKeysStep()
{
    Bench bench;
    bench.trees.select(bench.tree, {2}, 2);
    auto* slider = bench.part<QSlider>("sectionSlider");
    auto* table = bench.part<QTableView>("sectionTable");
    QTest::keyClick(slider, Qt::Key_Right);
    QCOMPARE(bench.browser()->currentSection(), 1);
    QTest::keyClick(slider, Qt::Key_End);
    QCOMPARE(bench.browser()->currentSection(), 3);
    QTest::keyClick(table, Qt::Key_Up);
    QCOMPARE(bench.browser()->currentSection(), 2);
    QTest::keyClick(table, Qt::Key_Home, Qt::ControlModifier);
    QCOMPARE(bench.browser()->currentSection(), 0);
    QTest::keyClick(table, Qt::Key_Down);
    QCOMPARE(bench.browser()->currentSection(), 1);
}

void TestBranchInspector::tellsTheViewportWhatToShow()
{
    Bench bench;
    QSignalSpy inspected(&bench.inspector, &BranchInspector::sectionInspected);
    QSignalSpy left(&bench.inspector, &BranchInspector::sectionLeft);
    bench.trees.select(bench.tree, {3}, 3);
    QCOMPARE(inspected.takeLast(), (QVariantList{bench.tree, Index(3), Index(0)}));
    bench.inspector.nextSection();
    QCOMPARE(inspected.takeLast(), (QVariantList{bench.tree, Index(3), Index(1)}));
    bench.trees.select(bench.tree, {4}, 4); // the same section of another branch
    QCOMPARE(inspected.takeLast(), (QVariantList{bench.tree, Index(4), Index(1)}));
    inspected.clear();
    bench.trees.compute(bench.tree); // its place may have moved
    QCOMPARE(inspected.count(), 1);
    QCOMPARE(left.count(), 0);
    bench.document().setSelection({});
    QCOMPARE(left.count(), 1);
    bench.document().setSelection({});
    bench.trees.selectNode(bench.tree);
    QCOMPARE(left.count(), 1); // said once
    bench.trees.select(bench.tree, {4}, 4);
    QVERIFY(edit::removeNodes(bench.document(), {bench.tree}));
    QCOMPARE(left.count(), 2);
}

void TestBranchInspector::hiddenItIsSilentAndCatchesUp()
{
    Bench bench;
    bench.trees.select(bench.tree, {3}, 3);
    QSignalSpy inspected(&bench.inspector, &BranchInspector::sectionInspected);
    QSignalSpy left(&bench.inspector, &BranchInspector::sectionLeft);
    bench.inspector.hide();
    QCOMPARE(left.count(), 1);
    bench.trees.select(bench.tree, {5}, 5);
    bench.trees.compute(bench.tree);
    QCOMPARE(inspected.count(), 0);
    bench.inspector.show();
    QCOMPARE(inspected.takeLast(), (QVariantList{bench.tree, Index(5), Index(0)}));
    QVERIFY(bench.visibleTexts().contains(QStringLiteral("Tree · branch 5 in reports")));
}

void TestBranchInspector::chosenSectionSurvivesADraft()
{
    NodeParams params = test::smallForks();
    params.sections.lengthDivisions = 9;
    Bench bench(params);
    bench.trees.select(bench.tree, {3}, 3);
    bench.part<QSlider>("sectionSlider")->setValue(6);
    bench.trees.compute(bench.tree, 3);
    QCOMPARE(bench.browser()->facts().size(), std::size_t(3));
    QCOMPARE(bench.browser()->currentSection(), 2);
    bench.trees.compute(bench.tree);
    QCOMPARE(bench.browser()->currentSection(), 6);
    QCOMPARE(bench.part<QTableView>("sectionTable")->currentIndex().row(), 6);
}

void TestBranchInspector::copiesCsv()
{
    Bench bench;
    bench.trees.select(bench.tree, {3}, 3);
    QSignalSpy messages(&bench.inspector, &BranchInspector::messageRaised);
    const QString expected = QString::fromStdString(sectionsCsv(bench.sections(3)));
    QGuiApplication::clipboard()->setText(QStringLiteral("before"));
    bench.inspector.copyCsv();
    QCOMPARE(QGuiApplication::clipboard()->text(), expected);
    QCOMPARE(messages.count(), 1);
    QGuiApplication::clipboard()->setText(QStringLiteral("before"));
    QTest::mouseClick(bench.part<QToolButton>("copyCsv"), Qt::LeftButton);
    QCOMPARE(QGuiApplication::clipboard()->text(), expected);
}

void TestBranchInspector::tableCopiesItsRows()
{
    Bench bench;
    bench.trees.select(bench.tree, {3}, 3);
    auto* table = bench.part<QTableView>("sectionTable");
    const auto sections = bench.sections(3);
    QTest::keyClick(table, Qt::Key_C, Qt::ControlModifier);
    QCOMPARE(QGuiApplication::clipboard()->text(), QString::fromStdString(sectionsCsv(sections)));
    const QAbstractItemModel* model = table->model();
    table->selectionModel()->select(QItemSelection(model->index(1, 0), model->index(2, 0)),
                                    QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
    QTest::keyClick(table, Qt::Key_C, Qt::ControlModifier);
    QCOMPARE(QGuiApplication::clipboard()->text(),
             QString::fromStdString(sectionsCsv(std::span(sections).subspan(1, 2))));
    // The window's own Ctrl+C does not get it.
    QKeyEvent override(QEvent::ShortcutOverride, Qt::Key_C, Qt::ControlModifier);
    override.ignore();
    QCoreApplication::sendEvent(table, &override);
    QVERIFY(override.isAccepted());
}

void TestBranchInspector::anglesInRadians()
{
    Bench bench;
    bench.trees.select(bench.tree, {1}, 1);
    bench.inspector.setAngleUnit(AngleUnit::Radians);
    QCOMPARE(bench.fact("Angle to the parent"), QStringLiteral("0.6000 rad"));
    auto* field = bench.part<NumberField>("rollField");
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("0.5"));
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(bench.rollOf(1), 0.5);
    bench.inspector.setAngleUnit(AngleUnit::Degrees);
    QCOMPARE(bench.fact("Angle to the parent"), QStringLiteral("34.38°"));
}

void TestBranchInspector::everyTextIsTranslated()
{
    const test::InStars stars;
    Bench bench;
    bench.trees.select(bench.tree, {1, 2}, 1);
    const auto isNumber = [](const QString& text) {
        return text.isEmpty() || text.contains(QRegularExpression(QStringLiteral("^[-0-9<]")));
    };
    for (const QLabel* label : bench.inspector.findChildren<QLabel*>()) {
        QVERIFY2(label->text().contains(u'★') || isNumber(label->text()), qPrintable(label->text()));
        QVERIFY2(label->toolTip().isEmpty() || label->toolTip().startsWith(u'★'),
                 qPrintable(label->toolTip()));
    }
    for (const QToolButton* button : bench.inspector.findChildren<QToolButton*>())
        if (!button->toolTip().isEmpty())
            QVERIFY2(button->toolTip().startsWith(u'★'), qPrintable(button->toolTip()));
    const auto* model = bench.part<QTableView>("sectionTable")->model();
    for (int column = 0; column < model->columnCount(); ++column) {
        QVERIFY(model->headerData(column, Qt::Horizontal).toString().startsWith(u'★'));
        QVERIFY(model->headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString().startsWith(u'★'));
    }
}

void TestBranchInspector::nothingIsCutOff()
{
    test::StarLanguage language;
    QVERIFY(QCoreApplication::installTranslator(&language));
    {
        Bench bench;
        bench.trees.select(bench.tree, {1, 2}, 1);
        for (const int width : {bench.inspector.minimumSizeHint().width(), 340, 500}) {
            bench.inspector.resize(width, 900);
            QCoreApplication::processEvents();
            for (const QLabel* label : bench.inspector.findChildren<QLabel*>()) {
                if (!label->isVisible())
                    continue;
                const bool fits = label->wordWrap() ? label->heightForWidth(label->width()) <= label->height()
                                                    : label->sizeHint().width() <= label->width();
                QVERIFY2(fits, qPrintable(QStringLiteral("%1 at %2").arg(label->text()).arg(width)));
            }
            const QWidget* content = bench.part<QWidget>("inspectorContent");
            QVERIFY(content->width() <= content->parentWidget()->width());
        }
    }
    QCoreApplication::removeTranslator(&language);
}

void TestBranchInspector::sectionModelKeepsTheRules()
{
    Bench bench;
    SectionModel model;
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    const auto all = bench.sections(3);
    for (const std::size_t count : {0, 1, 4, 4, 2, 0, 3}) {
        const std::vector<SectionFacts> facts(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count));
        model.setFacts(facts);
        QCOMPARE(model.rowCount(), static_cast<int>(count));
        for (int row = 0; row < model.rowCount(); ++row)
            for (int column = 0; column < model.columnCount(); ++column)
                QCOMPARE(model.index(row, column).data().toString(),
                         SectionModel::valueText(facts[static_cast<std::size_t>(row)], column,
                                                 AngleUnit::Degrees, 4));
    }
}

void TestBranchInspector::manyRandomChoices()
{
    Bench bench;
    Random random(5, RandomStream::Test);
    for (int i = 0; i < 300; ++i) {
        const Index branch = random.below(bench.skeleton().size());
        switch (random.below(6)) {
        case 0:
            bench.trees.compute(bench.tree, 2 + static_cast<int>(random.below(5)));
            break;
        case 1:
            bench.document().undo();
            break;
        case 2:
            emit bench.part<NumberField>("rollField")->valueEdited(random.range(-4.0, 4.0));
            break;
        case 3:
            bench.part<QSlider>("sectionSlider")->setValue(static_cast<int>(random.below(6)));
            break;
        default:
            bench.trees.select(bench.tree, {branch}, branch);
        }
        if (!bench.showsBranch() || !bench.document().scene().find(bench.tree))
            break;
        const Index active = bench.document().selection().activeBranch;
        const auto expected = bench.sections(active);
        QCOMPARE(bench.browser()->facts().size(), expected.size());
        QCOMPARE(sectionsCsv(bench.browser()->facts()), sectionsCsv(expected));
        QCOMPARE(bench.part<NumberField>("rollField")->value(), std::optional(bench.rollOf(active)));
    }
}

RAMURE_SUITE(TestBranchInspector)

} // namespace tst_branch_inspector

#include "tst_branch_inspector.moc"
