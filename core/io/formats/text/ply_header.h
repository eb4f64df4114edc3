/// \file
/// The header of a PLY file. Internal to core/io.
#pragma once

#include "core/base/error.h"
#include <string>
#include <string_view>
#include <vector>

namespace ramure::reading {

enum class PlyFormat : std::uint8_t { Ascii, LittleEndian, BigEndian };
enum class PlyType : std::uint8_t { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

constexpr std::size_t sizeOf(PlyType type)
{
    constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}
constexpr bool isInteger(PlyType type)
{
    return type != PlyType::Float32 && type != PlyType::Float64;
}

struct PlyProperty
{
    std::string name;
    PlyType type = PlyType::Float32;
    bool isList = false;
    PlyType countType = PlyType::UInt8; ///< of a list
};

struct PlyElement
{
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;

    /// Number of the property, or -1.
    [[nodiscard]] int find(std::string_view propertyName) const;
    /// Bytes that one of them takes at least: lists may be empty.
    [[nodiscard]] std::uint64_t smallestSize(PlyFormat format) const;
};

/// Names are in lower case: some programs write capitals.
struct PlyHeader
{
    PlyFormat format = PlyFormat::Ascii;
    std::vector<PlyElement> elements;
    std::size_t bytes = 0;   ///< where the data begin
    bool hasReturns = false; ///< lines end in carriage returns alone
    int lines = 0;
};

/// Errors: Syntax, Limit, with line. A count of elements that the rest of the file has no room for is an
/// error here, before anybody takes memory for it. \p fileBytes: how long the file is of which \p bytes is
/// the beginning.
Expected<PlyHeader> parsePlyHeader(std::string_view bytes, const std::string& file, std::uint64_t fileBytes);

} // namespace ramure::reading
