/// \file
/// Materials of a GLB, and the pictures inside it as files that nodes can name. Internal to the formats.
#pragma once

#include "core/io/formats/glb/glb_file.h"
#include "core/io/formats/text/animation_file.h"
#include "core/params/picture_params.h"
#include <glm/vec3.hpp>
#include <set>

namespace ramure::glb {

struct Surface
{
    glm::vec3 colour{1.0F}; ///< linear
    bool hasPictures = false;
};
/// White and plain where there is no such material. Errors: Invalid, with the place inside.
Expected<Surface> surfaceOf(const File& file, std::optional<std::size_t> material);

/// Writes a file into a folder, which is made if it is not there. A file of that name with other bytes stays:
/// the new one gets a number behind its name. Returns its path. Errors: Io, Limit.
Expected<std::string> keepPicture(const std::string& folder, const std::string& name, std::string_view bytes);

/// Writes the pictures of materials into a folder beside the GLB, NAME_pictures, each once.
class PictureFolder
{
public:
    /// \param path of the GLB
    PictureFolder(File& file, const std::string& path);

    /// Colour, normals, occlusion, roughness and opacity, as far as the material has them. What cannot be
    /// read or written is a note, and not there.
    PictureParams write(std::size_t material, std::vector<Note>& notes);
    /// How many files there are, and where.
    [[nodiscard]] std::size_t count() const { return m_files.size(); }
    [[nodiscard]] const std::string& folder() const { return m_folder; }

private:
    Expected<std::string_view> bytesOf(const Json& texture, const std::string& place);
    Expected<std::string> keep(const std::string& name, std::string_view bytes);

    File& m_file;
    std::string m_folder;
    std::set<std::string> m_files;                 ///< that are there
    std::map<std::size_t, std::string> m_fromText; ///< images that stand in the JSON
};

} // namespace ramure::glb
