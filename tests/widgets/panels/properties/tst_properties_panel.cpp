#include "tests/support/kind_with.h"
#include "tests/widgets/base/fixture.h"
#include "tests/widgets/base/input.h"
#include "widgets/base/fields/number_field.h"
#include "widgets/base/fields/number_slider.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/panels/properties/color_editor.h"
#include "widgets/panels/properties/grammar/grammar_edit.h"
#include "widgets/panels/properties/group_section.h"
#include "widgets/panels/properties/param_facts.h"
#include "widgets/panels/properties/param_row.h"
#include "widgets/panels/properties/picture_editor.h"
#include "widgets/panels/properties/profile_curve.h"
#include "widgets/panels/properties/properties_panel.h"
#include "widgets/panels/properties/text_editor.h"
#include <QColorDialog>
#include <numbers>
namespace tst_properties_panel {
using namespace ramure;
namespace {

const ParamDef& param(const char* key)
{
    return *findParam(key);
}

ParamValue valueOf(const Document& document, NodeId id, const ParamDef& def)
{
    return def.get(document.scene().find(id)->params);
}

} // namespace

class TestPropertiesPanel : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;
    std::unique_ptr<Preferences> m_preferences;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<PropertiesPanel> m_panel;
    QByteArray m_function;

    void addEveryParam()
    {
        QTest::addColumn<QString>("key");
        const auto table = paramTable();
        for (std::size_t i = 0; i < table.size(); i += test::isSanitized ? 5 : 1)
            QTest::newRow(table[i].key) << QString::fromLatin1(table[i].key);
    }
    /// The parameter of the present row of data; the nodes become of a kind that has it.
    const ParamDef& fetched()
    {
        const auto* key = static_cast<QString*>(QTest::qData("key", qMetaTypeId<QString>()));
        const ParamDef& def = *findParam(key->toStdString());
        if (!hasParam(NodeKind::Tree, def) || !acts(NodeParams(), def)) {
            Node one = test::treeNode(1, "One"), two = test::treeNode(2, "Two");
            one.kind = two.kind = test::kindWith(def);
            test::makeRelevant(one.params, def);
            test::makeRelevant(two.params, def);
            test::openNodes(*m_document, {one, two});
            showAdvanced();
        }
        return def;
    }
    void openBoxes()
    {
        Node one = test::treeNode(1, "One"), two = test::treeNode(2, "Two");
        one.kind = two.kind = NodeKind::Primitive;
        one.params.primitive.shape = two.params.primitive.shape = PrimitiveShape::Box;
        test::openNodes(*m_document, {one, two});
    }
    void showAdvanced()
    {
        for (GroupSection* section : m_panel->findChildren<GroupSection*>()) {
            auto* more = section->findChild<QToolButton*>(QStringLiteral("advanced"));
            if (more && !more->isHidden() && !section->showsAdvanced())
                more->click();
        }
    }

