// Signs that are measured on the mesh and by weight.
#include "core/math/angle.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/signs/sign_rows.h"
#include "core/skeleton/axes.h"
#include "core/surface/check/wood_sections.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ramure::signs {
namespace {

constexpr double thickLimb = 0.01;   ///< m
constexpr std::size_t fewLimbs = 10; ///< of which the middle one says nothing

double middleOf(std::vector<double> values)
{
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

void addSwelling(Rows& rows, TreeSign sign, const std::vector<double>& ratios)
{
    sign.note = std::to_string(ratios.size()) + " of them; the middle one";
    if (ratios.size() < fewLimbs)
        rows.push_back(absent(std::move(sign), "fewer than ten"));
    else
        rows.push_back(measured(std::move(sign), middleOf(ratios)));
}

/// m², of the trunk's cross-section so far over the ground, seen from above.
double areaOver(const TriangleMesh& mesh, const GroundPlane& ground, double height)
{
    double area = 0.0;
    for (const glm::uvec3& triangle : mesh.triangles) {
        if (mesh.level[triangle.x] + mesh.level[triangle.y] + mesh.level[triangle.z] > 0)
            continue;
        glm::dvec2 from(0.0), to(0.0);
        for (int c = 0; c < 3; ++c) {
            const glm::dvec3 a(mesh.positions[triangle[c]]), b(mesh.positions[triangle[(c + 1) % 3]]);
            const double below = ground.above(a) - height, above = ground.above(b) - height;
            if ((below < 0.0) == (above < 0.0))
                continue;
            const glm::dvec3 at = a + below / (below - above) * (b - a);
            (below < 0.0 ? from : to) = {at.x, at.z};
        }
        area += 0.5 * (from.x * to.y - from.y * to.x);
    }
    return std::abs(area);
}

/// How often the middle ring of a foot goes out and in again.
Index lobesOf(const BranchMesh& mesh, std::size_t tube)
{
    const FootSize& foot = mesh.axes[tube].foot;
    Index pole = noIndex;
    const std::size_t end =
        tube + 1 < mesh.tubes.size() ? mesh.tubes[tube + 1].firstTriangle : mesh.mesh.triangles.size();
    for (std::size_t t = mesh.tubes[tube].firstTriangle; t < end; ++t)
        for (int c = 0; c < 3; ++c)
            pole = std::min(pole, mesh.mesh.triangles[t][c]);
    const Index first = pole + 1 + foot.rings / 2 * foot.points;
    if (pole == noIndex || first + foot.points > mesh.mesh.vertexCount())
        return 0;
    glm::dvec2 middle(0.0);
    std::vector<glm::dvec2> ring;
    for (Index i = 0; i < foot.points; ++i) {
        const glm::vec3& at = mesh.mesh.positions[first + i];
        ring.emplace_back(at.x, at.z);
        middle += ring.back() / double(foot.points);
    }
    double mean = 0.0;
    for (const glm::dvec2& at : ring)
        mean += glm::length(at - middle) / double(foot.points);
    // It is out or in where it is so by more than little.
    constexpr double little = 0.02;
    Index lobes = 0;
    int was = 0, began = 0;
    for (const glm::dvec2& at : ring) {
        const double share = glm::length(at - middle) / mean - 1.0;
        const int now = share > little ? 1 : share < -little ? -1 : was;
        lobes += was == -1 && now == 1 ? 1 : 0;
        began = began == 0 ? now : began;
        was = now;
    }
    return lobes + (was == -1 && began == 1 ? 1 : 0);
}

void addFoot(Rows& rows, const BranchMesh& mesh, const NodeParams& params)
{
    TreeSign flare{"rootFlare", "root flare", "",  {},
                   0.0,         1.3,          2.0, "mean radius at the ground over that at breast height"};
    TreeSign lobes{"rootLobes", "lobes of the foot",
                   "",          {},
                   0.0,         4.0,
                   8.0,         "times that a ring half up the foot goes out and in"};
    const auto trunk =
        std::ranges::find_if(mesh.axes, [](const TubeAxis& axis) { return axis.foot.rings > 0; });
    if (trunk == mesh.axes.end()) {
        rows.push_back(absent(std::move(flare), "no trunk stands on roots"));
        rows.push_back(absent(std::move(lobes), "no trunk stands on roots"));
        return;
    }
    const GroundPlane ground = groundOf(params).value_or(GroundPlane());
    const double atGround = areaOver(mesh.mesh, ground, 0.05 * trunk->a0);
    const double above = areaOver(mesh.mesh, ground, 1.3);
    rows.push_back(above > 0.0 && atGround > 0.0 ? measured(std::move(flare), std::sqrt(atGround / above))
                                                 : absent(std::move(flare), "lower than breast height"));
    rows.push_back(measured(std::move(lobes), lobesOf(mesh, std::size_t(trunk - mesh.axes.begin()))));
}

// Sag.

constexpr double gravityOnEarth = 9.81, livingWood = 900.0; ///< m/s², kg/m³
constexpr double leafyRadius = 0.005;                       ///< m; the step hangs leaves on what is thinner
constexpr double softestRadius = 0.0005;                    ///< m; what is thinner bends like this
constexpr double smallShare = 0.01; ///< of the weight: the formula is that of small bends

/// m, how far down small turns by the moment of all that a piece carries, over E I, take an end.
class BeamDrops
{
public:
    BeamDrops(const Skeleton& tree, const SagParams& sag)
        : m_tree(tree)
        , m_turn(tree.size())
    {
        std::vector<double> mass(tree.size(), 0.0);
        std::vector<glm::dvec3> moment(tree.size(), glm::dvec3(0.0)); // kg m, of what is above the start
        for (Index i = tree.size(); i-- > 0;) {
            const double length = tree.length(i), a = tree.a0[i], b = tree.a1[i], mean = 0.5 * (a + b);
            double own = livingWood * pi * (a * a + a * b + b * b) / 3.0 * length;
            own += mean < leafyRadius ? sag.load * length : 0.0;
            const glm::dvec3 centre = 0.5 * (tree.p0[i] + tree.p1[i]);
            // The moment in the middle of a piece: what it carries, and its upper half.
            const glm::dvec3 half = 0.5 * own * 0.5 * (centre + tree.p1[i]);
            const glm::dvec3 arm = moment[i] + half - (mass[i] + 0.5 * own) * centre;
            const double radius = std::max(mean, softestRadius);
            const double stiffness = sag.stiffness * 1e9 * 0.25 * pi * radius * radius * radius * radius;
            m_turn[i] = gravityOnEarth * length / stiffness * glm::cross(arm, glm::dvec3(0.0, -1.0, 0.0));
            if (length > 0.0) { // no twist
                const glm::dvec3 along = (tree.p1[i] - tree.p0[i]) / length;
                m_turn[i] -= glm::dot(m_turn[i], along) * along;
            }
            mass[i] += own;
            moment[i] += own * centre;
            if (const Index parent = tree.parent[i]; parent != noIndex) {
                mass[parent] += mass[i];
                moment[parent] += moment[i];
            }
        }
    }
    [[nodiscard]] double dropOf(Index end) const
    {
        double drop = 0.0;
        for (Index i = end; i != noIndex; i = m_tree.parent[i])
            drop -= glm::cross(m_turn[i], m_tree.p1[end] - 0.5 * (m_tree.p0[i] + m_tree.p1[i])).y;
        return drop;
    }

private:
    const Skeleton& m_tree;
    std::vector<glm::dvec3> m_turn; ///< rad
};

/// The ends of the longest limbs that leave a trunk.
std::vector<Index> limbEnds(const Skeleton& tree)
{
    constexpr std::size_t most = 12;
    const TreeAxes axes = axesOf(tree);
    std::vector<Index> limbs;
    for (Index a = 0; a < axes.axes.size(); ++a)
        if (axes.axes[a].order == 1)
            limbs.push_back(a);
    std::ranges::stable_sort(limbs,
                             [&](Index a, Index b) { return axes.axes[a].length > axes.axes[b].length; });
    limbs.resize(std::min(limbs.size(), most));
    std::vector<Index> ends;
    for (const Index limb : limbs)
        ends.push_back(axes.nodesOf(limb).back());
    return ends;
}

} // namespace

void addWood(Rows& rows, const BranchMesh& mesh, const NodeParams& params)
{
    std::vector<double> collars, twins;
    for (const Swelling& swelling : WoodSections(mesh).swellings(thickLimb))
        if (swelling.share <= 0.5)
            collars.push_back(swelling.ratio);
        else if (swelling.share >= 0.8)
            twins.push_back(swelling.ratio);
    addSwelling(rows, {"branchCollar", "branch collar", "", {}, 0.0, 1.15, 1.5}, collars);
    addSwelling(rows, {"twins", "twins at a fork", "", {}, 0.0, 1.0, 1.1}, twins);
    addFoot(rows, mesh, params);
}

Expected<void> addSag(Rows& rows, const Skeleton& tree, const NodeParams& params, const Progress& progress)
{
    TreeSign sign{"sag", "sag under the weight",
                  "",    {},
                  0.0,   0.9,
                  1.1,   "drop of the longest limbs' tips over that of a beam"};
    const std::vector<Index> ends = limbEnds(tree);
    NodeParams light;
    light.step.sag.amount = smallShare;
    NodeParams sagging = params;
    TreeEdit step;
    step.operation = EditOperation::Sag;
    step.id = 1;
    for (const TreeEdit& other : params.edits)
        step.id = std::max(step.id, other.id + 1);
    step.values = StepValues(light);
    sagging.edits.push_back(std::move(step));
    TreePipeline pipeline;
    const auto made = pipeline.evaluate(sagging, Stage::Skeleton, progress);
    RAMURE_TRY(made);
    const Skeleton& sagged = *made->skeleton;
    const BeamDrops beams(tree, light.step.sag);
    double drops = 0.0, expected = 0.0;
    if (sagged.size() == tree.size())
        for (const Index end : ends) {
            drops += (tree.p1[end].y - sagged.p1[end].y) / smallShare;
            expected += beams.dropOf(end);
        }
    rows.push_back(expected > 0.0 ? measured(std::move(sign), drops / expected)
                                  : absent(std::move(sign), "no limbs that leave a trunk"));
    return {};
}

} // namespace ramure::signs
