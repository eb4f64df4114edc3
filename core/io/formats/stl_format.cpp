/// \file
/// STL: triangles and nothing else, what printers take. Written binary; read binary or as text, and corners
/// at one place become one vertex again.

#include "core/io/formats/blender_scene.h"
#include "core/io/formats/file_format.h"
#include "core/io/read_parts.h"
#include "core/io/write_parts.h"
#include "core/math/finite.h"
#include "core/surface/mesh/duplicate_positions.h"
#include <algorithm>
#include <array>
#include <bit>
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
    if (!out)
        return fail(out.error());
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

Expected<std::vector<glm::vec3>> binaryCorners(std::string_view bytes, const std::string& file,
                                               const Progress& progress)
{
    std::vector<glm::vec3> corners((bytes.size() - headSize - countSize) / triangleSize * 3);
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        const char* from = bytes.data() + headSize + countSize + i / 3 * triangleSize + sizeof(glm::vec3);
        std::memcpy(&corners[i], from, 3 * sizeof(glm::vec3));
        if (!std::all_of(&corners[i], &corners[i] + 3, &isFinite<3, float>))
            return refuse(file, ErrorCode::Invalid, RAMURE_NOOP("triangle %1 is not of finite numbers"),
                          {std::to_string(i / 3)});
        if (i % reading::chunk == 0 && progress.cancelled())
            return refuse(file, ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
    }
    return corners;
}

/// The corners of an STL that is text.
class TextStl
{
public:
    TextStl(std::string_view text, const std::string& file)
        : m_text(text)
        , m_file(file)
    {
        m_text += '\n';
        m_size = m_text.size();
        m_text.append(reading::ScanBlocks::padding, '\0');
    }

    Expected<std::vector<glm::vec3>> run(const Progress& progress)
    {
        for (std::size_t begin = 0; begin < m_size;) {
            const std::size_t end = m_text.find('\n', begin);
            ++m_line;
            if (auto taken = take(m_text.c_str() + begin, m_text.c_str() + end); !taken)
                return fail(std::move(taken.error()));
            if (m_line % 65536 == 0 && progress.cancelled())
                return refuse(m_file, ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
            begin = end + 1;
        }
        if (!m_isComplete)
            return refuse(m_file, ErrorCode::Syntax, RAMURE_NOOP("the file ends within a solid"), {}, m_line);
        return std::move(m_corners);
    }

private:
    Expected<void> take(const char* at, const char* end)
    {
        skipBlanks(at, end);
        const char* wordEnd = std::find_if(at, end, &reading::isBlank);
        const std::string_view word(at, static_cast<std::size_t>(wordEnd - at));
        if (word == "vertex")
            return takeVertex(wordEnd, end);
        if (word == "endloop" && m_corners.size() % 3 != 0)
            return refuse(m_file, ErrorCode::Syntax, RAMURE_NOOP("three vertices a loop expected"), {},
                          m_line);
        if (word == "endsolid")
            m_isComplete = true;
        for (const char* known : {"", "solid", "facet", "outer", "endloop", "endfacet", "endsolid"})
            if (word == known)
                return {};
        return refuse(m_file, ErrorCode::Syntax, RAMURE_NOOP("not a line of an STL file: \"%1\""),
                      {reading::excerpt(word)}, m_line);
    }

    Expected<void> takeVertex(const char* at, const char* end)
    {
        glm::vec3 p(0.0F);
        for (int axis = 0; axis < 3; ++axis) {
            skipBlanks(at, end);
            const char* before = at;
            if (at == end || scanFloat(at, p[axis]) != FloatScan::Ok)
                return refuse(m_file, ErrorCode::Syntax, RAMURE_NOOP("a number expected, found \"%1\""),
                              {reading::excerpt({before, static_cast<std::size_t>(end - before)})}, m_line);
        }
        m_corners.push_back(p);
        return {};
    }

    static void skipBlanks(const char*& at, const char* end)
    {
        at = std::find_if_not(at, end, &reading::isBlank);
    }

    std::string m_text; ///< the last line ended, and bytes behind it that scanFloat may look at
    std::size_t m_size = 0;
    const std::string& m_file;
    int m_line = 0;
    bool m_isComplete = false;
    std::vector<glm::vec3> m_corners;
};

/// Binary where the size is what the count says: the first word of some binary files is "solid" too.
Expected<std::vector<glm::vec3>> cornersIn(std::string_view bytes, const std::string& file,
                                           const Progress& progress)
{
    std::uint32_t count = 0;
    if (bytes.size() >= headSize + countSize) {
        std::memcpy(&count, bytes.data() + headSize, sizeof count);
        if (bytes.size() == headSize + countSize + std::size_t(count) * triangleSize)
            return binaryCorners(bytes, file, progress);
    }
    if (bytes.starts_with("solid"))
        return TextStl(bytes, file).run(progress);
    if (bytes.size() < headSize + countSize)
        return refuse(file, ErrorCode::Syntax, RAMURE_NOOP("too short for an STL file"));
    return refuse(file, ErrorCode::Syntax, RAMURE_NOOP("the size is not that of %1 triangles"),
                  {std::to_string(count)});
}

/// Corners at one place are one vertex.
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
    auto input = reading::InputFile::open(path);
    if (!input)
        return fail(input.error());
    const auto bytes = reading::loadFile(*input, path);
    if (!bytes)
        return fail(bytes.error());
    auto corners = cornersIn(bytes->view(), path, progress);
    if (!corners)
        return fail(std::move(corners.error()));
    if (corners->size() >= noIndex)
        return refuse(path, ErrorCode::Limit,
                      RAMURE_NOOP("the file holds more triangles than can be counted"));
    if (corners->empty())
        return refuse(path, ErrorCode::Invalid, RAMURE_NOOP("the file holds no triangles"));
    ReadMesh out;
    out.objects.push_back({reading::stem(path), welded(std::move(*corners)), {}});
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
