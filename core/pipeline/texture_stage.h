/// \file
/// The stage of texture coordinates: they are computed at the first request, then kept beside their mesh.
/// Views, files and checks all ask it.
#pragma once

#include "core/pipeline/stage_cache.h"
#include "core/surface/texture/texture_coordinates.h"
#include <mutex>

namespace ramure {

/// Does the bark have a picture, so that its branches need texture coordinates to be drawn?
bool isPictured(const NodeParams& params);

class TextureStage
{
public:
    /// \param rest of a tree at rest: it keeps its texture while it moves.
    explicit TextureStage(std::shared_ptr<const BranchMesh> rest);

    /// May be called from any thread; two simultaneous callers may both compute. Errors: those of
    /// textureCoordinates.
    Expected<std::shared_ptr<const TextureCoordinates>> coordinates(const TextureParams& params,
                                                                    const Progress& progress = {}) const;
    /// The memory of the coordinates that are kept, without the mesh. From any thread.
    [[nodiscard]] std::size_t bytes() const;

private:
    std::shared_ptr<const BranchMesh> m_rest;
    mutable std::mutex m_mutex;
    mutable StageCache<TextureCoordinates> m_kept; ///< by the hash of the parameters
};

} // namespace ramure
