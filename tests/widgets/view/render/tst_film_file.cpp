#include "tests/support/suite.h"
#include "widgets/view/render/passes/film_file.h"
#include <QDir>
#include <QFile>
#include <QTemporaryDir>

namespace tst_film_file {

using namespace ramure;

/// With a stand-in for ffmpeg, a script of the shell; `./dev clients` plays what the real one makes.
class TestFilmFile : public QObject
{
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_folder;
    QByteArray m_path;

    QString file(const char* name) const { return m_folder->filePath(QString::fromLatin1(name)); }
    std::string film(const char* name) const { return QFile::encodeName(file(name)).toStdString(); }
    QByteArray read(const char* name) const
    {
        QFile bytes(file(name));
        return bytes.open(QIODevice::ReadOnly) ? bytes.readAll() : QByteArray();
    }
    void write(const char* name, const QByteArray& bytes) const
    {
        QFile out(file(name));
        QVERIFY(out.open(QIODevice::WriteOnly) && out.write(bytes) == bytes.size());
    }
    void standIn(const QByteArray& script) const
    {
        QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("bin")));
        write("bin/ffmpeg", "#!/bin/sh\n" + script);
        QVERIFY(QFile(file("bin/ffmpeg")).setPermissions(QFile::ReadOwner | QFile::ExeOwner));
        qputenv("PATH", QFile::encodeName(file("bin")) + ":/usr/bin:/bin");
    }
    static QImage picture(const QColor& colour, QSize size = {33, 20})
    {
        QImage image(size, QImage::Format_RGB32);
        image.fill(colour);
        return image;
    }
    /// What the stand-in is given is the film, and its arguments lie beside it.
    QByteArray keeper() const
    {
        return "echo \"$@\" > " + QFile::encodeName(file("arguments")) +
               "\nfor last; do :; done\ncat > \"$last\"\n";
    }

private slots:
    void init()
    {
        test::failOnAnyWarning();
        m_path = qgetenv("PATH");
        m_folder = std::make_unique<QTemporaryDir>();
    }
    void cleanup() { qputenv("PATH", m_path); }

    void whatCannotBeFilmedIsRefused()
    {
        qputenv("PATH", QFile::encodeName(m_folder->path()));
        const auto none = FilmFile::begin(film("a.mp4"), {32, 20}, 24.0);
        QVERIFY(!none && none.error().code == ErrorCode::Unknown && none.error().file == film("a.mp4"));
        QVERIFY(none.error().message().find("ffmpeg") != std::string::npos);
        standIn(keeper());
        const auto gif = FilmFile::begin(film("a.gif"), {32, 20}, 24.0);
        QVERIFY(!gif && gif.error().message().find(".webm") != std::string::npos);
        QVERIFY(!isFilm(film("a.png")) && !isFilm(film("mp4")) && isFilm(film("a.MP4")));
        auto small = FilmFile::begin(film("a.mp4"), {32, 20}, 24.0);
        QVERIFY(small);
        const auto other = (*small)->add(picture(Qt::red), {});
        QVERIFY(!other && other.error().code == ErrorCode::Invalid);
        small->reset();
        QVERIFY(!QFile::exists(file("a.mp4")));
    }
    void anEncoderThatFailsIsQuoted_data()
    {
        QTest::addColumn<QByteArray>("script");
        QTest::newRow("at once") << QByteArray("echo 'no such codec' >&2; exit 1\n");
        QTest::newRow("while it reads")
            << QByteArray("head -c 3000 >/dev/null; echo 'no such codec' >&2; exit 1\n");
        QTest::newRow("at the end") << QByteArray("cat >/dev/null; echo 'no such codec' >&2; exit 1\n");
        QTest::newRow("it crashes") << QByteArray("echo 'no such codec' >&2; kill -9 $$\n");
    }
    void anEncoderThatFailsIsQuoted()
    {
        QFETCH(QByteArray, script);
        standIn(script);
        write("a.mp4", "old");
        auto made = FilmFile::begin(film("a.mp4"), {33, 20}, 24.0);
        QVERIFY(made);
        Expected<void> done;
        for (int i = 0; i < 200 && done; ++i)
            done = (*made)->add(picture(Qt::red), {});
        if (done)
            done = (*made)->finish({});
        QVERIFY(!done);
        QVERIFY2(done.error().message().find("no such codec") != std::string::npos,
                 done.error().message().c_str());
        made->reset();
        QCOMPARE(read("a.mp4"), QByteArray("old"));
    }
    void whoStopsKeepsTheOldFilm()
    {
        standIn("exec sleep 1000\n"); // takes what fits in a pipe, and no more
        write("a.mp4", "old");
        std::stop_source stop;
        auto made = FilmFile::begin(film("a.mp4"), {330, 200}, 24.0);
        QVERIFY(made);
        stop.request_stop();
        const auto done = (*made)->add(picture(Qt::red, {330, 200}), {stop.get_token(), {}});
        QVERIFY(!done && done.error().code == ErrorCode::Cancelled);
        made->reset();
        QCOMPARE(read("a.mp4"), QByteArray("old"));
    }
    void everyPictureArrives()
    {
        standIn(keeper());
        write("a.webm", "old");
        auto made = FilmFile::begin(film("a.webm"), {33, 20}, 12.5);
        QVERIFY(made);
        for (const QColor& colour : {QColor(1, 2, 3), QColor(4, 5, 6), QColor(7, 8, 9)})
            QVERIFY((*made)->add(picture(colour), {}));
        QCOMPARE(read("a.webm"), QByteArray("old")); // until it is whole
        QVERIFY((*made)->finish({}));
        const QByteArray bytes = read("a.webm");
        QCOMPARE(bytes.size(), 3 * 4 * 33 * 20);
        QCOMPARE(bytes.left(4), QByteArray("\x01\x02\x03\xff"));
        QCOMPARE(bytes.right(4), QByteArray("\x07\x08\x09\xff"));
        const QByteArray arguments = read("arguments");
        for (const char* wanted : {"-video_size 33x20", "-framerate 12.5", "libvpx-vp9", "-f webm"})
            QVERIFY2(arguments.contains(wanted), arguments.constData());
    }
};

RAMURE_SUITE(TestFilmFile)

} // namespace tst_film_file

#include "tst_film_file.moc"
