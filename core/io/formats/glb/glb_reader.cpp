#include "core/io/formats/glb/glb_reader.h"

#include "core/io/formats/glb/glb_arm_clip.h"
#include "core/io/formats/glb/glb_clip_reader.h"
#include "core/io/formats/glb/glb_nodes.h"
#include "core/io/formats/glb/glb_parts.h"
#include "core/io/formats/glb/glb_surfaces.h"
#include "core/io/formats/text/import_parts.h"
#include "core/io/mesh_mending.h"
#include "core/math/finite.h"
#include "core/rig/arm/arm_chain.h"
#include "core/scene/kinds/node_kinds.h"
#include "core/surface/mesh/transformed.h"

#include <algorithm>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <set>

namespace ramure {
namespace {

using glb::FileNode;
using glb::ReadGlbMesh;

tl::unexpected<Error> cancelled()
{
    return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
}

/// What large numbers of several nodes make of a mesh may be none.
Expected<TriangleMesh> placed(const TriangleMesh& mesh, const glm::dmat4& matrix, const std::string& name)
{
    TriangleMesh out = matrix == glm::dmat4(1.0) ? mesh : transformed(mesh, matrix);
    if (!std::ranges::all_of(out.positions, &isFinite<3, float>))
        return fail(ErrorCode::Invalid, RAMURE_NOOP("a coordinate of %1 is not a finite number"), {name});
    if (!std::ranges::all_of(out.normals, &isFinite<3, float>))
        out.normals.clear();
    return out;
}

/// \param tint linear; what is no number tints nothing
TriangleMesh tinted(TriangleMesh mesh, const glm::vec3& tint)
{
    if (tint == glm::vec3(1.0F) || !isFinite<3, float>(tint))
        return mesh;
    for (glm::u8vec3& colour : mesh.colours)
        colour =
            glb::srgb(tint * glm::vec3(glb::linear(colour.r), glb::linear(colour.g), glb::linear(colour.b)));
    return mesh;
}

/// A GLB with its meshes, each read once.
class GlbScene
{
public:
    static Expected<GlbScene> open(const std::string& path, const Progress& progress)
    {
        auto file = glb::File::open(path, progress.part(0.0, 0.3));
        RAMURE_TRY(file);
        GlbScene out(std::move(*file));
        auto nodes = glb::nodesOf(out.file);
        RAMURE_TRY(nodes);
        out.nodes = std::move(*nodes);
        return out;
    }

    Expected<const ReadGlbMesh*> mesh(std::size_t number)
    {
        auto found = m_meshes.find(number);
        if (found == m_meshes.end()) {
            auto read = glb::readGlbMesh(file, number);
            RAMURE_TRY(read);
            found = m_meshes.emplace(number, std::move(*read)).first;
        }
        return &found->second;
    }
    /// Of the materials of all primitives.
    Expected<std::vector<glb::Surface>> surfaces(const ReadGlbMesh& mesh) const
    {
        std::vector<glb::Surface> out;
        for (const glb::Primitive& primitive : mesh.primitives) {
            auto surface = glb::surfaceOf(file, primitive.material);
            RAMURE_TRY(surface);
            out.push_back(*surface);
        }
        return out;
    }
    /// The mesh in the pose of its joints, in the world, where it has a skin.
    Expected<ReadGlbMesh> posed(const FileNode& node)
    {
        const auto own = mesh(*node.mesh);
        RAMURE_TRY(own);
        ReadGlbMesh out = **own;
        if (!node.skin)
            return out;
        const auto joints = glb::jointMatrices(file, nodes, *node.skin);
        RAMURE_TRY(joints);
        RAMURE_TRY(glb::applySkin(out, *joints, glb::placeOf("skins", *node.skin)));
        return out;
    }
    /// Some of a mesh's primitives, once for each of the node's copies.
    Expected<TriangleMesh> copied(const FileNode& node, const ReadGlbMesh& mesh, std::size_t first,
                                  std::size_t count)
    {
        const auto colours = surfaces(mesh);
        RAMURE_TRY(colours);
        std::vector<glm::vec3> linear;
        for (const glb::Surface& surface : *colours)
            linear.push_back(surface.colour);
        const std::string place = glb::placeOf("nodes", static_cast<std::size_t>(&node - nodes.all.data()));
        const auto copies = glb::copiesOf(file, node, place);
        RAMURE_TRY(copies);
        TriangleMesh one = glb::joinedMesh(mesh, first, count, linear);
        if (one.colours.empty()) // all of one colour
            one.colours.assign(one.triangles.size(), glb::srgb(linear[first]));
        m_triangles += copies->size() * one.triangles.size();
        if (m_triangles > glb::mostTriangles)
            return glb::wrong(place, RAMURE_NOOP("more than %1 triangles"),
                              {std::to_string(glb::mostTriangles)}, ErrorCode::Limit);
        if (copies->size() == 1)
            return placed(tinted(one, copies->front().tint), copies->front().place, node.name);
        ReadMesh out;
        for (const glb::FileCopy& copy : *copies)
            if (auto there = placed(tinted(one, copy.tint), copy.place, node.name))
                out.objects.push_back({{}, std::move(*there), {}});
            else
                return there;
        return out.objects.empty() ? TriangleMesh() : out.joined();
    }

