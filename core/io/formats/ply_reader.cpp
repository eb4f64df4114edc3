#include "core/io/formats/ply_header.h"
#include "core/io/formats/ply_source.h"
#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

namespace ramure {

namespace {

using reading::AsciiSource;
using reading::BinarySource;
using reading::PlyElement;
using reading::PlyFormat;
using reading::PlyHeader;
using reading::PlyProperty;
using reading::PlyType;

/// What a property of a vertex is for.
struct VertexSlots
{
    int position[3];
    int normal[3];
    int branch;
    int level;
    int colour[3];

    explicit VertexSlots(const PlyElement& element)
        : position{element.find("x"), element.find("y"), element.find("z")}
        , normal{element.find("nx"), element.find("ny"), element.find("nz")}
        , branch(element.find("branch"))
        , level(element.find("level"))
        , colour{element.find("red"), element.find("green"), element.find("blue")}
    {
        for (const int slot : {normal[0], normal[1], normal[2]})
            if (slot < 0 || element.properties[static_cast<std::size_t>(slot)].isList)
                normal[0] = normal[1] = normal[2] = -1;
        for (const int slot : {colour[0], colour[1], colour[2]})
            if (slot < 0 || element.properties[static_cast<std::size_t>(slot)].isList ||
                element.properties[static_cast<std::size_t>(slot)].type != PlyType::UInt8)
                colour[0] = colour[1] = colour[2] = -1;
        for (int* const slot : {&branch, &level})
            if (*slot >= 0) {
                const PlyProperty& property = element.properties[static_cast<std::size_t>(*slot)];
                if (property.isList || !isInteger(property.type))
                    *slot = -1;
            }
    }
    [[nodiscard]] bool hasPosition(const PlyElement& element) const
    {
        for (const int slot : position)
            if (slot < 0 || element.properties[static_cast<std::size_t>(slot)].isList)
                return false;
        return true;
    }
};

/// Reads the elements of a file from a source of numbers, text or binary.
template <class Source> class PlyBody
{
public:
    PlyBody(Source source, const PlyHeader& header, const Progress& progress)
        : m_source(std::move(source))
        , m_header(header)
        , m_progress(progress)
    {
    }

    Expected<ReadMesh> read()
    {
        for (const PlyElement& element : m_header.elements)
            if (element.name == "vertex")
                m_vertexCount = element.count;
        bool isGood = true;
        for (const PlyElement& element : m_header.elements) {
            if (element.name == "vertex")
                isGood = readVertices(element);
            else if (element.name == "face")
                isGood = readFaces(element);
            else
                isGood = skip(element);
            if (!isGood)
                return fail(m_source.takeError());
            m_progress.report(m_source.fraction());
        }
        if (m_mesh.positions.empty()) {
            m_source.fail(ErrorCode::Syntax, RAMURE_NOOP("the file holds no vertices"));
            return fail(m_source.takeError());
        }
        m_source.noteTrailing(m_out.notes);
        reading::takeVertexColours(m_mesh, m_colours);
        m_out.objects.push_back({{}, std::move(m_mesh), {}});
        return std::move(m_out);
    }

private:
    bool readVertices(const PlyElement& element)
    {
        const VertexSlots slots(element);
        if (!slots.hasPosition(element))
            return m_source.fail(ErrorCode::Syntax, RAMURE_NOOP("vertices without x, y and z"));
        if (element.count >= noIndex)
            return m_source.fail(ErrorCode::Limit, RAMURE_NOOP("more than %1 vertices"),
                                 {std::to_string(noIndex - 1)});
        const auto count = static_cast<std::size_t>(element.count);
        m_mesh.positions.resize(count);
        m_mesh.normals.resize(slots.normal[0] >= 0 ? count : 0);
        m_mesh.branch.resize(slots.branch >= 0 ? count : 0);
        m_mesh.level.resize(slots.level >= 0 ? count : 0);
        m_colours.resize(slots.colour[0] >= 0 ? count : 0);
        std::vector<double> values(element.properties.size());
        for (std::size_t i = 0; i < count; ++i) {
            if (i % reading::chunk == 0 && !goesOn())
                return false;
            if (!m_source.begin(element.name, i) || !readScalars(element, values) ||
                !takeVertex(slots, values, i))
                return false;
        }
        return true;
    }
    /// All properties of one element; the values of lists are skipped.
    bool readScalars(const PlyElement& element, std::vector<double>& values)
    {
        for (std::size_t p = 0; p < element.properties.size(); ++p) {
            const PlyProperty& property = element.properties[p];
            if (property.isList ? !m_source.skipList(property) : !m_source.number(property.type, values[p]))
                return false;
        }
        return true;
    }
    bool takeVertex(const VertexSlots& slots, const std::vector<double>& values, std::size_t i)
    {
        const auto take = [&](const int(&from)[3], glm::vec3& to) {
            for (int k = 0; k < 3; ++k) {
                to[k] = static_cast<float>(values[static_cast<std::size_t>(from[k])]);
                if (!std::isfinite(to[k]))
                    return m_source.fail(ErrorCode::Invalid, RAMURE_NOOP("vertex %1 is not a finite number"),
                                         {std::to_string(i)});
            }
            return true;
        };
        if (!take(slots.position, m_mesh.positions[i]))
            return false;
        if (slots.normal[0] >= 0 && !take(slots.normal, m_mesh.normals[i]))
            return false;
        // -1 stands for none, as in the program.
        const auto index = [&](int slot) {
            return static_cast<Index>(static_cast<std::int64_t>(values[static_cast<std::size_t>(slot)]));
        };
        if (slots.branch >= 0)
            m_mesh.branch[i] = index(slots.branch);
        if (slots.level >= 0)
            m_mesh.level[i] = index(slots.level);
        for (int k = 0; k < 3 && slots.colour[0] >= 0; ++k) {
            const double value = values[static_cast<std::size_t>(slots.colour[k])];
            m_colours[i][k] = static_cast<std::uint8_t>(value > 0.0 ? std::min(value, 255.0) : 0.0);
        }
        return true;
    }
    bool readFaces(const PlyElement& element)
    {
        int slot = element.find("vertex_indices");
        if (slot < 0)
            slot = element.find("vertex_index");
        if (slot < 0)
            return skip(element);
        const PlyProperty& list = element.properties[static_cast<std::size_t>(slot)];
        if (!list.isList || !isInteger(list.type))
            return m_source.fail(ErrorCode::Syntax,
                                 RAMURE_NOOP("the faces' vertices are no list of integers"));
        m_mesh.triangles.reserve(m_source.mostTriangles(element, list));
        const int textureSlot = textureList(element);
        for (std::uint64_t i = 0; i < element.count; ++i) {
            if (i % reading::chunk == 0 && !goesOn())
                return false;
            if (!m_source.begin(element.name, i))
                return false;
            for (std::size_t p = 0; p < element.properties.size(); ++p) {
                const PlyProperty& property = element.properties[p];
                double ignored = 0.0;
                const bool isRead = static_cast<int>(p) == slot          ? readFace(property, i)
                                    : static_cast<int>(p) == textureSlot ? readTexture(property)
                                    : property.isList                    ? m_source.skipList(property)
                                                      : m_source.number(property.type, ignored);
                if (!isRead)
                    return false;
            }
            if (textureSlot >= 0)
                takeTexture();
        }
        finishTexture(textureSlot >= 0);
        return true;
    }
    /// u and v of each corner of a face, as MeshLab writes them; the number of the property, or -1.
    static int textureList(const PlyElement& element)
    {
        const int slot = element.find("texcoord");
        if (slot < 0)
            return -1;
        const PlyProperty& list = element.properties[static_cast<std::size_t>(slot)];
        return list.isList && !isInteger(list.type) ? slot : -1;
    }
    bool readTexture(const PlyProperty& list)
    {
        std::uint64_t numbers = 0;
        if (!m_source.listSize(list, numbers))
            return false;
        m_faceTexture.clear();
        for (std::uint64_t k = 0; k < numbers; ++k) {
            double number = 0.0;
            if (!m_source.number(list.type, number))
                return false;
            m_faceTexture.push_back(static_cast<float>(number));
        }
        return true;
    }
    /// For the triangles of the face read last.
    void takeTexture()
    {
        const std::size_t known = m_mesh.uvTriangles.size(), count = m_mesh.triangles.size() - known;
        const bool isGood = m_hasTexture && m_faceTexture.size() == 2 * (count + 2) &&
                            std::all_of(m_faceTexture.begin(), m_faceTexture.end(),
                                        [](float number) { return std::isfinite(number); });
        m_hasTexture = isGood;
        for (std::size_t i = 0; i < count && isGood; ++i) {
            glm::uvec3 corners;
            for (int k = 0; k < 3; ++k) {
                const std::size_t corner = k == 0 ? 0 : i + static_cast<std::size_t>(k);
                corners[k] = textureOf(m_mesh.triangles[known + i][k],
                                       {m_faceTexture[2 * corner], m_faceTexture[2 * corner + 1]});
            }
            m_mesh.uvTriangles.push_back(corners);
        }
    }
    /// The same coordinates of one vertex are stored once.
    Index textureOf(Index vertex, const glm::vec2& uv)
    {
        m_firstTexture.resize(std::max<std::size_t>(m_firstTexture.size(), vertex + 1), noIndex);
        for (Index i = m_firstTexture[vertex]; i != noIndex; i = m_nextTexture[i])
            if (m_mesh.uv[i] == uv)
                return i;
        const auto added = static_cast<Index>(m_mesh.uv.size());
        m_mesh.uv.push_back(uv);
        m_nextTexture.push_back(std::exchange(m_firstTexture[vertex], added));
        return added;
    }
    void finishTexture(bool wasAsked)
    {
        if (!wasAsked || (m_hasTexture && m_mesh.uvTriangles.size() == m_mesh.triangles.size()))
            return;
        m_mesh.uv.clear();
        m_mesh.uvTriangles.clear();
        m_out.notes.push_back("faces without two finite numbers per corner: texture coordinates left out");
    }
    bool readFace(const PlyProperty& list, std::uint64_t face)
    {
        std::uint64_t corners = 0;
        if (!m_source.listSize(list, corners))
            return false;
        if (corners < 3)
            return m_source.fail(ErrorCode::Syntax, RAMURE_NOOP("face %1 has fewer than three corners"),
                                 {std::to_string(face)});
        Index first = 0;
        Index previous = 0;
        for (std::uint64_t k = 0; k < corners; ++k) {
            std::int64_t index = 0;
            if (!m_source.integer(list.type, index))
                return false;
            if (index < 0 || static_cast<std::uint64_t>(index) >= m_vertexCount)
                return m_source.fail(ErrorCode::Invalid,
                                     RAMURE_NOOP("vertex %1 does not exist (there are %2)"),
                                     {std::to_string(index), std::to_string(m_vertexCount)});
            const auto vertex = static_cast<Index>(index);
            if (k == 0)
                first = vertex;
            if (k >= 2)
                m_mesh.triangles.emplace_back(first, previous, vertex);
            previous = vertex;
        }
        return true;
    }

    bool skip(const PlyElement& element)
    {
        if (element.count > 0)
            m_out.notes.push_back(std::to_string(element.count) + " elements \"" +
                                  reading::excerpt(element.name) + "\" skipped");
        if (element.properties.empty())
            return true; // nothing stands for them in the file, however many they are
        std::vector<double> ignored(element.properties.size());
        for (std::uint64_t i = 0; i < element.count; ++i) {
            if (i % reading::chunk == 0 && !goesOn())
                return false;
            if (!m_source.begin(element.name, i) || !readScalars(element, ignored))
                return false;
        }
        return true;
    }
    bool goesOn()
    {
        m_progress.report(m_source.fraction());
        return !m_progress.cancelled() || m_source.fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
    }

    Source m_source;
    const PlyHeader& m_header;
    const Progress& m_progress;
    std::uint64_t m_vertexCount = 0;
    TriangleMesh m_mesh;
    std::vector<glm::u8vec3> m_colours;               ///< of the vertices
    bool m_hasTexture = true;                         ///< every face up to here has its coordinates
    std::vector<float> m_faceTexture;                 ///< of the face read last
    std::vector<Index> m_firstTexture, m_nextTexture; ///< per vertex a list of its coordinates
    ReadMesh m_out;
};

/// What the file knows about vertices and the program does not want to.
void noteSkippedProperties(const PlyHeader& header, std::vector<std::string>& notes)
{
    std::string names;
    for (const PlyElement& element : header.elements)
        for (const PlyProperty& property : element.properties) {
            bool isKnown = element.name != "vertex";
            for (const char* known :
                 {"x", "y", "z", "nx", "ny", "nz", "red", "green", "blue", "alpha", "branch", "level"})
                isKnown = isKnown || property.name == known;
            if (!isKnown && names.size() < 200)
                names += (names.empty() ? "" : ", ") + reading::excerpt(property.name);
        }
    if (!names.empty())
        notes.push_back("vertex properties skipped: " + names);
}

void named(ReadMesh& mesh, const PlyHeader& header, const std::string& file)
{
    mesh.objects.front().name = reading::stem(file);
    noteSkippedProperties(header, mesh.notes);
}

} // namespace

void reading::takeVertexColours(TriangleMesh& mesh, std::span<const glm::u8vec3> colours)
{
    if (colours.empty() || mesh.triangles.empty())
        return;
    const auto isFirst = [&colours](const glm::u8vec3& colour) { return colour == colours.front(); };
    if (std::all_of(colours.begin(), colours.end(), isFirst)) {
        mesh.colours.assign(mesh.triangles.size(), colours.front());
        return;
    }
    std::vector<Index> lastOf(mesh.positions.size(), noIndex);
    for (Index t = 0; t < mesh.faceCount(); ++t)
        for (int k = 0; k < 3; ++k)
            lastOf[mesh.triangles[t][k]] = t;
    mesh.colours.resize(mesh.triangles.size());
    for (Index t = 0; t < mesh.faceCount(); ++t) {
        glm::uvec3 own(0), all(0);
        unsigned count = 0;
        for (int k = 0; k < 3; ++k) {
            const Index vertex = mesh.triangles[t][k];
            all += glm::uvec3(colours[vertex]);
            if (lastOf[vertex] == t) {
                own += glm::uvec3(colours[vertex]);
                ++count;
            }
        }
        mesh.colours[t] = glm::u8vec3(count > 0 ? (own + count / 2) / count : (all + 1U) / 3U);
    }
}

Expected<ReadMesh> parsePly(std::string_view bytes, const std::string& file, const Progress& progress)
{
    const auto header = reading::parsePlyHeader(bytes, file, bytes.size());
    if (!header)
        return fail(header.error());
    auto result = [&]() -> Expected<ReadMesh> {
        if (header->format == PlyFormat::Ascii) {
            const reading::ScanBlocks blocks(bytes.substr(header->bytes));
            return PlyBody(AsciiSource(blocks, file, header->lines), *header, progress).read();
        }
        if (header->format == PlyFormat::BigEndian)
            return PlyBody(BinarySource<true>(bytes, header->bytes, file), *header, progress).read();
        if (auto plain = reading::readPlainPly(bytes, *header, progress))
            return std::move(*plain);
        return PlyBody(BinarySource<false>(bytes, header->bytes, file), *header, progress).read();
    }();
    if (!result)
        return result;
    named(*result, *header, file);
    progress.report(1.0);
    return result;
}

Expected<ReadMesh> reading::readPlyFile(const std::string& path, const Progress& progress)
{
    auto input = InputFile::open(path);
    if (!input)
        return fail(input.error());
    if (input->isRegular()) {
        // Headers are short; what is longer, or not plain, is read as a whole.
        std::string begin(std::min<std::size_t>(input->size(), 1u << 14), '\0');
        const auto got = input->read(begin.data(), begin.size());
        const auto header = parsePlyHeader(begin, path, input->size());
        if (got && *got == begin.size() && header) {
            const auto body = std::string_view(begin).substr(header->bytes);
            if (auto plain = readPlainPly(*input, body, *header, progress)) {
                named(*plain, *header, path);
                progress.report(1.0);
                return std::move(*plain);
            }
        }
        input->rewind();
    }
    const auto bytes = loadFile(*input, path);
    if (!bytes)
        return fail(bytes.error());
    return parsePly(bytes->view(), path, progress);
}

} // namespace ramure
