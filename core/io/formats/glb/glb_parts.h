/// \file
/// The parts of a GLB file: one buffer with its views and accessors, vertices as graphics cards have them,
/// and materials with their pictures. Internal to glb_format.cpp. Names are those of the glTF 2.0
/// specification (Khronos Group, 2021), which has Y up and metres, as the program does.
#pragma once

#include "core/io/export_scene.h"
#include <glm/gtc/type_precision.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <span>

namespace ramure::glb {

using Json = nlohmann::json;

enum class Target : int { None = 0, Vertices = 34962, Indices = 34963 };
enum class Number : int {
    Byte = 5121,
    Short = 5123,
    Int = 5125,
    Float = 5126,
    Signed8 = 5120,
    Signed16 = 5122
};

/// Of numbers in a compressed file: places within 1/65,000 of how far they are from the origin, sizes and
/// colours.
inline constexpr int fineBits = 17, coarseBits = 12;

/// Values as EXT_meshopt_compression has them.
struct Packed
{
    std::string bytes;
    std::size_t stride = 0, count = 0; ///< of what they become again
    const char *mode = "ATTRIBUTES", *filter = "NONE";
};

/// Everything but the JSON.
class Buffer
{
public:
    /// \param isPacked views are compressed, which readers of the file have to know
    explicit Buffer(bool isPacked)
        : m_isPacked(isPacked)
    {
    }
    [[nodiscard]] bool isPacked() const { return m_isPacked; }

    /// \return the number of the view. It starts where any number may.
    std::size_t addView(std::string_view bytes, Target target = Target::None);
    std::size_t addPacked(const Packed& values, Target target);
    template <class T> std::size_t addValues(const std::vector<T>& values, Target target = Target::None)
    {
        return addNumbers({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)},
                          sizeof(T), target);
    }
    /// \param bits see packedFloats; what is not compressed is not rounded. \return the number of the
    /// accessor.
    template <class V>
    std::size_t addFloats(std::vector<V>& values, int bits, const char* type,
                          Target target = Target::Vertices)
    {
        const std::span<float> numbers(&values[0][0], values.size() * V::length());
        return addAccessor(addRounded(numbers, V::length(), bits, target), Number::Float, type,
                           values.size());
    }
    /// Places or ways, with the box about them, which readers want.
    std::size_t addPositions(std::vector<glm::vec3>& positions);
    /// Adds directions of unit length. \param isFine if compressed, they are right within a hundredth of a
    /// degree instead of one degree. \return the number of the accessor.
    std::size_t addDirections(const std::vector<glm::vec3>& directions, bool isFine = false);
    std::size_t addTangents(const std::vector<glm::vec4>& tangents);
    std::size_t addTurns(const std::vector<glm::vec4>& quaternions);
    /// \param type "SCALAR", "VEC3" ... \return the number of the accessor
    std::size_t addAccessor(std::size_t view, Number number, const char* type, std::size_t count,
                            bool isNormalised = false);
    Json& accessor(std::size_t at) { return m_accessors[at]; }

    /// \param root gets the views and accessors. Errors: Limit (4 GiB), those of FileWriter; Cancelled.
    Expected<void> write(const std::string& path, Json root, const Progress& progress) &&;

private:
    std::size_t addNumbers(std::string_view bytes, std::size_t stride, Target target);
    std::size_t addRounded(std::span<float> values, std::size_t components, int bits, Target target);
    void tellExtensions(Json& root) const;

    bool m_isPacked;
    bool m_isRounded = false; ///< directions are bytes
    /// One after the other: a single text would be copied whenever it grows. What cannot be written any more
    /// is not kept, but counted.
    std::vector<std::string> m_pieces;
    std::size_t m_size = 0;
    std::size_t m_unpacked = 0; ///< bytes that the compressed views become
    Json m_views = Json::array(), m_accessors = Json::array();
};

/// A vertex wherever position, place in the picture or colour differ.
struct Vertices
{
    std::vector<glm::vec3> positions, normals; ///< normals: as many, or none
    std::vector<glm::vec2> uv;                 ///< as many, or none; rows of pictures from the top
    std::vector<glm::vec4> tangents;           ///< as many, or none; w: the handedness
    std::vector<glm::u16vec4> colours;         ///< as many, or none; linear, 65535 is 1
    std::vector<Index> from;                   ///< per vertex its vertex in the mesh
    std::vector<Index> indices;
    /// What makes one surface of it again: of these indices, each is to be that vertex.
    std::vector<Index> mergeIndices, mergeValues;
};
/// \param textured with texture coordinates, where there are some
Vertices verticesOf(const TriangleMesh& mesh, bool textured);
/// What pictures of normals need: x around or to the right, y along the branch or to the tip of the leaf. As
/// in E. Lengyel, Foundations of Game Engine Development, volume 2 (2019), chapter 7.5. \pre uv and normals.
void addTangents(Vertices& vertices);

/// Adds to each vertex the colour that its bark is multiplied with, so that thin wood has a colour of its
/// own. Where that is lighter than old bark it keeps its hue alone. \pre The mesh has radii, the family is
/// not Plain.
void addAges(Vertices& vertices, const TriangleMesh& mesh, const BarkParams& bark);

/// Whether a mesh is closed and manifold. Of leaves that is known at once.
bool isClosed(const TriangleMesh& mesh);

/// What shaders want to know of the whole tree, for the extras of a mesh.
Json windExtras(const WindColumns& wind);

/// Linear, of an sRGB byte, and of sRGB from 0 to 1.
float linear(std::uint8_t channel);
glm::vec3 linear(const glm::vec3& colour);

/// Materials and their pictures, each once.
class Materials
{
public:
    /// \param mapSize pixels a side of pictures that the program makes; 0: no pictures
    Materials(Buffer& buffer, int mapSize)
        : m_buffer(buffer)
        , m_mapSize(mapSize)
    {
    }

    /// Whether it has pictures, which need texture coordinates.
    [[nodiscard]] bool isPictured(const Material& material) const;
    /// Returns the bark of a material that ages with the wood, null if it has none. The material was added
    /// before.
    [[nodiscard]] const BarkParams* barkOf(std::size_t material) const;
    /// Returns true if the material, which was added before, has a picture of normals.
    [[nodiscard]] bool hasNormals(std::size_t material) const;
    /// \param textured \param coloured what the mesh has. \return its number. Errors: those of the maps; Io
    /// and Invalid of image files (with file), of which PNG and JPEG can stand in a GLB.
    Expected<std::size_t> add(const Material& material, bool textured, bool coloured,
                              const Progress& progress);
    /// Materials, textures, images and the extensions that they need.
    void addTo(Json& root) const;

private:
    Expected<void> addPictures(Json& out, const Material& material, const Progress& progress);
    Expected<void> addSprays(Json& out, const CardAtlas& sprays, const Progress& progress);
    Expected<void> addOwnPictures(Json& out, const Material& material);
    Expected<void> addOwn(Json& place, const std::string& path);
    [[nodiscard]] Json texture(const std::string& name, std::string_view bytes, const char* type);

    Buffer& m_buffer;
    int m_mapSize;
    Json m_materials = Json::array(), m_textures = Json::array(), m_images = Json::array();
    std::vector<BarkParams> m_barks;                     ///< per material; Plain: it does not age
    std::map<std::string, std::size_t> m_numbers;        ///< of materials by their keys
    std::map<std::string, std::size_t> m_textureNumbers; ///< by the names of the pictures
    bool m_isTranslucent = false;
};

} // namespace ramure::glb
