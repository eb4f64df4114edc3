#include "tests/support/house_sources.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

namespace ramure::test {

std::string stripped(const std::string& text)
{
    std::string code = text;
    enum class State { Code, Line, Block, Text, Char, Raw } state = State::Code;
    std::string rawEnd;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const std::string_view rest = std::string_view(text).substr(i);
        const bool digitSeparator = i > 0 && std::isalnum(static_cast<unsigned char>(text[i - 1])) != 0;
        switch (state) {
        case State::Code:
            if (rest.starts_with("//"))
                state = State::Line;
            else if (rest.starts_with("/*"))
                state = State::Block;
            else if (rest.starts_with("R\"")) {
                rawEnd = ")" + std::string(rest.substr(2, rest.find('(') - 2)) + "\"";
                state = State::Raw;
                ++i;
            } else if (c == '"')
                state = State::Text;
            else if (c == '\'' && !digitSeparator)
                state = State::Char;
            break;
        case State::Line:
            if (c == '\n')
                state = State::Code;
            break;
        case State::Block:
            if (c == '/' && text[i - 1] == '*')
                state = State::Code;
            break;
        case State::Text:
        case State::Char:
            if (c == '\\') {
                code[i++] = ' ';
                break;
            }
            if (c == (state == State::Text ? '"' : '\'') || c == '\n') {
                state = State::Code;
                continue;
            }
            break;
        case State::Raw:
            if (rest.starts_with(rawEnd)) {
                i += rawEnd.size() - 1;
                state = State::Code;
                continue;
            }
            break;
        }
        if (state != State::Code && i < code.size() && code[i] != '\n' && code[i] != '"')
            code[i] = ' ';
    }
    return code;
}

static std::vector<std::string> includesOf(const std::string& text)
{
    static const std::regex pattern(R"re((?:^|\n)[ \t]*#[ \t]*include[ \t]*([<"][^>"\n]+[>"]))re");
    std::vector<std::string> found;
    for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it)
        found.push_back((*it)[1]);
    return found;
}

std::vector<Source> readSources()
{
    namespace fs = std::filesystem;
    const fs::path root(RAMURE_SOURCE_DIR);
    std::vector<Source> sources;
    for (const char* folder : {"core", "widgets", "app", "tests"})
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
            const std::string ending = entry.path().extension().string();
            if (ending != ".h" && ending != ".cpp" && ending != ".cc")
                continue;
            std::ostringstream text;
            text << std::ifstream(entry.path()).rdbuf();
            sources.push_back({entry.path().lexically_relative(root).generic_string(), text.str(),
                               stripped(text.str()), includesOf(text.str())});
        }
    std::sort(sources.begin(), sources.end(),
              [](const Source& a, const Source& b) { return a.path < b.path; });
    return sources;
}

std::size_t lineOf(const std::string& text, std::size_t at)
{
    return static_cast<std::size_t>(
               std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n')) +
           1;
}

} // namespace ramure::test
