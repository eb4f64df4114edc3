#include "tests/support/usd_rules.h"

#include "core/io/formats/usd/usd_places.h"
#include "core/io/formats/usd/usd_shape.h"
#include "core/surface/proof/validate.h"
#include <QFileInfo>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <set>

namespace ramure::test {

using usd::Attribute;
using usd::Layer;
using usd::Prim;

namespace {

constexpr double near = 1e-5; // of lengths, relative

class Judge
{
public:
    Judge(UsdRules& out, const Layer& layer, const QString& folder)
        : m_out(out)
        , m_root(layer.root)
        , m_folder(folder)
    {
    }

    void run()
    {
        stage();
        for (const auto& child : m_root.children)
            walk(*child, "/" + child->name, {});
    }

private:
    using Above = std::vector<const Prim*>;

    void rule(bool kept, const char* name, const std::string& where, const std::string& what = {})
    {
        if (!kept && m_out.broken.size() < 50)
            m_out.broken +=
                QStringLiteral("%1: %2: %3")
                    .arg(QLatin1String(name), QString::fromStdString(where), QString::fromStdString(what));
    }
    static bool applies(const Prim& prim, const std::string& schema)
    {
        const auto found = prim.metadata.find("apiSchemas");
        return found != prim.metadata.end() && std::ranges::count(found->second.texts, schema) > 0;
    }
    static std::vector<double> numbers(const Prim& prim, const std::string& name)
    {
        const Attribute* attribute = prim.attribute(name);
        return attribute && attribute->get() ? attribute->get()->numbers : std::vector<double>();
    }
    static std::vector<std::string> texts(const Prim& prim, const std::string& name)
    {
        const Attribute* attribute = prim.attribute(name);
        return attribute && attribute->get() ? attribute->get()->texts : std::vector<std::string>();
    }
    static double said(const Prim& prim, const char* name, double otherwise)
    {
        const auto found = prim.metadata.find(name);
        return found == prim.metadata.end() || found->second.numbers.empty() ? otherwise
                                                                             : found->second.numbers[0];
    }
    static bool encloses(const std::vector<double>& extent, const glm::dvec3& low, const glm::dvec3& high,
                         bool exactly)
    {
        if (extent.size() != 6)
            return false;
        const double off = near * glm::length(high - low) + 1e-9;
        for (int k = 0; k < 3; ++k) {
            const double from = low[k] - extent[static_cast<std::size_t>(k)],
                         to = extent[static_cast<std::size_t>(k) + 3] - high[k];
            if (from < -off || to < -off || (exactly && (from > off || to > off)))
                return false;
        }
        return true;
    }

    /// 1 and 2: what a stage says of itself.
    void stage()
    {
        const Prim* usual = m_root.child(m_root.said("defaultPrim"));
        rule(usual && usual->specifier == usd::Specifier::Def && usual->type == "Xform", "default prim", "/");
        rule(m_root.children.size() == 1, "encapsulation", "/", "prims beside the default one");
        const std::string up = m_root.said("upAxis");
        rule((up == "Y" || up == "Z") && said(m_root, "metersPerUnit", 0.0) > 0.0, "axis and unit", "/");
        m_end = said(m_root, "endTimeCode", -1.0);
        rule(m_end < 0.0 || (said(m_root, "startTimeCode", -1.0) == 0.0 &&
                             said(m_root, "timeCodesPerSecond", 0.0) > 0.0),
             "time codes", "/");
    }

    void walk(const Prim& prim, const std::string& path, Above above)
    {
        const auto active = prim.metadata.find("active");
        if (active != prim.metadata.end() && active->second.texts == std::vector<std::string>{"false"})
            return;
        ++m_out.prims;
        rule(prim.specifier == usd::Specifier::Def && !prim.type.empty(), "defined", path);
        const std::string_view in = above.empty() ? std::string_view() : above.back()->type;
        const bool isSurface = in == "Mesh" || in == "BasisCurves" || in == "Camera";
        rule(!isSurface || prim.type == "GeomSubset", "encapsulation", path, "below a surface");
        rule(prim.type != "Shader" || in == "Material", "encapsulation", path, "a shader alone");
        links(prim, path);
        for (const auto& [name, attribute] : prim.attributes)
            for (const auto& [code, value] : attribute.samples)
                rule(code >= 0.0 && code <= m_end, "time codes", path, name);
        if (prim.type == "Mesh")
            mesh(prim, path, above);
        else if (prim.type == "Material")
            material(prim, path);
        else if (prim.type == "Shader")
            shader(prim, path);
        else if (prim.type == "Skeleton")
            skeleton(prim, path, above);
        else if (prim.type == "PointInstancer")
            instancer(prim, path);
        if (applies(prim, "NaniteAssemblyRootAPI"))
            assembly(prim, path);
        above.push_back(&prim);
        for (const auto& child : prim.children)
            walk(*child, path + "/" + child->name, above);
    }

