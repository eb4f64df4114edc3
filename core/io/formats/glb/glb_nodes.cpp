#include "core/io/formats/glb/glb_nodes.h"

#include <algorithm>
#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace ramure::glb {

namespace {

constexpr std::size_t mostCopies = 5'000'000;

glm::dmat4 matrixOf(const Pose& pose)
{
    return glm::translate(glm::dmat4(1.0), pose.translation) * glm::mat4_cast(pose.rotation) *
           glm::scale(glm::dmat4(1.0), pose.scale);
}

glm::dquat unit(const double* xyzw)
{
    const glm::dquat turn(xyzw[3], xyzw[0], xyzw[1], xyzw[2]);
    return glm::length(turn) > 1e-12 ? glm::normalize(turn) : glm::dquat(1.0, 0.0, 0.0, 0.0);
}

Expected<void> readPlace(FileNode& node, const std::string& place)
{
    const Json& json = *node.json;
    if (member(json, "matrix")) {
        if (auto read = numbersOf(json, "matrix", {glm::value_ptr(node.local), 16}, place); !read)
            return read;
        for (int column = 0; column < 4; ++column) // which rounding may have touched
            node.local[column][3] = column == 3 ? 1.0 : 0.0;
        return {};
    }
    double turn[4] = {0.0, 0.0, 0.0, 1.0};
    for (const auto& [name, to, count] :
         {std::tuple("translation", glm::value_ptr(node.pose.translation), 3),
          std::tuple("scale", glm::value_ptr(node.pose.scale), 3), std::tuple("rotation", &turn[0], 4)})
        if (auto read = numbersOf(json, name, {to, static_cast<std::size_t>(count)}, place); !read)
            return read;
    node.pose.rotation = unit(turn);
    node.local = matrixOf(node.pose);
    return {};
}

std::string nameOf(const File& file, const FileNode& node, std::size_t number)
{
    if (std::string name = textOf(*node.json, "name"); !name.empty())
        return name;
    for (const auto& [list, held] : {std::pair("meshes", node.mesh), std::pair("cameras", node.camera)})
        if (held && *held < file.list(list).size())
            if (std::string name = textOf(file.list(list)[*held], "name"); !name.empty())
                return name;
    return "node " + std::to_string(number);
}

Expected<void> hang(FileNodes& nodes, std::size_t parent, const std::string& place)
{
    const Json* children = member(*nodes.all[parent].json, "children");
    if (!children)
        return {};
    for (const Json& child : *children) {
        const auto number = child.is_number_unsigned() ? child.get<std::size_t>() : nodes.all.size();
        if (number >= nodes.all.size())
            return wrong(place + ".children", RAMURE_NOOP("a child that does not exist"));
        if (nodes.all[number].parent != noIndex)
            return wrong(place + ".children", RAMURE_NOOP("%1 stands below two nodes"),
                         {placeOf("nodes", number)});
        nodes.all[number].parent = static_cast<Index>(parent);
    }
    return {};
}

/// The scene's own, or where there is no scene all that stand at the top.
Expected<std::vector<Index>> topsOf(const File& file, const FileNodes& nodes)
{
    std::vector<Index> tops;
    const std::size_t shown = numberOf(file.root(), "scene").value_or(0);
    if (file.list("scenes").empty()) {
        for (std::size_t i = 0; i < nodes.all.size(); ++i)
            if (nodes.all[i].parent == noIndex)
                tops.push_back(static_cast<Index>(i));
        return tops;
    }
    const auto scene = file.element("scenes", shown, "scene");
    RAMURE_TRY(scene);
    const std::string place = placeOf("scenes", shown) + ".nodes";
    if (const Json* list = member(**scene, "nodes"))
        for (const Json& top : *list) {
            const auto number = top.is_number_unsigned() ? top.get<std::size_t>() : nodes.all.size();
            if (number >= nodes.all.size() || nodes.all[number].parent != noIndex ||
                std::ranges::find(tops, static_cast<Index>(number)) != tops.end())
                return wrong(place, RAMURE_NOOP("a node that does not exist, or not at the top"));
            tops.push_back(static_cast<Index>(number));
        }
    return tops;
}

/// From these on down, parents before their children, in the order of the file. What stands in a circle has
/// no top and is never met.
std::vector<Index> walk(FileNodes& nodes, const std::vector<Index>& tops)
{
    std::vector<Index> out, waiting(tops.rbegin(), tops.rend());
    while (!waiting.empty()) {
        const Index at = waiting.back();
        waiting.pop_back();
        out.push_back(at);
        FileNode& node = nodes.all[at];
        node.world = node.parent == noIndex ? node.local : nodes.all[node.parent].world * node.local;
        if (const Json* children = member(*node.json, "children"))
            for (auto child = children->rbegin(); child != children->rend(); ++child)
                waiting.push_back(child->get<Index>());
    }
    return out;
}

} // namespace

