/// \file
/// What the fuzz targets share: a claim that does not hold ends the run with the input kept.
#pragma once

#include "core/io/formats/text/blender_scene.h"
#include "core/io/mesh_file.h"
#include "core/scene/scene.h"
#include "core/surface/proof/validate.h"
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <sys/mman.h>
#include <unistd.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace ramure::fuzz {

inline void claim(bool holds, const char* what)
{
    if (holds)
        return;
    std::fprintf(stderr, "does not hold: %s\n", what);
    std::abort();
}

/// An error says something, and all that its text refers to.
inline void claimGoodError(const Error& error)
{
    const std::string_view text(error.text);
    claim(!text.empty() && !error.message().empty(), "an error has a text");
    for (std::size_t i = error.args.size() + 1; i < 10; ++i)
        claim(text.find('%' + std::to_string(i)) == std::string_view::npos, "an error has its arguments");
}

inline std::string_view textOf(const std::uint8_t* data, std::size_t size)
{
    return {reinterpret_cast<const char*>(data), size};
}

inline bool areFinite(const std::vector<glm::vec3>& vectors)
{
    for (const glm::vec3& v : vectors)
        if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
            return false;
    return true;
}

inline bool sameBits(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b)
{
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0);
}

/// The input as a file that lives in memory alone: its path. It is gone with the object.
class MemoryFile
{
public:
    MemoryFile(const std::uint8_t* data, std::size_t size)
        : m_file(::memfd_create("fuzz", MFD_CLOEXEC))
    {
        claim(m_file >= 0 && ::write(m_file, data, size) == static_cast<ssize_t>(size), "memory for a file");
    }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    ~MemoryFile() { ::close(m_file); }
    [[nodiscard]] std::string path() const { return "/proc/self/fd/" + std::to_string(m_file); }

private:
    int m_file;
};

/// Read in one way and in another: the same, or the same error.
inline void claimSame(const Expected<ReadMesh>& a, const Expected<ReadMesh>& b)
{
    claim(a.has_value() == b.has_value(), "both ways read it, or none");
    if (!a) {
        claim(a.error().plain() == b.error().plain() && a.error().line == b.error().line, "the same error");
        return;
    }
    claim(a->notes == b->notes && a->objects.size() == b->objects.size(), "the same notes and objects");
    for (std::size_t i = 0; i < a->objects.size(); ++i) {
        const TriangleMesh& x = a->objects[i].mesh;
        const TriangleMesh& y = b->objects[i].mesh;
        claim(sameBits(x.positions, y.positions) && sameBits(x.normals, y.normals) &&
                  x.triangles == y.triangles && x.branch == y.branch && x.level == y.level,
              "the same mesh");
    }
}

/// What every reader promises of a mesh, and that the check can be run on it.
inline void claimGoodMesh(const TriangleMesh& mesh)
{
    const auto fits = [&](std::size_t size) { return size == 0 || size == mesh.positions.size(); };
    claim(areFinite(mesh.positions) && areFinite(mesh.normals), "numbers of a mesh are finite");
    claim(fits(mesh.normals.size()), "a normal for every vertex, or none");
    claim(fits(mesh.branch.size()) && fits(mesh.level.size()), "a branch and a level for every vertex");
    for (const glm::uvec3& t : mesh.triangles)
        claim(t.x < mesh.vertexCount() && t.y < mesh.vertexCount() && t.z < mesh.vertexCount(),
              "corners are vertices");
    const auto report = validateMesh(mesh);
    claim(report.has_value(), "a mesh that was read can be checked");
    claim(report->vertices == mesh.vertexCount() && report->faces == mesh.faceCount(),
          "all of it is checked");
    const auto again = validateMesh(mesh);
    claim(again && again->defects.size() == report->defects.size(), "a check gives the same twice");
}

/// What readers of scenes promise: of all as meshes, and of all as nodes.
inline void claimGoodReading(const Expected<ReadMesh>& mesh, const Expected<BlenderImport>& scene)
{
    if (!mesh)
        claimGoodError(mesh.error());
    else
        for (const ReadObject& object : mesh->objects)
            claimGoodMesh(object.mesh);
    if (!scene)
        return claimGoodError(scene.error());
    claim(Scene::fromNodes(scene->nodes).has_value(), "the nodes are a scene");
    for (const Note& note : scene->notes)
        claimGoodError(note);
    for (const Node& node : scene->nodes) {
        claim(checkParams(node.params).has_value(), "parameters are within their ranges");
        if (node.mesh)
            claimGoodMesh(*node.mesh);
    }
}

} // namespace ramure::fuzz