    /// 3 and 4: relationships and connections lead somewhere, inside.
    void links(const Prim& prim, const std::string& path)
    {
        for (const auto& [name, targets] : prim.relations)
            for (const std::string& target : targets)
                rule(usd::primAt(m_root, target) != nullptr, "targets", path, target);
        for (const auto& [name, attribute] : prim.attributes)
            for (const std::string& to : attribute.connections) {
                const std::size_t dot = std::min(to.find('.'), to.size());
                const Prim* from = usd::primAt(m_root, to.substr(0, dot));
                rule(from && dot < to.size() && from->attribute(to.substr(dot + 1)), "connections", path, to);
            }
        if (const auto bound = prim.relations.find("material:binding"); bound != prim.relations.end()) {
            const Prim* to = bound->second.size() == 1 ? usd::primAt(m_root, bound->second[0]) : nullptr;
            rule(to && to->type == "Material" && applies(prim, "MaterialBindingAPI"), "bindings", path);
        }
    }

    void material(const Prim& prim, const std::string& path)
    {
        ++m_out.materials;
        const Attribute* surface = prim.attribute("outputs:surface");
        rule(surface && surface->connections.size() == 1, "surface of a material", path);
    }

    void shader(const Prim& prim, const std::string& path)
    {
        const std::string id = prim.text("info:id");
        rule(id == "UsdPreviewSurface" || id == "UsdUVTexture" || id == "UsdPrimvarReader_float2", "shaders",
             path, id);
        if (id != "UsdUVTexture")
            return;
        const QString file = QString::fromStdString(prim.text("inputs:file"));
        const QStringList endings{QStringLiteral("png"), QStringLiteral("jpg"), QStringLiteral("jpeg"),
                                  QStringLiteral("exr")};
        rule(file.startsWith(QLatin1String("./")) && endings.contains(QFileInfo(file).suffix()), "pictures",
             path, file.toStdString());
        rule(m_folder.isEmpty() || QFileInfo::exists(m_folder + QLatin1Char('/') + file), "pictures", path,
             "missing");
    }

    /// 5 to 13: surfaces.
    void mesh(const Prim& prim, const std::string& path, const Above& above)
    {
        ++m_out.meshes;
        const auto shape = usd::shapeOf(prim);
        if (!shape)
            return rule(false, "lists of a mesh", path, shape.error().message());
        const TriangleMesh& own = shape->mesh;
        rule(prim.text("subdivisionScheme") == "none", "subdivision", path);
        glm::dvec3 low(1e30), high(-1e30);
        for (const glm::vec3& p : own.positions) {
            low = glm::min(low, glm::dvec3(p));
            high = glm::max(high, glm::dvec3(p));
        }
        rule(encloses(numbers(prim, "extent"), low, high, true), "extent", path);
        rule(own.normals.empty() || own.normals.size() == own.positions.size(), "normals", path);
        const std::vector<double> normals = numbers(prim, "normals");
        for (std::size_t i = 0; i + 2 < normals.size(); i += 3)
            if (const double length = glm::length(glm::make_vec3(&normals[i])); std::abs(length - 1.0) > 1e-3)
                return rule(false, "normals", path, std::to_string(length));
        faces(own, path);
        if (!prim.relations.contains("material:binding"))
            rule(false, "bindings", path, "no material");
        const bool isSkinned = prim.attribute("primvars:skel:jointIndices");
        if (isSkinned)
            skin(prim, path, above, own.positions.size());
    }

    void faces(const TriangleMesh& own, const std::string& path)
    {
        const auto report = validateMesh(own);
        rule(report && report->isolatedVertices == 0, "unused vertices", path);
        rule(report && report->degenerateFaces == 0, "zero areas", path);
        if (path.find("/branches") == std::string::npos)
            return;
        rule(report && report->boundaryEdges == 0 && report->nonManifoldEdges == 0 &&
                 report->inconsistentEdges == 0 && report->nonManifoldVertices == 0 && report->volume > 0.0,
             "closed bark", path);
        ++m_out.closed;
    }

