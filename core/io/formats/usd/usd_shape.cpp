#include "core/io/formats/usd/usd_shape.h"

#include "core/io/formats/glb/glb_mesh_reader.h"
#include "core/io/mesh_mending.h"
#include "core/surface/primitives/primitive_mesh.h"
#include <algorithm>
#include <cmath>

namespace ramure::usd {
namespace {

/// What a list of values has an element of.
enum class Rate : std::uint8_t { None, Constant, Face, Vertex, Corner };

/// A primvar: for each place of its rate the number of its value.
struct Spread
{
    Rate rate = Rate::None;
    std::vector<double> values;
    std::vector<Index> indices; ///< empty: they count from 0 on
    [[nodiscard]] Index at(std::size_t place) const
    {
        const std::size_t own = rate == Rate::Constant ? 0 : place;
        return indices.empty() ? static_cast<Index>(own) : indices[own];
    }
};

struct Counts
{
    std::size_t faces = 0, vertices = 0, corners = 0;
};

Expected<Spread> spreadOf(const Prim& prim, const std::string& name, int components, const Counts& counts)
{
    Spread out;
    const Attribute* attribute = prim.attribute(name);
    if (!attribute || !attribute->get())
        return out;
    auto values = numbersOf(prim, name, components);
    RAMURE_TRY(values);
    out.values = std::move(*values);
    const std::size_t count = out.values.size() / static_cast<std::size_t>(components);
    auto indices = indicesOf(prim, name + ":indices", count);
    RAMURE_TRY(indices);
    out.indices = std::move(*indices);
    const std::size_t places = out.indices.empty() ? count : out.indices.size();
    const std::string said = interpolationOf(*attribute);
    const std::tuple<const char*, Rate, std::size_t> rates[] = {
        {"constant", Rate::Constant, 1},
        {"uniform", Rate::Face, counts.faces},
        {"vertex", Rate::Vertex, counts.vertices},
        {"varying", Rate::Vertex, counts.vertices},
        {"faceVarying", Rate::Corner, counts.corners}};
    for (const auto& [word, rate, wanted] : rates)
        if (said == word) {
            out.rate = rate;
            if (places != wanted && !(rate == Rate::Constant && places > 0))
                return wrongAttribute(prim, name, RAMURE_NOOP("%1 values where there have to be %2"),
                                      {std::to_string(places), std::to_string(wanted)});
        }
    return out;
}

glm::vec3 vec3At(const std::vector<double>& numbers, std::size_t i)
{
    return {static_cast<float>(numbers[3 * i]), static_cast<float>(numbers[3 * i + 1]),
            static_cast<float>(numbers[3 * i + 2])};
}

/// A shape that its measures say, about its origin.
struct Form
{
    std::string_view type;
    PrimitiveShape shape;
};
constexpr Form forms[] = {{"Cube", PrimitiveShape::Box},
                          {"Sphere", PrimitiveShape::Sphere},
                          {"Cylinder", PrimitiveShape::Cylinder},
                          {"Cone", PrimitiveShape::Cone},
                          {"Plane", PrimitiveShape::Plane}};

Expected<Shape> formOf(const Prim& prim)
{
    const auto measure = [&](const char* name, double usual) {
        const auto said = numbersOf(prim, name, 1);
        return said && !said->empty() ? said->front() : usual;
    };
    PrimitiveParams params;
    params.shape = std::ranges::find(forms, prim.type, &Form::type)->shape;
    params.sides = 32;
    params.radius = measure("radius", 1.0);
    params.height = measure("height", 2.0);
    params.size = prim.type == "Plane" ? glm::dvec3(measure("width", 2.0), 1.0, measure("length", 2.0))
                                       : glm::dvec3(measure("size", 2.0));
    const std::string axis = prim.text("axis");
    params.axis = axis == "X" ? PrimitiveAxis::X : axis == "Y" ? PrimitiveAxis::Y : PrimitiveAxis::Z;
    if (!(params.radius > 0.0 && params.height > 0.0 && params.size.x > 0.0 && params.size.z > 0.0))
        return fail(ErrorCode::Invalid, RAMURE_NOOP("a shape without a size"));
    Shape out;
    out.mesh = primitiveSolid(params);
    const bool stands = params.shape == PrimitiveShape::Cylinder || params.shape == PrimitiveShape::Cone;
    for (glm::vec3& p : out.mesh.positions)
        p[int(params.axis)] -= stands ? float(0.5 * params.height) : 0.0F;
    out.faces = out.mesh.triangles.size();
    for (Index i = 0; i < out.mesh.faceCount(); ++i)
        out.faceOf.push_back(i);
    const auto colour = numbersOf(prim, "primvars:displayColor", 3);
    if (colour && colour->size() >= 3)
        out.mesh.colours.assign(out.faces, glb::srgb(glm::clamp(vec3At(*colour, 0), 0.0F, 1.0F)));
    return out;
}

class ShapeReader
{
public:
    explicit ShapeReader(const Prim& prim)
        : m_prim(prim)
    {
    }

