/// \file
/// GLB: nodes, meshes and materials of glTF 2.0 in one file. A closed mesh is told to be one by
/// EXT_mesh_manifold (Emmett Lalish, Khronos Group 2023), however its texture and its colours part it.

#include "core/base/number_text.h"
#include "core/base/version.h"
#include "core/io/formats/file_format.h"
#include "core/io/formats/glb/glb_levels.h"
#include "core/io/formats/glb/glb_motion.h"
#include "core/io/formats/glb/glb_packed.h"
#include "core/io/formats/glb/glb_reader.h"
#include "core/io/formats/glb/glb_shapes.h"
#include "core/io/formats/glb/glb_variants.h"
#include "core/math/finite.h"
#include "core/rig/arm/arm_chain.h"
#include "core/rig/arm/arm_shape.h"
#include "core/rig/pose/skin.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <span>

namespace ramure {
namespace {

using glb::Json;
using glb::Number;
using glb::Target;

constexpr const char* instancing = "EXT_mesh_gpu_instancing";
constexpr const char* manifold = "EXT_mesh_manifold";
constexpr const char* levels = "MSFT_lod";
using glb::coarseBits, glb::fineBits;

template <class T> bool areEqual(const std::shared_ptr<const T>& a, const std::shared_ptr<const T>& b)
{
    return a == b || (a && b && *a == *b);
}

/// A mesh without a skin that is in the file.
struct Written
{
    std::shared_ptr<const TriangleMesh> mesh;
    std::shared_ptr<const WindColumns> wind;      ///< may be null
    std::shared_ptr<const ExportSeasons> seasons; ///< may be null
    std::shared_ptr<const ExportShapes> shapes;   ///< may be null
    bool textured, coloured;
    std::size_t material;
    std::size_t number = 0; ///< in the file

    /// It would have the same bytes.
    bool operator==(const Written& other) const
    {
        return textured == other.textured && material == other.material && areEqual(mesh, other.mesh) &&
               areEqual(wind, other.wind) && seasons == other.seasons && shapes == other.shapes;
    }
};

class GlbWriter
{
public:
    GlbWriter(const ExportScene& scene, const WriteOptions& options)
        : m_scene(scene)
        , m_options(options)
        , m_buffer(options.compressed)
        , m_materials(m_buffer, options.mapSize)
        , m_animation(m_buffer, secondsOf(scene))
        , m_node(scene.nodes.size(), noIndex)
    {
    }

    Expected<void> run(const std::string& path, const Progress& progress)
    {
        for (std::size_t i = 0; i < m_scene.meshes.size(); ++i) {
            const double count = double(m_scene.meshes.size());
            const Progress part = progress.part(0.8 * double(i) / count, 0.8 * double(i + 1) / count);
            part.report(0.0);
            if (part.cancelled())
                return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
            if (auto added = add(m_scene.meshes[i], part); !added)
                return added;
        }
        for (const ExportCopies& copies : m_scene.copies)
            if (auto added = add(copies, progress.part(0.8, 0.8)); !added)
                return added;
        if (m_scene.lines)
            addLines(*m_scene.lines);
        if (const int last = lastLevel(m_scene); last > 0)
            linkLevels(last);
        Json root{{"asset", {{"version", "2.0"}, {"generator", "Ramure " RAMURE_VERSION}}},
                  {"scene", 0},
                  {"scenes", Json::array({{{"nodes", m_roots}}})},
                  {"nodes", std::move(m_nodes)},
                  {"meshes", std::move(m_meshes)}};
        m_materials.addTo(root);
        m_variants.addTo(root);
        m_animation.addTo(root);
        if (!m_skins.empty())
            root["skins"] = std::move(m_skins);
        if (!m_scene.copies.empty())
            for (const char* list : {"extensionsUsed", "extensionsRequired"}) // else one leaf would be seen
                root[list].push_back(instancing);
        if (m_hasManifold)
            root["extensionsUsed"].push_back(manifold);
        if (lastLevel(m_scene) > 0)
            root["extensionsUsed"].push_back(levels);
        return std::move(m_buffer).write(path, std::move(root), progress.part(0.8, 1.0));
    }

private:
    /// From 0 on.
    static std::vector<float> secondsOf(const ExportScene& scene)
    {
        std::vector<float> seconds;
        for (const ExportFrame& frame : scene.frames)
            seconds.push_back(static_cast<float>(frame.seconds - scene.frames.front().seconds));
        return seconds;
    }

