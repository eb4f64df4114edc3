#include "core/qt/session/export/export_bones.h"

namespace ramure {

std::vector<ExportBone> bonesOf(const NodeParams& arm)
{
    std::vector<ExportBone> bones;
    glm::dvec3 foot(0.0);
    for (const ArmJoint& joint : arm.joints) {
        const glm::dvec3 tip = foot + glm::dvec3(0.0, 0.0, joint.length);
        const Index parent = bones.empty() ? noIndex : static_cast<Index>(bones.size() - 1);
        bones.push_back({parent, arm.arm.jointRadius, foot, tip});
        foot = tip;
    }
    return bones;
}

std::vector<ExportBone> bonesOf(const Skeleton& skeleton, const Foliage* foliage, const NodeMotion& motion)
{
    std::vector<ExportBone> bones;
    if (!motion.bones)
        return bones;
    for (Index i = 0; i < skeleton.size(); ++i)
        bones.push_back({skeleton.parent[i], skeleton.a0[i], skeleton.p0[i], skeleton.p1[i]});
    const auto hang = [&](const std::vector<FoliageItem>& items, double size) {
        for (const FoliageItem& item : items)
            if (bones.size() < motion.bones->size())
                bones.push_back({item.branch, size, item.position, item.position});
    };
    if (foliage) {
        hang(foliage->apples, 1e-9); // they fall: joints, if there are some left
        hang(foliage->leaves, 0.0);  // never: there are too many of them
    }
    return bones;
}

} // namespace ramure
