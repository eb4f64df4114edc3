/// \file
/// Tables of text with commas between the cells (RFC 4180): quoted cells may hold commas, quotes and lines.
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
        int line = 0;                   ///< of the file where it begins, from 1
        std::vector<std::string> cells; ///< as many as there are columns
    };
    std::vector<std::string> columns; ///< at least one; no two the same, none empty
    std::vector<Row> rows;
};

/// Lines with nothing in them are skipped, so is a byte order mark. Errors, with file and line: Syntax (a
/// quote that is not closed or stands inside a cell), Invalid (no columns, a column without a name or named
/// twice, a row of another length).
Expected<CsvTable> parseCsv(std::string_view text, const std::string& file);
/// Errors: Io, those of parseCsv.
Expected<CsvTable> readCsv(const std::string& path);
/// In quotes where it has to be.
std::string csvCell(std::string_view text);

} // namespace ramure
