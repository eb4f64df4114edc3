#include "core/io/write_parts.h"
#include <cmath>

namespace ramure::writing {

namespace {

bool isFinite(const glm::vec3& v)
{
    // One subtraction each, no branch: infinity and NaN give NaN.
    return (v.x - v.x) + (v.y - v.y) + (v.z - v.z) == 0.0f;
}

Expected<void> checkFinite(std::span<const glm::vec3> vectors, const std::string& part,
                           const std::string& file)
{
    bool isGood = true;
    for (const glm::vec3& v : vectors)
        isGood &= isFinite(v);
    if (isGood)
        return {};
    std::size_t bad = 0;
    while (isFinite(vectors[bad]))
        ++bad;
    auto error = fail(ErrorCode::Invalid, RAMURE_NOOP("vertex %1 of %2 is not a finite number"),
                      {std::to_string(bad), part.empty() ? "the mesh" : part});
    error.value().file = file;
    return error;
}

} // namespace

Expected<void> checkFinite(std::span<const MeshPart> parts, const std::string& file)
{
    for (const MeshPart& part : parts) {
        if (const auto positions = checkFinite(part.mesh->positions, part.name, file); !positions)
            return positions;
        if (const auto normals = checkFinite(part.mesh->normals, part.name, file); !normals)
            return normals;
    }
    return {};
}

Expected<void> checkFinite(const LinePart& lines, const std::string& file)
{
    return checkFinite(lines.positions, lines.name, file);
}

std::string oneLine(std::string_view name)
{
    std::string out(name);
    for (char& c : out)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)
            c = '_';
    return out;
}

} // namespace ramure::writing
