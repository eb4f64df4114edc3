#include "core/io/mesh_mending.h"

#include "core/base/wide_clone.h"
#include "core/surface/mesh/normals.h"
#include "core/surface/mesh/polygon_cut.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

namespace ramure::reading {
namespace {

/// Times the mesh's size: single precision still tells 100,000 places along it apart.
constexpr double farSizes = 100.0;
/// Where it tells no more than 128 apart in a unit, a mesh is moved from less of its sizes already.
constexpr double farUnits = 100'000.0, farUnitSizes = 4.0;

/// \p count blocks of twelve numbers.
RAMURE_WIDE_CLONE void widen(float* low, float* high, const float* numbers, std::size_t count)
{
    for (std::size_t block = 0; block < count; ++block, numbers += 12)
        for (std::size_t k = 0; k < 12; ++k) {
            low[k] = numbers[k] < low[k] ? numbers[k] : low[k];
            high[k] = numbers[k] > high[k] ? numbers[k] : high[k];
        }
}

/// By the bits: all ones in the exponent are no number, all zeros but for the sign are zero.
RAMURE_WIDE_CLONE bool haveDirections(const float* numbers, std::size_t count)
{
    unsigned anyBad = 0;
    for (std::size_t i = 0; i < count; ++i, numbers += 3) {
        const std::uint32_t x = std::bit_cast<std::uint32_t>(numbers[0]) << 1U,
                            y = std::bit_cast<std::uint32_t>(numbers[1]) << 1U,
                            z = std::bit_cast<std::uint32_t>(numbers[2]) << 1U;
        constexpr std::uint32_t infinite = 0xFF000000U;
        anyBad |= unsigned((x | y | z) == 0) | unsigned(x >= infinite) | unsigned(y >= infinite) |
                  unsigned(z >= infinite);
    }
    return anyBad == 0;
}

} // namespace

void Bounds::take(std::span<const glm::vec3> positions)
{
    if (positions.empty())
        return;
    const std::size_t blocks = positions.size() / 4;
    widen(m_low.data(), m_high.data(), &positions[0].x, blocks);
    for (const glm::vec3& p : positions.subspan(4 * blocks)) {
        const float block[lanes] = {p.x, p.y, p.z, p.x, p.y, p.z, p.x, p.y, p.z, p.x, p.y, p.z};
        widen(m_low.data(), m_high.data(), block, 1);
    }
}

glm::dvec3 Bounds::origin() const
{
    glm::vec3 low(none), high(-none);
    for (std::size_t k = 0; k < lanes; ++k) {
        const auto axis = static_cast<glm::length_t>(k % 3);
        low[axis] = std::min(low[axis], m_low[k]);
        high[axis] = std::max(high[axis], m_high[k]);
    }
    return farOrigin(low, high);
}

glm::dvec3 farOrigin(const glm::dvec3& low, const glm::dvec3& high)
{
    double most = 0.0, size = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        most = std::max({most, std::abs(low[axis]), std::abs(high[axis])});
        size = std::max(size, high[axis] - low[axis]);
    }
    const bool isFar = most > farSizes * size || (most > farUnits && most > farUnitSizes * size);
    if (!isFar || !(most < double(std::numeric_limits<float>::max())))
        return glm::dvec3(0.0);
    // What single precision made one place has a size too.
    size = std::max(size, 1e-6 * most);
    double step = 1.0;
    while (step < size)
        step *= 10.0;
    while (step > 10.0 * size)
        step /= 10.0;
    return glm::round(0.5 * (low + high) / step) * step;
}

glm::dvec3 farOrigin(std::span<const glm::vec3> positions)
{
    Bounds bounds;
    bounds.take(positions);
    return bounds.origin();
}

