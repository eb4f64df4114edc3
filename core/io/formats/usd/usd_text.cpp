#include "core/io/formats/usd/usd_text.h"

#include "core/base/utf8.h"
#include <algorithm>
#include <cmath>

namespace ramure::usd {

std::string inQuotes(std::string_view text)
{
    constexpr const char* digits = "0123456789abcdef";
    std::string out = "\"";
    while (!text.empty()) {
        const std::size_t length = utf8Length(text);
        const auto byte = static_cast<unsigned char>(text[0]);
        if (text[0] == '"' || text[0] == '\\')
            out.append("\\").append(1, text[0]);
        else if (text[0] == '\n')
            out += "\\n";
        else if (length == 0 || byte < 0x20 || byte == 0x7F)
            out.append("\\x").append(1, digits[byte / 16]).append(1, digits[byte % 16]);
        else
            out.append(text.substr(0, length));
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return out += '"';
}

std::string target(const std::string& path)
{
    return "<" + path + ">";
}

std::string matrixText(const glm::dmat4& matrix)
{
    std::array<char, 4 * elementRoom> text;
    char* to = text.data();
    for (int row = 0; row < 4; ++row) {
        *to++ = row == 0 ? '(' : ',';
        *to++ = ' ';
        to = appendRoundedTuple(to, matrix[row], 1e12);
    }
    *to++ = ' ';
    *to++ = ')';
    return {text.data(), to};
}

std::string colourText(const glm::vec3& colour)
{
    std::array<char, elementRoom> text;
    return {text.data(), appendRoundedTuple(text.data(), colour)};
}

char* appendRounded(char* to, double number, double scale)
{
    const double rounded = std::round(number * scale) / scale;
    return std::to_chars(to, to + 24, rounded == 0.0 ? 0.0 : rounded).ptr; // no -0
}

std::string Names::take(const std::string& text)
{
    const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    std::string stem;
    for (std::size_t i = 0; i < text.size(); i += std::max<std::size_t>(utf8Length({&text[i]}), 1))
        stem += isLetter(text[i]) || isDigit(text[i]) ? text[i] : '_';
    if (stem.empty() || isDigit(stem.front()))
        stem.insert(0, "_");
    std::string name = stem;
    for (int number = 2; !m_taken.insert(name).second; ++number)
        name = stem + "_" + std::to_string(number);
    return name;
}

void Text::line(std::string_view text)
{
    indent();
    m_text.append(text).append("\n");
    flush();
}

void Text::open(const std::string& head, const std::vector<std::string>& metadata)
{
    if (metadata.empty())
        line(head);
    else {
        line(head + " (");
        ++m_depth;
        for (const std::string& each : metadata)
            line(each);
        --m_depth;
        line(")");
    }
    line("{");
    ++m_depth;
}

void Text::openBlock(const std::string& head)
{
    line(head);
    ++m_depth;
}

void Text::close()
{
    --m_depth;
    line("}");
}

void Text::endArray(const std::vector<std::string>& metadata)
{
    if (metadata.empty()) {
        m_text += '\n';
    } else {
        m_text += " (\n";
        ++m_depth;
        for (const std::string& each : metadata)
            line(each);
        --m_depth;
        line(")");
    }
    flush();
}

void Text::flush()
{
    if (m_file && m_text.size() >= blockSize)
        finish();
}

void Text::finish()
{
    if (m_file) {
        m_file->append(m_text);
        m_text.clear();
    }
}

} // namespace ramure::usd
