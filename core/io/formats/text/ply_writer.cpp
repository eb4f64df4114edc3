#include "core/base/version.h"
#include "core/io/write_parts.h"
#include "core/surface/bark/bark_maps.h"
#include <array>
#include <bit>
#include <cstring>

namespace ramure {

namespace {

using writing::appendText;
using writing::forEach;
using writing::Ticker;

static_assert(std::endian::native == std::endian::little, "binary PLY is written as it lies in memory");

/// What the joined vertices carry: branch and level where one part has them, normals where all have.
struct Layout
{
    bool normals = true;
    bool branch = false;
    bool level = false;
    bool texture = true; ///< per corner of the faces, where all parts have it
    std::size_t vertices = 0;
    std::size_t faces = 0;
};

Layout layoutOf(std::span<const MeshPart> parts)
{
    Layout out;
    for (const MeshPart& part : parts) {
        out.normals = out.normals && (writing::hasNormals(*part.mesh) || part.mesh->positions.empty());
        out.branch = out.branch || !part.mesh->branch.empty();
        out.level = out.level || !part.mesh->level.empty();
        out.texture = out.texture && (writing::hasTexture(*part.mesh) || part.mesh->triangles.empty());
        out.vertices += part.mesh->positions.size();
        out.faces += part.mesh->triangles.size();
    }
    out.normals = out.normals && out.vertices > 0;
    out.texture = out.texture && out.faces > 0;
    return out;
}

std::string headerBegin(const WriteOptions& options)
{
    return std::string("ply\nformat ") + (options.ascii ? "ascii" : "binary_little_endian") +
           " 1.0\ncomment Ramure " RAMURE_VERSION "\n" +
           (options.comment.empty() ? "" : "comment " + writing::oneLine(options.comment) + "\n");
}

std::string header(const Layout& layout, const WriteOptions& options)
{
    std::string out = headerBegin(options) + "element vertex " + std::to_string(layout.vertices) +
                      "\nproperty float x\nproperty float y\nproperty float z\n";
    if (layout.normals)
        out += "property float nx\nproperty float ny\nproperty float nz\n";
    out += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    if (layout.branch)
        out += "property uint branch\n";
    if (layout.level)
        out += "property int level\n";
    return out + "element face " + std::to_string(layout.faces) +
           "\nproperty list uchar int vertex_indices\n" +
           (layout.texture ? "property list uchar float texcoord\n" : "") + "end_header\n";
}

template <class T> char* appendBytes(char* to, const T& value)
{
    std::memcpy(to, &value, sizeof value);
    return to + sizeof value;
}

Index valueAt(const std::vector<Index>& values, std::size_t i)
{
    return i < values.size() ? values[i] : noIndex;
}

glm::u8vec3 toned(const glm::u8vec3& colour, const glm::u8vec3& tone)
{
    return {(glm::uvec3(colour) * glm::uvec3(tone) + 127u) / 255u};
}

/// Of bark, by the radius of the wood.
std::vector<glm::u8vec3> agedColours(const MeshPart& part)
{
    const BarkParams& bark = part.material.bark;
    const glm::vec3 young(youngColour(bark)), limb(limbColour(bark)), old(part.material.colour);
    std::vector<glm::u8vec3> out;
    out.reserve(part.mesh->radius.size());
    for (std::size_t i = 0; i < part.mesh->radius.size(); ++i) {
        const double radius = double(part.mesh->radius[i]);
        const glm::vec3 bare = glm::mix(limb, old, barkRipeness(bark.family, radius));
        const glm::vec3 worn = glm::mix(glm::vec3(1.0F), weatheredBark, barkWeather(part.mesh->positions[i]));
        out.emplace_back(worn * glm::mix(young, bare, barkAge(bark.family, radius)) + 0.5F);
    }
    return out;
}

/// Of each vertex, from the last triangle that has it; empty where the triangles have no colours.
std::vector<glm::u8vec3> vertexColours(const MeshPart& part)
{
    const TriangleMesh& mesh = *part.mesh;
    if (writing::hasAges(part))
        return agedColours(part);
    if (!writing::hasColours(mesh))
        return {};
    std::vector<glm::u8vec3> out(mesh.positions.size(), part.material.colour);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (int k = 0; k < 3; ++k)
            out[mesh.triangles[t][k]] =
                part.material.tones ? toned(part.material.colour, mesh.colours[t]) : mesh.colours[t];
    return out;
}

char* binaryVertex(char* to, const TriangleMesh& mesh, const glm::u8vec3 colour, const Layout& layout,
                   std::size_t i)
{
    to = appendBytes(to, mesh.positions[i]);
    if (layout.normals)
        to = appendBytes(to, mesh.normals[i]);
    to = appendBytes(to, colour);
    if (layout.branch)
        to = appendBytes(to, valueAt(mesh.branch, i));
    if (layout.level)
        to = appendBytes(to, valueAt(mesh.level, i));
    return to;
}

char* asciiVertex(char* to, const TriangleMesh& mesh, const glm::u8vec3 colour, const Layout& layout,
                  std::size_t i)
{
    to = writing::appendVector(to, mesh.positions[i]);
    *to++ = ' ';
    if (layout.normals) {
        to = writing::appendVector(to, mesh.normals[i]);
        *to++ = ' ';
    }
    for (int k = 0; k < 3; ++k) {
        to = appendIndex(to, colour[k]);
        *to++ = ' ';
    }
    if (layout.branch) {
        to = appendIndex(to, valueAt(mesh.branch, i));
        *to++ = ' ';
    }
    if (layout.level) {
        const Index level = valueAt(mesh.level, i);
        to = level == noIndex ? appendText(to, "-1") : appendIndex(to, level);
        *to++ = ' ';
    }
    to[-1] = '\n';
    return to;
}

char* asciiFace(char* to, const glm::uvec3& t)
{
    to = appendText(to, "3 ");
    to = appendIndex(to, t.x);
    *to++ = ' ';
    to = appendIndex(to, t.y);
    *to++ = ' ';
    to = appendIndex(to, t.z);
    *to++ = '\n';
    return to;
}

/// The same with u and v of each corner.
char* asciiTexturedFace(char* to, const glm::uvec3& t, const std::array<glm::vec2, 3>& uv)
{
    to = asciiFace(to, t);
    to = appendText(to - 1, " 6");
    for (const glm::vec2& at : uv) {
        *to++ = ' ';
        to = appendFloat(to, at.x);
        *to++ = ' ';
        to = appendFloat(to, at.y);
    }
    *to++ = '\n';
    return to;
}

constexpr std::size_t longestVertex = 6 * (maxFloatText + 1) + 5 * (maxIndexText + 1) + 16;
constexpr std::size_t longestFace = 48;

bool writeVertices(FileWriter& out, const MeshPart& part, const Layout& layout, bool ascii, Ticker& ticker)
{
    const TriangleMesh& mesh = *part.mesh;
    const std::vector<glm::u8vec3> colours = vertexColours(part);
    return forEach(mesh.positions.size(), longestVertex, ticker, out, [&](char* to, std::size_t i) {
        const glm::u8vec3 colour = colours.empty() ? part.material.colour : colours[i];
        return ascii ? asciiVertex(to, mesh, colour, layout, i) : binaryVertex(to, mesh, colour, layout, i);
    });
}

bool writeTexturedFaces(FileWriter& out, const TriangleMesh& mesh, Index first, bool ascii, Ticker& ticker)
{
    const std::vector<glm::uvec3>& texture = writing::textureTriangles(mesh);
    constexpr std::size_t longest = longestFace + 6 * (maxFloatText + 1) + 8;
    return forEach(mesh.triangles.size(), longest, ticker, out, [&](char* to, std::size_t i) {
        const glm::uvec3 t = mesh.triangles[i] + first;
        const std::array<glm::vec2, 3> uv{mesh.uv[texture[i].x], mesh.uv[texture[i].y],
                                          mesh.uv[texture[i].z]};
        if (ascii)
            return asciiTexturedFace(to, t, uv);
        *to++ = 3;
        to = appendBytes(to, t);
        *to++ = 6;
        return appendBytes(to, uv);
    });
}

bool writeFaces(FileWriter& out, const TriangleMesh& mesh, Index first, bool ascii, Ticker& ticker)
{
    const std::vector<glm::uvec3>& triangles = mesh.triangles;
    if (ascii)
        return forEach(triangles.size(), longestFace, ticker, out,
                       [&](char* to, std::size_t i) { return asciiFace(to, triangles[i] + first); });
    return forEach(triangles.size(), 1 + sizeof(glm::uvec3), ticker, out, [&](char* to, std::size_t i) {
        *to++ = 3;
        return appendBytes(to, triangles[i] + first);
    });
}

void writeElements(FileWriter& out, std::span<const MeshPart> parts, const Layout& layout, bool ascii,
                   Ticker& ticker)
{
    for (const MeshPart& part : parts)
        if (!writeVertices(out, part, layout, ascii, ticker))
            return;
    Index first = 0;
    for (const MeshPart& part : parts) {
        if (!(layout.texture ? writeTexturedFaces(out, *part.mesh, first, ascii, ticker)
                             : writeFaces(out, *part.mesh, first, ascii, ticker)))
            return;
        first += part.mesh->vertexCount();
    }
}

} // namespace

Expected<void> writePly(const std::string& path, std::span<const MeshPart> parts, const WriteOptions& options,
                        const Progress& progress)
{
    if (const auto finite = writing::checkFinite(parts, path); !finite)
        return finite;
    auto out = FileWriter::open(path);
    RAMURE_TRY(out);
    const Layout layout = layoutOf(parts);
    out->append(header(layout, options));
    Ticker ticker(progress, layout.vertices + layout.faces);
    writeElements(*out, parts, layout, options.ascii, ticker);
    if (ticker.cancelled()) {
        auto error = fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        error.value().file = path;
        return error;
    }
    return out->commit();
}

Expected<void> writePlyLines(const std::string& path, const LinePart& lines, const WriteOptions& options)
{
    if (const auto finite = writing::checkFinite(lines, path); !finite)
        return finite;
    auto out = FileWriter::open(path);
    RAMURE_TRY(out);
    out->append(headerBegin(options) + "element vertex " + std::to_string(lines.positions.size()) +
                "\nproperty float x\nproperty float y\nproperty float z\nelement edge " +
                std::to_string(lines.lines.size()) +
                "\nproperty int vertex1\nproperty int vertex2\nend_header\n");
    for (const glm::vec3& p : lines.positions) {
        char* to = out->room(longestVertex);
        to = options.ascii ? writing::appendVector(to, p) : appendBytes(to, p);
        if (options.ascii)
            *to++ = '\n';
        out->advance(to);
    }
    for (const glm::uvec2& line : lines.lines) {
        char* to = out->room(longestVertex);
        if (options.ascii) {
            to = appendIndex(to, line.x);
            *to++ = ' ';
            to = appendIndex(to, line.y);
            *to++ = '\n';
        } else {
            to = appendBytes(to, line);
        }
        out->advance(to);
    }
    return out->commit();
}

} // namespace ramure
