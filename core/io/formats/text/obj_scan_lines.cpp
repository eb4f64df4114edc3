#include "core/io/formats/text/obj_scanner.h"

#include "core/base/plain_text.h"
#include <algorithm>

namespace ramure::reading {

namespace {

/// Keywords that are noted by name; a file with more is not described any better by a longer list.
constexpr std::size_t maxNotedKeywords = 50;
constexpr const char* noSuchVertex = RAMURE_NOOP("vertex %1 does not exist (there are %2)");

} // namespace

/// Programs write nothing, one to three numbers, or words here: what cannot be used is no error.
void ObjScanner::scanTexture()
{
    glm::vec2 uv(0.0f);
    skipBlanks();
    bool isGood = scanFloat(m_at, m_end, uv.x) == FloatScan::Ok && endsWord(*m_at);
    skipBlanks();
    isGood = isGood && *m_at != '\n' && scanFloat(m_at, m_end, uv.y) == FloatScan::Ok && endsWord(*m_at);
    if (!isGood && m_badTextureLine == 0)
        m_badTextureLine = m_line;
    if (m_lists.texture.size() < maxObjVertices)
        m_lists.texture.push_back(uv);
}

/// Counted from 1, or from the end of what was read so far where it is negative. Nothing where it cannot be.
static std::optional<Index> placeOf(std::int64_t written, std::size_t count)
{
    const std::int64_t place = written < 0 ? written + static_cast<std::int64_t>(count) : written - 1;
    return place < 0 || place >= maxObjVertices ? std::nullopt : std::optional(static_cast<Index>(place));
}

/// A normal that there is not leaves the corner without one.
bool ObjScanner::scanCornerNormal(Index vertex, bool& hasNormal)
{
    if (endsWord(*m_at)) // "f 1// 2// 3//"
        return true;
    std::int64_t written = 0;
    if (!scanWhole(m_at, m_end, written))
        return false;
    const auto normal = placeOf(written, m_lists.normals.size());
    hasNormal = normal.has_value();
    if (!hasNormal && m_missingNormalLine == 0) {
        m_missingNormal = written;
        m_missingNormalLine = m_line;
    }
    if (!hasNormal)
        return true;
    if (*normal >= m_lists.normals.size() && written > m_largestNormal) {
        m_largestNormal = written;
        m_largestNormalLine = m_line;
    }
    setNormal(vertex, *normal);
    return true;
}

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
    if (!scanWhole(m_at, m_end, written))
        return syntax();
    const auto v = placeOf(written, m_lists.positions.size());
    if (!v)
        return fail(ErrorCode::Invalid, noSuchVertex,
                    {std::to_string(written), std::to_string(m_lists.positions.size())});
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
        if (*m_at != '/' && !scanWhole(m_at, m_end, number))
            return syntax();
        texture = placeOf(number, m_lists.texture.size()).value_or(noIndex);
        if (*m_at == '/') {
            ++m_at;
            if (!scanCornerNormal(vertex, hasNormal))
                return syntax();
        }
    }
    m_lists.cornersWithoutNormal += !hasNormal;
    return endsWord(*m_at) || syntax();
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
            if (const glm::uvec3 corners(m_faceTexture[0], m_faceTexture[1], texture);
                corners != glm::uvec3(noIndex))
                addTexture(corners);
        }
        m_face[1] = vertex;
        m_faceTexture[1] = texture;
    }
    if (m_corners < 3)
        return fail(ErrorCode::Syntax, RAMURE_NOOP("a face of fewer than three corners"));
    if (m_lists.triangles.size() > noIndex / 2)
        return fail(ErrorCode::Limit, RAMURE_NOOP("more than %1 triangles"), {std::to_string(noIndex / 2)});
    if (m_corners > 3)
        m_polygons.take(m_lists.triangles, static_cast<std::size_t>(m_corners), m_lists.positions);
    return true;
}