    /// The node of the scene, with those above it.
    Expected<std::size_t> nodeOf(Index number)
    {
        if (m_node[number] != noIndex)
            return m_node[number];
        const ExportNode& node = m_scene.nodes[number];
        const bool isTop = node.parent == noIndex;
        const auto parent = isTop ? Expected<std::size_t>(0) : nodeOf(node.parent);
        if (!parent)
            return parent;
        std::vector<glm::dmat4> places;
        for (const ExportFrame& frame : m_scene.frames) {
            const glm::dmat4& world = frame.transforms[number].world;
            places.push_back(isTop ? world : glb::inSpaceOf(frame.transforms[node.parent].world, world));
        }
        const auto added = addNode(node.name, places, isTop ? m_roots : m_nodes[*parent]["children"]);
        if (added)
            m_node[number] = static_cast<Index>(*added);
        return added;
    }

    /// Each finest mesh's node names those that may stand for it. No scene holds them: what does not know the
    /// extension shows the finest alone. A level that has nothing of it has an empty node.
    void linkLevels(int last)
    {
        for (std::size_t i = 0; i < m_scene.meshes.size(); ++i) {
            const ExportMesh& finest = m_scene.meshes[i];
            if (!finest.isLevel || finest.finest != noIndex)
                continue;
            std::string stem = finest.name;
            stem.erase(stem.size() - 1); // the 0
            std::vector<std::size_t> ids;
            std::vector<double> coverage{finest.coverage};
            for (int level = 1; level <= last; ++level) {
                std::size_t node = m_nodes.size();
                coverage.push_back(level < last ? coverage.back() : 0.0);
                for (std::size_t k = 0; k < m_scene.meshes.size(); ++k)
                    if (m_scene.meshes[k].finest == i && m_scene.meshes[k].level == level) {
                        node = m_meshNode[k];
                        coverage.back() = m_scene.meshes[k].coverage;
                    }
                if (node == m_nodes.size())
                    m_nodes.push_back({{"name", stem + std::to_string(level)}});
                ids.push_back(node);
            }
            Json& node = m_nodes[m_meshNode[i]];
            node["extensions"][levels]["ids"] = ids;
            node["extras"]["MSFT_screencoverage"] = coverage;
        }
    }

    /// What holds the geometry of a node: below it, where that has a place of its own; a level stands for
    /// what is there.
    Expected<std::size_t> holderOf(Index number, const std::string& name, const glm::dmat4& inside,
                                   bool isOther = false)
    {
        const auto parent = nodeOf(number);
        if (!parent)
            return parent;
        std::vector<glm::dmat4> places;
        for (const ExportFrame& frame : m_scene.frames) {
            const NodeTransforms& at = frame.transforms[number];
            places.push_back(
                (at.world == at.geometry ? glm::dmat4(1.0) : glb::inSpaceOf(at.world, at.geometry)) * inside);
        }
        if (Json none = Json::array(); isOther)
            return addNode(name, places, none);
        return addNode(name, places, m_nodes[*parent]["children"]);
    }

    /// \param places one a frame
    Expected<std::size_t> addNode(const std::string& name, std::span<const glm::dmat4> places, Json& siblings)
    {
        siblings.push_back(m_nodes.size()); // before its own growth moves them
        m_nodes.push_back({{"name", name}});
        Json& node = m_nodes.back();
        const bool isStill = std::ranges::all_of(
            places, [&](const glm::dmat4& place) { return glb::isNear(place, places.front()); });
        const std::size_t number = m_nodes.size() - 1;
        if (!isStill) {
            RAMURE_TRY(m_animation.place(node, number, places));
        } else if (places.front() != glm::dmat4(1.0)) {
            const double* numbers = glm::value_ptr(places.front());
            node["matrix"] = std::vector<double>(numbers, numbers + 16);
        }
        return number;
    }

