#include "core/io/formats/print/three_mf_reader.h"

#include "core/io/file_space.h"
#include "core/io/mesh_mending.h"
#include "core/io/read_parts.h"
#include "core/io/zip_file.h"
#include <charconv>
#include <cmath>
#include <expat.h>
#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <memory>
#include <optional>

namespace ramure {
namespace {

constexpr std::uint64_t mostBytes = std::uint64_t(4) << 30;
constexpr std::uint64_t mostRelations = std::uint64_t(1) << 20;
constexpr std::size_t mostPrintTriangles = 50'000'000; ///< of all items together
constexpr int mostDepth = 16;                          ///< of components in components
constexpr double largest = 1e30;                       ///< coordinate, far below the end of single precision
constexpr const char* usualModel = "3D/3dmodel.model";

using XmlParser = std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)>;

/// The value of an attribute, or nothing.
const char* attribute(const char** list, std::string_view name)
{
    for (; *list; list += 2)
        if (name == *list)
            return list[1];
    return nullptr;
}

template <class Number> bool isNumber(const char* text, Number& number)
{
    if (!text)
        return false;
    std::string_view rest = text;
    while (!rest.empty() && reading::isBlank(rest.front()))
        rest.remove_prefix(1);
    if (rest.starts_with('+'))
        rest.remove_prefix(1);
    const auto [end, problem] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
    for (const char* at = end; problem == std::errc() && at != rest.data() + rest.size(); ++at)
        if (!reading::isBlank(*at))
            return false;
    return problem == std::errc();
}

/// 12 numbers, of a row vector's matrix row by row; none: as it is.
std::optional<glm::dmat4> matrixOf(const char* text)
{
    glm::dmat4 out(1.0);
    if (!text)
        return out;
    std::string_view rest = text;
    for (int i = 0; i < 12; ++i) {
        const std::size_t begin = std::min(rest.find_first_not_of(" \t\r\n"), rest.size());
        const std::size_t end = std::min(rest.find_first_of(" \t\r\n", begin), rest.size());
        double number = 0.0;
        if (!isNumber(std::string(rest.substr(begin, end - begin)).c_str(), number) || !std::isfinite(number))
            return std::nullopt;
        out[i / 3][i % 3] = number;
        rest.remove_prefix(end);
    }
    return out;
}

struct Reference
{
    std::string object;
    glm::dmat4 place{1.0};
};

/// Coordinates become floats when all matrices are known.
struct ExactMesh
{
    std::string name;
    std::vector<glm::dvec3> positions;
    std::vector<glm::uvec3> triangles;
    std::vector<glm::u8vec3> colours; ///< of the triangles, or none
};

struct Resource
{
    ExactMesh mesh;
    std::string palette;               ///< where the numbers of colours count that do not say it themselves
    std::optional<glm::u8vec3> colour; ///< of triangles that say none
    std::vector<Reference> components;
};

/// "#RRGGBB" or "#RRGGBBAA"; grey where it is anything else.
glm::u8vec3 hexColour(const char* text)
{
    const std::string_view digits = text && *text == '#' ? text + 1 : "";
    std::uint32_t value = 0;
    const auto read =
        std::from_chars(digits.data(), digits.data() + std::min<std::size_t>(digits.size(), 6), value, 16);
    if (digits.size() < 6 || read.ec != std::errc() || read.ptr != digits.data() + 6)
        return reading::plainColour;
    return {value >> 16 & 0xFFU, value >> 8 & 0xFFU, value & 0xFFU};
}

/// Single precision, from one origin on.
ReadMesh rounded(std::vector<ExactMesh> meshes)
{
    glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
    for (const ExactMesh& mesh : meshes)
        for (const glm::dvec3& p : mesh.positions) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
    ReadMesh out;
    out.origin = reading::farOrigin(low, high);
    if (out.origin != glm::dvec3(0.0))
        out.notes.push_back(reading::farNote(out.origin));
    for (ExactMesh& mesh : meshes) {
        ReadObject& object = out.objects.emplace_back();
        object.name = std::move(mesh.name);
        object.mesh.positions = reading::movedFrom(out.origin, mesh.positions);
        object.mesh.triangles = std::move(mesh.triangles);
        object.mesh.colours = std::move(mesh.colours);
    }
    return out;
}

/// A model part as it is parsed.
class ModelReader
{
public:
    explicit ModelReader(std::string file)
        : m_file(std::move(file))
    {
        XML_SetUserData(m_parser.get(), this);
        XML_SetElementHandler(m_parser.get(), &ModelReader::begin, nullptr);
        XML_SetStartDoctypeDeclHandler(m_parser.get(), &ModelReader::doctype);
    }