    glb::File file;
    glb::FileNodes nodes;

private:
    explicit GlbScene(glb::File opened)
        : file(std::move(opened))
    {
    }

    std::map<std::size_t, ReadGlbMesh> m_meshes;
    std::size_t m_triangles = 0;
};

/// The scene of a file as nodes of ours.
class SceneReader
{
public:
    SceneReader(GlbScene& scene, const std::string& path, const Progress& progress)
        : m_scene(scene)
        , m_path(path)
        , m_progress(progress)
        , m_pictures(scene.file, path)
        , m_own(scene.nodes.all.size())
    {
    }

    Expected<BlenderImport> run()
    {
        auto clip = glb::readClip(m_scene.file, m_scene.nodes);
        RAMURE_TRY(clip);
        m_clip = std::move(*clip);
        RAMURE_TRY(findJoints());
        double done = 0.0;
        for (const Index number : m_scene.nodes.inScene) {
            m_progress.report(0.3 + 0.7 * done++ / double(m_scene.nodes.inScene.size()));
            if (m_progress.cancelled())
                return cancelled();
            RAMURE_TRY(add(number));
        }
        // Where they stand is known when their joints are.
        for (const Index number : m_scene.nodes.inScene)
            if (m_scene.nodes.all[number].mesh && m_scene.nodes.all[number].skin)
                RAMURE_TRY(addSkinned(number));
        if (m_out.nodes.empty())
            return fail(ErrorCode::Invalid, RAMURE_NOOP("the file shows no mesh, no camera and no node"));
        const auto isGroup = [](const Node& node) { return node.kind == NodeKind::Group; };
        if (m_hasBareMesh && std::ranges::all_of(m_out.nodes, isGroup))
            return fail(ErrorCode::Invalid,
                        RAMURE_NOOP("the meshes of the file have no triangles: there is no surface to read"));
        tell();
        hang();
        return std::move(m_out);
    }

private:
    /// What became of a node of the file.
    struct Own
    {
        NodeId id = noNode;   ///< noNode: it is not there, and its children hang above it
        glm::dmat4 rest{1.0}; ///< what its children have to take on, as no placement says it
        bool isJoint = false, isNeeded = false, holdsOthers = false;
    };

    void note(const char* text, std::vector<std::string> args = {}, ErrorCode code = ErrorCode::Invalid)
    {
        Note note = fail(code, text, std::move(args)).value();
        note.file = m_path;
        m_out.notes.push_back(std::move(note));
    }

    /// Joints are no groups, unless something else hangs on them.
    Expected<void> findJoints()
    {
        const std::vector<FileNode>& all = m_scene.nodes.all;
        for (std::size_t skin = 0; skin < m_scene.file.list("skins").size(); ++skin) {
            const auto joints = glb::jointsOf(m_scene.file, m_scene.nodes, skin);
            RAMURE_TRY(joints);
            for (const Index joint : *joints)
                m_own[joint].isJoint = true;
        }
        const std::vector<Index>& order = m_scene.nodes.inScene;
        for (auto it = order.rbegin(); it != order.rend(); ++it) {
            Own& own = m_own[*it];
            own.isNeeded = own.isNeeded || !own.isJoint || all[*it].mesh || all[*it].camera;
            if (own.isNeeded && all[*it].parent != noIndex)
                m_own[all[*it].parent].isNeeded = m_own[all[*it].parent].holdsOthers = true;
        }
        return {};
    }

