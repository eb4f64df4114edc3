/// \file
/// What the OBJ and the PLY writer share. Internal to core/io.
#pragma once

#include "core/io/file_writer.h"
#include "core/io/float_text.h"
#include "core/io/mesh_file.h"

namespace ramure::writing {

/// Elements between two looks at the stop token.
inline constexpr std::size_t chunk = std::size_t(1) << 16;

/// Non-finite positions or normals would be read by nobody: Invalid, with the part and the vertex.
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
    /// The outcome where tick() said stop, or nothing: the writer's own error comes from finish().
    [[nodiscard]] bool cancelled() const { return m_progress.cancelled(); }

private:
    const Progress& m_progress;
    std::size_t m_total;
    std::size_t m_done = 0;
};

/// Calls \p write(i) for i in [0, count), with a look at \p ticker every chunk. False = stopped.
template <class Write> bool forEach(std::size_t count, Ticker& ticker, const FileWriter& out, Write&& write)
{
    for (std::size_t begin = 0; begin < count; begin += chunk) {
        const std::size_t end = std::min(count, begin + chunk);
        for (std::size_t i = begin; i < end; ++i)
            write(i);
        if (!ticker.tick(out, end - begin))
            return false;
    }
    return true;
}

/// Normals are written where there is one for every vertex.
inline bool hasNormals(const TriangleMesh& mesh)
{
    return !mesh.normals.empty() && mesh.normals.size() == mesh.positions.size();
}

inline char* appendText(char* to, std::string_view text)
{
    return text.copy(to, text.size()) + to;
}

inline char* appendVector(char* to, const glm::vec3& v)
{
    to = appendFloat(to, v.x);
    *to++ = ' ';
    to = appendFloat(to, v.y);
    *to++ = ' ';
    return appendFloat(to, v.z);
}

} // namespace ramure::writing
