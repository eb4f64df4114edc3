#include "core/io/formats/glb/glb_mesh_reader.h"

#include "core/io/mesh_mending.h"
#include "core/math/finite.h"
#include "core/math/reproducible.h"
#include "core/surface/mesh/duplicate_positions.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

namespace ramure::glb {

namespace {

template <class V> std::vector<V> vectorsOf(const std::vector<float>& numbers)
{
    constexpr int size = V::length();
    std::vector<V> out(numbers.size() / static_cast<std::size_t>(size));
    for (std::size_t i = 0; i < numbers.size(); ++i)
        out[i / size][static_cast<int>(i % size)] = typename V::value_type(numbers[i]);
    return out;
}

/// The corners of triangles, of a strip or a fan too.
std::vector<Index> trianglesOf(const std::vector<Index>& corners, std::size_t mode)
{
    constexpr std::size_t triangles = 4, strip = 5;
    if (mode == triangles)
        return {corners.begin(), corners.end() - static_cast<std::ptrdiff_t>(corners.size() % 3)};
    std::vector<Index> out;
    for (std::size_t i = 2; i < corners.size(); ++i) {
        const std::size_t turn = mode == strip ? i % 2 : 0;
        out.push_back(mode == strip ? corners[i - 2 + turn] : corners[i - 1]);
        out.push_back(mode == strip ? corners[i - 1 - turn] : corners[i]);
        out.push_back(mode == strip ? corners[i] : corners.front());
    }
    return out;
}

/// Long enough to be normalised.
bool isDirection(const glm::vec3& n)
{
    const float square = glm::dot(n, n);
    return square > std::numeric_limits<float>::min() && std::isfinite(square);
}

class PrimitiveReader
{
public:
    PrimitiveReader(File& file, const Json& json, std::string place)
        : m_file(file)
        , m_json(json)
        , m_place(std::move(place))
    {
    }

