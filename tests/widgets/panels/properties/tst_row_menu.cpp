#include "core/scene/preset_scene.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/base/fields/number_field.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/panels/properties/grammar/grammar_edit.h"
#include "widgets/panels/properties/group_clipboard.h"
#include "widgets/panels/properties/param_row.h"
#include "widgets/panels/properties/properties_panel.h"
#include <QClipboard>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QToolButton>
#include <numbers>

namespace tst_row_menu {

using namespace ramure;

/// What the mouse does to a row: its menu, and dragging its label.
class TestRowMenu : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;
    std::unique_ptr<Preferences> m_preferences;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<PropertiesPanel> m_panel;

    ParamRow* row(const char* key) { return m_panel->row(*findParam(key)); }
    const NodeParams& params() { return m_document->scene().nodes().front().params; }
    static QString clipboard() { return QGuiApplication::clipboard()->text(); }

    /// Chooses from the menu of a right click on \p widget of the row; \p text is the beginning of the item.
    void choose(QWidget* widget, const char* text)
    {
        const QPoint at(5, 5);
        QContextMenuEvent event(QContextMenuEvent::Mouse, at, widget->mapToGlobal(at));
        QCoreApplication::sendEvent(widget, &event);
        auto* menu = m_panel->findChild<QMenu*>(QStringLiteral("rowMenu"));
        QVERIFY(menu && menu->isVisible());
        for (QAction* action : menu->actions()) {
            if (!action->text().startsWith(QLatin1String(text)))
                continue;
            QVERIFY(action->isEnabled());
            action->trigger();
            delete menu;
            return;
        }
        QFAIL(text);
    }

private slots:
    void init()
    {
        test::failOnWidgetWarning();
        m_preferences = std::make_unique<Preferences>();
        m_document = std::make_unique<Document>();
        m_panel = std::make_unique<PropertiesPanel>(m_document.get(), m_preferences.get());
        m_panel->resize(360, 700);
        m_panel->show();
        Node tree = *presetTree("FanTree");
        tree.id = 1;
        test::openNodes(*m_document, {tree});
    }
    void cleanup()
    {
        m_panel.reset();
        m_document.reset();
        m_preferences.reset();
    }

    void resetsCopiesAndPastes()
    {
        ParamRow* theta = row("turtle.theta");
        choose(theta, "Copy value");
        QCOMPARE(clipboard(), QStringLiteral("0.15 rad"));
        QVERIFY(edit::setParam(*m_document, {1}, theta->def(), 1.0));
        choose(theta, "Paste value");
        QCOMPARE(params().turtle.theta, 0.15);
        QCOMPARE(m_document->undoStack()->count(), 2);
        QVERIFY(edit::setParam(*m_document, {1}, theta->def(), 1.0));
        choose(theta->findChild<NumberField*>(), "Back to"); // a click on the number is one on the row
        QCOMPARE(params().turtle.theta, 0.15);
    }

    void anyTextIsPasted()
    {
        const std::tuple<const char*, const char*, ParamValue> cases[] = {
            {"turtle.theta", "18 deg", std::numbers::pi / 10},
            {"turtle.theta", "30", std::numbers::pi / 6}, // in the unit that is shown
            {"turtle.alpha", "20cm + 5mm", 0.205},
            {"mesh.forkSoftness", "10 %", 0.1},
            {"grammar.iterations", "7", std::int64_t{7}},
            {"simplify.enabled", "false", false},
            {"tree.translation", "1,2,3", glm::dvec3(1, 2, 3)},
            {"grammar.axiom", "A\\B", std::string("A\\B")},
        };
        for (const auto& [key, text, expected] : cases) {
            QGuiApplication::clipboard()->setText(QLatin1String(text));
            choose(row(key), "Paste value");
            const ParamValue value = findParam(key)->get(params());
            if (const auto* real = std::get_if<double>(&expected))
                QVERIFY2(std::abs(std::get<double>(value) - *real) < 1e-12, text);
            else
                QVERIFY2(value == expected, text);
        }
    }