    /// The skin of a node's bones, made when the first of its meshes needs it.
    Expected<std::size_t> skinOf(Index number)
    {
        if (const auto found = m_skinOf.find(number); found != m_skinOf.end())
            return found->second.first;
        const ExportNode& node = m_scene.nodes[number];
        std::vector<const std::vector<RigidTransform>*> poses;
        for (const ExportFrame& frame : m_scene.frames)
            poses.push_back(frame.bones[number].get());
        const auto limit = static_cast<std::size_t>(m_options.joints);
        const glb::Joints joints = glb::jointsOf(node.bones, poses.front()->size(), limit);
        if (joints.bones.size() > std::numeric_limits<std::uint16_t>::max())
            return fail(ErrorCode::Limit, RAMURE_NOOP("%1 has more than 65535 joints: choose fewer"),
                        {node.name});
        const auto root =
            holderOf(number, node.name + " joints", node.isArm ? armUpright() : glm::dmat4(1.0));
        if (!root)
            return root;
        Json numbers = Json::array();
        std::vector<glm::mat4> binds;
        std::vector<RigidTransform> before;
        for (const Index bone : joints.bones) {
            const glm::dvec3 foot = node.bones.empty() ? glm::dvec3(0.0) : node.bones[bone].foot;
            std::vector<RigidTransform> places;
            for (const auto* pose : poses)
                places.push_back({(*pose)[bone].rotation, (*pose)[bone].point(foot)});
            // Segments of an arm hang on each other, as other programs have it; of a tree's many branches
            // each stands for itself, so that no error adds up.
            const bool isBelow = node.isArm && !numbers.empty();
            const std::size_t above = isBelow ? numbers.back().get<std::size_t>() : *root;
            const std::vector<RigidTransform> worlds = places;
            for (std::size_t i = 0; isBelow && i < places.size(); ++i)
                places[i] = before[i].inverse() * worlds[i];
            before = worlds;
            numbers.push_back(m_nodes.size());
            m_nodes[above]["children"].push_back(m_nodes.size());
            m_nodes.push_back({{"name", "joint " + std::to_string(bone)}});
            m_animation.place(m_nodes.back(), m_nodes.size() - 1, places);
            glm::mat4& bind = binds.emplace_back(1.0F);
            bind[3] = glm::vec4(-foot, 1.0);
        }
        const std::size_t bindings =
            m_buffer.addAccessor(m_buffer.addValues(binds), Number::Float, "MAT4", binds.size());
        m_skins.push_back(
            Json{{"inverseBindMatrices", bindings}, {"joints", std::move(numbers)}, {"skeleton", *root}});
        tellJoints(node, joints, poses);
        m_skinOf.emplace(number, std::pair(m_skins.size() - 1, joints));
        return m_skins.size() - 1;
    }

    void tellJoints(const ExportNode& node, const glb::Joints& joints,
                    std::span<const std::vector<RigidTransform>* const> poses) const
    {
        if (!m_options.tell || joints.bones.size() == joints.jointOf.size())
            return;
        const double error = glb::jointError(joints, node.bones, poses);
        m_options.tell(
            fail(ErrorCode::Limit,
                 RAMURE_NOOP("%1: %2 joints for %3 bones; no tip is more than %4 m from its place"),
                 {node.name, numberText(joints.bones.size()), numberText(joints.jointOf.size()),
                  numberText(std::ceil(1000.0 * error) / 1000.0)})
                .value());
    }

