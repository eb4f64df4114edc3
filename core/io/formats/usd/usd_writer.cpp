#include "core/io/formats/usd/usd_writer.h"

#include "core/base/number_text.h"
#include "core/base/version.h"
#include "core/io/formats/glb/glb_motion.h"
#include "core/math/reproducible.h"
#include "core/rig/arm/arm_chain.h"
#include "core/rig/arm/arm_shape.h"
#include <algorithm>
#include <glm/matrix.hpp>

namespace ramure::usd {
namespace {

using Lines = std::vector<std::string>;

std::string shortText(double number)
{
    std::array<char, 32> text{};
    return {text.data(), appendRounded(text.data(), number, 1e6)};
}

std::string bindLine(const std::string& material)
{
    return "rel material:binding = " + target(material);
}

/// \param prim of which people know the \p title
Lines titled(const std::string& prim, const std::string& title)
{
    return prim == title ? Lines{} : Lines{"displayName = " + inQuotes(title)};
}

class LayerWriter
{
public:
    LayerWriter(Text& text, const ExportScene& scene, const Plan& plan, const Progress& progress)
        : m_text(text)
        , m_scene(scene)
        , m_plan(plan)
        , m_progress(progress)
    {
        for (const PlannedNode& node : plan.nodes)
            for (const PlannedMesh& mesh : node.meshes)
                m_total += node.sameAs == noIndex ? mesh.from->mesh->triangles.size() : 0;
    }

    void run()
    {
        writeHead();
        m_text.open("def Xform \"Scene\"", rootMetadata());
        if (!m_scene.space.isOwn())
            writePlace({&m_fileSpace, 1});
        m_plan.materials.write(m_text);
        if (m_scene.lines && !m_scene.lines->lines.empty()) {
            m_text.open("def BasisCurves " + inQuotes(m_plan.lines),
                        titled(m_plan.lines, m_scene.lines->name));
            if (!m_scene.space.isOwn()) { // they are in the space of the file already
                const glm::dmat4 back = glm::inverse(m_fileSpace);
                writePlace({&back, 1});
            }
            writeLines(m_text, *m_scene.lines);
            m_text.close();
        }
        for (const Index top : m_plan.tops)
            writeNode(top);
        writeRootVariants();
        m_text.close();
        m_text.finish();
    }

private:
    [[nodiscard]] bool moves() const { return m_plan.lastCode > 0.0; }

    void writeHead()
    {
        m_text.line("#usda 1.0");
        m_text.line("(");
        m_text.line("    defaultPrim = \"Scene\"");
        m_text.line("    doc = \"Ramure " RAMURE_VERSION "\"");
        if (moves()) {
            m_text.line("    endTimeCode = " + shortText(m_plan.lastCode));
            m_text.line("    framesPerSecond = " + shortText(m_plan.rate));
        }
        m_text.line("    metersPerUnit = " + shortText(lengthUnits[m_scene.space.unit].metres));
        if (moves()) {
            m_text.line("    startTimeCode = 0");
            m_text.line("    timeCodesPerSecond = " + shortText(m_plan.rate));
        }
        m_text.line(std::string("    upAxis = ") + (m_scene.space.up == UpAxis::Z ? "\"Z\"" : "\"Y\""));
        m_text.line(")");
        m_text.line("");
    }

