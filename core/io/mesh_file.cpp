#include "core/io/mesh_file.h"
#include "core/io/read_parts.h"
#include "core/io/write_parts.h"
#include <algorithm>

namespace ramure {

namespace {

void appendOrFill(std::vector<Index>& to, const std::vector<Index>& from, std::size_t before,
                  std::size_t count)
{
    if (to.empty() && from.empty())
        return;
    to.resize(before, noIndex);
    to.insert(to.end(), from.begin(), from.end());
    to.resize(before + count, noIndex);
}

/// The objects' texture coordinates one after the other, where all have some.
void appendTexture(TriangleMesh& out, const std::vector<ReadObject>& objects)
{
    const bool hasTexture = std::all_of(objects.begin(), objects.end(), [](const ReadObject& object) {
        return writing::hasTexture(object.mesh) || object.mesh.triangles.empty();
    });
    for (const ReadObject& object : objects) {
        const TriangleMesh& mesh = object.mesh;
        if (!hasTexture || mesh.triangles.empty())
            continue;
        const auto first = static_cast<Index>(out.uv.size());
        out.uv.insert(out.uv.end(), mesh.uv.begin(), mesh.uv.end());
        for (const glm::uvec3& t : writing::textureTriangles(mesh))
            out.uvTriangles.push_back(t + first);
    }
}

/// The colours of the objects' triangles one after the other, where any has some.
void appendColours(TriangleMesh& out, const std::vector<ReadObject>& objects)
{
    const auto hasColours = [](const ReadObject& object) { return !object.mesh.colours.empty(); };
    if (std::none_of(objects.begin(), objects.end(), hasColours))
        return;
    for (const ReadObject& object : objects) {
        const auto& colours = object.mesh.colours;
        out.colours.insert(out.colours.end(), colours.begin(), colours.end());
        out.colours.resize(out.colours.size() + object.mesh.triangles.size() - colours.size(),
                           reading::plainColour);
    }
}

/// The objects one after the other.
TriangleMesh appended(const std::vector<ReadObject>& objects)
{
    TriangleMesh out;
    const bool hasNormals = std::all_of(objects.begin(), objects.end(), [](const ReadObject& object) {
        return object.mesh.normals.size() == object.mesh.positions.size();
    });
    appendTexture(out, objects);
    appendColours(out, objects);
    for (const ReadObject& object : objects) {
        const TriangleMesh& mesh = object.mesh;
        const std::size_t before = out.positions.size();
        out.positions.insert(out.positions.end(), mesh.positions.begin(), mesh.positions.end());
        if (hasNormals)
            out.normals.insert(out.normals.end(), mesh.normals.begin(), mesh.normals.end());
        appendOrFill(out.branch, mesh.branch, before, mesh.positions.size());
        appendOrFill(out.level, mesh.level, before, mesh.positions.size());
        for (const glm::uvec3& t : mesh.triangles)
            out.triangles.push_back(t + static_cast<Index>(before));
    }
    return out;
}

/// The objects with the vertices of the file, each once.
TriangleMesh rewelded(const std::vector<ReadObject>& objects)
{
    Index count = 0;
    for (const ReadObject& object : objects)
        for (const Index v : object.fileVertex)
            count = std::max(count, v + 1);
    TriangleMesh out;
    appendTexture(out, objects);
    appendColours(out, objects);
    out.positions.resize(count);
    const bool hasNormals = std::all_of(objects.begin(), objects.end(), [](const ReadObject& object) {
        return object.mesh.normals.size() == object.mesh.positions.size();
    });
    if (hasNormals)
        out.normals.resize(count);
    for (const ReadObject& object : objects) {
        for (std::size_t i = 0; i < object.fileVertex.size(); ++i) {
            out.positions[object.fileVertex[i]] = object.mesh.positions[i];
            if (hasNormals)
                out.normals[object.fileVertex[i]] = object.mesh.normals[i];
        }
        for (const glm::uvec3& t : object.mesh.triangles)
            out.triangles.emplace_back(object.fileVertex[t.x], object.fileVertex[t.y],
                                       object.fileVertex[t.z]);
    }
    return out;
}

} // namespace

TriangleMesh ReadMesh::joined() const
{
    if (objects.size() == 1)
        return objects.front().mesh;
    const bool isShared = std::any_of(objects.begin(), objects.end(),
                                      [](const ReadObject& object) { return !object.fileVertex.empty(); });
    return isShared ? rewelded(objects) : appended(objects);
}

} // namespace ramure
