#include "core/base/version.h"
#include "core/io/formats/text/material_file.h"
#include "core/io/material_maps.h"
#include "core/io/write_parts.h"
#include "core/surface/bark/bark_maps.h"
#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

namespace ramure {

namespace {

constexpr double textShare = 0.5; ///< of the time, where pictures are made as well

using writing::appendText;
using writing::forEach;
using writing::oneLine;
using writing::Ticker;
using writing::writeVectors;

/// PATH with the ending .mtl instead of its own.
std::string materialPath(const std::string& path)
{
    std::filesystem::path out(path);
    if (out.extension() == ".mtl")
        out += ".mtl";
    else
        out.replace_extension(".mtl");
    return out.string();
}

std::string head(const std::string& comment)
{
    return "# Ramure " RAMURE_VERSION "\n" + (comment.empty() ? "" : "# " + oneLine(comment) + "\n");
}

/// How many stand in the file before.
struct Before
{
    Index vertices = 0, normals = 0, texture = 0;
};

/// Triangles of one material, which follow each other in the order of a mesh.
struct Run
{
    std::size_t begin, end;
};

/// Which triangle is written when: each material once, so that viewers draw an object in few calls.
struct Order
{
    std::vector<Run> runs;
    std::vector<Index> triangles; ///< numbers of triangles; empty: as they stand in the mesh