    /// Of the whole scene: each set that some node has.
    [[nodiscard]] Lines levelNames() const
    {
        Lines names;
        const bool has = std::ranges::any_of(m_plan.nodes, &PlannedNode::hasLevels);
        for (int level = 0; has && level <= m_plan.lastLevel; ++level)
            names.push_back("LOD" + std::to_string(level));
        return names;
    }
    [[nodiscard]] Lines seasonNames() const
    {
        for (const PlannedNode& node : m_plan.nodes)
            if (!node.seasons.empty())
                return node.seasons;
        return {};
    }
    /// \param selected the first of each set is chosen
    static void addSets(Lines& metadata, const Lines& levels, const Lines& seasons, bool selected)
    {
        Lines sets, chosen;
        for (const auto& [set, names] : {std::pair("lod", &levels), std::pair("season", &seasons)})
            if (!names->empty()) {
                sets.push_back(inQuotes(set));
                chosen.push_back(std::string("    string ") + set + " = " + inQuotes(names->front()));
            }
        if (sets.empty())
            return;
        if (selected) {
            metadata.emplace_back("variants = {");
            metadata.insert(metadata.end(), chosen.begin(), chosen.end());
            metadata.emplace_back("}");
        }
        const bool areTwo = sets.size() > 1;
        metadata.push_back("prepend variantSets = " +
                           (areTwo ? "[" + sets[0] + ", " + sets[1] + "]" : sets[0]));
    }
    [[nodiscard]] Lines rootMetadata() const
    {
        Lines metadata{"kind = \"component\""};
        addSets(metadata, levelNames(), seasonNames(), true);
        return metadata;
    }

    /// What the root's variants choose, the variants of nodes do.
    void writeRootVariants()
    {
        const auto write = [&](const char* set, const Lines& names, auto&& has) {
            if (names.empty())
                return;
            m_text.openBlock(std::string("variantSet ") + inQuotes(set) + " = {");
            for (const std::string& name : names) {
                m_text.openBlock(inQuotes(name) + " {");
                for (const Index top : m_plan.tops)
                    choose(top, std::string("string ") + set + " = " + inQuotes(name), has);
                m_text.close();
            }
            m_text.close();
        };
        write("lod", levelNames(), [&](const PlannedNode& node) { return ownerOf(node).hasLevels; });
        write("season", seasonNames(),
              [&](const PlannedNode& node) { return !ownerOf(node).seasons.empty(); });
    }
    [[nodiscard]] const PlannedNode& ownerOf(const PlannedNode& node) const
    {
        return node.sameAs == noIndex ? node : m_plan.nodes[node.sameAs];
    }
    template <class Has> [[nodiscard]] bool hasBelow(Index number, Has&& has) const
    {
        const PlannedNode& node = m_plan.nodes[number];
        return has(node) ||
               std::ranges::any_of(node.children, [&](Index child) { return hasBelow(child, has); });
    }
    template <class Has> void choose(Index number, const std::string& choice, Has&& has)
    {
        const PlannedNode& node = m_plan.nodes[number];
        if (!hasBelow(number, has))
            return;
        const Lines chosen{"variants = {", "    " + choice, "}"};
        const bool isOwn = has(node), isBody = isOwn && ownerOf(node).rig;
        m_text.open("over " + inQuotes(node.prim), isOwn && !isBody ? chosen : Lines());
        if (isBody) {
            m_text.open("over \"Body\"", chosen);
            m_text.close();
        }
        for (const Index child : node.children)
            choose(child, choice, has);
        m_text.close();
    }

    /// \param places one a frame \param always also where it changes nothing
    void writePlace(std::span<const glm::dmat4> places, bool always = false)
    {
        const bool isStill = std::ranges::all_of(
            places, [&](const glm::dmat4& place) { return glb::isNear(place, places.front()); });
        if (isStill && places.front() == glm::dmat4(1.0) && !always)
            return;
        if (isStill) {
            m_text.line("matrix4d xformOp:transform = " + matrixText(places.front()));
        } else {
            m_text.openBlock("matrix4d xformOp:transform.timeSamples = {");
            for (std::size_t i = 0; i < places.size(); ++i)
                m_text.line(shortText(m_plan.codes[i]) + ": " + matrixText(places[i]) + ",");
            m_text.close();
        }
        m_text.line("uniform token[] xformOpOrder = [\"xformOp:transform\"]");
    }
    template <class Of> std::vector<glm::dmat4> placesOf(Of&& of) const
    {
        std::vector<glm::dmat4> places;
        for (const ExportFrame& frame : m_scene.frames)
            places.push_back(of(frame));
        return places;
    }

