#include "core/io/grey_picture.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <png.h>

namespace ramure {
namespace {

/// Of 8 or 16 bits a pixel, as the file has them: they are numbers, no colours.
Expected<GreyPicture> greyPng(const std::string& file)
{
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    const auto damaged = [&image] {
        const std::string why = image.message;
        png_image_free(&image);
        return fail(ErrorCode::Invalid, RAMURE_NOOP("no PNG that can be read: %1"), {why});
    };
    if (!png_image_begin_read_from_memory(&image, file.data(), file.size()))
        return damaged();
    GreyPicture out;
    out.width = static_cast<int>(image.width);
    out.height = static_cast<int>(image.height);
    if (auto fits = checkGreySize(out.width, out.height); !fits) {
        png_image_free(&image);
        return fail(fits.error());
    }
    const bool isWide = (image.format & PNG_FORMAT_FLAG_LINEAR) != 0;
    image.format = isWide ? PNG_FORMAT_LINEAR_Y : PNG_FORMAT_GRAY;
    const std::size_t count = std::size_t(image.width) * image.height;
    out.values.resize(count);
    const auto read = [&](auto largest) {
        std::vector<decltype(largest)> pixels(count);
        if (!png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr))
            return false;
        std::ranges::transform(pixels, out.values.begin(),
                               [=](auto value) { return float(value) / float(largest); });
        return true;
    };
    if (!(isWide ? read(png_uint_16(65535)) : read(png_byte(255))))
        return damaged();
    return out;
}

Expected<GreyPicture> greyOf(const std::string& path)
{
    std::ifstream stream(path, std::ios::binary);
    std::error_code none;
    if (!stream || std::filesystem::is_directory(path, none))
        return fail(ErrorCode::Io, RAMURE_NOOP("this picture cannot be opened"));
    std::string file(4, '\0');
    stream.read(file.data(), 4);
    if (file == "\x76\x2f\x31\x01")
        return readExrNumbers(path);
    if (file != "\x89PNG")
        return fail(ErrorCode::Unknown, RAMURE_NOOP("this is neither a PNG nor an OpenEXR picture"));
    file.append(std::istreambuf_iterator<char>(stream), {});
    return greyPng(file);
}

} // namespace

Expected<void> checkGreySize(int width, int height)
{
    constexpr int most = 16384;
    if (std::max(width, height) > most)
        return fail(ErrorCode::Limit, RAMURE_NOOP("a picture of more than %1 pixels a side"),
                    {std::to_string(most)});
    return {};
}

double GreyPicture::at(double u, double v) const
{
    const double x = std::clamp(u * width - 0.5, 0.0, width - 1.0);
    const double y = std::clamp(v * height - 0.5, 0.0, height - 1.0);
    const auto column = static_cast<std::size_t>(x), row = static_cast<std::size_t>(y);
    const std::size_t right = std::min(column + 1, std::size_t(width) - 1);
    const std::size_t below = std::min(row + 1, std::size_t(height) - 1);
    const auto value = [&](std::size_t c, std::size_t r) {
        return double(values[r * std::size_t(width) + c]);
    };
    const double s = x - double(column), t = y - double(row);
    return std::lerp(std::lerp(value(column, row), value(right, row), s),
                     std::lerp(value(column, below), value(right, below), s), t);
}

Expected<GreyPicture> readGreyPicture(const std::string& path)
{
    return greyOf(path).map_error([&path](Error error) {
        error.file = path;
        return error;
    });
}

} // namespace ramure
