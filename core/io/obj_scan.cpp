#include "core/io/obj_scan.h"
#include "core/io/float_text_parts.h"
#include <algorithm>
#include <cstring>

namespace ramure::reading {

namespace {

constexpr Index maxVertices = noIndex - 1;
/// Keywords that are noted by name; a file with more is not described any better by a longer list.
constexpr std::size_t maxNotedKeywords = 50;

bool endsWord(char c)
{
    return isBlank(c) || c == '\n' || c == '\\';
}

class ObjScanner
{
public:
    ObjScanner(const std::string& file, std::size_t bytes, const Progress& progress)
        : m_file(file)
        , m_progress(progress)
        , m_bytes(std::max<std::size_t>(bytes, 1))
    {
        // Typical sizes of lines: memory that stays untouched costs nothing.
        reserve(m_lists.positions, bytes / 72);
        reserve(m_lists.triangles, bytes / 36);
        m_lists.areParallel = true;
    }
    bool scan(std::string_view block);
    bool finish();
    ObjLists takeLists() { return std::move(m_lists); }
    Error takeError() { return std::move(*m_error); }

private:
    template <class T> static void reserve(std::vector<T>& to, std::size_t count)
    {
        to.reserve(count);
        adviseHugePages(to.data(), count * sizeof(T));
    }
    bool scanPlainLine();
    bool scanPlainVector(const char* from, std::vector<glm::vec3>& to);
    bool scanPlainFace();
    bool scanLine();
    bool scanVector(std::vector<glm::vec3>& to);
    bool scanFace();
    bool scanCorner(Index& vertex, Index& texture);
    void scanTexture();
    void addTexture(const glm::uvec3& corners);
    void finishTexture();
    bool scanIndex(std::int64_t& value);
    bool resolve(std::int64_t written, std::size_t count, const char* what, std::optional<Index>& out);
    void giveNormal(Index vertex, Index normal);
    void setNormal(Index vertex, Index normal);
    void endParallel();
    void scanMark(std::vector<ObjMark>& marks);
    bool scanOther();
    void skipTransformNumbers();

    void skipBlanks();
    void skipLine();
    std::string_view restOfLine();
    bool fail(ErrorCode code, const char* text, std::vector<std::string> args = {});

    const std::string& m_file;
    const Progress& m_progress;
    std::size_t m_bytes;
    std::size_t m_bytesDone = 0;
    ObjLists m_lists;
    std::optional<Error> m_error;

