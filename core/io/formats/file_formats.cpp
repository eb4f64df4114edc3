#include "core/io/formats/file_format.h"

namespace ramure {

extern const FileFormat objFormat, plyFormat, plyTextFormat, animationFormat;

std::span<const FileFormat* const> fileFormats()
{
    static constexpr const FileFormat* table[] = {&objFormat, &plyFormat, &plyTextFormat, &animationFormat};
    return table;
}

} // namespace ramure
