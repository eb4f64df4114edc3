#include "core/io/formats/usd/usd_materials.h"

#include "core/io/formats/usd/usd_mesh.h"
#include "core/io/material_maps.h"
#include "core/io/picture_file.h"
#include "core/surface/foliage/leaf_table.h"
#include <algorithm>

namespace ramure::usd {
namespace {

/// Leaves of another season have colours without a picture: that has the colour of summer.
bool hasColourOfSummer(const Material& material)
{
    return material.leaf == LeafShape::Faithful || material.colour == leafColour(material.leaf, false);
}

bool isUsable(std::string_view bytes)
{
    return bytes.starts_with("\x89PNG\r\n\x1a\n") || bytes.starts_with("\xFF\xD8\xFF") ||
           bytes.starts_with("\x76\x2F\x31\x01");
}

constexpr int levels = 32, paletteWidth = 256, paletteHeight = levels * levels * levels / paletteWidth;

Expected<std::string> palettePng()
{
    std::vector<std::uint8_t> bytes;
    const auto full = [](int level) { return static_cast<std::uint8_t>((255 * level + 15) / (levels - 1)); };
    for (int i = 0; i < levels * levels * levels; ++i)
        for (const int level : {i / (levels * levels), i / levels % levels, i % levels})
            bytes.push_back(full(level));
    return pngOf({paletteWidth, paletteHeight, 3, true, bytes});
}

} // namespace

glm::vec2 placeInPalette(const glm::u8vec3& colour)
{
    int cell = 0;
    for (int k = 0; k < 3; ++k)
        cell = levels * cell + (colour[k] * (levels - 1) + 127) / 255;
    const int column = cell % paletteWidth, row = cell / paletteWidth;
    return {(float(column) + 0.5F) / float(paletteWidth), (float(row) + 0.5F) / float(paletteHeight)};
}

bool Materials::isPictured(const Material& material) const
{
    const bool isMade =
        material.leaf != LeafShape::Faithful || material.bark.family != BarkFamily::Plain || material.sprays;
    return m_mapSize > 0 && (isMade || !material.pictures.isEmpty());
}

Expected<std::string> Materials::add(const Material& material, const Wear& wear, const Progress& progress)
{
    const std::string key = material.name + (wear.textured ? " textured" : "") +
                            (wear.isPainted  ? " painted"
                             : wear.coloured ? " coloured"
                                             : "");
    if (const auto known = m_paths.find(key); known != m_paths.end())
        return known->second;
    Made made;
    made.colour = linearColour(material.colour);
    made.scale = wear.mean;
    made.roughness = material.phong ? 0.6 : 0.9;
    if (wear.textured) {
        RAMURE_TRY(addMade(made, material, progress));
        RAMURE_TRY(addOwn(made, material));
    }
    const bool hasPicture =
        std::ranges::any_of(made.textures, [](const Texture& texture) { return texture.isColour; });
    if (wear.isPainted) {
        auto palette = palettePng();
        RAMURE_TRY(palette);
        made.scale = glm::vec3(1.0F);
        made.textures.push_back({keep(paletteFile, std::move(*palette)), "diffuseColor", "rgb", true});
    } else if (wear.coloured && !hasPicture) {
        made.colour = (material.tones ? made.colour : glm::vec3(1.0F)) * wear.mean;
    }
    made.prim = m_names.take(material.name);
    made.title = material.name;
    m_made.push_back(std::move(made));
    return m_paths[key] = m_path + "/" + m_made.back().prim;
}

Expected<void> Materials::addMade(Made& made, const Material& material, const Progress& progress)
{
    if (material.sprays) {
        auto maps = makeMaps(*material.sprays, m_mapSize, progress);
        RAMURE_TRY(maps);
        const auto nameOf = [&](const char* map) { return sprayFileName(*material.sprays, m_mapSize, map); };
        const std::string cut = keep(nameOf("cut"), std::move(maps->cut));
        made.cutoff = 0.5;
        made.textures = {{cut, "diffuseColor", "rgb", true},
                         {cut, "opacity", "a"},
                         {keep(nameOf("normal"), std::move(maps->normal)), "normal", "rgb"}};
        return {};
    }
    const bool isLeaf = material.leaf != LeafShape::Faithful;
    if (!isLeaf && material.bark.family == BarkFamily::Plain)
        return {};
    constexpr std::array barkKinds{MaterialMap::Colour, MaterialMap::Normal, MaterialMap::Occlusion,
                                   MaterialMap::Roughness};
    constexpr std::array leafKinds{MaterialMap::Colour, MaterialMap::Normal};
    auto maps = isLeaf ? makeMaps(material.leaf, m_mapSize, leafKinds)
                       : makeMaps(material.bark, m_mapSize, barkKinds, progress);
    RAMURE_TRY(maps);
    for (auto& [map, png] : *maps) {
        if (map == MaterialMap::Colour && !hasColourOfSummer(material))
            continue;
        const std::string name = keep(isLeaf ? mapFileName(material.leaf, m_mapSize, map)
                                             : mapFileName(material.bark, m_mapSize, map),
                                      std::move(png));
        if (map == MaterialMap::Colour)
            made.textures.push_back({name, "diffuseColor", "rgb", true});
        else if (map == MaterialMap::Normal)
            made.textures.push_back({name, "normal", "rgb"});
        else
            made.textures.push_back({name, map == MaterialMap::Occlusion ? "occlusion" : "roughness", "r"});
    }
    return {};
}

/// Each in the place of what the program has made. Heights have no place here: the program's own normals
/// belong to its own height.
Expected<void> Materials::addOwn(Made& made, const Material& material)
{
    const PictureParams& own = material.pictures;
    if (!own.height.empty())
        std::erase_if(made.textures, [](const Texture& t) { return t.input == std::string_view("normal"); });
    const std::pair<const std::string*, Texture> places[] = {{&own.colour, {{}, "diffuseColor", "rgb", true}},
                                                             {&own.normal, {{}, "normal", "rgb"}},
                                                             {&own.roughness, {{}, "roughness", "r"}},
                                                             {&own.occlusion, {{}, "occlusion", "r"}},
                                                             {&own.opacity, {{}, "opacity", "r"}}};
    for (const auto& [path, texture] : places) {
        if (path->empty())
            continue;
        auto bytes = pictureBytes(*path);
        RAMURE_TRY(bytes);
        if (!isUsable(*bytes)) {
            auto error =
                fail(ErrorCode::Invalid, RAMURE_NOOP("only PNG, JPEG and EXR can be pictures of a USD file"));
            error.value().file = *path;
            return error;
        }
        const std::string_view input = texture.input;
        std::erase_if(made.textures, [&](const Texture& t) { return t.input == input; });
        if (input == "opacity")
            made.cutoff = 0.5;
        made.textures.push_back(texture);
        made.textures.back().file = keep(pictureFileName(*path), std::move(*bytes));
    }
    return {};
}

/// Returns the name of its file, fit for a path in a layer.
std::string Materials::keep(std::string name, std::string bytes)
{
    for (char& c : name)
        if (!((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
              c == '-' || c == '_'))
            c = '_';
    if (std::ranges::find(m_pictures, name, &Picture::name) == m_pictures.end())
        m_pictures.push_back({name, std::move(bytes)});
    return name;
}

/// It is the alpha of the picture of colour.
bool Materials::isAlpha(const Texture& texture)
{
    return texture.output == std::string_view("a");
}

void Materials::write(Text& text) const
{
    if (m_made.empty())
        return;
    text.open("def Scope " + inQuotes(m_path.substr(m_path.rfind('/') + 1)));
    for (const Made& made : m_made)
        write(text, made);
    text.close();
}

void Materials::write(Text& text, const Made& made) const
{
    const std::string path = m_path + "/" + made.prim;
    const auto has = [&](std::string_view input) {
        return std::ranges::any_of(made.textures, [&](const Texture& t) { return t.input == input; });
    };
    std::vector<std::string> metadata;
    if (made.prim != made.title)
        metadata.push_back("displayName = " + inQuotes(made.title));
    text.open("def Material " + inQuotes(made.prim), metadata);
    text.line("token outputs:surface.connect = " + target(path + "/Surface.outputs:surface"));
    text.open("def Shader \"Surface\"");
    text.line("uniform token info:id = \"UsdPreviewSurface\"");
    if (!has("diffuseColor"))
        text.line("color3f inputs:diffuseColor = " + colourText(made.colour));
    if (!has("roughness"))
        text.line(made.roughness > 0.8 ? "float inputs:roughness = 0.9" : "float inputs:roughness = 0.6");
    text.line("float inputs:metallic = 0");
    if (made.cutoff) {
        std::array<char, 32> number{};
        text.line("float inputs:opacityThreshold = " +
                  std::string(number.data(), appendRounded(number.data(), *made.cutoff)));
    }
    for (const Texture& texture : made.textures) {
        const std::string_view input = texture.input;
        const char* type = input == "diffuseColor" ? "color3f" : input == "normal" ? "normal3f" : "float";
        text.line(std::string(type) + " inputs:" + texture.input + ".connect = " +
                  target(path + "/" + (isAlpha(texture) ? "diffuseColor" : texture.input) +
                         ".outputs:" + texture.output));
    }
    text.line("token outputs:surface");
    text.close();
    if (!made.textures.empty()) {
        text.open("def Shader \"Coordinates\"");
        text.line("uniform token info:id = \"UsdPrimvarReader_float2\"");
        text.line("string inputs:varname = \"st\"");
        text.line("float2 outputs:result");
        text.close();
    }
    for (const Texture& texture : made.textures)
        if (!isAlpha(texture))
            write(text, made, texture, path);
    text.close();
}

void Materials::write(Text& text, const Made& made, const Texture& texture, const std::string& path)
{
    text.open("def Shader " + inQuotes(texture.input));
    text.line("uniform token info:id = \"UsdUVTexture\"");
    text.line("asset inputs:file = @./" + texture.file + "@");
    text.line("float2 inputs:st.connect = " + target(path + "/Coordinates.outputs:result"));
    text.line("token inputs:wrapS = \"repeat\"");
    text.line("token inputs:wrapT = \"repeat\"");
    text.line(std::string("token inputs:sourceColorSpace = ") + (texture.isColour ? "\"sRGB\"" : "\"raw\""));
    if (texture.isColour && made.scale != glm::vec3(1.0F)) {
        const std::string scale = colourText(made.scale);
        text.line("float4 inputs:scale = " + scale.substr(0, scale.size() - 1) + ", 1)");
    }
    if (texture.input == std::string_view("normal")) {
        text.line("float4 inputs:scale = (2, 2, 2, 1)");
        text.line("float4 inputs:bias = (-1, -1, -1, 0)");
    }
    const bool isOne = texture.output == std::string_view("r");
    text.line(std::string(isOne ? "float" : "float3") + " outputs:" + texture.output);
    if (texture.isColour && std::ranges::any_of(made.textures, &isAlpha))
        text.line("float outputs:a");
    text.close();
}

} // namespace ramure::usd
