#include "tests/cli/batch_support.h"
#include <QImage>

namespace tst_ramure_cli_sheet {

using namespace ramure;
using test::bytesOf;
using test::isRefused;
using test::runCli;

/// Contact sheets of real batches.
class TestRamureCliSheet : public test::FolderSuite
{
    Q_OBJECT

    /// What is embedded, in the order of the cards.
    static std::vector<QImage> picturesOf(const QByteArray& page)
    {
        static const QRegularExpression source("src=\"data:image/jpeg;base64,([^\"]*)\"");
        std::vector<QImage> pictures;
        for (auto it = source.globalMatch(QString::fromUtf8(page)); it.hasNext();)
            pictures.push_back(
                QImage::fromData(QByteArray::fromBase64(it.next().captured(1).toLatin1()), "JPEG"));
        return pictures;
    }

private slots:
    void init() { begin(); }

    void badUsage()
    {
        const QString good = path("m.jsonl"), page = path("s.html");
        test::write(good, "{\"row\":1,\"input\":\"preset:TinyTree\"}\n");
        QVERIFY(isRefused(runCli({"sheet"}), "missing MANIFEST.jsonl"));
        QVERIFY(isRefused(runCli({"sheet", good}), "missing -o FILE.html"));
        QVERIFY(isRefused(runCli({"sheet", path("none.jsonl"), "-o", page}), "none.jsonl"));
        QVERIFY(isRefused(runCli({"sheet", good, "-o", page, "--size", "8"}), "--size \"8\": 32 to 1024"));
        QVERIFY(isRefused(runCli({"sheet", good, "-o", page, "--jobs", "0"}), "--jobs \"0\""));
        QVERIFY(isRefused(runCli({"sheet", good, "-o", path("none/s.html")}), "none/s.html"));
        test::write(path("bad.jsonl"), "{\"row\":1}\nno JSON\n");
        QVERIFY(isRefused(runCli({"sheet", path("bad.jsonl"), "-o", page}), "bad.jsonl:2: no JSON"));
        QVERIFY(!QFile::exists(page));
    }

    void treesAreDrawnOrTheirPicturesTaken()
    {
        const QByteArray text = "preset,seed,files\nTinyTree,1,\nTinyTree,2,b.png\nNoTree,3,\n";
        test::write(path("t.csv"), text);
        QCOMPARE(runCli({"batch", path("t.csv"), "-o", path("out"), "--file", "{row}.obj", "--size", "64x32"})
                     .code,
                 3);
        const auto sheet = [&](const char* file, const char* jobs) {
            return runCli({"sheet", path("out/manifest.jsonl"), "-o", path(QLatin1String(file)), "--jobs",
                           QLatin1String(jobs), "--size", "48"});
        };
        const auto one = sheet("one.html", "1");
        QVERIFY2(one.code == 0 && one.out.isEmpty() && one.err.isEmpty(), qPrintable(one.err));
        QCOMPARE(sheet("two.html", "2").code, 0);
        const QByteArray page = bytesOf(path("one.html"));
        QVERIFY(page == bytesOf(path("two.html")));
        const auto pictures = picturesOf(page);
        QCOMPARE(pictures.size(), std::size_t(2));
        QCOMPARE(pictures[0].size(), QSize(48, 48)); // drawn
        QCOMPARE(pictures[1].size(), QSize(48, 24)); // taken from b.png
        QVERIFY(page.contains("3 rows, 1 failed") && page.contains("there is no preset &quot;NoTree&quot;"));
        // Nothing from elsewhere, nothing of this machine.
        QVERIFY(!page.contains("http") && !page.contains(folder().toUtf8()));
    }

    void projectsOfRowsAreFound()
    {
        test::write(path("oak.ramure"),
                    R"({"format": "ramure", "version": 1, "nodes": [{"id": 1, "kind": "tree", "name": "Oak",
                    "params": {"grammar.iterations": 3}}]})");
        test::write(path("t.csv"), "input,seed\noak.ramure,1\n");
        QCOMPARE(runCli({"batch", path("t.csv"), "-o", path("out"), "--file", "{row}.obj"}).code, 0);
        const auto count = [&](const QStringList& more) {
            const QStringList words{"sheet", path("out/manifest.jsonl"), "-o", path("s.html")};
            if (runCli(words + more).code != 0)
                return std::size_t(99);
            return picturesOf(bytesOf(path("s.html"))).size();
        };
        QCOMPARE(count({}), std::size_t(0)); // it does not stand beside the manifest
        QCOMPARE(count({"--inputs", folder()}), std::size_t(1));
    }
};

RAMURE_SUITE(TestRamureCliSheet)

} // namespace tst_ramure_cli_sheet

#include "tst_ramure_cli_sheet.moc"
