#include "app/cli/batch/manifest.h"
#include "app/cli/command_line.h"
#include "core/base/file_writer.h"
#include <QFile>
#include <QJsonDocument>
#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace ramure::cli {

namespace {

QString journalOf(const QString& path)
{
    return path + QStringLiteral(".journal");
}

tl::unexpected<Error> ioError(const QString& path)
{
    return fail(writeError(systemPath(path), errno));
}

/// Of a line of JSON, 0 where it is none.
std::int64_t rowOf(const QJsonObject& line)
{
    return line.value(QStringLiteral("row")).toInteger();
}

} // namespace

QByteArray lineText(const QJsonObject& line)
{
    return QJsonDocument(line).toJson(QJsonDocument::Compact) + '\n';
}

Expected<ManifestLines> readManifest(const QString& path)
{
    QFile file;
    RAMURE_TRY(openToRead(file, path));
    ManifestLines lines;
    for (int number = 1; !file.atEnd(); ++number) {
        QJsonParseError problem;
        const QJsonObject line = QJsonDocument::fromJson(file.readLine(), &problem).object();
        Error error;
        error.file = systemPath(path);
        error.line = number;
        if (problem.error != QJsonParseError::NoError) {
            error.code = ErrorCode::Syntax;
            error.text = "no JSON: %1";
            error.args = {problem.errorString().toStdString()};
            return fail(std::move(error));
        }
        if (rowOf(line) < 1) {
            error.text = "no line of a manifest: \"row\" expected";
            return fail(std::move(error));
        }
        lines[rowOf(line)] = line;
    }
    return lines;
}

ManifestWriter::ManifestWriter(QString path, int journal)
    : m_path(std::move(path))
    , m_journal(journal)
{
}

ManifestWriter::ManifestWriter(ManifestWriter&& other) noexcept
    : m_path(std::move(other.m_path))
    , m_journal(std::exchange(other.m_journal, -1))
    , m_lines(std::move(other.m_lines))
    , m_before(std::move(other.m_before))
{
}

ManifestWriter::~ManifestWriter()
{
    if (m_journal >= 0)
        ::close(m_journal);
}

Expected<ManifestWriter> ManifestWriter::open(const QString& path, bool resume)
{
    const std::string journal = systemPath(journalOf(path));
    for (;;) {
        const int file = ::open(journal.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
        if (file < 0)
            return ioError(journalOf(path));
        ManifestWriter writer(path, file);
        if (::flock(file, LOCK_EX) != 0 && errno != ENOLCK && errno != EOPNOTSUPP)
            return ioError(journalOf(path));
        // Whoever held the lock may have ended the journal: then this one is no longer in the folder.
        struct stat mine = {}, there = {};
        if (::fstat(file, &mine) != 0 || ::stat(journal.c_str(), &there) != 0 || mine.st_ino != there.st_ino)
            continue;
        writer.read(path);
        writer.read(journalOf(path));
        if (resume) {
            writer.m_lines = writer.m_before;
            if (mine.st_size > 0 && ::write(file, "\n", 1) != 1) // the last line may be torn
                return ioError(journalOf(path));
        } else {
            ::unlink(systemPath(path).c_str());
            if (::ftruncate(file, 0) != 0)
                return ioError(journalOf(path));
        }
        return writer;
    }
}

/// What a kill tore is no line; later lines count.
void ManifestWriter::read(const QString& path)
{
    QFile file;
    if (!openToRead(file, path))
        return;
    while (!file.atEnd()) {
        const QJsonObject line = QJsonDocument::fromJson(file.readLine()).object();
        if (rowOf(line) > 0)
            m_before[rowOf(line)] = line;
    }
}

Expected<void> ManifestWriter::add(const QJsonObject& line)
{
    const QByteArray text = lineText(line);
    if (::write(m_journal, text.constData(), std::size_t(text.size())) != text.size())
        return ioError(journalOf(m_path));
    m_lines[rowOf(line)] = line;
    return {};
}

Expected<void> ManifestWriter::commit(const std::vector<std::int64_t>& rows)
{
    auto file = FileWriter::open(systemPath(m_path));
    RAMURE_TRY(file);
    for (const std::int64_t row : rows)
        if (const auto found = m_lines.find(row); found != m_lines.end())
            file->append(lineText(found->second).toStdString());
    if (auto written = file->commit(); !written)
        return written;
    ::unlink(systemPath(journalOf(m_path)).c_str());
    return {};
}

} // namespace ramure::cli