    void writeNode(Index number)
    {
        const PlannedNode& node = m_plan.nodes[number];
        if (m_text.isStopped())
            return;
        Lines metadata = titled(node.prim, m_scene.nodes[number].name);
        const bool isSame = node.sameAs != noIndex;
        if (isSame) {
            metadata.emplace_back("instanceable = true");
            metadata.push_back("prepend references = " + target(m_plan.nodes[node.sameAs].path));
        } else {
            if (!node.copies.empty())
                metadata.emplace_back("prepend apiSchemas = [\"NaniteAssemblyRootAPI\"]");
            if (!node.rig)
                addSets(metadata, node.hasLevels ? levelNames() : Lines(), node.seasons, false);
        }
        m_text.open("def Xform " + inQuotes(node.prim), metadata);
        writePlace(placesOf([&](const ExportFrame& frame) { return placeOf(m_scene, frame, number); }),
                   isSame);
        if (!isSame) {
            writeAssembly(node);
            writeParts(number, node);
        }
        for (const Index child : node.children)
            writeNode(child);
        m_text.close();
    }
    void report(std::size_t triangles)
    {
        m_done += triangles;
        m_progress.report(double(m_done) / double(m_total));
    }

    /// Unreal's schema: one mesh with its parts as instances.
    void writeAssembly(const PlannedNode& node)
    {
        if (node.copies.empty())
            return;
        m_text.line(std::string("uniform token unreal:naniteAssembly:meshType = ") +
                    (node.rig ? "\"skeletalMesh\"" : "\"staticMesh\""));
        if (node.rig)
            m_text.line("rel unreal:naniteAssembly:skeleton = " + target(node.rig->path));
    }

    void writeParts(Index number, const PlannedNode& node)
    {
        const std::vector<glm::dmat4> inside =
            placesOf([&](const ExportFrame& frame) { return insideOf(frame, number); });
        if (node.rig)
            writeBody(number, node, inside);
        else
            writeMeshes(number, node, false, inside);
        for (const PlannedMesh& mesh : node.meshes)
            if (node.rig && !mesh.hasSkin)
                writeMesh(number, node, mesh, inside);
        for (const PlannedCopies& copies : node.copies)
            writeCopies(node, copies, inside);
        for (const PlannedCamera& camera : node.cameras)
            writeCamera(camera, inside);
    }

    void writeBody(Index number, const PlannedNode& node, std::vector<glm::dmat4> inside)
    {
        Lines metadata;
        addSets(metadata, node.hasLevels ? levelNames() : Lines(), node.seasons, false);
        m_text.open("def SkelRoot \"Body\"", metadata);
        Box box;
        for (const PlannedMesh& mesh : node.meshes)
            if (mesh.hasSkin)
                takePoses(box, *node.rig, *mesh.from->mesh, *mesh.from->skin, node.poses);
        writeExtent(m_text, box);
        for (glm::dmat4& place : inside)
            if (m_scene.nodes[number].isArm)
                place = place * armUpright();
        writePlace(inside);
        writeSkeleton(m_text, *node.rig, node.poses, m_plan.codes);
        const std::vector<glm::dmat4> none(1, glm::dmat4(1.0));
        writeMeshes(number, node, true, none);
        m_text.close();
    }

    /// The finest level stands outside of the variants, so that readers without them show it.
    void hideFinest(const PlannedNode& node, bool withSkin)
    {
        for (const PlannedMesh& mesh : node.meshes)
            if (mesh.hasSkin == withSkin && mesh.from->isLevel && mesh.from->level == 0) {
                m_text.open("over " + inQuotes(mesh.prim), {"active = false"});
                m_text.close();
            }
    }

