#include "core/io/formats/text/obj_scanner.h"

#include "core/base/plain_text.h"
#include "core/io/float_text_parts.h"
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>

namespace ramure::reading {

namespace {

/// The end of a line without anything else on it, or null.
const char* lineEnd(const char* at)
{
    at += *at == '\r' ? 1 : 0;
    return *at == '\n' ? at + 1 : nullptr;
}

/// v or v//v, with a vertex that is known and a normal of the same number.
bool scanPlainCorner(const char*& at, Index vertices, Index normals, Index& vertex, bool& hasNormal)
{
    const std::uint64_t text = floats::load8(at);
    const int length = floats::leadingDigits(text);
    if (length == 0 || length == 8)
        return false;
    const int others = 8 * (8 - length);
    const std::uint64_t number = floats::eightDigitValue(text << others);
    vertex = static_cast<Index>(number - 1);
    at += length;
    if (vertex >= vertices)
        return false;
    hasNormal = *at == '/';
    if (!hasNormal)
        return true;
    const bool isSame = (floats::load8(at + 2) ^ text) << others == 0;
    if (at[1] != '/' || !isSame || vertex >= normals)
        return false;
    at += 2 + length;
    return true;
}

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

void ObjScanner::skipBlanks()
{
    for (;;) {
        while (isBlank(*m_at))
            ++m_at;
        if (*m_at != '\\')
            return;
        const char* next = m_at + 1;
        if (*next == '\r')
            ++next;
        if (*next != '\n')
            return;
        m_at = next;
        if (next + 1 >= m_end)
            return; // the text ends here: so does the line
        ++m_at;
        ++m_line;
    }
}

/// To the beginning of the next line; continued lines are one.
void ObjScanner::skipLine()
{
    for (;;) {
        if (m_at >= m_end) {
            m_at = m_end;
            return;
        }
        const auto* feed =
            static_cast<const char*>(std::memchr(m_at, '\n', static_cast<std::size_t>(m_end - m_at)));
        if (!feed) {
            m_at = m_end;
            return;
        }
        const char* last = feed;
        if (last > m_at && last[-1] == '\r')
            --last;
        const bool isContinued = last > m_at && last[-1] == '\\';
        m_at = feed + 1;
        if (!isContinued)
            return;
        ++m_line;
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
    const char* reported = m_at;
    for (std::size_t lines = 0; m_at < m_end; ++lines) {
        ++m_line;
        if (!scanPlainLine()) {
            if (!scanLine())
                return false;
            skipLine();
        }
        if (lines % chunk == chunk - 1) {
            m_bytesDone += static_cast<std::size_t>(m_at - reported);
            reported = m_at;
            m_progress.report(double(m_bytesDone) / double(m_bytes));
            if (m_progress.cancelled())
                return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        }
    }
    return true;
}

/// The lines that most of nearly all files are: v or vn and three numbers, f and three corners v or v//v, one
/// space between two. False, and nothing done, for all others.
bool ObjScanner::scanPlainLine()
{
    if (m_at[0] == 'f' && m_at[1] == ' ')
        return scanPlainFace();
    if (m_at[0] != 'v')
        return false;
    if (m_at[1] == ' ')
        return !m_isFar && scanPlainVector(m_at + 2, m_lists.positions);
    return m_at[1] == 'n' && m_at[2] == ' ' && scanPlainVector(m_at + 3, m_lists.normals);
}

bool ObjScanner::scanPlainVector(const char* from, std::vector<glm::vec3>& to)
{
    glm::vec3 v;
    if (!floats::scanPlainFloat(from, v.x) || *from++ != ' ' || !floats::scanPlainFloat(from, v.y) ||
        *from++ != ' ' || !floats::scanPlainFloat(from, v.z))
        return false;
    const char* const end = lineEnd(from);
    if (!end || to.size() >= maxObjVertices)
        return false;
    if (to.size() == to.capacity() && to.empty())
        reserve(to, m_lists.positions.size()); // as many normals as vertices
    to.push_back(v);
    m_at = end;
    return true;
}

void ObjScanner::giveNormal(Index vertex, Index normal)
{
    m_hasNormals = true;
    if (m_lists.areParallel && vertex == normal && vertex < m_lists.positions.size())
        return;
    endParallel();
    setNormal(vertex, normal);
}

bool ObjScanner::scanPlainFace()
{
    const auto vertices = static_cast<Index>(m_lists.positions.size());
    const auto normals = static_cast<Index>(m_lists.normals.size());
    glm::uvec3 t;
    const char* at = m_at + 1;
    std::size_t without = 0;
    for (int k = 0; k < 3; ++k) {
        bool hasNormal = false;
        if (*at++ != ' ' || !scanPlainCorner(at, vertices, normals, t[k], hasNormal))
            return false;
        without += hasNormal ? 0 : 1;
    }
    const char* const end = lineEnd(at);
    if (!end || (without != 0 && without != 3) || m_lists.triangles.size() > noIndex / 2)
        return false;
    m_corners = 0;
    m_lists.cornersWithoutNormal += without;
    for (int k = 0; k < 3 && without == 0; ++k)
        giveNormal(t[k], t[k]);
    m_lists.triangles.push_back(t);
    m_at = end;
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
    const FloatScan result = scanFloat(m_at, value);
    if (result == FloatScan::NotFinite)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("\"%1\" is not a finite number"),
                    {excerpt(restOfLine())});
    if (result == FloatScan::NoNumber || !endsWord(*m_at)) {
        m_at = begin;
        return fail(ErrorCode::Syntax, RAMURE_NOOP("three numbers expected, found \"%1\""),
                    {excerpt(restOfLine())});
    }
    if (!m_isFar)
        return true;
    double wide = 0.0;
    std::from_chars(begin + (*begin == '+' ? 1 : 0), m_at, wide);
    value = static_cast<float>(wide - m_origin[axis]);
    return true;
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
        if (scanFloat(m_at, colour[channel]) != FloatScan::Ok || !endsWord(*m_at))
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
        isGood = scanFloat(m_at, n[k]) == FloatScan::Ok && endsWord(*m_at);
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
    ObjScanner scanner(file, plain.view().size(), progress, origin);
    const ScanBlocks blocks(plain.view());
    if (!scanner.scan(blocks.body) || !scanner.scan(blocks.restView()) || !scanner.finish(plain.padding()))
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
            const auto bytes = loadFile(input, file);
            return bytes ? scanObj(bytes->view(), file, progress, origin) : ramure::fail(bytes.error());
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
