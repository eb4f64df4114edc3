/// \file
/// Tables of text (RFC 4180) as spreadsheets and scripts save them: quoted cells may hold separators, quotes
/// and lines.
#pragma once

#include "core/base/error.h"
#include <string>
#include <string_view>
#include <vector>

namespace ramure {

struct CsvTable
{
    struct Row
    {
        int line = 0;                   ///< line of the file where it begins, from 1
        std::vector<std::string> cells; ///< one per column
    };
    std::vector<std::string> columns; ///< at least one; no two the same, none empty, no blanks at their ends
    std::vector<Row> rows;
    char separator = ','; ///< between the cells of the file
};

/// The text is UTF-8, or UTF-16 with or without a byte order mark. Cells are separated by commas, semicolons
/// or tabs, whichever the first line has most of, or as Excel's line "sep=;" says. Lines end in LF, CR LF or
/// CR. Rows without any text are skipped, and so are columns without a name if no cell of them has a text, or
/// if the first one only numbers the rows, as pandas writes it. Errors, with file and line: Syntax (a quote
/// that is not closed or stands inside a cell, bytes that are no text), Invalid (no columns, another column
/// without a name, one that is named twice, a row of another length).
Expected<CsvTable> parseCsv(std::string_view text, const std::string& file);
/// Errors: Io, those of parseCsv.
Expected<CsvTable> readCsv(const std::string& path);
/// Returns the text as a cell of a CSV file, in quotes if it needs them.
std::string csvCell(std::string_view text);

} // namespace ramure