    Expected<void> add(const ExportMesh& from, const Progress& progress)
    {
        const ExportFrame& now = m_scene.frames.front();
        const ExportNode& node = m_scene.nodes[from.node];
        std::shared_ptr<const TriangleMesh> mesh = from.mesh;
        const auto& bones = now.bones[from.node];
        const bool hasSkin = m_scene.frames.size() > 1 && from.skin && bones;
        if (!hasSkin && from.skin && bones)
            mesh = std::make_shared<const TriangleMesh>(deformed(*mesh, *from.skin, *bones, node.method));
        if (!hasSkin && node.isArm)
            mesh = std::make_shared<const TriangleMesh>(upright(*mesh));
        const Material& material = m_scene.materials[from.material];
        const bool pictured = m_materials.isPictured(material) && !mesh->uv.empty();
        // Colours that shaders move it by are not to be seen.
        const bool coloured = !mesh->colours.empty() && !(from.wind && !from.wind->colours.empty());
        const auto number = m_materials.add(material, pictured, coloured, progress);
        RAMURE_TRY(number);
        // Second texture coordinates stand beside first ones.
        const bool textured = pictured || (from.wind && !from.wind->uv.empty());
        if (hasSkin)
            return addSkinned(from, textured, *number);
        // An object of one mesh is one node.
        const auto isInPlace = [&](const ExportFrame& frame) {
            return frame.transforms[from.node].world == frame.transforms[from.node].geometry;
        };
        const bool isAlone = std::ranges::count(m_scene.meshes, from.node, &ExportMesh::node) == 1 &&
                             std::ranges::all_of(m_scene.frames, isInPlace);
        const auto holder = isAlone ? nodeOf(from.node)
                                    : holderOf(from.node, from.name, glm::dmat4(1.0), from.finest != noIndex);
        RAMURE_TRY(holder);
        m_meshNode.push_back(*holder);
        glb::tellFade(m_nodes[*holder], from);
        return addOnce(*holder, {mesh, from.wind, from.seasons, from.shapes, textured, coloured, *number},
                       from.name);
    }

    /// What is in the buffer already is only named: equal trees share one mesh, wherever they stand.
    Expected<void> addOnce(std::size_t node, Written written, const std::string& name)
    {
        const auto known = std::ranges::find(m_written, written);
        m_nodes[node]["mesh"] = known == m_written.end() ? m_meshes.size() : known->number;
        if (written.shapes)
            m_animation.shapes(node, *written.shapes);
        if (known != m_written.end())
            return {};
        written.number = m_meshes.size();
        m_written.push_back(written);
        RAMURE_TRY(addMesh(name, *written.mesh, written.textured, written.material, nullptr,
                           written.wind.get(), written.seasons.get(), written.shapes.get()));
        return addVariants(written);
    }

    Expected<void> addVariants(const Written& written)
    {
        std::vector<std::size_t> numbers;
        for (std::size_t i = 0; written.seasons && i < written.seasons->variants.size(); ++i) {
            const Material& material = m_scene.materials[written.seasons->variants[i].material];
            const bool pictured = written.textured && m_materials.isPictured(material);
            const auto number = m_materials.add(material, pictured, written.coloured, {});
            RAMURE_TRY(number);
            numbers.push_back(*number);
        }
        if (written.seasons)
            m_variants.tell(m_meshes[written.number]["primitives"][0], *written.seasons, numbers);
        return {};
    }

    /// Only its joints say where it is: its node stands at the top and nowhere.
    Expected<void> addSkinned(const ExportMesh& from, bool textured, std::size_t material)
    {
        const auto skin = skinOf(from.node);
        RAMURE_TRY(skin);
        if (from.finest == noIndex)
            m_roots.push_back(m_nodes.size());
        m_meshNode.push_back(m_nodes.size());
        m_nodes.push_back({{"name", from.name}, {"mesh", m_meshes.size()}, {"skin", *skin}});
        glb::tellFade(m_nodes.back(), from);
        return addMesh(from.name, *from.mesh, textured, material, &from);
    }

