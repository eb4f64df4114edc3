/// \file
/// What the OBJ and the PLY reader share. Internal to core/io.
#pragma once

#include "core/base/large_buffer.h"
#include "core/io/float_text.h"
#include "core/io/mesh_file.h"
#include <string_view>

namespace ramure::reading {

/// Elements or lines between two looks at the stop token.
inline constexpr std::size_t chunk = std::size_t(1) << 16;

/// The whole file. Errors: Io, Limit (a device or pipe that does not end).
struct Bytes
{
    LargeBuffer<char> buffer;
    std::size_t size = 0;
    [[nodiscard]] std::string_view view() const { return {buffer.data(), size}; }
};
Expected<Bytes> loadFile(const std::string& path);

/// "dir/tree.v2.obj" is "tree.v2": the name of an object that has none.
std::string stem(const std::string& path);

inline bool isBlank(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

/// A text that can be scanned without looking for its end at every byte: the lines but for the last few in
/// place, the rest as a copy that ends in a line feed and zeros. Lines are never torn, nor are lines that a
/// backslash continues.
struct ScanBlocks
{
    explicit ScanBlocks(std::string_view text);

    std::string_view body;
    std::string rest; ///< with `padding` zeros that are not part of the text
    static constexpr std::size_t padding = 16;
    [[nodiscard]] std::string_view restView() const { return {rest.data(), rest.size() - padding}; }
};

/// Part of a text as it may be shown in a message: short, printable.
std::string excerpt(std::string_view text);

} // namespace ramure::reading
