#include "core/io/formats/text/material_file.h"

#include "core/base/plain_text.h"
#include "core/io/read_parts.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

namespace ramure {
namespace {

constexpr std::size_t mostNotes = 20;
constexpr std::size_t largestFile = std::size_t(64) << 20;
/// One or three numbers; one is a grey. Nothing where it is anything else.
std::optional<glm::u8vec3> colourOf(std::string_view words)
{
    const char *at = words.data(), *const end = at + words.size();
    glm::vec3 colour(0.0F);
    int count = 0;
    for (; at != end; ++count) {
        if (count == 3 || scanFloat(at, end, colour[count]) != FloatScan::Ok ||
            (at != end && !reading::isBlank(*at)))
            return std::nullopt;
        while (at != end && reading::isBlank(*at))
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

/// Keywords whose value names a file.
bool isPicture(std::string_view word)
{
    constexpr std::array others{"bump", "norm", "disp", "decal", "refl"};
    return word.starts_with("map_") || std::ranges::find(others, word) != others.end();
}

/// The pictures of one material, each once: that of the normals stands there under several keywords.
struct PictureNames
{
    int line = 0; ///< of the first
    std::vector<std::string> names;

    void add(std::string_view name, int at)
    {
        std::string quoted = "\"" + reading::excerpt(name) + "\"";
        line = names.empty() ? at : line;
        if (names.size() < mostNotes && std::ranges::find(names, quoted) == names.end())
            names.push_back(std::move(quoted));
    }
    [[nodiscard]] std::string text() const
    {
        std::string out;
        for (const std::string& name : names)
            out += out.empty() ? "the picture " + name + " is not read" : ", nor is " + name;
        return out;
    }
};

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
    PictureNames pictures;
    const PlainText plain(text);
    TextLines lines(plain.view());
    const auto note = [&](int line, const std::string& what) {
        if (!what.empty() && out.notes.size() < mostNotes)
            out.notes.push_back(file + ", line " + std::to_string(line) + ": " + what);
    };
    while (lines.next()) {
        const std::string_view content = lines.line();
        const std::size_t gap = std::min(content.find_first_of(reading::blanksOfLine), content.size());
        const std::string word = lowered(content.substr(0, gap));
        const std::string_view rest = reading::trimmed(content.substr(gap));
        if (word == "newmtl") {
            note(pictures.line, pictures.text());
            pictures = {};
            name = rest;
        }
        if (isPicture(word))
            pictures.add(rest, lines.number());
        if (word != "kd")
            continue;
        if (const auto colour = colourOf(rest))
            out.colours.insert_or_assign(name, *colour);
        else
            note(lines.number(), "Kd needs three finite numbers, found \"" + reading::excerpt(rest) +
                                     "\": the colour is left out");
    }
    note(pictures.line, pictures.text());
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
        return reading::loadFile(found.string());
    };
}

} // namespace ramure