    /// The node of ours that a node of the file hangs below.
    [[nodiscard]] NodeId above(Index number) const
    {
        for (Index at = m_scene.nodes.all[number].parent; at != noIndex; at = m_scene.nodes.all[at].parent)
            if (m_own[at].id != noNode)
                return m_own[at].id;
        return noNode;
    }

    Node& addNode(NodeKind kind, const std::string& name, NodeId parent)
    {
        Node& node = m_out.nodes.emplace_back();
        node.id = static_cast<NodeId>(m_out.nodes.size());
        node.kind = kind;
        node.name = name;
        node.parent = parent;
        return node;
    }

    Expected<void> add(Index number)
    {
        if (!m_own[number].isNeeded)
            return {};
        const FileNode& from = m_scene.nodes.all[number];
        if (from.mesh && from.skin && !m_own[number].holdsOthers && !from.camera)
            return {};
        const bool hasMesh = from.mesh && !from.skin;
        const bool isCamera = !hasMesh && from.camera;
        addNode(isCamera ? NodeKind::Camera : NodeKind::Group, from.name, above(number));
        const std::size_t at = m_out.nodes.size() - 1;
        m_own[number].id = m_out.nodes[at].id;
        place(number, m_out.nodes[at]);
        if (from.camera)
            if (auto added = addCamera(number, at); !added)
                return added;
        return hasMesh ? addMesh(number, at) : Expected<void>();
    }

    /// Keys say where it stands, else its placement; what none can say is left to its mesh and its children.
    void place(Index number, Node& node)
    {
        const FileNode& from = m_scene.nodes.all[number];
        const glm::dmat4 rest = from.parent == noIndex ? glm::dmat4(1.0) : m_own[from.parent].rest;
        if (const auto moves = m_clip.moves.find(number); moves != m_clip.moves.end()) {
            node.animation = moves->second;
            m_own[number].rest = glm::dmat4(1.0);
            return;
        }
        const glm::dmat4 local = rest * from.local;
        if (const auto placement = placementNear(local)) {
            NodeParams params;
            params.tree = *placement;
            if (checkParams(params)) {
                node.params.tree = *placement;
                return;
            }
        }
        m_own[number].rest = local;
        note(
            RAMURE_NOOP("%1 is sheared, mirrored or flat: its children took over this part of the transform"),
            {node.name});
    }

    Expected<void> addCamera(Index number, std::size_t at)
    {
        const FileNode& from = m_scene.nodes.all[number];
        const std::string inside = glb::placeOf("cameras", *from.camera);
        const auto json = m_scene.file.element("cameras", from.camera, inside);
        RAMURE_TRY(json);
        if (m_out.nodes[at].kind != NodeKind::Camera)
            at = addNode(NodeKind::Camera, from.name + " camera", m_out.nodes[at].id).id - 1;
        const glb::Json* lens = glb::member(**json, "perspective");
        double angle[1] = {CameraParams().angleRad};
        if (const glb::Json* own = lens ? glb::member(*lens, "yfov") : nullptr; own && own->is_number())
            angle[0] = own->get<double>();
        NodeParams params = m_out.nodes[at].params;
        params.camera.angleRad = angle[0];
        if (!checkParams(params))
            params.camera.angleRad = CameraParams().angleRad;
        if (!lens || params.camera.angleRad != angle[0])
            note(RAMURE_NOOP("the camera %1 has no angle that can be kept: it gets the usual one"),
                 {from.name});
        m_out.nodes[at].params = std::move(params);
        return {};
    }

    Expected<void> addMesh(Index number, std::size_t at)
    {
        const auto mesh = m_scene.mesh(*m_scene.nodes.all[number].mesh);
        return mesh ? fill(number, **mesh, at) : fail(mesh.error());
    }

