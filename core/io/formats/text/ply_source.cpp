#include "core/io/formats/text/ply_source.h"
#include <charconv>
#include <limits>

namespace ramure::reading {

/// To the next number, over blanks and line feeds; false at the end of the text.
bool AsciiSource::findToken()
{
    for (;;) {
        for (; m_at < m_end && (isBlank(*m_at) || *m_at == '\n'); ++m_at)
            m_line += *m_at == '\n';
        if (m_at < m_end)
            return true;
        if (m_isInRest)
            return false;
        m_isInRest = true;
        m_at = m_blocks->rest.data();
        m_end = m_at + m_blocks->restView().size();
    }
}

bool AsciiSource::toToken()
{
    if (findToken())
        return true;
    Error error = endError();
    error.line = m_line;
    return store(std::move(error));
}

bool AsciiSource::badToken()
{
    const char* end = m_at;
    while (!isBlank(*end) && *end != '\n')
        ++end;
    return fail(ErrorCode::Syntax, RAMURE_NOOP("a number expected, found \"%1\""),
                {excerpt({m_at, static_cast<std::size_t>(end - m_at)})});
}

bool AsciiSource::number(PlyType type, double& value)
{
    if (isInteger(type)) {
        std::int64_t whole = 0;
        const bool isRead = integer(type, whole);
        value = static_cast<double>(whole);
        return isRead;
    }
    if (!toToken())
        return false;
    const char* const begin = m_at;
    float single = 0.0f;
    switch (scanFloat(m_at, single)) {
    case FloatScan::Ok:
        value = static_cast<double>(single);
        if (m_isExact)
            std::from_chars(begin + (*begin == '+' ? 1 : 0), m_at, value);
        break;
    case FloatScan::NotFinite: // matters only where it is a position
        value = std::numeric_limits<double>::quiet_NaN();
        while (!endsToken())
            ++m_at;
        break;
    case FloatScan::NoNumber:
        return badToken();
    }
    if (endsToken())
        return true;
    m_at = begin;
    return badToken();
}

bool AsciiSource::integer(PlyType, std::int64_t& value)
{
    if (!toToken())
        return false;
    const char* const token = m_at;
    const bool isNegative = *m_at == '-';
    if (isNegative || *m_at == '+')
        ++m_at;
    const char* const begin = m_at;
    std::int64_t size = 0;
    for (; static_cast<unsigned char>(*m_at - '0') < 10; ++m_at)
        if (size < std::int64_t(1) << 40) // far out of range, whatever follows
            size = size * 10 + (*m_at - '0');
    if (m_at == begin || !endsToken()) {
        m_at = token;
        return badToken();
    }
    value = isNegative ? -size : size;
    return true;
}

bool AsciiSource::listSize(const PlyProperty& list, std::uint64_t& size)
{
    std::int64_t count = 0;
    if (!integer(list.countType, count))
        return false;
    if (count < 0)
        return fail(ErrorCode::Syntax, RAMURE_NOOP("a list of %1 values"), {std::to_string(count)});
    size = static_cast<std::uint64_t>(count);
    return true;
}

bool AsciiSource::skipList(const PlyProperty& list)
{
    std::uint64_t size = 0;
    if (!listSize(list, size))
        return false;
    double ignored = 0.0;
    for (std::uint64_t i = 0; i < size; ++i)
        if (!number(list.type, ignored))
            return false;
    return true;
}

double AsciiSource::fraction() const
{
    return m_isInRest ? 1.0 : double(m_at - m_blocks->body.data()) / double(m_blocks->body.size() + 1);
}

std::size_t AsciiSource::mostTriangles(const PlyElement& element, const PlyProperty&) const
{
    constexpr std::uint64_t shortest = 8; // "3 0 1 2\n"
    const std::uint64_t left = m_isInRest ? 0 : static_cast<std::uint64_t>(m_end - m_at);
    return static_cast<std::size_t>(std::min<std::uint64_t>(element.count, left / shortest));
}

void AsciiSource::noteTrailing(std::vector<std::string>& notes)
{
    if (findToken())
        notes.push_back("line " + std::to_string(m_line) + ": text behind the last element");
}

} // namespace ramure::reading