    /// False: it is of no use to go on.
    bool take(std::string_view piece)
    {
        if (XML_Parse(m_parser.get(), piece.data(), static_cast<int>(piece.size()), XML_FALSE) ==
            XML_STATUS_OK)
            return true;
        if (!m_problem)
            m_problem = broken().value();
        return false;
    }
    /// \param space out of the file's, whose unit is a metre
    Expected<ReadMesh> finish(const std::string& fileName, const std::optional<glm::dmat4>& space)
    {
        if (!m_problem && XML_Parse(m_parser.get(), "", 0, XML_TRUE) != XML_STATUS_OK)
            m_problem = broken().value();
        const glm::dmat4 back = space ? *space * glm::dmat4(glm::dmat3(m_metres)) : glm::dmat4(1.0);
        std::vector<ExactMesh> meshes;
        for (const Reference& item : m_items)
            if (!m_problem)
                add(meshes, item.object, back * item.place, 0);
        if (!m_problem && meshes.empty())
            refuse(ErrorCode::Invalid, RAMURE_NOOP("the file holds no mesh to print"));
        if (m_problem)
            return fail(*m_problem);
        for (ExactMesh& mesh : meshes)
            if (mesh.name.empty())
                mesh.name = fileName;
        return rounded(std::move(meshes));
    }

private:
    static void begin(void* self, const char* name, const char** attributes)
    {
        auto& reader = *static_cast<ModelReader*>(self);
        if (!reader.m_problem)
            reader.element(name, attributes);
    }
    static void doctype(void* self, const char*, const char*, const char*, int)
    {
        static_cast<ModelReader*>(self)->refuse(ErrorCode::Syntax,
                                                RAMURE_NOOP("a document type has no place in a 3MF file"));
    }

    void element(std::string_view name, const char** attributes)
    {
        if (name == "vertex")
            vertex(attributes);
        else if (name == "triangle")
            triangle(attributes);
        else if (name == "object") {
            const char* id = attribute(attributes, "id");
            const char* title = attribute(attributes, "name");
            m_object = &m_objects[id ? id : ""];
            m_object->mesh.name = title ? title : "";
            if (const char* palette = attribute(attributes, "pid"))
                m_object->palette = palette;
            m_object->colour = colourAt(m_object->palette, attribute(attributes, "pindex"));
        } else if (name == "basematerials" || name.ends_with(":colorgroup")) {
            const char* id = attribute(attributes, "id");
            m_palette = &m_palettes[id ? id : ""];
        } else if ((name == "base" || name.ends_with(":color")) && m_palette)
            m_palette->push_back(hexColour(attribute(attributes, name == "base" ? "displaycolor" : "color")));
        else if (name == "component" && m_object)
            reference(m_object->components, attributes);
        else if (name == "item")
            reference(m_items, attributes);
        else if (name == "model")
            unit(attribute(attributes, "unit"));
    }
    void vertex(const char** attributes)
    {
        glm::dvec3 p(0.0);
        constexpr const char* axes[] = {"x", "y", "z"};
        for (int axis = 0; axis < 3; ++axis)
            if (!isNumber(attribute(attributes, axes[axis]), p[axis]) || !(std::abs(p[axis]) <= largest))
                return refuse(ErrorCode::Invalid, RAMURE_NOOP("a vertex without three finite numbers"));
        if (m_object)
            m_object->mesh.positions.push_back(p);
    }
    void triangle(const char** attributes)
    {
        glm::uvec3 t(0);
        constexpr const char* corners[] = {"v1", "v2", "v3"};
        if (!m_object)
            return;
        for (int k = 0; k < 3; ++k)
            if (!isNumber(attribute(attributes, corners[k]), t[k]) || t[k] >= m_object->mesh.positions.size())
                return refuse(ErrorCode::Invalid,
                              RAMURE_NOOP("a triangle with a vertex that does not exist"));
        m_object->mesh.triangles.push_back(t);
        paint(attributes);
    }
    /// The triangle that came last: the mean of its corners' colours.
    void paint(const char** attributes)
    {
        const char* own = attribute(attributes, "pid");
        glm::uvec3 sum(0);
        unsigned count = 0;
        for (const char* corner : {"p1", "p2", "p3"})
            if (const auto colour = colourAt(own ? own : m_object->palette, attribute(attributes, corner))) {
                sum += glm::uvec3(*colour);
                ++count;
            }
        if (count == 0)
            return;
        ExactMesh& mesh = m_object->mesh;
        mesh.colours.resize(mesh.triangles.size(), m_object->colour.value_or(reading::plainColour));
        mesh.colours.back() = glm::u8vec3((sum + count / 2) / count);
    }
    [[nodiscard]] std::optional<glm::u8vec3> colourAt(const std::string& palette, const char* place) const
    {
        const auto found = m_palettes.find(palette);
        std::size_t number = 0;
        if (found == m_palettes.end() || !isNumber(place, number) || number >= found->second.size())
            return std::nullopt;
        return found->second[number];
    }
    void reference(std::vector<Reference>& to, const char** attributes)
    {
        for (const char** each = attributes; *each; each += 2)
            if (std::string_view(*each).ends_with(":path"))
                return refuse(ErrorCode::Invalid, RAMURE_NOOP("objects that stand in another part of the "
                                                              "archive are not read"));
        const char* object = attribute(attributes, "objectid");
        const auto place = matrixOf(attribute(attributes, "transform"));
        if (!object || !place)
            return refuse(ErrorCode::Invalid, RAMURE_NOOP("an object without a number, or a broken matrix"));
        to.push_back({object, *place});
    }
    void unit(const char* name)
    {
        constexpr std::pair<std::string_view, double> units[] = {{"micron", 1e-6},     {"millimeter", 1e-3},
                                                                 {"centimeter", 1e-2}, {"meter", 1.0},
                                                                 {"inch", 0.0254},     {"foot", 0.3048}};
        for (const auto& [known, metres] : units)
            if (name && known == name)
                m_metres = metres;
    }

