#include "core/qt/base/system_path.h"
#include "tests/cli/batch_support.h"
#include <dirent.h>
#include <filesystem>

namespace tst_ramure_cli_names {

using namespace ramure;
using test::isRefused;

/// Files whose names are no UTF-8: they keep their bytes, or nothing is written.
class TestRamureCliNames : public test::FolderSuite
{
    Q_OBJECT

    /// \param line of bash, where $R is the program and $'\xEA' a byte.
    test::CliRun run(const char* line)
    {
        return test::runProgram(
            QStringLiteral("bash"),
            {"-c", QStringLiteral("cd '%1'; R='%2'; %3").arg(folder(), RAMURE_CLI, line)});
    }
    /// In bytes, sorted; \p below: "" or "/FOLDER".
    [[nodiscard]] std::vector<std::string> names(const char* below = "") const
    {
        std::vector<std::string> found;
        DIR* const dir = ::opendir((folder().toStdString() + below).c_str());
        while (const dirent* entry = dir ? ::readdir(dir) : nullptr)
            if (entry->d_name[0] != '.')
                found.emplace_back(entry->d_name);
        ::closedir(dir);
        std::ranges::sort(found);
        return found;
    }
    using Names = std::vector<std::string>;

private slots:
    void init() { begin(); }
    /// Qt knows no such names: it could not remove them.
    void cleanup() { std::filesystem::remove_all(folder().toStdString()); }

    void filesThatAreNotThere()
    {
        QVERIFY(isRefused(run("$R info $'\\xEA.obj'"), "No such file"));
        QVERIFY(isRefused(run("$R info $'\\xEA.ramure'"), "No such file"));
        QVERIFY(isRefused(run("$R batch $'\\xEA.csv' -o out"), "No such file"));
        QVERIFY(isRefused(run("$R sheet $'\\xEA.jsonl' -o a.html"), "No such file"));
        QVERIFY(isRefused(run("$R edit preset:TinyTree --script $'\\xEA' -o a.ramure"), "No such file"));
        QVERIFY(names().empty());
    }

    /// What a text of JSON or a parameter could not hold.
    void namesThatCannotBeKept()
    {
        test::write(path("t.csv"), test::smallTrees(2));
        QVERIFY(isRefused(run("$R batch t.csv -o out --file $'{row}_\\xEA.ply'"), "the name is no UTF-8"));
        QVERIFY(isRefused(run("$R job t.csv --make -o $'\\xEA'"), "the name is no UTF-8"));
        QVERIFY(isRefused(run("cp t.csv $'\\xEA'; $R job $'\\xEA' --make -o out"), "the name is no UTF-8"));
        QVERIFY(isRefused(run("$R export preset:TinyTree -o a.ply --set $'tree.picture=\\xEA'"), "no UTF-8"));
        QCOMPARE(names(), (Names{"t.csv", "\xEA"}));
    }

    void twoFilesStayTwo()
    {
        const auto ended = run("$R export preset:TinyTree -o $'ch\\xEAne.obj' --map-size 0 && "
                               "$R export preset:SmallTree -o $'ch\\xE9ne.obj' --map-size 0");
        QVERIFY2(ended.code == 0, qPrintable(ended.err));
        QCOMPARE(names(), (Names{"ch\xE9ne.mtl", "ch\xE9ne.obj", "ch\xEAne.mtl", "ch\xEAne.obj"}));
        const auto faces = [&](const char* line) { return run(line).json().value("faces").toInt(); };
        const int tiny = faces("$R validate $'ch\\xEAne.obj' --json"),
                  small = faces("$R validate $'ch\\xE9ne.obj' --json");
        QVERIFY(tiny > 100 && small > 2 * tiny);
    }

