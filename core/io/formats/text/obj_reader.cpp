#include "core/io/formats/text/material_file.h"
#include "core/io/formats/text/obj_scan.h"
#include "core/io/mesh_mending.h"
#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <set>

namespace ramure {

namespace {

using reading::ObjLists;
using reading::ObjMark;
using reading::plainColour;

/// One normal per vertex, from the normals of its corners; empty where a corner has none.
std::vector<glm::vec3> vertexNormals(ObjLists& lists, std::vector<std::string>& notes)
{
    const std::size_t vertices = lists.positions.size();
    if (!lists.givesNormals() || lists.cornersWithoutNormal > 0)
        return {};
    lists.normalOf.resize(vertices, noIndex);
    bool isParallel = lists.otherNormals.empty() && lists.normals.size() == vertices;
    for (std::size_t v = 0; v < vertices && isParallel; ++v)
        isParallel = lists.normalOf[v] == v || lists.normalOf[v] == noIndex;
    if (isParallel)
        return std::move(lists.normals);

    std::vector<glm::vec3> out(vertices, glm::vec3(0.0f, 1.0f, 0.0f));
    for (std::size_t v = 0; v < vertices; ++v)
        if (lists.normalOf[v] != noIndex)
            out[v] = lists.normals[lists.normalOf[v]];
    // Where faces disagree: the mean of the different ones.
    auto& others = lists.otherNormals;
    std::sort(others.begin(), others.end());
    others.erase(std::unique(others.begin(), others.end()), others.end());
    std::size_t averaged = 0;
    for (std::size_t i = 0; i < others.size();) {
        const Index v = others[i].first;
        const bool hasFirst = lists.normalOf[v] != noIndex;
        glm::vec3 sum = hasFirst ? out[v] : glm::vec3(0.0f);
        const glm::vec3 first = hasFirst ? out[v] : lists.normals[others[i].second];
        for (; i < others.size() && others[i].first == v; ++i)
            if (others[i].second != lists.normalOf[v])
                sum += lists.normals[others[i].second];
        const float length = glm::length(sum);
        out[v] = length > 0.0f ? sum / length : first;
        ++averaged;
    }
    if (averaged > 0)
        notes.push_back(std::to_string(averaged) + " vertices with several normals: their mean is taken");
    return out;
}

/// Which object a triangle and a vertex belong to, by the marks `o`, or `g` where there is none.
struct Split
{
    struct Range
    {
        std::size_t object;
        Index firstVertex, firstTriangle;
    };
    std::vector<std::string> names;
    std::vector<Range> ranges; ///< in the order of the file
};

Split splitOf(const ObjLists& lists, const std::string& file)
{
    const bool byObjects = !lists.objects.empty();
    Split out;
    out.names = {reading::stem(file)};
    out.ranges = {{0, 0, 0}};
    std::map<std::string, std::size_t> byName;
    for (const ObjMark& mark : byObjects ? lists.objects : lists.groups) {
        const std::string name = mark.name.empty() ? "default" : mark.name;
        // A group may be taken up again; two objects of one name are two.
        const auto [place, isNew] = byName.try_emplace(name, out.names.size());
        if (isNew || byObjects) {
            place->second = out.names.size();
            out.names.push_back(name);
        }
        out.ranges.push_back({place->second, mark.firstVertex, mark.firstTriangle});
    }
    return out;
}

/// One coordinate per vertex, in the vertices' order, needs no numbers of its own.
void simplifyTexture(TriangleMesh& mesh)
{
    if (mesh.uv.size() == mesh.positions.size() && mesh.uvTriangles == mesh.triangles)
        mesh.uvTriangles.clear();
}

/// The colours of all material files that the OBJ names; of a name in several of them the last counts.
MaterialColours materialColours(const ObjLists& lists, const MaterialSource& materials)
{
    MaterialColours out;
    const auto take = [&](const std::string& name) {
        const auto text = materials(name);
        if (!text)
            return std::optional(text.error());
        MaterialColours read = parseMaterials(*text, name);
        for (const auto& [material, colour] : read.colours)
            out.colours.insert_or_assign(material, colour);
        out.notes.insert(out.notes.end(), read.notes.begin(), read.notes.end());
        return std::optional<Error>();
    };
    for (const auto& [line, names] : lists.libraries) {
        // One name that may have blanks, or several names.
        const auto problem = take(names);
        bool isRead = !problem;
        for (std::size_t at = 0; problem && names.find(' ') != std::string::npos && at < names.size();) {
            const std::size_t end = std::min(names.find(' ', at), names.size());
            isRead = (end > at && !take(names.substr(at, end - at))) || isRead;
            at = end + 1;
        }
        if (!isRead)
            out.notes.push_back("line " + std::to_string(line) + ": the material file \"" +
                                reading::excerpt(names) + "\" cannot be read, " + problem->plain() +
                                ": its colours are left out");
    }
    return out;
}

/// Materials without a colour that are noted.
constexpr std::size_t mostMissing = 20;

/// Of the vertices, where one is not white, as all are where nobody painted; empty else.
std::vector<glm::u8vec3> paintedColours(ObjLists& lists, std::vector<std::string>& notes)
{
    if (lists.colours.empty())
        return {};
    float most = 1.0F;
    for (const glm::vec3& c : lists.colours)
        most = std::max({most, c.r, c.g, c.b});
    std::ranges::replace(lists.colours, reading::noColour, glm::vec3(most > 1.0F ? 255.0F : 1.0F));
    std::vector<glm::u8vec3> bytes = reading::colourBytes(lists.colours, notes);
    const bool isWhite =
        std::ranges::all_of(bytes, [](const glm::u8vec3& c) { return c == glm::u8vec3(255); });
    return isWhite ? std::vector<glm::u8vec3>() : reading::triangleColours(lists.triangles, bytes);
}

/// The colours of the triangles in the file's order: those of the vertices, else those of the materials;
/// empty where there are none.
std::vector<glm::u8vec3> coloursOf(ObjLists& lists, const MaterialSource& materials,
                                   std::vector<std::string>& notes)
{
    std::vector<glm::u8vec3> painted = paintedColours(lists, notes);
    if (!materials || lists.libraries.empty() || lists.materials.empty() || !painted.empty())
        return painted;
    MaterialColours read = materialColours(lists, materials);
    notes.insert(notes.end(), read.notes.begin(), read.notes.end());
    std::vector<glm::u8vec3> out;
    std::set<std::string> missing;
    for (std::size_t i = 0; i < lists.materials.size() && !read.colours.empty(); ++i) {
        const std::string& name = lists.materials[i].name;
        const auto found = read.colours.find(name);
        if (found == read.colours.end() && missing.size() < mostMissing && missing.insert(name).second)
            notes.push_back("the material \"" + reading::excerpt(name) +
                            "\" has no colour in the material file");
        if (found == read.colours.end())
            continue;
        const std::size_t end =
            i + 1 < lists.materials.size() ? lists.materials[i + 1].firstTriangle : lists.triangles.size();
        out.resize(lists.triangles.size(), plainColour);
        std::fill(out.begin() + lists.materials[i].firstTriangle, out.begin() + std::ptrdiff_t(end),
                  found->second);
    }
    return out;
}

/// Distributes vertices and triangles over the objects.
class ObjectSplitter
{
public:
    ObjectSplitter(const ObjLists& lists, const std::vector<glm::u8vec3>& colours, const Split& split)
        : m_lists(lists)
        , m_colours(colours)
        , m_split(split)
        , m_local(lists.positions.size(), noIndex)
        , m_user(lists.positions.size(), noIndex)
    {
    }

