/// \file
/// A hash of a mesh's contents: equal meshes have equal hashes, on every machine.
#pragma once

#include "core/surface/mesh/triangle_mesh.h"
#include <compare>
#include <cstdint>
#include <string>

namespace ramure {

/// 128 bits, well mixed, but not cryptographic: it does not protect against forged meshes.
struct MeshHash
{
    std::uint64_t high = 0, low = 0;
    auto operator<=>(const MeshHash&) const = default;

    /// 32 hexadecimal digits, lower case.
    [[nodiscard]] std::string text() const;
    /// The first 8 of them, for where there is little room.
    [[nodiscard]] std::string shortText() const { return text().substr(0, 8); }
};

/// Hashes positions and triangles in their order. -0 counts as 0. Normals and branches are left out, because
/// they follow. A mesh that was written to a file and read back has the same hash.
MeshHash meshHash(const TriangleMesh& mesh);

} // namespace ramure