    /// Those of the holder of the node, with its variants.
    void writeMeshes(Index number, const PlannedNode& node, bool withSkin, std::span<const glm::dmat4> inside)
    {
        const auto write = [&](int level) {
            for (const PlannedMesh& mesh : node.meshes)
                if (mesh.hasSkin == withSkin && mesh.from->level == level)
                    writeMesh(number, node, mesh, inside);
        };
        write(0);
        if (node.hasLevels) {
            m_text.openBlock("variantSet \"lod\" = {");
            for (int level = 0; level <= m_plan.lastLevel; ++level) {
                m_text.openBlock("\"LOD" + std::to_string(level) + "\" {");
                if (level > 0) {
                    hideFinest(node, withSkin);
                    write(level);
                }
                m_text.close();
            }
            m_text.close();
        }
        if (!node.seasons.empty())
            writeSeasons(node, withSkin);
    }

    /// Which material each part wears, or that it is not to be seen.
    void writeSeasons(const PlannedNode& node, bool withSkin)
    {
        const auto wear = [&](const Worn& worn, const ExportSeasons& seasons, std::size_t i) {
            if (m_scene.materials[seasons.variants[i].material].hidden)
                m_text.line("token visibility = \"invisible\"");
            m_text.line(bindLine(worn.variants[i]));
        };
        m_text.openBlock("variantSet \"season\" = {");
        for (std::size_t k = 0; k < node.seasons.size(); ++k) {
            m_text.openBlock(inQuotes(node.seasons[k]) + " {");
            for (const PlannedMesh& mesh : node.meshes)
                if (mesh.hasSkin == withSkin && !mesh.worn.variants.empty()) {
                    m_text.open("over " + inQuotes(mesh.prim));
                    wear(mesh.worn, *mesh.from->seasons, node.order[k]);
                    m_text.close();
                }
            for (const PlannedCopies& copies : node.copies)
                if (!withSkin && !copies.worn.variants.empty()) {
                    m_text.open("over " + inQuotes(copies.prim));
                    m_text.open("over \"Prototypes\"");
                    m_text.open("over " + inQuotes(copies.shape));
                    wear(copies.worn, *copies.from->seasons, node.order[k]);
                    m_text.close();
                    m_text.close();
                    m_text.close();
                }
            m_text.close();
        }
        m_text.close();
    }

    void writeMesh(Index number, const PlannedNode& node, const PlannedMesh& mesh,
                   std::span<const glm::dmat4> inside)
    {
        if (m_text.isStopped())
            return;
        const ExportMesh& from = *mesh.from;
        const auto& bones = m_scene.frames.front().bones[number];
        std::shared_ptr<const TriangleMesh> shape = from.mesh;
        if (!mesh.hasSkin && from.skin && bones)
            shape = std::make_shared<const TriangleMesh>(
                deformed(*shape, *from.skin, *bones, m_scene.nodes[number].method));
        if (!mesh.hasSkin && m_scene.nodes[number].isArm)
            shape = std::make_shared<const TriangleMesh>(upright(*shape));
        const Material& material = m_scene.materials[from.material];
        Lines metadata = titled(mesh.prim, from.name);
        metadata.emplace_back(mesh.hasSkin
                                  ? "prepend apiSchemas = [\"MaterialBindingAPI\", \"SkelBindingAPI\"]"
                                  : "prepend apiSchemas = [\"MaterialBindingAPI\"]");
        m_text.open("def Mesh " + inQuotes(mesh.prim), metadata);
        writePlace(inside);
        if (mesh.worn.variants.empty())
            m_text.line(bindLine(mesh.worn.material));
        if (!mesh.worn.young.empty())
            m_text.line("uniform token subsetFamily:materialBind:familyType = \"nonOverlapping\"");
        if (from.isLevel)
            m_text.line("custom double ramure:screenCoverage = " + shortText(from.coverage));
        usd::writeMesh(m_text, *shape, mesh.worn.textured, material.twoSided, mesh.worn.colours);
        if (from.shapes)
            writeShapes(m_text, *shape, *from.shapes, m_plan.rate);
        if (from.seasons)
            writePhases(m_text, *from.seasons, shape->vertexCount());
        if (mesh.hasSkin)
            writeSkin(m_text, *node.rig, *from.skin, m_scene.nodes[number].method);
        if (!mesh.worn.young.empty())
            writeYoung(m_text, youngTriangles(*shape, material.bark), bindLine(mesh.worn.young));
        m_text.close();
        report(shape->triangles.size());
    }