    [[nodiscard]] std::size_t operator[](std::size_t place) const
    {
        return triangles.empty() ? place : triangles[place];
    }
};

/// Do triangles need materials of their own? Tones do not: leaves are one material.
bool hasOwnColours(const MeshPart& part)
{
    return writing::hasColours(*part.mesh) && !part.material.tones;
}

/// Numbers of triangles, those of each group together.
Order grouped(std::span<const std::size_t> of, std::size_t groups)
{
    Order out;
    out.runs.resize(groups, {0, 0});
    for (const std::size_t group : of)
        ++out.runs[group].end;
    std::size_t before = 0;
    for (Run& run : out.runs) {
        run.begin = before;
        before += std::exchange(run.end, before); // a run ends where its next triangle goes
    }
    out.triangles.resize(of.size());
    for (std::size_t i = 0; i < of.size(); ++i)
        out.triangles[out.runs[of[i]].end++] = static_cast<Index>(i);
    std::erase_if(out.runs, [](const Run& run) { return run.begin == run.end; });
    return out;
}

/// Is it nearer to the skin of twigs than to bark?
bool isYoung(const MeshPart& part, std::size_t triangle)
{
    float radius = 0.0F;
    for (int k = 0; k < 3; ++k)
        radius = std::max(radius, part.mesh->radius[part.mesh->triangles[triangle][k]]);
    return barkAge(part.material.bark.family, double(radius)) < 0.5F;
}

/// Those of one colour together, colours and triangles in the order of the mesh; all of them where there are
/// no colours. Of bark, the old and the young.
Order orderOf(const MeshPart& part)
{
    const TriangleMesh& mesh = *part.mesh;
    std::vector<std::size_t> of;
    of.reserve(mesh.triangles.size());
    if (writing::hasAges(part)) {
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
            of.push_back(isYoung(part, i) ? 1 : 0);
        return grouped(of, 2);
    }
    if (!hasOwnColours(part))
        return {{{0, mesh.triangles.size()}}, {}};
    const auto number = [](const glm::u8vec3& c) {
        return Index(c.r) << 16U | Index(c.g) << 8U | Index(c.b);
    };
    std::unordered_map<Index, std::size_t> runOf;
    for (const glm::u8vec3& colour : mesh.colours)
        of.push_back(runOf.try_emplace(number(colour), runOf.size()).first->second);
    return grouped(of, runOf.size());
}

/// Faces v, v/vt, v//vn or v/vt/vn.
bool writeFaces(FileWriter& out, const TriangleMesh& mesh, const Order& order, const Run& run,
                const Before& before, Ticker& ticker)
{
    const bool hasTexture = writing::hasTexture(mesh), hasNormals = writing::hasNormals(mesh);
    const std::vector<glm::uvec3>& texture = writing::textureTriangles(mesh);
    constexpr std::size_t faceRoom = 2 + 3 * 3 * (maxIndexText + 1);
    return forEach(run.end - run.begin, faceRoom, ticker, out, [&](char* to, std::size_t number) {
        const std::size_t i = order[run.begin + number];
        *to++ = 'f';
        for (int k = 0; k < 3; ++k) {
            *to++ = ' ';
            to = appendIndex(to, mesh.triangles[i][k] + before.vertices + 1u);
            if (hasTexture || hasNormals)
                *to++ = '/';
            if (hasTexture)
                to = appendIndex(to, texture[i][k] + before.texture + 1u);
            if (!hasNormals)
                continue;
            *to++ = '/';
            to = appendIndex(to, mesh.triangles[i][k] + before.normals + 1u);
        }
        *to++ = '\n';
        return to;
    });
}

/// Of a triangle.
Material materialOf(const MeshPart& part, std::size_t triangle)
{
    if (writing::hasAges(part) && isYoung(part, triangle))
        return {part.material.name + "_young", youngColour(part.material.bark), false, false};
    return hasOwnColours(part) ? surfaceMaterial(part.mesh->colours[triangle]) : part.material;
}

/// One object.
bool writePart(FileWriter& out, const MeshPart& part, const Before& before, bool hasMaterials, Ticker& ticker)
{
    const TriangleMesh& mesh = *part.mesh;
    const bool hasNormals = writing::hasNormals(mesh);
    out.append("o " + oneLine(part.name) + "\n");
    const bool hasTexture = writing::hasTexture(mesh);
    if (!writeVectors("v ", mesh.positions, ticker, out) ||
        (hasTexture && !writeVectors("vt ", mesh.uv, ticker, out)) ||
        (hasNormals && !writeVectors("vn ", mesh.normals, ticker, out)))
        return false;
    const Order order = orderOf(part);
    for (const Run& run : order.runs) {
        if (hasMaterials)
            out.append("usemtl " + oneLine(materialOf(part, order[run.begin]).name) + "\n");
        if (hasNormals && &run == &order.runs.front())
            out.append("s 1\n"); // smooth: some programs look at this alone and not at the normals
        if (!writeFaces(out, mesh, order, run, before, ticker))
            return false;
    }
    return true;
}

/// Colours in an .mtl have no stated space. Programs show Kd as it is, so that it holds the sRGB value that
/// the user chose, divided by 255, and not a linear one.
///
/// With pictures Kd is white: programs multiply it with them. The picture of the normals stands there twice,
/// as Blender reads it (map_Bump) and as most others do (norm).
void writeMaterial(FileWriter& out, const Material& material, int mapSize)
{
    const bool isLeaf = material.leaf != LeafShape::Faithful;
    const bool isMade = mapSize > 0 && (isLeaf || material.bark.family != BarkFamily::Plain);
    const auto mapLine = [&](const char* word, const std::string& picture, std::optional<MaterialMap> map) {
        std::string name;
        if (!picture.empty())
            name = pictureFileName(picture);
        else if (isMade && map && !(isLeaf && std::ranges::count(leafMapKinds, *map) == 0))
            name = isLeaf ? mapFileName(material.leaf, mapSize, *map)
                          : mapFileName(material.bark, mapSize, *map);
        if (!name.empty())
            out.append(std::string(word) + " " + name + "\n");
    };
    char buffer[16 + 3 * maxFloatText];
    char* end = appendText(buffer, "Kd ");
    const glm::u8vec3 colour = material.pigments ? material.mean : material.colour;
    end = writing::appendVector(end, isMade ? glm::vec3(1.0f) : glm::vec3(colour) / 255.0f);
    out.append("\nnewmtl " + oneLine(material.name) + "\n");
    if (material.twoSided)
        out.append("# seen from both sides\n");
    out.append({buffer, static_cast<std::size_t>(end - buffer)});
    if (material.pigments) { // the filter of what shines through
        char* last = writing::appendVector(appendText(buffer, "\nTf "), glm::vec3(material.passed) / 255.0f);
        out.append({buffer, static_cast<std::size_t>(last - buffer)});
    }
    out.append(material.phong ? "\nKs 0.2 0.2 0.2\nNs 30\nillum 2\n" : "\nKs 0 0 0\nillum 1\n");
    if (mapSize <= 0)
        return;
    if (material.sprays)
        for (const auto& [word, map] : {std::pair("map_Kd", "colour"), std::pair("map_Bump", "normal"),
                                        std::pair("norm", "normal"), std::pair("map_d", "opacity")})
            out.append(std::string(word) + " " + sprayFileName(*material.sprays, mapSize, map) + "\n");
    const PictureParams& own = material.pictures;
    mapLine("map_Kd", own.colour, MaterialMap::Colour);
    // The program's normals belong to its height: a picture of the height is there in their place.
    if (!own.normal.empty() || own.height.empty()) {
        mapLine("map_Bump", own.normal, MaterialMap::Normal);
        mapLine("norm", own.normal, MaterialMap::Normal);
    }
    mapLine("map_Pr", own.roughness, MaterialMap::Roughness);
    mapLine("map_ao", own.occlusion, MaterialMap::Occlusion);
    mapLine("disp", own.height, MaterialMap::Height);
    mapLine("map_d", own.opacity, std::nullopt);
}

bool hasMaps(const MeshPart& part, const WriteOptions& options)
{
    const bool isPictured = part.material.bark.family != BarkFamily::Plain ||
                            part.material.leaf != LeafShape::Faithful || part.material.sprays ||
                            !part.material.pictures.isEmpty();
    return options.mapSize > 0 && isPictured && writing::hasTexture(*part.mesh);
}

/// The pictures that the program makes for a material, if there are some.
Expected<std::vector<std::string>> writeMade(const std::string& folder, const Material& material, int size,
                                             const Progress& progress)
{
    if (material.sprays)
        return writeMaps(folder, *material.sprays, size, progress);
    if (material.leaf != LeafShape::Faithful)
        return writeMaps(folder, material.leaf, size);
    if (material.bark.family != BarkFamily::Plain)
        return writeMaps(folder, material.bark, size, progress);
    return {};
}

void writeMaterials(FileWriter& out, std::span<const MeshPart> parts, const WriteOptions& options)
{
    out.append("# Ramure " RAMURE_VERSION "\n# Kd in sRGB\n");
    std::set<std::string> written;
    for (const MeshPart& part : parts) {
        const Order order = orderOf(part);
        for (const Run& run : order.runs) {
            const Material material = materialOf(part, order[run.begin]);
            if (written.insert(material.name).second)
                writeMaterial(out, material,
                              material == part.material && hasMaps(part, options) ? options.mapSize : 0);
        }
    }
}

/// Of all parts, into the folder of the file.
Expected<void> writePictures(const std::string& path, std::span<const MeshPart> parts,
                             const WriteOptions& options, const Progress& progress)
{
    const std::string folder = std::filesystem::path(path).parent_path().string();
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Progress own =
            progress.part(double(i) / double(parts.size()), double(i + 1) / double(parts.size()));
        if (!hasMaps(parts[i], options))
            continue;
        const Material& material = parts[i].material;
        if (auto copied = copyPictures(folder, material.pictures); !copied)
            return copied;
        RAMURE_TRY(writeMade(folder, material, options.mapSize, own));
        own.report(1.0);
    }
    return {};
}

std::size_t elementCount(std::span<const MeshPart> parts)
{
    std::size_t sum = 0;
    for (const MeshPart& part : parts)
        sum += part.mesh->positions.size() + part.mesh->normals.size() + part.mesh->triangles.size() +
               part.mesh->uv.size();
    return sum;
}

tl::unexpected<Error> cancelled(const std::string& path)
{
    auto out = fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
    out.value().file = path;
    return out;
}

} // namespace

