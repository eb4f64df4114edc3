#include "core/surface/check/texture_report.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace ramure {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// A triangle laid flat: its first edge along x.
struct FlatTriangle
{
    double x1 = 0.0, x2 = 0.0, y2 = 0.0;

    explicit FlatTriangle(const std::array<glm::vec3, 3>& place)
    {
        const glm::dvec3 a(place[0]), first = glm::dvec3(place[1]) - a, second = glm::dvec3(place[2]) - a;
        x1 = glm::length(first);
        if (!(x1 > 0.0))
            return;
        x2 = glm::dot(second, first) / x1;
        y2 = glm::length(glm::cross(first, second)) / x1;
    }
    [[nodiscard]] double doubledArea() const { return x1 * y2; }
};

double doubledArea(const std::array<glm::vec2, 3>& uv)
{
    const glm::dvec2 a(uv[0]), first = glm::dvec2(uv[1]) - a, second = glm::dvec2(uv[2]) - a;
    return first.x * second.y - first.y * second.x;
}

struct LevelSum
{
    Index triangles = 0;
    double inSpace = 0.0, inTexture = 0.0;
};

/// The level of the branch whose tube it is.
Index levelOf(const BranchMesh& mesh, const TubeRange& tube, Index end)
{
    for (Index t = end; t-- > tube.firstTriangle;)
        for (int corner = 0; corner < 3; ++corner)
            if (const Index vertex = mesh.mesh.triangles[t][corner]; mesh.mesh.branch[vertex] == tube.branch)
                return mesh.mesh.level[vertex];
    return 0;
}

void summarise(const std::map<Index, LevelSum>& sums, TextureReport& report)
{
    for (const auto& [level, sum] : sums)
        report.levels.push_back(
            {level, sum.triangles, sum.inSpace > 0.0 ? std::sqrt(sum.inTexture / sum.inSpace) : 0.0});
    if (report.levels.empty() || !(report.levels.front().tilesPerMetre > 0.0))
        return;
    const double trunk = report.levels.front().tilesPerMetre;
    for (const TextureLevel& level : report.levels)
        report.unevenness = std::max(report.unevenness, std::abs(level.tilesPerMetre / trunk - 1.0));
}

} // namespace

double textureStretch(const std::array<glm::vec3, 3>& place, const std::array<glm::vec2, 3>& uv)
{
    const FlatTriangle flat(place);
    const double area = flat.doubledArea(), inTexture = doubledArea(uv);
    if (!(area > 0.0) || inTexture == 0.0)
        return infinite;
    const glm::dvec2 first = glm::dvec2(uv[1]) - glm::dvec2(uv[0]),
                     second = glm::dvec2(uv[2]) - glm::dvec2(uv[0]);
    const glm::dvec2 alongX = first / flat.x1, alongY = (second - alongX * flat.x2) / flat.y2;
    // s1² + s2² and s1 s2 give the ratio of the two without a root of a difference.
    const double squares = glm::dot(alongX, alongX) + glm::dot(alongY, alongY);
    const double product = std::abs(inTexture) / area;
    const double half = 0.5 * squares / product;
    const double ratio = half + std::sqrt(std::max(half * half - 1.0, 0.0));
    return inTexture > 0.0 ? ratio : -ratio;
}

TextureReport textureReport(const BranchMesh& mesh, const TextureCoordinates& coordinates)
{
    TextureReport report;
    std::map<Index, LevelSum> sums;
    std::vector<float> stretches;
    stretches.reserve(mesh.mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.tubes.size(); ++i) {
        const Index first = mesh.tubes[i].firstTriangle;
        const Index end = i + 1 < mesh.tubes.size() ? mesh.tubes[i + 1].firstTriangle : mesh.mesh.faceCount();
        LevelSum& sum = sums[levelOf(mesh, mesh.tubes[i], end)];
        for (Index t = first; t < end; ++t) {
            std::array<glm::vec3, 3> place;
            std::array<glm::vec2, 3> uv;
            for (int corner = 0; corner < 3; ++corner) {
                place[std::size_t(corner)] = mesh.mesh.positions[mesh.mesh.triangles[t][corner]];
                uv[std::size_t(corner)] = coordinates.uv[coordinates.corners[t][corner]];
            }
            const double inTexture = doubledArea(uv);
            report.mirrored += inTexture <= 0.0 ? 1 : 0;
            stretches.push_back(static_cast<float>(std::abs(textureStretch(place, uv))));
            ++sum.triangles;
            sum.inSpace += FlatTriangle(place).doubledArea();
            sum.inTexture += std::abs(inTexture);
        }
    }
    report.triangles = static_cast<Index>(stretches.size());
    summarise(sums, report);
    if (stretches.empty())
        return report;
    report.stretched =
        static_cast<Index>(std::count_if(stretches.begin(), stretches.end(), [](float stretch) {
            return !(double(stretch) < TextureReport::goodStretch);
        }));
    const auto at = stretches.begin() + static_cast<std::ptrdiff_t>(stretches.size() * 95 / 100);
    std::nth_element(stretches.begin(), at, stretches.end());
    report.stretch95 = double(*at);
    report.worstStretch = double(*std::max_element(at, stretches.end()));
    return report;
}

} // namespace ramure
