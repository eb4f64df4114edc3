#include "tests/cli/batch_support.h"

namespace tst_ramure_cli_tables {

using namespace ramure;
using test::bytesOf;
using test::isRefused;
using test::linesOf;
using test::runCli;

/// Tables as spreadsheets and pandas save them are the same table: so are the trees. What may mean two things
/// is an error.
class TestRamureCliTables : public test::FolderSuite
{
    Q_OBJECT

    test::CliRun run(const QByteArray& text, const QString& pattern = QStringLiteral("{row}.ply"))
    {
        return runCli({"batch", table(text), "-o", path("out"), "--file", pattern, "--jobs", "2"});
    }
    QString errorOf(int row)
    {
        const QJsonObject line = linesOf(path("out/manifest.jsonl")).at(std::size_t(row - 1));
        return line["error"]["text"].toString();
    }

private slots:
    void init() { begin(); }

    void badTables_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("part");
        const auto row = [](const char* name, const QByteArray& text, const char* part) {
            QTest::newRow(name) << text << QString::fromUtf8(part);
        };
        row("Latin-1", "preset,seed,#place\nTinyTree,1,pr\xE9\n",
            "t.csv:2: column \"#place\": bytes that are no");
        row("the same column", "preset,seed,Seed\nTinyTree,1,2\n", "t.csv:1: column \"seed\" is there twice");
        row("a decimal comma among commas", "preset,turtle.alpha\nTinyTree,0,2\n",
            "t.csv:2: 3 cells, and there are 2 columns");
        row("semicolons below", "preset,seed\nTinyTree;1\n", "t.csv:2: 1 cells, and there are 2 columns");
        row("a spreadsheet itself", QByteArray("PK\x03\x04\x14\0\x08\x08\x08\0\xD5\xFF", 12),
            "no text in UTF-8");
    }
    void badTables()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, part);
        QVERIFY(isRefused(run(text), part));
        QVERIFY(!QFile::exists(path("out")));
    }

    void badCells_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("error");
        const auto row = [](const char* name, const QByteArray& text, const char* error) {
            QTest::newRow(name) << text << QString::fromUtf8(error);
        };
        row("a half", "preset,grammar.iterations\nTinyTree,2.5\n",
            "t.csv:2: grammar.iterations: \"2.5\" is not a whole number");
        row("thousands", "preset;mesh.targetTriangles\nTinyTree;10.000\n",
            "t.csv:2: mesh.targetTriangles: \"10.000\" is not a whole number");
        row("quoted thousands", "preset,mesh.targetTriangles\nTinyTree,\"10,000\"\n",
            "t.csv:2: mesh.targetTriangles: \"10,000\" is not a whole number");
        row("points and commas", "preset;turtle.alpha;physics.windStrength\nTinyTree;0,2;1.250\n",
            "t.csv:2: physics.windStrength: \"1.250\" has a decimal point, other numbers of the table have "
            "decimal commas");
        row("thousands or a fraction", "preset\tphysics.windStrength\nTinyTree\t1,250\n",
            "t.csv:2: physics.windStrength: the comma of \"1,250\" may stand before a fraction or before "
            "thousands: a decimal point expected");
        row("no bool", "preset,grammar.stochastic\nTinyTree,WAHR\n",
            "t.csv:2: grammar.stochastic: \"WAHR\" is neither true nor false");
        row("no seed", "preset,seed\nTinyTree,1.5\n", "t.csv:2: seed: \"1.5\" is no whole number from 0");
        row("no preset", "preset,seed\n,1\n", "t.csv:2: preset: the cell is empty");
        row("no input", "input,seed\n ,1\n", "t.csv:2: input: the cell is empty");
    }
    /// They name line and column, and are the row's: the others are made.
    void badCells()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, error);
        const char separator = text.contains('\t') ? '\t' : text.contains(';') ? ';' : ',';
        const QByteArray good = text.startsWith("input") ? "preset:TinyTree" : "TinyTree";
        const auto ended =
            run(text + good + QByteArray(text.left(text.indexOf('\n')).count(separator), separator));
        QCOMPARE(ended.code, 3);
        QCOMPARE(errorOf(1), error);
        QVERIFY(!QFile::exists(path("out/000001.ply")) && QFile::exists(path("out/000002.ply")));
    }

    void sameTable_data()
    {
        QTest::addColumn<QByteArray>("text");
        const auto row = [](const char* name, const QByteArray& text) { QTest::newRow(name) << text; };
        row("capitals of a spreadsheet", "preset,seed,turtle.alpha,grammar.stochastic,grammar.iterations\n"
                                         "TinyTree,1,0.2,TRUE,2\nTinyTree,2,0.3,FALSE,2\n");
        row("fractions of pandas", "preset,seed,turtle.alpha,grammar.stochastic,grammar.iterations\n"
                                   "TinyTree,1.0,0.2,1.0,2.0\nTinyTree,2.0,0.3,0.0,2.0\n");
        row("index of pandas", ",preset,seed,turtle.alpha,grammar.stochastic,grammar.iterations\n"
                               "0,TinyTree,1,0.2,True,2\n1,TinyTree,2,0.3,False,2\n");
        row("rows that were deleted", "preset,seed,turtle.alpha,grammar.stochastic,grammar.iterations,\n"
                                      "TinyTree,1,0.2,true,2,\n,,,,,\nTinyTree,2,0.3,false,2,\n,,,,,\n");
        row("names with blanks and capitals",
            "Preset, SEED , Turtle.Alpha,grammar.stochastic ,Grammar.iterations\n"
            "TinyTree,1,0.2,true,2\n TinyTree, 2, 0.3, false, 2\n");
        row("semicolons and commas", "preset;seed;turtle.alpha;grammar.stochastic;grammar.iterations\r\n"
                                     "TinyTree;1;0,2;true;2\r\nTinyTree;2;0,3;false;2,0\r\n");
        row("semicolons and points", "preset;seed;turtle.alpha;grammar.stochastic;grammar.iterations\n"
                                     "TinyTree;1;0.2;true;2\nTinyTree;2;0.3;false;2\n");
        row("tabs and commas", "preset\tseed\tturtle.alpha\tgrammar.stochastic\tgrammar.iterations\r\n"
                               "TinyTree\t1\t0,2\ttrue\t2\r\nTinyTree\t2\t0,3\tfalse\t2\r\n");
        row("old Macintosh", "preset,seed,turtle.alpha,grammar.stochastic,grammar.iterations\r"
                             "TinyTree,1,0.2,true,2\rTinyTree,2,0.3,false,2\r");
        row("mark", "\xEF\xBB\xBFpreset,seed,turtle.alpha,grammar.stochastic,grammar.iterations\n"
                    "TinyTree,1,0.2,true,2\nTinyTree,2,0.3,false,2\n");
        QByteArray wide = "\xFF\xFE";
        for (const char letter :
             QByteArray("preset\tseed\tturtle.alpha\tgrammar.stochastic\tgrammar.iterations\r\n"
                        "TinyTree\t1\t0,2\tTRUE\t2\r\nTinyTree\t2\t0,3\tFALSE\t2\r\n"))
            wide += QByteArray(1, letter) + QByteArray(1, '\0');
        row("Unicode text of Excel", wide);
        row("quoted",
            "\"preset\",\"seed\",\"turtle.alpha\",\"grammar.stochastic\",\"grammar.iterations\",\"#\"\n"
            "\"TinyTree\",\"1\",\"0.2\",\"true\",\"2\",\"two\nlines\"\n"
            "\"TinyTree\",\"2\",\"0.3\",\"false\",\"2\",\"\"\n");
    }
    void sameTable()
    {
        QFETCH(QByteArray, text);
        const QString pattern = QStringLiteral("{preset}_{Seed}.ply");
        const QByteArray plain = "preset,seed,turtle.alpha,grammar.stochastic,grammar.iterations\n"
                                 "TinyTree,1,0.2,true,2\nTinyTree,2,0.3,false,2\n";
        QCOMPARE(runCli({"batch", table(plain), "-o", path("plain"), "--file", pattern}).code, 0);
        const auto ended = runCli({"batch", table(text), "-o", path("out"), "--file", pattern});
        QVERIFY2(ended.code == 0, qPrintable(ended.err));
        for (const char* file : {"/TinyTree_1.ply", "/TinyTree_2.ply"}) {
            QVERIFY(bytesOf(path("out") + file) == bytesOf(path("plain") + file));
            QVERIFY(!bytesOf(path("plain") + file).isEmpty());
        }
        const auto lines = linesOf(path("out/manifest.jsonl")),
                   expected = linesOf(path("plain/manifest.jsonl"));
        QCOMPARE(lines.size(), std::size_t(2));
        for (std::size_t i = 0; i < 2; ++i) {
            QCOMPARE(lines[i]["proof"], expected[i]["proof"]);
            QCOMPARE(lines[i]["seed"], expected[i]["seed"]);
            QCOMPARE(lines[i]["row"], expected[i]["row"]);
        }
    }

    /// It would be the name of several trees, or of none.
    void emptyCellsMakeNoNames()
    {
        const QByteArray text = "preset,seed,name,files\n"
                                "TinyTree,1,oak,\n"
                                "TinyTree,2,,\n"
                                "TinyTree,,elm,\n"
                                "TinyTree,4,\" \",{row}.ply\n";
        const auto ended = run(text, QStringLiteral("{name}_{seed}.ply"));
        QCOMPARE(ended.code, 3);
        QVERIFY(errorOf(1).isEmpty() && errorOf(4).isEmpty());
        QCOMPARE(errorOf(2),
                 QString("t.csv:3: file \"{name}_{seed}.ply\": the cell of column \"name\" is empty"));
        QCOMPARE(errorOf(3),
                 QString("t.csv:4: file \"{name}_{seed}.ply\": the cell of column \"seed\" is empty"));
        auto files = test::filesBelow(path("out"));
        files.erase("manifest.jsonl");
        QCOMPARE(files.size(), std::size_t(2));
        QVERIFY(files.contains("oak_1.ply") && files.contains("000004.ply"));
    }

    /// Of a row that has none, or one that means nothing, the manifest says none.
    void manifestsInventNoSeed()
    {
        QCOMPARE(run("preset,seed\nTinyTree,soon\nTinyTree,-5\nTinyTree,\nTinyTree,0\nTinyTree,7.0\n").code,
                 3);
        const auto lines = linesOf(path("out/manifest.jsonl"));
        for (const std::size_t without : {0, 1, 2})
            QVERIFY(!lines[without].contains("seed"));
        QCOMPARE(lines[3]["seed"].toInt(-1), 0);
        QCOMPARE(lines[4]["seed"].toInt(-1), 7);
    }

    /// tree.obj and tree.OBJ write one tree.mtl.
    void filesThatWouldShareTheirMaterials()
    {
        QVERIFY(isRefused(run("preset,files\nTinyTree,a.obj\nTinyTree,a.OBJ\n"),
                          "t.csv:3: file \"a.mtl\": line 2 writes it too"));
    }
};

RAMURE_SUITE(TestRamureCliTables)

} // namespace tst_ramure_cli_tables

#include "tst_ramure_cli_tables.moc"
