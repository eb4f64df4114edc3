/// \file
/// How a mesh follows its bones. The member initialisers are the defaults.
#pragma once

#include <cstdint>

namespace ramure {

/// The values are positions in the table's list of items; files have the names.
enum class SkinMethod : std::uint8_t {
    Rigid,          ///< every vertex follows its own branch (SPEC A8)
    Linear,         ///< the bones' matrices are mixed; thins strong bends
    DualQuaternion, ///< the bones' screw motions are mixed: tubes keep their thickness (Kavan et al. 2008)
};

struct SkinParams
{
    SkinMethod method = SkinMethod::DualQuaternion;
    bool operator==(const SkinParams&) const = default;
};

} // namespace ramure