Expected<FileNodes> nodesOf(const File& file)
{
    FileNodes out;
    const Json& list = file.list("nodes");
    for (std::size_t i = 0; i < list.size(); ++i) {
        const auto json = file.element("nodes", i, "nodes");
        RAMURE_TRY(json);
        FileNode& node = out.all.emplace_back();
        node.json = *json;
        node.mesh = numberOf(**json, "mesh");
        node.skin = numberOf(**json, "skin");
        node.camera = numberOf(**json, "camera");
        node.name = nameOf(file, node, i);
        RAMURE_TRY(readPlace(node, placeOf("nodes", i)));
    }
    std::vector<Index> all;
    for (std::size_t i = 0; i < list.size(); ++i)
        RAMURE_TRY(hang(out, i, placeOf("nodes", i)));
    for (std::size_t i = 0; i < list.size(); ++i)
        if (out.all[i].parent == noIndex)
            all.push_back(static_cast<Index>(i));
    walk(out, all); // joints may stand outside of the scene
    const auto tops = topsOf(file, out);
    RAMURE_TRY(tops);
    out.inScene = walk(out, *tops);
    return out;
}

Expected<std::vector<FileCopy>> copiesOf(File& file, const FileNode& node, const std::string& place)
{
    const Json* extensions = member(*node.json, "extensions");
    const Json* instancing = extensions ? member(*extensions, "EXT_mesh_gpu_instancing") : nullptr;
    const Json* attributes = instancing ? member(*instancing, "attributes") : nullptr;
    if (!attributes)
        return std::vector<FileCopy>(1);
    std::vector<float> places, turns, sizes, tints;
    const std::size_t channels = file.components(numberOf(*attributes, "_COLOR_0")) == 4 ? 4 : 3;
    for (const auto& [name, to, size] :
         {std::tuple("TRANSLATION", &places, std::size_t(3)), std::tuple("ROTATION", &turns, std::size_t(4)),
          std::tuple("SCALE", &sizes, std::size_t(3)), std::tuple("_COLOR_0", &tints, channels)}) {
        if (!member(*attributes, name))
            continue;
        auto read = file.floats(numberOf(*attributes, name), size, place);
        RAMURE_TRY(read);
        *to = std::move(*read);
    }
    const std::size_t count = std::max({places.size() / 3, turns.size() / 4, sizes.size() / 3});
    if (count > mostCopies)
        return wrong(place, RAMURE_NOOP("more than %1 copies"), {std::to_string(mostCopies)},
                     ErrorCode::Limit);
    places.resize(3 * count, 0.0F);
    sizes.resize(3 * count, 1.0F);
    tints.resize(channels * count, 1.0F);
    for (std::size_t i = turns.size(); i < 4 * count; ++i)
        turns.push_back(i % 4 == 3 ? 1.0F : 0.0F);
    std::vector<FileCopy> out;
    for (std::size_t i = 0; i < count; ++i) {
        const double turn[4] = {double(turns[4 * i]), double(turns[4 * i + 1]), double(turns[4 * i + 2]),
                                double(turns[4 * i + 3])};
        out.push_back({matrixOf({glm::dvec3(glm::make_vec3(&places[3 * i])), unit(turn),
                                 glm::dvec3(glm::make_vec3(&sizes[3 * i]))}),
                       glm::make_vec3(&tints[channels * i])});
    }
    return out;
}

Expected<std::vector<Index>> jointsOf(const File& file, const FileNodes& nodes, std::size_t skin)
{
    const std::string place = placeOf("skins", skin);
    const auto json = file.element("skins", skin, place);
    RAMURE_TRY(json);
    std::vector<Index> out;
    if (const Json* joints = member(**json, "joints"); joints && joints->is_array())
        for (const Json& joint : *joints) {
            if (!joint.is_number_unsigned() || joint.get<std::size_t>() >= nodes.all.size())
                return wrong(place + ".joints", RAMURE_NOOP("a joint that is no node"));
            out.push_back(joint.get<Index>());
        }
    if (out.empty())
        return wrong(place, RAMURE_NOOP("a skin without joints"));
    return out;
}

Expected<std::vector<glm::dmat4>> inverseBinds(File& file, std::size_t skin, std::size_t joints)
{
    const std::string place = placeOf("skins", skin);
    const auto json = file.element("skins", skin, place);
    RAMURE_TRY(json);
    std::vector<glm::dmat4> out(joints, glm::dmat4(1.0));
    if (!member(**json, "inverseBindMatrices"))
        return out;
    const auto numbers = file.floats(numberOf(**json, "inverseBindMatrices"), 16, place);
    RAMURE_TRY(numbers);
    if (numbers->size() < 16 * joints)
        return wrong(place, RAMURE_NOOP("fewer bind matrices than joints"));
    for (std::size_t i = 0; i < joints; ++i)
        out[i] = glm::dmat4(glm::make_mat4(&(*numbers)[16 * i]));
    return out;
}

Expected<std::vector<glm::dmat4>> jointMatrices(File& file, const FileNodes& nodes, std::size_t skin)
{
    const auto joints = jointsOf(file, nodes, skin);
    RAMURE_TRY(joints);
    auto out = inverseBinds(file, skin, joints->size());
    for (std::size_t i = 0; out && i < joints->size(); ++i)
        (*out)[i] = nodes.all[(*joints)[i]].world * (*out)[i];
    return out;
}

} // namespace ramure::glb
