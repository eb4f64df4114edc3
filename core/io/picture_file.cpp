#include "core/io/picture_file.h"

#include <algorithm>
#include <png.h>
#include <vector>

namespace ramure {

Expected<std::string> pngOf(const PictureBytes& picture)
{
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(picture.width);
    image.height = static_cast<png_uint_32>(picture.height);
    image.format = picture.channels == 1 ? PNG_FORMAT_GRAY : PNG_FORMAT_RGB;
    if (picture.channels == 4)
        image.format = PNG_FORMAT_RGBA;
    if (!picture.areColours)
        image.flags = PNG_IMAGE_FLAG_COLORSPACE_NOT_sRGB;
    std::string file(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
    png_alloc_size_t size = file.size();
    const png_int_32 fromBelow = -picture.width * picture.channels;
    if (!png_image_write_to_memory(&image, file.data(), &size, 0, picture.bytes.data(), fromBelow, nullptr))
        return fail(ErrorCode::Io, RAMURE_NOOP("the picture could not be made: %1"), {image.message});
    file.resize(size);
    return file;
}

namespace {

constexpr png_uint_32 mostSide = 16384;

struct Pixels
{
    int width = 0, height = 0;
    std::vector<std::uint8_t> bytes; ///< row by row from the lowest one up
};

Expected<Pixels> pixelsOf(std::string_view file, png_uint_32 format)
{
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    Pixels out;
    if (png_image_begin_read_from_memory(&image, file.data(), file.size())) {
        if (std::max(image.width, image.height) > mostSide) {
            png_image_free(&image);
            return fail(ErrorCode::Limit, RAMURE_NOOP("a picture of more than %1 pixels a side"),
                        {std::to_string(mostSide)});
        }
        image.format = format;
        out.width = static_cast<int>(image.width);
        out.height = static_cast<int>(image.height);
        out.bytes.resize(PNG_IMAGE_SIZE(image));
        const png_int_32 fromBelow = -static_cast<png_int_32>(PNG_IMAGE_ROW_STRIDE(image));
        if (png_image_finish_read(&image, nullptr, out.bytes.data(), fromBelow, nullptr))
            return out;
    }
    const std::string why = image.message;
    png_image_free(&image);
    return fail(ErrorCode::Invalid, RAMURE_NOOP("no PNG that can be read: %1"), {why});
}

} // namespace

Expected<std::string> maskedPng(std::string_view colour, std::string_view opacity)
{
    const auto alpha = pixelsOf(opacity, PNG_FORMAT_GRAY);
    RAMURE_TRY(alpha);
    Pixels out{alpha->width, alpha->height, std::vector<std::uint8_t>(4 * alpha->bytes.size(), 255)};
    if (!colour.empty()) {
        auto read = pixelsOf(colour, PNG_FORMAT_RGBA);
        RAMURE_TRY(read);
        out = std::move(*read);
    }
    const auto width = static_cast<std::size_t>(out.width), height = static_cast<std::size_t>(out.height);
    const auto across = static_cast<std::size_t>(alpha->width), up = static_cast<std::size_t>(alpha->height);
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x)
            out.bytes[4 * (y * width + x) + 3] = alpha->bytes[y * up / height * across + x * across / width];
    return pngOf({out.width, out.height, 4, true, out.bytes});
}

Expected<std::string> channelPng(std::string_view picture, int channel)
{
    const auto from = pixelsOf(picture, PNG_FORMAT_RGBA);
    RAMURE_TRY(from);
    std::vector<std::uint8_t> out;
    out.reserve(from->bytes.size() / 4);
    bool isWhite = true;
    for (auto at = static_cast<std::size_t>(channel); at < from->bytes.size(); at += 4) {
        out.push_back(from->bytes[at]);
        isWhite = isWhite && out.back() == 255;
    }
    if (channel == 3 && isWhite)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("nothing of the picture is transparent"));
    return pngOf({from->width, from->height, 1, false, out});
}

} // namespace ramure
