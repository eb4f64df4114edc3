#include "core/io/formats/usd/usd_look.h"

#include "core/io/formats/glb/glb_surfaces.h"
#include "core/io/formats/usd/usd_materials.h"
#include "core/io/picture_file.h"
#include <algorithm>
#include <filesystem>

namespace ramure::usd {
namespace {

constexpr int longest = 8; // connections one behind the other

/// Three numbers from 0 to 1 of an input, if it has so many.
std::optional<glm::vec3> colourOf(const Prim& prim, const std::string& input)
{
    const Attribute* attribute = prim.attribute(input);
    const Value* value = attribute ? attribute->get() : nullptr;
    if (!value || value->numbers.size() < 3)
        return std::nullopt;
    glm::vec3 out;
    for (int k = 0; k < 3; ++k)
        out[k] = static_cast<float>(std::clamp(value->numbers[static_cast<std::size_t>(k)], 0.0, 1.0));
    return out;
}

} // namespace

const Look& Looks::of(const std::string& path, std::vector<Note>& notes)
{
    const auto known = m_looks.find(path);
    return known != m_looks.end() ? known->second : m_looks.emplace(path, read(path, notes)).first->second;
}

/// The prim that gives an input its value: itself, or what is connected with it in the end.
Looks::Found Looks::leadsTo(const Prim& prim, const std::string& input, int depth) const
{
    const Attribute* attribute = prim.attribute(input);
    if (!attribute || attribute->connections.empty() || depth > longest)
        return {&prim, input};
    const std::string& path = attribute->connections.front();
    const std::size_t dot = std::min(path.find('.'), path.size());
    const Prim* from = primAt(m_root, std::string_view(path).substr(0, dot));
    const std::string name = dot < path.size() ? path.substr(dot + 1) : std::string();
    if (!from)
        return {};
    if (name.starts_with("outputs:") &&
        !(from->attribute(name) && !from->attribute(name)->connections.empty()))
        return {from, name.substr(8)};
    return leadsTo(*from, name, depth + 1);
}

Look Looks::read(const std::string& path, std::vector<Note>& notes)
{
    Look look;
    const Prim* material = path.empty() ? nullptr : primAt(m_root, path);
    if (!material)
        return look;
    const Prim* surface = leadsTo(*material, "outputs:surface").prim;
    if (!surface || surface->text("info:id") != "UsdPreviewSurface") {
        notes.push_back(fail(ErrorCode::Unknown,
                             RAMURE_NOOP("the material %1 is no UsdPreviewSurface: its colour is left out"),
                             {material->name})
                            .value());
        return look;
    }
    const Found colour = leadsTo(*surface, "inputs:diffuseColor");
    const std::string kind = colour.prim ? colour.prim->text("info:id") : "";
    constexpr float usual = 0.18F; // of UsdPreviewSurface
    look.readsColours = kind == "UsdPrimvarReader_float3" ||
                        (kind == "UsdUVTexture" && colour.prim->text("inputs:file").ends_with(paletteFile));
    if (kind == "UsdUVTexture" && !look.readsColours)
        look.colour = colourOf(*colour.prim, "inputs:scale").value_or(glm::vec3(1.0F));
    else if (colour.prim && !look.readsColours)
        look.colour = colourOf(*colour.prim, colour.output).value_or(glm::vec3(usual));
    const std::pair<const char*, std::string PictureParams::*> places[] = {
        {"inputs:diffuseColor", &PictureParams::colour},
        {"inputs:normal", &PictureParams::normal},
        {"inputs:roughness", &PictureParams::roughness},
        {"inputs:occlusion", &PictureParams::occlusion},
        {"inputs:opacity", &PictureParams::opacity}};
    for (const auto& [input, to] : places)
        if (const Found from = leadsTo(*surface, input); from.prim &&
                                                         from.prim->text("info:id") == "UsdUVTexture" &&
                                                         !(look.readsColours && to == &PictureParams::colour))
            takePicture(look, to, from, notes);
    return look;
}

void Looks::takePicture(Look& look, std::string PictureParams::*to, const Found& from,
                        std::vector<Note>& notes)
{
    const std::string asset = from.prim->text("inputs:file");
    if (asset.empty())
        return;
    look.hasPictures = true;
    if (!m_isForPictures)
        return;
    if (auto file = fileOf(asset, from.output))
        look.pictures.*to = std::move(*file);
    else {
        notes.push_back(std::move(file.error()));
        notes.back().line = from.prim->line;
    }
}

Expected<std::string> Looks::fileOf(const std::string& asset, const std::string& output)
{
    const int channel = output == "g" ? 1 : output == "b" ? 2 : output == "a" ? 3 : -1;
    if (const std::string path = m_source.path(asset); !path.empty() && channel < 0)
        return path;
    auto bytes = m_source.bytes(asset);
    RAMURE_TRY(bytes);
    std::string name = std::filesystem::path(asset).filename().string();
    if (channel >= 0) {
        bytes = channelPng(*bytes, channel);
        RAMURE_TRY(bytes);
        name = std::filesystem::path(name).stem().string() + "_" + output + ".png";
    }
    ++m_written;
    return glb::keepPicture(m_source.folder, name, *bytes);
}

} // namespace ramure::usd