    /// Types something else into the first editor of the row. \param part of the range, for numbers
    void typeAnother(ParamRow* row, double part = 0.27)
    {
        if (auto* field = row->findChild<NumberField*>()) {
            const ParamDef& def = row->def();
            const double wish =
                def.hardMin + part * (std::min(def.hardMax, def.hardMin + 100.0) - def.hardMin);
            double typed = def.type == ParamType::Int ? std::round(wish) + 1 : wish;
            if (def.type == ParamType::Int && typed == double(std::get<std::int64_t>(defaultValue(def))))
                typed -= 1;
            field->setFocus();
            field->selectAll();
            QTest::keyClicks(field, QString::number(typed));
            QTest::keyClick(field, Qt::Key_Return);
        } else if (auto* curve = row->findChild<ProfileCurve*>()) {
            test::typeLine(curve->parentWidget(), "0 1, 1 0.5");
        } else if (auto* box = row->findChild<QCheckBox*>()) {
            box->setFocus();
            QTest::keyClick(box, Qt::Key_Space);
        } else if (auto* choice = row->findChild<QComboBox*>()) {
            choice->setFocus();
            QTest::keyClick(choice, choice->currentIndex() > 0 ? Qt::Key_Up : Qt::Key_Down);
        } else if (auto* text = row->findChild<GrammarEdit*>()) {
            text->setFocus();
            QTest::keyClicks(text, "B");
        } else if (auto* color = row->findChild<ColorEditor*>()) {
            test::typeLine(color, "#123abc");
        } else if (row->findChild<QLineEdit*>()) {
            test::typeLine(row, "a");
        } else {
            QFAIL("no editor that a key can reach");
        }
    }
    /// A press, a move and a release, or a click.
    void changeByMouse(ParamRow* row)
    {
        if (auto* slider = row->findChild<NumberSlider*>()) {
            slider->setFocus();
            const int to = slider->value() > slider->maximum() / 2 ? 2 : slider->width() - 2;
            test::drag(slider, {slider->width() / 2, slider->height() / 2}, {to, slider->height() / 2});
        } else if (auto* box = row->findChild<QCheckBox*>()) {
            QTest::mouseClick(box, Qt::LeftButton, {}, {8, box->height() / 2});
        } else if (auto* choice = row->findChild<QComboBox*>()) {
            choice->setFocus();
            test::turnWheel(choice, choice->currentIndex() == 0 ? -120 : 120); // away from the list's end
        } else if (auto* dice = row->editor()->findChild<QToolButton*>()) {
            QTest::mouseClick(dice, Qt::LeftButton);
        } else if (auto* field = row->findChild<NumberField*>()) {
            QTest::mouseClick(field, Qt::LeftButton);
            test::turnWheel(field, 120);
        } else if (auto* color = row->findChild<ColorEditor*>()) {
            QTest::mouseClick(color->findChild<QAbstractButton*>(), Qt::LeftButton);
            color->dialog()->setCurrentColor(Qt::red); // tried first
            color->dialog()->setCurrentColor(Qt::blue);
            color->dialog()->accept();
        }
    }

    /// All is marked and cut by the menu of a right click; where there was no text, some is pasted.
    void cutByMouse(ParamRow* row, const ParamDef& def)
    {
        if (auto* picture = row->findChild<PictureEditor*>())
            return void(
                test::dropFiles(picture, {QUrl::fromLocalFile(QStringLiteral("/pictures/bark.png"))}));
        if (auto* curve = row->findChild<ProfileCurve*>()) {
            const QPoint handle = curve->handleAt(curve->pairs().front()).toPoint();
            return test::drag(curve, handle, handle + QPoint(20, 0));
        }
        if (auto* plain = row->findChild<TextEditor*>())
            return test::pasteLine(plain, QStringLiteral("1 2"));
        auto* text = row->findChild<GrammarEdit*>();
        const bool empty = std::get<std::string>(valueOf(*m_document, 1, def)).empty();
        QGuiApplication::clipboard()->setText(QStringLiteral("A -> B"));
        const auto choose = [text](const char* name) {
            const QPoint at(5, 5);
            QContextMenuEvent event(QContextMenuEvent::Mouse, at, text->viewport()->mapToGlobal(at));
            QCoreApplication::sendEvent(text->viewport(), &event);
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            QVERIFY(menu);
            auto* action = menu->findChild<QAction*>(QLatin1String(name));
            QVERIFY2(action && action->isEnabled(), name);
            QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(action).center());
        };
        if (!empty)
            choose("select-all");
        choose(empty ? "edit-paste" : "edit-cut");
    }