    /// One node where one will do: pictures are of a whole node.
    Expected<void> fill(Index number, const ReadGlbMesh& mesh, std::size_t at)
    {
        const auto surfaces = m_scene.surfaces(mesh);
        RAMURE_TRY(surfaces);
        tellOf(mesh);
        const std::size_t count = mesh.primitives.size();
        m_hasBareMesh = m_hasBareMesh || count == 0;
        const bool isOne = count <= 1 || std::ranges::none_of(*surfaces, &glb::Surface::hasPictures);
        const NodeId top = m_out.nodes[at].id;
        for (std::size_t p = 0; p < (isOne ? std::min<std::size_t>(count, 1) : count); ++p) {
            const FileNode& from = m_scene.nodes.all[number];
            auto joined = m_scene.copied(from, mesh, p, isOne ? count : 1);
            RAMURE_TRY(joined);
            joined = placed(*joined, m_own[number].rest, from.name);
            RAMURE_TRY(joined);
            if (joined->empty()) // of no copies
                continue;
            Node& node =
                isOne ? m_out.nodes[at]
                      : addNode(NodeKind::Mesh, m_out.nodes[at].name + " " + std::to_string(p + 1), top);
            node.kind = NodeKind::Mesh;
            dress(node, std::move(*joined), mesh.primitives[p].material, (*surfaces)[p].hasPictures);
        }
        return {};
    }

    /// One colour for all is the node's own.
    void dress(Node& node, TriangleMesh mesh, std::optional<std::size_t> material, bool hasPictures)
    {
        const auto isFirst = [&](const glm::u8vec3& colour) { return colour == mesh.colours.front(); };
        const bool isOne = std::ranges::all_of(mesh.colours, isFirst);
        node.params.surface.color = isOne ? glm::dvec3(mesh.colours.front()) / 255.0 : glm::dvec3(1.0);
        if (isOne)
            mesh.colours.clear();
        if (hasPictures)
            node.params.surfacePictures = m_pictures.write(*material, m_out.notes);
        if (node.kind == NodeKind::Mesh)
            moveNear(node, mesh);
        node.mesh = SharedValue<TriangleMesh>(std::move(mesh));
    }

    /// What is far from its own origin is moved there, and the node's own position holds it where it was.
    void moveNear(Node& node, TriangleMesh& mesh)
    {
        const glm::dvec3 origin = reading::farOrigin(mesh.positions);
        if (origin == glm::dvec3(0.0))
            return;
        for (glm::vec3& p : mesh.positions)
            p = glm::vec3(glm::dvec3(p) - origin);
        NodeParams params = node.params;
        params.local.translation = origin;
        if (checkParams(params))
            node.params = std::move(params);
        note("%1", {node.name + ": " + reading::farNote(origin)});
    }

    /// Skins say where a mesh stands, not its node.
    Expected<void> addSkinned(Index number)
    {
        const FileNode& from = m_scene.nodes.all[number];
        const auto own = m_scene.mesh(*from.mesh);
        RAMURE_TRY(own);
        const auto asArm = addArm(number, **own);
        RAMURE_TRY(asArm);
        if (*asArm)
            return {};
        auto posed = m_scene.posed(from);
        RAMURE_TRY(posed);
        addNode(NodeKind::Mesh, from.name, noNode);
        note(RAMURE_NOOP("the joints of %1 make no arm: it stays a mesh, in the pose of the first frame"),
             {from.name});
        const glm::dmat4 rest = std::exchange(m_own[number].rest, glm::dmat4(1.0));
        auto filled = fill(number, *posed, m_out.nodes.size() - 1);
        m_own[number].rest = rest;
        return filled;
    }