    void whatDoesNotFitIsRefused()
    {
        const QByteArray before = writeProject(m_document->project());
        for (const char* text :
             {"cats", "", "{\"ramure-parameters\": {\"turtle.alpha\": \"1\", \"turtle.decay\": \"1\"}}"}) {
            QGuiApplication::clipboard()->setText(QLatin1String(text));
            choose(row("turtle.theta"), "Paste value");
            QVERIFY2(!row("turtle.theta")->message().isEmpty(), text);
        }
        QGuiApplication::clipboard()->setText(QStringLiteral("1000"));
        choose(row("sections.radialDivisions"), "Paste value");
        QVERIFY(!row("sections.radialDivisions")->message().isEmpty());
        QCOMPARE(writeProject(m_document->project()), before);
    }

    void valuesOfTheSameTypeFitEachOther()
    {
        QVERIFY(edit::setParam(*m_document, {1}, *findParam("tree.scale"), glm::dvec3(1, 2, 3)));
        choose(row("tree.scale"), "Copy value");
        QCOMPARE(clipboard(), QStringLiteral("1,2,3"));
        choose(row("tree.translation"), "Paste value");
        QCOMPARE(params().tree.translation, glm::dvec3(1, 2, 3));
    }

    void settingsAreForTheCommandLine()
    {
        choose(row("turtle.theta"), "Copy as --set");
        QCOMPARE(clipboard(), QStringLiteral("--set turtle.theta=0.15"));
        const ParamDef& rules = *findParam("grammar.rules");
        QCOMPARE(settingText(rules, std::string("A -> \\B'\n")),
                 QStringLiteral("--set 'grammar.rules=A -> \\\\B'\\''\\n'"));
        for (const ParamDef& def : paramTable()) { // what is copied reads back
            const ParamValue value = def.get(params());
            QString text = settingText(def, value).mid(6);
            if (text.startsWith(u'\''))
                text = text.mid(1, text.size() - 2).replace(QStringLiteral("'\\''"), QStringLiteral("'"));
            const auto back = parseValue(def, text.section(u'=', 1).toStdString(), true);
            QVERIFY2(back && *back == value, def.key);
        }
    }

    void draggingTheLabelIsOneStep()
    {
        auto* label = row("turtle.theta")->findChild<QLabel*>();
        test::drag(label, {10, 8}, {70, 8});
        QVERIFY(params().turtle.theta > 0.15);
        QCOMPARE(m_document->undoStack()->count(), 1);
        test::drag(label, {10, 8}, {70, 8});
        QCOMPARE(m_document->undoStack()->count(), 2);
        m_document->undo();
        m_document->undo();
        QCOMPARE(params().turtle.theta, 0.15);
        auto* letter = row("tree.translation")->findChild<QLabel*>(QStringLiteral("axisY"));
        test::drag(letter, {2, 8}, {62, 8});
        QVERIFY(params().tree.translation.y > 0.0 && params().tree.translation.x == 0.0);
        QCOMPARE(m_document->undoStack()->count(), 1);
    }

    void errorsOfRulesMoveNoRow()
    {
        ParamRow* rules = row("grammar.rules");
        const auto below = [this] {
            for (int i = 0; i < 5; ++i) // every layout asks the one above it
                QCoreApplication::sendPostedEvents();
            return row("grammar.iterations")->mapTo(m_panel.get(), QPoint()).y();
        };
        QVERIFY(QTest::qWaitForWindowExposed(m_panel.get()));
        const int place = below();
        rules->findChild<GrammarEdit*>()->setPlainText(QStringLiteral("A -> [B\n").repeated(20));
        Error error;
        error.code = ErrorCode::Syntax;
        error.text = "a closing bracket is missing";
        error.path = "grammar.rules";
        error.line = 2;
        rules->showProblem(error);
        QVERIFY(!rules->message().isEmpty());
        QCOMPARE(below(), place);
    }
};

RAMURE_SUITE(TestRowMenu)

} // namespace tst_row_menu

#include "tst_row_menu.moc"
