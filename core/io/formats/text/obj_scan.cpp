#include "core/io/formats/text/obj_scanner.h"

#include "core/base/plain_text.h"
#include <algorithm>
#include <charconv>
#include <cstring>

namespace ramure::reading {

namespace {

constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";

/// Of a keyword: without regard to capitals.
char lowerOf(char c)
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 'a' - 'A') : c;
}

} // namespace

bool ObjScanner::fail(ErrorCode code, const char* text, std::vector<std::string> args)
{
    Error error;
    error.code = code;
    error.text = text;
    error.args = std::move(args);
    error.file = m_file;
    error.line = m_line;
    m_error = std::move(error);
    return false;
}

/// From a backslash into the next line, if nothing is between it and the end of its own. False at the end of
/// the text, where the line ends too, and where the backslash continues nothing.
bool ObjScanner::skipContinuation()
{
    const char* next = m_at + 1;
    if (*next == '\r')
        ++next;
    if (*next != '\n')
        return false;
    m_at = next;
    if (next + 1 >= m_end)
        return false;
    ++m_at;
    ++m_line;
    return true;
}

/// To the beginning of the next line; continued lines are one.
void ObjScanner::skipLine()
{
    for (; m_at < m_end; ++m_line) {
        const char* const begin = m_at;
        while (*m_at != '\n')
            ++m_at;
        const char* last = m_at++;
        if (last > begin && last[-1] == '\r')
            --last;
        if (last == begin || last[-1] != '\\')
            return;
    }
}

/// Without blanks at its ends; the position stays.
std::string_view ObjScanner::restOfLine()
{
    const char* begin = m_at;
    while (isBlank(*begin))
        ++begin;
    const char* end = begin;
    while (*end != '\n')
        ++end;
    while (end > begin && isBlank(end[-1]))
        --end;
    return {begin, static_cast<std::size_t>(end - begin)};
}

bool ObjScanner::scan(std::string_view block)
{
    m_at = block.data();
    m_end = block.data() + block.size();
    const double before = double(m_bytesDone);
    m_bytesDone += block.size();
    while (m_at < m_end) {
        ++m_line;
        if (!scanLine())
            return false;
        skipLine();
        if (static_cast<std::size_t>(m_line) % chunk != 0)
            continue;
        m_progress.report((before + double(m_at - block.data())) / double(m_bytes));
        if (m_progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
    }
    return true;
}

bool ObjScanner::scanLine()
{
    while (isBlank(*m_at))
        ++m_at;
    if (*m_at == '\n')
        return true;
    if (*m_at == '#') {
        scanPolypaint();
        // A backslash does not continue a comment.
        m_at = static_cast<const char*>(std::memchr(m_at, '\n', static_cast<std::size_t>(m_end - m_at)));
        return true;
    }
    const char first = lowerOf(*m_at), second = lowerOf(m_at[1]);
    if (endsWord(m_at[1]) && (first == 'v' || first == 'f' || first == 'o' || first == 'g')) {
        ++m_at;
        if (first == 'v')
            return scanPosition();
        if (first == 'f')
            return scanFace();
        scanMark(first == 'o' ? m_lists.objects : m_lists.groups);
        return true;
    }
    if (first == 'v' && (second == 'n' || second == 't') && endsWord(m_at[2])) {
        m_at += 2;
        second == 'n' ? scanNormal() : scanTexture();
        return true;
    }
    return scanOther();
}

/// A number of a position, less the origin.
bool ObjScanner::scanCoordinate(int axis, float& value)
{
    skipBlanks();
    const char* const begin = m_at;
    FloatScan result = FloatScan::Ok;
    if (m_isFar) {
        double wide = 0.0;
        result = scanFloat(m_at, m_end, wide);
        value = static_cast<float>(wide - m_origin[axis]);
    } else
        result = scanFloat(m_at, m_end, value);
    if (result == FloatScan::NotFinite)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("\"%1\" is not a finite number"),
                    {excerpt(restOfLine())});
    if (result == FloatScan::Ok && endsWord(*m_at))
        return true;
    m_at = begin;
    return fail(ErrorCode::Syntax, RAMURE_NOOP("three numbers expected, found \"%1\""),
                {excerpt(restOfLine())});
}

