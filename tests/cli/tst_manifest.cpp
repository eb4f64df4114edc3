#include "app/cli/batch/manifest.h"
#include "tests/cli/cli_support.h"
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace tst_manifest {

using namespace ramure;
using namespace ramure::cli;

/// The manifest of a batch and its journal: what a kill leaves, and what the next run makes of it.
class TestManifest : public QObject
{
    Q_OBJECT
    std::unique_ptr<QTemporaryDir> m_folder;

    [[nodiscard]] QString path() const { return m_folder->filePath("m.jsonl"); }
    [[nodiscard]] QString journal() const { return path() + ".journal"; }
    static QJsonObject line(int row, const char* text) { return {{"row", row}, {"text", text}}; }

private slots:
    void init()
    {
        test::failOnAnyWarning();
        m_folder = std::make_unique<QTemporaryDir>();
    }

    void badManifests_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("part");
        QTest::newRow("no JSON") << QByteArray("{\"row\":1}\nrow 2\n") << ":2: no JSON";
        QTest::newRow("torn") << QByteArray("{\"row\":1}\n{\"row\":2,\"fil") << ":2: no JSON";
        QTest::newRow("no row") << QByteArray("{\"line\":1}\n") << ":1: no line of a manifest";
        QTest::newRow("row 0") << QByteArray("{\"row\":0}\n") << ":1: no line of a manifest";
        QTest::newRow("row of text") << QByteArray("{\"row\":\"1\"}\n") << ":1: no line of a manifest";
        QTest::newRow("a list") << QByteArray("[1]\n") << ":1: no line of a manifest";
        QTest::newRow("blank line") << QByteArray("{\"row\":1}\n\n{\"row\":2}\n") << ":2: no JSON";
    }
    void badManifests()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, part);
        test::write(path(), text);
        const auto lines = readManifest(path());
        QVERIFY(!lines);
        QVERIFY2(lines.error().message().find(part.toStdString()) != std::string::npos, test::why(lines));
    }

    void filesThatCannotBe()
    {
        QCOMPARE(readManifest(path()).error().code, ErrorCode::Io);
        QCOMPARE(ManifestWriter::open(m_folder->filePath("none/m.jsonl"), false).error().code, ErrorCode::Io);
        QCOMPARE(ManifestWriter::open(m_folder->filePath("none/m.jsonl"), true).error().code, ErrorCode::Io);
    }

    void linesStandInTheOrderOfTheRows()
    {
        {
            auto writer = ManifestWriter::open(path(), false);
            QVERIFY2(writer.has_value(), test::why(writer));
            for (const int row : {3, 1, 2})
                QVERIFY(writer->add(line(row, "x")));
            QVERIFY(QFile::exists(journal()));
            QVERIFY(!QFile::exists(path()));
            QVERIFY(writer->commit({1, 2, 3}));
        }
        QCOMPARE(test::bytesOf(path()),
                 QByteArray(
                     "{\"row\":1,\"text\":\"x\"}\n{\"row\":2,\"text\":\"x\"}\n{\"row\":3,\"text\":\"x\"}\n"));
        QVERIFY(!QFile::exists(journal()));
        const auto lines = readManifest(path());
        QVERIFY2(lines.has_value(), test::why(lines));
        QCOMPARE(lines->size(), std::size_t(3));
    }

    void rowsThatAreGoneFromTheTableAreGoneFromTheManifest()
    {
        test::write(path(), lineText(line(1, "a")) + lineText(line(9, "b")));
        auto writer = ManifestWriter::open(path(), true);
        QVERIFY(writer && writer->commit({1, 2}));
        QCOMPARE(test::bytesOf(path()), lineText(line(1, "a")));
    }

    /// As after kill -9: the journal stays, its last line is torn.
    void aTornJournalGoesOn()
    {
        test::write(path(), lineText(line(1, "old")) + lineText(line(2, "old")));
        test::write(journal(), lineText(line(2, "new")) + "{\"row\":3,\"te");
        {
            auto writer = ManifestWriter::open(path(), true);
            QVERIFY2(writer.has_value(), test::why(writer));
            QCOMPARE(writer->lines().size(), std::size_t(2));
            QCOMPARE(writer->lines().at(1), line(1, "old"));
            QCOMPARE(writer->lines().at(2), line(2, "new"));
            QVERIFY(writer->add(line(4, "later")));
        } // killed again
        auto writer = ManifestWriter::open(path(), true);
        QVERIFY2(writer.has_value(), test::why(writer));
        QCOMPARE(writer->lines().size(), std::size_t(3));
        QCOMPARE(writer->lines().at(4), line(4, "later"));
        QVERIFY(writer->commit({1, 2, 3, 4}));
        QCOMPARE(test::bytesOf(path()),
                 lineText(line(1, "old")) + lineText(line(2, "new")) + lineText(line(4, "later")));
    }

    void withoutResumeAllIsForgotten()
    {
        test::write(path(), lineText(line(1, "old")));
        test::write(journal(), lineText(line(2, "old")));
        auto writer = ManifestWriter::open(path(), false);
        QVERIFY2(writer.has_value(), test::why(writer));
        QVERIFY(writer->lines().empty());
        QVERIFY(!QFile::exists(path()));
        QVERIFY(test::bytesOf(journal()).isEmpty());
    }

    void oneAtATime()
    {
        auto writer = ManifestWriter::open(path(), false);
        QVERIFY2(writer.has_value(), test::why(writer));
        const int other = ::open(QFile::encodeName(journal()).constData(), O_RDWR | O_CLOEXEC);
        QVERIFY(other >= 0);
        QVERIFY(::flock(other, LOCK_EX | LOCK_NB) != 0);
        {
            const ManifestWriter ended = std::move(*writer);
        }
        QCOMPARE(::flock(other, LOCK_EX | LOCK_NB), 0);
        ::close(other);
    }
};

RAMURE_SUITE(TestManifest)

} // namespace tst_manifest

#include "tst_manifest.moc"
