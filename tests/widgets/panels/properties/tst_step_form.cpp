#include "core/params/tree_edit_table.h"
#include "core/qt/document/commands.h"
#include "tests/support/hand_bench.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/panels/properties/param_row.h"
#include "widgets/panels/properties/step_form.h"
#include <QToolButton>

namespace tst_step_form {

using namespace ramure;

/// The values of the step that is selected.
class TestStepForm : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnWidgetWarning(); }

    void showsNothingWithoutAStep()
    {
        test::HandBench bench(HandTool::None);
        QWidget window;
        StepForm form(&bench.document, &window);
        window.show();
        QVERIFY(!form.isVisible());
        form.setStep(1, 4711); // there is none
        QVERIFY(!form.isVisible());
        TreeEdit hand;
        hand.operation = EditOperation::Prune;
        hand.shape.numbers = {0, 0, 0, 100, 0, 0};
        const auto ids = edit::putTreeEdits(bench.document, 1, {hand});
        QVERIFY(ids);
        form.setStep(1, ids->front());
        QVERIFY(!form.isVisible()); // it has no parameters
    }

    /// Every kind in turn: a row for each parameter, a value that is set, undone and reset.
    void showsAndSetsValues_data()
    {
        QTest::addColumn<QByteArray>("kind");
        for (const EditOperationInfo& info : editOperations())
            if (!stepParams(info.operation).empty())
                QTest::newRow(info.key) << QByteArray(info.key);
    }
    void showsAndSetsValues()
    {
        QFETCH(QByteArray, kind);
        const EditOperation operation = editOperationOf(kind.constData())->operation;
        test::HandBench bench(HandTool::None);
        QWidget window;
        StepForm form(&bench.document, &window);
        window.show();
        const auto ids = edit::putTreeEdits(bench.document, 1, {newStep(operation)});
        QVERIFY(ids);
        form.setStep(1, ids->front());
        QVERIFY(form.isVisible());
        QCOMPARE(form.rows().size(), stepParams(operation).size());
        for (ParamRow* row : form.rows()) {
            if (row->def().type != ParamType::Real || !row->acts() || !row->isRelevant())
                continue;
            const auto valueOf = [&] {
                return std::get<double>(row->def().get(*bench.edits().front().values));
            };
            const double before = valueOf(), after = 0.5 * (row->def().softMin + before);
            emit row->editor()->valueEdited(ParamValue(after), 0);
            QCOMPARE(valueOf(), after);
            QVERIFY(before == after || !row->resetButton()->isHidden());
            bench.document.undo();
            QCOMPARE(valueOf(), before);
            emit row->editor()->valueEdited(ParamValue(row->def().hardMax + 1e9), 0);
            QVERIFY(!row->message().isEmpty() || row->editor()->showMessage(QString()));
            QCOMPARE(valueOf(), before);
            emit row->editor()->valueEdited(ParamValue(after), 0);
            row->resetButton()->click();
            QCOMPARE(valueOf(), before);
        }
        QVERIFY(edit::removeTreeEdits(bench.document, 1, *ids));
        QVERIFY(!form.isVisible());
    }
};

RAMURE_SUITE(TestStepForm)

} // namespace tst_step_form

#include "tst_step_form.moc"