    /// Each command reads and writes the names that it was given.
    void everyCommandKeepsThem()
    {
        const std::pair<const char*, Names> rows[] = {
            {"$R export preset:TinyTree -o $'\\xE91.ply' -o $'\\xE91.glb' -o $'\\xE91.stl' -o $'\\xE91.3mf'",
             {"\xE9"
              "1.3mf",
              "\xE9"
              "1.glb",
              "\xE9"
              "1.ply",
              "\xE9"
              "1.stl"}},
            {"$R export $'\\xE91.ply' -o $'\\xE92.obj'",
             {"\xE9"
              "2.mtl",
              "\xE9"
              "2.obj"}},
            {"$R export preset:TinyTree --set physics.windStrength=1 -o $'\\xE93.ply' --frames 0:1",
             {"\xE9"
              "3_0000.ply",
              "\xE9"
              "3_0001.ply"}},
            {"$R export preset:TinyTree -o $'\\xE94.ply' --report $'\\xE94.json'",
             {"\xE9"
              "4.json",
              "\xE9"
              "4.ply"}},
            {"$R import $'\\xE92.obj' -o $'\\xE95.ramure' 2>/dev/null",
             {"\xE9"
              "5.ramure"}},
            {"$R edit preset:TinyTree --script /dev/null -o $'\\xE96.ramure'",
             {"\xE9"
              "6.ramure"}},
            {"$R export $'\\xE96.ramure' -o $'\\xE97.ply'",
             {"\xE9"
              "7.ply"}},
            {"$R textures preset:TinyTree -o $'\\xE98' --size 64",
             {"\xE9"
              "8"}},
            {"$R simulate preset:TinyTree --steps 2 --csv $'\\xE99.csv' >/dev/null",
             {"\xE9"
              "9.csv"}},
            {"$R render preset:TinyTree -o $'\\xE9a.png' --size 32x32 --turntable 2",
             {"\xE9"
              "a_0000.png",
              "\xE9"
              "a_0001.png"}},
            {"$R billboard preset:TinyTree -o $'\\xE9b' --size 64 && $R billboard preset:TinyTree -o "
             "$'\\xE9c.glb' "
             "--size 64",
             {"\xE9"
              "b",
              "\xE9"
              "c.glb"}},
        };
        for (const auto& [line, files] : rows) {
            const Names before = names();
            const auto ended = run(line);
            QVERIFY2(ended.code == 0, qPrintable(QString(line) + ended.err));
            Names now = names();
            std::erase_if(now, [&](const std::string& name) {
                return std::ranges::find(before, name) != before.end();
            });
            if (now != files)
                QFAIL(qPrintable(QString(line) + ": " + pathText(now.empty() ? "nothing" : now.front())));
        }
        QVERIFY(!names("/\xE9"
                       "8")
                     .empty());
        QCOMPARE(names("/\xE9"
                       "b"),
                 (Names{"cards.glb", "cards_colour.png", "cards_normal.png"}));
    }

    void batchesInSuchFolders()
    {
        const QByteArray text = "input,seed\n\"tree.ramure\",1\npreset:TinyTree,2\n";
        QCOMPARE(
            run("mkdir $'\\xE9'; $R edit preset:TinyTree --script /dev/null -o $'\\xE9/tree.ramure'").code,
            0);
        test::write(path("t.csv"), text);
        const char* const batch =
            "mv t.csv $'\\xE9/t.csv' 2>/dev/null; $R batch $'\\xE9/t.csv' -o $'\\xE9/out' --resume "
            "--file '{row}.ply' --file '{row}/' --map-size 64 --timings $'\\xE9/s' && "
            "$R sheet $'\\xE9/out/manifest.jsonl' --inputs $'\\xE9' -o $'\\xE9/page.html'";
        const auto ended = run(batch);
        QVERIFY2(ended.code == 0, qPrintable(ended.err));
        QCOMPARE(names("/\xE9"), (Names{"out", "page.html", "s", "t.csv", "tree.ramure"}));
        const Names made = names("/\xE9/out");
        QVERIFY(std::ranges::find(made, "000001.ply") != made.end() &&
                std::ranges::find(made, "000002.ply") != made.end());
        QVERIFY(run("cat $'\\xE9/s'").out.count('\n') == 2);
        QCOMPARE(run(batch).code, 0);
        QVERIFY(run("cat $'\\xE9/s'").out.isEmpty()); // the hashes were found
    }
};

RAMURE_SUITE(TestRamureCliNames)

} // namespace tst_ramure_cli_names

#include "tst_ramure_cli_names.moc"
