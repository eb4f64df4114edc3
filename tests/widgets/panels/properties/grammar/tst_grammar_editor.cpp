#include "tests/widgets/base/fixture.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/panels/properties/grammar/grammar_edit.h"
#include "widgets/panels/properties/param_row.h"
#include "widgets/panels/properties/properties_panel.h"
#include <QLabel>
#include <QPushButton>

namespace tst_grammar_editor {

using namespace ramure;

/// The remarks of the grammar's editors, in the panel that they belong to.
class TestGrammarEditor : public QObject
{
    Q_OBJECT

    test::OwnSettings m_settings;
    std::unique_ptr<Preferences> m_preferences;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<PropertiesPanel> m_panel;

    [[nodiscard]] GrammarEdit* edit(const char* key) const
    {
        return m_panel->row(*findParam(key))->findChild<GrammarEdit*>();
    }
    [[nodiscard]] QString message(const char* key) const
    {
        const auto* label = edit(key)->findChild<QLabel*>();
        return label->isHidden() ? QString() : label->text();
    }
    [[nodiscard]] QPushButton* button(const char* key) const
    {
        auto* found = edit(key)->findChild<QPushButton*>();
        return found->isHidden() ? nullptr : found;
    }
    [[nodiscard]] const GrammarParams& grammar() const { return m_document->scene().find(1)->params.grammar; }
    void open(const char* axiom, const char* rules, GrammarDialect dialect = GrammarDialect::Classic)
    {
        Node tree = test::treeNode(1, "Tree");
        tree.params.grammar.axiom = axiom;
        tree.params.grammar.rules = rules;
        tree.params.grammar.dialect = dialect;
        test::openNodes(*m_document, {tree});
    }

private slots:
    void init()
    {
        test::failOnWidgetWarning();
        m_preferences = std::make_unique<Preferences>();
        m_document = std::make_unique<Document>();
        m_panel = std::make_unique<PropertiesPanel>(m_document.get(), m_preferences.get());
        m_panel->resize(320, 900);
        m_panel->show();
    }
    void cleanup() { m_panel.reset(); }

    void plainTextsHaveNoRemarks()
    {
        open("EEBA", "A -> [+B]A");
        for (const char* key : {"grammar.axiom", "grammar.rules"}) {
            QVERIFY(message(key).isEmpty() && !button(key));
            QCOMPARE(edit(key)->problemRange(), std::pair(-1, -1));
        }
    }

    void lookalikesAreReplacedInOneStep()
    {
        const char* rules = "A -> [+B]A\nB -> [\u2212A]\u00A0\u2013B";
        open("EEBA", rules);
        QVERIFY(message("grammar.axiom").isEmpty() && !button("grammar.axiom"));
        const QString said = message("grammar.rules");
        QVERIFY2(said.contains(QStringLiteral("\u2212")) && said.contains(QStringLiteral("U+2212")) &&
                     said.contains(QStringLiteral("2")) && said.contains(QStringLiteral("more")),
                 qPrintable(said));
        const int minus = static_cast<int>(edit("grammar.rules")->toPlainText().indexOf(QChar(0x2212)));
        QCOMPARE(edit("grammar.rules")->problemRange(), std::pair(minus, minus + 1));
        QPushButton* replace = button("grammar.rules");
        QVERIFY(replace && !replace->text().isEmpty() && !replace->toolTip().isEmpty());
        QVERIFY(edit("grammar.rules")
                    ->rect()
                    .contains(QRect(replace->mapTo(edit("grammar.rules"), QPoint()), replace->size())));

        const int steps = m_document->undoStack()->count();
        replace->setFocus(); // by keyboard
        QTest::keyClick(replace, Qt::Key_Space);
        QCOMPARE(grammar().rules, std::string("A -> [+B]A\nB -> [-A] -B"));
        QCOMPARE(m_document->undoStack()->count(), steps + 1);
        QVERIFY(message("grammar.rules").isEmpty() && !button("grammar.rules"));
        m_document->undo();
        QCOMPARE(grammar().rules, std::string(rules));
        QVERIFY(!message("grammar.rules").isEmpty() && button("grammar.rules"));
    }

    void commandsThatAreCommentsAreRemarked()
    {
        open("A", "#ignore: +-\nA -> B");
        QVERIFY(message("grammar.rules").contains(QStringLiteral("#ignore")));
        QVERIFY(!button("grammar.rules")); // there is nothing to replace
    }

    void errorsOfTheOtherLanguageAreReplacedToo()
    {
        open("A", "A -> F\uFF3BA]", GrammarDialect::Parametric);
        NodeResult result;
        Error error;
        error.text = "wrong";
        error.path = "grammar.rules";
        error.line = 1;
        error.column = 7;
        result.revision = m_document->revision();
        result.error = error;
        m_document->setResult(1, result);
        QVERIFY(message("grammar.rules").contains(QStringLiteral("rong"))); // the error, not the remark
        QVERIFY(button("grammar.rules"));
        button("grammar.rules")->click();
        QCOMPARE(grammar().rules, std::string("A -> F[A]"));
    }

    void nodesThatDifferHaveNoRemarks()
    {
        Node one = test::treeNode(1, "One"), two = test::treeNode(2, "Two");
        one.params.grammar.axiom = "A\u2212B";
        test::openNodes(*m_document, {one, two});
        QVERIFY(button("grammar.axiom"));
        Selection both;
        both.nodes = {1, 2};
        m_document->setSelection(both);
        QVERIFY(!button("grammar.axiom") && message("grammar.axiom").isEmpty());
    }
};

RAMURE_SUITE(TestGrammarEditor)

} // namespace tst_grammar_editor

#include "tst_grammar_editor.moc"