    Expected<Shape> run()
    {
        const auto points = numbersOf(m_prim, "points", 3);
        RAMURE_TRY(points);
        for (std::size_t i = 0; i < points->size() / 3; ++i)
            m_out.mesh.positions.push_back(vec3At(*points, i));
        RAMURE_TRY(readFaces());
        RAMURE_TRY(readTexture());
        RAMURE_TRY(readNormals());
        RAMURE_TRY(readColours());
        cut();
        if (m_prim.text("orientation") == "leftHanded")
            for (auto* triangles : {&m_out.mesh.triangles, &m_out.mesh.uvTriangles})
                for (glm::uvec3& t : *triangles)
                    std::swap(t.y, t.z);
        return std::move(m_out);
    }

private:
    Expected<void> readFaces()
    {
        const auto counts = numbersOf(m_prim, "faceVertexCounts", 1);
        RAMURE_TRY(counts);
        auto indices = indicesOf(m_prim, "faceVertexIndices", m_out.mesh.positions.size());
        RAMURE_TRY(indices);
        double corners = 0.0;
        for (const double count : *counts) {
            if (!(count >= 3.0) || count != std::floor(count))
                return wrongAttribute(m_prim, "faceVertexCounts", RAMURE_NOOP("a face of %1 corners"),
                                      {std::to_string(static_cast<long>(count))});
            corners += count;
        }
        if (corners != double(indices->size()))
            return wrongAttribute(
                m_prim, "faceVertexIndices", RAMURE_NOOP("%1 values where there have to be %2"),
                {std::to_string(indices->size()), std::to_string(static_cast<std::size_t>(corners))});
        if (indices->size() > 3 * mostTriangles)
            return fail(ErrorCode::Limit, RAMURE_NOOP("more than %1 triangles"),
                        {std::to_string(mostTriangles)});
        m_counts = {counts->size(), m_out.mesh.positions.size(), indices->size()};
        m_out.faces = counts->size();
        std::size_t first = 0;
        for (std::size_t face = 0; face < counts->size(); ++face) {
            const auto size = static_cast<std::size_t>((*counts)[face]);
            for (std::size_t k = 1; k + 1 < size; ++k) {
                m_corners.emplace_back(first, first + k, first + k + 1);
                m_out.mesh.triangles.emplace_back((*indices)[first], (*indices)[first + k],
                                                  (*indices)[first + k + 1]);
                m_out.faceOf.push_back(static_cast<Index>(face));
            }
            if (size > 3)
                m_polygons.take(m_out.mesh.triangles, size, m_out.mesh.positions);
            first += size;
        }
        return {};
    }

    /// The coordinates that everybody calls st, else the first that there are.
    [[nodiscard]] std::string coordinates() const
    {
        if (m_prim.attribute("primvars:st"))
            return "primvars:st";
        for (const auto& [name, attribute] : m_prim.attributes)
            if (name.starts_with("primvars:") && attribute.type.starts_with("texCoord2"))
                return name;
        return "primvars:st";
    }

    Expected<void> readTexture()
    {
        const auto uv = spreadOf(m_prim, coordinates(), 2, m_counts);
        RAMURE_TRY(uv);
        if (uv->rate != Rate::Vertex && uv->rate != Rate::Corner)
            return {};
        for (std::size_t i = 0; i < uv->values.size(); i += 2)
            m_out.mesh.uv.emplace_back(static_cast<float>(uv->values[i]),
                                       static_cast<float>(uv->values[i + 1]));
        if (uv->rate == Rate::Vertex && uv->indices.empty())
            return {};
        const std::vector<glm::uvec3>& places = uv->rate == Rate::Vertex ? m_out.mesh.triangles : m_corners;
        for (const glm::uvec3& t : places)
            m_out.mesh.uvTriangles.emplace_back(uv->at(t.x), uv->at(t.y), uv->at(t.z));
        return {};
    }

