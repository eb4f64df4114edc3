#include "core/io/formats/usd/usd_plan.h"

#include "core/base/number_text.h"
#include "core/io/formats/glb/glb_parts.h"
#include "core/io/write_parts.h"
#include "core/surface/bark/bark_maps.h"
#include <algorithm>
#include <cmath>
#include <cstring>

namespace ramure::usd {
namespace {

template <class T> bool areEqual(const std::shared_ptr<const T>& a, const std::shared_ptr<const T>& b)
{
    return a == b || (a && b && *a == *b);
}

bool areEqual(const ExportSeasons* a, const ExportSeasons* b)
{
    return a == b || (a && b && a->phases == b->phases &&
                      std::ranges::equal(a->variants, b->variants, [](const auto& x, const auto& y) {
                          return x.material == y.material && std::strcmp(x.name, y.name) == 0;
                      }));
}

bool areEqual(const PlannedMesh& a, const PlannedMesh& b)
{
    return a.from->material == b.from->material && a.from->level == b.from->level &&
           a.from->isLevel == b.from->isLevel && areEqual(a.from->mesh, b.from->mesh) &&
           areEqual(a.from->seasons.get(), b.from->seasons.get());
}
bool areEqual(const PlannedCopies& a, const PlannedCopies& b)
{
    return a.from->material == b.from->material && areEqual(a.from->shape, b.from->shape) &&
           a.from->copies == b.from->copies && areEqual(a.from->seasons.get(), b.from->seasons.get());
}

bool isOneColour(const TriangleMesh& mesh)
{
    return std::ranges::all_of(mesh.colours,
                               [&](const glm::u8vec3& colour) { return colour == mesh.colours.front(); });
}

class Planner
{
public:
    Planner(const ExportScene& scene, const WriteOptions& options, const Progress& progress)
        : m_scene(scene)
        , m_options(options)
        , m_progress(progress)
        , m_plan{std::vector<PlannedNode>(scene.nodes.size()),
                 {},
                 {},
                 Materials(rootPath + "/Materials", options.mapSize),
                 lastLevel(scene),
                 {}}
    {
    }

    Expected<Plan> run()
    {
        sort();
        for (std::size_t i = 0; i < m_plan.nodes.size(); ++i)
            if (m_plan.nodes[i].isNeeded)
                m_plan.nodes[i].sameAs = sameAs(static_cast<Index>(i));
        nameNodes();
        for (std::size_t i = 0; i < m_plan.nodes.size(); ++i) {
            const double count = double(m_plan.nodes.size());
            m_part = m_progress.part(double(i) / count, double(i + 1) / count);
            m_part.report(0.0);
            if (m_progress.cancelled())
                return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
            PlannedNode& node = m_plan.nodes[i];
            for (const ExportFrame& frame : m_scene.frames) {
                RAMURE_TRY(
                    checkFinite(placeOf(m_scene, frame, static_cast<Index>(i)), m_scene.nodes[i].name));
                RAMURE_TRY(checkFinite(insideOf(frame, static_cast<Index>(i)), m_scene.nodes[i].name));
            }
            if (node.isNeeded && node.sameAs == noIndex)
                RAMURE_TRY(fill(static_cast<Index>(i), node));
        }
        times();
        return std::move(m_plan);
    }

private:
    [[nodiscard]] bool isClip() const { return m_scene.frames.size() > 1; }

    /// Everything to its node, and each needed node to the one above it.
    void sort()
    {
        for (const ExportMesh& mesh : m_scene.meshes)
            m_plan.nodes[mesh.node].meshes.push_back(
                {&mesh, {}, {}, isClip() && mesh.skin && m_scene.frames.front().bones[mesh.node]});
        for (const ExportCopies& copies : m_scene.copies)
            m_plan.nodes[copies.node].copies.push_back({&copies, {}, {}, {}, {}});
        for (const ExportCamera& camera : m_scene.cameras)
            m_plan.nodes[camera.node].cameras.push_back({&camera, {}});
        for (std::size_t i = m_plan.nodes.size(); i-- > 0;) {
            PlannedNode& node = m_plan.nodes[i];
            node.isNeeded =
                node.isNeeded || !node.meshes.empty() || !node.copies.empty() || !node.cameras.empty();
            const Index parent = m_scene.nodes[i].parent;
            if (node.isNeeded && parent != noIndex)
                m_plan.nodes[parent].isNeeded = true;
        }
        for (std::size_t i = 0; i < m_plan.nodes.size(); ++i)
            if (m_plan.nodes[i].isNeeded) {
                const Index parent = m_scene.nodes[i].parent;
                (parent == noIndex ? m_plan.tops : m_plan.nodes[parent].children)
                    .push_back(static_cast<Index>(i));
            }
    }

