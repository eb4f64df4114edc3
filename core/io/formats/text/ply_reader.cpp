#include "core/base/plain_text.h"
#include "core/io/formats/text/ply_header.h"
#include "core/io/formats/text/ply_source.h"
#include "core/io/mesh_mending.h"
#include "core/math/finite.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ramure {

namespace {

using reading::BinarySource;
using reading::PlyElement;
using reading::PlyFormat;
using reading::PlyHeader;
using reading::PlyProperty;
using reading::PlyType;
using reading::TextSource;

/// Where red, green and blue stand among the properties of a vertex or a face.
struct ColourSlots
{
    std::size_t first[3] = {};
    double whole = 1.0; ///< what a full colour is in the file

    explicit ColourSlots(const PlyElement& element)
    {
        constexpr const char* names[][3] = {
            {"red", "green", "blue"}, {"diffuse_red", "diffuse_green", "diffuse_blue"}, {"r", "g", "b"}};
        for (const auto& triple : names) {
            bool isThere = true;
            for (int k = 0; k < 3; ++k) {
                const int slot = element.find(triple[k]);
                isThere = isThere && slot >= 0 && !element.properties[static_cast<std::size_t>(slot)].isList;
                first[k] = static_cast<std::size_t>(std::max(slot, 0));
            }
            if (isThere) {
                const PlyType type = element.properties[first[0]].type;
                whole = !isInteger(type) ? 1.0 : type == PlyType::UInt16 ? 65535.0 : 255.0;
                m_isThere = true;
                return;
            }
        }
    }
    [[nodiscard]] bool areThere() const { return m_isThere; }
    /// Whole numbers beyond the largest are the largest: only those with a point may mean bytes.
    [[nodiscard]] glm::vec3 of(const std::vector<double>& values) const
    {
        glm::vec3 out;
        for (int k = 0; k < 3; ++k) {
            const double share = values[first[k]] / whole;
            out[k] = static_cast<float>(whole > 1.0 ? std::min(share, 1.0) : share);
        }
        return out;
    }

private:
    bool m_isThere = false;
};

/// What a property of a vertex is for.
struct VertexSlots
{
    int position[3];
    int normal[3];
    int branch;
    int level;
    ColourSlots colour;

