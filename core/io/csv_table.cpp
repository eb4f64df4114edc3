#include "core/io/csv_table.h"
#include "core/base/plain_text.h"
#include "core/base/utf8.h"
#include "core/io/read_parts.h"
#include <algorithm>
#include <array>

namespace ramure {

namespace {

tl::unexpected<Error> failAt(const std::string& file, int line, ErrorCode code, const char* text,
                             std::vector<std::string> args = {})
{
    Error error;
    error.code = code;
    error.text = text;
    error.args = std::move(args);
    error.file = file;
    error.line = line;
    return fail(std::move(error));
}

/// Takes a text apart, row by row.
class Reader
{
public:
    Reader(std::string_view text, const std::string& file)
        : m_rest(text)
        , m_file(file)
    {
        constexpr std::string_view said = "sep="; // as Excel has it
        if (m_rest.starts_with(said) && m_rest.size() > said.size() + 1 &&
            isLineEnd(m_rest[said.size() + 1])) {
            m_separator = m_rest[said.size()];
            m_rest.remove_prefix(said.size() + 1);
            endLine();
        } else {
            m_separator = mostFrequent();
        }
    }

    [[nodiscard]] bool atEnd() const { return m_rest.empty(); }
    [[nodiscard]] char separator() const { return m_separator; }

    Expected<CsvTable::Row> row()
    {
        CsvTable::Row row{m_line, {}};
        for (;;) {
            auto cell = m_rest.starts_with('"') ? quoted() : plain();
            RAMURE_TRY(cell);
            row.cells.push_back(std::move(*cell));
            if (!m_rest.starts_with(m_separator)) {
                endLine();
                return row;
            }
            m_rest.remove_prefix(1);
        }
    }

private:
    static bool isLineEnd(char letter) { return letter == '\n' || letter == '\r'; }
    [[nodiscard]] bool atBorder() const
    {
        return m_rest.empty() || m_rest.front() == m_separator || isLineEnd(m_rest.front());
    }
    void endLine()
    {
        if (!m_rest.empty())
            m_rest.remove_prefix(m_rest.starts_with("\r\n") ? 2 : 1);
        ++m_line;
    }

    /// Of the separators that the first line with text has outside of quotes.
    [[nodiscard]] char mostFrequent() const
    {
        constexpr std::string_view known = ",;\t"; // the first one where none is more frequent
        std::array<std::size_t, known.size()> counts{};
        bool isQuoted = false;
        const std::size_t begin = std::min(m_rest.find_first_not_of("\r\n"), m_rest.size());
        for (const char letter : m_rest.substr(begin)) {
            if (letter == '"')
                isQuoted = !isQuoted;
            if (isQuoted)
                continue;
            if (isLineEnd(letter))
                break;
            if (const std::size_t at = known.find(letter); at != std::string_view::npos)
                ++counts[at];
        }
        return known[static_cast<std::size_t>(std::ranges::max_element(counts) - counts.begin())];
    }

    Expected<std::string> plain()
    {
        std::string cell;
        for (; !atBorder(); m_rest.remove_prefix(1)) {
            if (m_rest.front() == '"')
                return failAt(m_file, m_line, ErrorCode::Syntax,
                              RAMURE_NOOP("a quote inside a cell: the whole cell has to be quoted"));
            cell += m_rest.front();
        }
        return cell;
    }

    Expected<std::string> quoted()
    {
        const int begun = m_line;
        std::string cell;
        for (m_rest.remove_prefix(1); !m_rest.empty(); m_rest.remove_prefix(1)) {
            const char letter = m_rest.front();
            if (letter == '"') {
                m_rest.remove_prefix(1);
                if (atBorder())
                    return cell;
                if (!m_rest.starts_with('"'))
                    return failAt(m_file, m_line, ErrorCode::Syntax,
                                  RAMURE_NOOP("text behind a quoted cell: a separator expected"));
            }
            if (letter == '\n')
                ++m_line;
            cell += letter;
        }
        return failAt(m_file, begun, ErrorCode::Syntax, RAMURE_NOOP("a quote that is not closed"));
    }

