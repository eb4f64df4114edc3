#include "widgets/dialogs/variations/variations_dialog.h"

#include "core/io/csv_table.h"
#include "core/presets/presets.h"
#include "core/qt/document/commands.h"
#include "core/qt/document/project/own_presets.h"
#include "core/qt/session/jobs/job.h"
#include "tests/support/suite.h"
#include "tests/widgets/base/fixture.h"
#include "tests/widgets/tree_document.h"
#include "widgets/base/fields/number_field.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/dialogs/variations/variation_delegate.h"
#include "widgets/dialogs/variations/varied_params_form.h"
#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>

namespace tst_variations_dialog {

using namespace ramure;
using Choice = VariationsModel::Choice;

/// Many trees from one, as pictures.
class TestVariationsDialog : public QObject
{
    Q_OBJECT

    struct Fixture
    {
        test::TreeDocument trees;
        Preferences preferences;
        test::FakeChooser chooser;
        VariationsDialog dialog{&trees.document(), &preferences, &chooser, nullptr};
        NodeId tree = trees.add(*presetParams("TinyTree"), "TinyTree");

        explicit Fixture(int count = 4)
        {
            dialog.countField()->setValue(count);
            dialog.offerFor(tree);
        }
        [[nodiscard]] const NodeParams& params() { return trees.document().scene().find(tree)->params; }
        void choose(int row) { dialog.view()->setCurrentIndex(dialog.model()->index(row)); }
        [[nodiscard]] bool isDrawn() const { return dialog.model()->drawn() == dialog.model()->rowCount(); }
    };
    static const ParamDef& leafSize() { return *findParam("foliage.leafSize"); }
    static QPixmap pictureOf(const VariationsModel& model, int row)
    {
        return model.index(row).data(Qt::DecorationRole).value<QPixmap>();
    }

