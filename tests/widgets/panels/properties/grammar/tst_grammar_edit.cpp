#include "tests/widgets/base/fixture.h"
#include "widgets/panels/properties/grammar/grammar_edit.h"
#include "widgets/panels/properties/grammar/height_grip.h"
#include <QAbstractItemView>
#include <QCompleter>
#include <QLabel>
#include <QTextBlock>
#include <QTextLayout>

namespace tst_grammar_edit {

using namespace ramure;

class TestGrammarEdit : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnWidgetWarning(); }

    void placesThatDoNotExistMarkNothing()
    {
        GrammarEdit edit(GrammarText::Rules, nullptr);
        edit.showText(QStringLiteral("A -> B\nB -> C"));
        for (const auto& [line, column] : {std::pair{0, 0}, {0, 5}, {7, 1}, {-1, 2}}) {
            edit.showProblem(line, column);
            QCOMPARE(edit.problemRange(), std::pair(-1, -1));
        }
    }

    void problemsAreUnderlinedAtTheirBytes()
    {
        GrammarEdit edit(GrammarText::Rules, nullptr);
        // "é" and "→" take two and three bytes, one character each.
        edit.showText(QStringLiteral("# été →x\nA -> [B"));
        edit.showProblem(1, 12);
        QCOMPARE(edit.problemRange(), std::pair(7, 8));
        QCOMPARE(edit.toPlainText().mid(7, 1), QStringLiteral("x"));
        edit.showProblem(2, 6);
        QCOMPARE(edit.problemRange(), std::pair(14, 15));
        edit.showProblem(2, 100); // behind the end: the last character
        QCOMPARE(edit.problemRange(), std::pair(15, 16));
        edit.showProblem(2, 0);
        QCOMPARE(edit.problemRange(), std::pair(9, 16));
        edit.showProblem(0, 0);
        QCOMPARE(edit.problemRange(), std::pair(-1, -1));
    }

    void bracketsFindTheirPartner()
    {
        const QString text = QStringLiteral("[a[b]`]c]\n]");
        QCOMPARE(matchingBracket(text, 0), 8);
        QCOMPARE(matchingBracket(text, 8), 0);
        QCOMPARE(matchingBracket(text, 2), 4);
        QCOMPARE(matchingBracket(text, 6), -1);  // escaped
        QCOMPARE(matchingBracket(text, 10), -1); // another line
        QCOMPARE(matchingBracket(text, 1), -1);
        QCOMPARE(matchingBracket(text, -1), -1);
        QCOMPARE(matchingBracket(text, 99), -1);
    }

    void modulesAreColoured()
    {
        GrammarEdit edit(GrammarText::Rules, nullptr);
        edit.showText(QStringLiteral("A(l) : l > r -> [+(45)F(l*r)] # twig"));
        edit.setDialect(GrammarDialect::Parametric, {});
        const auto colour = [&edit](qsizetype at) {
            for (const auto& range : edit.document()->firstBlock().layout()->formats())
                if (at >= range.start && at < range.start + range.length)
                    return range.format.foreground().color();
            return QColor();
        };
        const QString text = edit.toPlainText();
        const QColor number = colour(text.indexOf(u'4')), name = colour(text.indexOf(QLatin1String("l*r")));
        QVERIFY(number.isValid() && name.isValid() && number != name);
        QCOMPARE(colour(text.indexOf(QLatin1String("r ->"))), name); // in the condition
        QVERIFY(colour(text.indexOf(u'[')) != colour(text.indexOf(u'F')));
        const QColor comment = colour(text.indexOf(u'#'));
        QCOMPARE(colour(text.size() - 1), comment);
        edit.setDialect(GrammarDialect::Classic, {});
        QVERIFY(colour(text.size() - 1) != comment);
    }

    void namesAreCompletedInExpressions()
    {
        GrammarEdit edit(GrammarText::Rules, nullptr);
        edit.show();
        edit.setDialect(GrammarDialect::Parametric, {QStringLiteral("ratio"), QStringLiteral("rand(")});
        const auto* completer = edit.findChild<QCompleter*>();
        QTest::keyClicks(&edit, QStringLiteral("A -> ra"));
        QVERIFY(!completer->popup()->isVisible()); // modules are letters, not words
        QTest::keyClicks(&edit, QStringLiteral("F(rat"));
        QTRY_VERIFY(completer->popup()->isVisible());
        QTest::keyClick(completer->popup(), Qt::Key_Return);
        QCOMPARE(edit.toPlainText(), QStringLiteral("A -> raF(ratio"));
        QVERIFY(!completer->popup()->isVisible());
    }

    void showingATextIsNoEdit()
    {
        GrammarEdit edit(GrammarText::Rules, nullptr);
        QSignalSpy edited(&edit, &GrammarEdit::edited);
        edit.showText(QStringLiteral("A -> BB"));
        QCOMPARE(edited.count(), 0);
        QTest::keyClicks(&edit, "x");
        QCOMPARE(edited.count(), 1);
    }

    void theCursorStaysWhereItWas()
    {
        GrammarEdit edit(GrammarText::Rules, nullptr);
        edit.showText(QStringLiteral("A -> BB"));
        QTextCursor cursor = edit.textCursor();
        cursor.setPosition(5);
        edit.setTextCursor(cursor);
        edit.showText(QStringLiteral("A -> BBBB"));
        QCOMPARE(edit.textCursor().position(), 5);
        edit.showText(QStringLiteral("A"));
        QCOMPARE(edit.textCursor().position(), 1);
    }

    void axiomsHaveOneLine()
    {
        GrammarEdit edit(GrammarText::Axiom, nullptr);
        QTest::keyClicks(&edit, "AB");
        QTest::keyClick(&edit, Qt::Key_Return);
        QCOMPARE(edit.toPlainText(), QStringLiteral("AB"));
        QGuiApplication::clipboard()->setText(QStringLiteral("C\nD\r\nE"));
        edit.paste();
        QCOMPARE(edit.toPlainText(), QStringLiteral("ABCDE"));
    }

    void gesturesBreakWhereTypingPauses()
    {
        GrammarEdit edit(GrammarText::Rules, nullptr);
        QSignalSpy broken(&edit, &GrammarEdit::gestureBroken);
        QTest::keyClicks(&edit, "A -> B");
        QCOMPARE(broken.count(), 0);
        QTest::keyClick(&edit, Qt::Key_Backspace);
        QCOMPARE(broken.count(), 1);
        QTest::keyClick(&edit, Qt::Key_Backspace);
        QCOMPARE(broken.count(), 1);
        QTest::keyClicks(&edit, "C");
        QCOMPARE(broken.count(), 2);
        QTest::keyClick(&edit, Qt::Key_Return);
        QCOMPARE(broken.count(), 3);
        QTest::keyClick(&edit, Qt::Key_Left);
        QCOMPARE(broken.count(), 4);
    }

    void undoBelongsToTheDocument()
    {
        GrammarEdit edit(GrammarText::Rules, nullptr);
        QTest::keyClicks(&edit, "AB");
        QKeyEvent undo(QEvent::ShortcutOverride, Qt::Key_Z, Qt::ControlModifier);
        undo.setAccepted(false);
        QCoreApplication::sendEvent(&edit, &undo);
        QVERIFY(!undo.isAccepted());
        QVERIFY(!edit.isUndoRedoEnabled());
    }

    void neitherTextNorErrorsChangeItsHeight()
    {
        GrammarEdit edit(GrammarText::Rules, nullptr);
        edit.resize(300, edit.height());
        edit.show();
        const int height = edit.height();
        for (const int lines : {1, 8, 1000}) {
            edit.showText(QStringLiteral("A -> B\n").repeated(lines));
            QCOMPARE(edit.height(), height);
        }
        const int text = edit.viewport()->height();
        edit.showMessage(
            QStringLiteral("Line 2, column 3: a closing bracket is missing here, or one too many is there"));
        QCOMPARE(edit.height(), height);
        const auto* message = edit.findChild<QLabel*>(QStringLiteral("problem"));
        QVERIFY(message->isVisible() && edit.rect().contains(message->geometry()));
        QCOMPARE(edit.viewport()->geometry().bottom() + 1, message->y()); // no line lies below it
        edit.showMessage({});
        QCOMPARE(edit.viewport()->height(), text);
    }

    void theGripMakesItHigher()
    {
        QWidget page;
        GrammarEdit edit(GrammarText::Rules, &page);
        HeightGrip grip(&edit, &page);
        page.show();
        const int lines = edit.lines(), height = edit.height();
        test::drag(&grip, {20, 3}, {20, 3 + 4 * edit.fontMetrics().lineSpacing()});
        QCOMPARE(edit.lines(), lines + 4);
        QVERIFY(edit.height() > height);
        QTest::mouseDClick(&grip, Qt::LeftButton);
        QCOMPARE(edit.height(), height);
        test::drag(&grip, {20, 3}, {20, -5000});
        QCOMPARE(edit.lines(), 1);
    }
};

RAMURE_SUITE(TestGrammarEdit)

} // namespace tst_grammar_edit

#include "tst_grammar_edit.moc"
