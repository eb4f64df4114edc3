#include "core/io/formats/file_format.h"

namespace ramure {

extern const FileFormat objFormat, plyFormat, plyTextFormat, glbFormat, stlFormat, threeMfFormat, usdaFormat,
    usdzFormat, pointCacheFormat, fbxFormat, animationFormat, arbaroFormat, ezTreeFormat, heightPngFormat,
    heightExrFormat;

std::span<const FileFormat* const> fileFormats()
{
    static constexpr const FileFormat* table[] = {
        &objFormat,       &plyFormat,    &plyTextFormat, &glbFormat,        &usdaFormat,
        &usdzFormat,      &stlFormat,    &threeMfFormat, &pointCacheFormat, &fbxFormat,
        &animationFormat, &arbaroFormat, &ezTreeFormat,  &heightPngFormat,  &heightExrFormat};
    return table;
}

} // namespace ramure
