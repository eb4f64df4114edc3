#include "core/io/formats/glb/glb_unpack.h"

#include <array>
#include <cstdint>
#include <meshoptimizer.h>

namespace ramure::glb {

/// RFC 4648, chapter 4.
static std::array<std::int8_t, 256> base64Values()
{
    std::array<std::int8_t, 256> values{};
    values.fill(-1);
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t i = 0; i < letters.size(); ++i)
        values[static_cast<unsigned char>(letters[i])] = static_cast<std::int8_t>(i);
    return values;
}

std::optional<std::string> bytesOfUri(std::string_view uri)
{
    constexpr std::string_view mark = ";base64,";
    const std::size_t begin = uri.find(mark);
    if (!uri.starts_with("data:") || begin == std::string_view::npos)
        return std::nullopt;
    uri.remove_prefix(begin + mark.size());
    while (uri.ends_with('='))
        uri.remove_suffix(1);
    static const std::array<std::int8_t, 256> values = base64Values();
    std::string out;
    out.reserve(uri.size() / 4 * 3 + 3);
    std::uint32_t bits = 0;
    int held = 0;
    for (const char letter : uri) {
        const int value = values[static_cast<unsigned char>(letter)];
        if (value < 0)
            return std::nullopt;
        bits = (bits << 6U) | static_cast<std::uint32_t>(value);
        held += 6;
        if (held < 8)
            continue;
        held -= 8;
        out += static_cast<char>((bits >> static_cast<unsigned>(held)) & 0xFFU);
    }
    return out;
}

std::optional<std::string> unpack(const PackedView& view)
{
    const auto* bytes = reinterpret_cast<const unsigned char*>(view.bytes.data());
    const std::size_t size = view.bytes.size(), count = view.count, stride = view.stride;
    constexpr std::size_t mostRatio = 256; // four times what the codecs can
    if (count * stride / mostRatio > size)
        return std::nullopt;
    std::string out;
    int failed = 1;
    if (view.mode == "ATTRIBUTES" && stride > 0 && stride <= 256 && stride % 4 == 0) {
        out.resize(count * stride);
        failed = meshopt_decodeVertexBuffer(out.data(), count, stride, bytes, size);
    } else if (stride == 2 || stride == 4) {
        out.resize(count * stride);
        if (view.mode == "TRIANGLES" && count % 3 == 0)
            failed = meshopt_decodeIndexBuffer(out.data(), count, stride, bytes, size);
        else if (view.mode == "INDICES")
            failed = meshopt_decodeIndexSequence(out.data(), count, stride, bytes, size);
    }
    if (failed != 0)
        return std::nullopt;
    if (view.filter == "OCTAHEDRAL" && (stride == 4 || stride == 8))
        meshopt_decodeFilterOct(out.data(), count, stride);
    else if (view.filter == "QUATERNION" && stride == 8)
        meshopt_decodeFilterQuat(out.data(), count, stride);
    else if (view.filter == "EXPONENTIAL")
        meshopt_decodeFilterExp(out.data(), count, stride);
    else if (!view.filter.empty() && view.filter != "NONE")
        return std::nullopt;
    return out;
}

} // namespace ramure::glb