    /// Nothing where it has no triangles.
    Expected<std::optional<Primitive>> read(std::vector<std::string>& notes)
    {
        const std::size_t mode = numberOf(m_json, "mode").value_or(4);
        if (mode < 4 || mode > 6) {
            notes.push_back(m_place + ": points and lines are left out");
            return std::nullopt;
        }
        if (member(m_json, "targets"))
            notes.push_back(m_place + ": shapes to blend to are left out");
        m_out.material = numberOf(m_json, "material");
        auto positions = attribute("POSITION", 3);
        RAMURE_TRY(positions);
        m_out.positions = vectorsOf<glm::vec3>(*positions);
        readLook(notes);
        RAMURE_TRY(readSkin());
        RAMURE_TRY(readCorners(mode));
        if (!std::ranges::all_of(m_out.normals, &isDirection))
            mendNormals(notes);
        for (glm::vec3& n : m_out.normals)
            n = glm::normalize(n);
        return m_out.indices.empty() ? std::nullopt : std::optional(std::move(m_out));
    }

private:
    [[nodiscard]] std::optional<std::size_t> accessorOf(const char* name) const
    {
        const Json* attributes = member(m_json, "attributes");
        return attributes ? numberOf(*attributes, name) : std::nullopt;
    }
    /// Of as many vertices as there are positions.
    Expected<std::vector<float>> attribute(const char* name, std::size_t components)
    {
        auto out = m_file.floats(accessorOf(name), components, m_place + "." + name);
        if (out && !m_out.positions.empty() && out->size() != components * m_out.positions.size())
            return wrong(m_place + "." + name, RAMURE_NOOP("not as many as there are positions"));
        return out;
    }
    /// A mesh is one without these: what is wrong with them is a note, and they are left out.
    std::vector<float> lookOf(const char* name, std::size_t components, std::vector<std::string>& notes)
    {
        const std::string place = m_place + "." + name;
        if (!accessorOf(name))
            return {};
        auto out = m_file.anyFloats(accessorOf(name), components, place);
        if (out && out->size() != components * m_out.positions.size())
            out = wrong(place, RAMURE_NOOP("not as many as there are positions"));
        if (out)
            return std::move(*out);
        notes.push_back(place + ": " + out.error().message() + ": left out");
        return {};
    }
    void readLook(std::vector<std::string>& notes)
    {
        m_out.normals = vectorsOf<glm::vec3>(lookOf("NORMAL", 3, notes));
        m_out.uv = vectorsOf<glm::vec2>(lookOf("TEXCOORD_0", 2, notes));
        if (!std::ranges::all_of(m_out.uv, &isFinite<2, float>)) {
            m_out.uv.clear();
            notes.push_back(m_place + ".TEXCOORD_0: a number is not finite: left out");
        }
        for (glm::vec2& place : m_out.uv)
            place.y = 1.0F - place.y;
        const std::size_t components = m_file.components(accessorOf("COLOR_0")) == 4 ? 4 : 3;
        const std::vector<float> colours = lookOf("COLOR_0", components, notes);
        for (std::size_t i = 0; i < colours.size(); i += components)
            m_out.colours.emplace_back(colours[i], colours[i + 1], colours[i + 2]);
        if (!std::ranges::all_of(m_out.colours, &isFinite<3, float>)) {
            m_out.colours.clear();
            notes.push_back(m_place + ".COLOR_0: a number is not finite: left out");
        }
    }
    /// Those of no direction get that of their faces.
    void mendNormals(std::vector<std::string>& notes)
    {
        for (glm::vec3& n : m_out.normals)
            n = isDirection(n) ? n : glm::vec3(0.0F);
        TriangleMesh mesh;
        mesh.positions = m_out.positions;
        for (std::size_t i = 0; i + 2 < m_out.indices.size(); i += 3)
            mesh.triangles.emplace_back(m_out.indices[i], m_out.indices[i + 1], m_out.indices[i + 2]);
        mesh.normals = std::move(m_out.normals);
        const std::size_t before = notes.size();
        reading::mendNormals(mesh, notes);
        for (std::size_t i = before; i < notes.size(); ++i)
            notes[i] = m_place + ".NORMAL: " + notes[i];
        m_out.normals = std::move(mesh.normals);
    }
    Expected<void> readSkin()
    {
        if (!accessorOf("JOINTS_0") || !accessorOf("WEIGHTS_0"))
            return {};
        const auto joints = m_file.indices(accessorOf("JOINTS_0"), 4, m_place + ".JOINTS_0");
        const auto weights = attribute("WEIGHTS_0", 4);
        if (!joints || !weights)
            return fail(joints ? weights.error() : joints.error());
        if (joints->size() != weights->size())
            return wrong(m_place + ".JOINTS_0", RAMURE_NOOP("not as many as there are positions"));
        m_out.weights = vectorsOf<glm::vec4>(*weights);
        m_out.joints.resize(joints->size() / 4);
        for (std::size_t i = 0; i < joints->size(); ++i)
            m_out.joints[i / 4][static_cast<int>(i % 4)] = (*joints)[i];
        return {};
    }
    Expected<void> readCorners(std::size_t mode)
    {
        std::vector<Index> corners(m_out.positions.size());
        if (member(m_json, "indices")) {
            auto read = m_file.indices(numberOf(m_json, "indices"), 1, m_place + ".indices");
            RAMURE_TRY(read);
            corners = std::move(*read);
        } else
            for (std::size_t i = 0; i < corners.size(); ++i)
                corners[i] = static_cast<Index>(i);
        if (corners.size() > 3 * mostTriangles)
            return wrong(m_place, RAMURE_NOOP("more than %1 triangles"), {std::to_string(mostTriangles)},
                         ErrorCode::Limit);
        if (std::ranges::any_of(corners, [&](Index corner) { return corner >= m_out.positions.size(); }))
            return wrong(m_place + ".indices", RAMURE_NOOP("a triangle with a vertex that does not exist"));
        m_out.indices = trianglesOf(corners, mode);
        return {};
    }

