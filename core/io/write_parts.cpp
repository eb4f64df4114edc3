#include "core/io/write_parts.h"
#include <bit>

namespace ramure::writing {

namespace {

/// All ones in the exponent: infinity and NaN. Whole numbers are compared, four at a time.
bool areFinite(const float* numbers, std::size_t count)
{
    std::uint32_t anyBad = 0;
    for (std::size_t i = 0; i < count; ++i)
        anyBad |= (std::bit_cast<std::uint32_t>(numbers[i]) & 0x7F800000u) == 0x7F800000u ? 1u : 0u;
    return anyBad == 0;
}

Expected<void> checkFinite(std::span<const glm::vec3> vectors, const std::string& part,
                           const std::string& file)
{
    if (vectors.empty() || areFinite(&vectors.data()->x, 3 * vectors.size()))
        return {};
    std::size_t bad = 0;
    while (areFinite(&vectors[bad].x, 3))
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
        const std::vector<glm::vec2>& uv = part.mesh->uv;
        if (uv.empty() || areFinite(&uv[0].x, 2 * uv.size()))
            continue;
        auto error =
            fail(ErrorCode::Invalid, RAMURE_NOOP("a texture coordinate of %1 is not a finite number"),
                 {part.name.empty() ? "the mesh" : part.name});
        error.value().file = file;
        return error;
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
