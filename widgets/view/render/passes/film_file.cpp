#include "widgets/view/render/passes/film_file.h"

#include "core/base/file_writer.h"
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>
#include <algorithm>

namespace ramure {
namespace {

constexpr int lookEveryMs = 100;   ///< for the wish to stop
constexpr int mostWaitMs = 60'000; ///< an encoder that takes nothing for so long has hung

QByteArray filmEnding(const std::string& path)
{
    return QFileInfo(QFile::decodeName(path.c_str())).suffix().toLower().toLatin1();
}

QString encoder()
{
    return QStandardPaths::findExecutable(QStringLiteral("ffmpeg"));
}

/// Nearly without loss to the eye; the colours are marked as those of a screen (BT.709).
QStringList argumentsFor(const QByteArray& ending, QSize size, double rate, const QString& file)
{
    QStringList all{"-hide_banner", "-loglevel", "error", "-y", "-f", "rawvideo", "-pixel_format", "rgba"};
    all << "-video_size" << QStringLiteral("%1x%2").arg(size.width()).arg(size.height());
    all << "-framerate" << QString::number(rate, 'g', 12) << "-i"
        << "-";
    all << "-vf"
        << "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv";
    all << "-pix_fmt"
        << "yuv420p"
        << "-colorspace"
        << "bt709"
        << "-color_primaries"
        << "bt709";
    all << "-color_trc"
        << "bt709";
    if (ending == "mp4")
        all << "-c:v"
            << "libx264"
            << "-crf"
            << "17"
            << "-movflags"
            << "+faststart"
            << "-f"
            << "mp4";
    else
        all << "-c:v"
            << "libvpx-vp9"
            << "-crf"
            << "24"
            << "-b:v"
            << "0"
            << "-row-mt"
            << "1"
            << "-cpu-used"
            << "4"
            << "-f"
            << "webm";
    return all << file;
}

} // namespace

bool isFilm(const std::string& path)
{
    const QByteArray ending = filmEnding(path);
    return std::ranges::any_of(filmEndings, [&](const char* film) { return ending == film; });
}

Expected<void> canFilm(const std::string& path)
{
    const char* why = !isFilm(path) ? RAMURE_NOOP("films are written as .mp4 or .webm")
                      : encoder().isEmpty()
                          ? RAMURE_NOOP("films need the program ffmpeg, which is not installed; pictures "
                                        "are written without it, as .png")
                          : nullptr;
    if (!why)
        return {};
    Error error = fail(ErrorCode::Unknown, why).value();
    error.file = path;
    return fail(std::move(error));
}

FilmFile::FilmFile(std::string path, QSize size)
    : m_path(std::move(path))
    , m_size(size)
{
}

FilmFile::~FilmFile()
{
    if (m_encoder.state() == QProcess::NotRunning)
        return;
    m_encoder.kill();
    m_encoder.waitForFinished();
}

tl::unexpected<Error> FilmFile::refuse(ErrorCode code, const char* text, const QString& why) const
{
    Error error = fail(code, text, {why.toStdString()}).value();
    error.file = m_path;
    return fail(std::move(error));
}

tl::unexpected<Error> FilmFile::refuseAsEncoder()
{
    m_encoder.waitForFinished(mostWaitMs);
    const QString said = QString::fromLocal8Bit(m_encoder.readAllStandardError()).trimmed();
    return refuse(ErrorCode::Unknown, RAMURE_NOOP("ffmpeg cannot encode the film: %1"),
                  said.isEmpty() ? m_encoder.errorString() : said);
}

Expected<std::unique_ptr<FilmFile>> FilmFile::begin(const std::string& path, QSize size,
                                                    double framesPerSecond)
{
    std::unique_ptr<FilmFile> film(new FilmFile(path, size));
    RAMURE_TRY(canFilm(path));
    if (!film->m_encoded.open())
        return film->refuse(ErrorCode::Io, RAMURE_NOOP("no temporary file can be made: %1"),
                            film->m_encoded.errorString());
    film->m_encoded.close();
    film->m_encoder.start(encoder(),
                          argumentsFor(filmEnding(path), size, framesPerSecond, film->m_encoded.fileName()));
    if (!film->m_encoder.waitForStarted(mostWaitMs))
        return film->refuseAsEncoder();
    return film;
}

Expected<void> FilmFile::add(const QImage& picture, const Progress& progress)
{
    if (picture.size() != m_size)
        return refuse(ErrorCode::Invalid, RAMURE_NOOP("all pictures of a film have one size"));
    const QImage pixels = picture.convertToFormat(QImage::Format_RGBA8888);
    m_encoder.write(reinterpret_cast<const char*>(pixels.constBits()), pixels.sizeInBytes());
    for (int waited = 0; m_encoder.bytesToWrite() > 0;) {
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        const bool took = m_encoder.waitForBytesWritten(lookEveryMs);
        waited = took ? 0 : waited + lookEveryMs;
        if (m_encoder.state() == QProcess::NotRunning || waited >= mostWaitMs)
            return refuseAsEncoder();
    }
    return {};
}

Expected<void> FilmFile::finish(const Progress& progress)
{
    m_encoder.closeWriteChannel();
    while (!m_encoder.waitForFinished(lookEveryMs) && m_encoder.state() != QProcess::NotRunning)
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
    if (m_encoder.exitStatus() != QProcess::NormalExit || m_encoder.exitCode() != 0)
        return refuseAsEncoder();
    QFile encoded(m_encoded.fileName());
    if (!encoded.open(QIODevice::ReadOnly))
        return refuse(ErrorCode::Io, RAMURE_NOOP("the encoded film cannot be read: %1"),
                      encoded.errorString());
    auto writer = FileWriter::open(m_path);
    RAMURE_TRY(writer);
    while (!encoded.atEnd() && writer->isGood()) {
        const QByteArray part = encoded.read(FileWriter::largestRoom);
        if (part.isEmpty())
            return refuse(ErrorCode::Io, RAMURE_NOOP("the encoded film cannot be read: %1"),
                          encoded.errorString());
        writer->append({part.constData(), static_cast<std::size_t>(part.size())});
    }
    return writer->commit();
}

} // namespace ramure
