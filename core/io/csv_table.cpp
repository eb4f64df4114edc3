#include "core/io/csv_table.h"
#include "core/io/read_parts.h"
#include <algorithm>

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
        if (m_rest.starts_with("\xEF\xBB\xBF"))
            m_rest.remove_prefix(3);
    }

    [[nodiscard]] bool atEnd() const { return m_rest.empty(); }

    Expected<CsvTable::Row> row()
    {
        CsvTable::Row row{m_line, {}};
        for (;;) {
            auto cell = m_rest.starts_with('"') ? quoted() : plain();
            if (!cell)
                return fail(std::move(cell.error()));
            row.cells.push_back(std::move(*cell));
            const bool more = m_rest.starts_with(',');
            if (!m_rest.empty())
                m_rest.remove_prefix(m_rest.starts_with("\r\n") ? 2 : 1);
            if (more)
                continue;
            ++m_line;
            return row;
        }
    }

private:
    [[nodiscard]] bool atBorder() const
    {
        return m_rest.empty() || m_rest.starts_with(',') || m_rest.starts_with('\n') ||
               m_rest.starts_with("\r\n");
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
                                  RAMURE_NOOP("text behind a quoted cell: a comma expected"));
            }
            if (letter == '\n')
                ++m_line;
            cell += letter;
        }
        return failAt(m_file, begun, ErrorCode::Syntax, RAMURE_NOOP("a quote that is not closed"));
    }

    std::string_view m_rest;
    std::string m_file;
    int m_line = 1;
};

Expected<void> checkColumns(const CsvTable::Row& head, const std::string& file)
{
    if (const auto found = std::ranges::find(head.cells, ""); found != head.cells.end())
        return failAt(file, head.line, ErrorCode::Invalid, RAMURE_NOOP("column %1 has no name"),
                      {std::to_string(found - head.cells.begin() + 1)});
    // Sorted: a table that is no table may have a million of them.
    std::vector<std::string_view> names(head.cells.begin(), head.cells.end());
    std::ranges::sort(names);
    if (const auto twice = std::ranges::adjacent_find(names); twice != names.end())
        return failAt(file, head.line, ErrorCode::Invalid, RAMURE_NOOP("column \"%1\" is there twice"),
                      {std::string(*twice)});
    return {};
}

bool isBlank(const CsvTable::Row& row)
{
    return row.cells.size() == 1 && row.cells.front().empty();
}

} // namespace

Expected<CsvTable> parseCsv(std::string_view text, const std::string& file)
{
    CsvTable table;
    Reader reader(text, file);
    while (!reader.atEnd()) {
        auto row = reader.row();
        if (!row)
            return fail(std::move(row.error()));
        if (isBlank(*row))
            continue;
        if (table.columns.empty()) {
            if (auto checked = checkColumns(*row, file); !checked)
                return fail(std::move(checked.error()));
            table.columns = std::move(row->cells);
            continue;
        }
        if (row->cells.size() != table.columns.size())
            return failAt(file, row->line, ErrorCode::Invalid,
                          RAMURE_NOOP("%1 cells, and there are %2 columns"),
                          {std::to_string(row->cells.size()), std::to_string(table.columns.size())});
        table.rows.push_back(std::move(*row));
    }
    if (table.columns.empty())
        return failAt(file, 0, ErrorCode::Invalid, RAMURE_NOOP("no columns: the first line names them"));
    return table;
}

Expected<CsvTable> readCsv(const std::string& path)
{
    auto file = reading::InputFile::open(path);
    if (!file)
        return fail(std::move(file.error()));
    const auto bytes = reading::loadFile(*file, path);
    if (!bytes)
        return fail(bytes.error());
    return parseCsv(bytes->view(), path);
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
