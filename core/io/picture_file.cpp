#include "core/io/picture_file.h"

#include "core/base/file_writer.h"
#include <png.h>
#include <vector>

namespace ramure {

Expected<void> writePng(const std::string& path, const PictureBytes& picture)
{
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(picture.width);
    image.height = static_cast<png_uint_32>(picture.height);
    image.format = picture.channels == 1 ? PNG_FORMAT_GRAY : PNG_FORMAT_RGB;
    if (!picture.areColours)
        image.flags = PNG_IMAGE_FLAG_COLORSPACE_NOT_sRGB;
    std::string file(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
    png_alloc_size_t size = file.size();
    const png_int_32 fromBelow = -picture.width * picture.channels;
    if (!png_image_write_to_memory(&image, file.data(), &size, 0, picture.bytes.data(), fromBelow, nullptr)) {
        auto error = fail(ErrorCode::Io, RAMURE_NOOP("the picture could not be made: %1"), {image.message});
        error.value().file = path;
        return error;
    }
    return writeFile(path, std::string_view(file).substr(0, size));
}

} // namespace ramure
