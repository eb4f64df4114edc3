/// \file
/// The image files of a scene, brought together beside its project so that both can be given away.
#pragma once

#include "core/qt/document/document.h"

namespace ramure {

/// The folder beside a project that its pictures are copied into: "oak pictures" beside oak.ramure.
QString packedFolder(const QString& projectPath);

namespace edit {
/// Copies every image file that nodes wear and that lies outside the project's folder into packedFolder(),
/// and names the copies in one step of undo. A file of the same name and content there is taken as it is; one
/// of another content stays, and the copy gets a number. \returns how many files are named anew. Errors:
/// Invalid (the document has no file yet; a locked node wears one), Io with file (missing, unreadable, cannot
/// be written); the document then stays as it was.
Expected<std::size_t> packPictures(Document& document);
} // namespace edit

} // namespace ramure