    [[nodiscard]] bool canBeSame(Index number) const
    {
        const PlannedNode& node = m_plan.nodes[number];
        return node.children.empty() && node.cameras.empty() && !m_scene.frames.front().bones[number] &&
               !m_scene.nodes[number].isArm;
    }
    [[nodiscard]] Index sameAs(Index number) const
    {
        const PlannedNode& node = m_plan.nodes[number];
        const auto isSame = [&](Index other) {
            const PlannedNode& before = m_plan.nodes[other];
            const auto stands = [&](const ExportFrame& frame) {
                return glb::isNear(insideOf(frame, number), insideOf(frame, other));
            };
            const auto equal = [](const auto& a, const auto& b) { return areEqual(a, b); };
            return before.isNeeded && before.sameAs == noIndex && canBeSame(other) &&
                   std::ranges::all_of(m_scene.frames, stands) &&
                   std::ranges::equal(node.meshes, before.meshes, equal) &&
                   std::ranges::equal(node.copies, before.copies, equal);
        };
        for (Index other = 0; other < number && canBeSame(number); ++other)
            if (isSame(other))
                return other;
        return noIndex;
    }

    /// Parents stand before their children.
    void nameNodes()
    {
        Names top;
        top.take("Materials");
        if (m_scene.lines)
            m_plan.lines = top.take(m_scene.lines->name);
        std::vector<Names> below(m_plan.nodes.size());
        for (std::size_t i = 0; i < m_plan.nodes.size(); ++i) {
            PlannedNode& node = m_plan.nodes[i];
            if (!node.isNeeded)
                continue;
            const Index parent = m_scene.nodes[i].parent;
            Names& names = parent == noIndex ? top : below[parent];
            node.prim = names.take(m_scene.nodes[i].name);
            node.path = (parent == noIndex ? rootPath : m_plan.nodes[parent].path) + "/" + node.prim;
            below[i].take("Body");
        }
        for (std::size_t i = 0; i < m_plan.nodes.size(); ++i)
            nameParts(m_plan.nodes[i], below[i]);
    }

    void nameParts(PlannedNode& node, Names& names) const
    {
        for (PlannedMesh& mesh : node.meshes) {
            mesh.prim = names.take(mesh.from->name);
            node.hasLevels = node.hasLevels || mesh.from->isLevel;
        }
        for (PlannedCopies& copies : node.copies) {
            copies.prim = names.take(copies.from->name);
            copies.shape = Names().take(copies.from->kind);
        }
        for (PlannedCamera& camera : node.cameras)
            camera.prim = names.take("Camera");
    }

    Expected<void> fill(Index number, PlannedNode& node)
    {
        bool isRigged = false;
        for (PlannedMesh& mesh : node.meshes) {
            RAMURE_TRY(checkFinite(*mesh.from->mesh, mesh.from->name));
            RAMURE_TRY(wear(mesh));
            isRigged = isRigged || mesh.hasSkin;
            tellSeasons(node, mesh.from->seasons.get(), mesh.from->material);
        }
        for (PlannedCopies& copies : node.copies) {
            RAMURE_TRY(checkFinite(*copies.from));
            RAMURE_TRY(wear(copies));
            tellSeasons(node, copies.from->seasons.get(), copies.from->material);
        }
        if (!isRigged)
            return {};
        for (const ExportFrame& frame : m_scene.frames)
            node.poses.push_back(frame.bones[number].get());
        auto rig = rigOf(m_scene.nodes[number], node.poses.front()->size(),
                         static_cast<std::size_t>(m_options.joints), node.path + "/Body/Skeleton");
        RAMURE_TRY(rig);
        node.rig = std::move(*rig);
        tellJoints(m_scene.nodes[number], node);
        return {};
    }

    void tellJoints(const ExportNode& from, const PlannedNode& node) const
    {
        const glb::Joints& joints = node.rig->joints;
        if (!m_options.tell || joints.bones.size() == joints.jointOf.size())
            return;
        const double error = glb::jointError(joints, from.bones, node.poses);
        m_options.tell(
            fail(ErrorCode::Limit,
                 RAMURE_NOOP("%1: %2 joints for %3 bones; no tip is more than %4 m from its place"),
                 {from.name, numberText(joints.bones.size()), numberText(joints.jointOf.size()),
                  numberText(std::ceil(1000.0 * error) / 1000.0)})
                .value());
    }

    static void tellSeasons(PlannedNode& node, const ExportSeasons* seasons, Index usual)
    {
        if (!seasons || !node.seasons.empty())
            return;
        for (std::size_t i = 0; i < seasons->variants.size(); ++i) {
            const bool isUsual = seasons->variants[i].material == usual;
            node.order.insert(isUsual ? node.order.begin() : node.order.end(), i);
        }
        for (const std::size_t i : node.order)
            node.seasons.emplace_back(seasons->variants[i].name);
    }