    std::vector<ReadObject> run()
    {
        std::vector<std::vector<std::size_t>> rangesOf(m_split.names.size());
        for (std::size_t r = 0; r < m_split.ranges.size(); ++r)
            rangesOf[m_split.ranges[r].object].push_back(r);
        std::vector<std::vector<Index>> vertices(m_split.names.size());
        for (std::size_t object = 0; object < rangesOf.size(); ++object)
            collectUsed(object, rangesOf[object], vertices[object]);
        for (std::size_t r = 0; r < m_split.ranges.size(); ++r)
            for (Index v = m_split.ranges[r].firstVertex; v < endVertex(r); ++v)
                if (m_user[v] == noIndex)
                    vertices[m_split.ranges[r].object].push_back(v);
        std::vector<ReadObject> out;
        for (std::size_t object = 0; object < rangesOf.size(); ++object)
            if (!vertices[object].empty())
                out.push_back(build(object, rangesOf[object], std::move(vertices[object])));
        return out;
    }

private:
    Index endVertex(std::size_t r) const
    {
        return r + 1 < m_split.ranges.size() ? m_split.ranges[r + 1].firstVertex
                                             : static_cast<Index>(m_lists.positions.size());
    }
    Index endTriangle(std::size_t r) const
    {
        return r + 1 < m_split.ranges.size() ? m_split.ranges[r + 1].firstTriangle
                                             : static_cast<Index>(m_lists.triangles.size());
    }
    template <class Use> void forTriangles(const std::vector<std::size_t>& ranges, Use&& use) const
    {
        for (const std::size_t r : ranges)
            for (Index t = m_split.ranges[r].firstTriangle; t < endTriangle(r); ++t)
                use(m_lists.triangles[t], t);
    }
    void collectUsed(std::size_t object, const std::vector<std::size_t>& ranges, std::vector<Index>& to)
    {
        forTriangles(ranges, [&](const glm::uvec3& t, Index) {
            for (int k = 0; k < 3; ++k) {
                Index& user = m_user[t[k]];
                if (user == object)
                    continue;
                m_isShared = m_isShared || user != noIndex;
                user = static_cast<Index>(object);
                to.push_back(t[k]);
            }
        });
    }
    ReadObject build(std::size_t object, const std::vector<std::size_t>& ranges, std::vector<Index> vertices)
    {
        std::sort(vertices.begin(), vertices.end());
        ReadObject out;
        out.name = m_split.names[object];
        for (const Index v : vertices) {
            m_local[v] = out.mesh.vertexCount();
            out.mesh.positions.push_back(m_lists.positions[v]);
            if (!m_lists.normals.empty())
                out.mesh.normals.push_back(m_lists.normals[v]);
        }
        forTriangles(ranges, [&](const glm::uvec3& t, Index number) {
            out.mesh.triangles.emplace_back(m_local[t.x], m_local[t.y], m_local[t.z]);
            if (!m_colours.empty())
                out.mesh.colours.push_back(m_colours[number]);
        });
        takeTexture(ranges, out.mesh);
        if (m_isShared)
            out.fileVertex = std::move(vertices);
        return out;
    }

