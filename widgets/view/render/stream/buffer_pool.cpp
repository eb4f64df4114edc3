#include "widgets/view/render/stream/buffer_pool.h"

namespace ramure {

BufferPool::BufferPool(Gl& gl)
    : m_gl(gl)
{
}

BufferPool::~BufferPool()
{
    for (const GpuBuffer& buffer : m_idle)
        m_gl.glDeleteBuffers(1, &buffer.name);
}

GpuBuffer BufferPool::take(std::size_t bytes)
{
    auto best = m_idle.end();
    for (auto it = m_idle.begin(); it != m_idle.end(); ++it) {
        const bool fits = it->capacity >= bytes && it->capacity / 2 <= bytes;
        if (fits && (best == m_idle.end() || it->capacity < best->capacity))
            best = it;
    }
    GpuBuffer buffer;
    if (best != m_idle.end()) {
        buffer = *best;
        m_idleBytes -= buffer.capacity;
        m_idle.erase(best);
    } else {
        m_gl.glGenBuffers(1, &buffer.name);
    }
    return buffer;
}

bool BufferPool::allocate(GpuBuffer& buffer, std::size_t bytes)
{
    if (buffer.capacity >= bytes)
        return false;
    buffer.capacity = bytes + bytes / 8;
    // A target that belongs to no vertex array.
    m_gl.glBindBuffer(GL_COPY_WRITE_BUFFER, buffer.name);
    m_gl.glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(buffer.capacity), nullptr,
                      GL_STATIC_DRAW);
    m_gl.glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
    return true;
}

void BufferPool::giveBack(const GpuBuffer& buffer)
{
    if (buffer.capacity == 0) {
        m_gl.glDeleteBuffers(1, &buffer.name);
        return;
    }
    m_idle.push_back(buffer);
    m_idleBytes += buffer.capacity;
    while (m_idleBytes > idleBytes) {
        m_gl.glDeleteBuffers(1, &m_idle.front().name);
        m_idleBytes -= m_idle.front().capacity;
        m_idle.erase(m_idle.begin());
    }
}

} // namespace ramure
