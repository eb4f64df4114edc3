#include "core/io/csv_table.h"
#include "tests/support/suite.h"
#include <QTemporaryDir>

namespace tst_csv_table {

using namespace ramure;
using namespace std::string_literals;

/// Tables with commas: what is refused and where, and what RFC 4180 allows.
class TestCsvTable : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void badTables_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("message");
        const auto row = [](const char* name, const QByteArray& text, const char* message) {
            QTest::newRow(name) << text << QString::fromUtf8(message);
        };
        row("empty file", "", "t.csv: no columns: the first line names them");
        row("only a mark", "\xEF\xBB\xBF", "t.csv: no columns: the first line names them");
        row("only blank lines", "\n\r\n\n", "t.csv: no columns: the first line names them");
        row("quote not closed", "a,b\n1,2\n3,\"4\n5,6\n", "t.csv:3: a quote that is not closed");
        row("quote at the end", "a\n\"", "t.csv:2: a quote that is not closed");
        row("quote inside a cell", "a,b\n1,2\"3\n",
            "t.csv:2: a quote inside a cell: the whole cell has to be quoted");
        row("text behind a quote", "a,b\n\"1\"2,3\n",
            "t.csv:2: text behind a quoted cell: a separator expected");
        row("space behind a quote", "a,b\n\"1\" ,3\n",
            "t.csv:2: text behind a quoted cell: a separator expected");
        row("column without a name", "a,,c\n1,2,3\n", "t.csv:1: column 2 has no name");
        row("first column without a name", ",b\n1,2\none,3\n", "t.csv:1: column 1 has no name");
        row("column of blanks", "a, \t,c\n1,2,3\n", "t.csv:1: column 2 has no name");
        row("a value behind the columns", "a,b,\n1,2,\n1,2,3\n", "t.csv:1: column 3 has no name");
        row("column twice but for blanks", "a, a\n", "t.csv:1: column \"a\" is there twice");
        row("column twice", "a,b,a\n", "t.csv:1: column \"a\" is there twice");
        row("column twice below blank lines", "\n\nb,b\n", "t.csv:3: column \"b\" is there twice");
        row("short row", "a,b\n1,2\n3\n", "t.csv:3: 1 cells, and there are 2 columns");
        row("long row", "a,b\n1,2,3\n", "t.csv:2: 3 cells, and there are 2 columns");
        row("comma behind a row", "a,b\n1,2,\n", "t.csv:2: 3 cells, and there are 2 columns");
        row("short row behind a cell of lines", "a,b\n\"1\n\n1\",2\n3\n",
            "t.csv:5: 1 cells, and there are 2 columns");
        row("semicolons above commas", "a;b\n1,2\n", "t.csv:2: 1 cells, and there are 2 columns");
        row("old Macintosh", "a,b\r1,2\r3\r", "t.csv:3: 1 cells, and there are 2 columns");
        row("a cell of old Macintosh lines", "a,b\r\"1\r\r1\",2\r3\r",
            "t.csv:5: 1 cells, and there are 2 columns");
        row("Latin-1", "a,b\n1,2\n3,\xE9t\xE9\n",
            "t.csv:3: column \"b\": bytes that are no text in UTF-8 or UTF-16");
        row("Latin-1 in a name", "a,\xE9\n1,2\n",
            "t.csv:1: column \"2\": bytes that are no text in UTF-8 or UTF-16");
        row("torn UTF-16",
            QByteArray("\xFF\xFE"
                       "a\0,",
                       5),
            "t.csv: this is neither UTF-8 nor whole UTF-16");
        row("half a pair in UTF-16",
            QByteArray("\xFF\xFE"
                       "a\0\x00\xD8",
                       6),
            "t.csv: this is neither UTF-8 nor whole UTF-16");
        row("a second half alone",
            QByteArray("\xFF\xFE"
                       "a\0\x00\xDC"
                       "b\0",
                       8),
            "t.csv: this is neither UTF-8 nor whole UTF-16");
    }
    void badTables()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, message);
        const auto table = parseCsv(text.toStdString(), "t.csv");
        QVERIFY(!table);
        QCOMPARE(QString::fromStdString(table.error().message()), message);
    }

    void aFileThatIsNotThere()
    {
        const QTemporaryDir folder;
        const auto table = readCsv(folder.filePath("none.csv").toStdString());
        QVERIFY(!table);
        QCOMPARE(table.error().code, ErrorCode::Io);
    }

    /// Not one look at all names for each of them.
    void aMillionColumns()
    {
        std::string head, row;
        for (int i = 0; i < 1'000'000; ++i) {
            head += (i > 0 ? ",c" : "c") + std::to_string(i);
            row += i > 0 ? ",1" : "1";
        }
        const auto table = parseCsv(head + '\n' + row + '\n', "t.csv");
        QVERIFY2(table.has_value(), test::why(table));
        QCOMPARE(table->columns.size(), std::size_t(1'000'000));
        QCOMPARE(table->columns.back(), "c999999"s);
        QCOMPARE(table->rows.front().cells.size(), std::size_t(1'000'000));
        const auto twice = parseCsv(head + ",c777\n", "t.csv");
        QVERIFY(!twice);
        QVERIFY(twice.error().message().find("\"c777\"") != std::string::npos);
    }

    void goodTables_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("plain") << QByteArray("a,b\n1,2\n3,4\n");
        QTest::newRow("without the last end") << QByteArray("a,b\n1,2\n3,4");
        QTest::newRow("CRLF") << QByteArray("a,b\r\n1,2\r\n3,4\r\n");
        QTest::newRow("mark") << QByteArray("\xEF\xBB\xBF"
                                            "a,b\n1,2\n3,4\n");
        QTest::newRow("mark and quotes") << QByteArray("\xEF\xBB\xBF\"a\",\"b\"\n\"1\",2\n3,\"4\"\n");
        QTest::newRow("quotes and CRLF") << QByteArray("\"a\",b\r\n1,\"2\"\r\n3,\"4\"\r\n");
        QTest::newRow("blank lines") << QByteArray("\na,b\n\n1,2\r\n\r\n3,4\n\n");
        QTest::newRow("rows without a text") << QByteArray("a,b\n1,2\n,\n3,4\n,,,\n \t,\"\"\n");
        QTest::newRow("names with blanks") << QByteArray(" a ,\tb\n1,2\n3,4\n");
        QTest::newRow("old Macintosh") << QByteArray("a,b\r1,2\r3,4\r");
        QTest::newRow("all line ends") << QByteArray("\r\na,b\r\r\n1,2\n\r3,4");
        QTest::newRow("semicolons") << QByteArray("a;b\n1;2\n3;4\n");
        QTest::newRow("tabs") << QByteArray("a\tb\n1\t2\n3\t4\n");
        QTest::newRow("Excel's line") << QByteArray("sep=;\r\na;b\r\n1;2\r\n3;4\r\n");
        QTest::newRow("Excel's line of another") << QByteArray("sep=|\na|b\n1|2\n3|4\n");
        QTest::newRow("empty columns") << QByteArray("a,,b,\n1,,2,\n3, ,4,\"\"\n");
        QTest::newRow("numbers of pandas") << QByteArray(",a,b\n0,1,2\n17,3,4\n");
        const std::u16string wide = u"a,b\r\n1,2\r\n3,4\r\n";
        QByteArray low, high;
        for (const char16_t unit : wide) {
            low += QByteArray(1, char(unit)) + QByteArray(1, '\0');
            high += QByteArray(1, '\0') + QByteArray(1, char(unit));
        }
        QTest::newRow("UTF-16") << "\xFF\xFE" + low;
        QTest::newRow("UTF-16 the other way") << "\xFE\xFF" + high;
        QTest::newRow("UTF-16 without a mark") << low;
        QTest::newRow("UTF-16 the other way without a mark") << high;
    }
    void goodTables()
    {
        QFETCH(QByteArray, text);
        const auto table = parseCsv(text.toStdString(), "t.csv");
        QVERIFY2(table.has_value(), test::why(table));
        QCOMPARE(table->columns, (std::vector{"a"s, "b"s}));
        QCOMPARE(table->rows.size(), std::size_t(2));
        QCOMPARE(table->rows[0].cells, (std::vector{"1"s, "2"s}));
        QCOMPARE(table->rows[1].cells, (std::vector{"3"s, "4"s}));
    }

    /// A header says how cells are separated: what stands in quotes, or in the cells, does not.
    void separators()
    {
        const auto cellsOf = [](std::string_view text) {
            const auto table = parseCsv(text, "t.csv");
            return table ? table->rows.at(0).cells : std::vector<std::string>();
        };
        QCOMPARE(cellsOf("a,b\n1;2;3,4\n"), (std::vector{"1;2;3"s, "4"s}));
        QCOMPARE(cellsOf("\"a;;;\",b\n1,2\n"), (std::vector{"1"s, "2"s}));
        QCOMPARE(cellsOf("a;b\n\"1;2\";3,4\n"), (std::vector{"1;2"s, "3,4"s}));
        QCOMPARE(cellsOf("a\n1;2\n"), (std::vector{"1;2"s}));
        QCOMPARE(parseCsv("a;b", "t.csv")->separator, ';');
        QCOMPARE(parseCsv("a", "t.csv")->separator, ',');
    }

    void textOfUtf16()
    {
        const std::u16string wide = u"\uFEFFa,\u00E9\U0001F333\r\n\u00E9,\U0001F333\r\n";
        QByteArray bytes;
        for (const char16_t unit : wide)
            bytes += QByteArray(1, char(unit & 0xFF)) + QByteArray(1, char(unit >> 8));
        const auto table = parseCsv(bytes.toStdString(), "t.csv");
        QVERIFY2(table.has_value(), test::why(table));
        QCOMPARE(table->columns, (std::vector{"a"s, "\xC3\xA9\xF0\x9F\x8C\xB3"s}));
        QCOMPARE(table->rows[0].cells, (std::vector{"\xC3\xA9"s, "\xF0\x9F\x8C\xB3"s}));
    }

    void columnsAlone()
    {
        const auto table = parseCsv("a,b", "t.csv");
        QVERIFY2(table.has_value(), test::why(table));
        QCOMPARE(table->columns.size(), std::size_t(2));
        QVERIFY(table->rows.empty());
    }

    void cellsHoldAnything()
    {
        const auto table = parseCsv("a,b,c\n\"1,2\",\"say \"\"hi\"\"\",\"two\nlines\"\n,\"\", x \n", "t.csv");
        QVERIFY2(table.has_value(), test::why(table));
        QCOMPARE(table->rows[0].cells, (std::vector{"1,2"s, "say \"hi\""s, "two\nlines"s}));
        QCOMPARE(table->rows[1].cells, (std::vector{""s, ""s, " x "s}));
        QCOMPARE(table->rows[0].line, 2);
        QCOMPARE(table->rows[1].line, 4); // the cell above has two lines
    }

    void whatIsWrittenIsRead()
    {
        for (const std::string& cell :
             {"plain"s, ""s, "a,b"s, "\""s, "\"\""s, "a\nb"s, "a\r\nb"s, " "s, "\xC3\xA9"s, "a\0b"s}) {
            const auto table = parseCsv("a,b\n" + csvCell(cell) + ",1\n", "t.csv");
            QVERIFY2(table.has_value(), test::why(table));
            QCOMPARE(table->rows[0].cells[0], cell);
        }
        QCOMPARE(csvCell("plain"), "plain"s);
    }
};

RAMURE_SUITE(TestCsvTable)

} // namespace tst_csv_table

#include "tst_csv_table.moc"
