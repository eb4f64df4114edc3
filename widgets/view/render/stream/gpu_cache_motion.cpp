// How blocks move: with bones, or in the wind of a game.
#include "core/game_wind/wind_elements.h"
#include "widgets/view/render/stream/gpu_cache.h"
#include <algorithm>
#include <cstddef>
#include <limits>

namespace ramure {
namespace {

using gpu::offset;

/// Per vertex, three bones and their weights.
struct VertexInfluence
{
    std::array<Index, 3> bone;
    std::array<float, 3> weight;
    float slope;
};

/// One for each copy, where there are some: a copy's vertices all follow the same bones.
std::vector<VertexInfluence> influencesOf(const Skin& skin, const MeshCopies& copies)
{
    const std::size_t count = copies.copies.size();
    const std::size_t vertices = std::max<std::size_t>(1, skin.vertices / std::max<std::size_t>(1, count));
    std::vector<VertexInfluence> all(count);
    for (std::size_t i = 0; i < count; ++i) {
        const SkinInfluence& influence = skin.of(static_cast<Index>(copies.pieceOf(i) * vertices));
        all[i] = {influence.bone, influence.weight, 0.0f};
    }
    return all;
}

} // namespace

const GpuBlock& GpuCache::influences(const std::shared_ptr<const Skin>& skin, const MeshCopies* copies)
{
    const auto [block, isNew] = slot(skin);
    if (!isNew)
        return block;
    std::vector<VertexInfluence> all(copies ? 0 : skin->vertices);
    for (std::size_t r = 0; r < skin->runs.size() && !copies; ++r) {
        const SkinRun& run = skin->runs[r];
        const Index end = r + 1 < skin->runs.size() ? skin->runs[r + 1].firstVertex : skin->vertices;
        std::fill(all.begin() + run.firstVertex, all.begin() + end,
                  VertexInfluence{run.influence.bone, run.influence.weight, run.slope});
    }
    if (copies)
        all = influencesOf(*skin, *copies);
    addBuffer(block, GL_ARRAY_BUFFER, all.data(), all.size() * sizeof(VertexInfluence));
    fill(block, std::numeric_limits<std::size_t>::max()); // the vector is gone afterwards
    block.count = static_cast<GLsizei>(all.size());
    return block;
}

/// The mesh's vertex array reads this skin from now on; without one, what it reads is not used.
void GpuCache::attachSkin(GpuBlock& block, const std::shared_ptr<const Skin>& skin, const MeshCopies* copies)
{
    if (!skin)
        return;
    const GLuint buffer = influences(skin, copies).buffers.front().name;
    if (block.skin == skin)
        return;
    m_gl.glBindVertexArray(block.vertexArray);
    m_gl.glBindBuffer(GL_ARRAY_BUFFER, buffer);
    constexpr GLsizei stride = sizeof(VertexInfluence);
    m_gl.glVertexAttribIPointer(5, 3, GL_UNSIGNED_INT, stride, offset(offsetof(VertexInfluence, bone)));
    m_gl.glVertexAttribPointer(6, 3, GL_FLOAT, GL_FALSE, stride, offset(offsetof(VertexInfluence, weight)));
    m_gl.glVertexAttribPointer(7, 1, GL_FLOAT, GL_FALSE, stride, offset(offsetof(VertexInfluence, slope)));
    for (const GLuint attribute : {5u, 6u, 7u}) {
        m_gl.glEnableVertexAttribArray(attribute);
        m_gl.glVertexAttribDivisor(attribute, copies ? 1 : 0);
    }
    m_gl.glBindVertexArray(0);
    block.skin = skin;
}

const GpuBlock& GpuCache::bones(const std::shared_ptr<const std::vector<RigidTransform>>& bones)
{
    const auto [block, isNew] = slot(bones);
    if (!isNew)
        return block;
    m_texels.resize(2 * bones->size());
    for (std::size_t b = 0; b < bones->size(); ++b) {
        const RigidTransform& bone = (*bones)[b];
        m_texels[2 * b] = glm::vec4(bone.rotation.x, bone.rotation.y, bone.rotation.z, bone.rotation.w);
        m_texels[2 * b + 1] = glm::vec4(glm::vec3(bone.translation), 0.0f);
    }
    fillTexels(block);
    if (block.texture != 0)
        block.count = static_cast<GLsizei>(bones->size());
    return block;
}

/// m_texels as a texture, row after row, where the card has room for it.
void GpuCache::fillTexels(GpuBlock& block)
{
    const std::size_t rows = textureRows(m_texels.size(), m_largestTexture);
    if (rows == 0)
        return;
    m_texels.resize(rows * gpu::stateWidth);
    m_gl.glGenTextures(1, &block.texture);
    m_gl.glBindTexture(GL_TEXTURE_2D, block.texture);
    m_gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, gpu::stateWidth, static_cast<GLsizei>(rows), 0, GL_RGBA,
                      GL_FLOAT, m_texels.data());
    m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    m_stats.bytes += m_texels.size() * sizeof(glm::vec4);
}