    /// False where the joints are no chain.
    Expected<bool> addArm(Index number, ReadGlbMesh mesh)
    {
        const FileNode& from = m_scene.nodes.all[number];
        const auto joints = glb::jointsOf(m_scene.file, m_scene.nodes, *from.skin);
        RAMURE_TRY(joints);
        auto binds = glb::inverseBinds(m_scene.file, *from.skin, joints->size());
        RAMURE_TRY(binds);
        glb::Chain chain;
        chain.order = glb::chainOf(parentsOf(*joints));
        const bool isSkinned = std::ranges::all_of(
            mesh.primitives, [](const glb::Primitive& primitive) { return !primitive.joints.empty(); });
        if (chain.order.empty() || !isSkinned || mesh.primitives.empty())
            return false;
        const Index foot = (*joints)[chain.order.front()], parent = m_scene.nodes.all[foot].parent;
        const glm::dmat4 into =
            parent == noIndex ? glm::dmat4(1.0) : glm::inverse(m_scene.nodes.all[parent].world);
        std::vector<Index> ordered;
        for (const Index joint : chain.order) {
            chain.binds.push_back(glm::inverse((*binds)[joint]));
            ordered.push_back((*joints)[joint]);
            chain.transforms.push_back(into * m_scene.nodes.all[ordered.back()].world);
        }
        const auto arm = glb::armOf(chain, mesh, glb::placeOf("skins", *from.skin));
        if (!arm)
            return false;
        const glm::dmat4 rest = parent == noIndex ? glm::dmat4(1.0) : m_own[parent].rest;
        const auto placement = placementNear(rest * arm->place);
        if (!placement || !checkArm(arm->joints))
            return false;
        NodeParams params;
        kindRow(NodeKind::Arm).begin(params);
        params.tree = *placement;
        params.joints = arm->joints;
        params.skin.method = SkinMethod::Linear; // as every reader of a GLB blends
        params.armSkin.window = arm->window;
        if (!checkParams(params))
            params.armSkin.window = ArmSkinParams().window;
        params.arm.target = ArmChain(arm->joints).tip();
        if (!checkParams(params)) // too far away, or too large
            return false;
        Node& node = addNode(NodeKind::Arm, from.name, above(foot));
        node.animation = glb::armTracks(*arm, chain, m_scene.nodes, m_clip, ordered);
        params.arm.follows = node.animation.empty();
        node.params = std::move(params);
        return wear(node, mesh);
    }

    /// What an arm wears stands where the straight arm has it.
    Expected<bool> wear(Node& node, const ReadGlbMesh& mesh)
    {
        const auto surfaces = m_scene.surfaces(mesh);
        RAMURE_TRY(surfaces);
        std::vector<glm::vec3> colours;
        for (const glb::Surface& surface : *surfaces)
            colours.push_back(surface.colour);
        TriangleMesh worn = glb::joinedMesh(mesh, 0, mesh.primitives.size(), colours);
        if (worn.colours.empty())
            worn.colours.assign(worn.triangles.size(), glb::srgb(colours.front()));
        auto finite = placed(worn, glm::dmat4(1.0), node.name);
        RAMURE_TRY(finite);
        dress(node, std::move(*finite), mesh.primitives.front().material, false);
        return true;
    }

    /// Of each joint the nearest joint above it.
    [[nodiscard]] std::vector<Index> parentsOf(const std::vector<Index>& joints) const
    {
        std::vector<Index> placeOf(m_scene.nodes.all.size(), noIndex), out;
        for (std::size_t i = 0; i < joints.size(); ++i)
            placeOf[joints[i]] = static_cast<Index>(i);
        for (const Index joint : joints) {
            Index at = m_scene.nodes.all[joint].parent;
            while (at != noIndex && placeOf[at] == noIndex)
                at = m_scene.nodes.all[at].parent;
            out.push_back(at == noIndex ? noIndex : placeOf[at]);
        }
        return out;
    }

    void tellOf(const ReadGlbMesh& mesh)
    {
        for (const std::string& text : mesh.notes)
            if (m_told.insert(text).second)
                note("%1", {text});
    }
    void tell()
    {
        if (m_pictures.count() > 0)
            note(RAMURE_NOOP("%1 pictures of materials are in %2 now"),
                 {std::to_string(m_pictures.count()), m_pictures.folder()}, remark);
        const auto hasLevels = [](const FileNode& node) {
            const glb::Json* extensions = glb::member(*node.json, "extensions");
            return extensions && glb::member(*extensions, "MSFT_lod");
        };
        if (std::ranges::any_of(m_scene.nodes.all, hasLevels))
            note(RAMURE_NOOP("only the finest level of detail is taken"), {}, remark);
        for (const std::string& text : m_scene.file.notes())
            note("%1", {text});
        for (Note& said : m_clip.notes)
            m_out.notes.push_back(std::move(said));
        m_out.keyCount = 0;
        for (const Node& node : m_out.nodes)
            for (const auto& [channel, track] : node.animation.tracks())
                m_out.keyCount += keyCount(*track);
        if (m_out.keyCount > 0)
            m_out.timeline = timelineOfKeys(m_out.nodes, 0.0, m_out.notes);
    }
    void hang()
    {
        if (std::ranges::count(m_out.nodes, noNode, &Node::parent) > 1) {
            const NodeId top = static_cast<NodeId>(m_out.nodes.size() + 1);
            for (Node& node : m_out.nodes)
                if (node.parent == noNode)
                    node.parent = top;
            addNode(NodeKind::Group, std::filesystem::path(m_path).stem().string(), noNode);
        }
        // The top first, parents before their children.
        m_out.nodes = Scene::fromNodes(std::move(m_out.nodes))->nodes();
    }

