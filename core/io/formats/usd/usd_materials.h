/// \file
/// Materials of a USD layer: UsdPreviewSurface with its textures, and the pictures that stand beside the
/// layer or inside the package. Internal to the formats.
#pragma once

#include "core/io/formats/usd/usd_text.h"
#include "core/scene/material.h"
#include "core/surface/mesh/triangle_mesh.h"
#include <map>
#include <optional>

namespace ramure::usd {

/// The picture of all colours: surfaces with colours of their own have coordinates in it, which every reader
/// understands.
inline constexpr const char* paletteFile = "ramure_colours_1.png";
/// The place of a colour in it. It comes back within 4 of 255 steps.
glm::vec2 placeInPalette(const glm::u8vec3& colour);

struct Picture
{
    std::string name; ///< of its file: letters, digits, dots, dashes, underscores
    std::string bytes;
};

/// What a surface has that decides how its material is made.
struct Wear
{
    bool textured = false;  ///< texture coordinates, and pictures are wanted
    bool coloured = false;  ///< colours of its own, per triangle or per copy
    bool isPainted = false; ///< and they are places in the picture of all colours
    glm::vec3 mean{1.0F};   ///< linear, of these colours: what multiplies a picture, or the material's colour
};

class Materials
{
public:
    /// \param path of the prim below which materials stand \param mapSize pixels a side of pictures that the
    /// program makes; 0: no pictures
    Materials(std::string path, int mapSize)
        : m_path(std::move(path))
        , m_mapSize(mapSize)
    {
    }

    /// True if it has pictures, which need texture coordinates.
    [[nodiscard]] bool isPictured(const Material& material) const;
    /// Returns the path of the material's prim, which is added if it is not there yet. Errors: those of the
    /// maps; Io and Invalid of image files (with file), of which PNG, JPEG and EXR can be used.
    Expected<std::string> add(const Material& material, const Wear& wear, const Progress& progress);
    /// All prims that were added.
    void write(Text& text) const;
    /// The pictures that they name, each once.
    [[nodiscard]] const std::vector<Picture>& pictures() const { return m_pictures; }

private:
    struct Texture
    {
        std::string file;
        const char* input = "";  ///< of the surface: "diffuseColor"
        const char* output = ""; ///< of the texture: "rgb"
        bool isColour = false;   ///< sRGB, and multiplied with the mean of the surface's colours
    };
    struct Made
    {
        std::string prim, title;
        glm::vec3 colour{1.0F}; ///< linear
        glm::vec3 scale{1.0F};  ///< of a picture of colour
        double roughness = 0.9;
        std::optional<double> cutoff;
        std::vector<Texture> textures;
    };

    Expected<void> addMade(Made& made, const Material& material, const Progress& progress);
    Expected<void> addOwn(Made& made, const Material& material);
    std::string keep(std::string name, std::string bytes);
    static bool isAlpha(const Texture& texture);
    void write(Text& text, const Made& made) const;
    static void write(Text& text, const Made& made, const Texture& texture, const std::string& path);

    std::string m_path;
    int m_mapSize;
    Names m_names;
    std::map<std::string, std::string> m_paths; ///< by what tells them apart
    std::vector<Made> m_made;
    std::vector<Picture> m_pictures;
};

} // namespace ramure::usd
