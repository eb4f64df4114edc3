#include "core/io/formats/usd/usd_reader.h"

#include "core/io/formats/glb/glb_mesh_reader.h"
#include "core/io/formats/text/import_parts.h"
#include "core/io/formats/usd/usd_places.h"
#include "core/io/formats/usd/usd_shape.h"
#include "core/io/formats/usd/usd_stage.h"
#include "core/io/mesh_mending.h"
#include "core/io/read_parts.h"
#include "core/math/finite.h"
#include "core/math/reproducible.h"
#include "core/params/param_def.h"
#include "core/surface/mesh/transformed.h"

#include <algorithm>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <set>

namespace ramure {
namespace {

using usd::Prim;
using usd::Shape;

tl::unexpected<Error> cancelled()
{
    return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
}

/// What stands in the place of faces: those of one material.
struct Piece
{
    std::string material;
    std::string name; ///< of the subset; empty: of all that is left
    TriangleMesh mesh;
};

bool isSeen(const Prim& prim)
{
    const std::string purpose = prim.text("purpose");
    const auto active = prim.metadata.find("active");
    const bool isOff = active != prim.metadata.end() && !active->second.texts.empty() &&
                       active->second.texts.front() == "false";
    return prim.specifier == usd::Specifier::Def && !isOff && prim.text("visibility") != "invisible" &&
           purpose != "guide" && purpose != "proxy";
}

bool isShape(const Prim& prim)
{
    return usd::isSurface(prim) || prim.type == "PointInstancer" || prim.type == "Camera";
}

bool hasShape(const Prim& prim)
{
    return isSeen(prim) && (isShape(prim) || std::ranges::any_of(prim.children, [](const auto& child) {
                                return hasShape(*child);
                            }));
}

std::string titleOf(const Prim& prim)
{
    const std::string said = prim.said("displayName");
    return said.empty() ? prim.name : said;
}

/// The triangles of one piece, with the vertices that they have.
TriangleMesh partOf(const TriangleMesh& mesh, const std::vector<bool>& isTaken)
{
    TriangleMesh out;
    std::vector<Index> numbers(mesh.positions.size(), noIndex);
    const bool perCorner = !mesh.uvTriangles.empty();
    if (perCorner)
        out.uv = mesh.uv;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (!isTaken[i])
            continue;
        glm::uvec3 triangle;
        for (int k = 0; k < 3; ++k) {
            const Index vertex = mesh.triangles[i][k];
            if (numbers[vertex] == noIndex) {
                numbers[vertex] = out.vertexCount();
                out.positions.push_back(mesh.positions[vertex]);
                if (!mesh.normals.empty())
                    out.normals.push_back(mesh.normals[vertex]);
                if (!mesh.uv.empty() && !perCorner)
                    out.uv.push_back(mesh.uv[vertex]);
            }
            triangle[k] = numbers[vertex];
        }
        out.triangles.push_back(triangle);
        if (perCorner)
            out.uvTriangles.push_back(mesh.uvTriangles[i]);
        if (!mesh.colours.empty())
            out.colours.push_back(mesh.colours[i]);
    }
    return out;
}

/// The prims of a file as nodes of ours.
class StageReader
{
public:
    StageReader(usd::OpenStage& opened, const std::string& path, bool isForPictures, const Progress& progress)
        : m_opened(opened)
        , m_root(opened.layer.root)
        , m_path(path)
        , m_progress(progress)
        , m_looks(m_root, opened.pictures, isForPictures)
    {
    }

    Expected<BlenderImport> run()
    {
        std::vector<const Prim*> tops;
        for (const auto& child : m_root.children)
            if (hasShape(*child))
                tops.push_back(child.get());
        std::set<std::string> others(m_opened.notes.begin(), m_opened.notes.end());
        if (tops.empty() && !others.empty())
            return fail(ErrorCode::Invalid,
                        RAMURE_NOOP("the file shows no mesh of its own, only those of other files: %1"),
                        {*others.begin()});
        if (tops.empty())
            return fail(ErrorCode::Invalid, RAMURE_NOOP("the file shows no mesh and no camera"));
        RAMURE_TRY(readSpace());
        NodeId top = noNode;
        if (tops.size() > 1) { // one subtree
            Node& group = addNode(NodeKind::Group, std::filesystem::path(m_path).stem().string(), noNode);
            top = group.id;
            place(group, m_space, m_space);
        }
        for (const Prim* prim : tops)
            RAMURE_TRY(add(*prim, top, {}, m_space));
        tell();
        return std::move(m_out);
    }

private:
    void note(const char* text, std::vector<std::string> args = {}, ErrorCode code = ErrorCode::Invalid)
    {
        Note note = fail(code, text, std::move(args)).value();
        note.file = m_path;
        m_out.notes.push_back(std::move(note));
    }

