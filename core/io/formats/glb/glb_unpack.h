/// \file
/// Bytes of a GLB that stand in it in another form: text of a data URI, and what EXT_meshopt_compression
/// packed. Internal to the formats.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace ramure::glb {

/// Decodes "data:...;base64,...". Returns nothing if the URI is of another kind or broken.
std::optional<std::string> bytesOfUri(std::string_view uri);

/// The fields of EXT_meshopt_compression, with the names that the extension gives them.
struct PackedView
{
    std::string_view bytes;
    std::size_t count = 0, stride = 0;
    std::string mode, filter;
};
/// Values of any bytes at all. Nothing where they are not what they say. \pre count * stride fits in memory
std::optional<std::string> unpack(const PackedView& view);

} // namespace ramure::glb
