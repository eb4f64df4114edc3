/// \file
/// What an export is for, in words: each use has a page of the export dialog, with the formats that it needs.
#pragma once

#include "core/qt/session/export/export_option.h"
#include <QString>
#include <QStringList>
#include <array>

namespace ramure {

inline constexpr std::array exportUses{ExportUse::Blender, ExportUse::Game, ExportUse::Print, ExportUse::Web,
                                       ExportUse::Pictures};

/// What stands behind the formats of the table: pictures of the view.
inline const QString pictureFormat = QStringLiteral("png");
/// The same, and films of it (filmEndings).
const QStringList& viewFormats();

/// FileFormat::id of those it takes, the usual one first. Formats that no other use asks for are Blender's.
QStringList formatsOf(ExportUse use);
/// In the present language: of its tab, and what it is, for a tooltip.
QString titleOf(ExportUse use);
QString tipOf(ExportUse use);
/// In files of settings.
QString keyOf(ExportUse use);

} // namespace ramure