glm::dvec3 farOrigin(std::span<const glm::dvec3> positions)
{
    glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
    for (const glm::dvec3& p : positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    return farOrigin(low, high);
}

std::vector<glm::vec3> movedFrom(const glm::dvec3& origin, std::span<const glm::dvec3> positions)
{
    std::vector<glm::vec3> out;
    out.reserve(positions.size());
    for (const glm::dvec3& p : positions)
        out.emplace_back(p - origin);
    return out;
}

std::string farNote(const glm::dvec3& origin)
{
    std::string place;
    for (int axis = 0; axis < 3; ++axis) {
        char text[400]; // of any double, without an exponent
        const auto end =
            std::to_chars(text, text + sizeof text, origin[axis] + 0.0, std::chars_format::fixed);
        place.append(axis == 0 ? "" : " ").append(text, static_cast<std::size_t>(end.ptr - text));
    }
    return "the coordinates are far from the origin, where single precision would lose the shape: " + place +
           " was subtracted from them";
}

void PolygonList::take(std::span<const glm::uvec3> triangles, std::size_t corners,
                       std::span<const glm::vec3> positions)
{
    const Polygon polygon{triangles.size() - (corners - 2), corners};
    if (!gather(triangles, polygon, positions) || !isFan(m_corners))
        m_polygons.push_back(polygon);
}

/// False where a vertex is not known.
bool PolygonList::gather(std::span<const glm::uvec3> triangles, const Polygon& polygon,
                         std::span<const glm::vec3> positions)
{
    const glm::uvec3& first = triangles[polygon.firstTriangle];
    m_corners.clear();
    const auto add = [&](Index vertex) {
        if (vertex < positions.size())
            m_corners.push_back(positions[vertex]);
    };
    add(first.x);
    add(first.y);
    for (std::size_t i = 0; i + 2 < polygon.corners; ++i)
        add(triangles[polygon.firstTriangle + i].z);
    return m_corners.size() == polygon.corners;
}

void PolygonList::cut(std::span<const glm::vec3> positions, std::span<glm::uvec3> triangles,
                      std::span<glm::uvec3> texture, std::vector<std::string>& notes)
{
    std::size_t crossing = 0;
    std::vector<glm::uvec3> cuts;
    std::vector<Index> numbers;
    const auto recut = [&](std::span<glm::uvec3> fan) {
        numbers.assign({fan[0].x, fan[0].y});
        for (const glm::uvec3& triangle : fan)
            numbers.push_back(triangle.z);
        for (std::size_t i = 0; i < fan.size(); ++i)
            fan[i] = {numbers[cuts[i].x], numbers[cuts[i].y], numbers[cuts[i].z]};
    };
    for (const Polygon& polygon : m_polygons) {
        if (!gather(triangles, polygon, positions) || isFan(m_corners))
            continue;
        cuts.clear();
        crossing += cutPolygon(m_corners, cuts) ? 0 : 1;
        recut(triangles.subspan(polygon.firstTriangle, cuts.size()));
        if (polygon.firstTriangle + cuts.size() <= texture.size())
            recut(texture.subspan(polygon.firstTriangle, cuts.size()));
    }
    if (crossing > 0)
        notes.push_back(std::to_string(crossing) +
                        " polygons cross themselves: some of their triangles lie on others");
}

std::vector<glm::u8vec3> triangleColours(std::span<const glm::uvec3> triangles,
                                         std::span<const glm::u8vec3> ofVertices)
{
    if (ofVertices.empty() || triangles.empty())
        return {};
    const auto isFirst = [&](const glm::u8vec3& colour) { return colour == ofVertices.front(); };
    if (std::ranges::all_of(ofVertices, isFirst))
        return std::vector<glm::u8vec3>(triangles.size(), ofVertices.front());
    std::vector<Index> lastOf(ofVertices.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (int k = 0; k < 3; ++k)
            lastOf[triangles[t][k]] = static_cast<Index>(t);
    std::vector<glm::u8vec3> out(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        glm::uvec3 own(0), all(0);
        unsigned count = 0;
        for (int k = 0; k < 3; ++k) {
            const Index vertex = triangles[t][k];
            all += glm::uvec3(ofVertices[vertex]);
            if (lastOf[vertex] == t) {
                own += glm::uvec3(ofVertices[vertex]);
                ++count;
            }
        }
        out[t] = glm::u8vec3(count > 0 ? (own + count / 2) / count : (all + 1U) / 3U);
    }
    return out;
}

std::vector<glm::u8vec3> colourBytes(std::span<const glm::vec3> colours, std::vector<std::string>& notes)
{
    const bool areBytes = std::ranges::any_of(colours, [](const glm::vec3& c) {
        return std::max({c.r, c.g, c.b}) > 1.0F;
    });
    if (areBytes)
        notes.push_back("colours above 1: taken as numbers from 0 to 255");
    std::vector<glm::u8vec3> out;
    out.reserve(colours.size());
    for (const glm::vec3& c : colours) {
        glm::u8vec3& bytes = out.emplace_back();
        for (int k = 0; k < 3; ++k) {
            const float share = areBytes ? c[k] / 255.0F : c[k];
            bytes[k] = static_cast<std::uint8_t>(share > 0.0F ? std::min(share, 1.0F) * 255.0F + 0.5F : 0.0F);
        }
    }
    return out;
}

bool areNormals(std::span<const glm::vec3> normals)
{
    return normals.empty() || haveDirections(&normals[0].x, normals.size());
}

void mendNormals(TriangleMesh& mesh, std::vector<std::string>& notes)
{
    if (mesh.normals.size() != mesh.positions.size() || areNormals(mesh.normals))
        return;
    TriangleMesh bare;
    bare.positions = mesh.positions;
    bare.triangles = mesh.triangles;
    computeNormals(bare);
    std::vector<bool> isUsed(mesh.positions.size(), false);
    for (const glm::uvec3& t : mesh.triangles)
        isUsed[t.x] = isUsed[t.y] = isUsed[t.z] = true;
    std::size_t mended = 0;
    for (std::size_t v = 0; v < mesh.normals.size(); ++v)
        if (!areNormals({&mesh.normals[v], 1})) {
            mesh.normals[v] = bare.normals[v];
            mended += isUsed[v] ? 1 : 0;
        }
    if (mended > 0)
        notes.push_back(std::to_string(mended) +
                        " vertices have a normal of length 0 or of no numbers: that of their faces is taken");
}

Expected<void> checkFaces(std::size_t points, std::size_t triangles, const std::string& file)
{
    if (triangles > 0)
        return {};
    auto error = fail(ErrorCode::Invalid,
                      RAMURE_NOOP("the file holds %1 points and no faces: there is no surface to read"),
                      {std::to_string(points)});
    error.value().file = file;
    return error;
}

void notePadding(std::size_t bytes, std::vector<std::string>& notes)
{
    if (bytes > 0)
        notes.push_back(std::to_string(bytes) + " bytes of padding behind the text are left out");
}

} // namespace ramure::reading
