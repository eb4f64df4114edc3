/// \file
/// SHA-256 of files: as fast as the processor has it, where Qt 6.4 goes byte by byte.
#pragma once

#include <QByteArray>
#include <QString>

namespace ramure::cli {

/// Returns the hash in hex, or nothing if the file cannot be read.
QByteArray sha256Of(const QString& path);

} // namespace ramure::cli