bool ObjScanner::scanPosition()
{
    glm::vec3 v;
    for (int axis = 0; axis < 3; ++axis)
        if (!scanCoordinate(axis, v[axis]))
            return false;
    if (m_lists.positions.size() >= maxObjVertices)
        return fail(ErrorCode::Limit, RAMURE_NOOP("more than %1 vertices"), {std::to_string(maxObjVertices)});
    m_lists.positions.push_back(v);
    skipBlanks();
    if (*m_at != '\n')
        scanColour();
    return true;
}

/// What may follow a position: a weight, which says nothing here, or red, green and blue, and perhaps alpha.
void ObjScanner::scanColour()
{
    glm::vec3 colour;
    for (int channel = 0; channel < 3; ++channel, skipBlanks())
        if (scanFloat(m_at, m_end, colour[channel]) != FloatScan::Ok || !endsWord(*m_at))
            return;
    m_lists.colours.resize(m_lists.positions.size(), noColour);
    m_lists.colours.back() = colour;
}

/// ZBrush writes colours into comments, "#MRGB " and for each of up to 64 vertices a mask and a colour, all
/// as two digits of base 16.
void ObjScanner::scanPolypaint()
{
    constexpr std::string_view keyword = "#MRGB ";
    constexpr std::size_t digits = 8;
    std::string_view line = restOfLine();
    if (!line.starts_with(keyword))
        return;
    line.remove_prefix(keyword.size());
    for (; line.size() >= digits; line.remove_prefix(digits)) {
        std::uint32_t bytes = 0;
        std::from_chars(line.data(), line.data() + digits, bytes, 16);
        m_polypaint.push_back(glm::vec3(bytes >> 16 & 0xFFU, bytes >> 8 & 0xFFU, bytes & 0xFFU) / 255.0F);
    }
}

/// A normal that is none is as good as zero: no mesh is refused for it.
void ObjScanner::scanNormal()
{
    glm::vec3 n;
    bool isGood = true;
    for (int k = 0; k < 3 && isGood; ++k) {
        skipBlanks();
        isGood = scanFloat(m_at, m_end, n[k]) == FloatScan::Ok && endsWord(*m_at);
    }
    if (!isGood && m_badNormalLine == 0)
        m_badNormalLine = m_line;
    if (m_lists.normals.size() < maxObjVertices)
        m_lists.normals.push_back(isGood ? n : glm::vec3(0.0F));
}

Expected<ObjLists> scanObj(std::string_view text, const std::string& file, const Progress& progress,
                           const glm::dvec3& origin)
{
    const PlainText plain(text);
    const std::string lines = std::string(plain.view()) + '\n';
    ObjScanner scanner(file, lines.size(), progress, origin);
    if (!scanner.scan(lines) || !scanner.finish(plain.padding()))
        return ramure::fail(scanner.takeError());
    return scanner.takeLists();
}

Expected<ObjLists> scanObj(InputFile& input, const std::string& file, const Progress& progress,
                           std::size_t blockSize, const glm::dvec3& origin)
{
    ObjScanner scanner(file, input.size(), progress, origin);
    LineBlocks blocks(input, blockSize);
    for (bool isFirst = true; isFirst || !blocks.isLast(); isFirst = false) {
        const auto block = blocks.next();
        if (!block)
            return ramure::fail(block.error());
        std::string_view text = *block;
        if (isFirst && isUtf16(text)) {
            input.rewind();
            const auto bytes = loadFile(input);
            return bytes ? scanObj(*bytes, file, progress, origin) : ramure::fail(bytes.error());
        }
        if (isFirst && text.starts_with(byteOrderMark))
            text.remove_prefix(byteOrderMark.size());
        if (!scanner.scan(text))
            return ramure::fail(scanner.takeError());
    }
    if (!scanner.finish(blocks.padding()))
        return ramure::fail(scanner.takeError());
    return scanner.takeLists();
}

} // namespace ramure::reading
