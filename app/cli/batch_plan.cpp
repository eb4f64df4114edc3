#include "app/cli/batch_plan.h"
#include "app/cli/file_hash.h"
#include "core/io/csv_table.h"
#include "core/io/formats/file_format.h"
#include "core/params/param_def.h"
#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QHash>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <algorithm>

namespace ramure::cli {

namespace {

constexpr int rowDigits = 6;         ///< of {row}: names sort as the rows do
constexpr std::int64_t block = 1000; ///< rows in a {block}: a folder that file systems still like

tl::unexpected<Error> failAt(const QString& table, int line, ErrorCode code, const char* text,
                             std::vector<std::string> args)
{
    Error error;
    error.code = code;
    error.text = text;
    error.args = std::move(args);
    error.file = systemPath(table);
    error.line = line;
    return fail(std::move(error));
}

/// Columns that are no parameters.
bool isOurs(const std::string& column)
{
    return column == "input" || column == "preset" || column == "seed" || column == "name" ||
           column == "files" || column.starts_with('#');
}

/// A table while it is turned into rows.
class Reader
{
public:
    Reader(QString table, CsvTable cells, QStringList files)
        : m_table(std::move(table))
        , m_cells(std::move(cells))
        , m_files(std::move(files))
    {
    }

    Expected<void> checkColumns() const
    {
        for (const std::string& column : m_cells.columns)
            if (!isOurs(column) && !findParam(column) && !column.starts_with("joints["))
                return failAt(m_table, 1, ErrorCode::Unknown,
                              "unknown column \"%1\": input, preset, seed, name, files, a parameter "
                              "(`ramure-cli list params`) or a note that begins with # expected",
                              {column});
        if (has("input") == has("preset"))
            return failAt(m_table, 1, ErrorCode::Invalid, "one column expected of input and preset", {});
        if (m_cells.rows.empty())
            return failAt(m_table, 0, ErrorCode::Invalid, "no rows: the first line only names the columns",
                          {});
        return {};
    }

    Expected<BatchRow> row(std::size_t index)
    {
        const CsvTable::Row& cells = m_cells.rows[index];
        BatchRow row;
        row.number = std::int64_t(index) + 1;
        row.line = cells.line;
        row.input = inputOf(cells);
        for (std::size_t i = 0; i < cells.cells.size(); ++i) {
            const std::string& column = m_cells.columns[i];
            if (!isOurs(column) && !cells.cells[i].empty())
                row.sets << fromText(column + "=" + cells.cells[i]);
        }
        if (const QString seed = cell(cells, "seed"); !seed.isEmpty()) {
            bool isNumber = false;
            row.seed = seed.toLongLong(&isNumber);
            if (!isNumber || *row.seed < 0)
                row.problem = QStringLiteral("seed: \"%1\" is no whole number from 0").arg(seed);
        }
        const QString own = cell(cells, "files");
        const QStringList templates = own.isEmpty() ? m_files : own.split(QLatin1Char(';'));
        for (const QString& pattern : templates) {
            auto file = fileOf(row, cells, pattern.trimmed());
            if (!file)
                return fail(std::move(file.error()));
            row.files << *file;
        }
        return row;
    }

private:
    [[nodiscard]] bool has(const char* column) const
    {
        return std::ranges::find(m_cells.columns, column) != m_cells.columns.end();
    }
    [[nodiscard]] QString cell(const CsvTable::Row& row, std::string_view column) const
    {
        const auto found = std::ranges::find(m_cells.columns, column);
        return found == m_cells.columns.end()
                   ? QString()
                   : fromText(row.cells[std::size_t(found - m_cells.columns.begin())]);
    }

    /// Files stand beside the table.
    [[nodiscard]] QString inputOf(const CsvTable::Row& row) const
    {
        if (has("preset"))
            return QStringLiteral("preset:") + cell(row, "preset");
        const QString input = cell(row, "input");
        return input.startsWith(QLatin1String("preset:")) || input.startsWith(QLatin1String("demo:"))
                   ? input
                   : QFileInfo(m_table).dir().filePath(input);
    }

    /// What stands for {word}; nothing: there is no such column.
    [[nodiscard]] std::optional<QString> wordOf(const BatchRow& row, const CsvTable::Row& cells,
                                                const QString& word) const
    {
        if (word == QLatin1String("row"))
            return QStringLiteral("%1").arg(row.number, rowDigits, 10, QLatin1Char('0'));
        if (word == QLatin1String("block"))
            return QStringLiteral("%1").arg(row.number / block, rowDigits, 10, QLatin1Char('0'));
        if (word == QLatin1String("preset"))
            return row.input.contains(QLatin1Char(':')) ? row.input.section(QLatin1Char(':'), 1)
                                                        : QFileInfo(row.input).completeBaseName();
        if (!has(word.toUtf8().constData()))
            return std::nullopt;
        return cell(cells, word.toStdString());
    }

