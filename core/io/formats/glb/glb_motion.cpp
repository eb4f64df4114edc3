#include "core/io/formats/glb/glb_motion.h"

#include "core/math/reproducible.h"
#include "core/scene/scene.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace ramure::glb {

glm::dmat4 inSpaceOf(const glm::dmat4& above, const glm::dmat4& world)
{
    glm::dmat4 place = glm::inverse(above) * world;
    for (int column = 0; column < 4; ++column) // which rounding may have touched
        place[column][3] = column == 3 ? 1.0 : 0.0;
    return place;
}

bool isNear(const glm::dmat4& a, const glm::dmat4& b)
{
    for (int column = 0; column < 4; ++column)
        if (glm::distance(a[column], b[column]) > 1e-9)
            return false;
    return true;
}

Joints jointsOf(std::span<const ExportBone> bones, std::size_t count, std::size_t limit)
{
    Joints out;
    std::vector<bool> isJoint(count, bones.empty()); // of unknown ones all
    std::size_t kept = 0;
    std::vector<Index> order;
    for (Index i = 0; i < bones.size(); ++i)
        if (bones[i].size > 0.0 || bones[i].parent == noIndex)
            order.push_back(i);
    std::ranges::stable_sort(order, std::greater{}, [&](Index i) { return bones[i].size; });
    for (const Index bone : order) {
        std::vector<Index> added;
        for (Index at = bone; at != noIndex && !isJoint[at]; at = bones[at].parent)
            added.push_back(at);
        if (limit > 0 && kept + added.size() > limit) {
            if (kept > 0)
                continue;
            added = {added.back()}; // one there must be
        }
        for (const Index at : added)
            isJoint[at] = true;
        kept += added.size();
    }
    out.jointOf.resize(count);
    for (Index i = 0; i < count; ++i) {
        if (isJoint[i]) {
            out.jointOf[i] = static_cast<Index>(out.bones.size());
            out.bones.push_back(i);
        } else {
            // A root that does not fit goes with the first.
            out.jointOf[i] = bones[i].parent == noIndex ? 0 : out.jointOf[bones[i].parent];
        }
    }
    return out;
}

double jointError(const Joints& joints, std::span<const ExportBone> bones,
                  std::span<const std::vector<RigidTransform>* const> poses)
{
    double most = 0.0;
    for (const std::vector<RigidTransform>* pose : poses)
        for (std::size_t i = 0; i < bones.size() && i < pose->size(); ++i) {
            const RigidTransform& joint = (*pose)[joints.bones[joints.jointOf[i]]];
            most = std::max(most, glm::distance((*pose)[i].point(bones[i].tip), joint.point(bones[i].tip)));
        }
    return most;
}

Weights weightsOf(const Skin& skin, const Joints& joints, std::span<const Index> from)
{
    // Runs are found by their vertices; those of a file jump to and fro.
    std::vector<std::uint32_t> runOf(skin.vertices);
    for (std::size_t run = 0; run < skin.runs.size(); ++run) {
        const Index end = run + 1 < skin.runs.size() ? skin.runs[run + 1].firstVertex : skin.vertices;
        std::fill(runOf.begin() + skin.runs[run].firstVertex, runOf.begin() + end, std::uint32_t(run));
    }
    Weights out;
    out.joints.reserve(from.size());
    out.weights.reserve(from.size());
    for (const Index vertex : from) {
        const SkinInfluence& influence = skin.runs[runOf[vertex]].influence;
        glm::u16vec4 joint(0);
        glm::dvec4 weight(0.0);
        int used = 0;
        for (std::size_t k = 0; k < influence.bone.size(); ++k) {
            if (!(influence.weight[k] > 0.0F))
                continue;
            const auto which = static_cast<std::uint16_t>(joints.jointOf[influence.bone[k]]);
            int at = 0;
            while (at < used && joint[at] != which)
                ++at;
            joint[at] = which;
            weight[at] += double(influence.weight[k]);
            used = std::max(used, at + 1);
        }
        out.joints.push_back(joint);
        out.weights.emplace_back(weight / (weight.x + weight.y + weight.z + weight.w));
    }
    return out;
}

