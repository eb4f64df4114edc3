#include "core/io/formats/obj_scanner.h"

#include "core/io/float_text_parts.h"
#include <algorithm>
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

/// Lines of old Macintosh files end in a carriage return alone.
bool isMacintosh(std::string_view text)
{
    return text.find('\n') == std::string_view::npos && text.find('\r') != std::string_view::npos;
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
        return scanPlainVector(m_at + 2, m_lists.positions);
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
    switch (*m_at) {
    case 'v':
        if (endsWord(m_at[1])) {
            ++m_at;
            return scanVector(m_lists.positions);
        }
        if (m_at[1] == 'n' && endsWord(m_at[2])) {
            m_at += 2;
            return scanVector(m_lists.normals);
        }
        if (m_at[1] == 't' && endsWord(m_at[2])) {
            m_at += 2;
            scanTexture();
            return true;
        }
        break;
    case 'f':
        if (endsWord(m_at[1])) {
            ++m_at;
            return scanFace();
        }
        break;
    case 'o':
        if (endsWord(m_at[1])) {
            ++m_at;
            scanMark(m_lists.objects);
            return true;
        }
        break;
    case 'g':
        if (endsWord(m_at[1])) {
            ++m_at;
            scanMark(m_lists.groups);
            return true;
        }
        break;
    case '#':
        m_at = static_cast<const char*>(std::memchr(m_at, '\n', static_cast<std::size_t>(m_end - m_at)));
        return true; // a backslash does not continue a comment
    case '\n':
        return true;
    default:
        break;
    }
    return scanOther();
}

bool ObjScanner::scanVector(std::vector<glm::vec3>& to)
{
    glm::vec3 v;
    for (int k = 0; k < 3; ++k) {
        skipBlanks();
        const char* const begin = m_at;
        const FloatScan result = scanFloat(m_at, v[k]);
        const bool ends = endsWord(*m_at);
        if (result == FloatScan::NotFinite)
            return fail(ErrorCode::Invalid, RAMURE_NOOP("\"%1\" is not a finite number"),
                        {excerpt(restOfLine())});
        if (result == FloatScan::NoNumber || !ends) {
            m_at = begin;
            return fail(ErrorCode::Syntax, RAMURE_NOOP("three numbers expected, found \"%1\""),
                        {excerpt(restOfLine())});
        }
    }
    if (to.size() >= maxObjVertices)
        return fail(ErrorCode::Limit, RAMURE_NOOP("more than %1 vertices"), {std::to_string(maxObjVertices)});
    to.push_back(v);
    return true;
}

Expected<ObjLists> scanObj(std::string_view text, const std::string& file, const Progress& progress)
{
    if (text.starts_with(byteOrderMark))
        text.remove_prefix(byteOrderMark.size());
    std::string converted;
    if (isMacintosh(text)) {
        converted = text;
        std::replace(converted.begin(), converted.end(), '\r', '\n');
        text = converted;
    }
    ObjScanner scanner(file, text.size(), progress);
    const ScanBlocks blocks(text);
    if (!scanner.scan(blocks.body) || !scanner.scan(blocks.restView()) || !scanner.finish())
        return ramure::fail(scanner.takeError());
    return scanner.takeLists();
}

Expected<ObjLists> scanObj(InputFile& input, const std::string& file, const Progress& progress,
                           std::size_t blockSize)
{
    ObjScanner scanner(file, input.size(), progress);
    LineBlocks blocks(input, blockSize);
    for (bool isFirst = true; isFirst || !blocks.isLast(); isFirst = false) {
        const auto block = blocks.next();
        if (!block)
            return ramure::fail(block.error());
        std::string_view text = *block;
        if (isFirst && text.starts_with(byteOrderMark))
            text.remove_prefix(byteOrderMark.size());
        // A file without a line feed is one block, with one put behind it.
        if (isFirst && blocks.isLast() && isMacintosh(text.substr(0, text.size() - 1)))
            return scanObj(text.substr(0, text.size() - 1), file, progress);
        if (!scanner.scan(text))
            return ramure::fail(scanner.takeError());
    }
    if (!scanner.finish())
        return ramure::fail(scanner.takeError());
    return scanner.takeLists();
}

} // namespace ramure::reading
