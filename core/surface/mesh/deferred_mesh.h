/// \file
/// A mesh that is made when somebody first looks at its lists. The merged mesh of all leaves is one: views
/// draw copies of one leaf, so that a day of the year costs them no mesh.
#pragma once

#include "core/surface/mesh/triangle_mesh.h"
#include <concepts>
#include <functional>
#include <memory>

namespace ramure {

/// A shared pointer to a mesh, copied as one; null where there is none. Two are equal if they share one mesh.
class DeferredMesh
{
public:
    using Pointer = std::shared_ptr<const TriangleMesh>;

    DeferredMesh() = default;
    /// One that is there already, or null.
    template <std::convertible_to<Pointer> Made>
    requires(!std::same_as<std::remove_cvref_t<Made>, DeferredMesh>)
        DeferredMesh(Made&& made) // NOLINT(google-explicit-constructor): as one pointer converts to another
        : m_made(std::forward<Made>(made))
    {
    }
    /// \param make is called once, by whichever thread asks first, and gives so many vertices and faces.
    DeferredMesh(Index vertices, Index faces, std::function<TriangleMesh()> make);

    [[nodiscard]] const Pointer& pointer() const { return m_later ? made() : m_made; }
    operator const Pointer&() const { return pointer(); } // NOLINT(google-explicit-constructor)
    [[nodiscard]] const TriangleMesh* get() const { return pointer().get(); }
    const TriangleMesh& operator*() const { return *pointer(); }
    const TriangleMesh* operator->() const { return pointer().get(); }
    explicit operator bool() const { return m_later || m_made; }

    // What follows makes nothing. Null has no vertices.
    [[nodiscard]] Index vertexCount() const;
    [[nodiscard]] Index faceCount() const;
    [[nodiscard]] bool empty() const { return faceCount() == 0; }
    [[nodiscard]] bool isMade() const;
    /// What tells it from others, for caches.
    [[nodiscard]] std::shared_ptr<const void> key() const;
    /// The memory that its lists hold by now.
    [[nodiscard]] std::size_t bytes() const;
    friend bool operator==(const DeferredMesh& a, const DeferredMesh& b);

private:
    struct Later;
    [[nodiscard]] const Pointer& made() const;

    Pointer m_made;
    std::shared_ptr<Later> m_later; ///< null: it is m_made
};

} // namespace ramure