/// Of the triangle added last.
void ObjScanner::addTexture(const glm::uvec3& corners)
{
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
    const char* end = m_at;
    while (end - m_at < 64 && isInWord(*end))
        ++end;
    const std::string_view said(m_at, static_cast<std::size_t>(end - m_at));
    const std::string word = lowered(said);
    if (word.empty() || !isLetter(word[0]) || !endsWord(*end))
        return fail(ErrorCode::Syntax, RAMURE_NOOP("not a line of an OBJ file: \"%1\""),
                    {excerpt(restOfLine())});
    m_transformNumbers = 0;
    if (word == "usemtl" || word == "mtllib") {
        m_at = end;
        if (word == "usemtl")
            scanMark(m_lists.materials);
        else if (m_lists.libraries.size() < maxNotedKeywords)
            m_lists.libraries.emplace_back(m_line, restOfLine());
        return true;
    }
    for (const std::string_view unused : {"vt", "vp", "s", "usemap", "maplib", "mg", "lod", "bevel",
                                          "c_interp", "d_interp", "shadow_obj", "trace_obj"})
        if (word == unused)
            return true;
    if (const auto known = m_skipped.find(said); known != m_skipped.end())
        ++known->second.count;
    else if (m_skipped.size() < maxNotedKeywords)
        m_skipped.emplace(said, Skipped{m_line, 1});
    if (word == "transform") {
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
    for (skipBlanks(); m_transformNumbers > 0 && scanFloat(m_at, m_end, ignored) == FloatScan::Ok;
         skipBlanks())
        --m_transformNumbers;
}

/// Corners whose normals the file does not hold are without one.
void ObjScanner::finishNormals()
{
    if (m_missingNormalLine == 0 && m_largestNormal > std::ssize(m_lists.normals)) {
        m_missingNormal = m_largestNormal;
        m_missingNormalLine = m_largestNormalLine;
        ++m_lists.cornersWithoutNormal;
    }
    if (m_badNormalLine > 0)
        m_lists.notes.push_back("line " + std::to_string(m_badNormalLine) +
                                ": not three finite numbers: no normal");
    if (m_missingNormalLine > 0)
        m_lists.notes.push_back("line " + std::to_string(m_missingNormalLine) + ": normal " +
                                std::to_string(m_missingNormal) + " does not exist (there are " +
                                std::to_string(m_lists.normals.size()) + "): all are left out");
    else if (m_lists.cornersWithoutNormal > 0 && m_lists.givesNormals())
        m_lists.notes.push_back(std::to_string(m_lists.cornersWithoutNormal) +
                                " corners without a normal: normals left out");
}

bool ObjScanner::finish(std::size_t padding)
{
    if (m_largestVertex > static_cast<std::int64_t>(m_lists.positions.size())) {
        m_line = m_largestVertexLine;
        return fail(ErrorCode::Invalid, noSuchVertex,
                    {std::to_string(m_largestVertex), std::to_string(m_lists.positions.size())});
    }
    m_line = 0; // what follows is about the whole file
    finishNormals();
    if (m_lists.positions.empty())
        return fail(ErrorCode::Syntax, RAMURE_NOOP("the file holds no vertices"));
    for (const auto& [word, skipped] : m_skipped)
        m_lists.notes.push_back("line " + std::to_string(skipped.firstLine) + ": " + word + " skipped" +
                                (skipped.count > 1 ? ", " + std::to_string(skipped.count) + " lines" : ""));
    finishTexture();
    m_polygons.cut(m_lists.positions, m_lists.triangles, m_lists.textureTriangles, m_lists.notes);
    if (m_lists.colours.empty() && m_polypaint.size() == m_lists.positions.size())
        m_lists.colours = std::move(m_polypaint);
    if (!m_lists.colours.empty())
        m_lists.colours.resize(m_lists.positions.size(), noColour);
    notePadding(padding, m_lists.notes);
    return true;
}

} // namespace ramure::reading