    Expected<void> addMesh(const std::string& name, const TriangleMesh& mesh, bool textured,
                           std::size_t material, const ExportMesh* skinned = nullptr,
                           const WindColumns* wind = nullptr, const ExportSeasons* seasons = nullptr,
                           const ExportShapes* shapes = nullptr)
    {
        if (!std::ranges::all_of(mesh.positions, &isFinite<3, float>) ||
            !std::ranges::all_of(mesh.normals, &isFinite<3, float>) ||
            !std::ranges::all_of(mesh.uv, &isFinite<2, float>))
            return fail(ErrorCode::Invalid, RAMURE_NOOP("a coordinate of %1 is not a finite number"), {name});
        glb::Vertices vertices = glb::verticesOf(mesh, textured);
        if (m_materials.hasNormals(material) && !vertices.normals.empty() && !vertices.uv.empty())
            glb::addTangents(vertices);
        const bool hasWindColours = wind && !wind->colours.empty();
        if (const BarkParams* bark = m_materials.barkOf(material);
            bark && !hasWindColours && mesh.radius.size() == mesh.positions.size())
            glb::addAges(vertices, mesh, *bark);
        const glb::Packed triangles = m_buffer.isPacked() ? glb::packedTriangles(vertices) : glb::Packed();
        const std::size_t count = vertices.positions.size();
        Json attributes{{"POSITION", m_buffer.addPositions(vertices.positions)}};
        if (!vertices.normals.empty())
            attributes["NORMAL"] = m_buffer.addDirections(vertices.normals, wind != nullptr);
        if (!vertices.tangents.empty())
            attributes["TANGENT"] = m_buffer.addTangents(vertices.tangents);
        if (!vertices.uv.empty())
            attributes["TEXCOORD_0"] = m_buffer.addFloats(vertices.uv, fineBits, "VEC2");
        if (!vertices.colours.empty())
            attributes[hasWindColours ? "COLOR_1" : "COLOR_0"] = addColours(vertices.colours);
        if (wind)
            addWind(attributes, *wind, vertices);
        if (auto phases = seasons ? glb::phasesOf(*seasons, vertices.from, mesh.positions.size())
                                  : std::vector<glm::vec1>();
            !phases.empty())
            attributes["_SEASON"] = m_buffer.addFloats(phases, coarseBits, "SCALAR");
        if (skinned) {
            const glb::Weights weights =
                glb::weightsOf(*skinned->skin, m_skinOf.at(skinned->node).second, vertices.from);
            attributes["JOINTS_0"] = m_buffer.addAccessor(
                m_buffer.addValues(weights.joints, Target::Vertices), Number::Short, "VEC4", count);
            attributes["WEIGHTS_0"] = m_buffer.addAccessor(
                m_buffer.addValues(weights.weights, Target::Vertices), Number::Float, "VEC4", count);
        }
        const std::size_t view = m_buffer.isPacked() ? m_buffer.addPacked(triangles, Target::Indices)
                                                     : m_buffer.addValues(vertices.indices, Target::Indices);
        const std::size_t indices =
            m_buffer.addAccessor(view, Number::Int, "SCALAR", vertices.indices.size());
        const Json positions = attributes["POSITION"];
        Json out{{"name", name},
                 {"primitives", Json::array({{{"attributes", std::move(attributes)},
                                              {"indices", indices},
                                              {"material", material}}})}};
        if (glb::isClosed(mesh))
            out["extensions"][manifold] = closed(vertices, positions, view);
        if (wind)
            out["extras"]["wind"] = glb::windExtras(*wind);
        if (shapes)
            glb::addShapes(out, m_buffer, *shapes, mesh, vertices.from);
        m_meshes.push_back(std::move(out));
        return {};
    }

    std::size_t addColours(const std::vector<glm::u16vec4>& colours)
    {
        return m_buffer.addAccessor(m_buffer.addValues(colours, Target::Vertices), Number::Short, "VEC4",
                                    colours.size(), true);
    }

