/// \file
/// The sources of the program as text, for suites that keep the rules of the house.
#pragma once

#include <string>
#include <vector>

namespace ramure::test {

struct Source
{
    std::string path; ///< relative to the source folder, with forward slashes
    std::string text;
    std::string code; ///< the text with comments and the insides of literals blanked out, line for line
    std::vector<std::string> includes;
};

/// Returns \p text with comments and literals blanked out; the lines stay where they are.
std::string stripped(const std::string& text);
/// All headers and sources of core, widgets, app and tests, by path.
std::vector<Source> readSources();
/// The number of the line on which \p at stands, from 1.
std::size_t lineOf(const std::string& text, std::size_t at);

} // namespace ramure::test
