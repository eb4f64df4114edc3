/// \file
/// Pictures as files.
#pragma once

#include "core/base/error.h"
#include <QImage>
#include <string>

namespace ramure {

/// In the format of the ending of \p path; the old file is intact on an error. Errors: Unknown (no such
/// format, or no picture), Io.
Expected<void> savePicture(const QImage& image, const std::string& path);

} // namespace ramure
