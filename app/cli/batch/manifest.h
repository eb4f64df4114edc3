/// \file
/// The manifest of a batch: a line of JSON for each row, in the order of the rows. While a batch works, lines
/// go to a journal beside it, MANIFEST.journal, as they come.
#pragma once

#include "core/base/error.h"
#include <QByteArray>
#include <QJsonObject>
#include <QString>
#include <map>
#include <vector>

namespace ramure::cli {

/// Lines by the number of their row.
using ManifestLines = std::map<std::int64_t, QJsonObject>;

QByteArray lineText(const QJsonObject& line); ///< with its end

/// Every line of a manifest. Errors, with file and line: Io, Syntax (no JSON), Invalid (no row).
Expected<ManifestLines> readManifest(const QString& path);

/// A manifest that is being made. Another process that makes the same one is waited for.
class ManifestWriter
{
public:
    /// \param resume keeps the lines of earlier runs, including killed ones; else they are forgotten. Error:
    /// Io.
    static Expected<ManifestWriter> open(const QString& path, bool resume);
    ManifestWriter(ManifestWriter&& other) noexcept;
    ManifestWriter& operator=(ManifestWriter&&) = delete;
    ~ManifestWriter(); ///< leaves the journal for the next run

    /// All lines that earlier runs wrote, even if this run starts anew.
    [[nodiscard]] const ManifestLines& before() const { return m_before; }
    /// The lines that this run continues, and those it added.
    [[nodiscard]] const ManifestLines& lines() const { return m_lines; }
    /// Error: Io.
    Expected<void> add(const QJsonObject& line);
    /// Writes the lines of these rows in the manifest's place, all or nothing, and ends the journal. Error:
    /// Io.
    Expected<void> commit(const std::vector<std::int64_t>& rows);

private:
    ManifestWriter(QString path, int journal);
    void read(const QString& file);

    QString m_path;
    int m_journal;
    ManifestLines m_lines, m_before;
};

} // namespace ramure::cli