    /// Validators want first texture coordinates beside second ones, if they are nowhere.
    void addWind(Json& attributes, const WindColumns& wind, const glb::Vertices& vertices)
    {
        const auto ofVertices = [&](const auto& column) {
            std::decay_t<decltype(column)> out;
            out.reserve(column.empty() ? 0 : vertices.from.size());
            for (std::size_t v = 0; v < vertices.from.size() && !column.empty(); ++v)
                out.push_back(column[vertices.from[v]]);
            return out;
        };
        if (!wind.colours.empty())
            attributes["COLOR_0"] = addColours(ofVertices(wind.colours));
        if (auto uv = ofVertices(wind.uv); !uv.empty()) {
            std::vector<glm::vec2> none(uv.size(), glm::vec2(0.0F));
            if (!attributes.contains("TEXCOORD_0"))
                attributes["TEXCOORD_0"] = m_buffer.addFloats(none, fineBits, "VEC2");
            attributes["TEXCOORD_1"] = m_buffer.addFloats(uv, fineBits, "VEC2");
        }
        if (auto numbers = ofVertices(wind.numbers); !numbers.empty())
            attributes["_WIND"] = m_buffer.addFloats(numbers, fineBits, "VEC4");
    }

    /// The same triangles with the vertices that texture and colours part as one.
    Json closed(const glb::Vertices& vertices, const Json& positions, std::size_t view)
    {
        m_hasManifold = true;
        const std::size_t whole = m_buffer.addAccessor(view, Number::Int, "SCALAR", vertices.indices.size());
        Json out{{"manifoldPrimitive",
                  {{"attributes", {{"POSITION", positions}}}, {"indices", whole}, {"mode", 4}}}};
        const std::size_t count = vertices.mergeIndices.size();
        if (count == 0)
            return out;
        const std::size_t places = m_buffer.addValues(vertices.mergeIndices);
        const std::size_t values = m_buffer.addValues(vertices.mergeValues);
        m_buffer.accessor(whole)["sparse"] = {
            {"count", count},
            {"indices", {{"bufferView", places}, {"componentType", static_cast<int>(Number::Int)}}},
            {"values", {{"bufferView", values}}}};
        out["mergeIndices"] = m_buffer.addAccessor(places, Number::Int, "SCALAR", count);
        out["mergeValues"] = m_buffer.addAccessor(values, Number::Int, "SCALAR", count);
        return out;
    }

    /// One mesh, and for each of its copies where it stands, how large it is and how it is turned. Their
    /// colours have no name in the extension; _COLOR_0 is what three.js takes.
    Expected<void> add(const ExportCopies& from, const Progress& progress)
    {
        const Material& material = m_scene.materials[from.material];
        const bool textured = m_materials.isPictured(material) && !from.shape->uv.empty();
        const bool coloured = !from.shape->colours.empty();
        const auto number = m_materials.add(material, textured, coloured, progress);
        RAMURE_TRY(number);
        const auto holder = holderOf(from.node, from.name, glm::dmat4(1.0));
        RAMURE_TRY(holder);
        auto known = std::ranges::find_if(
            m_placed, [&](const auto& placed) { return placed.first->copies == from.copies; });
        if (known == m_placed.end())
            known = m_placed.emplace(known, &from, placesOf(from));
        Json& attributes = m_nodes[*holder]["extensions"][instancing]["attributes"] = known->second;
        std::shared_ptr<const ExportSeasons> ofShape;
        if (from.seasons) {
            std::vector<glm::vec1> phases(from.seasons->phases.begin(), from.seasons->phases.end());
            if (!phases.empty())
                attributes["_SEASON"] = m_buffer.addFloats(phases, coarseBits, "SCALAR", Target::None);
            ofShape = std::make_shared<const ExportSeasons>(ExportSeasons{from.seasons->variants, {}});
        }
        return addOnce(*holder, {from.shape, nullptr, ofShape, nullptr, textured, coloured, *number},
                       from.name);
    }

