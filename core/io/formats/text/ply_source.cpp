#include "core/io/formats/text/ply_source.h"
#include <limits>

namespace ramure::reading {

bool PlySource::fail(ErrorCode code, const char* text, std::vector<std::string> args)
{
    Error error = ramure::fail(code, text, std::move(args)).value();
    error.file = *m_file;
    tellPlace(error);
    m_error = std::move(error);
    return false;
}

bool PlySource::atEnd()
{
    return fail(ErrorCode::Syntax, RAMURE_NOOP("the file ends within element %1 of \"%2\""),
                {std::to_string(m_number), m_element ? excerpt(*m_element) : std::string()});
}

/// To the next number, over blanks and line feeds; false at the end of the text.
bool TextSource::findToken()
{
    for (; m_at < m_bytes.size() && (isBlank(m_bytes[m_at]) || m_bytes[m_at] == '\n'); ++m_at)
        m_line += m_bytes[m_at] == '\n';
    return m_at < m_bytes.size();
}

bool TextSource::number(PlyType type, double& value)
{
    if (!findToken()) {
        ++m_line; // which is the one that is missing
        return atEnd();
    }
    const char *at = m_bytes.data() + m_at, *const end = m_bytes.data() + m_bytes.size();
    const auto endsToken = [&] { return at == end || isBlank(*at) || *at == '\n'; };
    FloatScan result = FloatScan::Ok;
    if (isInteger(type)) {
        std::int64_t whole = 0;
        result = scanWhole(at, end, whole) ? FloatScan::Ok : FloatScan::NoNumber;
        value = static_cast<double>(whole);
    } else if (m_isExact) {
        result = scanFloat(at, end, value);
    } else {
        float single = 0.0f;
        result = scanFloat(at, end, single);
        value = static_cast<double>(single);
    }
    if (result == FloatScan::NotFinite) { // matters only where it is a position
        value = std::numeric_limits<double>::quiet_NaN();
        while (!endsToken())
            ++at;
    }
    if (result == FloatScan::NoNumber || !endsToken()) {
        const std::string_view rest = m_bytes.substr(m_at);
        return fail(ErrorCode::Syntax, RAMURE_NOOP("a number expected, found \"%1\""),
                    {excerpt(rest.substr(0, rest.find_first_of(" \t\r\n")))});
    }
    m_at = static_cast<std::size_t>(at - m_bytes.data());
    return true;
}

void TextSource::noteTrailing(std::vector<std::string>& notes)
{
    if (findToken())
        notes.push_back("line " + std::to_string(m_line) + ": text behind the last element");
}

} // namespace ramure::reading
