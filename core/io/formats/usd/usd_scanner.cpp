#include "core/io/formats/usd/usd_scanner.h"

#include "core/io/read_parts.h"
#include <algorithm>
#include <cmath>

namespace ramure::usd {
namespace {

constexpr int deepestValue = 32;
constexpr std::size_t mostNumbers = 400'000'000;

bool isWordPart(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           static_cast<unsigned char>(c) >= 0x80;
}

int hexValue(char c)
{
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
}

} // namespace

bool Scanner::refuse(ErrorCode code, const char* text, std::vector<std::string> args)
{
    m_problem = fail(code, text, std::move(args)).value();
    m_problem.line = m_line;
    m_problem.column = static_cast<int>(m_at - std::min(m_at, m_lineBegin)) + 1;
    return false;
}

/// What stands next, for messages.
std::string Scanner::excerpt() const
{
    if (m_at >= m_text.size())
        return "the end of the file";
    const std::string_view rest = m_text.substr(m_at, 24);
    return '"' + reading::excerpt(rest.substr(0, rest.find('\n'))) + '"';
}

bool Scanner::takeHeader()
{
    if (m_text.starts_with("\xEF\xBB\xBF"))
        m_at = 3;
    if (m_text.substr(m_at).starts_with("#usda 1."))
        return true;
    if (m_text.starts_with("PXR-USDC"))
        return refuse(ErrorCode::Version, RAMURE_NOOP("a binary USD file: only USD as text can be read"));
    return refuse(ErrorCode::Syntax, RAMURE_NOOP("no USD file: its first line is not \"#usda 1.0\""));
}

char Scanner::peek()
{
    while (m_at < m_text.size()) {
        const char c = m_text[m_at];
        if (c == '\n') {
            ++m_line;
            m_lineBegin = ++m_at;
        } else if (reading::isBlank(c)) {
            ++m_at;
        } else if (c == '#' || (c == '/' && at(1) == '/')) {
            m_at = std::min(m_text.find('\n', m_at), m_text.size());
        } else if (c == '/' && at(1) == '*') {
            const std::size_t end = std::min(m_text.find("*/", m_at + 2), m_text.size() - 2) + 2;
            m_line += static_cast<int>(std::count(m_text.begin() + static_cast<std::ptrdiff_t>(m_at),
                                                  m_text.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
            m_at = end;
        } else {
            return c;
        }
    }
    return 0;
}

bool Scanner::takes(char c)
{
    if (peek() != c || m_at >= m_text.size())
        return false;
    ++m_at;
    return true;
}

bool Scanner::expect(char c)
{
    return takes(c) || refuse(ErrorCode::Syntax, RAMURE_NOOP("%1 where \"%2\" has to stand"),
                              {excerpt(), std::string(1, c)});
}

bool Scanner::word(std::string& out)
{
    peek();
    const std::size_t begin = m_at;
    while (isWordPart(at(0)))
        ++m_at;
    out = m_text.substr(begin, m_at - begin);
    return !out.empty() ||
           refuse(ErrorCode::Syntax, RAMURE_NOOP("%1 where a word has to stand"), {excerpt()});
}

bool Scanner::name(std::string& out)
{
    peek();
    const std::size_t begin = m_at;
    while (isWordPart(at(0)) || at(0) == ':' || at(0) == '.')
        ++m_at;
    out = m_text.substr(begin, m_at - begin);
    const bool isWhole = !out.empty() && isWordPart(out.front()) && isWordPart(out.back());
    return isWhole || refuse(ErrorCode::Syntax, RAMURE_NOOP("%1 where a name has to stand"), {excerpt()});
}

bool Scanner::string(std::string& out)
{
    const char quote = peek();
    if (quote != '"' && quote != '\'')
        return refuse(ErrorCode::Syntax, RAMURE_NOOP("%1 where a text has to stand"), {excerpt()});
    const bool isLong = at(1) == quote && at(2) == quote;
    m_at += isLong ? 3 : 1;
    out.clear();
    for (;; ++m_at) {
        if (m_at >= m_text.size() || (!isLong && at(0) == '\n'))
            return refuse(ErrorCode::Syntax, RAMURE_NOOP("a text without an end"));
        const char c = at(0);
        if (c == quote && (!isLong || (at(1) == quote && at(2) == quote)))
            break;
        if (c == '\n') {
            ++m_line;
            m_lineBegin = m_at + 1;
        }
        if (c != '\\') {
            out += c;
            continue;
        }
        ++m_at;
        const int high = hexValue(at(1)), low = hexValue(at(2));
        if (at(0) == 'x' && high >= 0 && low >= 0) {
            out += static_cast<char>(16 * high + low);
            m_at += 2;
        } else if (m_at < m_text.size()) {
            out += at(0) == 'n' ? '\n' : at(0) == 't' ? '\t' : at(0) == 'r' ? '\r' : at(0);
        }
    }
    m_at += isLong ? 3 : 1;
    return true;
}

bool Scanner::number(double& out)
{
    peek();
    const char* from = m_text.data() + m_at;
    const FloatScan scanned = scanFloat(from, m_text.data() + m_text.size(), out);
    if (scanned == FloatScan::NotFinite)
        return refuse(ErrorCode::Invalid, RAMURE_NOOP("%1 is not a finite number"), {excerpt()});
    if (scanned == FloatScan::NoNumber)
        return refuse(ErrorCode::Syntax, RAMURE_NOOP("%1 where a number has to stand"), {excerpt()});
    m_at = static_cast<std::size_t>(from - m_text.data());
    return true;
}

/// So many numbers between brackets, of a matrix in rows between brackets of their own.
bool Scanner::tuple(Value& out, int components)
{
    if (components == 1)
        return number(out.numbers.emplace_back()) &&
               (out.numbers.size() <= mostNumbers ||
                refuse(ErrorCode::Limit, RAMURE_NOOP("more numbers than a file can hold")));
    if (!expect('('))
        return false;
    const bool hasRows = peek() == '(';
    const int side = hasRows ? static_cast<int>(std::lround(std::sqrt(components))) : components;
    int count = 0;
    for (; !takes(')'); ++count) {
        if (!tuple(out, hasRows ? side : 1))
            return false;
        if (!takes(',') && peek() != ')')
            return expect(',');
    }
    const int wanted = hasRows && side * side != components ? components : side;
    return count == wanted || refuse(ErrorCode::Invalid, RAMURE_NOOP("%1 numbers where %2 have to stand"),
                                     {std::to_string(count), std::to_string(wanted)});
}

bool Scanner::asset(std::string& out)
{
    const bool isLong = at(1) == '@' && at(2) == '@';
    const std::size_t begin = m_at + (isLong ? 3 : 1);
    const std::size_t end = m_text.find(isLong ? "@@@" : "@", begin);
    if (end == std::string_view::npos || (!isLong && m_text.find('\n', begin) < end))
        return refuse(ErrorCode::Syntax, RAMURE_NOOP("a path of a file without an end"));
    out = m_text.substr(begin, end - begin);
    m_at = end + (isLong ? 3 : 1);
    return true;
}

bool Scanner::path(std::string& out)
{
    const std::size_t end = m_text.find_first_of(">\n", m_at);
    if (end == std::string_view::npos || m_text[end] == '\n')
        return refuse(ErrorCode::Syntax, RAMURE_NOOP("a path without an end"));
    out = m_text.substr(m_at + 1, end - m_at - 1);
    m_at = end + 1;
    return true;
}

/// A text, an asset (of a reference with the path in it), a path or a word.
bool Scanner::plain(Value& out)
{
    std::string& text = out.texts.emplace_back();
    const char next = peek();
    if (next == '"' || next == '\'')
        return string(text);
    if (next == '<')
        return path(text);
    if (next != '@')
        return word(text);
    if (!asset(text))
        return false;
    std::string inside;
    if (peek() != '<')
        return true;
    if (!path(inside))
        return false;
    text += "<" + inside;
    return true;
}

bool Scanner::list(Value& out, int depth)
{
    out.isArray = true;
    while (!takes(']')) {
        if (!value(out, depth + 1))
            return false;
        if (!takes(',') && peek() != ']')
            return expect(',');
    }
    return true;
}

/// Behind the opening brace: `string name = "Oak"`, each on a line of its own.
bool Scanner::dictionary(Value& out, int depth)
{
    while (!takes('}')) {
        if (takes(';') || takes(','))
            continue;
        std::string type, key;
        double code = 0.0;
        Value member;
        const char next = peek();
        if (next == '-' || (next >= '0' && next <= '9')) {
            if (!number(code) || !expect(':') || !value(member, depth + 1))
                return false;
            continue;
        }
        if (!word(type) || (takes('[') && !expect(']')))
            return false;
        const bool hasText = peek() == '"' || peek() == '\'';
        if (!(hasText ? string(key) : name(key)) || !expect('=') || !value(member, depth + 1))
            return false;
        out.members[key] = std::move(member);
    }
    return true;
}

bool Scanner::value(Value& out, int depth)
{
    if (depth > deepestValue)
        return refuse(ErrorCode::Limit, RAMURE_NOOP("too many brackets"));
    const char next = peek();
    if (takes('['))
        return list(out, depth);
    if (takes('{'))
        return dictionary(out, depth);
    if (takes('(')) { // of a reference how it is shifted in time, or numbers
        while (!takes(')')) {
            if (takes(',') || takes(';'))
                continue;
            if (peek() != 0 && isWordPart(peek()) && (peek() < '0' || peek() > '9')) {
                std::string key;
                if (!word(key))
                    return false;
                if (takes('=')) {
                    Value member;
                    if (!value(member, depth + 1))
                        return false;
                    continue;
                }
                out.texts.push_back(key);
            } else if (!value(out, depth + 1)) {
                return false;
            }
        }
        return true;
    }
    if (next == '-' || next == '+' || next == '.' || (next >= '0' && next <= '9')) {
        double one = 0.0;
        if (!number(one))
            return false;
        out.numbers.push_back(one);
        return true;
    }
    Value found;
    if (!plain(found))
        return false;
    if (found.texts.front() != "None" || next == '"')
        out.texts.push_back(std::move(found.texts.front()));
    if (takes('(')) { // behind a path or an asset
        --m_at;
        Value shift;
        return value(shift, depth + 1);
    }
    return true;
}

bool Scanner::typedValue(Value& out, int components, bool isArray)
{
    out.isArray = isArray;
    if (peek() == 'N') { // None
        std::string none;
        return word(none) &&
               (none == "None" ||
                refuse(ErrorCode::Syntax, RAMURE_NOOP("%1 where a number has to stand"), {none}));
    }
    const auto one = [&] {
        if (components > 0 && (peek() == 't' || peek() == 'f')) { // bool
            std::string state;
            if (!word(state) || (state != "true" && state != "false"))
                return refuse(ErrorCode::Syntax, RAMURE_NOOP("%1 where a number has to stand"), {state});
            out.numbers.push_back(state == "true" ? 1.0 : 0.0);
            return true;
        }
        if (components > 0)
            return tuple(out, components);
        const char next = peek();
        if (next != '"' && next != '\'' && next != '@' && next != '<')
            return refuse(ErrorCode::Syntax, RAMURE_NOOP("%1 where a text has to stand"), {excerpt()});
        return plain(out);
    };
    if (!isArray)
        return one();
    if (!expect('['))
        return false;
    while (!takes(']')) {
        if (!one())
            return false;
        if (!takes(',') && peek() != ']')
            return expect(',');
    }
    return true;
}

} // namespace ramure::usd
