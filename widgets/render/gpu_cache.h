/// \file
/// The blocks of a render scene on the graphics card. A block is uploaded when it is first asked for and
/// freed when a picture did not use it. The cache keeps the CPU block alive as long as its copy: an address
/// is never reused.
#pragma once

#include "widgets/render/render_scene.h"
#include "widgets/render/shader_program.h"
#include <cstdint>
#include <map>
#include <vector>

namespace ramure {

/// Buffers and vertex array of one block.
struct GpuBlock
{
    std::shared_ptr<const void> source;
    GLuint vertexArray = 0;
    std::vector<GLuint> buffers;
    GLuint texture = 0;
    GLsizei count = 0; ///< indices, instances, or entries
    std::uint64_t usedIn = 0;
};

struct UploadStats
{
    std::uint64_t uploads = 0; ///< blocks since the start
    std::uint64_t bytes = 0;
    std::uint64_t freed = 0; ///< blocks
    std::size_t alive = 0;   ///< blocks now on the card
};

/// Every function needs the cache's context current.
class GpuCache
{
public:
    explicit GpuCache(Gl& gl);
    ~GpuCache();
    GpuCache(const GpuCache&) = delete;
    GpuCache& operator=(const GpuCache&) = delete;

    void beginPicture() { ++m_picture; }
    const GpuBlock& mesh(const std::shared_ptr<const TriangleMesh>& mesh);
    const GpuBlock& lines(const std::shared_ptr<const LineSet>& lines);
    const GpuBlock& points(const std::shared_ptr<const PointSet>& points);
    const GpuBlock& states(const std::shared_ptr<const BranchStates>& states);
    /// Frees what was not asked for since beginPicture.
    void freeUnused();
    [[nodiscard]] UploadStats stats() const;

private:
    /// The block of this source, and whether it has to be filled.
    std::pair<GpuBlock&, bool> slot(const std::shared_ptr<const void>& source);
    GLuint addBuffer(GpuBlock& block, GLenum target, const void* data, std::size_t bytes);
    void free(GpuBlock& block);

    Gl& m_gl;
    std::map<const void*, GpuBlock> m_blocks;
    UploadStats m_stats;
    std::uint64_t m_picture = 0;
};

} // namespace ramure