    /// The object in its place, and those that it is made of.
    void add(std::vector<ExactMesh>& out, const std::string& id, const glm::dmat4& place, int depth)
    {
        const auto found = m_objects.find(id);
        if (found == m_objects.end())
            return refuse(ErrorCode::Invalid, RAMURE_NOOP("there is no object %1"), {reading::excerpt(id)});
        const Resource& object = found->second;
        m_count += object.mesh.triangles.size() + 1;
        if (depth > mostDepth || m_count > mostPrintTriangles)
            return refuse(ErrorCode::Limit, RAMURE_NOOP("components of components without an end"));
        if (!object.mesh.triangles.empty())
            addMesh(out.emplace_back(object.mesh), object, place);
        for (const Reference& component : object.components)
            if (!m_problem)
                add(out, component.object, place * component.place, depth + 1);
    }

    static void addMesh(ExactMesh& mesh, const Resource& object, const glm::dmat4& place)
    {
        for (glm::dvec3& p : mesh.positions)
            p = glm::dvec3(place * glm::dvec4(p, 1.0));
        if (glm::determinant(glm::dmat3(place)) < 0.0)
            for (glm::uvec3& t : mesh.triangles)
                std::swap(t.y, t.z);
        if (!mesh.colours.empty() || object.colour)
            mesh.colours.resize(mesh.triangles.size(), object.colour.value_or(reading::plainColour));
    }

    void refuse(ErrorCode code, const char* text, std::vector<std::string> args = {})
    {
        auto error = fail(code, text, std::move(args));
        error.value().file = m_file;
        error.value().line = static_cast<int>(XML_GetCurrentLineNumber(m_parser.get()));
        m_problem = std::move(error.value());
        XML_StopParser(m_parser.get(), XML_FALSE);
    }
    [[nodiscard]] tl::unexpected<Error> broken() const
    {
        auto error = fail(ErrorCode::Syntax, RAMURE_NOOP("the XML is broken or cut off (%1)"),
                          {XML_ErrorString(XML_GetErrorCode(m_parser.get()))});
        error.value().file = m_file;
        error.value().line = static_cast<int>(XML_GetCurrentLineNumber(m_parser.get()));
        return error;
    }

    std::string m_file;
    XmlParser m_parser{XML_ParserCreate(nullptr), &XML_ParserFree};
    double m_metres = 1e-3; // what a file without a unit has
    std::map<std::string, Resource, std::less<>> m_objects;
    std::map<std::string, std::vector<glm::u8vec3>, std::less<>> m_palettes;
    std::vector<glm::u8vec3>* m_palette = nullptr; ///< that is being read
    Resource* m_object = nullptr;                  ///< that is being read
    std::vector<Reference> m_items;
    std::size_t m_count = 0;
    std::optional<Error> m_problem;
};

/// The part that the relations of the package name; else where everybody has it.
std::string modelName(const ZipReader& archive)
{
    std::string name = usualModel;
    const auto begin = [](void* found, const char* element, const char** attributes) {
        const char* type = attribute(attributes, "Type");
        const char* target = attribute(attributes, "Target");
        if (std::string_view(element) == "Relationship" && type && target &&
            std::string_view(type).ends_with("/3dmodel"))
            *static_cast<std::string*>(found) = target + (*target == '/' ? 1 : 0);
    };
    const XmlParser parser(XML_ParserCreate(nullptr), &XML_ParserFree);
    XML_SetUserData(parser.get(), &name);
    XML_SetElementHandler(parser.get(), begin, nullptr);
    // What is wrong with the relations shows when there is no such part.
    (void)archive.read("_rels/.rels", mostRelations, [&parser](std::string_view piece) {
        return XML_Parse(parser.get(), piece.data(), static_cast<int>(piece.size()), XML_FALSE) ==
               XML_STATUS_OK;
    });
    return archive.has(name) ? name : usualModel;
}

} // namespace

Expected<ReadMesh> readThreeMf(const std::string& path, const Progress& progress)
{
    const auto archive = ZipReader::open(path);
    RAMURE_TRY(archive);
    ModelReader model(path);
    const auto read = archive->read(
        modelName(*archive), mostBytes, [&model](std::string_view piece) { return model.take(piece); },
        progress);
    RAMURE_TRY(read);
    FileSpace space;
    space.up = UpAxis::Z;
    const bool isOther = !fileSpaceOf(path); // our own say theirs, and are turned by it
    return model.finish(reading::stem(path),
                        isOther ? std::optional(glm::inverse(space.matrix())) : std::nullopt);
}

} // namespace ramure
