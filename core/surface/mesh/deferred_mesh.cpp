#include "core/surface/mesh/deferred_mesh.h"

#include <atomic>
#include <mutex>
#include <utility>

namespace ramure {

struct DeferredMesh::Later
{
    Index vertices = 0, faces = 0;
    std::function<TriangleMesh()> make;
    std::once_flag once;
    Pointer made;
    std::atomic<bool> isMade = false;
};

DeferredMesh::DeferredMesh(Index vertices, Index faces, std::function<TriangleMesh()> make)
    : m_later(std::make_shared<Later>())
{
    m_later->vertices = vertices;
    m_later->faces = faces;
    m_later->make = std::move(make);
}

const DeferredMesh::Pointer& DeferredMesh::made() const
{
    std::call_once(m_later->once, [this] {
        m_later->made = std::make_shared<const TriangleMesh>(m_later->make());
        m_later->make = nullptr; // and what it holds
        m_later->isMade = true;
    });
    return m_later->made;
}

Index DeferredMesh::vertexCount() const
{
    return m_later ? m_later->vertices : m_made ? m_made->vertexCount() : 0;
}

Index DeferredMesh::faceCount() const
{
    return m_later ? m_later->faces : m_made ? m_made->faceCount() : 0;
}

bool DeferredMesh::isMade() const
{
    return !m_later || m_later->isMade;
}

std::shared_ptr<const void> DeferredMesh::key() const
{
    return m_later ? std::shared_ptr<const void>(m_later) : m_made;
}

std::size_t DeferredMesh::bytes() const
{
    return isMade() && *this ? bytesOf(**this) : 0;
}

bool operator==(const DeferredMesh& a, const DeferredMesh& b)
{
    if (a.m_later && b.m_later)
        return a.m_later == b.m_later;
    return a.isMade() && b.isMade() && a.pointer() == b.pointer();
}

} // namespace ramure