    /// Normals of corners are left out: those of vertices are made anew from the faces.
    Expected<void> readNormals()
    {
        const std::string name = m_prim.attribute("primvars:normals") ? "primvars:normals" : "normals";
        const auto normals = spreadOf(m_prim, name, 3, m_counts);
        RAMURE_TRY(normals);
        if (normals->rate != Rate::Vertex)
            return {};
        for (std::size_t i = 0; i < m_counts.vertices; ++i)
            m_out.mesh.normals.push_back(vec3At(normals->values, normals->at(i)));
        reading::mendNormals(m_out.mesh, m_out.notes);
        for (glm::vec3& normal : m_out.mesh.normals)
            normal = glm::normalize(normal);
        return {};
    }

    Expected<void> readColours()
    {
        const auto colours = spreadOf(m_prim, "primvars:displayColor", 3, m_counts);
        RAMURE_TRY(colours);
        if (colours->rate == Rate::None)
            return {};
        const auto mean = [&](const glm::uvec3& places) {
            glm::vec3 sum(0.0F);
            for (int k = 0; k < 3; ++k)
                sum += vec3At(colours->values, colours->at(places[k]));
            return glb::srgb(glm::clamp(sum / 3.0F, 0.0F, 1.0F));
        };
        for (std::size_t i = 0; i < m_out.mesh.triangles.size(); ++i)
            m_out.mesh.colours.push_back(mean(colours->rate == Rate::Vertex   ? m_out.mesh.triangles[i]
                                              : colours->rate == Rate::Corner ? m_corners[i]
                                                                              : glm::uvec3(m_out.faceOf[i])));
        return {};
    }

    /// Faces that are no fans.
    void cut()
    {
        std::vector<std::string> notes;
        m_polygons.cut(m_out.mesh.positions, m_out.mesh.triangles, m_out.mesh.uvTriangles, notes);
        m_out.notes.insert(m_out.notes.end(), notes.begin(), notes.end());
    }

    const Prim& m_prim;
    Counts m_counts;
    Shape m_out;
    std::vector<glm::uvec3> m_corners; ///< per triangle its corners in the lists of the file
    reading::PolygonList m_polygons;
};

} // namespace

tl::unexpected<Error> wrongAttribute(const Prim& prim, const std::string& name, const char* text,
                                     std::vector<std::string> args)
{
    auto error = fail(ErrorCode::Invalid, text, std::move(args));
    const Attribute* attribute = prim.attribute(name);
    error.value().line = attribute ? attribute->line : prim.line;
    error.value().path = prim.name + "." + name;
    return error;
}

std::string interpolationOf(const Attribute& attribute)
{
    const auto said = attribute.metadata.find("interpolation");
    if (said != attribute.metadata.end() && !said->second.texts.empty())
        return said->second.texts.front();
    return attribute.type.starts_with("normal3") ? "vertex" : "constant";
}

Expected<std::vector<double>> numbersOf(const Prim& prim, const std::string& name, int components)
{
    const Attribute* attribute = prim.attribute(name);
    if (!attribute || !attribute->get())
        return std::vector<double>();
    if (attribute->components != components)
        return wrongAttribute(prim, name, RAMURE_NOOP("a list of the type %1"), {attribute->type});
    std::vector<double> out = attribute->get()->numbers;
    const auto isLarge = [](double number) { return !(std::abs(number) <= 1e30); }; // of single precision
    if (std::ranges::any_of(out, isLarge))
        return wrongAttribute(prim, name, RAMURE_NOOP("a number that is too large"));
    return out;
}

Expected<std::vector<Index>> indicesOf(const Prim& prim, const std::string& name, std::size_t end)
{
    const auto numbers = numbersOf(prim, name, 1);
    RAMURE_TRY(numbers);
    std::vector<Index> out;
    out.reserve(numbers->size());
    for (const double number : *numbers) {
        if (!(number >= 0.0 && number < double(end)) || number != std::floor(number))
            return wrongAttribute(prim, name, RAMURE_NOOP("index %1 of %2"),
                                  {std::to_string(static_cast<long>(number)), std::to_string(end)});
        out.push_back(static_cast<Index>(number));
    }
    return out;
}

bool isSurface(const Prim& prim)
{
    return prim.type == "Mesh" ||
           std::ranges::any_of(forms, [&](const Form& f) { return prim.type == f.type; });
}

Expected<Shape> shapeOf(const Prim& prim)
{
    auto shape = prim.type == "Mesh" ? ShapeReader(prim).run() : formOf(prim);
    if (!shape && shape.error().line == 0)
        shape.error().line = prim.line;
    return shape;
}

} // namespace ramure::usd
