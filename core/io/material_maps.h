/// \file
/// The pictures of materials as files: colour, normal, height, occlusion and roughness of a bark; colour,
/// normal and height of a leaf.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/lod/card_atlas.h"
#include "core/params/bark_params.h"
#include "core/params/leaf_params.h"
#include "core/params/picture_params.h"
#include <array>
#include <span>
#include <string>
#include <vector>

namespace ramure {

enum class MaterialMap : std::uint8_t { Colour, Normal, Height, Occlusion, Roughness };
inline constexpr std::array mapNames = {"colour", "normal", "height", "occlusion", "roughness"};

/// Returns a name such as "bark_furrowed_1f3a9c04_1024_normal.png". The hash in it covers everything that the
/// picture depends on, so frames of a sequence and neighbours in a folder share equal pictures and never take
/// wrong ones.
std::string mapFileName(const BarkParams& bark, int size, MaterialMap map);
/// "leaf_oak_1_1024_normal.png". The number is leafMapsVersion. \pre the map is one of leafMapKinds.
/// \param season LeafParams::season: the colours of another than summer have a name of their own,
/// "leaf_oak_1_season40_1024_colour.png", by the hundredth.
std::string mapFileName(LeafShape leaf, int size, MaterialMap map, double season = 0.0);
inline constexpr std::array leafMapKinds{MaterialMap::Colour, MaterialMap::Normal, MaterialMap::Height};

/// Writes the five pictures of a bark into a folder. If all are there already, nothing is written, so
/// pictures that somebody painted over survive. Returns the names of the written files. Errors: Invalid
/// (plain bark), Limit (the size), Io (with file), Cancelled.
Expected<std::vector<std::string>> writeMaps(const std::string& folder, const BarkParams& bark, int size,
                                             const Progress& progress = {});

/// A picture as the bytes of a PNG file.
struct MadeMap
{
    MaterialMap map;
    std::string png;
};
/// Makes the same pictures in memory, those of \p kinds in their order. Errors: Invalid, Limit, Cancelled.
Expected<std::vector<MadeMap>> makeMaps(const BarkParams& bark, int size, std::span<const MaterialMap> kinds,
                                        const Progress& progress = {});
/// Makes the maps of a leaf in summer. \pre all kinds are of leafMapKinds.
Expected<std::vector<MadeMap>> makeMaps(LeafShape leaf, int size, std::span<const MaterialMap> kinds);

/// Returns the name for a copy of an image file: its own name with a number made from its folder,
/// "oak_1f3a9c04.jpg".
std::string pictureFileName(const std::string& picture);
/// The bytes of an image file. Error: Io (missing, no file, unreadable), with the file.
Expected<std::string> pictureBytes(const std::string& path);
/// Copies the image files of a surface into a folder, as they are. Errors, all with the file: Io (missing, no
/// file, unreadable; not written).
Expected<void> copyPictures(const std::string& folder, const PictureParams& pictures);

/// The pictures on cards: colour (with opacity, and alone), opacity and normal.
struct MadeSprays
{
    std::string cut, colour, opacity, normal; ///< the bytes of PNG files
};
/// Makes them in memory. \param size pixels a side; the nearest power of two is taken. Errors: Limit,
/// Cancelled.
Expected<MadeSprays> makeMaps(const CardAtlas& sprays, int size, const Progress& progress = {});
/// "sprays_oak_1f3a9c04_1024_colour.png"
std::string sprayFileName(const CardAtlas& sprays, int size, const char* map);
/// Writes colour, opacity and normal into a folder, as writeMaps() does. Errors: Io, Cancelled.
Expected<std::vector<std::string>> writeMaps(const std::string& folder, const CardAtlas& sprays, int size,
                                             const Progress& progress = {});

/// Writes the pictures of a leaf in the same way. Errors: Invalid (the faithful leaf, the size), Io.
Expected<std::vector<std::string>> writeMaps(const std::string& folder, LeafShape leaf, int size,
                                             double season = 0.0);

} // namespace ramure