    File& m_file;
    const Json& m_json;
    std::string m_place;
    Primitive m_out;
};

/// What EXT_mesh_manifold says, where it is about the same corners.
Expected<void> readClosed(File& file, const Json& json, const std::string& place, ReadGlbMesh& mesh)
{
    const Json* extensions = member(json, "extensions");
    const Json* manifold = extensions ? member(*extensions, "EXT_mesh_manifold") : nullptr;
    const Json* whole = manifold ? member(*manifold, "manifoldPrimitive") : nullptr;
    const Json* attributes = whole ? member(*whole, "attributes") : nullptr;
    if (!attributes)
        return {};
    const std::string inside = place + ".EXT_mesh_manifold";
    auto corners = file.indices(numberOf(*whole, "indices"), 1, inside);
    const auto positions = file.floats(numberOf(*attributes, "POSITION"), 3, inside);
    if (!corners || !positions)
        return fail(corners ? positions.error() : corners.error());
    std::size_t at = 0;
    bool isSame = true;
    for (const Primitive& primitive : mesh.primitives)
        for (const Index index : primitive.indices) {
            isSame = isSame && at < corners->size() && (*corners)[at] < positions->size() / 3;
            for (int axis = 0; isSame && axis < 3; ++axis)
                isSame = (*positions)[std::size_t(3) * (*corners)[at] + static_cast<std::size_t>(axis)] ==
                         primitive.positions[index][axis];
            ++at;
        }
    if (isSame && at == corners->size())
        mesh.closedCorners = std::move(*corners);
    else
        mesh.notes.push_back(inside + ": not about the same triangles: left out");
    return {};
}

/// The corners of several primitives, and which of their vertices become one.
class Joiner
{
public:
    Joiner(const ReadGlbMesh& mesh, std::size_t first, std::size_t count)
        : m_primitives(mesh.primitives.data() + first, count)
    {
        for (std::size_t p = 0; p < count; ++p) {
            std::vector<Index> places(m_primitives[p].positions.size(), noIndex);
            for (const Index index : m_primitives[p].indices) {
                if (places[index] == noIndex) {
                    places[index] = static_cast<Index>(m_vertices.size());
                    m_vertices.emplace_back(&m_primitives[p], index);
                }
                m_corners.push_back(places[index]);
            }
        }
        std::size_t before = 0;
        for (std::size_t p = 0; p < first; ++p)
            before += mesh.primitives[p].indices.size();
        if (mesh.closedCorners.empty() || !groupAs(std::span(mesh.closedCorners).subspan(before)))
            groupByPosition();
        number();
    }

    TriangleMesh run(std::span<const glm::vec3> colours) const
    {
        TriangleMesh out;
        out.positions.resize(m_count);
        for (std::size_t v = m_vertices.size(); v-- > 0;)
            out.positions[m_group[v]] = positionOf(v);
        for (std::size_t i = 0; i + 2 < m_corners.size(); i += 3)
            out.triangles.emplace_back(m_group[m_corners[i]], m_group[m_corners[i + 1]],
                                       m_group[m_corners[i + 2]]);
        addNormals(out);
        addUv(out);
        addColours(out, colours);
        return out;
    }

private:
    using Vertex = std::pair<const Primitive*, Index>;

    [[nodiscard]] const glm::vec3& positionOf(std::size_t vertex) const
    {
        return m_vertices[vertex].first->positions[m_vertices[vertex].second];
    }
    /// False where the surface parts what is one vertex here.
    bool groupAs(std::span<const Index> closed)
    {
        m_group.assign(m_vertices.size(), noIndex);
        for (std::size_t i = 0; i < m_corners.size(); ++i) {
            Index& group = m_group[m_corners[i]];
            if (group != noIndex && group != closed[i])
                return false;
            group = closed[i];
        }
        return true;
    }
    void groupByPosition()
    {
        std::vector<glm::vec3> positions;
        m_group.clear();
        for (std::size_t v = 0; v < m_vertices.size(); ++v) {
            positions.push_back(positionOf(v));
            m_group.push_back(static_cast<Index>(v));
        }
        for (const DuplicatePosition& duplicate : findDuplicatePositions(positions))
            m_group[duplicate.vertex] = duplicate.earlier;
    }
    /// From 0 on, in the order in which they are met.
    void number()
    {
        Index most = 0;
        for (const Index group : m_group)
            most = std::max(most, group);
        std::vector<Index> numbers(std::size_t(most) + 1, noIndex);
        for (Index& group : m_group) {
            if (numbers[group] == noIndex)
                numbers[group] = m_count++;
            group = numbers[group];
        }
    }
    [[nodiscard]] bool all(const auto& has) const { return std::ranges::all_of(m_primitives, has); }