/// The mesh's vertex array reads this wind from now on: per vertex or per copy.
void GpuCache::attachWind(GpuBlock& block, const std::shared_ptr<const ItemWind>& wind, bool copies)
{
    if (!wind)
        return;
    const auto [numbers, isNew] = slot(wind);
    if (isNew)
        addBuffer(numbers, GL_ARRAY_BUFFER, wind->places.data(), wind->places.size() * sizeof(glm::vec3));
    drawn(numbers);
    if (block.wind == wind)
        return;
    m_gl.glBindVertexArray(block.vertexArray);
    m_gl.glBindBuffer(GL_ARRAY_BUFFER, numbers.buffers.front().name);
    m_gl.glVertexAttribPointer(11, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    m_gl.glEnableVertexAttribArray(11);
    m_gl.glVertexAttribDivisor(11, copies ? 1 : 0);
    m_gl.glBindVertexArray(0);
    block.wind = wind;
}

const GpuBlock& GpuCache::elements(const std::shared_ptr<const TreeWind>& wind)
{
    const auto [block, isNew] = slot(wind);
    if (!isNew)
        return block;
    m_texels = wind->texels;
    fillTexels(block);
    return block;
}

void GpuCache::bindBones(ShaderProgram& program, const ItemMotion& motion)
{
    m_gl.glActiveTexture(GL_TEXTURE0 + bonesUnit);
    const GpuBlock* block = motion.moves() ? &bones(motion.bones) : nullptr;
    m_gl.glBindTexture(GL_TEXTURE_2D, block && block->texture != 0 ? block->texture : restTexture());
    m_gl.glActiveTexture(GL_TEXTURE0);
    program.set("uBoneCount", block ? block->count : 0);
    program.set("uSkinMethod", int(motion.method));
}

void GpuCache::bindMotion(ShaderProgram& program, const ItemMotion& motion)
{
    bindBones(program, motion);
    m_gl.glActiveTexture(GL_TEXTURE0 + elementsUnit);
    const GpuBlock* block = motion.wind ? &elements(motion.wind->tree) : nullptr;
    m_gl.glBindTexture(GL_TEXTURE_2D, block && block->texture != 0 ? block->texture : restTexture());
    m_gl.glActiveTexture(GL_TEXTURE0);
    program.set("uWindProfile", motion.wind ? int(motion.wind->tree->profile) : 0);
    if (!motion.wind)
        return;
    const TreeWind& tree = *motion.wind->tree;
    constexpr PivotMotion pivots;
    program.set("uWindDirection", tree.direction);
    program.set("uWindNow", glm::vec2(m_wind.strength, m_wind.seconds));
    program.set("uWindTree", glm::vec4(tree.base, tree.lean, tree.bendScale, motion.wind->flutter));
    program.set("uTurns", glm::vec4(pivots.turns[0], pivots.turns[1], pivots.turns[2], pivots.turns[3]));
    program.set("uGusts", glm::vec4(pivots.gustOffset, pivots.falloff, pivots.speed, pivots.across));
    program.set("uShelter", glm::vec3(0.01 * pivots.worldScale, pivots.shelterBias, pivots.shelterScale));
}

} // namespace ramure