    std::string_view m_rest;
    std::string m_file;
    char m_separator = ',';
    int m_line = 1;
};

bool isBlank(std::string_view text)
{
    return reading::trimmed(text).empty();
}

Expected<void> checkText(const CsvTable::Row& row, const std::vector<std::string>& columns,
                         const std::string& file)
{
    for (std::size_t i = 0; i < row.cells.size(); ++i)
        if (!isUtf8(row.cells[i]))
            return failAt(file, row.line, ErrorCode::Syntax,
                          RAMURE_NOOP("column \"%1\": bytes that are no text in UTF-8 or UTF-16"),
                          {i < columns.size() && !columns[i].empty() ? columns[i] : std::to_string(i + 1)});
    return {};
}

Expected<void> checkColumns(const CsvTable& table, int line, const std::string& file)
{
    if (const auto found = std::ranges::find(table.columns, ""); found != table.columns.end())
        return failAt(file, line, ErrorCode::Invalid, RAMURE_NOOP("column %1 has no name"),
                      {std::to_string(found - table.columns.begin() + 1)});
    // Sorted: a table that is no table may have a million of them.
    std::vector<std::string_view> names(table.columns.begin(), table.columns.end());
    std::ranges::sort(names);
    if (const auto twice = std::ranges::adjacent_find(names); twice != names.end())
        return failAt(file, line, ErrorCode::Invalid, RAMURE_NOOP("column \"%1\" is there twice"),
                      {std::string(*twice)});
    return {};
}

/// Drops columns that have no name and say nothing; see parseCsv.
void dropNameless(CsvTable& table)
{
    const auto saysNothing = [&](std::size_t column) {
        const auto all = [&](auto is) {
            return std::ranges::all_of(table.rows, [&](const auto& row) { return is(row.cells[column]); });
        };
        const auto isNumber = [](const std::string& cell) {
            return !cell.empty() && cell.find_first_not_of("0123456789") == std::string::npos;
        };
        return table.columns[column].empty() && (all(&isBlank) || (column == 0 && all(isNumber)));
    };
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < table.columns.size(); ++i)
        if (!saysNothing(i))
            kept.push_back(i);
    if (kept.size() == table.columns.size())
        return;
    const auto keep = [&kept](std::vector<std::string>& cells) {
        std::vector<std::string> left;
        for (const std::size_t i : kept)
            left.push_back(std::move(cells[i]));
        cells = std::move(left);
    };
    keep(table.columns);
    for (CsvTable::Row& row : table.rows)
        keep(row.cells);
}

} // namespace

Expected<CsvTable> parseCsv(std::string_view bytes, const std::string& file)
{
    const PlainText text(bytes);
    if (!text.isWhole())
        return failAt(file, 0, ErrorCode::Syntax, RAMURE_NOOP("this is neither UTF-8 nor whole UTF-16"));
    CsvTable table;
    Reader reader(text.view(), file);
    table.separator = reader.separator();
    int head = 0;
    while (!reader.atEnd()) {
        auto row = reader.row();
        RAMURE_TRY(row);
        if (std::ranges::all_of(row->cells, &isBlank))
            continue;
        RAMURE_TRY(checkText(*row, table.columns, file));
        if (head == 0) {
            head = row->line;
            for (const std::string& name : row->cells)
                table.columns.emplace_back(reading::trimmed(name));
            continue;
        }
        if (row->cells.size() != table.columns.size())
            return failAt(file, row->line, ErrorCode::Invalid,
                          RAMURE_NOOP("%1 cells, and there are %2 columns"),
                          {std::to_string(row->cells.size()), std::to_string(table.columns.size())});
        table.rows.push_back(std::move(*row));
    }
    if (head == 0)
        return failAt(file, 0, ErrorCode::Invalid, RAMURE_NOOP("no columns: the first line names them"));
    dropNameless(table);
    RAMURE_TRY(checkColumns(table, head, file));
    return table;
}

Expected<CsvTable> readCsv(const std::string& path)
{
    const auto bytes = reading::loadFile(path);
    RAMURE_TRY(bytes);
    return parseCsv(*bytes, path);
}

std::string csvCell(std::string_view text)
{
    if (text.find_first_of(",\"\r\n") == std::string_view::npos)
        return std::string(text);
    std::string cell = "\"";
    for (const char letter : text)
        cell.append(letter == '"' ? 2 : 1, letter);
    return cell + '"';
}

} // namespace ramure