    Expected<QString> fileOf(const BatchRow& row, const CsvTable::Row& cells, const QString& pattern)
    {
        static const QRegularExpression place(QStringLiteral("\\{([^{}]*)\\}"));
        static const QRegularExpression unsafe(QStringLiteral("[/\\\\\\x00-\\x1f]"));
        QString file;
        qsizetype from = 0;
        for (auto found = place.globalMatch(pattern); found.hasNext();) {
            const QRegularExpressionMatch match = found.next();
            auto word = wordOf(row, cells, match.captured(1));
            if (!word)
                return failAt(
                    m_table, row.line, ErrorCode::Unknown,
                    "file \"%1\": there is no column \"%2\", and {row}, {block} and {preset} are all "
                    "there is besides",
                    {pattern.toStdString(), match.captured(1).toStdString()});
            file +=
                pattern.mid(from, match.capturedStart() - from) + word->replace(unsafe, QStringLiteral("_"));
            from = match.capturedEnd();
        }
        file += pattern.mid(from);
        return checked(row, file);
    }

    Expected<QString> checked(const BatchRow& row, const QString& file)
    {
        const bool isFolder = file.endsWith(QLatin1Char('/'));
        const QString clean = QDir::cleanPath(file) + QLatin1String(isFolder ? "/" : "");
        if (file.isEmpty() || QDir::isAbsolutePath(clean) || clean.startsWith(QLatin1String("..")) ||
            clean.startsWith(QLatin1String("./")) || clean.startsWith(QLatin1String(".row-")))
            return failAt(m_table, row.line, ErrorCode::Invalid,
                          "file \"%1\": a name below the folder expected", {file.toStdString()});
        if (!isFolder && !clean.endsWith(QLatin1String(".png")))
            if (const auto known = findFormat(systemPath(clean), FormatUse::Write); !known)
                return failAt(m_table, row.line, ErrorCode::Unknown,
                              "file \"%1\": .png, %2, or a folder of maps that ends in / expected",
                              {file.toStdString(), endingList(FormatUse::Write)});
        const int before = m_lines.value(clean);
        if (!isFolder && before > 0)
            return failAt(m_table, row.line, ErrorCode::Invalid,
                          "file \"%1\": line %2 writes it too; {row} or {seed} in the name tells them apart",
                          {file.toStdString(), std::to_string(before)});
        m_lines.insert(clean, row.line);
        return clean;
    }

    QString m_table;
    CsvTable m_cells;
    QStringList m_files;
    QHash<QString, int> m_lines; ///< files there are, and whose
};

/// Read once for each file, not for each row. Empty where it cannot be read: the row will say why.
QByteArray contentHash(const QString& input)
{
    static QHash<QString, QByteArray> known;
    auto found = known.find(input);
    if (found == known.end())
        found = known.insert(input, sha256Of(input));
    return *found;
}

} // namespace

Expected<Shard> shardFrom(const QString& text)
{
    const QStringList parts = text.split(QLatin1Char('/'));
    bool isIndex = false, isCount = false;
    const Shard shard{parts.front().toUInt(&isIndex), parts.back().toUInt(&isCount)};
    if (parts.size() != 2 || !isIndex || !isCount || shard.index < 1 || shard.index > shard.count)
        return fail(ErrorCode::Invalid, "--shard \"%1\": I/N expected, I from 1 to N", {text.toStdString()});
    return shard;
}

Expected<BatchPlan> readPlan(const QString& table, const QStringList& files, const Shard& shard)
{
    auto cells = readCsv(systemPath(table));
    if (!cells)
        return fail(std::move(cells.error()));
    BatchPlan plan;
    plan.table = QFileInfo(table).fileName();
    plan.whole = cells->rows.size();
    Reader reader(table, std::move(*cells), files);
    if (const auto good = reader.checkColumns(); !good)
        return fail(good.error());
    // All rows are looked at, so that every shard refuses the same tables.
    for (std::size_t i = 0; i < plan.whole; ++i) {
        auto row = reader.row(i);
        if (!row)
            return fail(std::move(row.error()));
        if (i >= shard.begin(plan.whole) && i < shard.end(plan.whole))
            plan.rows.push_back(std::move(*row));
    }
    return plan;
}

QByteArray inputsHash(const BatchPlan& plan, const BatchRow& row)
{
    const bool isFile =
        !row.input.startsWith(QLatin1String("preset:")) && !row.input.startsWith(QLatin1String("demo:"));
    QStringList levels{QString::number(plan.levels.count)};
    if (plan.isCompressed)
        levels << QStringLiteral("compressed");
    for (const WindProfileFacts& facts : windProfiles())
        if (facts.profile == plan.wind)
            levels << QLatin1String(facts.name);
    for (const std::int64_t budget : plan.levels.budgets)
        levels << QString::number(budget);
    if (const std::string switches = switchesText(plan.levels); !switches.empty())
        levels << QString::fromStdString(switches);
    const QJsonObject inputs{
        {QStringLiteral("program"), versionText().trimmed()},
        {QStringLiteral("input"), isFile ? QString::fromLatin1(contentHash(row.input)) : row.input},
        {QStringLiteral("seed"), row.seed ? QString::number(*row.seed) : QString()},
        {QStringLiteral("set"), QJsonArray::fromStringList(row.sets)},
        {QStringLiteral("files"), QJsonArray::fromStringList(row.files)},
        {QStringLiteral("mapSize"), plan.mapSize},
        {QStringLiteral("levels"), QJsonArray::fromStringList(levels)},
        {QStringLiteral("picture"),
         QStringLiteral("%1x%2").arg(plan.picture.width()).arg(plan.picture.height())}};
    return QCryptographicHash::hash(QJsonDocument(inputs).toJson(QJsonDocument::Compact),
                                    QCryptographicHash::Sha256)
        .toHex();
}

} // namespace ramure::cli
