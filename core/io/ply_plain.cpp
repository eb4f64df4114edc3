#include "core/io/ply_source.h"

namespace ramure::reading {

namespace {

/// Byte offsets within one vertex, or -1.
struct PlainLayout
{
    std::size_t stride = 0;
    std::ptrdiff_t position = -1; ///< x, y and z as floats in a row
    std::ptrdiff_t normal = -1;
    std::ptrdiff_t branch = -1;
    std::ptrdiff_t level = -1;
};

std::optional<PlainLayout> layoutOf(const PlyElement& vertex)
{
    PlainLayout out;
    const auto& properties = vertex.properties;
    const auto isTriple = [&](std::size_t p, const char* x, const char* y, const char* z) {
        const char* const names[] = {x, y, z};
        for (std::size_t k = 0; k < 3; ++k)
            if (p + k >= properties.size() || properties[p + k].name != names[k] ||
                properties[p + k].type != PlyType::Float32)
                return false;
        return true;
    };
    for (std::size_t p = 0; p < properties.size(); ++p) {
        if (properties[p].isList)
            return std::nullopt;
        const auto offset = static_cast<std::ptrdiff_t>(out.stride);
        if (isTriple(p, "x", "y", "z"))
            out.position = offset;
        if (isTriple(p, "nx", "ny", "nz"))
            out.normal = offset;
        for (const auto& [name, slot] : {std::pair{"branch", &out.branch}, std::pair{"level", &out.level}})
            if (properties[p].name == name) {
                if (sizeOf(properties[p].type) != sizeof(Index) || !isInteger(properties[p].type))
                    return std::nullopt;
                *slot = offset;
            }
        out.stride += sizeOf(properties[p].type);
    }
    const bool hasOtherNormals = out.normal < 0 && vertex.find("nx") >= 0;
    if (out.position < 0 || hasOtherNormals)
        return std::nullopt;
    return out;
}

bool isPlainFace(const PlyElement& face)
{
    if (face.name != "face" || face.properties.size() != 1)
        return false;
    const PlyProperty& list = face.properties[0];
    return (list.name == "vertex_indices" || list.name == "vertex_index") && list.isList &&
           sizeOf(list.countType) == 1 && isInteger(list.type) && sizeOf(list.type) == sizeof(Index);
}

template <class T>
void copyStrided(std::vector<T>& to, const char* from, std::size_t stride, std::size_t count)
{
    to.reserve(count);
    adviseHugePages(to.data(), count * sizeof(T));
    to.resize(count);
    for (std::size_t i = 0; i < count; ++i)
        std::memcpy(&to[i], from + i * stride, sizeof(T));
}

bool areFinite(const std::vector<glm::vec3>& vectors)
{
    bool areAll = true;
    for (const glm::vec3& v : vectors)
        areAll &= (v.x - v.x) + (v.y - v.y) + (v.z - v.z) == 0.0f; // infinity and NaN give NaN
    return areAll;
}

/// False where a face is no triangle or an index is out of range.
bool copyFaces(std::vector<glm::uvec3>& to, const char* from, std::size_t count, Index vertices)
{
    constexpr std::size_t stride = 1 + sizeof(glm::uvec3);
    to.reserve(count);
    adviseHugePages(to.data(), count * sizeof(glm::uvec3));
    to.resize(count);
    bool areTriangles = true;
    Index largest = 0;
    for (std::size_t i = 0; i < count; ++i, from += stride) {
        glm::uvec3 t;
        std::memcpy(&t, from + 1, sizeof t);
        areTriangles &= *from == 3;
        largest = std::max(largest, std::max(t.x, std::max(t.y, t.z)));
        to[i] = t;
    }
    return areTriangles && (count == 0 || largest < vertices);
}

} // namespace

std::optional<Expected<ReadMesh>> readPlainPly(std::string_view bytes, const PlyHeader& header,
                                               const Progress& progress)
{
    if constexpr (std::endian::native != std::endian::little)
        return std::nullopt;
    if (header.elements.size() != 2 || header.elements[0].name != "vertex" ||
        !isPlainFace(header.elements[1]))
        return std::nullopt;
    const auto layout = layoutOf(header.elements[0]);
    const std::uint64_t vertices = header.elements[0].count;
    const std::uint64_t faces = header.elements[1].count;
    if (!layout || vertices == 0 || vertices >= noIndex || faces >= noIndex)
        return std::nullopt;
    const std::uint64_t facesBegin =
        header.bytes + vertices * layout->stride; // the header has checked that they fit
    if (bytes.size() - facesBegin != faces * (1 + sizeof(glm::uvec3)))
        return std::nullopt;

    TriangleMesh mesh;
    const char* const from = bytes.data() + header.bytes;
    const auto count = static_cast<std::size_t>(vertices);
    copyStrided(mesh.positions, from + layout->position, layout->stride, count);
    if (layout->normal >= 0)
        copyStrided(mesh.normals, from + layout->normal, layout->stride, count);
    if (layout->branch >= 0)
        copyStrided(mesh.branch, from + layout->branch, layout->stride, count);
    if (layout->level >= 0)
        copyStrided(mesh.level, from + layout->level, layout->stride, count);
    if (!areFinite(mesh.positions) || !areFinite(mesh.normals))
        return std::nullopt;
    progress.report(0.5);
    if (progress.cancelled())
        return std::nullopt; // the general reader says so
    if (!copyFaces(mesh.triangles, bytes.data() + facesBegin, static_cast<std::size_t>(faces),
                   static_cast<Index>(vertices)))
        return std::nullopt;
    ReadMesh out;
    out.objects.push_back({{}, std::move(mesh), {}});
    return Expected<ReadMesh>(std::move(out));
}

} // namespace ramure::reading
