#include "widgets/view/arm_ghosts.h"

#include "core/rig/arm/arm_chain.h"
#include <algorithm>
#include <cmath>
#include <utility>

namespace ramure {

bool ArmGhosts::operator==(const ArmGhosts& other) const
{
    return arm.id == other.arm.id && arm.animation == other.arm.animation &&
           arm.params.joints == other.arm.params.joints && arm.params.ik == other.arm.params.ik &&
           arm.params.arm == other.arm.params.arm && now == other.now && geometryNow == other.geometryNow &&
           copies == other.copies;
}

ArmGhostMaker::ArmGhostMaker(QObject* parent)
    : QObject(parent)
    , m_arms(std::make_shared<Evaluator>())
{
}

ArmGhostMaker::~ArmGhostMaker() = default;

bool ArmGhostMaker::isNear(const glm::dmat4& a, const glm::dmat4& b)
{
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            if (std::abs(a[c][r] - b[c][r]) > 1e-6 * std::max(1.0, std::abs(b[c][r])))
                return false;
    return true;
}

void ArmGhostMaker::show(std::vector<ArmGhosts> wanted)
{
    if (wanted == m_wanted)
        return;
    m_wanted = std::move(wanted);
    if (m_wanted.empty()) {
        m_work.forget();
        if (!std::exchange(m_made, {}).empty())
            emit changed();
        return;
    }
    m_work.start(
        [all = m_wanted, arms = m_arms](const Progress& progress) -> Expected<std::vector<Made>> {
            return made(all, *arms, progress);
        },
        [this](Expected<std::vector<Made>>&& done) {
            m_made = done.value_or(std::vector<Made>());
            emit changed();
        });
}

std::vector<ArmGhostMaker::Made> ArmGhostMaker::made(const std::vector<ArmGhosts>& wanted, Evaluator& arms,
                                                     const Progress& progress)
{
    std::vector<Made> all;
    for (const ArmGhosts& ghosts : wanted) {
        const auto now = arms.joints(ghosts.arm, ghosts.now, progress);
        for (const ArmGhosts::Copy& copy : ghosts.copies) {
            const auto joints = arms.joints(ghosts.arm, copy.seconds, progress);
            if (progress.cancelled())
                return {};
            if (!now || !joints || (*joints == *now && isNear(copy.geometry, ghosts.geometryNow)))
                continue; // an arm that cannot be has no ghost either
            const ArmChain chain(*joints);
            auto lines = std::make_shared<LineSet>();
            auto marks = std::make_shared<PointSet>();
            const auto points = chain.points();
            for (std::size_t i = 0; i < points.size(); ++i) {
                marks->points.push_back({glm::vec3(points[i]), 7.0f, copy.colour, noIndex});
                marks->box.add(points[i]);
                if (i > 0)
                    lines->segments.push_back(
                        {glm::vec3(points[i - 1]), glm::vec3(points[i]), 4.0f, 3.0f, copy.colour, noIndex});
            }
            lines->box = marks->box;
            all.push_back({std::move(lines), std::move(marks), copy.geometry * armUpright()});
        }
    }
    return all;
}

void ArmGhostMaker::addTo(RenderScene& scene) const
{
    for (const Made& ghost : m_made) {
        scene.lines.push_back({ghost.lines, ghost.place, noNode, false, false, {}});
        scene.points.push_back({ghost.joints, ghost.place, noNode, false, {}});
        scene.trailBox.add(ghost.lines->box.transformed(ghost.place));
    }
}

} // namespace ramure
