#include "core/io/formats/usd/usd_mesh.h"

#include "core/io/formats/glb/glb_mesh_reader.h"
#include "core/io/formats/glb/glb_parts.h"
#include "core/io/formats/usd/usd_materials.h"
#include "core/io/write_parts.h"
#include "core/math/box.h"
#include "core/math/finite.h"
#include "core/math/random.h"
#include "core/surface/bark/bark_maps.h"
#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <set>
#include <tuple>

namespace ramure::usd {
namespace {

const std::vector<std::string> perVertex{"interpolation = \"vertex\""};
const std::vector<std::string> perCorner{"interpolation = \"faceVarying\""};
const std::vector<std::string> perFace{"interpolation = \"uniform\""};
const std::vector<std::string> perCopy{"interpolation = \"varying\""};
const std::vector<std::string> once{"interpolation = \"constant\""};
constexpr double coarse = 1e3, fine = 1e5; // decimals of colours and phases, of texture coordinates

tl::unexpected<Error> notFinite(const std::string& name)
{
    return fail(ErrorCode::Invalid, RAMURE_NOOP("a coordinate of %1 is not a finite number"), {name});
}

/// Numbers with five digits: of sizes.
char* appendShort(char* to, double number)
{
    return std::to_chars(to, to + 24, number, std::chars_format::general, 5).ptr;
}

void writeIndices(Text& text, const char* head, const std::vector<glm::uvec3>& triangles)
{
    text.array(head, 3 * triangles.size(), [&](char* to, std::size_t i) {
        return appendIndex(to, triangles[i / 3][static_cast<int>(i % 3)]);
    });
}

void writeCoordinates(Text& text, const TriangleMesh& mesh)
{
    const auto element = [&](char* to, std::size_t i) { return appendRoundedTuple(to, mesh.uv[i], fine); };
    text.array("texCoord2f[] primvars:st", mesh.uv.size(), element,
               mesh.uvTriangles.empty() ? perVertex : perCorner);
    if (!mesh.uvTriangles.empty())
        writeIndices(text, "int[] primvars:st:indices", mesh.uvTriangles);
}

/// Each colour once, and for each face its number. Painted ones have coordinates besides.
void writeColours(Text& text, const TriangleMesh& mesh, const Colours& colours)
{
    const char* head = "color3f[] primvars:displayColor";
    if (!writing::hasColours(mesh)) {
        text.line(std::string(head) + " = [" + colourText(colours.constant) + "] (");
        text.line("    " + once.front());
        text.line(")");
        return;
    }
    std::map<std::tuple<int, int, int>, Index> numbers;
    std::vector<glm::u8vec3> each;
    std::vector<Index> of;
    of.reserve(mesh.colours.size());
    for (const glm::u8vec3& c : mesh.colours) {
        const auto [place, isNew] = numbers.try_emplace({c.r, c.g, c.b}, static_cast<Index>(each.size()));
        if (isNew)
            each.push_back(c);
        of.push_back(place->second);
    }
    text.array(
        head, each.size(),
        [&](char* to, std::size_t i) {
            return appendRoundedTuple(to, linearColour(each[i]) * colours.factor, 10.0 * coarse);
        },
        perFace);
    text.array("int[] primvars:displayColor:indices", of.size(),
               [&](char* to, std::size_t i) { return appendIndex(to, of[i]); });
    if (!colours.isPainted)
        return;
    text.array(
        "texCoord2f[] primvars:st", each.size(),
        [&](char* to, std::size_t i) {
            const glm::vec3 colour = glm::min(linearColour(each[i]) * colours.factor, 1.0F);
            return appendRoundedTuple(to, placeInPalette(glb::srgb(colour)), fine);
        },
        perCorner);
    text.array("int[] primvars:st:indices", 3 * of.size(),
               [&](char* to, std::size_t i) { return appendIndex(to, of[i / 3]); });
}

/// Each stays the same when copies of other branches come or go. They are numbers that scripts hold exactly.
std::vector<std::uint64_t> idsOf(const std::vector<ExportCopy>& copies)
{
    std::set<std::uint64_t> taken;
    std::vector<std::uint64_t> out;
    for (const ExportCopy& copy : copies) {
        std::uint64_t id = mixBits(copy.key + mixBits(copy.number + 1)) >> 12U;
        while (!taken.insert(id).second) // fruit of one cluster
            id = mixBits(id) >> 12U;
        out.push_back(id);
    }
    return out;
}

void writePlaces(Text& text, const std::vector<ExportCopy>& copies)
{
    std::vector<float> sizes;
    std::vector<glm::dquat> turns;
    for (const ExportCopy& copy : copies) {
        const double size = glm::length(glm::dvec3(copy.place[0]));
        sizes.push_back(static_cast<float>(size));
        turns.push_back(glm::normalize(glm::quat_cast(glm::dmat3(copy.place) / size)));
    }
    const std::vector<std::uint64_t> ids = idsOf(copies);
    text.array("int64[] ids", copies.size(),
               [&](char* to, std::size_t i) { return std::to_chars(to, to + 24, ids[i]).ptr; });
    text.array("quath[] orientations", copies.size(), [&](char* to, std::size_t i) {
        return appendRoundedTuple(to, glm::vec4(turns[i].w, turns[i].x, turns[i].y, turns[i].z));
    });
    text.array("point3f[] positions", copies.size(),
               [&](char* to, std::size_t i) { return appendTuple(to, glm::vec3(copies[i].place[3])); });
    text.array("int[] protoIndices", copies.size(), [](char* to, std::size_t) {
        *to = '0';
        return to + 1;
    });
    text.array("float3[] scales", copies.size(), [&](char* to, std::size_t i) {
        const double size = double(sizes[i]);
        for (const char* between : {"(", ",", ","})
            to = appendShort(writing::appendText(to, between), size);
        *to++ = ')';
        return to;
    });
}

} // namespace

glm::vec3 linearColour(const glm::u8vec3& colour)
{
    return {glb::linear(colour.r), glb::linear(colour.g), glb::linear(colour.b)};
}

void Box::take(const glm::dvec3& point)
{
    low = glm::min(low, point);
    high = glm::max(high, point);
}

void writeExtent(Text& text, const Box& box)
{
    if (box.isEmpty())
        return;
    const glm::vec3 corners[] = {glm::vec3(box.low), glm::vec3(box.high)};
    text.array("float3[] extent", 2, [&](char* to, std::size_t i) { return appendTuple(to, corners[i]); });
}

void writeMesh(Text& text, const TriangleMesh& mesh, bool textured, bool twoSided, const Colours& colours)
{
    Box box;
    for (const glm::vec3& p : mesh.positions)
        box.take(p);
    if (twoSided)
        text.line("uniform bool doubleSided = 1");
    writeExtent(text, box);
    text.array("int[] faceVertexCounts", mesh.triangles.size(), [](char* to, std::size_t) {
        *to = '3';
        return to + 1;
    });
    writeIndices(text, "int[] faceVertexIndices", mesh.triangles);
    if (writing::hasNormals(mesh))
        text.array(
            "normal3f[] normals", mesh.normals.size(),
            [&](char* to, std::size_t i) { return appendRoundedTuple(to, mesh.normals[i]); }, perVertex);
    text.array("point3f[] points", mesh.positions.size(),
               [&](char* to, std::size_t i) { return appendTuple(to, mesh.positions[i]); });
    if (!colours.isHanded)
        writeColours(text, mesh, colours);
    if (textured && writing::hasTexture(mesh))
        writeCoordinates(text, mesh);
    text.line("uniform token subdivisionScheme = \"none\"");
}

void writeShapes(Text& text, const TriangleMesh& mesh, const ExportShapes& shapes, double rate)
{
    // Between two moments of the same form it stays as it is.
    std::vector<std::size_t> moments;
    for (std::size_t i = 0; i < shapes.at.size(); ++i)
        if (i == 0 || i + 1 == shapes.at.size() || shapes.at[i] != shapes.at[i - 1] ||
            shapes.at[i] != shapes.at[i + 1])
            moments.push_back(i);
    const auto write = [&](const char* head, auto&& sample) {
        text.openBlock(std::string(head) + ".timeSamples = {");
        for (const std::size_t i : moments)
            sample(double(shapes.seconds[i]) * rate,
                   shapes.at[i] == noIndex ? nullptr : &shapes.shapes[shapes.at[i]]);
        text.close();
    };
    const auto pointsOf = [&](const ExportShape* shape) -> const std::vector<glm::vec3>& {
        return shape ? shape->positions : mesh.positions;
    };
    const auto normalsOf = [&](const ExportShape* shape) -> const std::vector<glm::vec3>& {
        return shape && !shape->normals.empty() ? shape->normals : mesh.normals;
    };
    write("float3[] extent", [&](double code, const ExportShape* shape) {
        Box box;
        for (const glm::vec3& p : pointsOf(shape))
            box.take(p);
        const glm::vec3 corners[] = {glm::vec3(box.low), glm::vec3(box.high)};
        text.sample(code, 2, [&](char* to, std::size_t i) { return appendTuple(to, corners[i]); });
    });
    if (writing::hasNormals(mesh) &&
        std::ranges::any_of(shapes.shapes, [](const ExportShape& shape) { return !shape.normals.empty(); }))
        write("normal3f[] normals", [&](double code, const ExportShape* shape) {
            const std::vector<glm::vec3>& normals = normalsOf(shape);
            text.sample(code, normals.size(),
                        [&](char* to, std::size_t i) { return appendRoundedTuple(to, normals[i]); });
        });
    write("point3f[] points", [&](double code, const ExportShape* shape) {
        const std::vector<glm::vec3>& points = pointsOf(shape);
        text.sample(code, points.size(), [&](char* to, std::size_t i) { return appendTuple(to, points[i]); });
    });
}

glm::vec3 meanOf(const TriangleMesh& mesh)
{
    glm::dvec3 sum(0.0);
    for (const glm::u8vec3& colour : mesh.colours)
        sum += glm::dvec3(linearColour(colour));
    return mesh.colours.empty() ? glm::vec3(1.0F) : glm::vec3(sum / double(mesh.colours.size()));
}

std::vector<Index> youngTriangles(const TriangleMesh& mesh, const BarkParams& bark)
{
    std::vector<Index> out;
    if (bark.family == BarkFamily::Plain || mesh.radius.size() != mesh.positions.size())
        return out;
    for (Index i = 0; i < mesh.faceCount(); ++i) {
        float radius = 0.0F;
        for (int k = 0; k < 3; ++k)
            radius = std::max(radius, mesh.radius[mesh.triangles[i][k]]);
        if (barkAge(bark.family, double(radius)) < 0.5F)
            out.push_back(i);
    }
    return out;
}

void writeYoung(Text& text, std::span<const Index> triangles, const std::string& bind)
{
    if (triangles.empty())
        return;
    text.open("def GeomSubset \"young\"", {"prepend apiSchemas = [\"MaterialBindingAPI\"]"});
    text.line("uniform token elementType = \"face\"");
    text.line("uniform token familyName = \"materialBind\"");
    text.array("int[] indices", triangles.size(),
               [&](char* to, std::size_t i) { return appendIndex(to, triangles[i]); });
    text.line(bind);
    text.close();
}

void writePhases(Text& text, const ExportSeasons& seasons, Index vertices)
{
    const std::size_t each = seasons.phases.empty() ? 0 : vertices / seasons.phases.size();
    if (each == 0)
        return;
    text.array(
        "float[] primvars:season", vertices,
        [&](char* to, std::size_t i) {
            return appendRounded(to, double(seasons.phases[std::min(i / each, seasons.phases.size() - 1)]),
                                 coarse);
        },
        perVertex);
}

void writeCopies(Text& text, const ExportCopies& copies, const std::string& prototype,
                 const std::optional<glm::vec3>& colour)
{
    ramure::Box shape; // of a million copies its corners are looked at, not each vertex
    for (const glm::vec3& p : copies.shape->positions)
        shape.add(glm::dvec3(p));
    Box box;
    for (const ExportCopy& copy : copies.copies)
        for (int corner = 0; corner < 8; ++corner)
            box.take(glm::dvec3(copy.place * glm::dvec4(shape.corner(corner), 1.0)));
    writeExtent(text, box);
    writePlaces(text, copies.copies);
    if (colour)
        text.array(
            "color3f[] primvars:displayColor", copies.copies.size(),
            [&](char* to, std::size_t i) {
                return appendRoundedTuple(to, glb::linear(copies.copies[i].tint) * *colour, coarse);
            },
            perCopy);
    if (copies.seasons && copies.seasons->phases.size() == copies.copies.size())
        text.array(
            "float[] primvars:season", copies.copies.size(),
            [&](char* to, std::size_t i) {
                return appendRounded(to, double(copies.seasons->phases[i]), coarse);
            },
            perCopy);
    text.line("rel prototypes = " + target(prototype));
}

void writeLines(Text& text, const LinePart& lines)
{
    Box box;
    for (const glm::vec3& p : lines.positions)
        box.take(p);
    writeExtent(text, box);
    text.array("int[] curveVertexCounts", lines.lines.size(), [](char* to, std::size_t) {
        *to = '2';
        return to + 1;
    });
    text.array("point3f[] points", 2 * lines.lines.size(), [&](char* to, std::size_t i) {
        return appendTuple(to, lines.positions[lines.lines[i / 2][static_cast<int>(i % 2)]]);
    });
    text.line("uniform token type = \"linear\"");
    text.line("float[] widths = [0.01] (");
    text.line("    " + once.front());
    text.line(")");
}

Expected<void> checkFinite(const TriangleMesh& mesh, const std::string& name)
{
    if (std::ranges::all_of(mesh.positions, &isFinite<3, float>) &&
        std::ranges::all_of(mesh.normals, &isFinite<3, float>) &&
        std::ranges::all_of(mesh.uv, &isFinite<2, float>))
        return {};
    return notFinite(name);
}

Expected<void> checkFinite(const glm::dmat4& place, const std::string& name)
{
    for (int column = 0; column < 4; ++column)
        if (!isFinite(glm::dvec3(place[column])))
            return notFinite(name);
    return {};
}

Expected<void> checkFinite(const ExportCopies& copies)
{
    for (const ExportCopy& copy : copies.copies) {
        RAMURE_TRY(checkFinite(copy.place, copies.name));
        if (!isFinite(copy.tint) || !(glm::length(glm::dvec3(copy.place[0])) > 0.0))
            return notFinite(copies.name);
    }
    return checkFinite(*copies.shape, copies.name);
}

} // namespace ramure::usd
