#include "core/qt/session/export/scatter_export.h"

#include "core/qt/session/export/scene_counts.h"
#include "core/rig/arm/arm_shape.h"
#include "core/scatter/scatter.h"
#include "core/surface/mesh/transformed.h"

#include <algorithm>

namespace ramure {
namespace {

/// Of one mesh that holds all copies: 4 GiB of vertices and triangles.
constexpr std::size_t mostTriangles = 60'000'000;

/// Adds numbers of another mesh, whose vertices or coordinates begin at \p from.
void append(std::vector<glm::uvec3>& to, const std::vector<glm::uvec3>& more, std::size_t from)
{
    for (const glm::uvec3& corners : more)
        to.push_back(corners + static_cast<Index>(from));
}

template <class T> void append(std::vector<T>& to, const std::vector<T>& more)
{
    to.insert(to.end(), more.begin(), more.end());
}

/// All lists that the shape has, in as many copies.
TriangleMesh meshOf(const TriangleMesh& shape, const std::vector<glm::dmat4>& places)
{
    TriangleMesh out;
    for (const glm::dmat4& place : places) {
        const TriangleMesh copy = transformed(shape, place);
        append(out.triangles, copy.triangles, out.positions.size());
        append(out.uvTriangles, copy.uvTriangles, out.uv.size());
        append(out.positions, copy.positions);
        append(out.normals, copy.normals);
        append(out.branch, copy.branch);
        append(out.level, copy.level);
        append(out.uv, copy.uv);
        append(out.colours, copy.colours);
        append(out.radius, copy.radius);
    }
    return out;
}

/// As it stands in its node's own space, without bones.
std::shared_ptr<const TriangleMesh> standing(const ExportScene& of, const ExportMesh& mesh,
                                             const glm::dmat4& place)
{
    const ExportNode& node = of.nodes[mesh.node];
    const auto& bones = of.frames.front().bones[mesh.node];
    std::shared_ptr<const TriangleMesh> shape = mesh.mesh;
    if (mesh.skin && bones)
        shape = std::make_shared<const TriangleMesh>(deformed(*shape, *mesh.skin, *bones, node.method));
    if (node.isArm)
        shape = std::make_shared<const TriangleMesh>(upright(*shape));
    return place == glm::dmat4(1.0) ? shape
                                    : std::make_shared<const TriangleMesh>(transformed(*shape, place));
}

struct PrototypeCopies
{
    std::string name;
    std::vector<ExportCopy> copies;
};

std::vector<PrototypeCopies> copiesOf(const std::vector<const Node*>& prototypes, const ScatterPlaces& places)
{
    std::vector<PrototypeCopies> out;
    for (const Node* node : prototypes) {
        std::string name = node->name;
        for (int number = 2; std::ranges::count(out, name, &PrototypeCopies::name) > 0; ++number)
            name = node->name + "_" + std::to_string(number);
        out.push_back({name, {}});
    }
    for (const ScatterPlace& place : places) {
        std::vector<ExportCopy>& copies = out[place.prototype].copies;
        copies.push_back({placeMatrix(place), glm::vec3(1.0F), noIndex, place.key,
                          static_cast<std::uint32_t>(copies.size())});
    }
    return out;
}

Expected<void> addAsMesh(ExportScene& out, ExportMesh mesh, const std::vector<ExportCopy>& copies)
{
    const std::size_t triangles = mesh.mesh->triangles.size() * copies.size();
    if (triangles > mostTriangles)
        return fail(
            ErrorCode::Limit,
            RAMURE_NOOP("%1 copies of %2 would be a mesh of %3 million triangles: write instances, or "
                        "choose a format that has them (GLB, USD)"),
            {std::to_string(copies.size()), mesh.name, std::to_string(triangles / 1'000'000)});
    std::vector<glm::dmat4> places;
    for (const ExportCopy& copy : copies)
        places.push_back(copy.place);
    mesh.mesh = std::make_shared<const TriangleMesh>(meshOf(*mesh.mesh, places));
    mesh.pieces *= static_cast<Index>(copies.size());
    out.meshes.push_back(std::move(mesh));
    return {};
}

} // namespace

std::vector<Index> scattersOf(const Scene& scene, const ExportOptions& options)
{
    std::vector<Index> found;
    for (std::size_t i = 0; i < scene.nodes().size(); ++i)
        if (const Node& node = scene.nodes()[i];
            node.kind == NodeKind::Scatter && isChosen(scene, options, node) && !isPrototype(scene, node.id))
            found.push_back(static_cast<Index>(i));
    return found;
}

Expected<void> checkScatterExport(const Scene& scene, const ExportOptions& options)
{
    for (const Index number : scattersOf(scene, options)) {
        const char* why = nullptr;
        if (options.model != ExportModel::Mesh)
            why = RAMURE_NOOP("copies of a scatter are written as meshes alone");
        else if (!options.clip.empty())
            why = RAMURE_NOOP("copies of a scatter do not move: write one moment");
        else if (options.levels.isWanted() || options.levelFiles)
            why = RAMURE_NOOP("copies of a scatter have no levels of detail: write its trees by themselves");
        else if (options.growthFrom > 0.0)
            why = RAMURE_NOOP("copies of a scatter do not grow: write its trees by themselves");
        else if (options.wind != WindProfile::None)
            why = RAMURE_NOOP("copies of a scatter have no data for wind: write its trees by themselves");
        if (why) {
            auto error = fail(ErrorCode::Invalid, why);
            error.value().path = scene.nodes()[number].name;
            return error;
        }
    }
    return {};
}

Expected<void> addScatter(ExportScene& out, Index number, EvaluatedScene& scene, const ExportOptions& options,
                          CollectNode* collect, const Progress& progress)
{
    Node scatter = scene.scene().nodes()[number];
    scatter.params = scene.params(scatter);
    auto places = scatterPlaces(scene.scene(), scatter, progress.part(0.0, 0.2));
    if (!places)
        return fail(named(scatter, std::move(places.error())));
    const std::vector<const Node*> prototypes = prototypesOf(scene.scene(), scatter.id);
    const std::vector<PrototypeCopies> all = copiesOf(prototypes, **places);
    for (std::size_t i = 0; i < prototypes.size(); ++i) {
        if (all[i].copies.empty())
            continue;
        ExportOptions only = options;
        only.nodes = {prototypes[i]->id};
        only.instances = false;
        only.collision = CollisionNames::None;
        only.variants = false;
        const double share = 0.8 / double(prototypes.size());
        const auto made =
            collect(scene, only, progress.part(0.2 + share * double(i), 0.2 + share * double(i + 1)));
        RAMURE_TRY(made);
        for (const ExportMesh& mesh : made->meshes) {
            const auto shape = standing(*made, mesh, prototypeMatrix(*prototypes[i]));
            const Index material = materialIn(out, made->materials[mesh.material]);
            const std::string name = mesh.name + "_" + all[i].name;
            if (options.copies) {
                out.copies.push_back({name, all[i].name, number, shape, material, all[i].copies});
                continue;
            }
            ExportMesh merged{name, number, shape, material};
            merged.pieces = mesh.pieces;
            RAMURE_TRY(addAsMesh(out, std::move(merged), all[i].copies));
        }
    }
    return {};
}

} // namespace ramure
