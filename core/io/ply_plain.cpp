#include "core/io/ply_source.h"
#include <iterator>

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

/// Walks over records of equal size and gives a value that stands in each: a vector built from two of these
/// is written once, and not filled with zeros before.
template <class T> class StridedIterator
{
public:
    using iterator_category = std::random_access_iterator_tag; // so that the size is known before
    using value_type = T;
    using difference_type = std::ptrdiff_t;
    using pointer = const T*;
    using reference = T;

    StridedIterator(const char* at, std::size_t stride)
        : m_at(at)
        , m_stride(static_cast<std::ptrdiff_t>(stride))
    {
    }
    T operator*() const
    {
        T value;
        std::memcpy(&value, m_at, sizeof value);
        return value;
    }
    StridedIterator& operator++()
    {
        m_at += m_stride;
        return *this;
    }
    StridedIterator& operator--()
    {
        m_at -= m_stride;
        return *this;
    }
    StridedIterator& operator+=(difference_type n)
    {
        m_at += n * m_stride;
        return *this;
    }
    difference_type operator-(const StridedIterator& other) const { return (m_at - other.m_at) / m_stride; }
    bool operator==(const StridedIterator& other) const { return m_at == other.m_at; }

private:
    const char* m_at;
    std::ptrdiff_t m_stride;
};

template <class T> void reserveHuge(std::vector<T>& to, std::size_t count)
{
    to.reserve(count);
    adviseHugePages(to.data(), count * sizeof(T));
}

/// Appends the values at \p offset of \p count records; nothing where there is no such property.
template <class T>
void appendStrided(std::vector<T>& to, const char* from, std::ptrdiff_t offset, std::size_t stride,
                   std::size_t count)
{
    if (offset >= 0)
        to.insert(to.end(), StridedIterator<T>(from + offset, stride),
                  StridedIterator<T>(from + offset + static_cast<std::ptrdiff_t>(stride * count), stride));
}

/// All properties of a block of vertices while it is in the cache.
void copyVertices(TriangleMesh& mesh, const char* from, const PlainLayout& layout, std::size_t count)
{
    reserveHuge(mesh.positions, count);
    reserveHuge(mesh.normals, layout.normal >= 0 ? count : 0);
    reserveHuge(mesh.branch, layout.branch >= 0 ? count : 0);
    reserveHuge(mesh.level, layout.level >= 0 ? count : 0);
    constexpr std::size_t block = 512;
    for (std::size_t begin = 0; begin < count; begin += block) {
        const std::size_t size = std::min(block, count - begin);
        const char* const at = from + begin * layout.stride;
        appendStrided(mesh.positions, at, layout.position, layout.stride, size);
        appendStrided(mesh.normals, at, layout.normal, layout.stride, size);
        appendStrided(mesh.branch, at, layout.branch, layout.stride, size);
        appendStrided(mesh.level, at, layout.level, layout.stride, size);
    }
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
    reserveHuge(to, count);
    bool areTriangles = true;
    Index largest = 0;
    constexpr std::size_t block = 1024;
    for (std::size_t begin = 0; begin < count; begin += block) {
        const std::size_t end = std::min(count, begin + block);
        appendStrided(to, from + begin * stride, 1, stride, end - begin);
        for (std::size_t i = begin; i < end; ++i) {
            areTriangles &= from[i * stride] == 3;
            largest = std::max(largest, std::max(to[i].x, std::max(to[i].y, to[i].z)));
        }
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
    copyVertices(mesh, from, *layout, count);
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
