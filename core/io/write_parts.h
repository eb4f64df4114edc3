/// \file
/// Parts that the OBJ and the PLY writer share. Internal to core/io.
#pragma once

#include "core/base/file_writer.h"
#include "core/io/float_text.h"
#include "core/io/mesh_file.h"

namespace ramure::writing {

/// Elements between two looks at the stop token.
inline constexpr std::size_t chunk = std::size_t(1) << 16;

/// Refuses non-finite positions and normals, which no program could read: Invalid, with the part and the
/// vertex.
Expected<void> checkFinite(std::span<const MeshPart> parts, const std::string& file);
Expected<void> checkFinite(const LinePart& lines, const std::string& file);

/// A name on one line: control characters become underscores.
std::string oneLine(std::string_view name);

/// Counts elements, reports progress and says when to stop.
class Ticker
{
public:
    Ticker(const Progress& progress, std::size_t total)
        : m_progress(progress)
        , m_total(total)
    {
    }
    /// Call every `chunk` elements with how many were written since the last call; false = stop.
    bool tick(const FileWriter& out, std::size_t count)
    {
        m_done += count;
        m_progress.report(m_total ? double(m_done) / double(m_total) : 1.0);
        return out.isGood() && !m_progress.cancelled();
    }
    /// The outcome where tick() said stop, or nothing: the writer's own error comes from commit().
    [[nodiscard]] bool cancelled() const { return m_progress.cancelled(); }

private:
    const Progress& m_progress;
    std::size_t m_total;
    std::size_t m_done = 0;
};

/// Writes \p count elements, each of which needs at most \p mostBytes of room, by `to = write(to, i)`, with a
/// look at \p ticker every chunk. False = stopped.
template <class Write>
bool forEach(std::size_t count, std::size_t mostBytes, Ticker& ticker, FileWriter& out, Write&& write)
{
    const std::size_t range = FileWriter::largestRoom / mostBytes;
    for (std::size_t chunkBegin = 0; chunkBegin < count; chunkBegin += chunk) {
        const std::size_t chunkEnd = std::min(count, chunkBegin + chunk);
        for (std::size_t i = chunkBegin; i < chunkEnd;) {
            const std::size_t end = std::min(chunkEnd, i + range);
            char* to = out.room((end - i) * mostBytes);
            for (; i < end; ++i)
                to = write(to, i);
            out.advance(to);
        }
        if (!ticker.tick(out, chunkEnd - chunkBegin))
            return false;
    }
    return true;
}

inline char* appendText(char* to, std::string_view text)
{
    return text.copy(to, text.size()) + to;
}

/// The numbers of a vector with a space between two.
template <class Vector> char* appendVector(char* to, const Vector& v)
{
    to = appendFloat(to, v[0]);
    for (glm::length_t k = 1; k < Vector::length(); ++k) {
        *to++ = ' ';
        to = appendFloat(to, v[k]);
    }
    return to;
}

/// A line for each vector: \p head and its numbers.
template <class Vector>
bool writeVectors(std::string_view head, const std::vector<Vector>& vectors, Ticker& ticker, FileWriter& out)
{
    const std::size_t most = head.size() + std::size_t(Vector::length()) * (maxFloatText + 1);
    return forEach(vectors.size(), most, ticker, out, [&](char* to, std::size_t i) {
        to = appendVector(appendText(to, head), vectors[i]);
        *to++ = '\n';
        return to;
    });
}

/// Texture coordinates are written where every corner has one.
inline bool hasTexture(const TriangleMesh& mesh)
{
    if (mesh.uv.empty() || mesh.triangles.empty())
        return false;
    return mesh.uvTriangles.empty() ? mesh.uv.size() == mesh.positions.size()
                                    : mesh.uvTriangles.size() == mesh.triangles.size();
}
inline const std::vector<glm::uvec3>& textureTriangles(const TriangleMesh& mesh)
{
    return mesh.uvTriangles.empty() ? mesh.triangles : mesh.uvTriangles;
}

/// Bark that is older where the wood is thicker.
inline bool hasAges(const MeshPart& part)
{
    return part.material.bark.family != BarkFamily::Plain && part.material.pictures.colour.empty() &&
           part.mesh->radius.size() == part.mesh->positions.size();
}

/// Each triangle has a colour of its own, in place of the part's material.
inline bool hasColours(const TriangleMesh& mesh)
{
    return !mesh.colours.empty() && mesh.colours.size() == mesh.triangles.size();
}

/// Normals are written where there is one for every vertex.
inline bool hasNormals(const TriangleMesh& mesh)
{
    return !mesh.normals.empty() && mesh.normals.size() == mesh.positions.size();
}

} // namespace ramure::writing