    void writeCopies(const PlannedNode& node, const PlannedCopies& copies, std::span<const glm::dmat4> inside)
    {
        const ExportCopies& from = *copies.from;
        const bool rides = node.rig && from.follows.size() == from.copies.size();
        Lines metadata = titled(copies.prim, from.name);
        if (rides)
            metadata.emplace_back("prepend apiSchemas = [\"NaniteAssemblySkelBindingAPI\"]");
        m_text.open("def PointInstancer " + inQuotes(copies.prim), metadata);
        writePlace(inside);
        const std::string prototypes = node.path + "/" + copies.prim + "/Prototypes";
        usd::writeCopies(m_text, from, prototypes + "/" + copies.shape, copies.tint);
        if (rides)
            writeRides(*node.rig, from);
        m_text.open("def Scope \"Prototypes\"");
        Lines shape = titled(copies.shape, from.kind);
        shape.emplace_back("prepend apiSchemas = [\"MaterialBindingAPI\"]");
        m_text.open("def Mesh " + inQuotes(copies.shape), shape);
        if (copies.worn.variants.empty())
            m_text.line(bindLine(copies.worn.material));
        usd::writeMesh(m_text, *from.shape, copies.worn.textured, m_scene.materials[from.material].twoSided,
                       copies.worn.colours);
        m_text.close();
        m_text.close();
        m_text.close();
    }

    /// The joint with which each copy goes.
    void writeRides(const Rig& rig, const ExportCopies& from)
    {
        const Lines one{"elementSize = 1", "interpolation = \"vertex\""};
        std::string line = "uniform token[] primvars:unreal:naniteAssembly:bindJoints = [";
        for (std::size_t i = 0; i < from.follows.size(); ++i)
            line.append(i == 0 ? "" : ", ").append(inQuotes(jointOf(rig, from.follows[i])));
        m_text.line(line + "] (");
        for (const std::string& each : one)
            m_text.line("    " + each);
        m_text.line(")");
        m_text.array(
            "uniform float[] primvars:unreal:naniteAssembly:bindJointWeights", from.follows.size(),
            [](char* to, std::size_t) {
                *to = '1';
                return to + 1;
            },
            one);
    }

    /// Lengths of lenses are tenths of the stage's unit.
    void writeCamera(const PlannedCamera& camera, std::span<const glm::dmat4> inside)
    {
        const CameraParams& lens = camera.from->lens;
        constexpr double film = 0.024; // m
        const double tenths = 10.0 / lengthUnits[m_scene.space.unit].metres;
        const auto half = maths::sincos(0.5 * lens.angleRad);
        const double focal = 0.5 * film * half.cos / half.sin;
        m_text.open("def Camera " + inQuotes(camera.prim));
        writePlace(inside);
        m_text.line("float2 clippingRange = (" + shortText(0.01 * 0.1 * tenths) + ", " +
                    shortText(1e4 * 0.1 * tenths) + ")");
        m_text.line("float focalLength = " + shortText(focal * tenths));
        m_text.line("float focusDistance = " + shortText(lens.focus * 0.1 * tenths));
        m_text.line("float fStop = " + shortText(lens.fStop));
        m_text.line("float horizontalAperture = " + shortText(1.5 * film * tenths));
        m_text.line("token projection = \"perspective\"");
        m_text.line("float verticalAperture = " + shortText(film * tenths));
        m_text.close();
    }

    Text& m_text;
    const ExportScene& m_scene;
    const Plan& m_plan;
    const Progress& m_progress;
    const glm::dmat4 m_fileSpace = m_scene.space.matrix();
    std::size_t m_done = 0, m_total = 1;
};

} // namespace

void writeLayer(Text& text, const ExportScene& scene, const Plan& plan, const Progress& progress)
{
    LayerWriter(text, scene, plan, progress).run();
}

} // namespace ramure::usd
