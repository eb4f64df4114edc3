#include "core/pipeline/texture_stage.h"

#include "core/pipeline/stage_hashes.h"

namespace ramure {

bool isPictured(const NodeParams& params)
{
    return params.bark.family != BarkFamily::Plain || !params.barkPictures.isEmpty();
}

TextureStage::TextureStage(std::shared_ptr<const BranchMesh> rest)
    : m_rest(std::move(rest))
    , m_kept([](const TextureCoordinates& made) {
        return made.uv.capacity() * sizeof(glm::vec2) + made.vertex.capacity() * sizeof(Index) +
               made.radius.capacity() * sizeof(float) + made.corners.capacity() * sizeof(glm::uvec3);
    })
{
    m_kept.setCapacity(2);
}

Expected<std::shared_ptr<const TextureCoordinates>> TextureStage::coordinates(const TextureParams& params,
                                                                              const Progress& progress) const
{
    NodeParams all;
    all.texture = params;
    const std::uint64_t hash = StageHashes(all)[Stage::Texture];
    {
        const std::lock_guard lock(m_mutex);
        if (auto kept = m_kept.find(hash))
            return kept;
    }
    if (progress.cancelled()) // asked only for what is kept
        return fail(ErrorCode::Cancelled, RAMURE_NOOP("Cancelled"));
    // Nobody waits for another one's computation, which only that one can cancel.
    auto made = textureCoordinates(*m_rest, params, progress);
    RAMURE_TRY(made);
    const auto result = std::make_shared<const TextureCoordinates>(std::move(*made));
    const std::lock_guard lock(m_mutex);
    m_kept.keep(hash, result);
    return result;
}

std::size_t TextureStage::bytes() const
{
    const std::lock_guard lock(m_mutex);
    return m_kept.bytes();
}

} // namespace ramure
