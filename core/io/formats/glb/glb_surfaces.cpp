#include "core/io/formats/glb/glb_surfaces.h"

#include "core/base/file_writer.h"
#include "core/io/formats/glb/glb_unpack.h"
#include "core/io/picture_file.h"

#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace ramure::glb {

namespace {

namespace fs = std::filesystem;

/// Fit for a file on every system.
std::string fileName(const std::string& name)
{
    std::string out;
    for (const char c : name.substr(0, 60))
        out += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' ? c : '_';
    return out.empty() ? "material" : out;
}

/// Empty where there is no file.
std::string contentOf(const fs::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

const Json& memberOr(const Json& object, const char* name)
{
    static const Json none = Json::object();
    const Json* found = member(object, name);
    return found ? *found : none;
}

bool isPng(std::string_view bytes)
{
    return bytes.starts_with("\x89PNG");
}

/// The picture of a texture, in the form that all programs read or else in that of an extension.
std::optional<std::size_t> sourceOf(const Json& texture)
{
    if (const auto plain = numberOf(texture, "source"))
        return plain;
    for (const Json& extension : memberOr(texture, "extensions"))
        if (const auto other = numberOf(extension, "source"))
            return other;
    return std::nullopt;
}

/// As people know it.
std::string pictureName(const Json& image, std::size_t number)
{
    const std::string name = textOf(image, "name"), uri = textOf(image, "uri"),
                      type = textOf(image, "mimeType");
    if (!name.empty())
        return reading::excerpt(name);
    if (!uri.empty() && !uri.starts_with("data:"))
        return reading::excerpt(uri);
    return placeOf("images", number) + (type.empty() ? "" : ", " + reading::excerpt(type));
}

/// A picture that a surface wears, and where in a material it stands.
struct Place
{
    std::string PictureParams::*to;
    const Json* texture;
    const char* name;
    std::optional<int> channel; ///< the one that it is of a picture of several things
};

std::vector<Place> placesOf(const Json& material)
{
    const Json& pbr = memberOr(material, "pbrMetallicRoughness");
    const Json* colour = member(pbr, "baseColorTexture");
    const std::string mode = textOf(material, "alphaMode");
    const bool isCut = mode == "MASK" || mode == "BLEND";
    return {{&PictureParams::colour, colour, "colour", {}},
            {&PictureParams::opacity, isCut ? colour : nullptr, "opacity", 3},
            {&PictureParams::normal, member(material, "normalTexture"), "normal", {}},
            {&PictureParams::occlusion, member(material, "occlusionTexture"), "occlusion", 0},
            {&PictureParams::roughness, member(pbr, "metallicRoughnessTexture"), "roughness", 1}};
}

} // namespace

Expected<Surface> surfaceOf(const File& file, std::optional<std::size_t> material)
{
    Surface out;
    if (!material)
        return out;
    const std::string place = placeOf("materials", *material);
    const auto json = file.element("materials", material, place);
    RAMURE_TRY(json);
    double colour[4] = {1.0, 1.0, 1.0, 1.0};
    RAMURE_TRY(numbersOf(memberOr(**json, "pbrMetallicRoughness"), "baseColorFactor", colour, place));
    out.colour = {static_cast<float>(colour[0]), static_cast<float>(colour[1]),
                  static_cast<float>(colour[2])};
    for (const Place& picture : placesOf(**json))
        out.hasPictures = out.hasPictures || picture.texture;
    return out;
}

PictureFolder::PictureFolder(File& file, const std::string& path)
    : m_file(file)
    , m_folder((fs::path(path).parent_path() / (fs::path(path).stem().string() + "_pictures")).string())
{
}

PictureParams PictureFolder::write(std::size_t material, std::vector<Note>& notes)
{
    PictureParams out;
    const auto json = m_file.element("materials", material, {});
    if (!json)
        return out;
    const std::string given = textOf(**json, "name");
    const std::string name =
        given.empty() ? std::string("material_").append(std::to_string(material)) : fileName(given);
    for (const Place& picture : placesOf(**json)) {
        if (!picture.texture)
            continue;
        const std::string place = placeOf("materials", material) + "." + picture.name;
        auto bytes = bytesOf(*picture.texture, place);
        Expected<std::string> made = bytes ? Expected<std::string>(*bytes) : fail(bytes.error());
        if (made && picture.channel)
            made = channelPng(*made, *picture.channel);
        const char* ending = made && isPng(*made) ? ".png" : ".jpg";
        auto path = made ? keep(name + "_" + picture.name + ending, *made) : std::move(made);
        if (path)
            out.*picture.to = std::move(*path);
        else {
            notes.push_back(std::move(path.error()));
            notes.back().path = place;
        }
    }
    return out;
}

Expected<std::string_view> PictureFolder::bytesOf(const Json& texture, const std::string& place)
{
    const auto sampled = m_file.element("textures", numberOf(texture, "index"), place);
    RAMURE_TRY(sampled);
    const auto number = sourceOf(**sampled);
    const auto image = m_file.element("images", number, place);
    RAMURE_TRY(image);
    const std::string name = pictureName(**image, *number);
    Expected<std::string_view> bytes = std::string_view();
    if (member(**image, "bufferView"))
        bytes = m_file.view(numberOf(**image, "bufferView"), place);
    else {
        auto text = bytesOfUri(textOf(**image, "uri"));
        if (!text)
            return wrong(place, RAMURE_NOOP("the picture \"%1\" stands in another file"), {name});
        bytes = m_fromText.insert_or_assign(*number, std::move(*text)).first->second;
    }
    if (bytes && !isPng(*bytes) && !bytes->starts_with("\xFF\xD8\xFF"))
        return wrong(place, RAMURE_NOOP("the picture \"%1\" is neither a PNG nor a JPEG"), {name});
    return bytes;
}

Expected<std::string> PictureFolder::keep(const std::string& name, std::string_view bytes)
{
    auto path = keepPicture(m_folder, name, bytes);
    if (path)
        m_files.insert(*path);
    return path;
}

Expected<std::string> keepPicture(const std::string& folder, const std::string& name, std::string_view bytes)
{
    std::error_code problem;
    fs::create_directory(folder, problem); // what is wrong with it shows when a file is written
    const fs::path stem = fs::path(folder) / fs::path(name).stem(), ending = fs::path(name).extension();
    for (int i = 1; i < 100; ++i) {
        std::string path = stem.string();
        if (i > 1)
            path.append("_").append(std::to_string(i));
        path += ending.string();
        if (fs::exists(path, problem)) {
            if (contentOf(path) != bytes)
                continue;
        } else if (auto written = writeFile(path, bytes); !written)
            return fail(std::move(written.error()));
        return path;
    }
    return fail(ErrorCode::Limit, RAMURE_NOOP("a hundred other pictures of this name are there"));
}

} // namespace ramure::glb
