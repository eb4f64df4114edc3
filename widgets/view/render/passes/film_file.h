/// \file
/// Pictures as one film: .mp4 (H.264) or .webm (VP9). Both are encoded by ffmpeg, a program of its own, where
/// that is installed.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include <QImage>
#include <QProcess>
#include <QTemporaryFile>
#include <memory>
#include <string>

namespace ramure {

/// Endings that films have, in the order of the interface.
inline constexpr const char* filmEndings[] = {"mp4", "webm"};
/// Decides by the ending of \p path.
bool isFilm(const std::string& path);

/// Errors: Unknown (no film's ending; ffmpeg is not installed).
Expected<void> canFilm(const std::string& path);

/// All functions belong to the thread that made the object; it needs no event loop.
class FilmFile
{
public:
    /// Errors: those of canFilm(); Unknown (ffmpeg does not start), Io (no temporary file). \param size
    /// pixels; where a side is odd, ffmpeg adds a black line, as its formats ask for
    static Expected<std::unique_ptr<FilmFile>> begin(const std::string& path, QSize size,
                                                     double framesPerSecond);
    ~FilmFile(); ///< ends ffmpeg; without finish() nothing is written
    FilmFile(const FilmFile&) = delete;
    FilmFile& operator=(const FilmFile&) = delete;

    /// The next picture; transparency is left out. Errors: Invalid (another size), Cancelled, Unknown (what
    /// ffmpeg says).
    Expected<void> add(const QImage& picture, const Progress& progress);
    /// Puts the film in the place of the old one. Errors: Cancelled, Unknown (what ffmpeg says), Io; the old
    /// film is then intact.
    Expected<void> finish(const Progress& progress);

private:
    FilmFile(std::string path, QSize size);
    [[nodiscard]] tl::unexpected<Error> refuse(ErrorCode code, const char* text,
                                               const QString& why = {}) const;
    [[nodiscard]] tl::unexpected<Error> refuseAsEncoder();

    std::string m_path;
    QSize m_size;
    QTemporaryFile m_encoded;
    QProcess m_encoder;
};

} // namespace ramure
