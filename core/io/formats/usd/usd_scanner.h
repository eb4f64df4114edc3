/// \file
/// The words and values of a .usda. Internal to usd_layer.cpp.
#pragma once

#include "core/io/formats/usd/usd_layer.h"

namespace ramure::usd {

/// Walks over the text. A function that returns false has left a problem, with its line and column.
class Scanner
{
public:
    explicit Scanner(std::string_view text)
        : m_text(text)
    {
    }

    /// The first line, "#usda 1.0".
    bool takeHeader();
    /// The next character behind blanks and comments; 0: there is none.
    char peek();
    [[nodiscard]] bool atEnd() { return peek() == 0; }
    /// Takes the character if it is the next one. That is no problem.
    bool takes(char c);
    bool expect(char c);
    /// A word of letters, digits and underscores.
    bool word(std::string& out);
    /// A name with its namespaces and what is behind a dot: "inputs:file.connect".
    bool name(std::string& out);
    bool string(std::string& out);
    /// A finite number.
    bool number(double& out);
    /// A value of unknown type.
    bool value(Value& out, int depth = 0);
    /// \param components see componentsOf
    bool typedValue(Value& out, int components, bool isArray);

    bool refuse(ErrorCode code, const char* text, std::vector<std::string> args = {});
    [[nodiscard]] const Error& problem() const { return m_problem; }
    [[nodiscard]] int line() const { return m_line; }
    [[nodiscard]] double fraction() const { return double(m_at) / double(m_text.size() + 1); }

private:
    bool tuple(Value& out, int components);
    bool plain(Value& out);
    bool asset(std::string& out);
    bool path(std::string& out);
    bool list(Value& out, int depth);
    bool dictionary(Value& out, int depth);
    [[nodiscard]] char at(std::size_t ahead) const
    {
        return m_at + ahead < m_text.size() ? m_text[m_at + ahead] : '\0';
    }
    [[nodiscard]] std::string excerpt() const;

    std::string_view m_text;
    std::size_t m_at = 0, m_lineBegin = 0;
    int m_line = 1;
    Error m_problem;
};

} // namespace ramure::usd