    Json placesOf(const ExportCopies& from)
    {
        std::vector<glm::vec3> places, sizes, tints;
        std::vector<glm::vec4> turns;
        for (const ExportCopy& copy : from.copies) {
            const double size = glm::length(glm::dvec3(copy.place[0]));
            const glm::dquat turn = glm::normalize(glm::quat_cast(glm::dmat3(copy.place) / size));
            places.emplace_back(copy.place[3]);
            sizes.emplace_back(static_cast<float>(size));
            turns.emplace_back(turn.x, turn.y, turn.z, turn.w);
            tints.push_back(glb::linear(copy.tint));
        }
        const auto values = [this](auto& all, int bits) {
            return m_buffer.addFloats(all, bits, "VEC3", Target::None);
        };
        return {{"TRANSLATION", values(places, fineBits)},
                {"ROTATION", m_buffer.addTurns(turns)},
                {"SCALE", values(sizes, coarseBits)},
                {"_COLOR_0", values(tints, coarseBits)}};
    }

    /// They are in the space of the file already.
    void addLines(const LinePart& lines)
    {
        if (lines.lines.empty())
            return;
        std::vector<glm::vec3> places = lines.positions;
        const std::size_t positions = m_buffer.addPositions(places);
        const std::size_t indices = m_buffer.addAccessor(m_buffer.addValues(lines.lines, Target::Indices),
                                                         Number::Int, "SCALAR", 2 * lines.lines.size());
        constexpr int mode = 1; // LINES
        m_roots.push_back(m_nodes.size());
        m_nodes.push_back({{"name", lines.name}});
        m_nodes.back()["mesh"] = m_meshes.size();
        m_meshes.push_back({{"name", lines.name},
                            {"primitives", Json::array({{{"attributes", {{"POSITION", positions}}},
                                                         {"indices", indices},
                                                         {"mode", mode}}})}});
    }

    const ExportScene& m_scene;
    const WriteOptions& m_options;
    glb::Buffer m_buffer;
    glb::Materials m_materials;
    glb::Variants m_variants;
    glb::Animation m_animation;
    std::vector<Index> m_node; ///< per node of the scene that of the file, once it is there
    std::vector<Written> m_written;
    std::vector<std::pair<const ExportCopies*, Json>> m_placed; ///< with their attributes
    std::vector<std::size_t> m_meshNode; ///< per mesh of the scene its node in the file
    std::map<Index, std::pair<std::size_t, glb::Joints>> m_skinOf; ///< per node of the scene
    Json m_roots = Json::array(), m_nodes = Json::array(), m_meshes = Json::array(), m_skins = Json::array();
    bool m_hasManifold = false;
};

Expected<void> exportGlb(const std::string& path, const ExportScene& scene, const WriteOptions& options,
                         const Progress& progress)
{
    auto written = scene.space.isOwn()
                       ? GlbWriter(scene, options).run(path, progress)
                       : fail(ErrorCode::Invalid, RAMURE_NOOP("a GLB always has Y up and metres"));
    if (!written && written.error().file.empty())
        written.error().file = path;
    return written;
}

/// Places, normals, colours; with pictures there are coordinates and tangents.
FileRates glbRates(bool /*texture*/, double /*digits*/)
{
    return {31.5, 12.0};
}

} // namespace

extern const FileFormat glbFormat;
const FileFormat glbFormat = {
    .id = "glb",
    .ending = "glb",
    .name = RAMURE_NOOP("Binary glTF"),
    .choice = RAMURE_NOOP("GLB (glTF), with materials and motion"),
    .help = "glTF 2.0 with materials and pictures inside: nodes as in the scene, closed meshes told as such",
    .holds = holdsObjects | holdsTexture | holdsLines | holdsCopies | holdsClip | holdsLevels |
             holdsCompressed | holdsWind | holdsVariants | holdsShapes,
    .read = &readGlb,
    .import = &importGlb,
    .write = &exportGlb,
    .rates = &glbRates,
};

} // namespace ramure