private slots:
    void init()
    {
        test::failOnWidgetWarning();
        // The rows of a table share a panel: to build one takes ten times as long as to try a parameter.
        const QByteArray before = std::exchange(m_function, QTest::currentTestFunction());
        const bool isShared = m_function == before && before.startsWith("every");
        if (!isShared) {
            m_panel.reset();
            m_preferences = std::make_unique<Preferences>();
            m_preferences->angleUnit.set(AngleUnit::Degrees);
            m_preferences->foldedGroups.set({});
            m_document = std::make_unique<Document>();
        }
        test::openNodes(*m_document,
                        {test::treeNode(1, "One"), test::treeNode(2, "Two"), test::groupNode(3, "Group")});
        if (isShared)
            return;
        m_panel = std::make_unique<PropertiesPanel>(m_document.get(), m_preferences.get());
        m_panel->resize(380, 900);
        m_panel->show();
        QVERIFY(QTest::qWaitForWindowActive(m_panel.get()));
        showAdvanced();
    }
    void refusedTextsSayWhy()
    {
        ParamRow* row = m_panel->row(param("turtle.alpha"));
        auto* field = row->findChild<NumberField*>();
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, "long");
        QTest::keyClick(field, Qt::Key_Return);
        QVERIFY(!row->message().isEmpty());
        QCOMPARE(m_document->undoStack()->count(), 0);
        QTest::keyClick(field, Qt::Key_Escape);
        QVERIFY(row->message().isEmpty());
    }

    void textsThatAreNoColourSayWhy()
    {
        openBoxes();
        ParamRow* row = m_panel->row(param("surface.color"));
        auto* editor = row->findChild<ColorEditor*>();
        for (const char* text : {"red", "#12", "#12345", "#gggggg", "123456 7"}) {
            test::typeLine(editor, text);
            QVERIFY2(row->message().contains(QLatin1String(text).left(7)), text);
            QCOMPARE(m_document->undoStack()->count(), 0);
            QCOMPARE(editor->findChild<QLineEdit*>()->text(), QStringLiteral("#b8b8b8"));
        }
        test::typeLine(editor, "f00");
        QVERIFY(row->message().isEmpty());
        QVERIFY(valueOf(*m_document, 1, row->def()) == ParamValue(glm::dvec3(1.0, 0.0, 0.0)));
    }

    void aColourTriedAndGivenUpLeavesNothing()
    {
        openBoxes();
        ParamRow* row = m_panel->row(param("surface.color"));
        auto* editor = row->findChild<ColorEditor*>();
        const ParamValue before = valueOf(*m_document, 1, row->def());
        QTest::mouseClick(editor->findChild<QAbstractButton*>(), Qt::LeftButton);
        editor->dialog()->setCurrentColor(Qt::green);
        QVERIFY(valueOf(*m_document, 1, row->def()) == ParamValue(glm::dvec3(0.0, 1.0, 0.0)));
        editor->dialog()->reject();
        QVERIFY(valueOf(*m_document, 1, row->def()) == before);
        QCOMPARE(m_document->undoStack()->count(), 0);
    }

    void numbersOutsideTheRangeSayWhichIsTaken()
    {
        const ParamDef& def = param("sections.lengthDivisions");
        ParamRow* row = m_panel->row(def);
        auto* field = row->findChild<NumberField*>();
        const auto type = [field](const char* text) {
            field->setFocus();
            field->selectAll();
            QTest::keyClicks(field, QLatin1String(text));
            QTest::keyClick(field, Qt::Key_Return);
        };
        type("1000");
        QVERIFY(valueOf(*m_document, 1, def) == ParamValue(std::int64_t{64}));
        QCOMPARE(row->message(), QStringLiteral("The largest is 64"));
        type("1");
        QCOMPARE(row->message(), QStringLiteral("The smallest is 2"));
        type("9");
        QVERIFY(row->message().isEmpty());
        type("1e999");
        QCOMPARE(row->message(), QStringLiteral("The number 1e999 is out of all range"));
        type("nan");
        QCOMPARE(row->message(), QStringLiteral("\"nan\" is neither a number nor a function"));
        QVERIFY(valueOf(*m_document, 1, def) == ParamValue(std::int64_t{9}));
    }

    void aValueThatReadsAsTheDefaultIsTheDefault()
    {
        const ParamDef& def = param("turtle.theta"); // 0.3142 rad, shown as 18.00°
        ParamRow* row = m_panel->row(def);
        auto* field = row->findChild<NumberField*>();
        const auto type = [field](const char* text) {
            field->setFocus();
            field->selectAll();
            QTest::keyClicks(field, QLatin1String(text));
            QTest::keyClick(field, Qt::Key_Return);
        };
        type("20");
        QVERIFY(row->isChanged());
        type("18 deg");
        QVERIFY(!row->isChanged());
        QVERIFY(valueOf(*m_document, 1, def) == defaultValue(def));
        // From elsewhere (a file, a script) a value may differ by less than is shown: then it is another one.
        QVERIFY(edit::setParam(*m_document, {1}, def, 0.1 * std::numbers::pi));
        QVERIFY(row->isChanged());
        row->resetButton()->click();
        QVERIFY(!row->isChanged());
    }

    void lockedNodesCannotBeChanged()
    {
        QVERIFY(edit::setNodeLocked(*m_document, {1}, true));
        const int steps = m_document->undoStack()->count();
        QVERIFY(!m_panel->row(param("turtle.alpha"))->editor()->isEnabled());
        QCOMPARE(m_document->undoStack()->count(), steps);
        QVERIFY(edit::setNodeLocked(*m_document, {1}, false));
        QVERIFY(m_panel->row(param("turtle.alpha"))->editor()->isEnabled());
    }

    void everyParamHasAnEditorAndATooltip_data() { addEveryParam(); }
    void everyParamHasAnEditorAndATooltip()
    {
        const ParamDef& def = fetched();
        ParamRow* row = m_panel->row(def);
        QVERIFY(row);
        QVERIFY(row->isVisibleTo(m_panel.get()));
        QVERIFY(row->editor()->focusProxy());
        QVERIFY(row->editor()->toolTip().contains(QLatin1String(def.key)));
        QVERIFY(row->editor()->toolTip().contains(QString::fromLatin1(def.label).toHtmlEscaped()));
        for (QWidget* widget : row->editor()->findChildren<QWidget*>()) {
            if (widget->focusPolicy() != Qt::NoFocus && widget->parentWidget() == row->editor())
                QVERIFY2(!widget->accessibleName().isEmpty(), widget->metaObject()->className());
        }
    }

    void everyParamChangesByKeysAndUndo_data() { addEveryParam(); }
    void everyParamChangesByKeysAndUndo()
    {
        const ParamDef& def = fetched();
        ParamRow* row = m_panel->row(def);
        const ParamValue before = valueOf(*m_document, 1, def);
        typeAnother(row);
        const ParamValue after = valueOf(*m_document, 1, def);
        QVERIFY2(after != before, formatValue(after).c_str());
        QCOMPARE(m_document->undoStack()->count(), 1);
        QCOMPARE(row->isChanged(), after != defaultValue(def));
        m_document->undo();
        QVERIFY(valueOf(*m_document, 1, def) == before);
        m_document->redo();
        QVERIFY(valueOf(*m_document, 1, def) == after);
    }

    void everyNumberStepsByArrowKeys_data() { addEveryParam(); }
    void everyNumberStepsByArrowKeys()
    {
        const ParamDef& def = fetched();
        ParamRow* row = m_panel->row(def);
        const ParamValue before = valueOf(*m_document, 1, def);
        int steps = 0;
        const auto changes = [&](QWidget* widget, Qt::Key key, Qt::Key other) {
            widget->setFocus();
            QTest::keyClick(widget, key);
            if (valueOf(*m_document, 1, def) == before)
                QTest::keyClick(widget, other); // it stood at the end of its range
            const bool changed = valueOf(*m_document, 1, def) != before;
            widget->clearFocus();
            if (changed) {
                ++steps;
                m_document->undo();
            }
            return changed && valueOf(*m_document, 1, def) == before;
        };
        for (NumberField* field : row->findChildren<NumberField*>())
            QVERIFY2(changes(field, Qt::Key_Up, Qt::Key_Down), qPrintable(field->accessibleName()));
        for (NumberSlider* slider : row->findChildren<NumberSlider*>())
            QVERIFY2(changes(slider, Qt::Key_Right, Qt::Key_Left), qPrintable(slider->accessibleName()));
        for (QComboBox* box : row->findChildren<QComboBox*>())
            QVERIFY2(changes(box, Qt::Key_Down, Qt::Key_Up), qPrintable(box->accessibleName()));
        const bool isColor = (def.flags & paramColor) != 0; // typed, or chosen in its dialog
        const bool isNumber = def.type != ParamType::Text && def.type != ParamType::Bool && !isColor;
        QCOMPARE(steps > 0, isNumber);
        QCOMPARE(def.type != ParamType::Vec3 || isColor || steps == 3, true); // each axis
    }

    void everyParamChangesByMouseInOneStep_data() { addEveryParam(); }
    void everyParamChangesByMouseInOneStep()
    {
        const ParamDef& def = fetched();
        const ParamValue before = valueOf(*m_document, 1, def);
        if (def.type == ParamType::Text)
            cutByMouse(m_panel->row(def), def);
        else
            changeByMouse(m_panel->row(def));
        QVERIFY(valueOf(*m_document, 1, def) != before);
        QCOMPARE(m_document->undoStack()->count(), 1);
        m_document->undo();
        QVERIFY(valueOf(*m_document, 1, def) == before);
    }

    void everyParamIsResetByItsArrow_data() { addEveryParam(); }
    void everyParamIsResetByItsArrow()
    {
        const ParamDef& def = fetched();
        ParamRow* row = m_panel->row(def);
        QVERIFY(row->resetButton()->isHidden() == !row->isChanged());
        typeAnother(row);
        if (!row->isChanged())
            typeAnother(row, 0.75);
        row->resetButton()->click();
        QVERIFY(valueOf(*m_document, 1, def) == defaultValue(def));
        QVERIFY(!row->isChanged());
        QVERIFY(row->resetButton()->isHidden());
    }

    void everyParamOfManyNodesIsSetAtOnce_data() { addEveryParam(); }
    void everyParamOfManyNodesIsSetAtOnce()
    {
        const ParamDef& def = fetched();
        Selection both;
        both.nodes = {1, 2};
        m_document->setSelection(both);
        typeAnother(m_panel->row(def));
        QVERIFY(valueOf(*m_document, 1, def) == valueOf(*m_document, 2, def));
        QCOMPARE(m_document->undoStack()->count(), 1);
    }

    void everyParamWithDifferentValuesIsSetAndUndone_data() { addEveryParam(); }
    void everyParamWithDifferentValuesIsSetAndUndone()
    {
        const ParamDef& def = fetched();
        ParamRow* row = m_panel->row(def);
        typeAnother(row); // of the first node only
        if (valueOf(*m_document, 1, def) == valueOf(*m_document, 2, def))
            typeAnother(row, 0.75);
        const ParamValue first = valueOf(*m_document, 1, def), second = valueOf(*m_document, 2, def);
        Selection both;
        both.nodes = {1, 2};
        m_document->setSelection(both);
        QCOMPARE(m_document->undoStack()->count(), 1);
        if (auto* field = row->findChild<NumberField*>())
            QVERIFY(!field->value());
        else if (auto* box = row->findChild<QCheckBox*>())
            QCOMPARE(box->checkState(), Qt::PartiallyChecked);
        else if (auto* choice = row->findChild<QComboBox*>())
            QCOMPARE(choice->currentIndex(), -1);
        else if (auto* line = row->findChild<QLineEdit*>()) // of a colour, a picture or a profile
            QVERIFY(line->text().isEmpty());
        else
            QVERIFY(row->findChild<GrammarEdit*>()->toPlainText().isEmpty());
        row->editor()->focusProxy()->setFocus();
        const bool isVector = def.type == ParamType::Vec3 && !(def.flags & paramColor);
        if (isVector)
            QTest::keyClicks(row->findChild<NumberField*>(), "2");
        else
            typeAnother(row);
        if (isVector)
            QTest::keyClick(row->findChild<NumberField*>(), Qt::Key_Return);
        QVERIFY(!row->findChild<NumberField*>() || row->findChild<NumberField*>()->value());
        QCOMPARE(m_document->undoStack()->count(), 2);
        if (!isVector)
            QVERIFY(valueOf(*m_document, 1, def) == valueOf(*m_document, 2, def));
        m_document->undo();
        QVERIFY(valueOf(*m_document, 1, def) == first);
        QVERIFY(valueOf(*m_document, 2, def) == second);
    }

    void componentsOfManyNodesStayTheirOwn()
    {
        const ParamDef& def = param("tree.translation");
        QVERIFY(edit::setParam(*m_document, {2}, def, glm::dvec3(1.0, 2.0, 3.0)));
        Selection both;
        both.nodes = {1, 2};
        m_document->setSelection(both);
        const auto fields = m_panel->row(def)->findChildren<NumberField*>();
        QVERIFY(!fields[1]->value());
        fields[0]->setFocus();
        QTest::keyClicks(fields[0], "7");
        QTest::keyClick(fields[0], Qt::Key_Return);
        QVERIFY(valueOf(*m_document, 1, def) == ParamValue(glm::dvec3(7.0, 0.0, 0.0)));
        QVERIFY(valueOf(*m_document, 2, def) == ParamValue(glm::dvec3(7.0, 2.0, 3.0)));
    }

    void differentValuesAreShownAsADash()
    {
        QVERIFY(edit::setParam(*m_document, {2}, param("turtle.alpha"), 0.5));
        QVERIFY(edit::setParam(*m_document, {2}, param("simplify.enabled"), false));
        QVERIFY(edit::setParam(*m_document, {2}, param("grammar.axiom"), std::string("X")));
        Selection both;
        both.nodes = {1, 2};
        m_document->setSelection(both);
        QVERIFY(!m_panel->row(param("turtle.alpha"))->findChild<NumberField*>()->value());
        QCOMPARE(m_panel->row(param("simplify.enabled"))->findChild<QCheckBox*>()->checkState(),
                 Qt::PartiallyChecked);
        QVERIFY(m_panel->row(param("grammar.axiom"))->findChild<GrammarEdit*>()->toPlainText().isEmpty());
        QCOMPARE(m_document->undoStack()->count(), 3);
    }

    void kindsWithoutAParamDoNotShowIt()
    {
        Selection both;
        both.nodes = {1, 3};
        m_document->setSelection(both);
        QVERIFY(!m_panel->row(param("turtle.alpha"))->isVisibleTo(m_panel.get()));
        QVERIFY(m_panel->row(param("tree.translation"))->isVisibleTo(m_panel.get()));
        m_document->setSelection({});
        QVERIFY(m_panel->nodes().empty());
    }

    void sliderDragIsOneUndoStepAndTwoDragsAreTwo()
    {
        auto* slider = m_panel->row(param("turtle.theta"))->findChild<NumberSlider*>();
        for (int drag = 1; drag <= 2; ++drag) {
            test::drag(slider, {10 * drag, slider->height() / 2}, {60 + 5 * drag, slider->height() / 2});
            QCOMPARE(m_document->undoStack()->count(), drag);
        }
    }

    void anglesAreShownInTheUnitOfTheUser()
    {
        auto* field = m_panel->row(param("turtle.theta"))->findChild<NumberField*>();
        QVERIFY(edit::setParam(*m_document, {1}, param("turtle.theta"), std::numbers::pi / 6.0));
        QCOMPARE(field->text(), QStringLiteral("30.00°"));
        m_preferences->angleUnit.set(AngleUnit::Radians);
        QCOMPARE(field->text(), QStringLiteral("0.5236 rad"));
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, "18 deg");
        QTest::keyClick(field, Qt::Key_Return);
        QVERIFY(std::abs(std::get<double>(valueOf(*m_document, 1, param("turtle.theta"))) -
                         0.1 * std::numbers::pi) < 1e-12);
    }

    void groupsAreCopiedFromNodeToNode()
    {
        QVERIFY(edit::setParam(*m_document, {1}, param("turtle.alpha"), 0.37));
        QVERIFY(edit::setParam(*m_document, {1}, param("turtle.decay"), 0.77));
        auto* turtle = m_panel->findChild<GroupSection*>(QStringLiteral("group/Turtle"));
        emit turtle->copyRequested();
        Selection other;
        other.nodes = {2};
        m_document->setSelection(other);
        emit turtle->pasteRequested();
        QVERIFY(valueOf(*m_document, 2, param("turtle.alpha")) == ParamValue(0.37));
        QVERIFY(valueOf(*m_document, 2, param("turtle.decay")) == ParamValue(0.77));
        QCOMPARE(m_document->undoStack()->count(), 3);
        emit turtle->resetRequested();
        QVERIFY(valueOf(*m_document, 2, param("turtle.alpha")) == defaultValue(param("turtle.alpha")));
        QGuiApplication::clipboard()->setText(QStringLiteral("{}"));
        emit turtle->pasteRequested();
        QCOMPARE(m_document->undoStack()->count(), 4);
        QVERIFY(!turtle->rows().front()->message().isEmpty());
    }

    void foldsAreRemembered()
    {
        auto* turtle = m_panel->findChild<GroupSection*>(QStringLiteral("group/Turtle"));
        turtle->findChild<QToolButton*>(QStringLiteral("groupHeading"))->click();
        QVERIFY(!m_panel->row(param("turtle.alpha"))->isVisibleTo(m_panel.get()));
        PropertiesPanel another(m_document.get(), m_preferences.get());
        QVERIFY(another.findChild<GroupSection*>(QStringLiteral("group/Turtle"))->isFolded());
        m_panel->showParam(QStringLiteral("turtle.alpha"));
        QVERIFY(m_panel->row(param("turtle.alpha"))->isVisibleTo(m_panel.get()));
    }

    void grammarErrorsStandAtTheirPlace()
    {
        NodeResult result;
        Error error;
        error.code = ErrorCode::Syntax;
        error.text = "all probabilities of the rule are zero";
        error.path = "grammar.rules";
        error.line = 2;
        error.column = 6;
        result.revision = m_document->revision();
        result.error = error;
        m_document->setResult(1, result);
        ParamRow* row = m_panel->row(param("grammar.rules"));
        QVERIFY2(row->message().contains(QStringLiteral("ine 2, column 6")), qPrintable(row->message()));
        const auto* text = row->findChild<GrammarEdit*>();
        const int line = static_cast<int>(text->toPlainText().indexOf(u'\n')) + 1;
        QCOMPARE(text->problemRange(), std::pair(line + 5, line + 6));
        m_document->setResult(1, {});
        QVERIFY(row->message().isEmpty());
        QCOMPARE(text->problemRange().first, -1);
    }

    void tabReachesEveryEditor()
    {
        Node tree = test::treeNode(1, "Tree");
        tree.params.leaf.shape = LeafShape::Birch;
        tree.params.bark.family = BarkFamily::Ringed;
        test::openNodes(*m_document, {tree});
        showAdvanced();
        QSet<QWidget*> reached;
        QWidget* start = m_panel->findChild<QLineEdit*>();
        start->setFocus();
        for (int i = 0; i < 500; ++i) {
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
            if (QApplication::focusWidget() == start)
                break;
            reached += QApplication::focusWidget();
        }
        for (const ParamDef& def : paramTable()) {
            if (!hasParam(NodeKind::Tree, def) || !acts(tree.params, def))
                continue;
            const bool hit = std::ranges::any_of(
                reached, [&](QWidget* widget) { return m_panel->row(def)->editor()->isAncestorOf(widget); });
            QVERIFY2(hit, def.key);
        }
    }

    /// Between two keys it is a part of a day.
    void theDateIsThatOfTheDayInTheField()
    {
        const ParamDef& day = *findParam("season.day");
        QCOMPARE(numberFormat(day, AngleUnit()).text(82.9), QStringLiteral("83"));
        QCOMPARE(paramMeaning(day, 82.9), paramMeaning(day, 83.0));
        QVERIFY(paramMeaning(day, 82.9) != paramMeaning(day, 82.0));
    }
};

RAMURE_SUITE(TestPropertiesPanel)
} // namespace tst_properties_panel
#include "tst_properties_panel.moc"