    const char* m_at = nullptr;
    const char* m_end = nullptr;
    int m_line = 0;
    Index m_face[2] = {};        ///< of the face being scanned, the first corner and the one before
    Index m_faceTexture[2] = {}; ///< the same for texture coordinates
    int m_corners = 0;           ///< and how many there were
    int m_badTextureLine = 0;    ///< where the first texture coordinate is that nobody can use
    int m_transformNumbers = 0;  ///< how many numbers the matrix of the TRANSFORM line still lacks
    bool m_hasNormals = false;   ///< some corner has one
    // References to what the file has not given yet are checked at its end.
    std::int64_t m_largestVertex = 0, m_largestNormal = 0;
    int m_largestVertexLine = 0, m_largestNormalLine = 0;
    struct Skipped
    {
        int firstLine;
        int count;
    };
    std::map<std::string, Skipped, std::less<>> m_skipped;
};

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

/// The end of a line without anything else on it, or null.
const char* lineEnd(const char* at)
{
    at += *at == '\r' ? 1 : 0;
    return *at == '\n' ? at + 1 : nullptr;
}

bool ObjScanner::scanPlainVector(const char* from, std::vector<glm::vec3>& to)
{
    glm::vec3 v;
    if (!floats::scanPlainFloat(from, v.x) || *from++ != ' ' || !floats::scanPlainFloat(from, v.y) ||
        *from++ != ' ' || !floats::scanPlainFloat(from, v.z))
        return false;
    const char* const end = lineEnd(from);
    if (!end || to.size() >= maxVertices)
        return false;
    if (to.size() == to.capacity() && to.empty())
        reserve(to, m_lists.positions.size()); // as many normals as vertices
    to.push_back(v);
    m_at = end;
    return true;
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
    if (to.size() >= maxVertices)
        return fail(ErrorCode::Limit, RAMURE_NOOP("more than %1 vertices"), {std::to_string(maxVertices)});
    to.push_back(v);
    return true;
}

/// Programs write nothing, one to three numbers, or words here: what cannot be used is no error.
void ObjScanner::scanTexture()
{
    glm::vec2 uv(0.0f);
    skipBlanks();
    bool isGood = scanFloat(m_at, uv.x) == FloatScan::Ok && endsWord(*m_at);
    skipBlanks();
    isGood = isGood && *m_at != '\n' && scanFloat(m_at, uv.y) == FloatScan::Ok && endsWord(*m_at);
    if (!isGood && m_badTextureLine == 0)
        m_badTextureLine = m_line;
    if (m_lists.texture.size() < maxVertices)
        m_lists.texture.push_back(uv);
}

bool ObjScanner::scanIndex(std::int64_t& value)
{
    const bool isNegative = *m_at == '-';
    if (isNegative || *m_at == '+')
        ++m_at;
    std::uint64_t size = 0;
    if (!scanDigits(m_at, size))
        return false;
    value = isNegative ? -static_cast<std::int64_t>(size) : static_cast<std::int64_t>(size);
    return true;
}

/// Counted from 1, or from the end of what was read so far where it is negative.
bool ObjScanner::resolve(std::int64_t written, std::size_t count, const char* what, std::optional<Index>& out)
{
    const std::int64_t index = written < 0 ? written + static_cast<std::int64_t>(count) : written - 1;
    if (index < 0 || index >= maxVertices)
        return fail(ErrorCode::Invalid, what, {std::to_string(written), std::to_string(count)});
    out = static_cast<Index>(index);
    return true;
}

constexpr const char* noSuchVertex = RAMURE_NOOP("vertex %1 does not exist (there are %2)");
constexpr const char* noSuchNormal = RAMURE_NOOP("normal %1 does not exist (there are %2)");

bool ObjScanner::scanCorner(Index& vertex, Index& texture)
{
    const char* const begin = m_at;
    const auto syntax = [&] {
        m_at = begin;
        return fail(ErrorCode::Syntax,
                    RAMURE_NOOP("a corner v, v/vt, v//vn or v/vt/vn expected, found \"%1\""),
                    {excerpt(restOfLine())});
    };
    std::int64_t written = 0;
    if (!scanIndex(written))
        return syntax();
    std::optional<Index> v;
    if (!resolve(written, m_lists.positions.size(), noSuchVertex, v))
        return false;
    vertex = *v;
    if (vertex >= m_lists.positions.size() && written > m_largestVertex) {
        m_largestVertex = written;
        m_largestVertexLine = m_line;
    }
    bool hasNormal = false;
    texture = noIndex;
    if (*m_at == '/') {
        ++m_at;
        std::int64_t number = 0;
        if (*m_at != '/' && !scanIndex(number))
            return syntax();
        const std::int64_t place = number < 0 ? number + std::ssize(m_lists.texture) : number - 1;
        if (number != 0 && place >= 0 && place < maxVertices)
            texture = static_cast<Index>(place);
        if (*m_at == '/') {
            ++m_at;
            if (!scanIndex(written))
                return syntax();
            std::optional<Index> normal;
            if (!resolve(written, m_lists.normals.size(), noSuchNormal, normal))
                return false;
            if (*normal >= m_lists.normals.size() && written > m_largestNormal) {
                m_largestNormal = written;
                m_largestNormalLine = m_line;
            }
            giveNormal(vertex, *normal);
            hasNormal = true;
        }
    }
    m_lists.cornersWithoutNormal += !hasNormal;
    return endsWord(*m_at) || syntax();
}

void ObjScanner::giveNormal(Index vertex, Index normal)
{
    m_hasNormals = true;
    if (m_lists.areParallel && vertex == normal && vertex < m_lists.positions.size())
        return;
    endParallel();
    setNormal(vertex, normal);
}

/// Writes down what was true of all corners up to here.
void ObjScanner::endParallel()
{
    if (!m_lists.areParallel)
        return;
    m_lists.areParallel = false;
    for (const glm::uvec3& t : m_lists.triangles)
        for (int k = 0; k < 3; ++k)
            setNormal(t[k], t[k]);
    for (int i = 0; i < std::min(m_corners, 2); ++i)
        setNormal(m_face[i], m_face[i]);
}

void ObjScanner::setNormal(Index vertex, Index normal)
{
    std::vector<Index>& of = m_lists.normalOf;
    if (vertex < of.size()) {
        if (of[vertex] == normal)
            return;
        if (of[vertex] == noIndex) {
            of[vertex] = normal;
            return;
        }
    } else if (vertex < m_lists.positions.size()) {
        of.resize(m_lists.positions.size(), noIndex);
        of[vertex] = normal;
        return;
    }
    m_lists.otherNormals.emplace_back(vertex, normal);
}

bool ObjScanner::scanFace()
{
    m_corners = 0;
    for (skipBlanks(); *m_at != '\n' && *m_at != '#'; skipBlanks(), ++m_corners) {
        Index vertex = 0, texture = noIndex;
        if (!scanCorner(vertex, texture))
            return false;
        if (m_corners == 0) {
            m_face[0] = vertex;
            m_faceTexture[0] = texture;
        }
        if (m_corners >= 2) {
            m_lists.triangles.emplace_back(m_face[0], m_face[1], vertex);
            addTexture({m_faceTexture[0], m_faceTexture[1], texture});
        }
        m_face[1] = vertex;
        m_faceTexture[1] = texture;
    }
    if (m_corners < 3)
        return fail(ErrorCode::Syntax, RAMURE_NOOP("a face of fewer than three corners"));
    if (m_lists.triangles.size() > noIndex / 2)
        return fail(ErrorCode::Limit, RAMURE_NOOP("more than %1 triangles"), {std::to_string(noIndex / 2)});
    return true;
}

/// Of the triangle added last.
void ObjScanner::addTexture(const glm::uvec3& corners)
{
    if (corners == glm::uvec3(noIndex))
        return;
    m_lists.textureTriangles.resize(m_lists.triangles.size(), glm::uvec3(noIndex));
    m_lists.textureTriangles.back() = corners;
}

/// All of them or none: a file that gives numbers which do not exist has none.
void ObjScanner::finishTexture()
{
    std::vector<glm::uvec3>& triangles = m_lists.textureTriangles;
    if (triangles.empty())
        return;
    bool isGood = m_badTextureLine == 0;
    for (const glm::uvec3& t : triangles)
        for (int k = 0; k < 3; ++k)
            isGood = isGood && (t[k] == noIndex || t[k] < m_lists.texture.size());
    if (isGood)
        return;
    triangles.clear();
    m_lists.notes.push_back(m_badTextureLine > 0
                                ? "line " + std::to_string(m_badTextureLine) +
                                      ": not two finite numbers: texture coordinates left out"
                                : std::string("texture coordinates that do not exist: left out"));
}

void ObjScanner::scanMark(std::vector<ObjMark>& marks)
{
    marks.push_back({std::string(restOfLine()), static_cast<Index>(m_lists.positions.size()),
                     static_cast<Index>(m_lists.triangles.size())});
}

/// Keywords that say nothing about the mesh, keywords that are noted, and what is no line of an OBJ file at
/// all.
bool ObjScanner::scanOther()
{
    const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
    const auto isInWord = [&](char c) {
        return isLetter(c) || (c >= '0' && c <= '9') || c == '-' || c == '.';
    };
    if (m_transformNumbers > 0 && isInWord(*m_at) && !isLetter(*m_at)) {
        skipTransformNumbers();
        return true;
    }
    if (*m_at == '\0' && m_at >= m_end)
        return true;
    const char* end = m_at;
    while (end - m_at < 64 && isInWord(*end))
        ++end;
    const std::string_view word(m_at, static_cast<std::size_t>(end - m_at));
    if (word.empty() || !isLetter(word[0]) || !endsWord(*end))
        return fail(ErrorCode::Syntax, RAMURE_NOOP("not a line of an OBJ file: \"%1\""),
                    {excerpt(restOfLine())});
    m_transformNumbers = 0;
    for (const std::string_view unused : {"vt", "vp", "s", "mtllib", "usemtl", "usemap", "maplib", "mg",
                                          "lod", "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj"})
        if (word == unused)
            return true;
    if (const auto known = m_skipped.find(word); known != m_skipped.end())
        ++known->second.count;
    else if (m_skipped.size() < maxNotedKeywords)
        m_skipped.emplace(word, Skipped{m_line, 1});
    if (word == "TRANSFORM") {
        m_at = end;
        m_transformNumbers = 16;
        skipTransformNumbers();
    }
    return true;
}

/// The sixteen numbers stand on the keyword's line or on the four that follow.
void ObjScanner::skipTransformNumbers()
{
    float ignored = 0.0f;
    for (skipBlanks(); m_transformNumbers > 0 && scanFloat(m_at, ignored) == FloatScan::Ok; skipBlanks())
        --m_transformNumbers;
}

bool ObjScanner::finish()
{
    if (m_largestVertex > static_cast<std::int64_t>(m_lists.positions.size())) {
        m_line = m_largestVertexLine;
        return fail(ErrorCode::Invalid, noSuchVertex,
                    {std::to_string(m_largestVertex), std::to_string(m_lists.positions.size())});
    }
    if (m_largestNormal > static_cast<std::int64_t>(m_lists.normals.size())) {
        m_line = m_largestNormalLine;
        return fail(ErrorCode::Invalid, noSuchNormal,
                    {std::to_string(m_largestNormal), std::to_string(m_lists.normals.size())});
    }
    m_line = 0; // what follows is about the whole file
    // Without normals there is nothing to be parallel; too many of them belong to no vertex.
    if (m_hasNormals && m_lists.normals.size() != m_lists.positions.size())
        endParallel();
    m_lists.areParallel = m_lists.areParallel && m_hasNormals;
    if (m_lists.positions.empty())
        return fail(ErrorCode::Syntax, RAMURE_NOOP("the file holds no vertices"));
    for (const auto& [word, skipped] : m_skipped)
        m_lists.notes.push_back("line " + std::to_string(skipped.firstLine) + ": " + word + " skipped" +
                                (skipped.count > 1 ? ", " + std::to_string(skipped.count) + " lines" : ""));
    finishTexture();
    return true;
}

} // namespace

namespace {

constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";

/// Lines of old Macintosh files end in a carriage return alone.
bool isMacintosh(std::string_view text)
{
    return text.find('\n') == std::string_view::npos && text.find('\r') != std::string_view::npos;
}

} // namespace

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
