#include "core/io/formats/glb/glb_parts.h"
#include "core/io/material_maps.h"
#include "core/io/picture_file.h"
#include "core/surface/foliage/leaf_table.h"

namespace ramure::glb {
namespace {

constexpr const char* translucent = "KHR_materials_diffuse_transmission";

Json linearColour(const glm::u8vec3& colour)
{
    return {linear(colour.r), linear(colour.g), linear(colour.b)};
}

bool isMade(const Material& material)
{
    return material.leaf != LeafShape::Faithful || material.bark.family != BarkFamily::Plain ||
           material.sprays;
}

/// The picture of a leaf has the colour of summer; at other times the leaves have colours without one.
bool hasColourOfSummer(const Material& material)
{
    return material.leaf == LeafShape::Faithful || material.colour == leafColour(material.leaf, false);
}

/// null: neither.
const char* typeOf(std::string_view bytes)
{
    if (bytes.starts_with("\x89PNG\r\n\x1a\n"))
        return "image/png";
    return bytes.starts_with("\xFF\xD8\xFF") ? "image/jpeg" : nullptr;
}

Error inFile(Error error, const std::string& path)
{
    error.file = path;
    return error;
}

} // namespace

bool Materials::isPictured(const Material& material) const
{
    return m_mapSize > 0 && (isMade(material) || !material.pictures.isEmpty());
}

bool Materials::hasNormals(std::size_t material) const
{
    return m_materials[material].contains("normalTexture");
}

const BarkParams* Materials::barkOf(std::size_t material) const
{
    const BarkParams& bark = m_barks[material];
    return bark.family == BarkFamily::Plain ? nullptr : &bark;
}

Expected<std::size_t> Materials::add(const Material& material, bool textured, bool coloured,
                                     const Progress& progress)
{
    const std::string key = material.name + (textured ? " textured" : "") + (coloured ? " coloured" : "");
    if (const auto found = m_numbers.find(key); found != m_numbers.end())
        return found->second;
    Json pbr{{"metallicFactor", 0.0}, {"roughnessFactor", material.phong ? 0.6 : 0.9}};
    Json out{{"name", material.name}, {"pbrMetallicRoughness", std::move(pbr)}};
    if (material.twoSided)
        out["doubleSided"] = true;
    if (material.through > 0.0F) {
        m_isTranslucent = true;
        // As much light as a leaf throws back.
        const float factor = material.pigments ? 0.5F : material.through;
        const glm::u8vec3 colour = material.pigments ? material.passed : material.colour;
        out["extensions"][translucent] = {{"diffuseTransmissionFactor", factor},
                                          {"diffuseTransmissionColorFactor", linearColour(colour)}};
    }
    if (textured)
        RAMURE_TRY(addPictures(out, material, progress));
    Json& made = out["pbrMetallicRoughness"];
    // Colours that are no tones are all that is to be seen; pictures stand for the colour of the material.
    const bool isWhite = made.contains("baseColorTexture") || (coloured && !material.tones);
    if (!isWhite) {
        made["baseColorFactor"] = linearColour(material.colour);
        made["baseColorFactor"].push_back(1.0);
    }
    if (material.hidden) {
        out["alphaMode"] = "MASK";
        made["baseColorFactor"] = {1.0, 1.0, 1.0, 0.0};
    }
    m_materials.push_back(std::move(out));
    m_barks.push_back(material.pictures.colour.empty() ? material.bark : BarkParams());
    return m_numbers[key] = m_materials.size() - 1;
}

Expected<void> Materials::addPictures(Json& out, const Material& material, const Progress& progress)
{
    constexpr std::array barkKinds{MaterialMap::Colour, MaterialMap::Normal, MaterialMap::Occlusion,
                                   MaterialMap::Roughness};
    constexpr std::array leafKinds{MaterialMap::Colour, MaterialMap::Normal};
    Json& pbr = out["pbrMetallicRoughness"];
    const bool isLeaf = material.leaf != LeafShape::Faithful;
    if (material.sprays)
        return addSprays(out, *material.sprays, progress);
    if (isMade(material)) {
        const auto maps = isLeaf ? makeMaps(material.leaf, m_mapSize, leafKinds)
                                 : makeMaps(material.bark, m_mapSize, barkKinds, progress);
        RAMURE_TRY(maps);
        for (const auto& [map, png] : *maps) {
            const std::string name = isLeaf ? mapFileName(material.leaf, m_mapSize, map)
                                            : mapFileName(material.bark, m_mapSize, map);
            if (map == MaterialMap::Colour && hasColourOfSummer(material))
                pbr["baseColorTexture"] = texture(name, png, "image/png");
            else if (map == MaterialMap::Normal)
                out["normalTexture"] = texture(name, png, "image/png");
            else if (map == MaterialMap::Occlusion)
                out["occlusionTexture"] = texture(name, png, "image/png");
            else if (map ==
                     MaterialMap::Roughness) // grey: its blue is taken as metal, of which there is none
                pbr["metallicRoughnessTexture"] = texture(name, png, "image/png");
        }
        if (pbr.contains("metallicRoughnessTexture"))
            pbr["roughnessFactor"] = 1.0;
    }
    return addOwnPictures(out, material);
}

/// Twigs, or the tree, cut out of cards.
Expected<void> Materials::addSprays(Json& out, const CardAtlas& sprays, const Progress& progress)
{
    const auto maps = makeMaps(sprays, m_mapSize, progress);
    RAMURE_TRY(maps);
    const std::string name = sprayFileName(sprays, m_mapSize, "cut");
    out["pbrMetallicRoughness"]["baseColorTexture"] = texture(name, maps->cut, "image/png");
    out["normalTexture"] = texture(sprayFileName(sprays, m_mapSize, "normal"), maps->normal, "image/png");
    out["alphaMode"] = "MASK"; // at a half
    return {};
}

/// Each in the place of what the program has made. Heights have no place in a GLB.
Expected<void> Materials::addOwnPictures(Json& out, const Material& material)
{
    const PictureParams& own = material.pictures;
    Json& pbr = out["pbrMetallicRoughness"];
    if (!own.normal.empty() || !own.height.empty())
        out.erase("normalTexture"); // the program's belong to its height
    const std::pair<Json*, const std::string*> places[] = {{&pbr["baseColorTexture"], &own.colour},
                                                           {&pbr["metallicRoughnessTexture"], &own.roughness},
                                                           {&out["normalTexture"], &own.normal},
                                                           {&out["occlusionTexture"], &own.occlusion}};
    for (const auto& [place, path] : places)
        if (auto done = path->empty() ? Expected<void>() : addOwn(*place, *path); !done)
            return done;
    if (!own.roughness.empty())
        pbr["roughnessFactor"] = 1.0;
    if (!own.opacity.empty()) {
        auto colour = own.colour.empty() ? Expected<std::string>() : pictureBytes(own.colour);
        const auto opacity = pictureBytes(own.opacity);
        if (!colour || !opacity)
            return fail(!colour ? colour.error() : opacity.error());
        auto masked = maskedPng(*colour, *opacity);
        if (!masked)
            return fail(inFile(std::move(masked.error()), own.opacity));
        pbr["baseColorTexture"] = texture(own.colour + '\n' + own.opacity, *masked, "image/png");
        out["alphaMode"] = "MASK";
    }
    for (Json* parent : {&pbr, &out})
        for (auto it = parent->begin(); it != parent->end();)
            it = it->is_null() ? parent->erase(it) : std::next(it);
    return {};
}

Expected<void> Materials::addOwn(Json& place, const std::string& path)
{
    const auto bytes = pictureBytes(path);
    RAMURE_TRY(bytes);
    const char* type = typeOf(*bytes);
    if (!type)
        return fail(inFile(
            {ErrorCode::Invalid, RAMURE_NOOP("only PNG and JPEG can stand in a GLB"), {}, {}, {}}, path));
    place = texture(path, *bytes, type);
    return {};
}

/// Once for each name.
Json Materials::texture(const std::string& name, std::string_view bytes, const char* type)
{
    const auto [found, isNew] = m_textureNumbers.try_emplace(name, m_textures.size());
    if (isNew) {
        m_images.push_back({{"bufferView", m_buffer.addView(bytes)}, {"mimeType", type}});
        m_textures.push_back({{"source", m_images.size() - 1}, {"sampler", 0}});
    }
    return {{"index", found->second}};
}

void Materials::addTo(Json& root) const
{
    if (m_materials.empty())
        return;
    root["materials"] = m_materials;
    if (m_isTranslucent)
        root["extensionsUsed"].push_back(translucent);
    if (m_textures.empty())
        return;
    root["textures"] = m_textures;
    root["images"] = m_images;
    constexpr int linearMipmapLinear = 9987, linearly = 9729;
    root["samplers"] = Json::array({{{"magFilter", linearly}, {"minFilter", linearMipmapLinear}}});
}

} // namespace ramure::glb
