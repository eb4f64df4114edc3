#include "app/cli/batch/batch_plan.h"
#include "app/cli/batch/file_hash.h"
#include "core/base/utf8.h"
#include "core/io/csv_table.h"
#include "core/io/formats/file_format.h"
#include "core/io/pivot_files.h"
#include "core/params/recipe.h"
#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QHash>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <algorithm>
#include <set>

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

constexpr const char* ourColumns[] = {"input", "preset", "seed", "name", "files"}; ///< that are no parameters

bool isOurs(const std::string& column)
{
    return column.starts_with('#') || std::ranges::find(ourColumns, column) != std::end(ourColumns);
}

bool isJoint(const std::string& column)
{
    return column.starts_with("joints[");
}

/// The column that a table means, whose author may have written "Seed".
std::string meantColumn(const std::string& written)
{
    if (written.starts_with('#'))
        return written;
    const QString name = fromText(written);
    const auto isMeant = [&name](const char* column) {
        return name.compare(QLatin1String(column), Qt::CaseInsensitive) == 0;
    };
    if (const auto* ours = std::ranges::find_if(ourColumns, isMeant); ours != std::end(ourColumns))
        return *ours;
    const auto params = paramTable();
    const auto def = std::ranges::find_if(params, isMeant, &ParamDef::key);
    return def == params.end() ? written : def->key;
}

/// The parameter that a column sets, of a step or of the tree; null: none.
const ParamDef* paramOf(const std::string& column)
{
    const auto key = parseRecipeKey(column);
    return key ? key->def : nullptr;
}

