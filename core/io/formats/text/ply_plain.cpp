#include "core/base/wide_clone.h"
#include "core/io/formats/text/ply_source.h"
#include "core/io/mesh_mending.h"
#include "core/surface/mesh/largest_index.h"
#include <iterator>
#include <utility>

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
    std::ptrdiff_t colour = -1; ///< red, green and blue as bytes in a row
};

std::optional<PlainLayout> layoutOf(const PlyElement& vertex)
{
    PlainLayout out;
    const auto& properties = vertex.properties;
    const auto isTriple = [&](std::size_t p, const char* x, const char* y, const char* z,
                              PlyType type = PlyType::Float32) {
        const char* const names[] = {x, y, z};
        for (std::size_t k = 0; k < 3; ++k)
            if (p + k >= properties.size() || properties[p + k].name != names[k] ||
                properties[p + k].type != type)
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
        if (isTriple(p, "red", "green", "blue", PlyType::UInt8))
            out.colour = offset;
        for (const auto& [name, slot] : {std::pair{"branch", &out.branch}, std::pair{"level", &out.level}})
            if (properties[p].name == name) {
                if (sizeOf(properties[p].type) != sizeof(Index) || !isInteger(properties[p].type))
                    return std::nullopt;
                *slot = offset;
            }
        out.stride += sizeOf(properties[p].type);
    }
    const bool hasOtherNormals = out.normal < 0 && vertex.find("nx") >= 0;
    const bool hasOtherColours =
        out.colour < 0 && (vertex.find("red") >= 0 || vertex.find("diffuse_red") >= 0);
    if (out.position < 0 || hasOtherNormals || hasOtherColours)
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

/// All finite: numbers that are not have all ones in the exponent.
RAMURE_WIDE_CLONE bool areFinite(const float* numbers, std::size_t count)
{
    std::uint32_t anyBad = 0;
    for (std::size_t i = 0; i < count; ++i)
        anyBad |= (std::bit_cast<std::uint32_t>(numbers[i]) & 0x7F800000u) == 0x7F800000u ? 1u : 0u;
    return anyBad == 0;
}

/// Records of \p count vertices, while they are in the cache. False where a position is not finite or a
/// normal has no direction.
bool appendVertices(TriangleMesh& mesh, std::vector<glm::u8vec3>& colours, Bounds& bounds, const char* from,
                    const PlainLayout& layout, std::size_t count)
{
    const std::size_t before = mesh.positions.size();
    appendStrided(mesh.positions, from, layout.position, layout.stride, count);
    appendStrided(mesh.normals, from, layout.normal, layout.stride, count);
    appendStrided(mesh.branch, from, layout.branch, layout.stride, count);
    appendStrided(mesh.level, from, layout.level, layout.stride, count);
    appendStrided(colours, from, layout.colour, layout.stride, count);
    bounds.take(std::span(mesh.positions).subspan(before));
    return areFinite(&mesh.positions[before].x, 3 * count) &&
           (layout.normal < 0 || areNormals(std::span(mesh.normals).subspan(before)));
}

constexpr std::size_t faceBytes = 1 + sizeof(glm::uvec3);

/// False where a face is no triangle or an index is out of range.
bool appendFaces(std::vector<glm::uvec3>& to, const char* from, std::size_t count, Index vertices)
{
    appendStrided(to, from, 1, faceBytes, count);
    unsigned anyOther = 0;
    for (std::size_t i = 0; i < count; ++i)
        anyOther |= static_cast<unsigned char>(from[i * faceBytes]) ^ 3u;
    return anyOther == 0 && largestIndex(std::span(to).last(count)) < vertices;
}

/// Bytes that are in memory.
class MemoryBytes
{
public:
    explicit MemoryBytes(std::string_view bytes)
        : m_at(bytes.data())
    {
    }
    const char* take(std::size_t bytes) { return std::exchange(m_at, m_at + bytes); }

private:
    const char* m_at;
};

/// Records from one after the other are copied at most this many bytes at a time, so that they stay in the
/// cache.
constexpr std::size_t blockBytes = std::size_t(1) << 17;

/// Bytes that are still in a file, through a buffer that stays in the cache.
class FileBytes
{
public:
    FileBytes(InputFile& file, std::string_view begun)
        : m_file(file)
        , m_begun(begun)
        , m_buffer(blockBytes)
    {
    }
    /// Null where there are not so many.
    const char* take(std::size_t bytes)
    {
        const std::size_t first = m_begun.copy(m_buffer.data(), bytes);
        m_begun.remove_prefix(first);
        const auto got = m_file.read(m_buffer.data() + first, bytes - first);
        return got && *got == bytes - first ? m_buffer.data() : nullptr;
    }

private:
    InputFile& m_file;
    std::string_view m_begun;
    LargeBuffer<char> m_buffer;
};

/// Calls \p use(bytes, records) for all records; false where that or the source says so, or cancelled.
template <class Source, class Use>
bool forBlocks(Source& source, std::uint64_t count, std::size_t stride, const Progress& progress, Use&& use)
{
    const std::uint64_t most = blockBytes / stride;
    for (std::uint64_t begin = 0; begin < count; begin += most) {
        const auto records = static_cast<std::size_t>(std::min(most, count - begin));
        const char* const bytes = source.take(records * stride);
        if (!bytes || progress.cancelled() || !use(bytes, records))
            return false;
        progress.report(double(begin) / double(count));
    }
    return true;
}

template <class Source>
std::optional<ReadMesh> readPlain(Source source, const PlainLayout& layout, const PlyHeader& header,
                                  const Progress& progress)
{
    const std::uint64_t vertices = header.elements[0].count;
    const std::uint64_t faces = header.elements[1].count;
    const auto count = static_cast<std::size_t>(vertices);
    TriangleMesh mesh;
    reserveHuge(mesh.positions, count);
    reserveHuge(mesh.normals, layout.normal >= 0 ? count : 0);
    reserveHuge(mesh.branch, layout.branch >= 0 ? count : 0);
    reserveHuge(mesh.level, layout.level >= 0 ? count : 0);
    std::vector<glm::u8vec3> colours;
    reserveHuge(colours, layout.colour >= 0 ? count : 0);
    Bounds bounds;
    const bool hasVertices =
        forBlocks(source, vertices, layout.stride, progress.part(0.0, 0.5),
                  [&](const char* bytes, std::size_t records) {
                      return appendVertices(mesh, colours, bounds, bytes, layout, records);
                  });
    if (!hasVertices || bounds.origin() != glm::dvec3(0.0))
        return std::nullopt; // the general reader says why, or mends it
    reserveHuge(mesh.triangles, static_cast<std::size_t>(faces));
    const bool hasFaces = forBlocks(
        source, faces, faceBytes, progress.part(0.5, 1.0), [&](const char* bytes, std::size_t records) {
            return appendFaces(mesh.triangles, bytes, records, static_cast<Index>(vertices));
        });
    if (!hasFaces)
        return std::nullopt;
    mesh.colours = triangleColours(mesh.triangles, colours);
    ReadMesh out;
    out.objects.push_back({{}, std::move(mesh), {}});
    return out;
}

/// Nothing where the file is not as simple as that. \p bodyBytes: behind the header.
std::optional<PlainLayout> plainLayout(const PlyHeader& header, std::uint64_t bodyBytes)
{
    if constexpr (std::endian::native != std::endian::little)
        return std::nullopt;
    if (header.format != PlyFormat::LittleEndian || header.elements.size() != 2 ||
        header.elements[0].name != "vertex" || !isPlainFace(header.elements[1]))
        return std::nullopt;
    const auto layout = layoutOf(header.elements[0]);
    const std::uint64_t vertices = header.elements[0].count;
    const std::uint64_t faces = header.elements[1].count;
    if (!layout || vertices == 0 || vertices >= noIndex || faces >= noIndex || layout->stride > blockBytes)
        return std::nullopt;
    // The header has checked that the vertices fit.
    if (bodyBytes - vertices * layout->stride != faces * faceBytes)
        return std::nullopt;
    return layout;
}

} // namespace

std::optional<ReadMesh> readPlainPly(std::string_view bytes, const PlyHeader& header,
                                     const Progress& progress)
{
    const auto layout = plainLayout(header, bytes.size() - header.bytes);
    if (!layout)
        return std::nullopt;
    return readPlain(MemoryBytes(bytes.substr(header.bytes)), *layout, header, progress);
}

std::optional<ReadMesh> readPlainPly(InputFile& file, std::string_view begun, const PlyHeader& header,
                                     const Progress& progress)
{
    const auto layout = plainLayout(header, file.size() - header.bytes);
    if (!layout)
        return std::nullopt;
    return readPlain(FileBytes(file, begun), *layout, header, progress);
}

} // namespace ramure::reading
