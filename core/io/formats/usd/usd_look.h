/// \file
/// Materials of a USD layer as colours and pictures. Internal to the formats.
#pragma once

#include "core/io/formats/text/animation_file.h"
#include "core/io/formats/usd/usd_layer.h"
#include "core/params/picture_params.h"
#include <functional>
#include <glm/vec3.hpp>

namespace ramure::usd {

struct Look
{
    glm::vec3 colour{1.0F};    ///< linear; of a picture what multiplies it
    bool readsColours = false; ///< its colours are those of the mesh
    bool hasPictures = false;
    PictureParams pictures{};
};

/// The pictures of a layer, which stand beside it or inside the package.
struct PictureSource
{
    /// The bytes of a file that an asset names. Errors: Io, Unknown.
    std::function<Expected<std::string>(const std::string& asset)> bytes;
    /// Its path where it is a file of its own; empty: it is none.
    std::function<std::string(const std::string& asset)> path;
    std::string folder; ///< for pictures that have to become files
};

class Looks
{
public:
    /// \param isForPictures false: only colours are wanted
    Looks(const Prim& root, PictureSource source, bool isForPictures)
        : m_root(root)
        , m_source(std::move(source))
        , m_isForPictures(isForPictures)
    {
    }

    /// \param path of a Material; empty, or of a prim that there is not: a plain one. What cannot be read is
    /// a note.
    const Look& of(const std::string& path, std::vector<Note>& notes);
    /// How many pictures became files.
    [[nodiscard]] std::size_t written() const { return m_written; }

private:
    struct Found
    {
        const Prim* prim = nullptr;
        std::string output; ///< "rgb"
    };
    [[nodiscard]] Found leadsTo(const Prim& prim, const std::string& input, int depth = 0) const;
    Look read(const std::string& path, std::vector<Note>& notes);
    void takePicture(Look& look, std::string PictureParams::*to, const Found& from, std::vector<Note>& notes);
    Expected<std::string> fileOf(const std::string& asset, const std::string& output);

    const Prim& m_root;
    PictureSource m_source;
    bool m_isForPictures;
    std::map<std::string, Look> m_looks;
    std::size_t m_written = 0;
};

} // namespace ramure::usd