/// May its cells have a decimal comma? Vectors have commas between their numbers.
bool isNumber(const std::string& column)
{
    const ParamDef* def = paramOf(column);
    return column == "seed" || isJoint(column) ||
           (def && (def->type == ParamType::Int || def->type == ParamType::Real));
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

    Expected<void> readColumns()
    {
        std::set<std::string_view> known;
        for (std::string& column : m_cells.columns) {
            column = meantColumn(column);
            if (!isOurs(column) && !paramOf(column) && !isJoint(column))
                return failAt(m_table, 1, ErrorCode::Unknown,
                              "unknown column \"%1\": input, preset, seed, name, files, a parameter "
                              "(`ramure-cli list params`) or a note that begins with # expected",
                              {column});
            if (!known.insert(column).second)
                return failAt(m_table, 1, ErrorCode::Invalid, "column \"%1\" is there twice", {column});
        }
        if (has("input") == has("preset"))
            return failAt(m_table, 1, ErrorCode::Invalid, "one column expected of input and preset", {});
        if (m_cells.rows.empty())
            return failAt(m_table, 0, ErrorCode::Invalid, "no rows: the first line only names the columns",
                          {});
        findDecimalCommas();
        return {};
    }

    Expected<BatchRow> row(std::size_t index)
    {
        const CsvTable::Row& cells = m_cells.rows[index];
        BatchRow row;
        row.number = std::int64_t(index) + 1;
        row.line = cells.line;
        row.input = inputOf(row, cells);
        for (std::size_t i = 0; i < cells.cells.size(); ++i) {
            const std::string& column = m_cells.columns[i];
            if (!isOurs(column) && !fromText(cells.cells[i]).trimmed().isEmpty())
                row.sets << fromText(column + "=" + valueOf(row, i, cells.cells[i]));
        }
        if (const QString seed = cell(cells, "seed"); !seed.isEmpty())
            readSeed(row, seed);
        const QString own = cell(cells, "files");
        const QStringList templates = own.isEmpty() ? m_files : own.split(QLatin1Char(';'));
        for (const QString& pattern : templates) {
            auto file = fileOf(row, cells, pattern.trimmed());
            RAMURE_TRY(file);
            if (!file->isEmpty())
                row.files << *file;
        }
        return row;
    }

private:
    [[nodiscard]] std::size_t indexOf(std::string_view column) const
    {
        return std::size_t(std::ranges::find(m_cells.columns, column) - m_cells.columns.begin());
    }
    [[nodiscard]] bool has(std::string_view column) const { return indexOf(column) < m_cells.columns.size(); }
    /// Without blanks at its ends.
    [[nodiscard]] QString cell(const CsvTable::Row& row, std::string_view column) const
    {
        return has(column) ? fromText(row.cells[indexOf(column)]).trimmed() : QString();
    }

    void findDecimalCommas()
    {
        for (std::size_t i = 0; m_cells.separator != ',' && i < m_cells.columns.size(); ++i)
            m_hasDecimalCommas =
                m_hasDecimalCommas || (isNumber(m_cells.columns[i]) &&
                                       std::ranges::any_of(m_cells.rows, [i](const CsvTable::Row& row) {
                                           return row.cells[i].find(',') != std::string::npos;
                                       }));
    }

    /// A number with a decimal point, other values as they are. What may mean two numbers is the row's
    /// problem.
    std::string valueOf(BatchRow& row, std::size_t column, std::string value) const
    {
        static const QRegularExpression thousands(QStringLiteral("^\\s*[+-]?[1-9]\\d{0,2}(,\\d{3})+\\s*$"));
        const std::string& name = m_cells.columns[column];
        if (!m_hasDecimalCommas || !isNumber(name))
            return value;
        if (value.find('.') != std::string::npos)
            setProblem(row, QStringLiteral("%1: \"%2\" has a decimal point, other numbers of the table have "
                                           "decimal commas")
                                .arg(fromText(name), fromText(value)));
        else if (m_cells.separator == '\t' && thousands.match(fromText(value)).hasMatch())
            setProblem(row, QStringLiteral("%1: the comma of \"%2\" may stand before a fraction or before "
                                           "thousands: a decimal point expected")
                                .arg(fromText(name), fromText(value)));
        std::ranges::replace(value, ',', '.');
        return value;
    }

    void readSeed(BatchRow& row, const QString& text) const
    {
        const auto seed =
            parseValue(*findParam("grammar.seed"), valueOf(row, indexOf("seed"), text.toStdString()));
        if (seed && std::get<std::int64_t>(*seed) >= 0)
            row.seed = std::get<std::int64_t>(*seed);
        else
            setProblem(row, QStringLiteral("seed: \"%1\" is no whole number from 0").arg(text));
    }

    /// The first one is told.
    static void setProblem(BatchRow& row, const QString& problem)
    {
        if (row.problem.isEmpty())
            row.problem = problem;
    }

    /// Files stand beside the table.
    [[nodiscard]] QString inputOf(BatchRow& row, const CsvTable::Row& cells) const
    {
        const char* const column = has("preset") ? "preset" : "input";
        const QString input = cell(cells, column);
        if (input.isEmpty())
            setProblem(row, QStringLiteral("%1: the cell is empty").arg(QLatin1String(column)));
        if (has("preset"))
            return QStringLiteral("preset:") + input;
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
        const std::string column = meantColumn(word.trimmed().toStdString());
        if (!has(column))
            return std::nullopt;
        return column == "seed" && row.seed ? QString::number(*row.seed) : cell(cells, column);
    }

    /// Empty where an empty cell would make the name: that is the row's problem.
    Expected<QString> fileOf(BatchRow& row, const CsvTable::Row& cells, const QString& pattern)
    {
        static const QRegularExpression place(QStringLiteral("\\{([^{}]*)\\}"));
        static const QRegularExpression unsafe(QStringLiteral("[/\\\\\\x00-\\x1f]"));
        if (!isUtf8(systemPath(pattern)))
            return failAt(m_table, row.line, ErrorCode::Invalid,
                          "file \"%1\": the name is no UTF-8, and a manifest cannot hold it",
                          {pattern.toStdString()});
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
            if (word->isEmpty()) {
                setProblem(row, QStringLiteral("file \"%1\": the cell of column \"%2\" is empty")
                                    .arg(pattern, match.captured(1)));
                return QString();
            }
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
        if (file.isEmpty() || !isBelowFolder(clean))
            return failAt(m_table, row.line, ErrorCode::Invalid,
                          "file \"%1\": a name below the folder expected", {file.toStdString()});
        if (!isFolder && !clean.endsWith(QLatin1String(".png")))
            if (const auto known = findFormat(systemPath(clean), FormatUse::Write); !known)
                return failAt(m_table, row.line, ErrorCode::Unknown,
                              "file \"%1\": .png, %2, or a folder of maps that ends in / expected",
                              {file.toStdString(), endingList(FormatUse::Write)});
        for (const QString& name : isFolder ? QStringList() : ownNames(clean, WindProfile::None)) {
            if (const int before = m_lines.value(name); before > 0)
                return failAt(
                    m_table, row.line, ErrorCode::Invalid,
                    "file \"%1\": line %2 writes it too; {row} or {seed} in the name tells them apart",
                    {name.toStdString(), std::to_string(before)});
            m_lines.insert(name, row.line);
        }
        return clean;
    }

    QString m_table;
    CsvTable m_cells;
    QStringList m_files;
    bool m_hasDecimalCommas = false;
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

QStringList ownNames(const QString& file, WindProfile wind)
{
    QStringList names{file};
    const auto format = findFormat(systemPath(file), FormatUse::Write);
    if (format && *(*format)->beside != '\0')
        names << file.left(file.lastIndexOf(QLatin1Char('.')) + 1) + QLatin1String((*format)->beside);
    if (format && wind == WindProfile::PivotPainter && ((*format)->holds & holdsWind)) {
        const PivotPaths pivots = pivotPaths(file.toStdString(), {});
        names << fromText(pivots.pivots) << fromText(pivots.axes);
    }
    return names;
}

bool isBelowFolder(const QString& file)
{
    const QString clean = QDir::cleanPath(file);
    return !clean.isEmpty() && !QDir::isAbsolutePath(clean) && !clean.startsWith(QLatin1String("..")) &&
           clean != QLatin1String(".") && !clean.startsWith(QLatin1String(".row-"));
}

QString folderOf(const QString& file)
{
    return file.section(QLatin1Char('/'), 0, -2);
}

Expected<BatchPlan> readPlan(const QString& table, const QStringList& files, const Shard& shard)
{
    auto cells = readCsv(systemPath(table));
    RAMURE_TRY(cells);
    BatchPlan plan;
    plan.table = QFileInfo(table).fileName();
    plan.whole = cells->rows.size();
    Reader reader(table, std::move(*cells), files);
    RAMURE_TRY(reader.readColumns());
    // All rows are looked at, so that every shard refuses the same tables.
    for (std::size_t i = 0; i < plan.whole; ++i) {
        auto row = reader.row(i);
        RAMURE_TRY(row);
        if (i >= shard.begin(plan.whole) && i < shard.end(plan.whole))
            plan.rows.push_back(std::move(*row));
        else
            for (const QString& file : row->files)
                plan.foreignFolders.insert(folderOf(file));
    }
    return plan;
}

QByteArray inputsHash(const BatchPlan& plan, const BatchRow& row)
{
    const bool isFile =
        !row.input.startsWith(QLatin1String("preset:")) && !row.input.startsWith(QLatin1String("demo:"));
    QStringList levels{QString::number(plan.options.levels.count)};
    for (const ExportOption& option : exportOptions())
        if (option.hashed && !isUsual(option, plan.options))
            levels += QString::fromLatin1(option.hashed)
                          .replace(QLatin1String("%1"), fromText(optionText(option, plan.options)))
                          .split(QLatin1Char(','));
    const QJsonObject inputs{
        {QStringLiteral("program"), versionText().trimmed()},
        {QStringLiteral("input"), isFile ? QString::fromLatin1(contentHash(row.input)) : row.input},
        {QStringLiteral("seed"), row.seed ? QString::number(*row.seed) : QString()},
        {QStringLiteral("set"), QJsonArray::fromStringList(row.sets)},
        {QStringLiteral("files"), QJsonArray::fromStringList(row.files)},
        {QStringLiteral("mapSize"), plan.options.write.mapSize},
        {QStringLiteral("levels"), QJsonArray::fromStringList(levels)},
        {QStringLiteral("picture"),
         QStringLiteral("%1x%2").arg(plan.picture.width()).arg(plan.picture.height())}};
    return QCryptographicHash::hash(QJsonDocument(inputs).toJson(QJsonDocument::Compact),
                                    QCryptographicHash::Sha256)
        .toHex();
}

} // namespace ramure::cli
