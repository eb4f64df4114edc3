/// \file
/// Buffers on the graphics card that wait for their next use. While a slider moves, each picture needs
/// buffers of nearly the sizes of the one before; fresh memory costs the driver up to 3 ms per MiB where the
/// processor draws (it clears what it has never touched), memory used before costs nothing.
#pragma once

#include "widgets/view/render/shader_program.h"
#include <cstddef>
#include <vector>

namespace ramure {

struct GpuBuffer
{
    GLuint name = 0;
    std::size_t capacity = 0; ///< bytes; 0: a name without memory yet
};

/// Every function needs the context of \p gl current.
class BufferPool
{
public:
    /// What may lie idle; the buffers given back first are deleted first.
    static constexpr std::size_t idleBytes = std::size_t(128) << 20;

    explicit BufferPool(Gl& gl);
    ~BufferPool();
    BufferPool(const BufferPool&) = delete;
    BufferPool& operator=(const BufferPool&) = delete;

    /// The smallest idle buffer that holds \p bytes without wasting half of itself, else a new name.
    [[nodiscard]] GpuBuffer take(std::size_t bytes);
    /// Gives memory for \p bytes, and a little to grow, to a buffer that has none. True if it had to.
    bool allocate(GpuBuffer& buffer, std::size_t bytes);
    void giveBack(const GpuBuffer& buffer);
    [[nodiscard]] std::size_t idle() const { return m_idleBytes; }

private:
    Gl& m_gl;
    std::vector<GpuBuffer> m_idle; ///< in the order in which they were given back
    std::size_t m_idleBytes = 0;
};

} // namespace ramure