    /// 14 to 16: skins.
    void skin(const Prim& prim, const std::string& path, const Above& above, std::size_t vertices)
    {
        ++m_out.skins;
        rule(applies(prim, "SkelBindingAPI"), "schema of a skin", path);
        rule(std::ranges::any_of(above, [](const Prim* each) { return each->type == "SkelRoot"; }),
             "inside a SkelRoot", path);
        const auto to = prim.relations.find("skel:skeleton");
        const Prim* bones = to == prim.relations.end() || to->second.empty()
                                ? nullptr
                                : usd::primAt(m_root, to->second.front());
        rule(bones && bones->type == "Skeleton", "skeleton of a skin", path);
        const std::size_t joints = bones ? texts(*bones, "joints").size() : 0;
        const std::vector<double> which = numbers(prim, "primvars:skel:jointIndices"),
                                  weights = numbers(prim, "primvars:skel:jointWeights");
        const Attribute* attribute = prim.attribute("primvars:skel:jointIndices");
        const auto size = attribute->metadata.find("elementSize");
        const std::size_t each = size == attribute->metadata.end() || size->second.numbers.empty()
                                     ? 1
                                     : static_cast<std::size_t>(size->second.numbers[0]);
        rule(which.size() == each * vertices && weights.size() == which.size(), "lists of a skin", path);
        rule(std::ranges::all_of(which, [&](double j) { return j >= 0.0 && j < double(joints); }),
             "joints of a skin", path);
        for (std::size_t v = 0; v < vertices && (v + 1) * each <= weights.size(); ++v) {
            double sum = 0.0;
            for (std::size_t k = 0; k < each; ++k)
                sum += weights[v * each + k];
            if (std::abs(sum - 1.0) > 1e-6)
                return rule(false, "weights", path, std::to_string(sum));
        }
        rule(numbers(prim, "primvars:skel:geomBindTransform").size() == 16, "place of a skin", path);
    }

    /// 17 to 19: skeletons and their motion.
    void skeleton(const Prim& prim, const std::string& path, const Above& above)
    {
        ++m_out.skeletons;
        const std::vector<std::string> joints = texts(prim, "joints");
        const std::vector<double> binds = numbers(prim, "bindTransforms"),
                                  rests = numbers(prim, "restTransforms");
        rule(!joints.empty() && binds.size() == 16 * joints.size() && rests.size() == binds.size(),
             "lists of a skeleton", path);
        rule(!above.empty() && above.back()->type == "SkelRoot" &&
                 numbers(*above.back(), "extent").size() == 6,
             "extent", path, "of the SkelRoot");
        std::map<std::string, std::size_t> known;
        for (std::size_t j = 0; j < joints.size() && binds.size() == 16 * joints.size(); ++j) {
            const std::size_t slash = joints[j].rfind('/');
            glm::dmat4 world = glm::make_mat4(&rests[16 * j]);
            if (slash != std::string::npos) {
                const auto parent = known.find(joints[j].substr(0, slash));
                if (parent == known.end())
                    return rule(false, "order of joints", path, joints[j]);
                world = glm::dmat4(glm::make_mat4(&binds[16 * parent->second])) * world;
            }
            rule(known.emplace(joints[j], j).second, "names of joints", path, joints[j]);
            const glm::dmat4 bind = glm::make_mat4(&binds[16 * j]);
            for (int column = 0; column < 4; ++column)
                if (glm::distance(world[column], bind[column]) > 1e-6)
                    return rule(false, "binding and rest", path, joints[j]);
        }
        const auto source = prim.relations.find("skel:animationSource");
        if (source == prim.relations.end())
            return;
        const Prim* motion = source->second.empty() ? nullptr : usd::primAt(m_root, source->second.front());
        rule(motion && motion->type == "SkelAnimation" && texts(*motion, "joints") == joints, "motion", path);
        for (const auto& [name, size] :
             {std::pair("translations", std::size_t(3)), std::pair("rotations", std::size_t(4))})
            for (const auto& [code, value] : motion ? motion->attribute(name)->samples
                                                    : std::map<double, std::shared_ptr<const usd::Value>>())
                rule(value->numbers.size() == size * joints.size(), "motion", path, name);
    }