    GlbScene& m_scene;
    const std::string& m_path;
    const Progress& m_progress;
    glb::PictureFolder m_pictures;
    glb::Clip m_clip;
    std::vector<Own> m_own; ///< by the nodes of the file
    std::set<std::string> m_told;
    bool m_hasBareMesh = false; ///< one without triangles
    BlenderImport m_out;
};

template <class T> Expected<T> inFile(Expected<T> result, const std::string& path)
{
    if (!result && result.error().file.empty())
        result.error().file = path;
    return result;
}

/// Where single precision holds the shape of a mesh in the world.
glm::dvec3 originOf(const TriangleMesh& mesh, const glm::dmat4& world)
{
    std::vector<glm::dvec3> positions;
    positions.reserve(mesh.positions.size());
    for (const glm::vec3& p : mesh.positions)
        positions.emplace_back(world * glm::dvec4(p, 1.0));
    return reading::farOrigin(positions);
}

Expected<ReadMesh> allMeshes(GlbScene& scene, const std::string& path, const Progress& progress)
{
    ReadMesh out;
    out.notes = scene.file.notes();
    bool isFirst = true;
    double done = 0.0;
    for (const Index number : scene.nodes.inScene) {
        progress.report(0.3 + 0.7 * done++ / double(scene.nodes.inScene.size()));
        if (progress.cancelled())
            return cancelled();
        const FileNode& node = scene.nodes.all[number];
        if (!node.mesh)
            continue;
        const auto posed = scene.posed(node);
        RAMURE_TRY(posed);
        out.notes.insert(out.notes.end(), posed->notes.begin(), posed->notes.end());
        if (posed->primitives.empty())
            continue;
        auto mesh = scene.copied(node, *posed, 0, posed->primitives.size());
        RAMURE_TRY(mesh);
        const glm::dmat4 world = node.skin ? glm::dmat4(1.0) : node.world;
        if (std::exchange(isFirst, false))
            out.origin = originOf(*mesh, world);
        mesh = placed(*mesh, glm::translate(glm::dmat4(1.0), -out.origin) * world, node.name);
        RAMURE_TRY(mesh);
        if (!mesh->empty()) // of no copies
            out.objects.push_back({node.name, std::move(*mesh), {}});
    }
    if (out.objects.empty())
        return fail(ErrorCode::Invalid, RAMURE_NOOP("%1 shows no mesh"), {path});
    if (out.origin != glm::dvec3(0.0))
        out.notes.push_back(reading::farNote(out.origin));
    return out;
}

} // namespace

Expected<ReadMesh> readGlb(const std::string& path, const Progress& progress)
{
    auto scene = GlbScene::open(path, progress);
    if (!scene)
        return inFile<ReadMesh>(fail(std::move(scene.error())), path);
    return inFile(allMeshes(*scene, path, progress), path);
}

Expected<BlenderImport> importGlb(const std::string& path, const ImportOptions& options,
                                  const Progress& progress)
{
    if (options.space && !options.space->isOwn())
        return inFile<BlenderImport>(
            fail(ErrorCode::Invalid, RAMURE_NOOP("a GLB always has Y up and metres")), path);
    auto scene = GlbScene::open(path, progress);
    if (!scene)
        return inFile<BlenderImport>(fail(std::move(scene.error())), path);
    return inFile(SceneReader(*scene, path, progress).run(), path);
}

} // namespace ramure
