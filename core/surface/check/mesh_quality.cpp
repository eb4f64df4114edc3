#include "core/surface/check/mesh_quality.h"

#include "core/base/parallel_chunks.h"
#include "core/math/reproducible.h"
#include "core/surface/mesh/near_positions.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace ramure {
namespace {

constexpr std::size_t facesPerChunk = 16'384;

/// Shape of one triangle; the sine of its smallest angle instead of the angle, which takes longer.
struct Shape
{
    double sine = 0.0;   ///< 0 to that of 60 degrees (equilateral)
    double aspect = 0.0; ///< 0: no area
    Index face = 0;
};

/// Worse first: a smaller angle, then the lower face.
bool worse(const Shape& a, const Shape& b)
{
    return a.sine != b.sine ? a.sine < b.sine : a.face < b.face;
}

Shape shapeOf(const TriangleMesh& mesh, Index face)
{
    const glm::uvec3& t = mesh.triangles[face];
    const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    const glm::dvec3 ab = b - a, bc = c - b, ca = a - c;
    std::array<double, 3> side{glm::dot(ab, ab), glm::dot(bc, bc), glm::dot(ca, ca)};
    const double twiceArea = glm::length(glm::cross(ab, ca));
    std::sort(side.begin(), side.end());
    for (double& s : side)
        s = std::sqrt(s);
    if (!(twiceArea > 0.0) || !std::isfinite(side[0] + side[1] + side[2]))
        return {};
    // The smallest angle lies opposite to the shortest side, between the two others.
    const double sine = twiceArea / (side[1] * side[2]);
    const double inradius = twiceArea / (side[0] + side[1] + side[2]);
    return {std::min(sine, 1.0), side[2] / (2.0 * std::numbers::sqrt3 * inradius), face};
}

/// Sines of the upper ends of the angle bins.
std::array<double, MeshQuality::angleBins> sinesOfBins()
{
    std::array<double, MeshQuality::angleBins> ends{};
    for (std::size_t i = 0; i < ends.size(); ++i)
        ends[i] = maths::sin(double(i + 1) * std::numbers::pi / 36.0);
    return ends;
}

struct Part
{
    std::array<Index, MeshQuality::angleBins> angles{};
    std::array<Index, MeshQuality::aspectBins.size()> aspects{};
    Index withoutArea = 0;
    Shape flattest;           ///< the largest aspect
    std::vector<Shape> worst; ///< sorted and cut when it has doubled
};

void cut(std::vector<Shape>& worst)
{
    const std::size_t kept = std::min(worst.size(), MeshQuality::worstListed);
    std::partial_sort(worst.begin(), worst.begin() + static_cast<std::ptrdiff_t>(kept), worst.end(), worse);
    worst.resize(kept);
}

void addTo(Part& part, const Shape& shape)
{
    static const auto sines = sinesOfBins();
    if (shape.aspect == 0.0) {
        ++part.withoutArea;
        return;
    }
    const auto angle =
        std::find_if(sines.begin(), sines.end() - 1, [&](double end) { return shape.sine < end; });
    ++part.angles[static_cast<std::size_t>(angle - sines.begin())];
    const auto& ends = MeshQuality::aspectBins;
    const auto aspect =
        std::find_if(ends.begin() + 1, ends.end(), [&](double e) { return shape.aspect < e; });
    ++part.aspects[static_cast<std::size_t>(aspect - ends.begin()) - 1];
    if (shape.aspect > part.flattest.aspect)
        part.flattest = shape;
    const bool full = part.worst.size() >= MeshQuality::worstListed;
    if (full && !worse(shape, part.worst[MeshQuality::worstListed - 1]))
        return;
    part.worst.push_back(shape);
    if (part.worst.size() == MeshQuality::worstListed || part.worst.size() >= 2 * MeshQuality::worstListed)
        cut(part.worst);
}

MeshQuality gather(const std::vector<Part>& parts)
{
    MeshQuality all;
    Shape flattest;
    std::vector<Shape> worst;
    for (const Part& part : parts) {
        for (std::size_t i = 0; i < all.angles.size(); ++i)
            all.angles[i] += part.angles[i];
        for (std::size_t i = 0; i < all.aspects.size(); ++i)
            all.aspects[i] += part.aspects[i];
        all.withoutArea += part.withoutArea;
        if (part.flattest.aspect > flattest.aspect)
            flattest = part.flattest;
        worst.insert(worst.end(), part.worst.begin(), part.worst.end());
    }
    cut(worst);
    for (const Shape& shape : worst)
        all.worst.push_back({shape.face, maths::asin(shape.sine), shape.aspect});
    if (!all.worst.empty()) {
        all.smallestAngleRad = all.worst.front().smallestAngleRad;
        all.smallestAngleFace = all.worst.front().face;
        all.largestAspect = flattest.aspect;
        all.largestAspectFace = flattest.face;
    }
    return all;
}

} // namespace

Expected<MeshQuality> measureQuality(const TriangleMesh& mesh, unsigned threads, const Progress& progress)
{
    const Index vertices = mesh.vertexCount();
    for (const glm::uvec3& t : mesh.triangles)
        if (std::max({t.x, t.y, t.z}) >= vertices)
            return fail(ErrorCode::Invalid,
                        RAMURE_NOOP("the mesh refers to something that it does not have"));
    const std::size_t faces = mesh.triangles.size();
    std::vector<Part> parts((faces + facesPerChunk - 1) / facesPerChunk);
    const bool all = forChunks(parts.size(), threads, progress, [&](std::size_t chunk) {
        const std::size_t end = std::min(faces, (chunk + 1) * facesPerChunk);
        for (std::size_t f = chunk * facesPerChunk; f < end; ++f)
            addTo(parts[chunk], shapeOf(mesh, static_cast<Index>(f)));
        cut(parts[chunk].worst);
    });
    if (!all)
        return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
    MeshQuality quality = gather(parts);
    const auto near =
        findNearPositions(mesh.positions, MeshQuality::nearDistance, MeshQuality::mostNearPairs);
    quality.nearPairs = static_cast<Index>(near.size());
    return quality;
}

} // namespace ramure