    /// From the space of the file into the program's.
    Expected<void> readSpace()
    {
        FileSpace space;
        const std::string up = m_root.said("upAxis");
        if (!up.empty() && up != "Y" && up != "Z")
            return fail(ErrorCode::Invalid, RAMURE_NOOP("\"%1\" is no axis that points up"), {up});
        space.up = up == "Z" ? UpAxis::Z : UpAxis::Y;
        m_metres = 0.01; // where nothing is said
        if (const auto said = m_root.metadata.find("metersPerUnit");
            said != m_root.metadata.end() && !said->second.numbers.empty())
            m_metres = said->second.numbers.front();
        if (!(m_metres >= 1e-9 && m_metres <= 1e9))
            return fail(ErrorCode::Invalid, RAMURE_NOOP("the unit of the file is no length"));
        m_space = glm::scale(glm::inverse(space.matrix()), glm::dvec3(m_metres));
        return {};
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

    /// Gives a node its place. \param rest becomes what its mesh and its children have to take on, as no
    /// placement says it
    void place(Node& node, const glm::dmat4& local, glm::dmat4& rest)
    {
        if (const auto placement = placementNear(local)) {
            NodeParams params;
            params.tree = *placement;
            if (checkParams(params)) {
                node.params.tree = *placement;
                rest = glm::dmat4(1.0);
                return;
            }
        }
        rest = local;
        note(
            RAMURE_NOOP("%1 is sheared, mirrored or flat: its children took over this part of the transform"),
            {node.name});
    }

    /// \param material of what is above \param before what has to be taken on from above
    Expected<void> add(const Prim& prim, NodeId parent, std::string material, const glm::dmat4& before,
                       const std::string& title = {})
    {
        if (m_progress.cancelled())
            return cancelled();
        if (!hasShape(prim)) {
            m_leftOut = m_leftOut || (!isSeen(prim) && prim.specifier == usd::Specifier::Def);
            return {};
        }
        m_progress.report(0.4 + 0.6 * double(m_out.nodes.size() % 1000) / 1000.0);
        material = boundTo(prim, std::move(material));
        auto local = usd::placeOf(prim, m_operations);
        RAMURE_TRY(local);
        local = before * *local;
        const std::string name = title.empty() ? titleOf(prim) : title;
        if (const Prim* only = onlyChild(prim))
            return add(*only, parent, material, *local, name);
        // What holds a single thing and all of it has nothing to say.
        const auto isOnly = [](const auto& child) { return hasShape(*child); };
        if (parent == noNode && !isShape(prim) && std::ranges::count_if(prim.children, isOnly) == 1)
            return add(**std::ranges::find_if(prim.children, isOnly), parent, material, *local);
        Node& node = addNode(prim.type == "Camera" ? NodeKind::Camera : NodeKind::Group, name, parent);
        const NodeId id = node.id;
        glm::dmat4 rest(1.0);
        place(node, *local, rest);
        if (prim.type == "Camera")
            addCamera(node, prim);
        if (prim.type == "PointInstancer")
            return addCopies(prim, id, material, rest);
        if (usd::isSurface(prim))
            RAMURE_TRY(addMesh(prim, id, material, rest));
        for (const auto& child : prim.children)
            RAMURE_TRY(add(*child, id, material, rest));
        return {};
    }

    /// A mesh or a camera alone in a group is that node itself, where it stands in its origin.
    [[nodiscard]] const Prim* onlyChild(const Prim& prim)
    {
        const Prim* only = nullptr;
        for (const auto& child : prim.children)
            if (hasShape(*child)) {
                if (only)
                    return nullptr;
                only = child.get();
            }
        const bool isGroup = !isShape(prim) && only && (isShape(*only) || onlyChild(*only)) &&
                             !(only->attribute("xformOpOrder"));
        return isGroup ? only : nullptr;
    }

    [[nodiscard]] static std::string boundTo(const Prim& prim, std::string above)
    {
        const auto bound = prim.relations.find("material:binding");
        return bound == prim.relations.end() || bound->second.empty() ? above : bound->second.front();
    }

    void addCamera(Node& node, const Prim& prim)
    {
        const auto number = [&](const char* name, double usual) {
            const auto found = usd::numbersOf(prim, name, 1);
            return found && !found->empty() ? found->front() : usual;
        };
        const double film = number("verticalAperture", 15.2908), focal = number("focalLength", 50.0);
        NodeParams params = node.params;
        params.camera.angleRad = 2.0 * maths::atan2(0.5 * film, focal);
        if (checkParams(params))
            node.params = params;
        else
            note(RAMURE_NOOP("the camera %1 has no angle that can be kept: it gets the usual one"),
                 {node.name});
        params.camera.fStop = number("fStop", 0.0);
        params.camera.focus = m_metres * number("focusDistance", 0.0);
        if (params.camera.fStop > 0.0 && checkParams(params)) // else everything is sharp
            node.params = std::move(params);
    }

    /// The faces of a mesh, those of each material together where pictures make that matter.
    Expected<std::vector<Piece>> piecesOf(const Prim& prim, const std::string& material)
    {
        auto shape = usd::shapeOf(prim);
        RAMURE_TRY(shape);
        for (const std::string& text : shape->notes)
            note("%1", {prim.name + ": " + text});
        const std::string scheme = prim.text("subdivisionScheme");
        if (prim.type == "Mesh" && scheme != "none" && scheme != "bilinear")
            m_isSmooth = true;
        m_hasSkin = m_hasSkin || prim.attribute("primvars:skel:jointIndices");
        std::vector<Piece> out{{material, {}, {}}};
        std::vector<std::size_t> of(shape->faces, 0);
        for (const auto& child : prim.children) {
            if (child->type != "GeomSubset" || child->text("elementType") != "face")
                continue;
            const auto faces = usd::indicesOf(*child, "indices", shape->faces);
            RAMURE_TRY(faces);
            for (const Index face : *faces)
                of[face] = out.size();
            out.push_back({boundTo(*child, material), child->name, {}});
        }
        for (std::size_t piece = 0; piece < out.size(); ++piece) {
            std::vector<bool> isTaken;
            for (const Index face : shape->faceOf)
                isTaken.push_back(of[face] == piece);
            out[piece].mesh = out.size() == 1 ? std::move(shape->mesh) : partOf(shape->mesh, isTaken);
            colour(out[piece]);
        }
        std::erase_if(out, [](const Piece& piece) { return piece.mesh.empty(); });
        return out;
    }

    /// Colours of faces are those of the mesh only where the material reads them, or where there is none.
    void colour(Piece& piece)
    {
        const usd::Look& look = m_looks.of(piece.material, m_out.notes);
        if (!piece.material.empty() && !look.readsColours)
            piece.mesh.colours.assign(piece.mesh.triangles.size(), glb::srgb(look.colour));
    }

    /// \param id of the node that is there for it
    Expected<void> addMesh(const Prim& prim, NodeId id, const std::string& material, const glm::dmat4& rest)
    {
        auto pieces = piecesOf(prim, material);
        RAMURE_TRY(pieces);
        return addPieces(std::move(*pieces), id, rest);
    }

    Expected<void> addPieces(std::vector<Piece> pieces, NodeId id, const glm::dmat4& rest)
    {
        const auto hasPictures = [&](const Piece& piece) {
            return m_looks.of(piece.material, m_out.notes).hasPictures;
        };
        const std::string name = m_out.nodes[id - 1].name;
        if (pieces.size() > 1 && std::ranges::none_of(pieces, hasPictures)) {
            ReadMesh all;
            for (Piece& piece : pieces)
                all.objects.push_back({{}, std::move(piece.mesh), {}});
            pieces = {{pieces.front().material, {}, all.joined()}};
        }
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            TriangleMesh mesh =
                rest == glm::dmat4(1.0) ? std::move(pieces[i].mesh) : transformed(pieces[i].mesh, rest);
            if (!std::ranges::all_of(mesh.positions, &isFinite<3, float>))
                return fail(ErrorCode::Invalid, RAMURE_NOOP("a coordinate of %1 is not a finite number"),
                            {name});
            if (!std::ranges::all_of(mesh.normals, &isFinite<3, float>))
                mesh.normals.clear();
            m_triangles += mesh.triangles.size();
            if (m_triangles > usd::mostTriangles)
                return fail(ErrorCode::Limit, RAMURE_NOOP("more than %1 triangles"),
                            {std::to_string(usd::mostTriangles)});
            Node& node =
                i == 0 ? m_out.nodes[id - 1] : addNode(NodeKind::Mesh, name + " " + pieces[i].name, id);
            node.kind = NodeKind::Mesh;
            dress(node, std::move(mesh), m_looks.of(pieces[i].material, m_out.notes));
        }
        return {};
    }