    explicit VertexSlots(const PlyElement& element)
        : position{element.find("x"), element.find("y"), element.find("z")}
        , normal{element.find("nx"), element.find("ny"), element.find("nz")}
        , branch(element.find("branch"))
        , level(element.find("level"))
        , colour(element)
    {
        for (const int slot : {normal[0], normal[1], normal[2]})
            if (slot < 0 || element.properties[static_cast<std::size_t>(slot)].isList)
                normal[0] = normal[1] = normal[2] = -1;
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
    /// \param origin is subtracted from positions
    PlyBody(Source source, const PlyHeader& header, const glm::dvec3& origin, const Progress& progress)
        : m_source(std::move(source))
        , m_header(header)
        , m_origin(origin)
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
            else if (element.name == "face" || element.name == "tristrips")
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
        m_polygons.cut(m_mesh.positions, m_mesh.triangles, m_mesh.uvTriangles, m_out.notes);
        takeColours();
        reading::mendNormals(m_mesh, m_out.notes);
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
        m_colours.resize(slots.colour.areThere() ? count : 0);
        std::vector<double> values(element.properties.size());
        for (std::size_t i = 0; i < count; ++i) {
            if (i % reading::chunk == 0 && !goesOn())
                return false;
            m_source.begin(element.name, i);
            if (!readScalars(element, values) || !takeVertex(slots, values, i))
                return false;
        }
        return true;
    }
    /// All properties of one element; the values of lists are skipped.
    bool readScalars(const PlyElement& element, std::vector<double>& values)
    {
        for (std::size_t p = 0; p < element.properties.size(); ++p) {
            const PlyProperty& property = element.properties[p];
            if (!readScalar(property, values[p]))
                return false;
        }
        return true;
    }
    /// \param value the last of a list, if it is one
    bool readScalar(const PlyProperty& property, double& value)
    {
        std::uint64_t size = 1;
        if (property.isList && !listSize(property, size))
            return false;
        for (std::uint64_t i = 0; i < size; ++i)
            if (!m_source.number(property.type, value))
                return false;
        return true;
    }
    bool listSize(const PlyProperty& list, std::uint64_t& size)
    {
        double count = 0.0;
        if (!m_source.number(list.countType, count))
            return false;
        if (count < 0.0)
            return m_source.fail(ErrorCode::Syntax, RAMURE_NOOP("a list of %1 values"),
                                 {std::to_string(static_cast<std::int64_t>(count))});
        size = static_cast<std::uint64_t>(count);
        return m_source.holds(size, list.type);
    }
    bool takeVertex(const VertexSlots& slots, const std::vector<double>& values, std::size_t i)
    {
        const auto take = [&](const int(&from)[3], const glm::dvec3& less) {
            glm::vec3 to;
            for (int k = 0; k < 3; ++k)
                to[k] = static_cast<float>(values[static_cast<std::size_t>(from[k])] - less[k]);
            return to;
        };
        m_mesh.positions[i] = take(slots.position, m_origin);
        if (!isFinite(m_mesh.positions[i]))
            return m_source.fail(ErrorCode::Invalid, RAMURE_NOOP("vertex %1 is not a finite number"),
                                 {std::to_string(i)});
        if (slots.normal[0] >= 0) {
            const glm::vec3 normal = take(slots.normal, glm::dvec3(0.0));
            m_mesh.normals[i] = isFinite(normal) ? normal : glm::vec3(0.0F);
        }
        // -1 stands for none, as in the program.
        const auto index = [&](int slot) {
            return static_cast<Index>(static_cast<std::int64_t>(values[static_cast<std::size_t>(slot)]));
        };
        if (slots.branch >= 0)
            m_mesh.branch[i] = index(slots.branch);
        if (slots.level >= 0)
            m_mesh.level[i] = index(slots.level);
        if (slots.colour.areThere())
            m_colours[i] = slots.colour.of(values);
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
        constexpr std::size_t smallestTriangle = 4; // bytes
        m_mesh.triangles.reserve(std::min<std::uint64_t>(element.count, m_source.left() / smallestTriangle));
        const int textureSlot = textureList(element);
        const bool isFace = element.name == "face"; // and no strip
        const ColourSlots colour(element);
        std::vector<double> values(element.properties.size());
        for (std::uint64_t i = 0; i < element.count; ++i) {
            if (i % reading::chunk == 0 && !goesOn())
                return false;
            m_source.begin(element.name, i);
            for (std::size_t p = 0; p < element.properties.size(); ++p) {
                const PlyProperty& property = element.properties[p];
                const bool isRead = static_cast<int>(p) == slot          ? readCorners(property, i, isFace)
                                    : static_cast<int>(p) == textureSlot ? readTexture(property)
                                                                         : readScalar(property, values[p]);
                if (!isRead)
                    return false;
            }
            if (textureSlot >= 0)
                takeTexture();
            if (colour.areThere())
                m_faceColours.resize(m_mesh.triangles.size(), colour.of(values));
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
        if (!listSize(list, numbers))
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
    bool readCorners(const PlyProperty& list, std::uint64_t number, bool isFace)
    {
        std::uint64_t corners = 0;
        if (!listSize(list, corners))
            return false;
        return isFace ? readFace(list, number, corners) : readStrips(list, corners);
    }
    bool readVertex(const PlyProperty& list, std::int64_t& index, std::int64_t least)
    {
        double number = 0.0;
        if (!m_source.number(list.type, number))
            return false;
        index = static_cast<std::int64_t>(number);
        return (index >= least && index < static_cast<std::int64_t>(m_vertexCount)) ||
               m_source.fail(ErrorCode::Invalid, RAMURE_NOOP("vertex %1 does not exist (there are %2)"),
                             {std::to_string(index), std::to_string(m_vertexCount)});
    }
    /// Each corner makes a triangle with the two before it, every other one turned round; -1 ends a strip.
    bool readStrips(const PlyProperty& list, std::uint64_t corners)
    {
        Index last[2] = {};
        std::uint64_t inStrip = 0;
        for (std::uint64_t k = 0; k < corners; ++k) {
            std::int64_t index = 0;
            if ((k % reading::chunk == 0 && !goesOn()) || !readVertex(list, index, -1))
                return false;
            inStrip = index < 0 ? 0 : inStrip + 1;
            if (index < 0)
                continue;
            const auto vertex = static_cast<Index>(index);
            const bool isTurned = inStrip % 2 == 0;
            // Strips are joined by triangles without an area.
            if (inStrip > 2 && last[0] != last[1] && last[1] != vertex && last[0] != vertex)
                m_mesh.triangles.emplace_back(last[isTurned ? 1 : 0], last[isTurned ? 0 : 1], vertex);
            last[0] = std::exchange(last[1], vertex);
        }
        return true;
    }
    bool readFace(const PlyProperty& list, std::uint64_t face, std::uint64_t corners)
    {
        if (corners < 3)
            return m_source.fail(ErrorCode::Syntax, RAMURE_NOOP("face %1 has fewer than three corners"),
                                 {std::to_string(face)});
        Index first = 0;
        Index previous = 0;
        for (std::uint64_t k = 0; k < corners; ++k) {
            std::int64_t index = 0;
            if (!readVertex(list, index, 0))
                return false;
            const auto vertex = static_cast<Index>(index);
            if (k == 0)
                first = vertex;
            if (k >= 2)
                m_mesh.triangles.emplace_back(first, previous, vertex);
            previous = vertex;
        }
        if (corners > 3)
            m_polygons.take(m_mesh.triangles, static_cast<std::size_t>(corners), m_mesh.positions);
        return true;
    }
    /// Those of the faces, unless they are all the same and vertices have some.
    void takeColours()
    {
        const auto isFirst = [this](const glm::vec3& colour) { return colour == m_faceColours.front(); };
        const bool haveFaces = !m_faceColours.empty() && m_faceColours.size() == m_mesh.triangles.size();
        if (haveFaces && (m_colours.empty() || !std::ranges::all_of(m_faceColours, isFirst)))
            m_mesh.colours = reading::colourBytes(m_faceColours, m_out.notes);
        else if (!m_colours.empty())
            m_mesh.colours =
                reading::triangleColours(m_mesh.triangles, reading::colourBytes(m_colours, m_out.notes));
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
            m_source.begin(element.name, i);
            if (!readScalars(element, ignored))
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
    glm::dvec3 m_origin;
    const Progress& m_progress;
    std::uint64_t m_vertexCount = 0;
    TriangleMesh m_mesh;
    std::vector<glm::vec3> m_colours;     ///< of the vertices
    std::vector<glm::vec3> m_faceColours; ///< of the triangles
    reading::PolygonList m_polygons;
    bool m_hasTexture = true;                         ///< every face up to here has its coordinates
    std::vector<float> m_faceTexture;                 ///< of the face read last
    std::vector<Index> m_firstTexture, m_nextTexture; ///< per vertex a list of its coordinates
    ReadMesh m_out;
};

/// What the file knows about an element and the program does not want to.
void noteSkippedProperties(const PlyHeader& header, const char* elementName,
                           std::initializer_list<std::string_view> used, std::vector<std::string>& notes)
{
    constexpr std::array colours{"red",           "green",        "blue", "alpha", "diffuse_red",
                                 "diffuse_green", "diffuse_blue", "r",    "g",     "b"};
    std::string names;
    for (const PlyElement& element : header.elements)
        for (const PlyProperty& property : element.properties) {
            const bool isUsed = element.name != elementName ||
                                std::ranges::find(colours, property.name) != colours.end() ||
                                std::ranges::find(used, property.name) != used.end();
            if (!isUsed && names.size() < 200)
                names += (names.empty() ? "" : ", ") + reading::excerpt(property.name);
        }
    if (!names.empty())
        notes.push_back(std::string(elementName) + " properties skipped: " + names);
}

/// \param origin 0: as it stands in the file; else in double precision, from there on
Expected<ReadMesh> bodyOf(std::string_view bytes, const PlyHeader& header, const std::string& file,
                          const glm::dvec3& origin, const Progress& progress)
{
    const bool isFar = origin != glm::dvec3(0.0);
    if (header.format != PlyFormat::Ascii)
        return PlyBody(BinarySource(bytes, header, file), header, origin, progress).read();
    const PlainText plain(bytes.substr(header.bytes));
    auto read = PlyBody(TextSource(plain.view(), file, header.lines, isFar), header, origin, progress).read();
    if (read)
        reading::notePadding(plain.padding(), read->notes);
    return read;
}

} // namespace

Expected<ReadMesh> parsePly(std::string_view bytes, const std::string& file, const Progress& progress)
{
    if (isUtf16(bytes)) {
        const PlainText plain(bytes);
        return parsePly(plain.view(), file, progress);
    }
    const auto header = reading::parsePlyHeader(bytes, file, bytes.size());
    RAMURE_TRY(header);
    auto result = bodyOf(bytes, *header, file, glm::dvec3(0.0), progress);
    const glm::dvec3 origin =
        result ? reading::farOrigin(result->objects.front().mesh.positions) : glm::dvec3(0.0);
    if (origin != glm::dvec3(0.0)) {
        result = bodyOf(bytes, *header, file, origin, progress);
        if (result) {
            result->origin = origin;
            result->notes.push_back(reading::farNote(origin));
        }
    }
    RAMURE_TRY(result);
    ReadObject& only = result->objects.front();
    RAMURE_TRY(reading::checkFaces(only.mesh.positions.size(), only.mesh.triangles.size(), file));
    only.name = reading::stem(file);
    noteSkippedProperties(*header, "vertex", {"x", "y", "z", "nx", "ny", "nz", "branch", "level"},
                          result->notes);
    noteSkippedProperties(*header, "face", {"vertex_indices", "vertex_index", "texcoord"}, result->notes);
    progress.report(1.0);
    return result;
}

Expected<ReadMesh> reading::readPlyFile(const std::string& path, const Progress& progress)
{
    const auto bytes = loadFile(path);
    RAMURE_TRY(bytes);
    return parsePly(*bytes, path, progress);
}

} // namespace ramure
