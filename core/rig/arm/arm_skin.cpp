#include "core/rig/arm/arm_skin.h"

#include "core/math/angle.h"
#include "core/math/reproducible.h"
#include "core/params/param_def.h"
#include "core/rig/arm/arm_chain.h"
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

/// Where segments begin along the straight arm, and where the last one ends.
std::vector<double> heightsOf(std::span<const ArmJoint> joints)
{
    std::vector<double> heights{0.0};
    for (const ArmJoint& joint : joints)
        heights.push_back(heights.back() + joint.length);
    return heights;
}

Index segmentAt(const std::vector<double>& heights, double z)
{
    const auto after = std::upper_bound(heights.begin() + 1, heights.end() - 1, z);
    return static_cast<Index>(after - heights.begin() - 1);
}

/// Rings of vertices, then the triangles between them.
class Roll
{
public:
    Roll(const ArmSkinParams& params, const std::vector<double>& heights)
        : m_params(params)
        , m_heights(heights)
    {
    }
    TriangleMesh made()
    {
        const auto rows = static_cast<Index>(m_params.lengthDivisions);
        const double cell = m_heights.back() / double(rows);
        for (Index row = 0; row <= rows; ++row)
            ring(row == rows ? m_heights.back() : cell * row, glm::dvec3(0.0));
        for (Index row = 0; row < rows; ++row)
            band(row * round(), (row + 1) * round());
        end(0.0, -1.0F);
        end(m_heights.back(), 1.0F);
        return std::move(m_mesh);
    }

private:
    [[nodiscard]] Index round() const { return static_cast<Index>(m_params.radialDivisions); }
    void vertex(const glm::dvec3& at, const glm::dvec3& normal, const glm::dvec2& uv)
    {
        m_mesh.positions.emplace_back(at);
        m_mesh.normals.emplace_back(normal);
        m_mesh.uv.emplace_back(uv);
        m_mesh.branch.push_back(segmentAt(m_heights, at.z));
    }
    /// \param flat normal of an end; zero: they stand away from the axis
    void ring(double z, const glm::dvec3& flat)
    {
        for (Index i = 0; i < round(); ++i) {
            const auto [sine, cosine] = maths::sincos(2.0 * pi * double(i) / double(round()));
            const glm::dvec3 away(cosine, sine, 0.0);
            const bool isEnd = flat.z != 0.0;
            vertex(m_params.radius * away + glm::dvec3(0.0, 0.0, z), isEnd ? flat : away,
                   {double(i) / double(round()), z / (2.0 * pi * m_params.radius)});
        }
    }
    void band(Index below, Index above)
    {
        for (Index i = 0; i < round(); ++i) {
            const Index next = (i + 1) % round();
            m_mesh.triangles.emplace_back(below + i, below + next, above + next);
            m_mesh.triangles.emplace_back(below + i, above + next, above + i);
        }
    }
    void end(double z, float side)
    {
        const Index first = m_mesh.vertexCount();
        ring(z, {0.0, 0.0, side});
        vertex({0.0, 0.0, z}, {0.0, 0.0, side}, {0.5, z / (2.0 * pi * m_params.radius)});
        for (Index i = 0; i < round(); ++i) {
            const Index a = first + i, b = first + (i + 1) % round(), centre = first + round();
            m_mesh.triangles.emplace_back(side > 0.0F ? glm::uvec3(a, b, centre) : glm::uvec3(b, a, centre));
        }
    }

    const ArmSkinParams& m_params;
    const std::vector<double>& m_heights;
    TriangleMesh m_mesh;
};

/// What the vertices of one height follow.
SkinRun runAt(std::span<const ArmJoint> joints, const std::vector<double>& heights, double z, double window)
{
    const Index own = segmentAt(heights, z);
    SkinRun run{0, {{own, own, own}, {1.0F, 0.0F, 0.0F}}};
    const bool nearStart = z - heights[own] < heights[own + 1] - z;
    const Index upper = nearStart ? own : own + 1; // the segment above the nearer joint
    if (upper == 0 || upper >= joints.size())
        return run;
    const double half = std::min({window, 0.5 * joints[upper - 1].length, 0.5 * joints[upper].length});
    const double away = z - heights[upper];
    if (std::abs(away) >= half)
        return run;
    const auto above = static_cast<float>((away + half) / (2.0 * half));
    const auto slope = static_cast<float>(0.5 / half);
    const Index lower = upper - 1;
    // The bone that weighs more comes first.
    if (above < 0.5F)
        return {0, {{lower, upper, lower}, {1.0F - above, above, 0.0F}}, slope};
    return {0, {{upper, lower, upper}, {above, 1.0F - above, 0.0F}}, -slope};
}

} // namespace

Expected<TriangleMesh> armCylinder(std::span<const ArmJoint> joints, const ArmSkinParams& params)
{
    RAMURE_TRY(checkArm(joints));
    RAMURE_TRY(checkPart(&NodeParams::armSkin, params));
    const std::vector<double> heights = heightsOf(joints);
    return Roll(params, heights).made();
}

Skin bindArm(const TriangleMesh& mesh, std::span<const ArmJoint> joints, bool smooth, double window)
{
    const std::vector<double> heights = heightsOf(joints);
    Skin skin;
    skin.vertices = mesh.vertexCount();
    skin.bones = static_cast<Index>(joints.size());
    for (Index v = 0; v < skin.vertices; ++v) {
        SkinRun run = runAt(joints, heights, double(mesh.positions[v].z), smooth ? window : 0.0);
        run.firstVertex = v;
        const SkinRun* last = skin.runs.empty() ? nullptr : &skin.runs.back();
        if (!last || last->influence != run.influence || last->slope != run.slope)
            skin.runs.push_back(run);
    }
    return skin;
}

} // namespace ramure