    /// One colour for all is the node's own.
    static void dress(Node& node, TriangleMesh mesh, const usd::Look& look)
    {
        const auto isFirst = [&](const glm::u8vec3& colour) { return colour == mesh.colours.front(); };
        const bool isOne = std::ranges::all_of(mesh.colours, isFirst);
        if (!mesh.colours.empty())
            node.params.surface.color = isOne ? glm::dvec3(mesh.colours.front()) / 255.0 : glm::dvec3(1.0);
        if (isOne)
            mesh.colours.clear();
        node.params.surfacePictures = look.pictures;
        node.mesh = SharedValue<TriangleMesh>(std::move(mesh));
    }

    /// All meshes below a prototype, in the space of the instancer.
    Expected<void> gather(const Prim& prim, const glm::dmat4& above, std::string material,
                          std::vector<Piece>& out)
    {
        if (prim.type == "PointInstancer" || !isSeen(prim))
            return {};
        const auto own = usd::placeOf(prim, m_operations);
        RAMURE_TRY(own);
        const glm::dmat4 local = above * *own;
        material = boundTo(prim, std::move(material));
        if (usd::isSurface(prim)) {
            auto pieces = piecesOf(prim, material);
            RAMURE_TRY(pieces);
            for (Piece& piece : *pieces) {
                if (local != glm::dmat4(1.0))
                    piece.mesh = transformed(piece.mesh, local);
                out.push_back(std::move(piece));
            }
        }
        for (const auto& child : prim.children)
            RAMURE_TRY(gather(*child, local, material, out));
        return {};
    }

