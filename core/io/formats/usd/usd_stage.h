/// \file
/// A USD file, opened: its layer as it is seen, and its pictures. Internal to the formats.
#pragma once

#include "core/io/formats/usd/usd_look.h"

namespace ramure::usd {

struct OpenStage
{
    Layer layer; ///< composed
    PictureSource pictures;
    std::vector<std::string> notes; ///< references that are not followed
};

/// Opens .usda and .usdz. Errors: Io; Version (a binary layer); those of parseLayer, composed and ZipReader.
Expected<OpenStage> openStage(const std::string& path, const Progress& progress);

} // namespace ramure::usd