    /// Texture coordinates of an object, in the order of the file; none where a corner has none.
    void takeTexture(const std::vector<std::size_t>& ranges, TriangleMesh& mesh)
    {
        std::vector<Index> used;
        bool hasAll = true;
        forTriangles(ranges, [&](const glm::uvec3&, Index number) {
            hasAll = hasAll && number < m_lists.textureTriangles.size();
            for (int k = 0; k < 3 && hasAll; ++k) {
                used.push_back(m_lists.textureTriangles[number][k]);
                hasAll = used.back() != noIndex;
            }
        });
        if (!hasAll || used.empty())
            return;
        std::sort(used.begin(), used.end());
        used.erase(std::unique(used.begin(), used.end()), used.end());
        m_localTexture.resize(m_lists.texture.size());
        for (const Index texture : used) {
            m_localTexture[texture] = static_cast<Index>(mesh.uv.size());
            mesh.uv.push_back(m_lists.texture[texture]);
        }
        forTriangles(ranges, [&](const glm::uvec3&, Index number) {
            const glm::uvec3& t = m_lists.textureTriangles[number];
            mesh.uvTriangles.emplace_back(m_localTexture[t.x], m_localTexture[t.y], m_localTexture[t.z]);
        });
        simplifyTexture(mesh);
    }