namespace {

glm::vec4 turnOf(const glm::dquat& q)
{
    return {q.x, q.y, q.z, q.w};
}

Json listOf(const glm::vec3& v)
{
    return {v.x, v.y, v.z};
}
Json listOf(const glm::vec4& v)
{
    return {v.x, v.y, v.z, v.w};
}

/// From one to the next the short way round.
void keepTogether(std::vector<glm::vec4>& turns)
{
    for (std::size_t i = 1; i < turns.size(); ++i)
        if (glm::dot(turns[i], turns[i - 1]) < 0.0F)
            turns[i] = -turns[i];
}

} // namespace

template <class Value>
void Animation::channel(Json& node, std::size_t number, const char* path, const char* type,
                        const std::vector<Value>& values)
{
    node[path] = listOf(values.front());
    constexpr float unseen = 1e-6F; // m, and of a half turn about a third
    const bool isStill = std::ranges::all_of(
        values, [&](const Value& value) { return glm::distance(value, values.front()) <= unseen; });
    if (!moves() || isStill)
        return;
    if (!m_input)
        m_input = addInput(m_seconds);
    const std::size_t output =
        m_buffer.addAccessor(m_buffer.addValues(values), Number::Float, type, values.size());
    m_channels.push_back({{"sampler", m_samplers.size()}, {"target", {{"node", number}, {"path", path}}}});
    m_samplers.push_back({{"input", *m_input}, {"output", output}});
}

Expected<void> Animation::place(Json& node, std::size_t number, std::span<const glm::dmat4> places)
{
    std::vector<glm::vec3> moved, sizes;
    std::vector<glm::vec4> turns;
    for (const glm::dmat4& matrix : places) {
        const auto parts = decomposePlacement(matrix);
        RAMURE_TRY(parts);
        moved.emplace_back(parts->translation);
        const glm::dvec3& turn = parts->rotation;
        turns.push_back(turnOf(maths::angleAxis(turn.z, {0, 0, 1}) * maths::angleAxis(turn.y, {0, 1, 0}) *
                               maths::angleAxis(turn.x, {1, 0, 0})));
        sizes.emplace_back(parts->scale);
    }
    keepTogether(turns);
    channel(node, number, "translation", "VEC3", moved);
    channel(node, number, "rotation", "VEC4", turns);
    channel(node, number, "scale", "VEC3", sizes);
    return {};
}

void Animation::place(Json& node, std::size_t number, std::span<const RigidTransform> places)
{
    std::vector<glm::vec3> moved;
    std::vector<glm::vec4> turns;
    for (const RigidTransform& place : places) {
        moved.emplace_back(place.translation);
        turns.push_back(turnOf(glm::normalize(place.rotation)));
    }
    keepTogether(turns);
    channel(node, number, "translation", "VEC3", moved);
    channel(node, number, "rotation", "VEC4", turns);
}

std::size_t Animation::addInput(const std::vector<float>& seconds)
{
    const std::size_t input =
        m_buffer.addAccessor(m_buffer.addValues(seconds), Number::Float, "SCALAR", seconds.size());
    m_buffer.accessor(input)["min"] = Json::array({seconds.front()});
    m_buffer.accessor(input)["max"] = Json::array({seconds.back()});
    return input;
}

void Animation::shapes(std::size_t number, const ExportShapes& shapes)
{
    const std::size_t count = shapes.shapes.size();
    std::vector<float> weights(shapes.seconds.size() * count, 0.0F);
    for (std::size_t i = 0; i < shapes.at.size(); ++i)
        if (shapes.at[i] != noIndex)
            weights[i * count + shapes.at[i]] = 1.0F;
    const std::size_t input = addInput(shapes.seconds);
    const std::size_t output =
        m_buffer.addAccessor(m_buffer.addValues(weights), Number::Float, "SCALAR", weights.size());
    m_channels.push_back(
        {{"sampler", m_samplers.size()}, {"target", {{"node", number}, {"path", "weights"}}}});
    m_samplers.push_back({{"input", input}, {"output", output}});
}

void Animation::addTo(Json& root)
{
    if (!m_channels.empty())
        root["animations"] = Json::array({{{"name", "Timeline"},
                                           {"channels", std::move(m_channels)},
                                           {"samplers", std::move(m_samplers)}}});
}

} // namespace ramure::glb
