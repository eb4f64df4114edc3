#include "core/io/write_parts.h"
#include <algorithm>
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
        out.vertices += part.mesh->positions.size();
        out.faces += part.mesh->triangles.size();
    }
    out.normals = out.normals && out.vertices > 0;
    return out;
}

std::string headerBegin(bool ascii)
{
    return std::string("ply\nformat ") + (ascii ? "ascii" : "binary_little_endian") +
           " 1.0\ncomment Ramure " RAMURE_VERSION "\n";
}

std::string header(const Layout& layout, bool ascii)
{
    std::string out = headerBegin(ascii) + "element vertex " + std::to_string(layout.vertices) +
                      "\nproperty float x\nproperty float y\nproperty float z\n";
    if (layout.normals)
        out += "property float nx\nproperty float ny\nproperty float nz\n";
    out += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    if (layout.branch)
        out += "property uint branch\n";
    if (layout.level)
        out += "property int level\n";
    return out + "element face " + std::to_string(layout.faces) +
           "\nproperty list uchar int vertex_indices\nend_header\n";
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

char* binaryVertex(char* to, const MeshPart& part, const Layout& layout, std::size_t i)
{
    to = appendBytes(to, part.mesh->positions[i]);
    if (layout.normals)
        to = appendBytes(to, part.mesh->normals[i]);
    to = appendBytes(to, part.material.colour);
    if (layout.branch)
        to = appendBytes(to, valueAt(part.mesh->branch, i));
    if (layout.level)
        to = appendBytes(to, valueAt(part.mesh->level, i));
    return to;
}

char* asciiVertex(char* to, const MeshPart& part, const Layout& layout, std::size_t i)
{
    to = writing::appendVector(to, part.mesh->positions[i]);
    *to++ = ' ';
    if (layout.normals) {
        to = writing::appendVector(to, part.mesh->normals[i]);
        *to++ = ' ';
    }
    for (int k = 0; k < 3; ++k) {
        to = appendIndex(to, part.material.colour[k]);
        *to++ = ' ';
    }
    if (layout.branch) {
        to = appendIndex(to, valueAt(part.mesh->branch, i));
        *to++ = ' ';
    }
    if (layout.level) {
        const Index level = valueAt(part.mesh->level, i);
        to = level == noIndex ? appendText(to, "-1") : appendIndex(to, level);
        *to++ = ' ';
    }
    to[-1] = '\n';
    return to;
}

char* binaryFace(char* to, const glm::uvec3& t)
{
    *to++ = 3;
    return appendBytes(to, t);
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

constexpr std::size_t longestRecord = 256;

void writeElements(FileWriter& out, std::span<const MeshPart> parts, const Layout& layout, bool ascii,
                   Ticker& ticker)
{
    const auto vertex = ascii ? asciiVertex : binaryVertex;
    const auto face = ascii ? asciiFace : binaryFace;
    for (const MeshPart& part : parts)
        if (!forEach(part.mesh->positions.size(), ticker, out,
                     [&](std::size_t i) { out.advance(vertex(out.room(longestRecord), part, layout, i)); }))
            return;
    Index first = 0;
    for (const MeshPart& part : parts) {
        if (!forEach(part.mesh->triangles.size(), ticker, out, [&](std::size_t i) {
                out.advance(face(out.room(longestRecord), part.mesh->triangles[i] + first));
            }))
            return;
        first += part.mesh->vertexCount();
    }
}

Expected<void> finished(FileWriter& out)
{
    if (const auto done = out.finish(); !done)
        return done;
    return out.commit();
}

} // namespace

Expected<void> writePly(const std::string& path, std::span<const MeshPart> parts, const PlyOptions& options,
                        const Progress& progress)
{
    if (const auto finite = writing::checkFinite(parts, path); !finite)
        return finite;
    auto out = FileWriter::open(path);
    if (!out)
        return fail(out.error());
    const Layout layout = layoutOf(parts);
    out->append(header(layout, options.ascii));
    Ticker ticker(progress, layout.vertices + layout.faces);
    writeElements(*out, parts, layout, options.ascii, ticker);
    if (ticker.cancelled()) {
        auto error = fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        error.value().file = path;
        return error;
    }
    return finished(*out);
}

Expected<void> writePlyLines(const std::string& path, const LinePart& lines, const PlyOptions& options)
{
    if (const auto finite = writing::checkFinite(lines, path); !finite)
        return finite;
    auto out = FileWriter::open(path);
    if (!out)
        return fail(out.error());
    out->append(headerBegin(options.ascii) + "element vertex " + std::to_string(lines.positions.size()) +
                "\nproperty float x\nproperty float y\nproperty float z\nelement edge " +
                std::to_string(lines.lines.size()) +
                "\nproperty int vertex1\nproperty int vertex2\nend_header\n");
    for (const glm::vec3& p : lines.positions) {
        char* to = out->room(longestRecord);
        to = options.ascii ? writing::appendVector(to, p) : appendBytes(to, p);
        if (options.ascii)
            *to++ = '\n';
        out->advance(to);
    }
    for (const glm::uvec2& line : lines.lines) {
        char* to = out->room(longestRecord);
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
    return finished(*out);
}

} // namespace ramure