    /// 20 and 21: copies.
    void instancer(const Prim& prim, const std::string& path)
    {
        ++m_out.instancers;
        const auto copies = usd::copiesOf(prim);
        if (!copies)
            return rule(false, "lists of copies", path, copies.error().message());
        const std::vector<double> ids = numbers(prim, "ids"), turns = numbers(prim, "orientations");
        rule(std::set<double>(ids.begin(), ids.end()).size() == copies->size(), "ids of copies", path);
        for (std::size_t i = 0; i + 3 < turns.size(); i += 4)
            if (const double length = glm::length(glm::make_vec4(&turns[i])); std::abs(length - 1.0) > 1e-3)
                return rule(false, "turns of copies", path, std::to_string(length));
        std::vector<std::vector<double>> points;
        for (const std::string& target : prim.relations.at("prototypes")) {
            rule(target.starts_with(path + "/"), "prototypes", path, "elsewhere");
            const Prim* shape = usd::primAt(m_root, target);
            points.push_back(shape ? numbers(*shape, "points") : std::vector<double>());
        }
        glm::dvec3 low(1e30), high(-1e30);
        for (const usd::Copy& copy : *copies)
            for (std::size_t i = 0; i + 2 < points[copy.prototype].size(); i += 3) {
                const glm::dvec3 p = copy.place * glm::dvec4(glm::make_vec3(&points[copy.prototype][i]), 1.0);
                low = glm::min(low, p);
                high = glm::max(high, p);
            }
        const glm::dvec3 off(1e-3 * glm::length(high - low)); // turns are half numbers
        rule(encloses(numbers(prim, "extent"), low + off, high - off, false), "extent", path);
    }

    /// 22: Unreal's schema.
    void assembly(const Prim& prim, const std::string& path)
    {
        ++m_out.assemblies;
        const Attribute* type = prim.attribute("unreal:naniteAssembly:meshType");
        const std::string kind = prim.text("unreal:naniteAssembly:meshType");
        rule(type && type->isUniform && (kind == "staticMesh" || kind == "skeletalMesh"), "assembly", path);
        const auto to = prim.relations.find("unreal:naniteAssembly:skeleton");
        rule((kind == "skeletalMesh") == (to != prim.relations.end()), "assembly", path, "skeleton");
        if (to == prim.relations.end() || to->second.size() != 1)
            return;
        const Prim* bones = usd::primAt(m_root, to->second.front());
        rule(bones && bones->type == "Skeleton" && to->second.front().starts_with(path + "/"), "assembly",
             path, "the skeleton is not below it");
        const auto isBody = [](const auto& child) { return child->type == "SkelRoot"; };
        const auto body = std::ranges::find_if(prim.children, isBody);
        rule(body != prim.children.end() &&
                 std::ranges::any_of((*body)->children,
                                     [](const auto& child) { return child->type == "Mesh"; }),
             "assembly", path, "no surface of its own");
        const std::vector<std::string> known = bones ? texts(*bones, "joints") : std::vector<std::string>();
        const std::set<std::string> joints(known.begin(), known.end());
        for (const auto& child : prim.children) {
            if (child->type != "PointInstancer")
                continue;
            const std::size_t count = numbers(*child, "protoIndices").size();
            const auto bound = texts(*child, "primvars:unreal:naniteAssembly:bindJoints");
            rule(applies(*child, "NaniteAssemblySkelBindingAPI") && bound.size() == count &&
                     numbers(*child, "primvars:unreal:naniteAssembly:bindJointWeights").size() == count,
                 "assembly", path, child->name);
            rule(std::ranges::all_of(bound, [&](const auto& joint) { return joints.contains(joint); }),
                 "assembly", path, "a joint that there is not");
        }
    }

    UsdRules& m_out;
    const Prim& m_root;
    QString m_folder;
    double m_end = -1.0;
};

} // namespace

UsdRules usdRules(const Layer& layer, const QString& folder)
{
    UsdRules out;
    const auto judge = [&](const Layer& as) {
        std::vector<std::string> notes;
        const auto seen = usd::composed(as, notes);
        if (!seen)
            out.broken += QString::fromStdString(seen.error().message());
        else
            Judge(out, *seen, folder).run();
        for (const std::string& note : notes)
            out.broken += QString::fromStdString(note);
    };
    // 23: as it is, and with each variant of the default prim.
    const Prim* usual = layer.root.child(layer.root.said("defaultPrim"));
    if (!usual || usual->sets.empty())
        judge(layer);
    for (std::size_t s = 0; usual && s < usual->sets.size(); ++s)
        for (const auto& [name, body] : usual->sets[s].variants) {
            Layer other = layer;
            auto chosen = std::make_shared<Prim>(*usual);
            chosen->metadata["variants"].members[usual->sets[s].name].texts = {name};
            std::ranges::replace_if(
                other.root.children, [&](const auto& child) { return child.get() == usual; }, chosen);
            const int before = out.meshes;
            judge(other);
            if (out.meshes == before)
                out.broken += QStringLiteral("variants: %1 shows no mesh").arg(QString::fromStdString(name));
            ++out.variants;
        }
    return out;
}

} // namespace ramure::test