    Expected<void> addCopies(const Prim& prim, NodeId id, const std::string& material, const glm::dmat4& rest)
    {
        const auto copies = usd::copiesOf(prim);
        RAMURE_TRY(copies);
        std::vector<std::vector<Piece>> prototypes;
        if (const auto targets = prim.relations.find("prototypes"); targets != prim.relations.end())
            for (const std::string& target : targets->second) {
                const Prim* prototype = usd::primAt(m_root, target);
                if (!prototype)
                    return usd::wrongAttribute(prim, "prototypes", RAMURE_NOOP("there is no prim %1"),
                                               {target});
                RAMURE_TRY(gather(*prototype, glm::dmat4(1.0), material, prototypes.emplace_back()));
            }
        const auto tints = usd::numbersOf(prim, "primvars:displayColor", 3);
        RAMURE_TRY(tints);
        std::vector<Piece> all;
        for (std::size_t p = 0; p < prototypes.size(); ++p)
            for (const Piece& piece : prototypes[p]) {
                auto joined = copied(piece, *copies, p, *tints);
                RAMURE_TRY(joined);
                if (!joined->empty())
                    all.push_back({piece.material, piece.name, std::move(*joined)});
            }
        return addPieces(std::move(all), id, rest);
    }

    /// One mesh of all copies of a piece. \param tints of all copies, or none
    Expected<TriangleMesh> copied(const Piece& piece, const std::vector<usd::Copy>& copies,
                                  std::size_t prototype, const std::vector<double>& tints)
    {
        const auto count =
            static_cast<std::size_t>(std::ranges::count(copies, prototype, &usd::Copy::prototype));
        if (count * piece.mesh.triangles.size() > usd::mostTriangles)
            return fail(ErrorCode::Limit, RAMURE_NOOP("more than %1 triangles"),
                        {std::to_string(usd::mostTriangles)});
        const usd::Look& look = m_looks.of(piece.material, m_out.notes);
        const bool isTinted =
            tints.size() == 3 * copies.size() && (look.readsColours || piece.material.empty());
        ReadMesh all;
        for (std::size_t i = 0; i < copies.size(); ++i) {
            if (copies[i].prototype != prototype)
                continue;
            TriangleMesh one = transformed(piece.mesh, copies[i].place);
            if (isTinted)
                one.colours.assign(one.triangles.size(),
                                   glb::srgb(glm::vec3(tints[3 * i], tints[3 * i + 1], tints[3 * i + 2])));
            all.objects.push_back({{}, std::move(one), {}});
        }
        return all.objects.empty() ? TriangleMesh() : all.joined();
    }