    /// Drawing leaves the processor to every other suite that runs.
    static constexpr int patienceMs = test::patience(280'000);

private slots:
    void init() { test::failOnAnyWarning(); }
    /// What a closed dialog left to itself uses what the end of the program takes apart.
    void cleanup() { QTRY_COMPARE_WITH_TIMEOUT(Job::abandonedCount(), 0, patienceMs); }

    void whatIsNoTreeIsNotOffered()
    {
        Fixture f;
        const QString title = f.dialog.windowTitle();
        f.dialog.offerFor(f.trees.addGroup());
        f.dialog.offerFor(999);
        QCOMPARE(f.dialog.windowTitle(), title);
        QCOMPARE(f.dialog.model()->rowCount(), 4);
    }
    void treesThatCannotGrowSayWhy()
    {
        test::TreeDocument trees;
        Node broken = test::treeNode(1, "Broken");
        broken.params.grammar.rules = "A -> [";
        const NodeId id = edit::insertNodes(trees.document(), {broken}, noNode, 0).value_or(noNode);
        Preferences preferences;
        test::FakeChooser chooser;
        VariationsDialog dialog(&trees.document(), &preferences, &chooser, nullptr);
        dialog.countField()->setValue(2);
        dialog.offerFor(id);
        QTRY_COMPARE_WITH_TIMEOUT(dialog.model()->drawn(), 2, patienceMs);
        QVERIFY(!dialog.model()->index(1).data(VariationsModel::ProblemRole).toString().isEmpty());
        QVERIFY(pictureOf(*dialog.model(), 1).isNull());
    }
    void lockedTreesStayAsTheyAre()
    {
        Fixture f;
        QVERIFY(edit::setNodeLocked(f.trees.document(), {f.tree}, true));
        const int steps = f.trees.document().undoStack()->count();
        f.dialog.openAction()->trigger();
        QCOMPARE(f.trees.document().undoStack()->count(), steps);
        QVERIFY(f.dialog.hint()->text().contains(QStringLiteral("lock")));
    }
    void eachHasAPictureOfItsOwn()
    {
        Fixture f;
        QVERIFY(f.dialog.stopButton()->isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(f.isDrawn(), patienceMs);
        QVERIFY(!f.dialog.stopButton()->isVisible());
        const VariationsModel& model = *f.dialog.model();
        QVERIFY(pictureOf(model, 0).toImage() != pictureOf(model, 1).toImage());
        QVERIFY(model.index(2).data(Qt::ToolTipRole).toString().contains(QStringLiteral("Seed")));
    }
    void stoppedPicturesGoOn()
    {
        Fixture f;
        f.dialog.stopButton()->click();
        const int drawn = f.dialog.model()->drawn();
        QVERIFY(drawn < 4);
        QVERIFY(f.dialog.stopButton()->isVisible());
        f.dialog.stopButton()->click();
        QTRY_VERIFY_WITH_TIMEOUT(f.isDrawn(), patienceMs);
    }
    void openingIsOneStepOfUndo()
    {
        Fixture f;
        const NodeParams before = f.params();
        f.dialog.form()->add(leafSize());
        QTRY_COMPARE(f.dialog.model()->at(0).values.size(), std::size_t(1));
        const int steps = f.trees.document().undoStack()->count();
        f.choose(1);
        QTest::keyClick(f.dialog.view(), Qt::Key_Return);
        QCOMPARE(f.trees.document().undoStack()->count(), steps + 1);
        QVERIFY(f.params() == *variedParams(before, f.dialog.model()->at(1)));
        // One without the parameter, after one with it: of the first nothing is left.
        f.dialog.form()->remove(leafSize());
        QTRY_VERIFY(f.dialog.model()->at(0).values.empty());
        f.choose(2);
        f.dialog.openAction()->trigger();
        QVERIFY(f.params() == *variedParams(before, f.dialog.model()->at(2)));
        f.trees.document().undo();
        f.trees.document().undo();
        QVERIFY(f.params() == before);
        // What was opened here goes on; what was changed elsewhere begins anew.
        f.trees.document().redo();
        f.trees.document().redo();
        f.dialog.starAction()->trigger();
        f.dialog.offerFor(f.tree);
        QVERIFY(f.dialog.model()->isStarred(2));
        QVERIFY(edit::setParam(f.trees.document(), {f.tree}, leafSize(), 3.0));
        f.dialog.offerFor(f.tree);
        QVERIFY(f.dialog.model()->chosen(Choice::Starred).empty());
    }
    void starredOnesStay()
    {
        Fixture f;
        QVERIFY(QTest::qWaitForWindowActive(&f.dialog)); // for the shortcut
        f.choose(0);
        QTest::keyClick(f.dialog.view(), Qt::Key_Right);
        QTest::keyClick(f.dialog.view(), Qt::Key_S);
        QVERIFY(f.dialog.model()->isStarred(1));
        const Variation good = f.dialog.model()->at(1);
        f.dialog.otherButton()->click();
        QCOMPARE(f.dialog.model()->rowCount(), 5);
        QVERIFY(f.dialog.model()->at(0) == good && f.dialog.model()->isStarred(0));
        const QPoint star =
            VariationDelegate::starPlace(f.dialog.view()->visualRect(f.dialog.model()->index(3))).center();
        QTest::mouseClick(f.dialog.view()->viewport(), Qt::LeftButton, {}, star);
        QVERIFY(f.dialog.model()->isStarred(3));
        QTest::mouseClick(f.dialog.view()->viewport(), Qt::LeftButton, {}, star);
        QVERIFY(!f.dialog.model()->isStarred(3));
    }
    void parametersAreFoundByAPartOfTheirName()
    {
        Fixture f;
        VariedParamsForm* form = f.dialog.form();
        form->picker()->lineEdit()->setText(QStringLiteral("e")); // of many
        QTest::keyClick(form->picker()->lineEdit(), Qt::Key_Return);
        QCoreApplication::processEvents();
        QVERIFY(form->params().empty());
        const QString title =
            form->picker()->itemText(form->picker()->findData(QString::fromLatin1(leafSize().key)));
        form->picker()->lineEdit()->setText(title.toLower());
        QTest::keyClick(form->picker()->lineEdit(), Qt::Key_Return);
        emit form->picker()->activated(0); // as the list of completions does
        QTRY_COMPARE(form->params().size(), std::size_t(1));
        QVERIFY(form->params().front().def == &leafSize());
        QCOMPARE(form->picker()->findText(title), -1); // is varied already
        emit form->field(leafSize(), true)->valueEdited(4.0);
        QCOMPARE(form->params().front().to, 4.0);
        QTRY_VERIFY(!f.dialog.model()->at(0).values.empty());
    }
    void tablesHoldThoseThatWereChosen()
    {
        Fixture f;
        const QTemporaryDir folder;
        f.choose(2);
        f.dialog.starAction()->trigger();
        const auto rows = [&](Choice choice) {
            f.chooser.answer = folder.filePath(QStringLiteral("%1.csv").arg(int(choice)));
            f.dialog.saveAction(choice)->trigger();
            const auto table = readCsv(f.chooser.answer.toStdString());
            return table ? int(table->rows.size()) : -1;
        };
        QCOMPARE(rows(Choice::All), 4);
        QCOMPARE(rows(Choice::Starred), 1);
        QCOMPARE(rows(Choice::Rest), 3);
        QVERIFY(f.dialog.hint()->text().contains(QStringLiteral("ramure-cli batch")));
        f.chooser.answer = folder.filePath("none/wrong.csv");
        f.dialog.saveAction(Choice::All)->trigger();
        QVERIFY2(f.dialog.hint()->text().contains(QStringLiteral("wrong")),
                 qPrintable(f.dialog.hint()->text()));
    }
    void keptOnesAreInTheGallery()
    {
        Fixture f;
        QSignalSpy kept(&f.dialog, &VariationsDialog::presetKept);
        const QStringList before = OwnPresets().names();
        f.choose(3);
        f.dialog.keepAction()->trigger();
        QCOMPARE(kept.count(), 1);
        QStringList after = OwnPresets().names();
        for (const QString& name : before)
            after.removeAll(name);
        QCOMPARE(after.size(), 1);
        QVERIFY(OwnPresets().load(after.front())->params ==
                *variedParams(f.params(), f.dialog.model()->at(3)));
        QFile::remove(OwnPresets().folder() + u'/' + after.front() + QStringLiteral(".ramure"));
    }
};

RAMURE_SUITE(TestVariationsDialog)

} // namespace tst_variations_dialog

#include "tst_variations_dialog.moc"
