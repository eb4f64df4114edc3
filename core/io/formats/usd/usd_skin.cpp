#include "core/io/formats/usd/usd_skin.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <numeric>

namespace ramure::usd {
namespace {

constexpr double weightScale = 1e4; // four decimals

/// A turn as USD has it: the real part first.
glm::vec4 realFirst(const glm::dquat& q)
{
    return {q.w, q.x, q.y, q.z};
}

/// Of joints as their parents see them.
std::vector<RigidTransform> localPlaces(const Rig& rig, const Pose& pose)
{
    std::vector<RigidTransform> worlds, out;
    for (std::size_t j = 0; j < rig.feet.size(); ++j) {
        const RigidTransform& bone = pose[rig.joints.bones[j]];
        worlds.push_back({glm::normalize(bone.rotation), bone.point(rig.feet[j])});
        const Index parent = rig.parents[j];
        out.push_back(parent == noIndex ? worlds.back() : worlds[parent].inverse() * worlds.back());
    }
    return out;
}

void writeTokens(Text& text, const Rig& rig)
{
    std::string line = "uniform token[] joints = [";
    for (const std::string& token : rig.tokens)
        line.append(&token == &rig.tokens.front() ? "" : ", ").append(inQuotes(token));
    text.line(line + "]");
}

void writeRest(Text& text, const Rig& rig, const char* name, bool isLocal)
{
    std::string line = std::string("uniform matrix4d[] ") + name + " = [";
    for (std::size_t j = 0; j < rig.feet.size(); ++j) {
        const bool isBelow = isLocal && rig.parents[j] != noIndex;
        const glm::dvec3 place = rig.feet[j] - (isBelow ? rig.feet[rig.parents[j]] : glm::dvec3(0.0));
        line.append(j == 0 ? "" : ", ").append(matrixText(glm::translate(glm::dmat4(1.0), place)));
    }
    text.line(line + "]");
}

void writeAnimation(Text& text, const Rig& rig, std::span<const Pose* const> poses,
                    std::span<const double> codes)
{
    std::vector<std::vector<glm::vec3>> places;
    std::vector<std::vector<glm::vec4>> turns;
    for (const Pose* pose : poses) {
        places.emplace_back();
        turns.emplace_back();
        for (const RigidTransform& local : localPlaces(rig, *pose)) {
            places.back().emplace_back(local.translation);
            turns.back().push_back(realFirst(glm::normalize(local.rotation)));
        }
        for (std::size_t j = 0; turns.size() > 1 && j < rig.feet.size(); ++j) // the short way round
            if (glm::dot(turns.back()[j], turns[turns.size() - 2][j]) < 0.0F)
                turns.back()[j] = -turns.back()[j];
    }
    text.open("def SkelAnimation \"Animation\"");
    writeTokens(text, rig);
    text.openBlock("quatf[] rotations.timeSamples = {");
    for (std::size_t i = 0; i < codes.size(); ++i)
        text.sample(codes[i], rig.feet.size(),
                    [&](char* to, std::size_t j) { return appendRoundedTuple(to, turns[i][j], 1e7); });
    text.close();
    text.array("half3[] scales", rig.feet.size(),
               [](char* to, std::size_t) { return appendTuple(to, glm::vec3(1.0F)); });
    text.openBlock("float3[] translations.timeSamples = {");
    for (std::size_t i = 0; i < codes.size(); ++i)
        text.sample(codes[i], rig.feet.size(),
                    [&](char* to, std::size_t j) { return appendTuple(to, places[i][j]); });
    text.close();
    text.close();
}

} // namespace

Expected<Rig> rigOf(const ExportNode& node, std::size_t bones, std::size_t limit, std::string path)
{
    Rig rig;
    rig.path = std::move(path);
    rig.joints = glb::jointsOf(node.bones, bones, limit);
    if (rig.joints.bones.size() > std::numeric_limits<std::uint16_t>::max())
        return fail(ErrorCode::Limit, RAMURE_NOOP("%1 has more than 65535 joints: choose fewer"),
                    {node.name});
    for (const Index bone : rig.joints.bones) {
        const Index above = node.bones.empty() ? noIndex : node.bones[bone].parent;
        rig.parents.push_back(above == noIndex ? noIndex : rig.joints.jointOf[above]);
        rig.feet.push_back(node.bones.empty() ? glm::dvec3(0.0) : node.bones[bone].foot);
        const std::string name = "j" + std::to_string(bone);
        rig.tokens.push_back(above == noIndex ? name : rig.tokens[rig.parents.back()] + "/" + name);
    }
    return rig;
}

void writeSkeleton(Text& text, const Rig& rig, std::span<const Pose* const> poses,
                   std::span<const double> codes)
{
    text.open("def Skeleton \"Skeleton\"", {"prepend apiSchemas = [\"SkelBindingAPI\"]"});
    writeRest(text, rig, "bindTransforms", false);
    writeTokens(text, rig);
    writeRest(text, rig, "restTransforms", true);
    text.line("rel skel:animationSource = " + target(rig.path + "/Animation"));
    writeAnimation(text, rig, poses, codes);
    text.close();
}

void writeSkin(Text& text, const Rig& rig, const Skin& skin, SkinMethod method)
{
    std::vector<Index> all(skin.vertices);
    std::iota(all.begin(), all.end(), Index(0));
    const glb::Weights weights = glb::weightsOf(skin, rig.joints, all);
    int size = 1;
    for (const glm::vec4& weight : weights.weights)
        for (int k = size; k < 4 && weight[k] > 0.0F; ++k)
            size = k + 1;
    const auto each = static_cast<std::size_t>(size);
    const std::vector<std::string> metadata{"elementSize = " + std::to_string(size),
                                            "interpolation = \"vertex\""};
    const auto place = [&](std::size_t i) { return std::pair(i / each, static_cast<int>(i % each)); };
    text.line("matrix4d primvars:skel:geomBindTransform = " + matrixText(glm::dmat4(1.0)));
    text.array(
        "int[] primvars:skel:jointIndices", each * all.size(),
        [&](char* to, std::size_t i) {
            const auto [v, k] = place(i);
            return appendIndex(to, weights.joints[v][k]);
        },
        metadata);
    // What stands in the file adds up to 1: the first takes what rounding left.
    text.array(
        "float[] primvars:skel:jointWeights", each * all.size(),
        [&](char* to, std::size_t i) {
            const auto [v, k] = place(i);
            double share = double(weights.weights[v][k]);
            if (k == 0) {
                share = 1.0;
                for (int other = 1; other < size; ++other)
                    share -= std::round(double(weights.weights[v][other]) * weightScale) / weightScale;
            }
            return appendRounded(to, share, weightScale);
        },
        metadata);
    if (method == SkinMethod::DualQuaternion)
        text.line("uniform token primvars:skel:skinningMethod = \"dualQuaternion\"");
    text.line("rel skel:skeleton = " + target(rig.path));
}

const std::string& jointOf(const Rig& rig, const SkinInfluence& influence)
{
    return rig.tokens[rig.joints.jointOf[influence.bone[0]]];
}

void takePoses(Box& box, const Rig& rig, const TriangleMesh& mesh, const Skin& skin,
               std::span<const Pose* const> poses)
{
    std::vector<Box> ofJoints(rig.feet.size());
    for (std::size_t run = 0; run < skin.runs.size(); ++run) {
        const Index end = run + 1 < skin.runs.size() ? skin.runs[run + 1].firstVertex : skin.vertices;
        for (Index v = skin.runs[run].firstVertex; v < end; ++v)
            for (std::size_t k = 0; k < 3; ++k)
                if (skin.runs[run].influence.weight[k] > 0.0F)
                    ofJoints[rig.joints.jointOf[skin.runs[run].influence.bone[k]]].take(mesh.positions[v]);
    }
    for (const Pose* pose : poses)
        for (std::size_t j = 0; j < ofJoints.size(); ++j)
            for (int corner = 0; corner < 8 && !ofJoints[j].isEmpty(); ++corner) {
                glm::dvec3 p;
                for (int axis = 0; axis < 3; ++axis)
                    p[axis] = (corner >> axis & 1) != 0 ? ofJoints[j].high[axis] : ofJoints[j].low[axis];
                box.take((*pose)[rig.joints.bones[j]].point(p));
            }
}

} // namespace ramure::usd