    void tell()
    {
        for (const std::string& text : std::set(m_opened.notes.begin(), m_opened.notes.end()))
            note(RAMURE_NOOP("another file is not read: %1"), {text});
        std::set<std::string> types;
        for (const auto& child : m_root.children)
            gatherOthers(*child, types);
        for (const std::string& type : types)
            note(RAMURE_NOOP("a %1 is no mesh: it is left out"), {type});
        for (const std::string& text : std::set(m_operations.begin(), m_operations.end()))
            note(RAMURE_NOOP("a part of a place is left out: %1"), {text});
        if (m_hasSkin)
            note(RAMURE_NOOP("meshes with a skin are read as they rest, without their joints"), {}, remark);
        if (m_isSmooth)
            note(RAMURE_NOOP("surfaces of subdivision are read as the mesh that they are made of"), {},
                 remark);
        if (m_leftOut)
            note(RAMURE_NOOP("what the file hides is left out"), {}, remark);
        if (m_looks.written() > 0)
            note(RAMURE_NOOP("%1 pictures of materials are in %2 now"),
                 {std::to_string(m_looks.written()), m_opened.pictures.folder}, remark);
        if (std::ranges::any_of(m_root.children, [](const auto& child) { return hasSets(*child); }))
            note(RAMURE_NOOP("of variants only those are taken that the file chooses"), {}, remark);
        for (Note& each : m_out.notes)
            if (each.file.empty())
                each.file = m_path;
    }
    /// The types of shapes and lights that are not read.
    static void gatherOthers(const Prim& prim, std::set<std::string>& types)
    {
        static const std::set<std::string_view> known{
            "Capsule", "BasisCurves", "Points",    "NurbsCurves",  "NurbsPatch", "Volume",
            "TetMesh", "SphereLight", "DomeLight", "DistantLight", "RectLight",  "DiskLight"};
        if (isSeen(prim) && known.contains(prim.type))
            types.insert(prim.type);
        for (const auto& child : prim.children)
            gatherOthers(*child, types);
    }
    static bool hasSets(const Prim& prim)
    {
        return !prim.sets.empty() ||
               std::ranges::any_of(prim.children, [](const auto& child) { return hasSets(*child); });
    }

    usd::OpenStage& m_opened;
    const Prim& m_root;
    const std::string& m_path;
    const Progress& m_progress;
    usd::Looks m_looks;
    glm::dmat4 m_space{1.0};
    double m_metres = 1.0;
    std::size_t m_triangles = 0;
    std::vector<std::string> m_operations;
    bool m_hasSkin = false, m_isSmooth = false, m_leftOut = false;
    BlenderImport m_out;
};

template <class T> Expected<T> inFile(Expected<T> result, const std::string& path)
{
    if (!result && result.error().file.empty())
        result.error().file = path;
    return result;
}

Expected<BlenderImport> nodesOf(const std::string& path, bool isForPictures, const Progress& progress)
{
    auto opened = usd::openStage(path, progress);
    RAMURE_TRY(opened);
    return StageReader(*opened, path, isForPictures, progress).run();
}

Expected<ReadMesh> meshesOf(BlenderImport import)
{
    ReadMesh out;
    for (const Note& note : import.notes)
        out.notes.push_back(note.plain());
    const auto scene = Scene::fromNodes(std::move(import.nodes));
    RAMURE_TRY(scene);
    for (const Node& node : scene->nodes()) {
        if (node.kind != NodeKind::Mesh || !node.mesh)
            continue;
        TriangleMesh mesh = transformed(*node.mesh, geometryMatrix(*scene, node));
        if (!std::ranges::all_of(mesh.positions, &isFinite<3, float>))
            return fail(ErrorCode::Invalid, RAMURE_NOOP("a coordinate of %1 is not a finite number"),
                        {node.name});
        if (mesh.colours.empty())
            mesh.colours.assign(mesh.triangles.size(), glm::u8vec3(node.params.surface.color * 255.0 + 0.5));
        out.objects.push_back({node.name, std::move(mesh), {}});
    }
    if (out.objects.empty())
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the file shows no mesh and no camera"));
    return out;
}

} // namespace

Expected<ReadMesh> readUsd(const std::string& path, const Progress& progress)
{
    auto nodes = nodesOf(path, false, progress);
    if (!nodes)
        return inFile<ReadMesh>(fail(std::move(nodes.error())), path);
    return inFile(meshesOf(std::move(*nodes)), path);
}

Expected<BlenderImport> importUsd(const std::string& path, const ImportOptions& options,
                                  const Progress& progress)
{
    if (options.space)
        return inFile<BlenderImport>(
            fail(ErrorCode::Invalid, RAMURE_NOOP("a USD file says itself which axis points up and what its "
                                                 "unit is")),
            path);
    return inFile(nodesOf(path, true, progress), path);
}

} // namespace ramure
