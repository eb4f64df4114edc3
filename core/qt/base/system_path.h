/// \file
/// Converts file names between Qt's text and the bytes of the system. The bytes may be no UTF-8 (a disk of an
/// older system, an archive), and QFile::encodeName() and decodeName() would turn several such names into
/// one.
#pragma once

#include "core/base/error.h"
#include <QString>
#include <string>
#include <string_view>

class QFile;

namespace ramure {

/// Returns a text that stands for exactly these bytes: a byte that is no UTF-8 becomes the lone surrogate
/// 0xDC00 + byte, which no other text has. Only systemPath() knows these; Qt's own classes for files do not.
QString pathText(std::string_view bytes);
/// The bytes of a path, also of one that pathText() gave.
std::string systemPath(const QString& path);
/// Opens a file for reading, whatever its name is. Error: Io, with the file.
Expected<void> openToRead(QFile& file, const QString& path);

} // namespace ramure
