#include "core/io/formats/material_file.h"

#include "core/io/read_parts.h"

#include <algorithm>
#include <filesystem>
#include <optional>

namespace ramure {
namespace {

constexpr std::size_t mostNotes = 20;
constexpr std::size_t largestFile = std::size_t(64) << 20;
/// One or three numbers; one is a grey. Nothing where it is anything else.
std::optional<glm::u8vec3> colourOf(std::string_view words)
{
    // Scanning needs an end that is no part of a number.
    const std::string text = std::string(words) + "\n" + std::string(reading::ScanBlocks::padding, '\0');
    const char* at = text.c_str();
    glm::vec3 colour(0.0F);
    int count = 0;
    for (; *at != '\n'; ++count) {
        if (count == 3 || scanFloat(at, colour[count]) != FloatScan::Ok ||
            (*at != '\n' && !reading::isBlank(*at)))
            return std::nullopt;
        while (reading::isBlank(*at))
            ++at;
    }
    if (count != 1 && count != 3)
        return std::nullopt;
    if (count == 1)
        colour = glm::vec3(colour.x);
    glm::u8vec3 bytes;
    for (int k = 0; k < 3; ++k)
        bytes[k] = static_cast<std::uint8_t>(std::clamp(colour[k], 0.0F, 1.0F) * 255.0F + 0.5F);
    return bytes;
}

/// Programs of other systems part folders with a backslash.
std::filesystem::path pathOf(std::string name)
{
    std::replace(name.begin(), name.end(), '\\', '/');
    return name;
}

} // namespace

Material surfaceMaterial(const glm::u8vec3& colour)
{
    Material material{"surface_", colour, true, false};
    constexpr const char* digits = "0123456789abcdef";
    for (int c = 0; c < 3; ++c)
        material.name.append(1, digits[colour[c] / 16]).append(1, digits[colour[c] % 16]);
    return material;
}

MaterialColours parseMaterials(std::string_view text, const std::string& file)
{
    MaterialColours out;
    std::string name;
    int line = 0;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view content = reading::trimmed(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        ++line;
        const std::size_t gap = std::min(content.find_first_of(reading::blanksOfLine), content.size());
        const std::string_view word = content.substr(0, gap), rest = reading::trimmed(content.substr(gap));
        if (word == "newmtl")
            name = rest;
        if (word == "map_Kd" && out.notes.size() < mostNotes)
            out.notes.push_back(file + ", line " + std::to_string(line) + ": the picture \"" +
                                reading::excerpt(rest) + "\" is not read");
        if (word != "Kd")
            continue;
        if (const auto colour = colourOf(rest))
            out.colours.insert_or_assign(name, *colour);
        else if (out.notes.size() < mostNotes)
            out.notes.push_back(file + ", line " + std::to_string(line) +
                                ": Kd needs three finite numbers, found \"" + reading::excerpt(rest) +
                                "\": the colour is left out");
    }
    return out;
}

MaterialSource materialsBeside(const std::string& path)
{
    return [folder = std::filesystem::path(path).parent_path()](const std::string& name) {
        std::error_code problem;
        const std::filesystem::path asked = folder / pathOf(name), near = folder / asked.filename();
        // What is named may be on another machine's disk; pipes and devices are no files to wait for.
        const bool isThere = std::filesystem::is_regular_file(asked, problem);
        const std::filesystem::path& found = isThere ? asked : near;
        if (!std::filesystem::is_regular_file(found, problem))
            return Expected<std::string>(fail(ErrorCode::Io, RAMURE_NOOP("there is no such file")));
        if (std::filesystem::file_size(found, problem) > largestFile)
            return Expected<std::string>(fail(ErrorCode::Limit, RAMURE_NOOP("the file is too large")));
        auto file = reading::InputFile::open(found.string());
        if (!file)
            return Expected<std::string>(fail(file.error()));
        const auto bytes = reading::loadFile(*file, found.string());
        return bytes ? Expected<std::string>(std::string(bytes->view())) : fail(bytes.error());
    };
}

} // namespace ramure
