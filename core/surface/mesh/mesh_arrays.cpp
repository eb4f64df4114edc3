#include "core/surface/mesh/mesh_arrays.h"

#include <mutex>
#include <utility>

namespace ramure {

namespace {

constexpr std::size_t mostKeptBytes = std::size_t(256) << 20;

template <class... T> std::size_t bytesOf(const std::vector<T>&... arrays)
{
    return (... + (arrays.capacity() * sizeof(T)));
}

} // namespace

struct MeshArrays::Kept
{
    std::mutex mutex;
    TriangleMesh mesh;
};

MeshArrays::MeshArrays()
    : m_kept(std::make_shared<Kept>())
{
}

TriangleMesh MeshArrays::take()
{
    const std::scoped_lock lock(m_kept->mutex);
    return std::exchange(m_kept->mesh, {});
}

void MeshArrays::keep(TriangleMesh&& from)
{
    TriangleMesh kept;
    kept.positions = std::move(from.positions);
    kept.normals = std::move(from.normals);
    kept.triangles = std::move(from.triangles);
    kept.branch = std::move(from.branch);
    kept.level = std::move(from.level);
    if (bytesOf(kept.positions, kept.normals, kept.triangles, kept.branch, kept.level) > mostKeptBytes)
        return;
    const std::scoped_lock lock(m_kept->mutex);
    if (kept.triangles.capacity() >= m_kept->mesh.triangles.capacity())
        std::swap(m_kept->mesh, kept);
}

std::shared_ptr<const TriangleMesh> MeshArrays::share(TriangleMesh&& mesh)
{
    return {new TriangleMesh(std::move(mesh)), [arrays = *this](TriangleMesh* done) mutable {
                arrays.keep(std::move(*done));
                delete done;
            }};
}

} // namespace ramure
