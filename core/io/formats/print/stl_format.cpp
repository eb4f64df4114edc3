/// \file
/// STL: triangles and nothing else, what printers take. Written binary; read binary or as text, and corners
/// at one place become one vertex again.

#include "core/base/plain_text.h"
#include "core/base/version.h"
#include "core/io/formats/file_format.h"
#include "core/io/formats/text/blender_scene.h"
#include "core/io/mesh_mending.h"
#include "core/io/read_parts.h"
#include "core/io/write_parts.h"
#include "core/math/finite.h"
#include "core/surface/mesh/duplicate_positions.h"
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <limits>

namespace ramure {
namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is written as it lies in memory");

constexpr std::size_t headSize = 80, countSize = 4, triangleSize = 50;

tl::unexpected<Error> refuse(const std::string& file, ErrorCode code, const char* text,
                             std::vector<std::string> args = {}, int line = 0)
{
    auto error = fail(code, text, std::move(args));
    error.value().file = file;
    error.value().line = line;
    return error;
}

/// Never begins with "solid", as text does. The space stands on a line of its own, where fileSpaceIn finds
/// it.
std::string header(const std::string& comment)
{
    std::string out = "Ramure " RAMURE_VERSION " binary STL\n";
    if (!comment.empty())
        out += "# " + writing::oneLine(comment) + "\n";
    out.resize(headSize, ' ');
    return out;
}

/// Zero where the triangle has no area: so the format says.
glm::vec3 normalOf(const std::array<glm::vec3, 3>& corners)
{
    const glm::dvec3 a(corners[0]);
    const glm::dvec3 normal = glm::cross(glm::dvec3(corners[1]) - a, glm::dvec3(corners[2]) - a);
    const double length = glm::length(normal);
    return length > 0.0 ? glm::vec3(normal / length) : glm::vec3(0.0F);
}

char* appendTriangle(char* to, const TriangleMesh& mesh, const glm::uvec3& t)
{
    const std::array<glm::vec3, 3> corners{mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]};
    const glm::vec3 normal = normalOf(corners);
    std::memcpy(to, &normal, sizeof normal);
    std::memcpy(to + sizeof normal, corners.data(), sizeof corners);
    std::memset(to + sizeof normal + sizeof corners, 0, 2);
    return to + triangleSize;
}