    void addNormals(TriangleMesh& out) const
    {
        if (!all([](const Primitive& p) { return !p.normals.empty(); }))
            return;
        std::vector<glm::vec3> sums(m_count, glm::vec3(0.0F)), firsts = sums;
        for (std::size_t v = m_vertices.size(); v-- > 0;) {
            const glm::vec3& normal = m_vertices[v].first->normals[m_vertices[v].second];
            sums[m_group[v]] += normal;
            firsts[m_group[v]] = normal;
        }
        for (std::size_t v = 0; v < m_count; ++v) {
            const float length = glm::length(sums[v]);
            // Those that were the same stay the same to the last bit.
            const bool isOne = length > 0.0F && glm::dot(sums[v], firsts[v]) > 0.999999F * length;
            out.normals.push_back(isOne || length < 1e-3F ? firsts[v] : sums[v] / length);
        }
    }
    void addUv(TriangleMesh& out) const
    {
        if (!all([](const Primitive& p) { return !p.uv.empty(); }))
            return;
        for (const auto& [primitive, vertex] : m_vertices)
            out.uv.push_back(primitive->uv[vertex]);
        if (m_vertices.size() == m_count)
            return;
        for (std::size_t i = 0; i + 2 < m_corners.size(); i += 3)
            out.uvTriangles.emplace_back(m_corners[i], m_corners[i + 1], m_corners[i + 2]);
    }
    void addColours(TriangleMesh& out, std::span<const glm::vec3> colours) const
    {
        const bool isOne = std::ranges::all_of(colours, [&](const glm::vec3& c) { return c == colours[0]; });
        if (isOne && all([](const Primitive& p) { return p.colours.empty(); }))
            return;
        for (std::size_t p = 0; p < m_primitives.size(); ++p) {
            const Primitive& from = m_primitives[p];
            for (std::size_t i = 0; i + 2 < from.indices.size(); i += 3) {
                glm::vec3 colour(1.0F);
                if (!from.colours.empty())
                    colour = (from.colours[from.indices[i]] + from.colours[from.indices[i + 1]] +
                              from.colours[from.indices[i + 2]]) /
                             3.0F;
                out.colours.push_back(srgb(colour * colours[p]));
            }
        }
    }

    std::span<const Primitive> m_primitives;
    std::vector<Vertex> m_vertices; ///< those that a triangle has
    std::vector<Index> m_corners;   ///< of all triangles
    std::vector<Index> m_group;     ///< per vertex its vertex of the mesh
    Index m_count = 0;
};

} // namespace

Expected<ReadGlbMesh> readGlbMesh(File& file, std::size_t number)
{
    const std::string place = placeOf("meshes", number);
    const auto json = file.element("meshes", number, place);
    RAMURE_TRY(json);
    const Json* primitives = member(**json, "primitives");
    ReadGlbMesh out;
    out.name = textOf(**json, "name");
    for (std::size_t i = 0; primitives && primitives->is_array() && i < primitives->size(); ++i) {
        auto read =
            PrimitiveReader(file, (*primitives)[i], place + "." + placeOf("primitives", i)).read(out.notes);
        RAMURE_TRY(read);
        if (*read)
            out.primitives.push_back(std::move(**read));
    }
    RAMURE_TRY(readClosed(file, **json, place, out));
    return out;
}

Expected<void> applySkin(ReadGlbMesh& mesh, std::span<const glm::dmat4> joints, const std::string& place)
{
    for (Primitive& primitive : mesh.primitives)
        for (std::size_t v = 0; v < primitive.joints.size(); ++v) {
            glm::dmat4 matrix(0.0);
            double sum = 0.0;
            for (int k = 0; k < 4; ++k) {
                const double weight = double(primitive.weights[v][k]);
                if (weight == 0.0)
                    continue;
                if (primitive.joints[v][k] >= joints.size())
                    return wrong(place, RAMURE_NOOP("a vertex follows a joint that the skin has not"));
                matrix += weight * joints[primitive.joints[v][k]];
                sum += weight;
            }
            if (!(sum > 0.0))
                continue;
            matrix /= sum;
            glm::vec3& position = primitive.positions[v];
            position = glm::vec3(matrix * glm::dvec4(position, 1.0));
            if (!primitive.normals.empty()) {
                const glm::dvec3 normal = glm::dmat3(matrix) * glm::dvec3(primitive.normals[v]);
                if (glm::length(normal) > 0.0)
                    primitive.normals[v] = glm::vec3(glm::normalize(normal));
            }
        }
    return {};
}

TriangleMesh joinedMesh(const ReadGlbMesh& mesh, std::size_t first, std::size_t count,
                        std::span<const glm::vec3> colours)
{
    return Joiner(mesh, first, count).run(colours.subspan(first, count));
}

glm::u8vec3 srgb(const glm::vec3& linear)
{
    glm::u8vec3 out;
    for (int c = 0; c < 3; ++c) {
        const double l = std::clamp(double(linear[c]), 0.0, 1.0);
        const double s = l <= 0.0031308 ? 12.92 * l : 1.055 * maths::pow(l, 1.0 / 2.4) - 0.055;
        out[c] = static_cast<std::uint8_t>(std::lround(255.0 * s));
    }
    return out;
}

} // namespace ramure::glb