    /// Colours that no picture shows are painted.
    [[nodiscard]] bool isPainted(const TriangleMesh& shape, bool textured) const
    {
        return !textured && m_options.mapSize > 0 && writing::hasColours(shape) && !isOneColour(shape);
    }

    Expected<void> wear(PlannedMesh& mesh)
    {
        const TriangleMesh& shape = *mesh.from->mesh;
        const Material& material = m_scene.materials[mesh.from->material];
        Wear has{m_plan.materials.isPictured(material) && !shape.uv.empty(), !shape.colours.empty(), false,
                 meanOf(shape)};
        has.isPainted = isPainted(shape, has.textured) && !mesh.from->seasons;
        mesh.worn.colours = {material.tones ? linearColour(material.colour) : glm::vec3(1.0F),
                             linearColour(material.colour), false, has.isPainted};
        RAMURE_TRY(wear(mesh.worn, material, mesh.from->seasons.get(), has));
        const bool isAging =
            material.pictures.colour.empty() && has.textured && !youngTriangles(shape, material.bark).empty();
        if (isAging) {
            const auto young =
                m_plan.materials.add({material.name + "_young", youngColour(material.bark)}, {}, m_part);
            RAMURE_TRY(young);
            mesh.worn.young = *young;
        }
        return {};
    }

    Expected<void> wear(PlannedCopies& copies)
    {
        const TriangleMesh& shape = *copies.from->shape;
        const Material& material = m_scene.materials[copies.from->material];
        const glm::vec3 own = meanOf(shape);
        glm::dvec3 tints(0.0);
        for (const ExportCopy& copy : copies.from->copies)
            tints += glm::dvec3(glb::linear(copy.tint));
        const auto count = std::max<double>(1.0, double(copies.from->copies.size()));
        const auto tint = glm::vec3(tints / count);
        Wear has{m_plan.materials.isPictured(material) && !shape.uv.empty(), true, false, own * tint};
        has.isPainted = isPainted(shape, has.textured) && !copies.from->seasons;
        const bool isWhole = !shape.colours.empty() && !material.tones;
        const glm::vec3 factor = isWhole ? glm::vec3(1.0F) : linearColour(material.colour);
        copies.worn.colours = {has.isPainted ? factor * tint : factor, factor, isOneColour(shape),
                               has.isPainted};
        if (copies.worn.colours.isHanded)
            copies.tint = own * factor;
        return wear(copies.worn, material, copies.from->seasons.get(), has);
    }

    Expected<void> wear(Worn& worn, const Material& material, const ExportSeasons* seasons, const Wear& has)
    {
        worn.textured = has.textured;
        const auto own = m_plan.materials.add(material, has, m_part);
        RAMURE_TRY(own);
        worn.material = *own;
        for (std::size_t i = 0; seasons && i < seasons->variants.size(); ++i) {
            const Material& other = m_scene.materials[seasons->variants[i].material];
            const auto path = m_plan.materials.add(
                other, {has.textured && m_plan.materials.isPictured(other), has.coloured, false, has.mean},
                m_part);
            RAMURE_TRY(path);
            worn.variants.push_back(*path);
        }
        return {};
    }

    void times()
    {
        const auto& frames = m_scene.frames;
        const double length = frames.back().seconds - frames.front().seconds;
        if (isClip() && length > 0.0)
            m_plan.rate = std::round(1e3 * double(frames.size() - 1) / length) / 1e3;
        for (const ExportFrame& frame : frames)
            m_plan.codes.push_back(std::round(1e6 * (frame.seconds - frames.front().seconds) * m_plan.rate) /
                                   1e6);
        m_plan.lastCode = m_plan.codes.back();
        for (const ExportMesh& mesh : m_scene.meshes)
            if (mesh.shapes)
                m_plan.lastCode =
                    std::max(m_plan.lastCode, double(mesh.shapes->seconds.back()) * m_plan.rate);
    }

    const ExportScene& m_scene;
    const WriteOptions& m_options;
    const Progress& m_progress;
    Progress m_part; ///< of the node that is being filled
    Plan m_plan;
};

} // namespace

glm::dmat4 placeOf(const ExportScene& scene, const ExportFrame& frame, Index node)
{
    const Index parent = scene.nodes[node].parent;
    const glm::dmat4& world = frame.transforms[node].world;
    return parent == noIndex ? world : glb::inSpaceOf(frame.transforms[parent].world, world);
}

glm::dmat4 insideOf(const ExportFrame& frame, Index node)
{
    const NodeTransforms& at = frame.transforms[node];
    return at.world == at.geometry ? glm::dmat4(1.0) : glb::inSpaceOf(at.world, at.geometry);
}

Expected<Plan> planOf(const ExportScene& scene, const WriteOptions& options, const Progress& progress)
{
    return Planner(scene, options, progress).run();
}

} // namespace ramure::usd