Expected<void> exportStl(const std::string& path, const ExportScene& scene, const WriteOptions& options,
                         const Progress& progress)
{
    const FlatScene flat = flattened(scene);
    const std::vector<MeshPart> parts = flat.parts();
    if (const auto finite = writing::checkFinite(parts, path); !finite)
        return finite;
    std::size_t count = 0;
    for (const MeshPart& part : parts)
        count += part.mesh->triangles.size();
    if (count > std::numeric_limits<std::uint32_t>::max())
        return refuse(path, ErrorCode::Limit, RAMURE_NOOP("an STL holds up to 4294967295 triangles"));
    auto out = FileWriter::open(path);
    RAMURE_TRY(out);
    const auto number = static_cast<std::uint32_t>(count);
    out->append(header(options.comment));
    out->append({reinterpret_cast<const char*>(&number), sizeof number});
    writing::Ticker ticker(progress, count);
    for (const MeshPart& part : parts) {
        const TriangleMesh& mesh = *part.mesh;
        if (!writing::forEach(
                mesh.triangles.size(), triangleSize, ticker, *out,
                [&](char* to, std::size_t i) { return appendTriangle(to, mesh, mesh.triangles[i]); }))
            break;
    }
    if (ticker.cancelled())
        return refuse(path, ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
    return out->commit();
}

/// The corners of all triangles, three by three, from an origin on.
struct StlCorners
{
    std::vector<glm::vec3> positions;
    glm::dvec3 origin{0.0};
    std::vector<std::string> notes;
};

Expected<StlCorners> binaryCorners(std::string_view bytes, std::size_t count, const std::string& file,
                                   const Progress& progress)
{
    StlCorners out;
    std::vector<glm::vec3>& corners = out.positions;
    corners.resize(3 * count);
    std::size_t painted = 0;
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        const char* from = bytes.data() + headSize + countSize + i / 3 * triangleSize + sizeof(glm::vec3);
        std::memcpy(&corners[i], from, 3 * sizeof(glm::vec3));
        const char* colour = from + 3 * sizeof(glm::vec3); // of two bytes, as several programs use them
        painted += colour[0] != 0 || colour[1] != 0 ? 1 : 0;
        if (!std::all_of(&corners[i], &corners[i] + 3, &isFinite<3, float>))
            return refuse(file, ErrorCode::Invalid, RAMURE_NOOP("triangle %1 is not of finite numbers"),
                          {std::to_string(i / 3)});
        if (i % reading::chunk == 0 && progress.cancelled())
            return refuse(file, ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
    }
    if (painted > 0)
        out.notes.push_back(std::to_string(painted) + " triangles have colours of their own: left out");
    const std::size_t size = headSize + countSize + count * triangleSize;
    if (bytes.size() > size)
        out.notes.push_back(std::to_string(bytes.size() - size) + " bytes behind the last triangle");
    out.origin = reading::farOrigin(corners);
    if (out.origin != glm::dvec3(0.0))
        for (glm::vec3& p : corners)
            p = glm::vec3(glm::dvec3(p) - out.origin);
    return out;
}

/// The corners of an STL that is text.
class TextStl
{
public:
    TextStl(std::string_view text, const std::string& file)
        : m_text(text)
        , m_lines(m_text.view())
        , m_file(file)
    {
    }

    Expected<StlCorners> run(const Progress& progress)
    {
        while (m_lines.next()) {
            RAMURE_TRY(take(m_lines.line()));
            if (m_lines.number() % 65536 == 0 && progress.cancelled())
                return refuse(m_file, ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        }
        if (!m_isComplete)
            return refuse(m_file, ErrorCode::Syntax, RAMURE_NOOP("the file ends within a solid"), {},
                          m_lines.number());
        StlCorners out;
        out.origin = reading::farOrigin(m_corners);
        out.positions = reading::movedFrom(out.origin, m_corners);
        if (m_strayLine > 0)
            out.notes.push_back("line " + std::to_string(m_strayLine) + ": text behind the last solid");
        reading::notePadding(m_text.padding(), out.notes);
        return out;
    }

private:
    Expected<void> take(std::string_view line)
    {
        const std::size_t gap = std::min(line.find_first_of(reading::blanksOfLine), line.size());
        const std::string word = lowered(line.substr(0, gap));
        if (word == "vertex")
            return takeVertex(line.substr(gap));
        if (word == "endloop" && m_corners.size() % 3 != 0)
            return refuse(m_file, ErrorCode::Syntax, RAMURE_NOOP("three vertices a loop expected"), {},
                          m_lines.number());
        if (word == "endsolid" || word == "solid")
            m_isComplete = word == "endsolid";
        for (const char* known : {"", "solid", "facet", "outer", "endloop", "endfacet", "endsolid"})
            if (word == known)
                return {};
        if (m_isComplete) {
            m_strayLine = m_strayLine == 0 ? m_lines.number() : m_strayLine;
            return {};
        }
        return refuse(m_file, ErrorCode::Syntax, RAMURE_NOOP("not a line of an STL file: \"%1\""),
                      {reading::excerpt(word)}, m_lines.number());
    }

    Expected<void> takeVertex(std::string_view numbers)
    {
        glm::dvec3 p(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            numbers = reading::trimmed(numbers);
            const std::string_view from = numbers.substr(numbers.starts_with('+') ? 1 : 0);
            const auto [end, problem] = std::from_chars(from.data(), from.data() + from.size(), p[axis]);
            if (problem != std::errc() || !(std::abs(p[axis]) <= double(std::numeric_limits<float>::max())))
                return refuse(m_file, ErrorCode::Syntax, RAMURE_NOOP("a number expected, found \"%1\""),
                              {reading::excerpt(numbers)}, m_lines.number());
            numbers = from.substr(static_cast<std::size_t>(end - from.data()));
        }
        m_corners.push_back(p);
        return {};
    }

    PlainText m_text;
    TextLines m_lines;
    const std::string& m_file;
    bool m_isComplete = false; ///< no solid is open
    int m_strayLine = 0;       ///< the first line that belongs to no solid
    std::vector<glm::dvec3> m_corners;
};

bool isTextStl(std::string_view bytes)
{
    const PlainText head(bytes.substr(0, 256));
    const std::string_view text = head.view();
    const std::string_view begin = text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    return isWord(begin.substr(0, 5), "solid");
}

/// Binary where as many triangles are there as the count says: the first word of some binary files is "solid"
/// too, and some have bytes behind the last one. In a text, the count is a number of some hundred million.
Expected<StlCorners> cornersIn(std::string_view bytes, const std::string& file, const Progress& progress)
{
    std::uint32_t count = 0;
    const bool isText = isTextStl(bytes);
    if (bytes.size() >= headSize + countSize) {
        std::memcpy(&count, bytes.data() + headSize, sizeof count);
        const std::size_t size = headSize + countSize + std::size_t(count) * triangleSize;
        if (bytes.size() == size || (bytes.size() > size && (count > 0 || !isText)))
            return binaryCorners(bytes, count, file, progress);
    }
    if (isText)
        return TextStl(bytes, file).run(progress);
    if (bytes.size() < headSize + countSize)
        return refuse(file, ErrorCode::Syntax, RAMURE_NOOP("too short for an STL file"));
    return refuse(file, ErrorCode::Syntax, RAMURE_NOOP("the size is not that of %1 triangles"),
                  {std::to_string(count)});
}

/// StlCorners at one place are one vertex.
TriangleMesh welded(std::vector<glm::vec3>&& corners)
{
    TriangleMesh mesh;
    std::vector<Index> vertexOf(corners.size(), noIndex);
    for (const DuplicatePosition& same : findDuplicatePositions(corners))
        vertexOf[same.vertex] = same.earlier;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (vertexOf[i] != noIndex) {
            vertexOf[i] = vertexOf[vertexOf[i]];
            continue;
        }
        vertexOf[i] = static_cast<Index>(mesh.positions.size());
        mesh.positions.push_back(corners[i]);
    }
    for (std::size_t i = 0; i < corners.size(); i += 3)
        mesh.triangles.emplace_back(vertexOf[i], vertexOf[i + 1], vertexOf[i + 2]);
    return mesh;
}

Expected<ReadMesh> importStl(const std::string& path, const Progress& progress)
{
    const auto bytes = reading::loadFile(path);
    RAMURE_TRY(bytes);
    auto corners = cornersIn(*bytes, path, progress);
    RAMURE_TRY(corners);
    if (corners->positions.size() >= noIndex)
        return refuse(path, ErrorCode::Limit,
                      RAMURE_NOOP("the file holds more triangles than can be counted"));
    if (corners->positions.empty())
        return refuse(path, ErrorCode::Invalid, RAMURE_NOOP("the file holds no triangles"));
    ReadMesh out;
    out.notes = std::move(corners->notes);
    out.origin = corners->origin;
    if (out.origin != glm::dvec3(0.0))
        out.notes.push_back(reading::farNote(out.origin));
    out.objects.push_back({reading::stem(path), welded(std::move(corners->positions)), {}});
    progress.report(1.0);
    return out;
}

FileRates stlRates(bool /*texture*/, double /*digits*/)
{
    return {0.0, double(triangleSize)};
}

} // namespace

extern const FileFormat stlFormat;
const FileFormat stlFormat = {
    .id = "stl",
    .ending = "stl",
    .name = RAMURE_NOOP("STL"),
    .choice = RAMURE_NOOP("STL, for printers"),
    .help = "binary; triangles alone, for printers: see --print",
    .holds = holdsSpace,
    .read = &importStl,
    .import = &importBlender,
    .write = &exportStl,
    .rates = &stlRates,
};

} // namespace ramure
