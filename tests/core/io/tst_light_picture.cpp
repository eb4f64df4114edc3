#include "core/io/exr_file.h"
#include "core/io/light_picture.h"
#include "tests/support/suite.h"
#include <QFile>
#include <QTemporaryDir>
#include <limits>

namespace tst_light_picture {

using namespace ramure;

namespace {

struct Taken
{
    int width = 0, height = 0;
    std::vector<glm::vec3> pixels;
};

Expected<Taken> taken(const QString& path, const Progress& progress = {})
{
    Taken out;
    RAMURE_TRY(readLightPicture(path.toStdString(),
                                {[&](int w, int h) {
                                     out.width = w;
                                     out.height = h;
                                     return w < 1 || h < 1 ? Expected<void>(fail(ErrorCode::Invalid, "size"))
                                                           : Expected<void>();
                                 },
                                 [&](int, std::span<const glm::vec3> row) {
                                     out.pixels.insert(out.pixels.end(), row.begin(), row.end());
                                     return Expected<void>();
                                 }},
                                progress));
    return out;
}

const QByteArray head = "#?RADIANCE\n# made here\nFORMAT=32-bit_rle_rgbe\n\n";

} // namespace

class TestLightPicture : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    QString written(const char* name, const QByteArray& bytes)
    {
        QFile file(m_folder.filePath(name));
        if (!file.open(QIODevice::WriteOnly))
            qFatal("no file");
        file.write(bytes);
        return file.fileName();
    }

private slots:
    void init() { test::failOnAnyWarning(); }
    void badFilesAreRefusedWithTheirName_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("reason");
        QTest::newRow("empty") << QByteArray() << "neither";
        QTest::newRow("text") << QByteArray("hello world") << "neither";
        QTest::newRow("header without end") << QByteArray("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n") << "no end";
        QTest::newRow("endless header") << "#?RADIANCE\n" + QByteArray(200'000, 'x') << "no end";
        QTest::newRow("other colours")
            << QByteArray("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 2\n") << "rgbe";
        QTest::newRow("upside down") << head + "+Y 1 +X 2\n"
                                     << "-Y height";
        QTest::newRow("no size") << head + "-Y a +X b\n"
                                 << "size";
        QTest::newRow("negative") << head + "-Y -2 +X -4\n"
                                  << "size";
        QTest::newRow("ends early") << head + "-Y 2 +X 2\n" + QByteArray(9, '\x80') << "row 2";
        QTest::newRow("run too long") << head + "-Y 1 +X 8\n" + QByteArray("\2\2\0\10\377\1", 6) << "row 1";
        QTest::newRow("run of none") << head + "-Y 1 +X 8\n" + QByteArray("\2\2\0\10\0\1", 6) << "row 1";
        QTest::newRow("exr cut off") << QByteArray("\x76\x2f\x31\x01\x02\0\0\0chan", 12) << "damaged";
    }
    void badFilesAreRefusedWithTheirName()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, reason);
        const QString path = written("bad.hdr", bytes);
        const auto read = taken(path);
        QVERIFY(!read);
        QVERIFY2(read.error().plain().find(reason.toStdString()) != std::string::npos,
                 read.error().message().c_str());
        QCOMPARE(read.error().file, path.toStdString());
    }
    void whatIsNotThereIsNamed()
    {
        for (const QString& path : {m_folder.filePath("no.hdr"), m_folder.path()}) {
            const auto read = taken(path);
            QVERIFY(!read);
            QCOMPARE(read.error().code, ErrorCode::Io);
            QCOMPARE(read.error().file, path.toStdString());
        }
    }
    void numbersAreCleaned()
    {
        const float inf = std::numeric_limits<float>::infinity();
        const QString path = m_folder.filePath("clean.exr");
        std::vector<glm::vec4> pixels(8, glm::vec4(0.5f));
        pixels[1] = {inf, -3.0f, -inf, 1.0f};
        pixels[2] = {1e9f, 0.0f, 2.0f, 1.0f}; // more than 16 bits hold
        QVERIFY(writeExr(path.toStdString(), 4, 2, pixels));
        const auto read = taken(path);
        QVERIFY2(read, read ? "" : read.error().message().c_str());
        QCOMPARE(read->pixels[1], glm::vec3(65504.0f, 0.0f, 0.0f));
        QCOMPARE(read->pixels[2], glm::vec3(65504.0f, 0.0f, 2.0f));
        QCOMPARE(read->pixels[7], glm::vec3(0.5f));
        pixels[6].g = std::numeric_limits<float>::quiet_NaN();
        QVERIFY(writeExr(path.toStdString(), 4, 2, pixels));
        const auto bad = taken(path);
        QVERIFY(!bad);
        QCOMPARE(bad.error().plain(), std::string("row 2, column 3 is not a number"));
    }
    void damagedExrFilesAreRefused()
    {
        const QString path = m_folder.filePath("whole.exr");
        std::vector<glm::vec4> pixels;
        for (int i = 0; i < 64 * 32; ++i)
            pixels.emplace_back(float(i % 37), float(i % 11), 0.1f * float(i % 5), 1.0f);
        QVERIFY(writeExr(path.toStdString(), 64, 32, pixels));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray whole = file.readAll();
        for (qsizetype length = 4; length < whole.size(); length += 97)
            QVERIFY(!taken(written("cut.exr", whole.first(length))));
        for (qsizetype at = 8; at < whole.size(); at += 41) { // read or refused
            QByteArray changed = whole;
            changed[at] = char(~changed[at]);
            (void)taken(written("changed.exr", changed));
        }
    }
    void allWritingsOfRadianceAreRead()
    {
        const QByteArray pixel("\x80\x40\x20\x81", 4), black(4, '\0');
        const glm::vec3 colour = glm::vec3(128.5f, 64.5f, 32.5f) / 128.0f;
        const auto flat = taken(written("flat.hdr", head + "-Y 1 +X 2\n" + pixel + black));
        QVERIFY(flat);
        QCOMPARE(flat->pixels, (std::vector<glm::vec3>{colour, glm::vec3(0.0f)}));
        const auto old = taken(written("old.hdr", head + "-Y 1 +X 4\n" + pixel + QByteArray("\1\1\1\3", 4)));
        QVERIFY(old);
        QCOMPARE(old->pixels, std::vector<glm::vec3>(4, colour));
        QByteArray runs("\2\2\0\10", 4);
        for (int i = 0; i < 3; ++i)
            runs += QByteArray("\x88", 1) + pixel[i];
        runs += QByteArray("\3\x81\x81\x81\x85\x81", 6); // three as they are, then five of one
        const auto run = taken(written("runs.hdr", head + "-Y 1 +X 8\n" + runs));
        QVERIFY2(run, run ? "" : run.error().message().c_str());
        QCOMPARE(run->pixels, std::vector<glm::vec3>(8, colour));
    }
    void readingCanBeGivenUp()
    {
        std::stop_source stop;
        stop.request_stop();
        const auto read = taken(written("flat.hdr", head + "-Y 1 +X 2\n" + QByteArray(8, '\x80')),
                                Progress{stop.get_token(), {}});
        QVERIFY(!read);
        QCOMPARE(read.error().code, ErrorCode::Cancelled);
    }
};

RAMURE_SUITE(TestLightPicture)

} // namespace tst_light_picture

#include "tst_light_picture.moc"