    const ObjLists& m_lists;
    const std::vector<glm::u8vec3>& m_colours; ///< per triangle, or none
    std::vector<Index> m_localTexture; ///< number of a texture coordinate within the object being built
    const Split& m_split;
    std::vector<Index> m_local; ///< number of a vertex within the object being built
    std::vector<Index> m_user;  ///< the last object that was found to use a vertex
    bool m_isShared = false;
};

/// \param scan gives the lists, with positions from a given origin on
template <class Scan>
Expected<ReadMesh> meshOf(Scan&& scan, const std::string& file, const MaterialSource& materials,
                          const Progress& progress)
{
    Expected<ObjLists> lists = scan(glm::dvec3(0.0));
    ReadMesh out;
    if (lists)
        out.origin = reading::farOrigin(lists->positions);
    if (out.origin != glm::dvec3(0.0))
        lists = scan(out.origin);
    RAMURE_TRY(lists);
    RAMURE_TRY(reading::checkFaces(lists->positions.size(), lists->triangles.size(), file));
    out.notes = std::move(lists->notes);
    if (out.origin != glm::dvec3(0.0))
        out.notes.push_back(reading::farNote(out.origin));
    lists->normals = vertexNormals(*lists, out.notes);
    const Split split = splitOf(*lists, file);
    std::vector<glm::u8vec3> colours = coloursOf(*lists, materials, out.notes);
    const bool isWhole =
        split.ranges.size() == 1 ||
        (split.ranges.size() == 2 && split.ranges[1].firstVertex == 0 && split.ranges[1].firstTriangle == 0);
    if (isWhole) {
        ReadObject object;
        object.name = split.names.back();
        object.mesh.positions = std::move(lists->positions);
        object.mesh.normals = std::move(lists->normals);
        object.mesh.triangles = std::move(lists->triangles);
        object.mesh.colours = std::move(colours);
        const auto isWholly = [](const glm::uvec3& t) {
            return t.x != noIndex && t.y != noIndex && t.z != noIndex;
        };
        std::vector<glm::uvec3>& texture = lists->textureTriangles;
        if (texture.size() == object.mesh.triangles.size() && !texture.empty() &&
            std::all_of(texture.begin(), texture.end(), isWholly)) {
            object.mesh.uv = std::move(lists->texture);
            object.mesh.uvTriangles = std::move(texture);
            simplifyTexture(object.mesh);
        }
        out.objects.push_back(std::move(object));
    } else {
        out.objects = ObjectSplitter(*lists, colours, split).run();
    }
    for (ReadObject& object : out.objects)
        reading::mendNormals(object.mesh, out.notes);
    progress.report(1.0);
    return out;
}

} // namespace

Expected<ReadMesh> parseObj(std::string_view text, const std::string& file, const Progress& progress,
                            const MaterialSource& materials)
{
    return meshOf(
        [&](const glm::dvec3& origin) {
            return reading::scanObj(text, file, progress.part(0.0, 0.9), origin);
        },
        file, materials, progress);
}

Expected<ReadMesh> reading::readObjFile(const std::string& path, const Progress& progress,
                                        const MaterialSource& materials, std::size_t blockSize)
{
    auto input = InputFile::open(path);
    RAMURE_TRY(input);
    if (input->isRegular())
        return meshOf(
            [&](const glm::dvec3& origin) {
                input->rewind();
                return scanObj(*input, path, progress.part(0.0, 0.9), blockSize, origin);
            },
            path, materials, progress);
    const auto text = loadFile(*input);
    RAMURE_TRY(text);
    return parseObj(*text, path, progress, materials);
}

} // namespace ramure