Expected<void> writeObj(const std::string& path, std::span<const MeshPart> parts, const Progress& progress,
                        const WriteOptions& options)
{
    if (const auto finite = writing::checkFinite(parts, path); !finite)
        return finite;
    auto out = FileWriter::open(path);
    RAMURE_TRY(out);
    const std::string library = materialPath(path);
    out->append(head(options.comment));
    if (out->isRegular()) // a device has nothing beside it
        out->append("mtllib " + oneLine(std::filesystem::path(library).filename().string()) + "\n");
    const auto pictured =
        std::ranges::count_if(parts, [&](const MeshPart& p) { return hasMaps(p, options); });
    const double text = pictured > 0 ? textShare : 1.0;
    const Progress ofText = progress.part(0.0, text);
    Ticker ticker(ofText, elementCount(parts));
    Before before;
    for (const MeshPart& part : parts) {
        if (!writePart(*out, part, before, out->isRegular(), ticker))
            break;
        before.vertices += part.mesh->vertexCount();
        before.normals += writing::hasNormals(*part.mesh) ? part.mesh->vertexCount() : 0;
        before.texture += writing::hasTexture(*part.mesh) ? static_cast<Index>(part.mesh->uv.size()) : 0;
    }
    if (ticker.cancelled())
        return cancelled(path);
    if (!out->isRegular())
        return out->commit();
    auto materials = FileWriter::open(library);
    RAMURE_TRY(materials);
    writeMaterials(*materials, parts, options);
    if (auto done = writePictures(path, parts, options, progress.part(text, 1.0)); !done)
        return done;
    return FileWriter::commitTogether({&*materials, &*out});
}

Expected<void> writeObjLines(const std::string& path, const LinePart& lines, const Progress& progress,
                             const std::string& comment)
{
    if (const auto finite = writing::checkFinite(lines, path); !finite)
        return finite;
    auto out = FileWriter::open(path);
    RAMURE_TRY(out);
    out->append(head(comment) + "o " + oneLine(lines.name) + "\n");
    Ticker ticker(progress, lines.positions.size() + lines.lines.size());
    if (writeVectors("v ", lines.positions, ticker, *out))
        forEach(lines.lines.size(), 8 + 2 * maxIndexText, ticker, *out, [&](char* to, std::size_t i) {
            to = appendText(to, "l ");
            to = appendIndex(to, lines.lines[i].x + 1u);
            *to++ = ' ';
            to = appendIndex(to, lines.lines[i].y + 1u);
            *to++ = '\n';
            return to;
        });
    if (ticker.cancelled())
        return cancelled(path);
    return out->commit();
}

} // namespace ramure
